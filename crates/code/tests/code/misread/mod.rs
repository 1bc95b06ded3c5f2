//! Programs that look as if they computed a formula, and do not: lists and arrays that share memory, names that are changed elsewhere,
//! integers whose division rounds. Each is refused, or found to be different, and its true neighbours are read.

mod arrays;
mod changes;
mod complex;
mod generators;
mod integers;
mod lists;
mod names;
mod rust;
mod rust_names;
mod symbols;

use crate::support::line;
use std::sync::Arc;
use torse_code::{CodeQuestion, CodeVerdict, Comparison, compare};
use torse_syntax::derivation::{DerivationError, Paper, Source, paper};

/// The work of a comparison.
const WORK: u64 = 20_000_000;

/// A claim of which both sides are a formula.
fn claim(formula: &str) -> Paper {
    let head = "[paper]\nid = 'look'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']\n\
                [symbols]\nx = {}\ny = {}\na = {}\nb = {}\nt = {}\nn = { integer = '>= 0' }\nm = { integer = '>= 1' }\n\
                p = { vector = 3 }\nq = { vector = 3 }\nP = { family = 3, indices = ['0..n'] }\n\
                k = { integer = '>= -9' }\ni = { integer = '0..9' }\nQ = { family = 3, indices = ['0..3'] }\nV = { family = 1, indices = ['1..3'] }\nW = { family = 1, indices = ['0..3'] }\n";
    let claims = format!(
        "[[claim]]\nid = 'look/1'\nat = ''\nkind = 'identity'\nprinted = ''\nstates = '{formula} == {formula}'\n"
    );
    let read = |name: &str| {
        let text = match name {
            "paper.toml" => head,
            _ => claims.as_str(),
        };
        Ok(Arc::new(Source::new(name, text)))
    };
    paper(read).unwrap()
}

fn compared(file: &str, text: &str, formula: &str) -> Result<Comparison, Box<DerivationError>> {
    let paper = claim(formula);
    let question = CodeQuestion::new(file, text, "f");
    compare(WORK, "look", &paper.claims[0], &question)
}

/// What is found of each program; `None` for one that is refused, at a place of its file.
fn are(file: &str, rows: &[(&str, &str, Option<CodeVerdict>)]) {
    let mut wrong = vec![];
    for (text, formula, wanted) in rows {
        let found = compared(file, text, formula);
        let verdict = found.as_ref().ok().map(|found| found.verdict);
        let said = match &found {
            Ok(found) => found.to_string(),
            Err(error) => line(error, text),
        };
        if verdict != *wanted {
            wrong.push(format!("{text}{formula}: {said}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn what_is_wrong_with_the_formula_of_code_is_shown_in_the_code() {
    // The last index is that of no member.
    let text = "fn f(W: &[f64], n: i32) -> f64 {\n    (1..=n).map(|i| W[-i]).sum()\n}\n";
    let error = compared("f.rs", text, "x").unwrap_err();
    let said = line(&error, text);
    assert!(said.starts_with("1:4 `f`"), "{said}");
    assert!(!said.contains('°'), "{said}");
}

#[test]
fn the_search_for_changes_of_a_sum_ends() {
    let text = "def f(n, x):\n    return sum(i for i in range(n)) + x\n";
    let found = compared("f.py", text, "x").unwrap();
    assert_eq!(found.verdict, CodeVerdict::Different);
}
