//! Derivatives.

use super::Fraction;
use crate::polynomial::Polynomial;

impl Fraction {
    /// The derivative by the variable `name`.
    #[must_use]
    pub fn derivative(&self, name: &str) -> Self {
        // (n / prod f^e)' = n' / prod f^e - sum e n f' / (f prod f^e)
        let part = |numerator: Polynomial, denominator| Self {
            numerator,
            denominator,
            conditions: self.conditions.clone(),
        };
        let mut total = part(self.numerator.derivative(name), self.denominator.clone()).cancelled();
        for (factor, exponent) in &self.denominator {
            let rate = factor.derivative(name);
            if rate.is_zero() {
                continue;
            }
            let mut denominator = self.denominator.clone();
            *denominator.entry(factor.clone()).or_insert(0) += 1;
            let numerator =
                (&self.numerator * &rate).scaled(&crate::rational::integer(i64::from(*exponent)));
            total = total - part(numerator, denominator).cancelled();
        }
        total
    }
}
