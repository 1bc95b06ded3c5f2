//! Outcomes of claims from a text, for the tests of this room.

#![allow(dead_code, reason = "not every binary uses all of it")]

#[path = "../../../../../tests/support/claims.rs"]
mod claims;

pub use claims::paper_of as loaded;
use torse_syntax::derivation::Paper;
use torse_verdicts::engine::decide_claim;
use torse_verdicts::outcome::Outcome;

/// A paper that makes sense.
pub fn paper(name: &str, declarations: &str, claims: &[&str]) -> Paper {
    loaded(name, declarations, claims).expect("the claims make sense")
}

/// The outcomes of such claims, in order.
pub fn outcomes(name: &str, declarations: &str, claims: &[&str]) -> Vec<Outcome> {
    let paper = paper(name, declarations, claims);
    let decide = |claim| decide_claim(&paper.head.id, claim).expect("every formula makes sense");
    paper.claims.iter().map(decide).collect()
}

/// The outcomes of these statements, in order.
pub fn stated(name: &str, declarations: &str, statements: &[&str]) -> Vec<Outcome> {
    let quoted = |s: &&str| format!("states = \"{s}\"");
    let claims: Vec<String> = statements.iter().map(quoted).collect();
    let claims: Vec<&str> = claims.iter().map(String::as_str).collect();
    outcomes(name, declarations, &claims)
}
