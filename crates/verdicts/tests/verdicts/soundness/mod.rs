//! Statements on which an earlier engine was wrong, one test for each, by what went wrong.
//!
//! A claim says that its statement is true for all values in the declared sets that satisfy the hypotheses and at
//! which every term is defined. Every verdict below was derived from that sentence by hand.

use crate::common;

mod accused;
mod adversary;
mod coefficients;
mod conditions;
mod defined;
mod denied;
mod properties;
mod proved;
mod questions;

use torse_syntax::taxonomy::Verdict;
use torse_verdicts::outcome::Outcome;

/// What all claims of this binary may use.
const DECLARATIONS: &str = r#"
[symbols]
x = { in = "[0, 1]" }
a = {}
b = {}
c = {}
d = {}
e = {}
f = {}
r = {}
s = {}
y = {}
m = { integer = ">= 1" }
P = { family = "any", indices = ["0..m"] }
[basis.B]
variable = "x"
degree = 0
seeds = ['1']
step = ['1 - x', 'x']
"#;

/// The outcome of one claim, whose fields are `lines`; an error where the claim makes no sense.
fn tried(name: &str, lines: &str) -> Result<Outcome, String> {
    let paper = common::loaded(name, DECLARATIONS, &[lines]).map_err(|e| e.to_string())?;
    torse_verdicts::engine::decide_claim(name, &paper.claims[0]).map_err(|e| e.to_string())
}

/// The outcome of one claim that makes sense.
fn outcome(name: &str, lines: &str) -> Outcome {
    tried(name, lines).unwrap_or_else(|error| panic!("{lines}: {error}"))
}

/// The verdict is this one; returns the outcome for a closer look.
#[track_caller]
fn expect(name: &str, lines: &str, verdict: Verdict) -> Outcome {
    let found = outcome(name, lines);
    assert_eq!(found.verdict(), verdict, "{lines}: {found:#?}");
    found
}

/// The verdict is one of these: where the power of the engine is not at stake, only its honesty.
#[track_caller]
fn expect_one_of(name: &str, lines: &str, verdicts: &[Verdict]) -> Outcome {
    let found = outcome(name, lines);
    assert!(verdicts.contains(&found.verdict()), "{lines}: {found:#?}");
    found
}

/// The claim is refuted at a point in which `name` has one of these values.
#[track_caller]
fn expect_refuted_where(claim: &str, lines: &str, symbol: &str, fails: impl Fn(&str) -> bool) {
    let found = expect(claim, lines, Verdict::False);
    let witness = found.witness().expect("a refutation has a point");
    let value = witness.at.iter().find(|(name, _)| name == symbol);
    assert!(
        value.is_some_and(|(_, value)| fails(value)),
        "{lines}: {symbol} in {witness:?}"
    );
}

/// The texts of the conditions.
fn conditions(outcome: &Outcome) -> Vec<&str> {
    outcome
        .conditions()
        .iter()
        .map(|c| c.text.as_str())
        .collect()
}
