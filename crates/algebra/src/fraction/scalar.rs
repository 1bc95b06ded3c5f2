//! Fractions as [`Scalar`]s: generic code over scalars also computes formulas.

use super::Fraction;
use crate::rational::Rational;
use crate::scalar::{ExactError, Scalar, ZeroTest};
use crate::symbol::Symbol;

impl Scalar for Fraction {
    fn constant(&self, q: &Rational) -> Self {
        q.clone().into()
    }

    fn divided_by(&self, divisor: &Self) -> Result<Self, ExactError> {
        self.over(divisor)
    }

    fn quarter_turn(&self) -> Result<(Self, Self), ExactError> {
        let polynomial = self
            .as_polynomial()
            .ok_or_else(|| ExactError::NoExactTurn {
                argument: self.to_string(),
            })?;
        let (sine, cosine) = Scalar::quarter_turn(polynomial)?;
        Ok((sine.into(), cosine.into()))
    }

    fn pi_like(&self) -> Result<Self, ExactError> {
        Ok(Self::symbol(Symbol::Pi))
    }

    fn scaled(&self, q: &Rational) -> Self {
        let mut result = self.clone();
        result.numerator = result.numerator.scaled(q);
        if result.is_zero() {
            result.denominator.clear();
        }
        result
    }
}

impl ZeroTest for Fraction {
    fn is_known_zero(&self) -> bool {
        self.is_zero()
    }

    fn is_known_nonzero(&self) -> bool {
        !self.is_zero()
    }
}

impl Fraction {
    /// `(sin(self), cos(self))` with `self` in radians; see [`Polynomial::sine_cosine`](crate::Polynomial::sine_cosine).
    ///
    /// # Errors
    /// [`ExactError::NoExactTurn`] when the pair is not a pair of polynomials.
    pub fn sine_cosine(&self) -> Result<(Self, Self), ExactError> {
        let polynomial = self
            .as_polynomial()
            .ok_or_else(|| ExactError::NoExactTurn {
                argument: self.to_string(),
            })?;
        let (sine, cosine) = polynomial.sine_cosine()?;
        Ok((sine.into(), cosine.into()))
    }

    /// The exponential; see [`Polynomial::exponential`](crate::Polynomial::exponential).
    ///
    /// # Errors
    /// [`ExactError::NoExponential`] when the exponential is not a quotient of polynomials.
    pub fn exponential(&self) -> Result<Self, ExactError> {
        let polynomial = self
            .as_polynomial()
            .ok_or_else(|| ExactError::NoExponential {
                argument: self.to_string(),
            })?;
        polynomial.exponential()
    }
}
