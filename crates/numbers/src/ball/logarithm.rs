//! The natural logarithm.
//!
//! The logarithm increases, so its values at the two ends enclose its values between. At an end x > 0:
//! 1. `x = 2^e m` with `2/3 <= m < 4/3`, so `ln x = e ln 2 + ln m`;
//! 2. `ln m = 2 artanh z` with `z = (m - 1)/(m + 1)`, and `ln 2 = 2 artanh(1/3)`;
//! 3. the series `artanh z = z + z^3/3 + z^5/5 + ...` in balls. For `abs(z) <= 1/3` all terms after one term add up to
//!    at most `z^2/(1 - z^2) <= 1/8` of it, so the last term that is added is added once more, with both signs.
//!
//! The working precision has so many more digits that the rounding of all terms stays below one unit of the result.

use super::Ball;
use crate::fault_injection::{InjectedFault, injected};
use crate::rational::{Integer, Rational, ceiling_quotient, floor_quotient};
use crate::scalar::{ExactError, Scalar as _};
use dashu_int::ops::BitTest;
use num_traits::Signed;

impl Ball {
    /// The natural logarithm.
    ///
    /// ```
    /// use torse_numbers::{Ball, rational::integer};
    /// let two = Ball::from_rational(&integer(2), 80);
    /// assert_eq!(two.ln().unwrap().decimal(20), "0.69314718055994530941...");
    /// assert!(Ball::from_rational(&integer(0), 80).ln().is_err());
    /// ```
    ///
    /// # Errors
    /// [`ExactError::NoLogarithm`] when the ball contains a number that is not positive.
    pub fn ln(&self) -> Result<Self, ExactError> {
        if !self.lo.is_positive() {
            return Err(ExactError::NoLogarithm {
                argument: self.to_string(),
            });
        }
        let below = at_point(&self.lo, self.bits);
        let above = match self.lo == self.hi {
            true => below.clone(),
            false => at_point(&self.hi, self.bits),
        };
        let hi = match injected(InjectedFault::LogarithmRoundedDown) {
            true => above.lo,
            false => above.hi,
        };
        Ok(Self {
            lo: below.lo,
            hi,
            bits: self.bits,
        })
    }
}

/// The logarithm of the dyadic number `numerator * 2^-bits > 0`.
fn at_point(numerator: &Integer, bits: usize) -> Ball {
    // The number with the point before its first digit is in [1/2, 1); below 2/3 the point moves by one place.
    let length = numerator.bit_len();
    let places = match numerator * 3 < (Integer::ONE << (length + 1)) {
        true => length - 1,
        false => length,
    };
    let exponent = Integer::from(places) - Integer::from(bits);
    let size = bits + exponent.bit_len();
    let working = size + 2 * Integer::from(size).bit_len() + 16;
    let one = Integer::ONE << places;
    let mantissa = inverse_hyperbolic_tangent(&(numerator - &one), &(numerator + &one), working);
    let two = inverse_hyperbolic_tangent(&Integer::ONE, &Integer::from(3), working);
    let sum = &mantissa + &two.scaled(&Rational::from_integer(exponent));
    sum.scaled(&Rational::from_integer(2.into())).rescaled(bits)
}

/// `artanh(above/below)` for `abs(above/below) <= 1/3` and `below > 0`.
fn inverse_hyperbolic_tangent(above: &Integer, below: &Integer, bits: usize) -> Ball {
    let shifted = above << bits;
    let argument = Ball {
        lo: floor_quotient(&shifted, below),
        hi: ceiling_quotient(&shifted, below),
        bits,
    };
    let square = &argument * &argument;
    let mut power = argument.clone();
    let mut sum = argument;
    let mut n = 1_u32;
    loop {
        n += 2;
        power = &power * &square;
        let term = power.scaled(&Rational::new(1.into(), n.into()));
        sum = &sum + &term;
        let size = term.lo.abs().max(term.hi.abs());
        if size <= Integer::from(2) {
            sum.lo -= &size;
            sum.hi += &size;
            return sum;
        }
    }
}
