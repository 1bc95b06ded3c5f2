//! One side of an equality, replaced by candidates from outside.
//!
//! A comparison of code and print asks on each side for the one change after which both are equal. What may change in a
//! program is not known here: its candidates come with their formulas, and are filtered and proved like those of a print.

use super::alphabet::{Alphabet, alphabet};
use super::edit::{Edit, placed};
use super::points::MAX_CANDIDATES;
use super::subject::Subject;
use super::target::Target;
use super::{MAX_PROOFS, canonical, edits, insertions, provable, retyped};
use std::collections::BTreeSet;
use torse_semantics::judge_samples;
use torse_semantics::tree::Reading;
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::{Expr, Node};
use torse_syntax::notation::Formula;

/// The work of one search, in the units of [`Target`].
const MAX_WORK: u64 = 1_200_000;
/// Where a side has no value at the sample point: the points at which a candidate is judged, and the work there.
const POINTS: u64 = 2;
const POINT_WORK: u64 = 20_000;

/// A replacement after which both sides are equal.
#[derive(Debug, Clone)]
pub struct SideEdit<T> {
    /// What the candidate came with.
    pub change: T,
    /// The side after it.
    pub side: Expr,
    /// The conditions under which the sides are equal.
    pub conditions: Vec<Formula>,
    /// Whether no other candidate was proved that gives another formula.
    pub is_unique: bool,
}

/// What a search came to.
#[derive(Debug)]
pub struct SideSearch<T> {
    /// The first candidate that was proved.
    pub found: Option<SideEdit<T>>,
    /// Whether the work was used up before all candidates were tried.
    pub ended_early: bool,
}

/// Returns the first of the candidates for a side (0 is left) of an equality with which the equality is proved.
#[must_use]
pub fn replace_side<T>(
    claim: &Claim,
    statement: &Written,
    side: usize,
    candidates: impl IntoIterator<Item = (Expr, T)>,
) -> SideSearch<T> {
    let path = [side];
    let mut ended_early = false;
    let mut seen = BTreeSet::new();
    let mut found: Option<SideEdit<T>> = None;
    let subject = Subject::plain(&statement.expr, &path);
    let target = subject.and_then(|subject| Target::new(claim, statement, &subject));
    let target = target.as_ref();
    let agrees = |expr: &Expr| match target {
        Some(target) => target.apart(MAX_WORK, || target.agrees(expr)),
        None => {
            let whole = placed(&statement.expr, &path, expr.clone());
            let reading = Reading::new(claim, &whole, []);
            let judged = judge_samples(&reading, &[], "comparison", POINTS, POINT_WORK);
            judged.failing.is_none() && judged.holding > 0
        }
    };
    for (position, (expr, change)) in candidates.into_iter().enumerate() {
        let is_spent = match target {
            Some(target) => target.spent_more_than(MAX_WORK),
            None => position >= MAX_CANDIDATES,
        };
        if is_spent {
            ended_early = true;
            break;
        }
        if !agrees(&expr) {
            continue;
        }
        if seen.len() >= MAX_PROOFS {
            ended_early = true;
            break;
        }
        if !seen.insert(canonical::canonical(&expr)) {
            continue;
        }
        let whole = placed(&statement.expr, &path, expr.clone());
        let Some(conditions) = provable(claim, statement, &whole) else {
            continue;
        };
        if let Some(first) = &mut found {
            first.is_unique = false;
            break;
        }
        found = Some(SideEdit {
            change,
            side: expr,
            conditions,
            is_unique: true,
        });
    }
    SideSearch { found, ended_early }
}

/// Returns the one edit of the right side of an equality, or of the definition of a printed formula that it calls, after which both
/// sides are equal, with its change in words.
#[must_use]
pub fn edit_right_side(claim: &Claim, statement: &Written) -> SideSearch<String> {
    let subject = Subject::from_claim(claim, statement);
    let Some(subject) = subject.filter(|subject| subject.path == [1]) else {
        return SideSearch {
            found: None,
            ended_early: false,
        };
    };
    let alphabet = alphabet(claim, &statement.expr, &subject.formula);
    let edits = all_edits(&subject.formula, &alphabet);
    let candidates = edits.into_iter().map(|edit| {
        let side = subject.side(&edit.expr);
        (side, edit.change.to_string())
    });
    replace_side(claim, statement, 1, candidates)
}

/// Returns the formulas one edit away from one of a program, whose variables and lists are these: slips that say most first.
#[must_use]
pub fn edits_of_code(expr: &Expr, names: &[String], lists: &[String]) -> Vec<Edit> {
    let alphabet = Alphabet {
        names: names.to_vec(),
        families: lists.to_vec(),
        ..Alphabet::default()
    };
    all_edits(expr, &alphabet)
}

fn all_edits(expr: &Expr, alphabet: &Alphabet) -> Vec<Edit> {
    let mut all = edits::single(expr, alphabet);
    all.extend(insertions::edits(expr));
    all.extend(retyped::edits(expr));
    // A factor that is put in says least of what went wrong.
    all.sort_by_key(|edit| edit.change.is_factor_inserted());
    all
}

/// The sides of an equality.
#[must_use]
pub fn sides(statement: &Expr) -> Option<(&Expr, &Expr)> {
    match &statement.node {
        Node::Compare(left, rest) => match rest.as_slice() {
            [(torse_syntax::formula::Relation::Equal, right)] => Some((left, right)),
            _ => None,
        },
        _ => None,
    }
}
