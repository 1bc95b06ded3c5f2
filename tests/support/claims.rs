//! Papers from a few lines of text, for the tests of several rooms: each includes this file as a module.

use std::sync::Arc;
use torse_syntax::derivation::{LoadError, Paper, Source, paper};

/// The paper `name` with these declarations and one claim `name/1`, `name/2`, ... for every entry, the lines of which
/// follow `id`, `at`, `kind` (a property unless they say otherwise) and `printed`.
pub fn paper_of(name: &str, declarations: &str, claims: &[&str]) -> Result<Paper, LoadError> {
    let entry = |(number, lines): (usize, &&str)| {
        let kind = match lines.contains("kind = ") {
            true => "",
            false => "kind = \"property\"\n",
        };
        let id = number + 1;
        format!("[[claim]]\nid = \"{name}/{id}\"\nat = \"here\"\n{kind}printed = \"p\"\n{lines}\n")
    };
    let body: String = claims.iter().enumerate().map(entry).collect();
    let head = format!(
        "[paper]\nid = \"{name}\"\ntitle = \"T\"\nauthors = \"A\"\nvenue = \"V\"\nclaims = [\"c.toml\"]\n{declarations}"
    );
    paper(|file| {
        let text = if file == "paper.toml" { &head } else { &body };
        Ok(Arc::new(Source::new(file, text.clone())))
    })
}
