//! Why a proof is not accepted: it is wrong, or it uses something that the checker does not support.

use std::cell::Cell;
use torse_certificate::line::Uncut;
use torse_certificate::polynomial::Polynomial;
use torse_certificate::wronskian::Unfit;

/// The result of checking a proof that is not accepted.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum CheckError {
    /// The checker does not support something in the proof, which may nevertheless be right.
    #[error("out of the checker's reach: {0}")]
    Unsupported(Unsupported),
    /// The proof is wrong.
    #[error("the proof is wrong: {0}")]
    Wrong(Wrong),
}

/// What the checker does not support.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Unsupported {
    /// An index, a degree or the bound of a sum that is not an integer constant.
    #[error("{0} of symbolic size")]
    Symbolic(&'static str),
    /// A construct of the language, or a kind of proof.
    #[error("{0}")]
    Construct(&'static str),
    /// The expansion is too large.
    #[error("the expansion has too many terms")]
    Large,
    /// A term is undefined, everywhere or at the point.
    #[error("{0} has no value")]
    Undefined(&'static str),
    /// A symbol has no value at a point.
    #[error("the point has no value for {0}")]
    NoValue(String),
    /// The enclosures are too wide to determine the sign of a constant.
    #[error("two numbers are too close to each other")]
    Near,
    /// A divisor of an elimination is nonzero for reasons that the proof does not contain.
    #[error("that {0} is nonzero is known only from before the elimination")]
    Divisor(String),
}

impl Unsupported {
    /// An angle of which no sine is known.
    pub(crate) const ANGLE: Self = Self::Construct("the sine of this angle");
}

/// What is wrong with a proof.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Wrong {
    /// The kind of the proof does not match the statement.
    #[error("the proof is of another kind than the statement")]
    Kind,
    /// The sides differ.
    #[error("the difference of the sides, expanded, has {0} terms")]
    Differs(usize),
    /// An equation of a combination is not among the hypotheses.
    #[error("an equation of the combination is not a hypothesis")]
    NoEquation,
    /// No hypothesis determines the value of an eliminated symbol.
    #[error("no equation gives {0} its value")]
    Eliminated(String),
    /// A divisor may vanish.
    #[error("{0} is not known to be nonzero")]
    Divisor(String),
    /// A constraint is not among the hypotheses.
    #[error("{0} is not a hypothesis")]
    Constraint(String),
    /// The parts of a certificate do not add up to its polynomial.
    #[error("the parts of a certificate do not make up its polynomial")]
    Equation,
    /// A part of a certificate may be negative.
    #[error("a part of a certificate may be negative")]
    Negative,
    /// A coordinate does not enclose the range of its symbol.
    #[error("the coordinate of {0} does not enclose its range")]
    Coordinate(String),
    /// The pieces do not fill the box.
    #[error("the {0} pieces do not fill the box")]
    NotFilled(usize),
    /// A coefficient has the wrong sign.
    #[error("a coefficient on piece {0} has the wrong sign")]
    Coefficient(usize),
    /// Zero is not excluded where it must be.
    #[error("zero is not excluded")]
    Zero,
    /// The signs are not those of the difference.
    #[error("the signs are not those of the difference")]
    Sign,
    /// A printed number does not agree in the stated way.
    #[error("printed number {0} does not agree in the stated way")]
    Printed(usize),
    /// A counterexample is not a point of the domain.
    #[error("the point is outside of the domain")]
    Outside,
    /// The statement is not false at a counterexample.
    #[error("the statement is not false at the point")]
    Stands,
    /// The sides do not have the values that the counterexample states.
    #[error("the sides have other values at the point")]
    Sides,
    /// Total positivity was not shown.
    #[error("total positivity is not shown: {0}")]
    Wronskians(Unfit),
    /// The line is not cut as a sign on it needs it.
    #[error("{0}")]
    Line(Uncut),
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

/// A budget of products of terms; work is counted, not timed.
#[derive(Debug)]
pub struct Work {
    products: Cell<u64>,
    /// Whether a cosine was met of which no more is known than that it is one: then a difference of texts may be none of values.
    unknown_turn: Cell<bool>,
}

impl Work {
    /// A budget of this many products.
    #[must_use]
    pub fn new(products: u64) -> Self {
        Self {
            products: Cell::new(products),
            unknown_turn: Cell::new(false),
        }
    }

    /// Records a sine or cosine of a number that is a symbol.
    pub(crate) fn meet_unknown_turn(&self) {
        self.unknown_turn.set(true);
    }

    /// The result of a check: what was seen to be wrong with such a symbol in it may be right.
    pub(crate) fn judged(&self, checked: Result<(), CheckError>) -> Result<(), CheckError> {
        match checked {
            Err(CheckError::Wrong(_)) if self.unknown_turn.get() => Err(Unsupported::ANGLE.into()),
            other => other,
        }
    }

    /// Spends this many products.
    pub(crate) fn spend(&self, products: usize) -> Result<(), Unsupported> {
        let products = u64::try_from(products).unwrap_or(u64::MAX);
        let left = self
            .products
            .get()
            .checked_sub(products)
            .ok_or(Unsupported::Large)?;
        self.products.set(left);
        Ok(())
    }

    /// The product of two polynomials.
    pub(crate) fn times(&self, a: &Polynomial, b: &Polynomial) -> Result<Polynomial, Unsupported> {
        self.spend(a.len().saturating_mul(b.len()))?;
        Ok(a.times(b))
    }
}
