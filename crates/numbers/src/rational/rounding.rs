//! Rounding to integers, correct for all signs.

use super::{Integer, Rational};
use dashu_int::ops::{DivEuclid, RemEuclid};
use num_traits::Signed;

/// Returns the greatest integer that is at most `numerator / denominator`.
///
/// ```
/// use torse_numbers::{Integer, rational::floor_quotient};
/// assert_eq!(floor_quotient(&Integer::from(-7), &Integer::from(2)), Integer::from(-4));
/// ```
///
/// # Panics
/// When the denominator is zero.
#[must_use]
pub fn floor_quotient(numerator: &Integer, denominator: &Integer) -> Integer {
    // The Euclidean remainder lies in [0, abs(denominator)), so for a positive denominator the Euclidean quotient is
    // the floor.
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

/// Returns the residue of `n` in `[0, abs(modulus))`.
///
/// ```
/// use torse_numbers::{Integer, rational::remainder};
/// assert_eq!(remainder(&Integer::from(-1), &Integer::from(4)), Integer::from(3));
/// ```
///
/// # Panics
/// For a modulus of zero.
#[must_use]
pub fn remainder(n: &Integer, modulus: &Integer) -> Integer {
    n.rem_euclid(modulus).into()
}

impl Rational {
    /// The greatest integer that is at most the number.
    #[must_use]
    pub fn floor(&self) -> Self {
        Self::from_integer(floor_quotient(self.numer(), self.denom()))
    }

    /// The least integer that is at least the number.
    #[must_use]
    pub fn ceil(&self) -> Self {
        Self::from_integer(ceiling_quotient(self.numer(), self.denom()))
    }

    /// Returns the nearest integer; a tie is rounded away from zero.
    ///
    /// ```
    /// use torse_numbers::rational::{integer, ratio};
    /// assert_eq!(ratio(-1, 2).map(|q| q.round()), Some(integer(-1)));
    /// assert_eq!(ratio(-1, 3).map(|q| q.round()), Some(integer(0)));
    /// ```
    #[must_use]
    pub fn round(&self) -> Self {
        // Add half a unit away from zero, then truncate: (2 n + d) / (2 d) for n >= 0.
        let twice = self.denom() * 2;
        let outward = if self.is_negative() {
            self.numer() * 2 - self.denom()
        } else {
            self.numer() * 2 + self.denom()
        };
        Self::from_integer(outward / twice)
    }

    /// Rounds toward zero.
    #[must_use]
    pub fn trunc(&self) -> Self {
        Self::from_integer(self.to_integer())
    }

    /// The number minus its [`Rational::trunc`]; it has the sign of the number.
    #[must_use]
    pub fn fract(&self) -> Self {
        Self::in_lowest_terms(self.numer() % self.denom(), self.denom().clone())
    }

    /// [`Rational::trunc`] as an integer.
    #[must_use]
    pub fn to_integer(&self) -> Integer {
        self.numer() / self.denom()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
    fn numbers_round_as_doubles_do_for_all_signs() {
        // Doubles are exact for these quotients' floors; halves are dyadic.
        for n in -40..=40_i64 {
            for d in 1..=12_i64 {
                let exact = n as f64 / d as f64;
                let q = Rational::new(n.into(), d.into());
                let whole = |x: f64| Rational::from(x as i64);
                assert_eq!(q.floor(), whole(exact.floor()), "{q}");
                assert_eq!(q.ceil(), whole(exact.ceil()), "{q}");
                assert_eq!(q.round(), whole(exact.round()), "{q}");
                assert_eq!(q.trunc(), whole(exact.trunc()), "{q}");
                assert_eq!(q.trunc() + q.fract(), q);
                assert!(q.fract().abs() < Rational::from(1), "{q}");
            }
        }
    }
}
