//! Signs of polynomials that are linear in the square of a bounded symbol.

use super::gap::{CheckError, Wrong};
use super::quotient::Quotient;
use super::sign::Signs;
use torse_certificate::polynomial::Polynomial;
use torse_certificate::ratio::Ratio;
use torse_certificate::sign::{End, Even};
use torse_numbers::rational::integer;

impl Signs<'_> {
    /// Checks both signs; whether the polynomial is not zero either.
    pub(super) fn even(
        &self,
        polynomial: &Polynomial,
        even: &Even<Polynomial>,
    ) -> Result<bool, CheckError> {
        let work = self.domain.work;
        let coefficients = polynomial.coefficients_in(&even.symbol);
        let [constant, linear, square] = coefficients.as_slice() else {
            return Err(Wrong::Equation.into());
        };
        let same = |a: &Polynomial, b: &Polynomial| Quotient::from(a.minus(b)).is_zero(work);
        let at_bound = constant.plus(&square.scaled(&(&even.bound * &even.bound)));
        let made = linear.is_zero()
            && same(constant, &even.at_zero.polynomial)?
            && same(&at_bound, &even.at_bound.polynomial)?;
        if !made {
            return Err(Wrong::Equation.into());
        }
        self.sign(&even.at_zero)?;
        self.sign(&even.at_bound)?;
        let within = |closed: bool| {
            let end = |number: torse_numbers::Rational| End {
                value: Ratio::from(Polynomial::constant(number)),
                closed,
            };
            let (lower, upper) = (end(-even.bound.clone()), end(even.bound.clone()));
            self.ranges.side(&even.symbol, Some(&lower), Some(&upper))
        };
        if even.bound <= integer(0) || !within(true) {
            return Err(Wrong::Coordinate(even.symbol.to_string()).into());
        }
        Ok(even.at_zero.strict && (even.at_bound.strict || within(false)))
    }
}
