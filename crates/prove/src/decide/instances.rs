//! Small instances of statements about all degrees.
//!
//! Where a symbolic degree cannot be carried through, integer symbols get their smallest values in turn.
//! One failing instance refutes the statement. Instances that hold prove nothing, unless the ranges of
//! the integers are finite and every instance was decided.

use super::Decision;
use crate::evidence::Evidence;
use std::collections::{BTreeMap, BTreeSet};
use torse_algebra::Fraction;
use torse_language::derivation::declarations::{Declarations, SymbolKind};
use torse_language::syntax::{Expr, Node};

/// How many values of each unbounded integer are tried.
const SPAN: i64 = 4;
/// The most instances of one statement.
const MAX_INSTANCES: usize = 240;

/// The integer symbols that formulas use, through definitions.
#[must_use]
pub fn integers_used(exprs: &[&Expr], declarations: &Declarations) -> Vec<String> {
    let mut seen = BTreeSet::new();
    let mut pending: Vec<&Expr> = exprs.to_vec();
    let mut integers = BTreeSet::new();
    while let Some(expr) = pending.pop() {
        let mut names = BTreeSet::new();
        free_names(expr, &mut vec![], &mut names);
        for name in names {
            let base = name.trim_end_matches('\'');
            if !seen.insert(name.clone()) {
                continue;
            }
            if matches!(declarations.symbol(base), Some(SymbolKind::Integer { .. })) {
                integers.insert(base.to_owned());
            }
            let definition = declarations
                .definition(&name)
                .or_else(|| declarations.definition(base));
            pending.extend(definition.map(|d| &d.body.expr));
        }
    }
    // A symbol whose bound names another one comes after it.
    let mut ordered: Vec<String> = vec![];
    let mut rest: Vec<String> = integers.into_iter().collect();
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

/// The names of a formula that no sum binds.
fn free_names<'e>(expr: &'e Expr, bound: &mut Vec<&'e str>, into: &mut BTreeSet<String>) {
    match &expr.node {
        Node::Name(name) => {
            if !bound.contains(&name.as_str()) {
                into.insert(name.clone());
            }
        }
        Node::Call(head, arguments) => {
            if let (Node::Name(function), [index, low, high, term]) =
                (&head.node, arguments.as_slice())
                && function == "sum"
                && let Node::Name(index) = &index.node
            {
                free_names(low, bound, into);
                free_names(high, bound, into);
                bound.push(index);
                free_names(term, bound, into);
                bound.pop();
                return;
            }
            expr.parts()
                .into_iter()
                .for_each(|part| free_names(part, bound, into));
        }
        _ => expr
            .parts()
            .into_iter()
            .for_each(|part| free_names(part, bound, into)),
    }
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
/// the instances are all there are, open otherwise.
#[must_use]
pub fn combined(
    instances: Vec<(BTreeMap<String, i64>, Decision)>,
    complete: bool,
    reason: &str,
) -> Decision {
    let mut conditions = vec![];
    let mut tried = vec![];
    for (assignment, decision) in instances {
        let label = assignment
            .iter()
            .map(|(n, v)| format!("{n} = {v}"))
            .collect::<Vec<_>>()
            .join(", ");
        match decision {
            Decision::Refuted(mut refutation) => {
                let integers = assignment.iter().map(|(n, v)| (n.clone(), v.to_string()));
                refutation.witness.at.splice(0..0, integers);
                refutation.steps.insert(0, format!("the instance {label}"));
                return Decision::Refuted(refutation);
            }
            // "Somewhere": one instance is enough.
            Decision::Proven {
                evidence: Evidence::Witness,
                conditions,
                mut steps,
            } => {
                steps.insert(0, format!("the instance {label}"));
                return Decision::Proven {
                    evidence: Evidence::Witness,
                    conditions,
                    steps,
                };
            }
            Decision::Proven {
                conditions: more, ..
            } => {
                conditions.extend(more);
                tried.push(format!("holds for {label}"));
            }
            vacuous @ Decision::Vacuous { .. } => return vacuous,
            Decision::Open { reason, .. } => {
                tried.push(format!("open for {label}: {reason}"));
                return Decision::Open { reason, tried };
            }
        }
    }
    if complete && !tried.is_empty() {
        conditions.sort();
        conditions.dedup();
        return Decision::Proven {
            evidence: Evidence::Identity,
            conditions,
            steps: tried,
        };
    }
    Decision::Open {
        reason: reason.to_owned(),
        tried,
    }
}
