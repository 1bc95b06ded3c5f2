//! Why a proof is not accepted: it is wrong, or the checker does not reach so far.

use std::cell::Cell;
use torse_certificate::polynomial::Polynomial;
use torse_certificate::wronskian::Unfit;

/// What the checker says of a proof that it does not accept.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum CheckError {
    /// The checker cannot follow it; nothing is said against the proof.
    #[error("out of the checker's reach: {0}")]
    Unsupported(Unsupported),
    /// It proves nothing.
    #[error("the proof is wrong: {0}")]
    Wrong(Wrong),
}

/// What the checker cannot follow.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Unsupported {
    /// An index, a degree or the bound of a sum is no fixed integer.
    #[error("{0} of symbolic size")]
    Symbolic(&'static str),
    /// A construct of the language, or a kind of proof.
    #[error("{0}")]
    Construct(&'static str),
    /// The expansion is too long.
    #[error("the expansion has too many terms")]
    Large,
    /// A term has no value anywhere, or none at the point.
    #[error("{0} has no value")]
    Undefined(&'static str),
    /// A symbol has no value at a point.
    #[error("the point has no value for {0}")]
    NoValue(String),
    /// The sign of a number is not told by enclosures.
    #[error("two numbers are too near to each other")]
    Near,
    /// A divisor of an elimination is known not to vanish by reasons that the proof does not carry.
    #[error("that {0} does not vanish was seen before the elimination")]
    Divisor(String),
}

/// What is wrong with a proof.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Wrong {
    /// The proof is of another kind than the statement.
    #[error("the proof is of another kind than the statement")]
    Kind,
    /// The sides differ.
    #[error("the difference of the sides, multiplied out, has {0} terms")]
    Differs(usize),
    /// What a combination calls an equation is none of the hypotheses.
    #[error("an equation of the combination is no hypothesis")]
    NoEquation,
    /// No equation of the hypotheses gives a symbol its value.
    #[error("no equation gives {0} its value")]
    Eliminated(String),
    /// A divisor may vanish.
    #[error("nothing says that {0} does not vanish")]
    Divisor(String),
    /// What is used as a constraint is none of the hypotheses.
    #[error("{0} is no hypothesis")]
    Constraint(String),
    /// The parts of a certificate do not make up its polynomial.
    #[error("the parts of a certificate do not make up its polynomial")]
    Equation,
    /// A part of a certificate may be negative.
    #[error("a part of a certificate may be negative")]
    Negative,
    /// A coordinate does not enclose the range of its symbol.
    #[error("{0} leaves its coordinate")]
    Coordinate(String),
    /// The pieces do not fill the box.
    #[error("the {0} pieces do not fill the box")]
    NotFilled(usize),
    /// A coefficient has the wrong sign.
    #[error("a coefficient on piece {0} has the wrong sign")]
    Coefficient(usize),
    /// Zero is not excluded where it has to be.
    #[error("zero is not excluded")]
    Zero,
    /// The signs are not those of the difference.
    #[error("the signs are not those of the difference")]
    Sign,
    /// A printed number does not agree as it is said to.
    #[error("printed number {0} does not agree so")]
    Printed(usize),
    /// A counterexample is no point of the domain.
    #[error("the point is outside of the domain")]
    Outside,
    /// The statement is not false at a counterexample.
    #[error("the statement is not false at the point")]
    Stands,
    /// The sides are not what the counterexample says.
    #[error("the sides have other values at the point")]
    Sides,
    /// Total positivity is not shown.
    #[error("total positivity is not shown: {0}")]
    Wronskians(Unfit),
    /// The instances are not all there are.
    #[error("an instance is missing")]
    Instances,
}

impl From<Unsupported> for CheckError {
    fn from(beyond: Unsupported) -> Self {
        Self::Unsupported(beyond)
    }
}

impl From<Wrong> for CheckError {
    fn from(wrong: Wrong) -> Self {
        Self::Wrong(wrong)
    }
}

/// Products of terms that may still be formed: work is counted, not time.
#[derive(Debug)]
pub struct Work(Cell<u64>);

impl Work {
    /// So many.
    #[must_use]
    pub fn new(products: u64) -> Self {
        Self(Cell::new(products))
    }

    /// Spends some.
    pub(crate) fn spend(&self, products: usize) -> Result<(), Unsupported> {
        let products = u64::try_from(products).unwrap_or(u64::MAX);
        let left = self
            .0
            .get()
            .checked_sub(products)
            .ok_or(Unsupported::Large)?;
        self.0.set(left);
        Ok(())
    }

    /// The product of two polynomials.
    pub(crate) fn times(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Unsupported> {
        self.spend(a.len().saturating_mul(b.len()))?;
        Ok(a.times(b))
    }
}
