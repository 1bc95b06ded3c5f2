//! The exponential function.
//!
//! The exponential function increases, so its values at the two ends enclose its values between. At an end `x >= 0`:
//! 1. x is divided by `2^s`, so that `0 <= h < 2^-t` with `t >= 3`;
//! 2. Taylor, in balls: after the term `h^n/n!` whose enclosure is a few units wide the rest of the series is at most
//!    `h/(n+1) + h^2/(n+1)^2 + ... <= 1` times that term, so the enclosure of the term is added once more, from zero;
//! 3. s squarings of balls.
//!
//! For `x < 0` the result is the inverse of `exp(-x)`. A squaring doubles the relative error, and the result has
//! about `3/2 x` binary digits before the point; the working precision has that many more digits, so the result is
//! one or two units wide.

use super::{Ball, Toward, shifted_down};
use crate::rational::{Integer, Rational};
use crate::scalar::{ExactError, Scalar as _};
use dashu_int::ops::BitTest;
use num_integer::Roots;
use num_traits::Signed;

/// The largest absolute value of an exponent; its power has about 24,000 binary digits before the point.
const MAX_EXPONENT: usize = 1 << 14;

impl Ball {
    /// The exponential function.
    ///
    /// ```
    /// use torse_numbers::{Ball, rational::integer};
    /// let e = Ball::from_rational(&integer(1), 80).exp().unwrap();
    /// assert_eq!(e.decimal(20), "2.71828182845904523536...");
    /// ```
    ///
    /// # Errors
    /// [`ExactError::TooLarge`] for exponents above 2^14, whose powers have too many digits to be stored. A power
    /// below one unit is enclosed between zero and one unit.
    pub fn exp(&self) -> Result<Self, ExactError> {
        let hi = at_point(&self.hi, self.bits)?.hi;
        let lo = if self.lo == self.hi {
            at_point(&self.hi, self.bits)?.lo
        } else {
            at_point(&self.lo, self.bits)?.lo
        };
        let bits = self.bits;
        Ok(Self { lo, hi, bits })
    }
}

/// The exponential of the dyadic number `numerator * 2^-bits`.
fn at_point(numerator: &Integer, bits: usize) -> Result<Ball, ExactError> {
    let size = numerator.abs();
    let bound = shifted_down(&size, bits, Toward::PlusInfinity);
    if bound > Integer::from(MAX_EXPONENT) {
        return if numerator.is_negative() {
            // Here exp(x) < exp(-2^14), and a unit 2^-bits may be smaller than that, since bits goes up to 2^16.
            Ok(Ball {
                lo: Integer::ZERO,
                hi: (Integer::ONE << bits.saturating_sub(MAX_EXPONENT)) + 1,
                bits,
            })
        } else {
            let bits = bound.bit_len();
            let limit = Integer::from(MAX_EXPONENT).bit_len();
            Err(ExactError::TooLarge { bits, limit })
        };
    }
    let bound = usize::try_from(&bound).unwrap_or(MAX_EXPONENT);
    if !numerator.is_negative() {
        return Ok(upward(&size, bits, bound, bits).rescaled(bits));
    }
    // The derivative of 1/y is at most 1 in size for y >= 1, so an error of one unit stays at most one unit.
    let inverse = upward(&size, bits, bound, bits + 4);
    let one = Ball::integer(1, inverse.bits);
    one.divided_by(&inverse).map(|ball| ball.rescaled(bits))
}

/// The exponential of `numerator * 2^-places >= 0`, which is at most `bound`, with at least `bits` digits after the
/// point.
fn upward(numerator: &Integer, places: usize, bound: usize, bits: usize) -> Ball {
    let before_point = bound + bound / 2 + 1;
    // h < 2^-t balances the number of Taylor terms against the number of squarings.
    let t = (bits + before_point).sqrt() * 2 / 3 + 3;
    let squarings = bound.next_power_of_two().trailing_zeros() as usize + t;
    let working = bits + before_point + squarings + 16;
    let h = Ball {
        lo: numerator.clone(),
        hi: numerator.clone(),
        bits: places + squarings,
    }
    .rescaled(working);
    let mut term = Ball::integer(1, working);
    let mut sum = term.clone();
    let mut n = 0_u32;
    loop {
        n += 1;
        term = (&term * &h).scaled(&Rational::new(1.into(), n.into()));
        sum = &sum + &term;
        // The upper end of a term never falls below one unit.
        if term.hi <= Integer::from(2) {
            break;
        }
    }
    sum.hi += &term.hi;
    for _ in 0..squarings {
        sum = &sum * &sum;
    }
    sum
}
