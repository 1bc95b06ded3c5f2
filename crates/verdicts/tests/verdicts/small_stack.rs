//! The library on a thread of its user: two megabytes of stack, and what the command decides is decided there.
use std::sync::Arc;
use torse_syntax::derivation::{LoadError, Paper, Source, paper};
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::engine::decide_claim;
use torse_verdicts::words;

/// What a thread has unless its program says otherwise.
const SMALL: usize = 2 << 20;

/// A paper whose definitions use each other as deeply as they may, each of them as deep as a formula may be.
fn deep_paper() -> Paper {
    let mut definitions = String::from("d0 = \"x\"\n");
    for n in 1..78 {
        let inner = n - 1;
        let (open, closed) = ("1 + 1*(".repeat(90), ")".repeat(90));
        definitions += &format!("d{n} = \"{open}d{inner}{closed}\"\n");
    }
    let head = format!(
        "[paper]\nid = 'p'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']\n\
         [symbols]\nx = {{}}\n[define]\n{definitions}"
    );
    let claims = "[[claim]]\nid = 'p/deep'\nat = ''\nkind = 'identity'\nprinted = ''\nstates = 'd77 == x + 6930'\n\
                  [[claim]]\nid = 'p/slip'\nat = ''\nkind = 'identity'\nprinted = ''\nstates = 'd77 == x + 6931'\n";
    let read = |name: &str| -> Result<Arc<Source>, LoadError> {
        let text = if name == "paper.toml" { &head } else { claims };
        let (name, text) = (name.to_owned(), text.to_owned());
        Ok(Arc::new(Source::new(name, text)))
    };
    paper(read).unwrap()
}

#[test]
fn definitions_as_deep_as_they_may_be_are_decided_on_a_thread_of_two_megabytes() {
    let decided = || -> Vec<(Verdict, Vec<String>)> {
        let paper = deep_paper();
        let claims = paper.claims.iter();
        let outcomes = claims.map(|claim| decide_claim("p", claim).unwrap());
        outcomes
            .map(|found| (found.verdict(), words::steps(&found)))
            .collect()
    };
    let thread = std::thread::Builder::new().stack_size(SMALL);
    let found = thread.spawn(decided).unwrap().join().unwrap();
    assert!(
        matches!(
            found.as_slice(),
            [(Verdict::Holds, _), (Verdict::Misprint | Verdict::False, _)]
        ),
        "{found:?}"
    );
}
