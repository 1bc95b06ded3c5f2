//! Small instances of statements about all degrees.
//!
//! Where a symbolic degree cannot be carried through, integer symbols get their smallest values in turn.
//! One failing instance refutes the statement. Instances that hold prove nothing, unless the ranges of
//! the integers are finite and every instance was decided.

use super::Decision;
use crate::evidence::Evidence;
use std::collections::BTreeMap;
use torse_algebra::Fraction;
use torse_language::derivation::declarations::{Declarations, SymbolKind};

/// How many values of each unbounded integer are tried.
const SPAN: i64 = 4;
/// The most instances of one statement.
const MAX_INSTANCES: usize = 240;

/// The integers in an order in which a symbol whose bound names another one comes after it.
#[must_use]
pub fn ordered(integers: Vec<String>, declarations: &Declarations) -> Vec<String> {
    // A symbol whose bound names another one comes after it.
    let mut ordered: Vec<String> = vec![];
    let mut rest = integers;
    while !rest.is_empty() {
        let free = |name: &String| match declarations.symbol(name) {
            Some(SymbolKind::Integer { least, most }) => {
                let bounds = least
                    .iter()
                    .chain(most)
                    .flat_map(torse_algebra::Affine::multiples);
                !bounds
                    .into_iter()
                    .any(|(other, _)| other != name && rest.iter().any(|r| r == other))
            }
            _ => true,
        };
        let position = rest.iter().position(free).unwrap_or(0);
        ordered.push(rest.remove(position));
    }
    ordered
}

/// Values of the integers, smallest first, and whether the list is complete.
#[must_use]
pub fn assignments(
    integers: &[String],
    declarations: &Declarations,
) -> (Vec<BTreeMap<String, i64>>, bool) {
    let mut all: Vec<BTreeMap<String, i64>> = vec![BTreeMap::new()];
    let mut complete = true;
    for name in integers {
        let Some(SymbolKind::Integer { least, most }) = declarations.symbol(name) else {
            continue;
        };
        let mut next = vec![];
        for fixed in &all {
            let number = |form: &torse_algebra::Affine| {
                fixed
                    .iter()
                    .fold(form.clone(), |f, (n, v)| {
                        f.substituted(n, &torse_algebra::Affine::number(*v))
                    })
                    .as_number()
            };
            let low = least.as_ref().and_then(number);
            let high = most.as_ref().and_then(number);
            complete &= low.is_some() && high.is_some_and(|h| h - low.unwrap_or(h) < 12);
            let start = low.unwrap_or(0);
            let end = high.unwrap_or(start + SPAN - 1).min(start + 11);
            for value in start..=end {
                let mut more = fixed.clone();
                more.insert(name.clone(), value);
                next.push(more);
            }
        }
        all = next;
    }
    // Small sums of the integers first, so that a counterexample is simple.
    all.sort_by_key(|fixed| fixed.values().sum::<i64>());
    if all.len() > MAX_INSTANCES {
        complete = false;
        all.truncate(MAX_INSTANCES);
    }
    (all, complete)
}

/// The values as fixed symbols.
#[must_use]
pub fn fixed(assignment: &BTreeMap<String, i64>) -> BTreeMap<String, Fraction> {
    assignment
        .iter()
        .map(|(name, value)| (name.clone(), Fraction::integer(*value)))
        .collect()
}

/// The decision from all instances: a refutation with the integers in front of its witness, a proof if
/// the instances are all there are, open otherwise. An instance without points says nothing.
#[must_use]
pub fn combined(
    instances: Vec<(BTreeMap<String, i64>, Decision)>,
    complete: bool,
    reason: &str,
) -> Decision {
    let mut conditions = vec![];
    let mut tried = vec![];
    let mut empty = None;
    let mut proven = false;
    for (assignment, decision) in instances {
        let label = assignment
            .iter()
            .map(|(n, v)| format!("{n} = {v}"))
            .collect::<Vec<_>>()
            .join(", ");
        match decision {
            Decision::Refuted(mut refutation) => {
                let known = refutation.witness.at.clone();
                let integers = assignment
                    .iter()
                    .filter(|(n, _)| known.iter().all(|(name, _)| name != *n))
                    .map(|(n, v)| (n.clone(), v.to_string()));
                refutation.witness.at.splice(0..0, integers);
                refutation.steps.insert(0, format!("the instance {label}"));
                return Decision::Refuted(refutation);
            }
            Decision::Proven {
                conditions: more, ..
            } => {
                proven = true;
                conditions.extend(more);
                tried.push(format!("holds for {label}"));
            }
            Decision::Vacuous { reason } => {
                tried.push(format!("says nothing for {label}: {reason}"));
                empty.get_or_insert(reason);
            }
            Decision::Open { reason, .. } => {
                tried.push(format!("open for {label}: {reason}"));
                return Decision::Open { reason, tried };
            }
        }
    }
    match (complete, proven, empty) {
        (true, true, _) => {
            conditions.sort();
            conditions.dedup();
            Decision::Proven {
                evidence: Evidence::Identity,
                conditions,
                steps: tried,
            }
        }
        (true, false, Some(reason)) => Decision::Vacuous { reason },
        _ => Decision::Open {
            reason: reason.to_owned(),
            tried,
        },
    }
}
