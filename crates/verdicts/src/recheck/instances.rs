//! The smallest values of the integer symbols of a claim.

use crate::outcome::Outcome;
use std::collections::{BTreeMap, BTreeSet};
use torse_algebra::Affine;
use torse_language::derivation::Claim;
use torse_language::derivation::declarations::{Declarations, SymbolKind};
use torse_language::syntax::{Expr, Node, Relation};

/// How many values of an unbounded integer are taken.
const SPAN: i64 = 3;
/// The most instances of one claim.
const MAX_INSTANCES: usize = 24;

/// An instance, written: `k = 2, l = 4`.
pub fn name(instance: &BTreeMap<String, i64>) -> String {
    let parts: Vec<String> = instance
        .iter()
        .map(|(name, value)| format!("{name} = {value}"))
        .collect();
    parts.join(", ")
}

/// The integers of the counterexample.
pub fn of_witness(claim: &Claim, outcome: &Outcome) -> Option<BTreeMap<String, i64>> {
    let witness = outcome.witness.as_ref()?;
    let is_integer = |name: &str| {
        matches!(
            claim.declarations.symbol(name),
            Some(SymbolKind::Integer { .. })
        )
    };
    let integers = witness.at.iter().filter(|(name, _)| is_integer(name));
    let values: BTreeMap<String, i64> = integers
        .filter_map(|(name, value)| Some((name.clone(), value.parse().ok()?)))
        .collect();
    (!values.is_empty() && values.keys().cloned().collect::<BTreeSet<_>>() == used(claim, None))
        .then_some(values)
}

/// Small instances: unbounded integers take their least values in turn, in different orders so that two
/// degrees are not always equal; bounded ones take all values.
pub fn small(claim: &Claim, statement: &Expr) -> Vec<BTreeMap<String, i64>> {
    let names = used(claim, Some(statement));
    let pinned = pinned(claim);
    let mut all = vec![];
    for turn in 0..SPAN {
        let mut partial = vec![BTreeMap::new()];
        let mut pending: Vec<&String> = names.iter().collect();
        let mut count = 0;
        // Bounds name other integers, so those come first.
        for _ in 0..names.len() {
            let ready = |n: &&&String| {
                bounds(&claim.declarations, n).all(|b| partial.iter().all(|p| at(&b, p).is_some()))
            };
            let Some(name) = pending.iter().find(ready).map(|n| (*n).clone()) else {
                break;
            };
            pending.retain(|n| **n != name);
            let unbounded_turn = (turn * (1 + count % 2)) % SPAN;
            let range = |p: &BTreeMap<String, i64>| {
                if let Some(value) = pinned.get(&name) {
                    return *value..=*value;
                }
                let bound = |b: &Option<Affine>| b.as_ref().and_then(|b| at(b, p));
                match claim.declarations.symbol(&name) {
                    Some(SymbolKind::Integer { least, most }) => {
                        match (bound(least), bound(most)) {
                            (Some(least), Some(most)) => least..=most.min(least + 11),
                            (least, _) => {
                                least.unwrap_or(0) + unbounded_turn
                                    ..=least.unwrap_or(0) + unbounded_turn
                            }
                        }
                    }
                    _ => 0..=0,
                }
            };
            let unbounded = partial.iter().all(|p| range(p).count() == 1);
            count += i64::from(unbounded);
            let with = |p: &BTreeMap<String, i64>, value| {
                let mut more = p.clone();
                more.insert(name.clone(), value);
                more
            };
            partial = partial
                .iter()
                .flat_map(|p| range(p).map(|value| with(p, value)).collect::<Vec<_>>())
                .collect();
            partial.truncate(MAX_INSTANCES);
        }
        all.extend(partial);
    }
    let mut seen = BTreeSet::new();
    all.retain(|instance| seen.insert(instance.clone()));
    all.truncate(MAX_INSTANCES);
    all
}

fn bounds(declarations: &Declarations, name: &str) -> impl Iterator<Item = Affine> {
    let (least, most) = match declarations.symbol(name) {
        Some(SymbolKind::Integer { least, most }) => (least.clone(), most.clone()),
        _ => (None, None),
    };
    least.into_iter().chain(most)
}

/// The value of a bound.
fn at(form: &Affine, instance: &BTreeMap<String, i64>) -> Option<i64> {
    form.multiples()
        .try_fold(form.constant(), |sum, (name, multiple)| {
            instance.get(name).map(|value| sum + multiple * value)
        })
}

/// Integers that an assumption gives a value: `m == 3`.
fn pinned(claim: &Claim) -> BTreeMap<String, i64> {
    let one = |expr: &Expr| {
        let Node::Compare(first, rest) = &expr.node else {
            return None;
        };
        let [(Relation::Equal, right)] = rest.as_slice() else {
            return None;
        };
        match (&first.node, &right.node) {
            (Node::Name(name), Node::Number { value, .. }) if value.is_integer() => {
                Some((name.clone(), i64::try_from(value.to_integer()).ok()?))
            }
            _ => None,
        }
    };
    claim
        .assumptions
        .iter()
        .filter_map(|a| one(&a.expr))
        .collect()
}

/// The integer symbols that a claim uses, through definitions and bounds.
fn used(claim: &Claim, statement: Option<&Expr>) -> BTreeSet<String> {
    let declarations = &claim.declarations;
    let written = claim
        .statement
        .iter()
        .filter(|_| statement.is_none())
        .chain(&claim.given)
        .chain(&claim.assumptions)
        .chain(&claim.unknowns);
    let mut pending: Vec<String> = statement
        .into_iter()
        .chain(written.map(|w| &w.expr))
        .flat_map(free)
        .collect();
    let (mut seen, mut integers) = (BTreeSet::new(), BTreeSet::new());
    while let Some(name) = pending.pop() {
        if !seen.insert(name.clone()) {
            continue;
        }
        if matches!(declarations.symbol(&name), Some(SymbolKind::Integer { .. })) {
            integers.insert(name.clone());
            let named = bounds(declarations, &name)
                .flat_map(|b| b.multiples().map(|(n, _)| n.to_owned()).collect::<Vec<_>>());
            pending.extend(named);
        }
        let base = name.trim_end_matches('\'');
        for definition in [
            declarations.definition(&name),
            declarations.definition(base),
        ]
        .into_iter()
        .flatten()
        {
            let inner = free(&definition.body.expr).into_iter();
            pending.extend(inner.filter(|n| !definition.parameters.contains(n)));
        }
    }
    integers
}

/// The names of a formula that no sum binds.
fn free(expr: &Expr) -> BTreeSet<String> {
    match &expr.node {
        Node::Name(name) => BTreeSet::from([name.clone()]),
        Node::Call(head, arguments) if matches!(&head.node, Node::Name(n) if n == "sum") => {
            let mut all: BTreeSet<String> = arguments.iter().skip(3).flat_map(free).collect();
            if let Some(Node::Name(index)) = arguments.first().map(|a| &a.node) {
                all.remove(index);
            }
            all.extend(arguments.iter().skip(1).take(2).flat_map(free));
            all
        }
        _ => expr.parts().into_iter().flat_map(free).collect(),
    }
}
