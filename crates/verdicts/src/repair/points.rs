//! Candidates at points of the domain, for sides that have no value at the sample point: those with roots.
//!
//! The semantics judges each candidate as a statement at a few points. One that is false at none of them is still to be
//! proved.

use super::edit::{Change, Edit, exact_numbers, placed};
use super::subject::Subject;
use torse_algebra::rational::integer;
use torse_semantics::judge_samples;
use torse_semantics::tree::Reading;
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::Expr;

/// The most candidates of one search, the points of each, and the work on them in operations on numbers.
pub(super) const MAX_CANDIDATES: usize = 2_500;
const POINTS: u64 = 2;
const MAX_WORK: u64 = 20_000;
/// The largest number that is tried in the place of another.
const MAX_NUMBER: i64 = 24;

/// The edits that make a statement that is true at points of the domain, and false at none that was looked at.
#[must_use]
pub(super) fn agreeing(
    claim: &Claim,
    statement: &Written,
    subject: &Subject,
    edits: Vec<Edit>,
) -> Vec<Edit> {
    let agrees = |edit: &Edit| {
        let expr = subject.statement(&statement.expr, &edit.expr);
        let reading = Reading::new(claim, &expr, []);
        let found = judge_samples(&reading, &[], "correction", POINTS, MAX_WORK);
        found.failing.is_none() && found.holding > 0
    };
    let few = edits.into_iter().take(MAX_CANDIDATES);
    few.filter(agrees).collect()
}

/// Small numbers in the place of each number.
#[must_use]
pub(super) fn numbers(expr: &Expr) -> Vec<Edit> {
    let mut found = vec![];
    for (path, part, value) in exact_numbers(expr) {
        for other in (1..=MAX_NUMBER).map(integer).filter(|n| n != value) {
            let number = Expr::number(&other);
            found.push(Edit {
                change: Change::replaced(part, &number),
                expr: placed(expr, &path, number),
            });
        }
    }
    found
}
