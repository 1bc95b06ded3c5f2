//! The order of the rational numbers.
//!
//! **Do not compare rationals with `<`, `max`, `sort` or `cmp`.** `Ratio` compares through
//! `num_integer::Integer::div_mod_floor`, and `dashu_int` (0.4 to 0.6.2) answers 0 instead of -1 for the floor
//! of a quotient between -1 and 0: its truncated quotient 0 carries no sign. So `-1/2 > 0` holds for
//! `Ratio<IBig>`, and `floor`, `ceil` and `round` err in the same way. Arithmetic and `is_negative` are right.
//! So is `==`, but it goes through `cmp` too, which recurses once for each step of Euclid's algorithm: for
//! two long numbers that nearly agree it is slow and deep. What is right and fast stands here.

use crate::rational::{Integer, Rational};
use dashu_int::ops::DivEuclid;
use num_traits::Signed;
use std::cmp::Ordering;

/// How `a` compares with `b`.
///
/// ```
/// use std::cmp::Ordering;
/// use torse_numbers::{order::compare, rational::{integer, ratio}};
/// assert_eq!(compare(&ratio(-1, 2).unwrap(), &integer(0)), Ordering::Less);
/// ```
#[must_use]
pub fn compare(a: &Rational, b: &Rational) -> Ordering {
    // Denominators are positive.
    if a.denom() == b.denom() {
        return a.numer().cmp(b.numer());
    }
    (a.numer() * b.denom()).cmp(&(b.numer() * a.denom()))
}

/// Whether the two numbers are the same: they are in lowest terms with positive denominators.
#[must_use]
pub fn equal(a: &Rational, b: &Rational) -> bool {
    a.numer() == b.numer() && a.denom() == b.denom()
}

/// The smaller of two rationals.
#[must_use]
pub fn least<'a>(a: &'a Rational, b: &'a Rational) -> &'a Rational {
    if compare(a, b).is_gt() { b } else { a }
}

/// The larger of two rationals.
#[must_use]
pub fn greatest<'a>(a: &'a Rational, b: &'a Rational) -> &'a Rational {
    if compare(a, b).is_lt() { b } else { a }
}

/// The greatest integer that is at most `numerator / denominator`; the denominator is not zero.
pub(crate) fn floor_quotient(numerator: &Integer, denominator: &Integer) -> Integer {
    // The Euclidean quotient leaves a remainder in [0, abs(denominator)): for a positive denominator
    // that is the floor.
    if denominator.is_negative() {
        (-numerator).div_euclid(-denominator)
    } else {
        numerator.div_euclid(denominator)
    }
}

/// The least integer that is at least `numerator / denominator`; the denominator is not zero.
pub(crate) fn ceiling_quotient(numerator: &Integer, denominator: &Integer) -> Integer {
    -floor_quotient(&-numerator, denominator)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_integer::Integer as _;

    #[test]
    fn quotients_round_as_named_for_all_signs() {
        for n in -7..=7_i64 {
            for d in (-3..=3_i64).filter(|&d| d != 0) {
                let exact = n as f64 / d as f64;
                let (n, d) = (Integer::from(n), Integer::from(d));
                assert_eq!(floor_quotient(&n, &d), Integer::from(exact.floor() as i64));
                assert_eq!(ceiling_quotient(&n, &d), Integer::from(exact.ceil() as i64));
            }
        }
    }

    #[test]
    fn small_fractions_are_in_order() {
        let all = || (-6..=6_i64).flat_map(|n| (1..=6_i64).map(move |d| (n, d)));
        for (a, b) in all() {
            for (c, d) in all() {
                let (x, y) = (
                    Rational::new(a.into(), b.into()),
                    Rational::new(c.into(), d.into()),
                );
                assert_eq!(compare(&x, &y), (a * d).cmp(&(c * b)));
                assert_eq!(equal(&x, &y), a * d == c * b);
                assert!(compare(least(&x, &y), greatest(&x, &y)).is_le());
            }
        }
    }

    #[test]
    fn long_numbers_that_nearly_agree_are_compared_without_recursion() {
        // Neighbouring quotients of Fibonacci numbers take the most steps of Euclid's algorithm.
        let (mut a, mut b) = (Integer::ONE, Integer::ONE);
        for _ in 0..200_000 {
            (a, b) = (b.clone(), a + b);
        }
        let x = Rational::new_raw(b.clone(), a.clone());
        let y = Rational::new_raw(&a + &b, b);
        assert!(!equal(&x, &y) && compare(&x, &y).is_ne());
    }

    /// When this fails the dependency is mended and this module can go.
    #[test]
    fn the_dependency_still_floors_small_negative_quotients_wrongly() {
        assert_eq!(
            Integer::from(-1).div_floor(&Integer::from(2)),
            Integer::ZERO
        );
    }
}
