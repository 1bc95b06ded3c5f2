//! The numbers a term is evaluated in.
//!
//! The evaluator is written once over [`Arithmetic`] and runs on real numbers that are exact where they can be and
//! enclosed where they cannot ([`Reals`](crate::Reals)), and on quotients of polynomials
//! ([`Polynomials`](crate::Polynomials)), which turn a statement at fixed small degrees into an identity.

use crate::no_value::{NoValue, Work};
use std::fmt::Debug;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// How two numbers compare.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Comparison {
    /// They are the same.
    Equal,
    /// The first is less.
    Less,
    /// The first is greater.
    Greater,
    /// They are different; an order is not known, or there is none.
    Apart,
    /// They agree to so many digits that they count as equal, but no proof says so.
    Near,
    /// Not known.
    Open,
}

/// Arithmetic with numbers of one kind.
///
/// Every operation returns the value of the mathematical operation, or says that it is undefined, or that it is not
/// known; it spends work.
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

    /// The circle number.
    fn pi(&self) -> Self::Number;

    /// `a + b`.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] for too much work.
    fn plus(&self, a: &Self::Number, b: &Self::Number) -> Result<Self::Number, NoValue>;

    /// `-a`.
    fn negated(&self, a: &Self::Number) -> Self::Number;

    /// `a * b`.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] for too much work or numbers that grow too large.
    fn times(&self, a: &Self::Number, b: &Self::Number) -> Result<Self::Number, NoValue>;

    /// `a / b`.
    ///
    /// # Errors
    /// [`NoValue::Undefined`] if b is zero, [`NoValue::Unknown`] if that is not known.
    fn over(&self, a: &Self::Number, b: &Self::Number) -> Result<Self::Number, NoValue>;

    /// The root that is not negative.
    ///
    /// # Errors
    /// [`NoValue::Undefined`] for negative numbers, [`NoValue::Unknown`] if the sign is not known.
    fn square_root(&self, a: &Self::Number) -> Result<Self::Number, NoValue>;

    /// `(sin a, cos a)` of an angle in radians.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] where they cannot be expressed.
    fn sine_cosine(&self, a: &Self::Number) -> Result<(Self::Number, Self::Number), NoValue>;

    /// The exponential of a.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] where it cannot be expressed.
    fn exponential(&self, a: &Self::Number) -> Result<Self::Number, NoValue>;

    /// Whether the number is zero; `None` if that is not known.
    fn is_zero(&self, a: &Self::Number) -> Option<bool>;

    /// The number, if it is known to be this rational one.
    fn as_rational(&self, a: &Self::Number) -> Option<Rational>;

    /// A bound of the size of the number as a power of two, if it has a size.
    fn bit_length(&self, a: &Self::Number) -> Option<u64>;

    /// How a compares with b; where numbers satisfy their equations only nearly, those that differ by little count as open.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] for too much work.
    fn compare(
        &self,
        a: &Self::Number,
        b: &Self::Number,
        _near: bool,
    ) -> Result<Comparison, NoValue> {
        let gap = self.minus(a, b)?;
        Ok(match self.is_zero(&gap) {
            Some(true) => Comparison::Equal,
            Some(false) => Comparison::Apart,
            None => Comparison::Open,
        })
    }

    /// Some number between two, of which nothing else is known; `None` for arithmetics that know no order.
    fn between(&self, _low: &Rational, _high: &Rational) -> Option<Self::Number> {
        None
    }

    /// Shares of the way between the ends of an integral, and how much the integrand counts there, where such a sum stands for
    /// the integral: none but where two readings of one text are compared.
    fn stands_for_integral(&self) -> Option<[(Rational, Rational); 2]> {
        None
    }

    /// Whether it makes no difference to what is told of numbers if this one is added.
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
