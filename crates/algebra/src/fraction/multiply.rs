//! Products and powers.

use super::{Fraction, merged};
use crate::scalar::ExactError;
use std::ops::Mul;

impl Mul for Fraction {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let mut denominator = self.denominator;
        for (factor, exponent) in other.denominator {
            *denominator.entry(factor).or_insert(0) += exponent;
        }
        let conditions = merged(&self.conditions, &other.conditions);
        let result = Self {
            numerator: &self.numerator * &other.numerator,
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

impl Fraction {
    /// `self` to an integer power.
    ///
    /// # Errors
    /// [`ExactError::DivisionByZero`] for a negative power of zero.
    pub fn power(&self, exponent: i32) -> Result<Self, ExactError> {
        let mut result = Self::integer(1);
        let (mut base, mut rest) = (self.clone(), exponent.unsigned_abs());
        while rest > 0 {
            if rest % 2 == 1 {
                result = result * base.clone();
            }
            rest /= 2;
            if rest > 0 {
                base = base.clone() * base;
            }
        }
        if exponent < 0 {
            Self::integer(1).over(&result)
        } else {
            Ok(result)
        }
    }
}
