//! Intervals with exact ends.

use super::order::order;
use std::cmp::Ordering;
use torse_algebra::{Fraction, Scalar as _, Symbol};
use torse_syntax::derivation::declarations::{self, Constant};
use torse_syntax::formula::Relation;

/// One end of an interval.
#[derive(Debug, Clone)]
pub struct Bound {
    /// The exact value (a rational, or a rational multiple of pi).
    pub value: Fraction,
    /// Whether the end belongs to the interval.
    pub closed: bool,
}

/// An interval of real numbers; a missing end is infinite.
#[derive(Debug, Clone, Default)]
pub struct Interval {
    /// The lower end.
    pub lower: Option<Bound>,
    /// The upper end.
    pub upper: Option<Bound>,
}

impl Interval {
    /// Leaves out what is not `relation number`. An end that lies further inside stays, and so does one of which that
    /// cannot be told.
    pub fn narrow(&mut self, relation: Relation, number: &Fraction) {
        let (end, closed, inward) = match relation {
            Relation::Greater => (&mut self.lower, false, Ordering::Greater),
            Relation::AtLeast => (&mut self.lower, true, Ordering::Greater),
            Relation::Less => (&mut self.upper, false, Ordering::Less),
            Relation::AtMost => (&mut self.upper, true, Ordering::Less),
            Relation::Equal | Relation::Different => return,
        };
        let narrows = match end.as_ref() {
            None => true,
            Some(own) => {
                let gap = number.clone() - own.value.clone();
                order(&gap).is_some_and(|order| order == inward || (order.is_eq() && own.closed))
            }
        };
        if narrows {
            *end = Some(Bound {
                value: number.clone(),
                closed,
            });
        }
    }
}

/// A part of the domain: a symbol, and the interval that it is looked at in. The interval of the cosine of an angle is
/// one of its variable, for that angle alone: an angle is given but for whole turns.
pub type Part = (Symbol, Interval);

/// The exact value of a constant.
#[must_use]
pub fn exact(constant: &Constant) -> Fraction {
    Fraction::from(constant.rational.clone()) + Fraction::symbol(Symbol::Pi).scaled(&constant.turns)
}

impl From<&declarations::Interval> for Interval {
    fn from(declared: &declarations::Interval) -> Self {
        let end = |bound: &declarations::Bound| Bound {
            value: exact(&bound.value),
            closed: bound.closed,
        };
        Self {
            lower: declared.lower.as_ref().map(end),
            upper: declared.upper.as_ref().map(end),
        }
    }
}
