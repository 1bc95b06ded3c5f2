//! Pi to any number of binary digits.
//!
//! Machin (1706): `pi = 16 arctan(1/5) - 4 arctan(1/239)`. The integer `floor(pi 2^b)` is one
//! well-defined number, so what is returned depends neither on guard bits nor on what was computed
//! before: `floor(floor(pi 2^B) / 2^(B-b)) = floor(pi 2^b)` for `b <= B` lets the longest value
//! found so far serve all shorter ones exactly.

use super::Ball;
use crate::rational::Integer;
use std::sync::{Mutex, PoisonError};

/// The largest precision `B` used so far, with `floor(pi 2^B)`; precision 0 means that nothing was computed yet.
static LONGEST: Mutex<(usize, Integer)> = Mutex::new((0, Integer::ZERO));

impl Ball {
    /// The ball `[n, n + 1] * 2^-bits` around pi, of width one unit.
    ///
    /// ```
    /// use torse_numbers::Ball;
    /// assert_eq!(Ball::pi(100).decimal(25), "3.1415926535897932384626433...");
    /// ```
    #[must_use]
    pub fn pi(bits: usize) -> Self {
        enclosure(bits.min(Self::MAX_BITS))
    }
}

/// Pi at any precision. It is irrational, so the upper end is the lower end plus one.
pub(super) fn enclosure(bits: usize) -> Ball {
    let lo = floor_of_scaled_pi(bits);
    Ball {
        hi: &lo + 1,
        lo,
        bits,
    }
}

/// `floor(pi 2^bits)`.
fn floor_of_scaled_pi(bits: usize) -> Integer {
    // A poisoned lock still holds a consistent pair, because the pair is replaced by one assignment.
    let mut longest = LONGEST.lock().unwrap_or_else(PoisonError::into_inner);
    if longest.0 <= bits {
        *longest = (bits + 64, computed_floor(bits + 64));
    }
    &longest.1 >> (longest.0 - bits)
}

/// `floor(pi 2^bits)` from Machin's formula, with guard digits until both ends of an enclosure agree.
/// They do at some length because pi is irrational.
fn computed_floor(bits: usize) -> Integer {
    let mut guard = 16;
    loop {
        let (at_5, error_at_5) = arctan_of_inverse(5, bits + guard);
        let (at_239, error_at_239) = arctan_of_inverse(239, bits + guard);
        let value: Integer = at_5 * 16 - at_239 * 4;
        let error = Integer::from(16 * error_at_5 + 4 * error_at_239);
        let below: Integer = (&value - &error) >> guard;
        if below == (value + error) >> guard {
            return below;
        }
        guard *= 2;
    }
}

/// `(a, e)` with `abs(arctan(1/n) 2^bits - a) <= e`, from the alternating series
/// `sum (-1)^k / ((2k+1) n^(2k+1))`.
///
/// Each power of `1/n` is a floor of a floor and so within 1 of the true one from below, each term
/// within 2. The first power to vanish is below 1 in truth, hence so is the first term left out, which
/// bounds the tail of an alternating decreasing series.
fn arctan_of_inverse(n: u64, bits: usize) -> (Integer, u64) {
    let mut power: Integer = (Integer::ONE << bits) / n;
    let mut sum = Integer::ZERO;
    let mut terms = 0;
    while !power.is_zero() {
        let term = &power / (2 * terms + 1);
        sum = if terms % 2 == 0 {
            sum + term
        } else {
            sum - term
        };
        power /= n * n;
        terms += 1;
    }
    (sum, 2 * terms + 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use dashu_float::{Context, round::mode};

    #[test]
    fn every_digit_computed_is_that_of_the_correctly_rounded_value() {
        for bits in (0..2000).chain([4096]) {
            // Two digits stand before the point.
            let cut = Context::<mode::Down>::new(bits + 2).pi::<2>(None).value();
            let digits = cut.repr().significand();
            let exponent = bits as isize + cut.repr().exponent();
            let expected = if exponent >= 0 {
                digits << exponent.unsigned_abs()
            } else {
                digits >> exponent.unsigned_abs()
            };
            assert_eq!(computed_floor(bits), expected, "{bits} bits");
        }
    }
}
