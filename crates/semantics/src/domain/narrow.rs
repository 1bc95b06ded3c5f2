//! Narrows declared ranges by hypotheses: under `k > 0` positive numbers are drawn for k, under `k == 3` the number
//! 3.
//!
//! This only finds points sooner, and excludes none: all hypotheses are still checked at every point.

use super::constraints::Constraint;
use crate::name::Name;
use crate::no_value::Work;
use crate::real::Reals;
use crate::tree::{Reading, Values};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_numbers::rational::floor_quotient;
use torse_numbers::{Affine, Rational};
use torse_syntax::derivation::declarations::{Bound, SymbolKind};
use torse_syntax::formula::{Expr, Node, Relation};

/// The budget for evaluating the number in one hypothesis, and the precision if it is not exact.
const MAX_WORK: u64 = 100;
const BITS: usize = 64;

/// The sets from which symbols are drawn, narrowed by hypotheses that compare them with rational numbers.
#[derive(Debug, Clone, Default)]
pub(crate) struct Narrowed {
    /// The narrowed sets, by symbol.
    pub sets: BTreeMap<Arc<str>, SymbolKind>,
    /// The symbols that a hypothesis sets equal to a number.
    pub pinned: BTreeSet<Arc<str>>,
}

impl Narrowed {
    /// Narrows the sets of single symbols by the hypotheses of a claim.
    pub fn new(reading: &Reading<'_>, constraints: &[Constraint<'_>]) -> Self {
        let mut all = Self::default();
        let declarations = reading.declarations();
        let declared = |tree: &Expr| match &tree.node {
            Node::Name(name) if declarations.definition(name).is_none() => {
                let set = declarations.symbol(name)?;
                Some((Arc::from(name.as_str()), set.clone()))
            }
            _ => None,
        };
        for (relation, left, right) in constraints {
            let found = match (declared(left), declared(right)) {
                (Some(symbol), _) => number(reading, right).map(|n| (symbol, *relation, n)),
                (None, Some(symbol)) => {
                    number(reading, left).map(|n| (symbol, relation.mirrored(), n))
                }
                (None, None) => None,
            };
            let Some(((name, declared), relation, number)) = found else {
                continue;
            };
            let set = all.sets.entry(Arc::clone(&name)).or_insert(declared);
            if relation != Relation::Different && narrow(set, relation, &number) {
                all.pinned.insert(name);
            }
        }
        all
    }
}

/// Narrows a set to the numbers that have this relation to `number`. Returns whether only one number remains.
fn narrow(set: &mut SymbolKind, relation: Relation, number: &Rational) -> bool {
    let (below, above, closed) = match relation {
        Relation::Less => (true, false, false),
        Relation::AtMost => (true, false, true),
        Relation::Greater => (false, true, false),
        Relation::AtLeast => (false, true, true),
        Relation::Equal => (true, true, true),
        Relation::Different => return false,
    };
    match set {
        SymbolKind::Real(interval) => {
            let bound = || Bound {
                value: number.clone().into(),
                closed,
            };
            if below {
                narrow_end(&mut interval.upper, bound(), |own, new| own > new);
            }
            if above {
                narrow_end(&mut interval.lower, bound(), |own, new| own < new);
            }
        }
        SymbolKind::Integer { least, most } => {
            // The largest integer that is at most the number, and the smallest that is at least the number.
            let (numer, denom) = (number.numer(), number.denom());
            let last = i64::try_from(&floor_quotient(numer, denom));
            let first = i64::try_from(&-floor_quotient(&-numer, denom));
            let (Ok(last), Ok(first)) = (last, first) else {
                return false;
            };
            // If the number is an integer and the relation is strict, the number itself is excluded.
            let open = i64::from(!closed && last == first);
            match relation {
                Relation::Equal => {
                    *least = Some(Affine::number(first));
                    *most = Some(Affine::number(last));
                }
                _ if below => narrow_bound(most, last.saturating_sub(open), i64::min),
                _ => narrow_bound(least, first.saturating_add(open), i64::max),
            }
        }
        SymbolKind::Vector(_) | SymbolKind::Family { .. } => return false,
    }
    relation == Relation::Equal
}

/// Replaces a bound of an interval by one further inside. Multiples of pi are kept.
fn narrow_end(end: &mut Option<Bound>, new: Bound, outside: fn(&Rational, &Rational) -> bool) {
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

/// Replaces a bound of an integer by one further inside. Bounds that refer to other integers are kept.
fn narrow_bound(bound: &mut Option<Affine>, new: i64, inner: fn(i64, i64) -> i64) {
    let inside = match bound {
        None => new,
        Some(own) => match own.as_number() {
            None => return,
            Some(own) => inner(own, new),
        },
    };
    *bound = Some(Affine::number(inside));
}

/// The rational value of a formula without symbols, if it has one.
fn number(reading: &Reading<'_>, tree: &Expr) -> Option<Rational> {
    let work = Work::new(MAX_WORK);
    let reals = Reals::new(BITS, &work);
    let values = Values {
        number: &|_: &Name| None,
        near: false,
        fails: &|_| false,
    };
    let value = reading.value_of(tree, &reals, values).ok()?;
    value.number().ok()?.as_number()?.as_rational().cloned()
}
