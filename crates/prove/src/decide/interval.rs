//! Intervals with exact ends.

use torse_algebra::{Fraction, Scalar as _, Symbol};
use torse_language::derivation::declarations::{self, Constant};

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
