//! Products and powers.

use super::{Fraction, merged};
use crate::power::power;
use crate::scalar::ExactError;
use std::ops::Mul;

impl Mul for &Fraction {
    type Output = Fraction;
    fn mul(self, other: Self) -> Fraction {
        let numerator = &self.numerator * &other.numerator;
        let conditions = merged(&self.conditions, &other.conditions);
        // A nonzero number adds no factor that could cancel.
        let brings_nothing = |factor: &Fraction| {
            factor.denominator.is_empty() && factor.numerator.is_constant() && !factor.is_zero()
        };
        if brings_nothing(other) {
            return Fraction {
                numerator,
                denominator: self.denominator.clone(),
                conditions,
            };
        }
        if brings_nothing(self) {
            return Fraction {
                numerator,
                denominator: other.denominator.clone(),
                conditions,
            };
        }
        let mut denominator = self.denominator.clone();
        for (factor, exponent) in &other.denominator {
            *denominator.entry(factor.clone()).or_insert(0) += exponent;
        }
        let result = Fraction {
            numerator,
            denominator,
            conditions,
        };
        if result.denominator.is_empty() {
            result
        } else {
            result.cancelled()
        }
    }
}

impl Mul for Fraction {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        &self * &other
    }
}

impl Fraction {
    /// `self` to an integer power.
    ///
    /// # Errors
    /// [`ExactError::DivisionByZero`] for a negative power of zero.
    pub fn power(&self, exponent: i32) -> Result<Self, ExactError> {
        let result = power(self, exponent.unsigned_abs(), Self::integer(1), |a, b| {
            a * b
        });
        if exponent < 0 {
            Self::integer(1).over(&result)
        } else {
            Ok(result)
        }
    }
}
