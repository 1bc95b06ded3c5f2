//! Claims from a text, without a folder of their own in the repository.

use std::path::Path;
use torse_language::derivation::{LoadError, Paper, load};
use torse_verdicts::engine::decide_claim;
use torse_verdicts::outcome::Outcome;

/// The paper `name` with these declarations and one claim `name/1`, `name/2`, ... for every entry, the
/// lines of which follow `id`, `at`, `kind` (a property unless they say otherwise) and `printed`.
pub fn paper(name: &str, declarations: &str, claims: &[&str]) -> Paper {
    loaded(name, declarations, claims).expect("the claims make sense")
}

/// The same, where the declarations may make no sense.
pub fn loaded(name: &str, declarations: &str, claims: &[&str]) -> Result<Paper, LoadError> {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(folder.join(name)).expect("a folder for the claims");
    let head = format!(
        "[paper]\nid = \"{name}\"\ntitle = \"T\"\nauthors = \"A\"\nvenue = \"V\"\nclaims = [\"c.toml\"]\n{declarations}"
    );
    let entry = |(number, lines): (usize, &&str)| {
        let kind = match lines.contains("kind = ") {
            true => "",
            false => "kind = \"property\"\n",
        };
        format!(
            "[[claim]]\nid = \"{name}/{}\"\nat = \"here\"\n{kind}printed = \"p\"\n{lines}\n",
            number + 1
        )
    };
    let body: String = claims.iter().enumerate().map(entry).collect();
    std::fs::write(folder.join(name).join("paper.toml"), head).expect("the paper is written");
    std::fs::write(folder.join(name).join("c.toml"), body).expect("the claims are written");
    load(&folder).map(|mut papers| papers.remove(0))
}

/// The outcomes of such claims, in order.
pub fn outcomes(name: &str, declarations: &str, claims: &[&str]) -> Vec<Outcome> {
    let paper = paper(name, declarations, claims);
    let decide = |claim| decide_claim(&paper.head.id, claim).expect("every formula makes sense");
    paper.claims.iter().map(decide).collect()
}
