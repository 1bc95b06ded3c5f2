//! Division and cancellation; both keep every divisor as a condition.

use super::{Fraction, merged};
use crate::polynomial::Polynomial;
use crate::rational::Rational;
use crate::scalar::ExactError;
use std::collections::BTreeMap;

impl Fraction {
    /// `self / divisor`, recording the divisor.
    ///
    /// # Errors
    /// [`ExactError::DivisionByZero`] when the divisor is the zero function.
    ///
    /// ```
    /// use torse_algebra::Fraction;
    /// let (x, y) = (Fraction::named("x"), Fraction::named("y"));
    /// let quotient = (x.clone() * y.clone()).over(&y).unwrap();
    /// assert_eq!(quotient.to_string(), "x");
    /// assert_eq!(quotient.conditions()[0].to_string(), "y"); // cancelled, but recorded
    /// ```
    pub fn over(&self, divisor: &Self) -> Result<Self, ExactError> {
        Ok(self.clone().divided(divisor, 1)?.cancelled())
    }

    /// `self / divisor^exponent`, not yet cancelled; records the divisor.
    pub(super) fn divided(mut self, divisor: &Self, exponent: u32) -> Result<Self, ExactError> {
        if divisor.is_zero() {
            return Err(ExactError::DivisionByZero {
                divisor: divisor.to_string(),
            });
        }
        self.conditions = merged(&self.conditions, &divisor.conditions);
        self.numerator = &self.numerator * &divisor.denominator().power(exponent);
        let (content, factors) = self.factors_of(&divisor.numerator);
        let content = num_traits::pow(content.recip(), exponent as usize);
        self.numerator = self.numerator.scaled(&content);
        for (factor, times) in factors {
            if !factor.is_exponential() {
                self.conditions = merged(&self.conditions, std::slice::from_ref(&factor));
            }
            *self.denominator.entry(factor).or_insert(0) += times * exponent;
        }
        Ok(self)
    }

    /// Splits a nonzero polynomial into its content and primitive factors. Single symbols and the factors of this
    /// fraction's denominator are split off; the remainder is not factored.
    fn factors_of(&self, p: &Polynomial) -> (Rational, BTreeMap<Polynomial, u32>) {
        let (content, mut rest) = p.primitive();
        let mut factors = BTreeMap::new();
        let symbols = rest.symbols().to_vec();
        let known = symbols
            .into_iter()
            .map(Polynomial::symbol)
            .chain(self.denominator.keys().cloned());
        for candidate in known.collect::<Vec<_>>() {
            while !rest.is_constant()
                && let Some(quotient) = rest.exact_quotient(&candidate)
            {
                *factors.entry(candidate.clone()).or_insert(0) += 1;
                rest = quotient;
            }
        }
        // The remaining content is a rational number, so it belongs to the content of the whole.
        let (more, rest) = rest.primitive();
        if !rest.is_constant() {
            *factors.entry(rest).or_insert(0) += 1;
        }
        (content * more, factors)
    }

    /// Cancels powers of denominator factors that divide the numerator.
    pub(super) fn cancelled(mut self) -> Self {
        if self.numerator.is_zero() {
            self.denominator.clear();
            return self;
        }
        let mut reduced = BTreeMap::new();
        let mut pending: Vec<(Polynomial, u32)> =
            std::mem::take(&mut self.denominator).into_iter().collect();
        while let Some((factor, mut exponent)) = pending.pop() {
            while exponent > 0
                && let Some(quotient) = self.numerator.exact_quotient(&factor)
            {
                self.numerator = quotient;
                exponent -= 1;
            }
            if exponent == 0 {
                continue;
            }
            if factor.is_linear_somewhere() {
                *reduced.entry(factor).or_insert(0) += exponent;
                continue;
            }
            let common = factor.gcd(&self.numerator);
            match factor.exact_quotient(&common) {
                Some(rest) if !common.is_constant() && !rest.is_constant() => {
                    pending.push((common, exponent));
                    pending.push((rest.primitive().1, exponent));
                    let content = rest.primitive().0;
                    self.numerator = self
                        .numerator
                        .scaled(&num_traits::pow(content.recip(), exponent as usize));
                }
                _ => *reduced.entry(factor).or_insert(0) += exponent,
            }
        }
        self.denominator = reduced;
        self
    }
}
