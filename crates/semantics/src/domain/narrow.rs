//! Ranges that hypotheses narrow: `k > 0` among them says that k is to be drawn from the positive numbers.
//!
//! This finds points sooner and excludes none: whether all hypotheses are true is asked of every point all the same.

use super::solve::constraints;
use crate::evaluate::Evaluator;
use crate::gap::Work;
use crate::name::Name;
use crate::real::Reals;
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_language::core::{Claim, Node, Set, Term};
use torse_language::derivation::declarations::{Bound, Interval};
use torse_language::syntax::Relation;
use torse_numbers::Rational;

/// The operations that the number of one hypothesis may take, and their precision where they are not exact.
const MAX_WORK: u64 = 100;
const BITS: usize = 64;

/// The intervals of the symbols that a hypothesis compares with a rational number.
pub(crate) fn narrowed(claim: &Claim) -> BTreeMap<Arc<str>, Interval> {
    let mut all: BTreeMap<Arc<str>, Interval> = BTreeMap::new();
    for (relation, left, right) in constraints(claim) {
        let (name, relation, number) = match (&*left.node, &*right.node) {
            (Node::Symbol(name), _) => (name, relation, number(right)),
            (_, Node::Symbol(name)) => (name, relation.mirrored(), number(left)),
            _ => continue,
        };
        let (Some(Set::Real(declared)), Some(number)) = (claim.symbols.get(name), number) else {
            continue;
        };
        let interval = all
            .entry(Arc::clone(name))
            .or_insert_with(|| (**declared).clone());
        let bound = |closed| Bound {
            value: number.clone().into(),
            closed,
        };
        match relation {
            Relation::Less => narrow(&mut interval.upper, bound(false), |own, new| own > new),
            Relation::AtMost => narrow(&mut interval.upper, bound(true), |own, new| own > new),
            Relation::Greater => narrow(&mut interval.lower, bound(false), |own, new| own < new),
            Relation::AtLeast => narrow(&mut interval.lower, bound(true), |own, new| own < new),
            Relation::Equal | Relation::Different => {}
        }
    }
    all
}

/// Replaces an end of an interval by one that lies further inside. Multiples of pi stay.
fn narrow(end: &mut Option<Bound>, new: Bound, outside: fn(&Rational, &Rational) -> bool) {
    let keeps = end.as_ref().is_some_and(|own| {
        let (Some(a), Some(b)) = (own.value.as_rational(), new.value.as_rational()) else {
            return true;
        };
        !(outside(a, b) || (a == b && own.closed))
    });
    if !keeps {
        *end = Some(new);
    }
}

/// The rational number that a term without symbols is.
fn number(term: &Term) -> Option<Rational> {
    let work = Work::new(MAX_WORK);
    let reals = Reals {
        bits: BITS,
        work: &work,
    };
    let nameless = |_: &Name| None;
    let value = Evaluator::new(&reals, &nameless).value(term).ok()?;
    value.number().ok()?.as_number()?.as_rational().cloned()
}
