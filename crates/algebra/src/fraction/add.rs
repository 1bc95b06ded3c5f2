//! Sums over the least common multiple of the denominators' factors.

use super::{Fraction, merged};
use crate::polynomial::Polynomial;
use std::collections::BTreeMap;
use std::ops::{Add, Neg, Sub};

fn sum(a: &Fraction, b: &Fraction) -> Fraction {
    a.sum_uncancelled(b).cancelled()
}

impl Fraction {
    /// The sum over the least common multiple of the denominators, not yet cancelled.
    pub(super) fn sum_uncancelled(&self, other: &Self) -> Self {
        let conditions = merged(&self.conditions, &other.conditions);
        if self.denominator == other.denominator {
            return Self {
                numerator: &self.numerator + &other.numerator,
                denominator: self.denominator.clone(),
                conditions,
            };
        }
        let mut denominator = self.denominator.clone();
        for (factor, exponent) in &other.denominator {
            let entry = denominator.entry(factor.clone()).or_insert(0);
            *entry = (*entry).max(*exponent);
        }
        let missing = |own: &BTreeMap<Polynomial, u32>| {
            denominator
                .iter()
                .fold(Polynomial::integer(1), |p, (factor, exponent)| {
                    &p * &factor.power(exponent - own.get(factor).copied().unwrap_or(0))
                })
        };
        let lifted = |fraction: &Self| &fraction.numerator * &missing(&fraction.denominator);
        Self {
            numerator: &lifted(self) + &lifted(other),
            denominator,
            conditions,
        }
    }
}

impl Add for Fraction {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        sum(&self, &other)
    }
}

impl Add for &Fraction {
    type Output = Fraction;
    fn add(self, other: Self) -> Fraction {
        sum(self, other)
    }
}

impl Neg for Fraction {
    type Output = Self;
    fn neg(mut self) -> Self {
        self.numerator = -self.numerator;
        self
    }
}

impl Sub for Fraction {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        sum(&self, &-other)
    }
}

/// Compares values where both are defined; conditions are ignored.
impl PartialEq for Fraction {
    fn eq(&self, other: &Self) -> bool {
        if self.denominator == other.denominator {
            return self.numerator == other.numerator;
        }
        (self.clone() - other.clone()).is_zero()
    }
}
