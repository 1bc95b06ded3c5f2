//! The numbers a term is evaluated in.
//!
//! The evaluator is generic over [`Arithmetic`]. It runs on real numbers that are exact where possible and enclosed
//! elsewhere ([`Reals`](crate::Reals)), on quotients of polynomials ([`Polynomials`](crate::Polynomials)), for which a
//! statement at fixed small degrees is an identity, on real numbers with their gradients, and on residues modulo a
//! prime.

use crate::no_value::{NoValue, Work};
use std::fmt::Debug;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// The result of comparing two numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Comparison {
    /// They are equal.
    Equal,
    /// The first is less.
    Less,
    /// The first is greater.
    Greater,
    /// They are different; the order is not known, or does not exist.
    Apart,
    /// They agree to so many digits that they count as equal, but this is not proved.
    Near,
    /// Not known.
    Open,
}

/// Arithmetic with numbers of one kind.
///
/// Every operation spends work, and returns the exact value of the mathematical operation (an enclosure of it for
/// balls), or an error that says that it is undefined or unknown.
pub trait Arithmetic {
    /// A number.
    type Number: Clone + Debug + PartialEq;

    /// The budget of the work.
    fn work(&self) -> &Work;

    /// A rational number.
    fn rational(&self, value: &Rational) -> Self::Number;

    /// An integer.
    fn integer(&self, n: i64) -> Self::Number {
        self.rational(&integer(n))
    }

    /// The number pi.
    fn pi(&self) -> Self::Number;

    /// `a + b`.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] if the budget of work is spent.
    fn plus(&self, a: &Self::Number, b: &Self::Number) -> Result<Self::Number, NoValue>;

    /// `-a`.
    fn negated(&self, a: &Self::Number) -> Self::Number;

    /// `a * b`.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] if the budget of work is spent or the result is too large.
    fn times(&self, a: &Self::Number, b: &Self::Number) -> Result<Self::Number, NoValue>;

    /// `a / b`.
    ///
    /// # Errors
    /// [`NoValue::Undefined`] if b is zero, [`NoValue::Unknown`] if it is not known whether b is zero.
    fn over(&self, a: &Self::Number, b: &Self::Number) -> Result<Self::Number, NoValue>;

    /// The nonnegative square root.
    ///
    /// # Errors
    /// [`NoValue::Undefined`] for negative numbers, [`NoValue::Unknown`] if the sign is not known.
    fn square_root(&self, a: &Self::Number) -> Result<Self::Number, NoValue>;

    /// `(sin a, cos a)` of an angle in radians.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] if the result cannot be expressed.
    fn sine_cosine(&self, a: &Self::Number) -> Result<(Self::Number, Self::Number), NoValue>;

    /// The exponential of a.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] if the result cannot be expressed.
    fn exponential(&self, a: &Self::Number) -> Result<Self::Number, NoValue>;

    /// The natural logarithm of a.
    ///
    /// # Errors
    /// [`NoValue::Undefined`] for numbers that are not positive, [`NoValue::Unknown`] if the sign is not known or the
    /// result cannot be expressed.
    fn logarithm(&self, a: &Self::Number) -> Result<Self::Number, NoValue>;

    /// The arc tangent of a, between -pi/2 and pi/2.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] if the result cannot be expressed.
    fn arctangent(&self, a: &Self::Number) -> Result<Self::Number, NoValue>;

    /// The arc sine of a, from -pi/2 to pi/2.
    ///
    /// # Errors
    /// [`NoValue::Undefined`] for numbers above 1 or below -1, [`NoValue::Unknown`] if that is not known or the result cannot be
    /// expressed.
    fn arcsine(&self, a: &Self::Number) -> Result<Self::Number, NoValue>;

    /// The greater one of two numbers. Arithmetics without an order have it as `(a + b + sqrt((a - b)^2))/2`.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] if the result cannot be expressed.
    fn greater(&self, a: &Self::Number, b: &Self::Number) -> Result<Self::Number, NoValue> {
        let gap = self.minus(a, b)?;
        let size = self.square_root(&self.times(&gap, &gap)?)?;
        let twice = self.plus(&self.plus(a, b)?, &size)?;
        self.over(&twice, &self.integer(2))
    }

    /// Whether the numbers are those of a point that satisfies the hypotheses only approximately.
    fn is_beside_domain(&self) -> bool {
        false
    }

    /// Whether the number is zero; `None` if that is not known.
    fn is_zero(&self, a: &Self::Number) -> Option<bool>;

    /// The rational value, if the number is known to be rational.
    fn as_rational(&self, a: &Self::Number) -> Option<Rational>;

    /// A bound of the absolute value as a power of two, if the numbers have absolute values.
    fn bit_length(&self, a: &Self::Number) -> Option<u64>;

    /// Compares two numbers.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] if the budget of work is spent.
    fn compare(&self, a: &Self::Number, b: &Self::Number) -> Result<Comparison, NoValue> {
        let gap = self.minus(a, b)?;
        Ok(match self.is_zero(&gap) {
            Some(true) => Comparison::Equal,
            Some(false) => Comparison::Apart,
            None => Comparison::Open,
        })
    }

    /// A number of which nothing is known but that it lies between two bounds; `None` for arithmetics without an
    /// order.
    fn between(&self, _low: &Rational, _high: &Rational) -> Option<Self::Number> {
        None
    }

    /// Nodes (as fractions of the interval of integration) and weights of a sum that replaces integrals. Only the
    /// arithmetic that compares two readings of a text has one; for it any functional of the integrand will do.
    fn stands_for_integral(&self) -> Option<[(Rational, Rational); 2]> {
        None
    }

    /// Whether adding this number changes no comparison.
    fn is_negligible(&self, a: &Self::Number) -> bool {
        self.is_zero(a) == Some(true)
    }

    /// `a - b`.
    ///
    /// # Errors
    /// As [`Arithmetic::plus`].
    fn minus(&self, a: &Self::Number, b: &Self::Number) -> Result<Self::Number, NoValue> {
        self.plus(a, &self.negated(b))
    }
}
