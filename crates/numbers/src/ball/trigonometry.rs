//! Sine and cosine.
//!
//! All angles are counted in quarter turns, where reduction is exact: a ball's ends are dyadic, and
//! `sin(pi x/2)`, `cos(pi x/2)` have period 4 and take the values 0, 1, -1 at the integers. Only a
//! fraction `0 < f < 1` of a quarter turn is left to compute. On an interval the extremes are
//! attained at its ends or at the integers inside, so the hull of those values encloses the range, and
//! does so tightly.
//!
//! **The kernel.** With `w` working bits, all quantities in units `u = 2^-w`:
//! 1. the angle `f pi/2` is halved `r` times, to `h <= 1.6 * 2^-r <= 1/2`, rounded down;
//! 2. Taylor: `t_1 = h`, `t_n = floor(floor(t_{n-1} h) / n)`, until it vanishes. If `t_{n-1}` is within 2
//!    of `h^{n-1}/(n-1)!`, then `t_n` is within `(2 h + 1)/n + 1 <= 2` of `h^n/n!`. So after `N` terms
//!    `sin h` and `v = 1 - cos h` are each off by at most `N` (half of the terms, 2 each) plus 2 for the
//!    alternating tail, whose first term is at most 2 in truth;
//! 3. `r` doublings `s' = 2 s (1 - v)`, `v' = 2 s^2`. If `s` and `v` are off by at most `e`, then `s'` and `v'`
//!    are by at most `4 e + 2 e^2 u + 1 <= 4 e + 2`, as long as `2 e^2 <= 2^w`.
//!
//! Working with `1 - cos` instead of `cos` keeps the last step from losing digits near the angle 0,
//! and computing the sine as a square root of `1 - cos^2` would lose all of them there. Halving about
//! `0.6 sqrt(bits)` times balances the doublings against the terms.

use super::{Ball, Toward, pi, shifted_down};
use crate::rational::Integer;
use crate::rational::{ceiling_quotient, floor_quotient};
use dashu_int::ops::BitTest;
use num_integer::Roots;

/// Enclosures of `sin(pi x/2)` and `cos(pi x/2)` for all `x` in the ball, at the given precision.
pub(super) fn quarter_turn(x: &Ball, bits: usize) -> (Ball, Ball) {
    let start = at_point(&x.lo, x.bits, bits);
    if x.lo == x.hi {
        return start;
    }
    if &x.hi - &x.lo >= Integer::from(4) << x.bits {
        let all = Ball::integer(-1, bits).hull(&Ball::integer(1, bits));
        return (all.clone(), all);
    }
    let join = |(s, c): (Ball, Ball), other: (Ball, Ball)| (s.hull(&other.0), c.hull(&other.1));
    let mut range = join(start, at_point(&x.hi, x.bits, bits));
    let mut turning = shifted_down(&x.lo, x.bits, Toward::PlusInfinity);
    while &turning << x.bits <= x.hi {
        range = join(range, at_point(&turning, 0, bits));
        turning += 1;
    }
    range
}

/// `(sin, cos)` of a quarter turn times the dyadic number `numerator * 2^-places`.
fn at_point(numerator: &Integer, places: usize, bits: usize) -> (Ball, Ball) {
    let turns = numerator >> places;
    let (s, c) = in_first_quadrant(&(numerator - (&turns << places)), places, bits);
    match (turns.bit(1), turns.bit(0)) {
        (false, false) => (s, c),
        (false, true) => (c, -s),
        (true, false) => (-s, -c),
        (true, true) => (-c, s),
    }
}

/// `(sin, cos)` of a quarter turn times `fraction * 2^-places`, which lies in `[0, 1)`.
fn in_first_quadrant(fraction: &Integer, places: usize, bits: usize) -> (Ball, Ball) {
    if fraction.is_zero() {
        return (Ball::integer(0, bits), Ball::integer(1, bits));
    }
    let halvings = bits.sqrt() * 3 / 5 + 2;
    // The error grows by 4^halvings; 16 more bits hold the error before the doublings, so what remains is a small
    // part of one unit of the result.
    let guard = 2 * halvings + 16;
    let working = bits + guard;
    let Kernel {
        sine,
        versine,
        error,
    } = Kernel::new(fraction, places, working, halvings);
    let enclosure = |value: &Integer| Ball {
        // Both values lie in [0, 1] because the angle is in the first quadrant.
        lo: shifted_down(&(value - &error), guard, Toward::MinusInfinity).max(Integer::ZERO),
        hi: shifted_down(&(value + &error), guard, Toward::PlusInfinity).min(Integer::ONE << bits),
        bits,
    };
    (
        enclosure(&sine),
        enclosure(&((Integer::ONE << working) - versine)),
    )
}

/// `sin` and `1 - cos` of an angle in the first quadrant, in units of `2^-working`.
struct Kernel {
    sine: Integer,
    versine: Integer,
    /// A bound of the absolute error of both values.
    error: Integer,
}

impl Kernel {
    /// Computes the pair for a quarter turn times `fraction * 2^-places`, with at least 2 halvings.
    fn new(fraction: &Integer, places: usize, working: usize, halvings: usize) -> Self {
        let one = Integer::ONE << working;
        let pi = pi::enclosure(working);
        let angle: Integer = (fraction * &pi.lo) >> (places + 1 + halvings);
        let (mut sine, mut versine, terms) = taylor(&angle, working);
        // The terms and the tail; then the angle: pi is known to one unit, the floor adds another.
        let mut error = Integer::from(terms + 2 + 2);
        for _ in 0..halvings {
            let doubled = (&sine * (&one - &versine)) >> (working - 1);
            versine = (&sine * &sine) >> (working - 1);
            sine = doubled;
            error = error * 4 + 2;
        }
        Self {
            sine,
            versine,
            error,
        }
    }
}

/// `(sin h, 1 - cos h, N)` from `N` Taylor terms, for `0 <= h <= 1/2`, all with `working` binary digits.
fn taylor(h: &Integer, working: usize) -> (Integer, Integer, u32) {
    let mut sine = h.clone();
    let mut versine = Integer::ZERO;
    let mut term = h.clone();
    let mut n = 1_u32;
    while !term.is_zero() {
        n += 1;
        term = ((&term * h) >> working) / n;
        match n % 4 {
            0 => versine -= &term,
            1 => sine += &term,
            2 => versine += &term,
            _ => sine -= &term,
        }
    }
    (sine, versine, n)
}

impl Ball {
    /// Enclosures of the sine and the cosine of an angle in radians, of any size.
    ///
    /// The angle is turned into quarter turns with as many more digits of `2/pi` as it has digits
    /// before the point, so a huge angle loses nothing. For `sin(pi x/2)` itself prefer
    /// [`quarter_turn`](crate::Scalar::quarter_turn), which needs no such step.
    ///
    /// ```
    /// use torse_numbers::{Ball, rational::integer};
    /// let (sine, cosine) = Ball::from_rational(&integer(1), 80).sin_cos();
    /// assert_eq!(sine.decimal(20), "0.84147098480789650665...");
    /// assert_eq!(cosine.decimal(20), "0.54030230586813971740...");
    /// ```
    #[must_use]
    pub fn sin_cos(&self) -> (Self, Self) {
        // With 2/pi known to 2 units of 2^-precision and abs(angle) <= 2^integer_bits, the angle in
        // quarter turns is off by less than a tenth of a unit of the result.
        let precision = self.bits + self.integer_bits() + 8;
        let pi = pi::enclosure(precision);
        let two = Integer::from(2) << (2 * precision);
        let two_over_pi = Self {
            lo: floor_quotient(&two, &pi.hi),
            hi: ceiling_quotient(&two, &pi.lo),
            bits: precision,
        };
        quarter_turn(&(self * &two_over_pi), self.bits)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_traits::Signed;

    #[test]
    fn the_error_of_the_kernel_is_within_its_bound() {
        let (coarse, fine) = (100, 400);
        for halvings in [2, 4, 8, 16, 30] {
            for fraction in 1..64 {
                let kernel =
                    |working, halvings| Kernel::new(&Integer::from(fraction), 6, working, halvings);
                let (rough, exact) = (kernel(coarse, halvings), kernel(fine, 3));
                let bound = (&rough.error << (fine - coarse)) + &exact.error;
                for (value, truth) in [(rough.sine, exact.sine), (rough.versine, exact.versine)] {
                    let difference = ((value << (fine - coarse)) - truth).abs();
                    assert!(difference <= bound, "{halvings} halvings at {fraction}/64");
                }
            }
        }
    }

    #[test]
    fn the_error_bound_has_to_grow_with_the_doublings() {
        // With 30 halvings the true error exceeds what the Taylor series alone accounts for.
        let (working, halvings) = (160, 30);
        let exceeds = (1..64).any(|fraction| {
            let rough = Kernel::new(&Integer::from(fraction), 6, working, halvings);
            let exact = Kernel::new(&Integer::from(fraction), 6, 400, 3);
            let terms = taylor(&(Integer::ONE << (working - halvings)), working).2;
            ((rough.sine << (400 - working)) - exact.sine).abs()
                > Integer::from(terms + 4) << (400 - working)
        });
        assert!(exceeds);
    }
}
