//! Corrections of refuted formulas.
//!
//! The right side of a refuted equality is edited, first once, then twice; candidates are filtered at a
//! sample point ([`sample`]) and the survivors **proved** like any statement. The smallest number of
//! edits wins; whether another correction with as few edits exists is reported.

pub mod canonical;
pub mod edits;
pub mod sample;

use crate::derivation::{Claim, Written};
use crate::engine::case::Case;
use crate::engine::decide_statement;
use crate::evaluate::Evaluator;
use crate::evaluate::scope::SymbolKind;
use crate::evaluate::value::{Statement, Value};
use crate::notation;
use crate::outcome::Correction;
use crate::syntax::{Connective, Expr, Node, Relation};
use edits::{Alphabet, Edit};
use std::collections::{BTreeMap, BTreeSet};
use torse_algebra::Fraction;

/// The most candidates evaluated with one edit.
const MAX_SINGLE: usize = 6_000;
/// The most first edits that are combined with a second one.
const MAX_FIRST: usize = 150;
/// The most candidates evaluated with two edits.
const MAX_DOUBLE: usize = 12_000;
/// The work one search may do, in units of a visited node of a formula.
const MAX_WORK: u64 = 400_000;
/// How many survivors of the sample point are proved before the search ends.
const MAX_PROOFS: usize = 8;
/// A comparison whose left side has at most so many nodes is a tautology when both sides are equal.
const MAX_TAUTOLOGY: usize = 5;
/// Formulas larger than this are corrected with one edit at most.
const MAX_SIZE_DOUBLE: usize = 60;

/// Searches a correction of a refuted statement.
#[must_use]
pub fn search(claim: &Claim, statement: &Written) -> Option<Correction> {
    let (path, right) = failing_side(claim, statement)?;
    let target = Target::new(claim, statement, &path)?;
    let alphabet = alphabet(claim, &statement.expr);
    let singles = edits::single(&right, &alphabet);
    let once: Vec<(Edit, Vec<String>)> = singles
        .iter()
        .take(MAX_SINGLE)
        .filter(|edit| target.agrees(&edit.expr))
        .map(|edit| (edit.clone(), vec![edit.change.clone()]))
        .collect();
    if let Some(found) = proved(claim, statement, &path, once) {
        return Some(found);
    }
    if right.size() > MAX_SIZE_DOUBLE {
        return None;
    }
    let mut twice = vec![];
    let mut budget = MAX_DOUBLE;
    for first in singles.iter().take(MAX_FIRST) {
        for second in edits::single(&first.expr, &Alphabet::default()) {
            budget = budget.saturating_sub(1);
            if budget == 0 || twice.len() >= MAX_PROOFS {
                break;
            }
            if second.expr != right && target.agrees(&second.expr) {
                let changes = vec![first.change.clone(), second.change.clone()];
                twice.push((second, changes));
            }
        }
    }
    proved(claim, statement, &path, twice)
}

/// Proves candidates; the first proved one is the correction, a second essentially different one makes
/// it not unique.
fn proved(
    claim: &Claim,
    statement: &Written,
    path: &[usize],
    candidates: Vec<(Edit, Vec<String>)>,
) -> Option<Correction> {
    let mut seen = BTreeSet::new();
    let mut found: Option<Correction> = None;
    for (edit, changes) in candidates {
        if seen.len() >= MAX_PROOFS {
            break;
        }
        let key = canonical::canonical(&edit.expr);
        if !seen.insert(key) {
            continue;
        }
        let expr = edits::placed(&statement.expr, path, edit.expr);
        if is_tautology(&expr, path) {
            continue;
        }
        let trial = Written {
            expr: expr.clone(),
            origin: statement.origin.clone(),
        };
        if !decide_statement(claim, &trial).is_ok_and(|d| d.is_proven()) {
            continue;
        }
        match &mut found {
            None => {
                found = Some(Correction {
                    statement: notation::formula(&expr),
                    edits: changes,
                    unique: true,
                })
            }
            Some(first) => {
                first.unique = false;
                return found;
            }
        }
    }
    found
}

/// Whether the comparison at the end of the path says the same thing twice: no correction.
fn is_tautology(expr: &Expr, path: &[usize]) -> bool {
    let parent = path.split_last().map_or(path, |(_, parent)| parent);
    let comparison = parent
        .iter()
        .try_fold(expr, |e, position| e.parts().into_iter().nth(*position));
    match comparison.map(|e| &e.node) {
        // A long formula that comes to repeat the left side is a corrected restatement; a short one
        // says nothing.
        Some(Node::Compare(left, _)) if left.size() > MAX_TAUTOLOGY => false,
        Some(Node::Compare(left, rest)) => rest
            .iter()
            .any(|(_, right)| canonical::canonical(left) == canonical::canonical(right)),
        _ => false,
    }
}

/// The right side of the first equality of the statement that does not hold, and the way to it.
fn failing_side(claim: &Claim, statement: &Written) -> Option<(Vec<usize>, Expr)> {
    let mut path = vec![];
    let mut expr = &statement.expr;
    while let Node::Join(Connective::And, a, b) = &expr.node {
        let part = Written {
            expr: (**a).clone(),
            origin: statement.origin.clone(),
        };
        let first_fails = decide_statement(claim, &part).is_ok_and(|d| d.is_refuted());
        path.push(usize::from(!first_fails));
        expr = if first_fails { a } else { b };
    }
    match &expr.node {
        Node::Compare(_, rest) => match rest.as_slice() {
            [(Relation::Equal, right)] => {
                path.push(1);
                Some((path, right.clone()))
            }
            _ => None,
        },
        _ => None,
    }
}

/// The most names of a kind that edits may put in.
const MAX_NAMES: usize = 16;

/// Numbers, vectors and families that occur in the claim, through definitions; those of the formula
/// itself first.
fn alphabet(claim: &Claim, expr: &Expr) -> Alphabet {
    let mut seen: BTreeSet<String> = BTreeSet::new();
    let mut alphabet = Alphabet::default();
    let mut level: Vec<&Expr> = std::iter::once(expr)
        .chain(claim.given.iter().map(|w| &w.expr))
        .collect();
    while !level.is_empty() {
        let mut deeper = vec![];
        for name in level.iter().flat_map(|e| e.names()) {
            if !seen.insert(name.to_owned()) {
                continue;
            }
            match claim.declarations.symbol(name) {
                Some(SymbolKind::Real(_) | SymbolKind::Integer { .. } | SymbolKind::Vector(_)) => {
                    alphabet.names.push(name.to_owned());
                }
                Some(SymbolKind::Family { .. }) => alphabet.families.push(name.to_owned()),
                None => {}
            }
            if let Some(definition) = claim.declarations.definition(name) {
                if definition.parameters.is_empty() && level.len() == 1 {
                    alphabet.names.push(name.to_owned());
                }
                deeper.push(&definition.body.expr);
            }
        }
        level = deeper;
    }
    // A name is usually one of a pair.
    for (one, other) in [
        ("mu", "nu"),
        ("mu1", "nu1"),
        ("mu2", "nu2"),
        ("k", "l"),
        ("m", "n"),
    ] {
        for (present, absent) in [(one, other), (other, one)] {
            if seen.contains(present)
                && claim.declarations.symbol(absent).is_some()
                && seen.insert(absent.to_owned())
            {
                alphabet.names.push(absent.to_owned());
            }
        }
    }
    alphabet.names.truncate(MAX_NAMES);
    alphabet.families.truncate(MAX_NAMES);
    alphabet
}

/// The left side at a few instances of the integers, at the sample point.
struct Target<'a> {
    instances: Vec<(Evaluator<'a>, Vec<Fraction>)>,
}

impl<'a> Target<'a> {
    fn new(claim: &'a Claim, statement: &Written, path: &[usize]) -> Option<Self> {
        let exprs: Vec<&Expr> = std::iter::once(statement)
            .chain(&claim.given)
            .map(|w| &w.expr)
            .collect();
        let integers = crate::decide::instances::integers_used(&exprs, &claim.declarations);
        let mut instances = vec![];
        for shift in 0..2_i64 {
            // Different integers for different symbols, above the special small degrees.
            let fixed: BTreeMap<String, Fraction> = integers
                .iter()
                .enumerate()
                .map(|(position, name)| {
                    let spread = i64::try_from(position).unwrap_or(0);
                    let form = torse_algebra::Affine::symbol(name);
                    let top = claim.declarations.greatest(&form).unwrap_or(i64::MAX);
                    let least = claim.declarations.least(&form).unwrap_or(2);
                    (
                        name.clone(),
                        Fraction::integer((least + 2 + spread + shift).min(top)),
                    )
                })
                .collect();
            let case = Case::new(claim, statement, fixed).ok()?;
            let left = side(&case.statement, path)?;
            let values = left
                .entries()
                .into_iter()
                .map(|q| q.as_fraction().and_then(sample::at_sample))
                .collect::<Option<Vec<_>>>()?;
            instances.push((case.evaluator.sampling(), values));
            if integers.is_empty() {
                break;
            }
        }
        Some(Self { instances })
    }

    /// Whether a candidate agrees with the left side at every instance; never once the work is used up.
    fn agrees(&self, candidate: &Expr) -> bool {
        if self
            .instances
            .iter()
            .map(|(evaluator, _)| evaluator.work())
            .sum::<u64>()
            > MAX_WORK
        {
            return false;
        }
        self.instances.iter().all(|(evaluator, left)| {
            let Ok(value) = evaluator.evaluate(candidate) else {
                return false;
            };
            let entries = value.entries();
            entries.len() == left.len()
                && entries.iter().zip(left).all(|(q, l)| {
                    q.as_fraction()
                        .and_then(sample::at_sample)
                        .is_some_and(|r| r == *l)
                })
        })
    }
}

/// The left side of the comparison at the end of the path.
fn side<'s>(statement: &'s Statement, path: &[usize]) -> Option<&'s Value> {
    match (statement, path) {
        (Statement::Join(_, a, b), [first, rest @ ..]) => {
            side(if *first == 0 { a } else { b }, rest)
        }
        (Statement::Compare { left, .. }, _) => Some(left),
        _ => None,
    }
}
