//! The logarithm of a product of numbers and exponentials.
//!
//! `log(a b) = log(a) + log(b)` where both are positive: exponentials are, and so are roots of primes. The logarithm of a
//! positive rational number is the sum of those of its primes, each as often as it divides the number.

use super::Polynomial;
use super::primes::prime_factors;
use crate::fraction::Fraction;
use crate::rational::{Rational, integer, ratio};
use crate::scalar::ExactError;
use crate::symbol::Symbol;
use num_traits::{One, Signed, ToPrimitive};

impl Polynomial {
    /// The logarithm of a positive rational number, as a sum of logarithms of primes.
    ///
    /// ```
    /// use torse_algebra::{Polynomial, rational::ratio};
    /// assert_eq!(Polynomial::logarithm(&ratio(8, 9).unwrap()).unwrap().to_string(), "3*log(2) - 2*log(3)");
    /// ```
    ///
    /// # Errors
    /// [`ExactError::NoLogarithm`] for zero and negative numbers, and for those with a prime factor that is not found
    /// by dividing by the numbers up to one million or that has more than 32 bits; [`ExactError::TooLarge`] for numbers
    /// of more than 2^14 binary digits.
    pub fn logarithm(number: &Rational) -> Result<Self, ExactError> {
        let refused = || ExactError::NoLogarithm {
            argument: number.to_string(),
        };
        if !number.is_positive() {
            return Err(refused());
        }
        let mut sum = Self::zero();
        for (part, sign) in [(number.numer(), 1), (number.denom(), -1)] {
            for (prime, exponent) in prime_factors(part)?.ok_or_else(refused)? {
                let prime = prime.to_u32().ok_or_else(refused)?;
                let times = sign * exponent.to_i64().ok_or_else(refused)?;
                sum = &sum + &Self::symbol(Symbol::Log(prime)).scaled(&integer(times));
            }
        }
        Ok(sum)
    }

    /// The logarithm of a single term: a positive number times powers of exponentials and of roots of primes.
    fn logarithm_of_term(&self) -> Result<Self, ExactError> {
        let refused = || ExactError::NoLogarithm {
            argument: self.to_string(),
        };
        let mut terms = self.terms();
        let (Some(term), None) = (terms.next(), terms.next()) else {
            return Err(refused());
        };
        let mut sum = Self::logarithm(&term.coefficient)?;
        for (symbol, power) in &term.powers {
            let part = match symbol {
                Symbol::Exp(exponent) => exponent.polynomial(),
                Symbol::Root(prime) => {
                    let half = ratio(1, 2).unwrap_or_else(Rational::one);
                    Self::symbol(Symbol::Log(*prime)).scaled(&half)
                }
                _ => return Err(refused()),
            };
            sum = &sum + &part.scaled(&integer(i64::from(*power)));
        }
        Ok(sum)
    }
}

impl Fraction {
    /// The logarithm of a product of a positive number, exponentials and roots of primes, and of a quotient of two such
    /// products.
    ///
    /// ```
    /// use torse_algebra::Fraction;
    /// let power = Fraction::named("x").exponential().unwrap();
    /// let quotient = Fraction::integer(2) * power.clone() * power;
    /// assert_eq!(quotient.logarithm().unwrap().to_string(), "2*x + log(2)");
    /// assert!(Fraction::named("x").logarithm().is_err());
    /// ```
    ///
    /// # Errors
    /// [`ExactError::NoLogarithm`] for everything else.
    pub fn logarithm(&self) -> Result<Self, ExactError> {
        let above = self.numerator().logarithm_of_term()?;
        let below = self.denominator().logarithm_of_term()?;
        Ok((&above - &below).into())
    }
}
