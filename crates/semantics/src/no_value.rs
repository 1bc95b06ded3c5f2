//! Why a term has no value, or no known value, at a point.

use std::cell::Cell;
use std::fmt;

/// Why a term has no value.
///
/// The two kinds are never mixed: [`NoValue::Undefined`] is a fact about the term at this point, [`NoValue::Unknown`]
/// is a limitation of this evaluator.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NoValue {
    /// The term is undefined at this point, so a claim about the term makes no assertion there.
    Undefined(Undefined),
    /// The evaluator could not determine whether the term has a value, or which.
    Unknown(Unknown),
}

/// Why a term is undefined at a point.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Undefined {
    /// A divisor is zero, a power of zero has a negative exponent, or a matrix to invert is singular.
    #[error("division by zero")]
    ZeroDivisor,
    /// The root of a negative number.
    #[error("the root of a negative number")]
    NegativeRoot,
    /// The logarithm of a number that is not positive.
    #[error("the logarithm of a number that is not positive")]
    NoLogarithm,
    /// The arc sine or the arc cosine of a number above 1 or below -1, or an arc of what has no value.
    #[error("the arc of a number that has none")]
    NoArc,
    /// An index, degree, order or exponent that is not an integer.
    #[error("{what} that is not an integer")]
    NoInteger {
        /// What should be an integer.
        what: &'static str,
    },
    /// A negative order of a derivative, or a negative argument of a factorial.
    #[error("{what} that is negative")]
    Negative {
        /// What should not be negative.
        what: &'static str,
    },
    /// An index of a family of points, or of an entry, that is out of range.
    #[error("the index {index} of `{name}` is outside {low} to {high}")]
    IndexOutside {
        /// The family, or `entry`.
        name: String,
        /// The index.
        index: i64,
        /// The smallest index.
        low: i64,
        /// The largest index.
        high: i64,
    },
    /// A basis below the degree of its seeds.
    #[error("degree {degree} of `{name}`, whose seeds have degree {least}")]
    BelowSeeds {
        /// The family.
        name: String,
        /// The requested degree.
        degree: i64,
        /// The degree of the seeds.
        least: u8,
    },
    /// A derivative that does not exist: of a root at zero, or of a function of integers.
    #[error("a derivative where there is none")]
    NotDifferentiable,
    /// The terms of a hypothesis, or those of `p implies q` where p is false or undefined: no assertion is made there.
    #[error("a hypothesis or a premise is not satisfied")]
    Unasserted,
    /// Coefficients of a form that is not linear in the unknowns.
    #[error("coefficients of a form that is not linear")]
    NotLinear,
}

/// Why a value is not known.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Unknown {
    /// The enclosure of a number is too wide to determine its sign, or whether it is an integer.
    #[error("an enclosure is too wide")]
    Precision,
    /// The budget of work is spent.
    #[error("it takes too much work")]
    Work,
    /// A number, power, sum or degree is too large, or a term is nested too deeply.
    #[error("{what} is too large")]
    Large {
        /// What.
        what: &'static str,
    },
    /// Vectors or matrices whose shapes do not match.
    #[error("{what} does not fit")]
    Shape {
        /// What.
        what: &'static str,
    },
    /// An operation that this arithmetic does not support.
    #[error("{what} is not covered")]
    NotCovered {
        /// What.
        what: &'static str,
    },
    /// The infinitesimal of a derivative occurs outside of it, which is a fault of this evaluator.
    #[error("the infinitesimals of two derivatives were confused")]
    Confused,
    /// A symbol without a value at the point.
    #[error("`{name}` has no value")]
    NoValue {
        /// Its name.
        name: String,
    },
}

impl fmt::Display for NoValue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Undefined(why) => write!(f, "undefined: {why}"),
            Self::Unknown(why) => write!(f, "not known: {why}"),
        }
    }
}

impl From<Undefined> for NoValue {
    fn from(why: Undefined) -> Self {
        Self::Undefined(why)
    }
}

impl From<Unknown> for NoValue {
    fn from(why: Unknown) -> Self {
        Self::Unknown(why)
    }
}

impl NoValue {
    /// The error for operands whose shapes do not match.
    #[must_use]
    pub fn shape(what: &'static str) -> Self {
        Unknown::Shape { what }.into()
    }
}

/// A budget of work, counted in operations on numbers, so it is the same on every machine.
///
/// ```
/// use torse_semantics::Work;
/// let work = Work::new(2);
/// assert!(work.spend(2).is_ok());
/// assert!(work.spend(1).is_err());
/// assert_eq!(work.left(), 0);
/// ```
#[derive(Debug)]
pub struct Work {
    left: Cell<u64>,
}

impl Work {
    /// A budget of this many operations.
    #[must_use]
    pub fn new(operations: u64) -> Self {
        Self {
            left: Cell::new(operations),
        }
    }

    /// Spends this many operations.
    ///
    /// # Errors
    /// [`Unknown::Work`] once the budget is spent.
    pub fn spend(&self, operations: u64) -> Result<(), Unknown> {
        match self.left.get().checked_sub(operations) {
            Some(left) => {
                self.left.set(left);
                Ok(())
            }
            None => {
                self.left.set(0);
                Err(Unknown::Work)
            }
        }
    }

    /// The remaining operations.
    #[must_use]
    pub fn left(&self) -> u64 {
        self.left.get()
    }
}
