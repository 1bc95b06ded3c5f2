//! Small instances of statements about all degrees.
//!
//! Where a symbolic degree cannot be carried through, integer symbols get their smallest values in turn.
//! One failing instance refutes the statement. Instances that hold prove nothing, unless the ranges of
//! the integers are finite and every instance was decided.

use super::value::Proof;
use super::{Decision, Refutation, Unsettled};
use std::collections::BTreeMap;
use torse_algebra::Fraction;
use torse_certificate::Refuted;
use torse_certificate::proof::{Emptiness, Instance};
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};

/// How far integers are raised where small ones say nothing.
const FAR: i64 = 12;
/// How many values of each unbounded integer are tried.
const SPAN: i64 = 4;
/// The most instances of one statement.
const MAX_INSTANCES: usize = 240;
/// The most assignments of some of the integers that are carried on to the next one: all there are of a few integers, those
/// of the smallest sum of many.
const MAX_CARRIED: usize = 1_024;

/// The integers in an order in which a symbol whose bound names another one comes after it.
#[must_use]
pub fn ordered(integers: Vec<String>, declarations: &Declarations) -> Vec<String> {
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
///
/// The work grows with the number of integers and not with its power: at most `MAX_CARRIED` assignments of the first of
/// them are extended by the next.
#[must_use]
pub fn assignments(
    integers: &[String],
    declarations: &Declarations,
) -> (Vec<BTreeMap<String, i64>>, bool) {
    // Each assignment as the values of the integers so far.
    let mut all: Vec<Vec<i64>> = vec![vec![]];
    let mut complete = true;
    let mut names: Vec<&String> = vec![];
    for name in integers {
        let Some(SymbolKind::Integer { least, most }) = declarations.symbol(name) else {
            continue;
        };
        let mut next = vec![];
        for fixed in &all {
            let number = |form: &torse_algebra::Affine| {
                if let Some(number) = form.as_number() {
                    return Some(number);
                }
                let known = names.iter().zip(fixed);
                known
                    .fold(form.clone(), |f, (n, v)| {
                        f.substituted(n, &torse_algebra::Affine::number(*v))
                    })
                    .as_number()
            };
            let low = least.as_ref().and_then(number);
            let high = most.as_ref().and_then(number);
            complete &=
                low.is_some() && high.is_some_and(|h| h.saturating_sub(low.unwrap_or(h)) < 12);
            let start = low.unwrap_or(0);
            let some = start.saturating_add(SPAN - 1);
            let end = high.unwrap_or(some).min(start.saturating_add(11));
            for value in start..=end {
                next.push([fixed.as_slice(), &[value]].concat());
            }
        }
        all = next;
        names.push(name);
        if all.len() > MAX_CARRIED {
            complete &= cut(&mut all, MAX_CARRIED);
        }
    }
    complete &= cut(&mut all, MAX_INSTANCES);
    let named = |values: Vec<i64>| {
        names
            .iter()
            .map(|name| (*name).clone())
            .zip(values)
            .collect()
    };
    (all.into_iter().map(named).collect(), complete)
}

/// Assignments with greater integers than the first of these, all integers raised together.
#[must_use]
pub fn far(
    assignments: &[BTreeMap<String, i64>],
    declarations: &Declarations,
) -> Vec<BTreeMap<String, i64>> {
    let Some(first) = assignments.first() else {
        return vec![];
    };
    let raised = |by: i64| -> BTreeMap<String, i64> {
        let value = |name: &String, least: i64| {
            let greatest = declarations.greatest(&torse_algebra::Affine::symbol(name));
            least.saturating_add(by).min(greatest.unwrap_or(i64::MAX))
        };
        first
            .iter()
            .map(|(name, least)| (name.clone(), value(name, *least)))
            .collect()
    };
    (SPAN..=FAR).map(raised).collect()
}

/// Sorts by the sum of the integers, so that a counterexample is simple, and cuts off what is too much. Returns whether all
/// are still there.
fn cut(all: &mut Vec<Vec<i64>>, most: usize) -> bool {
    let sum = |values: &Vec<i64>| {
        values
            .iter()
            .fold(0_i64, |sum, value| sum.saturating_add(*value))
    };
    all.sort_by_key(sum);
    let complete = all.len() <= most;
    all.truncate(most);
    complete
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
/// the instances are all there are, open otherwise. An instance without points says nothing. Where the statement has no value in
/// any of them, that is no lack of points: it stays open.
#[must_use]
pub fn combined(
    instances: Vec<(BTreeMap<String, i64>, Decision)>,
    complete: bool,
    reason: &str,
) -> Decision {
    let mut proofs = vec![];
    let (mut empty, mut undefined) = (None, None);
    let mut proven = false;
    for (integers, decision) in instances {
        match decision {
            Decision::Refuted(refutation) => {
                return Decision::Refuted(Box::new(Refutation {
                    refuted: Refuted::Instance {
                        integers,
                        refuted: Box::new(refutation.refuted),
                    },
                    sides: refutation.sides,
                }));
            }
            Decision::Proven(proof) => {
                proven = true;
                proofs.push(Instance { integers, proof });
            }
            Decision::Vacuous(emptiness) => {
                match &emptiness {
                    Emptiness::Undefined(term) => undefined = Some(term.clone()),
                    nowhere => empty = Some(nowhere.clone()),
                }
                let proof = Proof::Nowhere(emptiness);
                proofs.push(Instance { integers, proof });
            }
            Decision::Open(Unsettled { reason, .. }) => {
                return Decision::Open(Unsettled {
                    tried: vec![format!("open for {}: {reason}", label(&integers))],
                    instances: proofs,
                    reason,
                });
            }
        }
    }
    let reason = match (complete, proven, undefined, empty) {
        (true, true, ..) => return Decision::Proven(Proof::Instances(proofs)),
        (true, false, None, Some(emptiness)) => return Decision::Vacuous(emptiness),
        (true, false, Some(term), _) => term,
        _ => reason.to_owned(),
    };
    Decision::Open(Unsettled {
        reason,
        instances: proofs,
        tried: vec![],
    })
}

pub(crate) fn label(integers: &BTreeMap<String, i64>) -> String {
    let values = integers.iter().map(|(n, v)| format!("{n} = {v}"));
    values.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_algebra::Affine;

    fn integers(count: i64, most: Option<i64>) -> (Vec<String>, Declarations) {
        let names: Vec<String> = (0..count).map(|n| format!("n{n:02}")).collect();
        let mut declarations = Declarations::default();
        for name in &names {
            let (least, most) = (Some(Affine::number(0)), most.map(Affine::number));
            declarations.declare(name, SymbolKind::Integer { least, most });
        }
        (names, declarations)
    }

    #[test]
    fn a_few_integers_get_all_their_values_and_the_list_says_so() {
        let (names, declarations) = integers(3, Some(2));
        let (all, complete) = assignments(&names, &declarations);
        assert_eq!((all.len(), complete), (27, true));
        let sums: Vec<i64> = all.iter().map(|fixed| fixed.values().sum()).collect();
        assert!(sums.is_sorted());
        assert!(!assignments(&names[..1], &integers(1, None).1).1);
    }

    #[test]
    fn many_integers_get_a_few_small_values_each_at_once() {
        for most in [None, Some(1), Some(i64::MAX)] {
            let (names, declarations) = integers(60, most);
            let (all, complete) = assignments(&names, &declarations);
            assert_eq!((all.len(), complete), (MAX_INSTANCES, false));
            assert!(all.iter().all(|fixed| fixed.len() == 60));
            assert!(all[0].values().all(|value| *value == 0));
            assert!(all.iter().all(|fixed| fixed.values().sum::<i64>() <= 3));
        }
    }
}
