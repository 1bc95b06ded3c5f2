//! Sums over the least common multiple of the denominators' factors.

use super::{Fraction, merged};
use crate::polynomial::Polynomial;
use std::collections::BTreeMap;
use std::ops::{Add, Neg, Sub};

fn sum(a: &Fraction, b: &Fraction) -> Fraction {
    let conditions = merged(&a.conditions, &b.conditions);
    if a.denominator == b.denominator {
        let numerator = &a.numerator + &b.numerator;
        let result = Fraction {
            numerator,
            denominator: a.denominator.clone(),
            conditions,
        };
        return if result.denominator.is_empty() {
            result
        } else {
            result.cancelled()
        };
    }
    let mut denominator = a.denominator.clone();
    for (factor, exponent) in &b.denominator {
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
    let numerator =
        &(&a.numerator * &missing(&a.denominator)) + &(&b.numerator * &missing(&b.denominator));
    Fraction {
        numerator,
        denominator,
        conditions,
    }
    .cancelled()
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

/// Equality of values where both are defined; conditions do not count.
impl PartialEq for Fraction {
    fn eq(&self, other: &Self) -> bool {
        if self.denominator == other.denominator {
            return self.numerator == other.numerator;
        }
        (self.clone() - other.clone()).is_zero()
    }
}
