//! Signs by partial sums: each sum has to be one that bounds its function on the domain, and the gaps with their coefficients make
//! the polynomial.

use super::gap::{CheckError, Unsupported, Wrong};
use super::quotient::Quotient;
use super::sign::Signs;
use torse_certificate::polynomial::Polynomial;
use torse_certificate::sign::Taylor;
use torse_certificate::taylor::PartialSum;

impl Signs<'_> {
    /// Checks that the gaps make the polynomial, and that it is not negative; whether it is not zero either.
    pub(super) fn taylor(
        &self,
        polynomial: &Polynomial,
        taylor: &Taylor<Polynomial>,
    ) -> Result<bool, CheckError> {
        let work = self.domain.work;
        let gaps = taylor.bounds.iter().map(|bound| self.gap(bound));
        let gaps: Vec<(Polynomial, bool)> = gaps.collect::<Result<_, _>>()?;
        let (mut sum, mut strict) = (Polynomial::zero(), false);
        for term in &taylor.terms {
            if term.exponents.len() != gaps.len() {
                return Err(Wrong::Equation.into());
            }
            self.sign(&term.coefficient)?;
            let (mut product, mut positive) =
                (term.coefficient.polynomial.clone(), term.coefficient.strict);
            for ((gap, is_positive), exponent) in gaps.iter().zip(&term.exponents) {
                for _ in 0..*exponent {
                    product = work.times(&product, gap)?;
                }
                positive &= *is_positive || *exponent == 0;
            }
            strict |= positive;
            sum = sum.plus(&product);
        }
        match Quotient::from(sum.minus(polynomial)).is_zero(work)? {
            true => Ok(strict),
            false => Err(Wrong::Equation.into()),
        }
    }

    /// The gap of a partial sum, and whether it is positive.
    fn gap(&self, bound: &PartialSum) -> Result<(Polynomial, bool), CheckError> {
        if bound.exponent.is_some() {
            // The checker does not know what an exponential is the power of.
            return Err(Unsupported::Construct("an exponential").into());
        }
        let wrong = || CheckError::from(Wrong::Coordinate(bound.symbol.to_string()));
        let (variable, from_zero) = bound.variable().ok_or_else(wrong)?;
        let gap = bound.gap().ok_or_else(wrong)?;
        match !from_zero || self.ranges.is_nonnegative(&variable) {
            true => Ok((gap, bound.is_strict() && self.ranges.is_positive(&variable))),
            false => Err(Wrong::Negative.into()),
        }
    }
}
