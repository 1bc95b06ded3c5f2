//! The exponential function.
//!
//! It increases, so the powers of the two ends enclose those of all numbers between. At an end `x >= 0`:
//! 1. x is divided by `2^s`, so that `0 <= h < 2^-t` with `t >= 3`;
//! 2. Taylor, in balls: after the term `h^n/n!` whose enclosure is a few units wide the rest of the series is at most
//!    `h/(n+1) + h^2/(n+1)^2 + ... <= 1` times that term, so the enclosure of the term is added once more, from zero;
//! 3. s squarings of balls.
//!
//! Below zero it is the inverse. A squaring doubles the relative error, and the result has about `3/2 x` binary digits
//! before the point; the working precision has so many digits more, which keeps the result a unit or two wide.

use super::{Ball, Toward, shifted_down};
use crate::rational::{Integer, Rational};
use crate::scalar::{ExactError, Scalar as _};
use dashu_int::ops::BitTest;
use num_integer::Roots;
use num_traits::Signed;

/// The largest size of an exponent: its power has about 24,000 binary digits.
const LARGEST: usize = 1 << 14;

impl Ball {
    /// The number e to this power.
    ///
    /// ```
    /// use torse_numbers::{Ball, rational::integer};
    /// let e = Ball::from_rational(&integer(1), 80).exp().unwrap();
    /// assert_eq!(e.decimal(20), "2.71828182845904523536...");
    /// ```
    ///
    /// # Errors
    /// [`ExactError::TooLarge`] for exponents above 2^14, whose powers are too long to be written. Powers that are too
    /// small are enclosed between zero and one unit.
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

/// The power at the dyadic number `numerator * 2^-bits`.
fn at_point(numerator: &Integer, bits: usize) -> Result<Ball, ExactError> {
    let size = numerator.abs();
    let whole = shifted_down(&size, bits, Toward::PlusInfinity);
    if whole > Integer::from(LARGEST) {
        return if numerator.is_negative() {
            // Less than 2^-bits: no precision goes beyond 2^16 bits, and exp(-2^14) may be larger than that.
            Ok(Ball {
                lo: Integer::ZERO,
                hi: (Integer::ONE << bits.saturating_sub(LARGEST)) + 1,
                bits,
            })
        } else {
            let bits = whole.bit_len();
            let limit = Integer::from(LARGEST).bit_len();
            Err(ExactError::TooLarge { bits, limit })
        };
    }
    let whole = usize::try_from(&whole).unwrap_or(LARGEST);
    if !numerator.is_negative() {
        return Ok(upward(&size, bits, whole, bits).rescaled(bits));
    }
    // An error of one unit of the inverse is at most one of the power, which is at least one.
    let inverse = upward(&size, bits, whole, bits + 4);
    let one = Ball::integer(1, inverse.bits);
    one.divided_by(&inverse).map(|ball| ball.rescaled(bits))
}

/// The power at `numerator * 2^-places >= 0`, which is at most `whole`, with a few more than so many bits.
fn upward(numerator: &Integer, places: usize, whole: usize, bits: usize) -> Ball {
    let before_point = whole + whole / 2 + 1;
    // h < 2^-t: about as many terms as squarings, whatever part of the digits stands before the point.
    let t = (bits + before_point).sqrt() * 2 / 3 + 3;
    let squarings = whole.next_power_of_two().trailing_zeros() as usize + t;
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
