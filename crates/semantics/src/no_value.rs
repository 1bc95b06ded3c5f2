//! Why a term has no value at a point, or none that is known.

use std::cell::Cell;
use std::fmt;

/// Why there is no value.
///
/// The two kinds are never mixed: [`NoValue::Undefined`] is a fact about the term at this point, [`NoValue::Unknown`] one
/// about this evaluator.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NoValue {
    /// The term is undefined at this point: the point says nothing about a statement with this term.
    Undefined(Undefined),
    /// Whether the term has a value, or which, was not found out.
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
    /// An index, degree, order or exponent that is no integer.
    #[error("{what} that is no integer")]
    NoInteger {
        /// What should be one.
        what: &'static str,
    },
    /// A negative order of a derivative or argument of a factorial.
    #[error("{what} that is negative")]
    Negative {
        /// What should not be.
        what: &'static str,
    },
    /// An index of a family of points, or of an entry, outside its range.
    #[error("the index {index} of `{name}` is outside {low} to {high}")]
    IndexOutside {
        /// The family, or `entry`.
        name: String,
        /// The index.
        index: i64,
        /// The least index.
        low: i64,
        /// The greatest one.
        high: i64,
    },
    /// A basis below the degree of its seeds.
    #[error("degree {degree} of `{name}`, whose seeds have degree {least}")]
    BelowSeeds {
        /// The family.
        name: String,
        /// The degree asked for.
        degree: i64,
        /// That of the seeds.
        least: u8,
    },
    /// A derivative where there is none: of a root at zero, of what is defined at integers only.
    #[error("a derivative where there is none")]
    NotDifferentiable,
    /// Coefficients of a form that is not linear in the unknowns.
    #[error("coefficients of a form that is not linear")]
    NotLinear,
}

/// Why a value is not known.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Unknown {
    /// The enclosure of a number is too wide to say whether it is zero, positive or an integer.
    #[error("an enclosure is too wide")]
    Precision,
    /// The budget of work is spent.
    #[error("it takes too much work")]
    Work,
    /// A number, power, sum or degree is too large, or a term too deep.
    #[error("{what} is too large")]
    Large {
        /// What.
        what: &'static str,
    },
    /// Vectors and matrices that do not fit.
    #[error("{what} does not fit")]
    Shape {
        /// What.
        what: &'static str,
    },
    /// Something this arithmetic cannot express.
    #[error("{what} is not covered")]
    NotCovered {
        /// What.
        what: &'static str,
    },
    /// The infinitesimal of a derivative was met outside of it: a fault of this evaluator.
    #[error("the infinitesimals of two derivatives were confused")]
    Confused,
    /// A symbol that has no value at the point.
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
    /// Operands whose shapes do not fit.
    #[must_use]
    pub fn shape(what: &'static str) -> Self {
        Unknown::Shape { what }.into()
    }
}

/// A budget of work, in operations on numbers. It is the same on every machine.
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
    /// A budget of so many operations.
    #[must_use]
    pub fn new(operations: u64) -> Self {
        Self {
            left: Cell::new(operations),
        }
    }

    /// Takes so many operations.
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

    /// What is left of the budget.
    #[must_use]
    pub fn left(&self) -> u64 {
        self.left.get()
    }
}
