//! Certified enclosures of real numbers.
//!
//! A [`Ball`] is a closed interval `[lo, hi] * 2^-bits` with integers `lo <= hi` of any size, known to
//! contain the number it stands for. The one theorem everything here relies on is the *inclusion
//! property*: if `x` lies in `X` and `y` in `Y`, then `x op y` lies in `X op Y`. Each operation keeps it
//! by rounding the lower end down and the upper end up, so a sign read off a ball is a proof.
//!
//! | operation | width of the result, in units of `2^-bits`, for arguments of width `wx`, `wy` |
//! |---|---|
//! | `+`, `-`, negation, `abs`, hull | no rounding: `wx + wy`, `wx`, ... |
//! | `*` | at most `abs(x) wy + abs(y) wx` (largest values) plus 2 |
//! | `/` | at most 1 for exact arguments |
//! | `sqrt`, [`Ball::pi`], [`Ball::from_rational`] | at most 1 for exact arguments |
//! | [`quarter_turn`](crate::Scalar::quarter_turn) | at most 2 for exact arguments, exact at integers |
//! | [`Ball::sin_cos`] | at most 3 for exact arguments |
//! | [`Ball::exp`], [`Ball::ln`], [`Ball::atan`], [`Ball::asin`] | at most 2 for exact arguments |
//!
//! Precision is absolute (fixed point): `bits` counts binary digits after the point. Balls of
//! different precision combine at the larger one, and raising a precision is exact.

mod arc;
mod arithmetic;
mod exponential;
mod logarithm;
mod pi;
mod text;
mod trigonometry;

use crate::fault_injection::{InjectedFault, injected};
use crate::rational::{Integer, Rational};
use crate::rational::{ceiling_quotient, floor_quotient};
use crate::scalar::{ExactError, Scalar, ZeroTest};
use dashu_int::ops::{BitTest, SquareRoot};
use num_traits::{Signed, Zero};
use std::cmp::Ordering;

/// A closed interval with dyadic ends that contains the real number it stands for.
///
/// `==` compares enclosures, not the numbers inside; ask [`Ball::sign`] of a difference, or
/// [`Ball::overlaps`], about the numbers.
///
/// ```
/// use torse_numbers::{Ball, rational::ratio};
/// use std::cmp::Ordering;
///
/// let third = Ball::from_rational(&ratio(1, 3).unwrap(), 64);
/// let pi = Ball::pi(64);
/// let difference = pi.powi(2) - pi * third;
/// assert_eq!(difference.sign(), Some(Ordering::Greater));
/// assert_eq!(difference.decimal(10), "8.8224068498...");
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct Ball {
    lo: Integer,
    hi: Integer,
    bits: usize,
}

/// Which way an end is rounded.
#[derive(Clone, Copy)]
enum Toward {
    MinusInfinity,
    PlusInfinity,
}

/// `value / 2^shift`, rounded.
fn shifted_down(value: &Integer, shift: usize, toward: Toward) -> Integer {
    match toward {
        Toward::MinusInfinity => value >> shift,
        Toward::PlusInfinity => -(-value >> shift),
    }
}

impl Ball {
    /// The largest precision of a ball. Constructors use this precision where a larger one is asked for: the
    /// enclosure is then wider, but still correct.
    pub const MAX_BITS: usize = 1 << 16;

    /// The tightest ball of this precision around a rational number, exact when the denominator
    /// divides `2^bits`.
    #[must_use]
    pub fn from_rational(value: &Rational, bits: usize) -> Self {
        Self::from_bounds(value, value, bits)
    }

    /// Returns the smallest ball of this precision that contains the closed interval between the two numbers, given
    /// in either order.
    #[must_use]
    pub fn from_bounds(first: &Rational, second: &Rational, bits: usize) -> Self {
        let bits = bits.min(Self::MAX_BITS);
        let (least, greatest) = (first.min(second), first.max(second));
        Self {
            lo: floor_quotient(&(least.numer() << bits), least.denom()),
            hi: ceiling_quotient(&(greatest.numer() << bits), greatest.denom()),
            bits,
        }
    }

    /// The integer `n`, exactly.
    fn integer(n: i8, bits: usize) -> Self {
        let scaled = Integer::from(n) << bits;
        Self {
            lo: scaled.clone(),
            hi: scaled,
            bits,
        }
    }

    /// The number of binary digits after the point.
    #[must_use]
    pub fn bits(&self) -> usize {
        self.bits
    }

    /// Changes the precision: exact if `bits` is not smaller than before, else rounded outward.
    #[must_use]
    pub fn with_bits(&self, bits: usize) -> Self {
        self.rescaled(bits.min(Self::MAX_BITS))
    }

    /// [`Ball::with_bits`] without a limit, for the guard bits of an operation.
    fn rescaled(&self, bits: usize) -> Self {
        match self.bits.checked_sub(bits) {
            Some(fewer) => Self {
                lo: shifted_down(&self.lo, fewer, Toward::MinusInfinity),
                hi: shifted_down(&self.hi, fewer, Toward::PlusInfinity),
                bits,
            },
            None => {
                let more = bits - self.bits;
                Self {
                    lo: &self.lo << more,
                    hi: &self.hi << more,
                    bits,
                }
            }
        }
    }

    /// The lower end.
    #[must_use]
    pub fn lower(&self) -> Rational {
        dyadic(&self.lo, self.bits)
    }

    /// The upper end.
    #[must_use]
    pub fn upper(&self) -> Rational {
        dyadic(&self.hi, self.bits)
    }

    /// The middle of the ball.
    #[must_use]
    pub fn midpoint(&self) -> Rational {
        dyadic(&(&self.lo + &self.hi), self.bits + 1)
    }

    /// Upper end minus lower end, never negative.
    #[must_use]
    pub fn width(&self) -> Rational {
        dyadic(&(&self.hi - &self.lo), self.bits)
    }

    /// Whether the rational number lies in the ball.
    #[must_use]
    pub fn contains(&self, value: &Rational) -> bool {
        let scaled = value.numer() << self.bits;
        &self.lo * value.denom() <= scaled && scaled <= &self.hi * value.denom()
    }

    /// Whether every number of the ball has an absolute value of at most `2^-places`.
    #[must_use]
    pub fn is_within(&self, places: usize) -> bool {
        let most = Integer::ONE << self.bits;
        [&self.lo, &self.hi]
            .into_iter()
            .all(|end| end.abs() << places <= most)
    }

    /// A lower bound of the number of zero binary digits after the point: every number of the ball has an absolute
    /// value below two to the minus this. Returns 0 if the ball contains numbers larger than one.
    #[must_use]
    pub fn leading_zeros(&self) -> usize {
        let length = self.lo.bit_len().max(self.hi.bit_len());
        self.bits.saturating_sub(length)
    }

    /// Whether zero lies in the ball.
    #[must_use]
    pub fn contains_zero(&self) -> bool {
        !self.lo.is_positive() && !self.hi.is_negative()
    }

    /// The sign of the enclosed number; `None` if the ball contains numbers of different signs.
    #[must_use]
    pub fn sign(&self) -> Option<Ordering> {
        if self.lo.is_positive() {
            Some(Ordering::Greater)
        } else if self.hi.is_negative() {
            Some(Ordering::Less)
        } else if self.lo.is_zero() && self.hi.is_zero() {
            Some(Ordering::Equal)
        } else {
            None
        }
    }

    /// Whether the two balls have a point in common. Balls that do not overlap hold different numbers.
    #[must_use]
    pub fn overlaps(&self, other: &Self) -> bool {
        let bits = self.bits.max(other.bits);
        let (a, b) = (self.rescaled(bits), other.rescaled(bits));
        a.lo <= b.hi && b.lo <= a.hi
    }

    /// The smallest ball that contains both.
    #[must_use]
    pub fn hull(&self, other: &Self) -> Self {
        let bits = self.bits.max(other.bits);
        let (a, b) = (self.rescaled(bits), other.rescaled(bits));
        Self {
            lo: a.lo.min(b.lo),
            hi: a.hi.max(b.hi),
            bits,
        }
    }

    /// The absolute value.
    #[must_use]
    pub fn abs(&self) -> Self {
        if !self.lo.is_negative() {
            self.clone()
        } else if !self.hi.is_positive() {
            -self
        } else {
            Self {
                lo: Integer::ZERO,
                hi: (-&self.lo).max(self.hi.clone()),
                bits: self.bits,
            }
        }
    }

    /// The power with a natural exponent; `powi(0)` is one.
    ///
    /// An even power is a power of the absolute value, so it never dips below zero.
    ///
    /// ```
    /// use torse_numbers::{Ball, rational::integer};
    /// let around_zero = Ball::from_bounds(&integer(-2), &integer(1), 8);
    /// assert_eq!(around_zero.powi(2), Ball::from_bounds(&integer(0), &integer(4), 8));
    /// assert_eq!(around_zero.powi(3), Ball::from_bounds(&integer(-8), &integer(1), 8));
    /// ```
    #[must_use]
    pub fn powi(&self, exponent: u32) -> Self {
        // The power is monotone on all reals (odd) or on the absolute values (even), so the powers of
        // the two ends enclose those of all numbers between.
        let base = if exponent.is_multiple_of(2) {
            self.abs()
        } else {
            self.clone()
        };
        let power_of = |end: &Integer| {
            let mut square = Self {
                lo: end.clone(),
                hi: end.clone(),
                bits: self.bits,
            };
            let mut power = Self::integer(1, self.bits);
            let mut rest = exponent;
            while rest > 0 {
                if rest % 2 == 1 {
                    power = &power * &square;
                }
                rest /= 2;
                if rest > 0 {
                    square = &square * &square;
                }
            }
            power
        };
        Self {
            lo: power_of(&base.lo).lo,
            hi: power_of(&base.hi).hi,
            bits: self.bits,
        }
    }

    /// The square root.
    ///
    /// # Errors
    /// [`ExactError::NoSquareRoot`] when the ball contains a negative number.
    pub fn sqrt(&self) -> Result<Self, ExactError> {
        if self.lo.is_negative() {
            return Err(ExactError::NoSquareRoot {
                radicand: self.to_string(),
            });
        }
        // sqrt(m 2^-b) = sqrt(m 2^b) 2^-b, and sqrt rounds an integer's root down.
        let floor_root = |end: &Integer| Integer::from((end << self.bits).into_parts().1.sqrt());
        let lo = floor_root(&self.lo);
        let below = floor_root(&self.hi);
        let exact = &below * &below == &self.hi << self.bits;
        let hi = if exact || injected(InjectedFault::RoundedInward) {
            below
        } else {
            below + 1
        };
        Ok(Self {
            lo,
            hi,
            bits: self.bits,
        })
    }

    /// The largest double `a` and the smallest double `b` with `a <= x <= b` for every `x` in the ball.
    ///
    /// An end outside the range of doubles becomes an infinity or the largest finite double,
    /// whichever lies outward.
    #[must_use]
    pub fn to_f64_bounds(&self) -> (f64, f64) {
        let (lo, hi) = (&self.lo, &self.hi);
        (
            greatest_double_below(lo, self.bits),
            -greatest_double_below(&-hi, self.bits),
        )
    }

    /// The number of binary digits before the point that the larger end needs.
    fn integer_bits(&self) -> usize {
        self.lo
            .bit_len()
            .max(self.hi.bit_len())
            .saturating_sub(self.bits)
    }
}

/// `numerator * 2^-bits` in lowest terms.
fn dyadic(numerator: &Integer, bits: usize) -> Rational {
    match numerator.trailing_zeros() {
        None => Rational::zero(),
        Some(zeros) => {
            let common = zeros.min(bits);
            Rational::in_lowest_terms(numerator >> common, Integer::ONE << (bits - common))
        }
    }
}

/// The greatest double that is at most `numerator * 2^-bits`.
fn greatest_double_below(numerator: &Integer, bits: usize) -> f64 {
    // Doubles are top * 2^exponent with abs(top) <= 2^53 and -1074 <= exponent <= 971.
    let signed = |n: usize| i64::try_from(n).unwrap_or(i64::MAX / 2);
    let exponent = (signed(numerator.bit_len()) - signed(bits) - 53).max(-1074);
    if exponent > 971 {
        return if numerator.is_negative() {
            f64::NEG_INFINITY
        } else {
            f64::MAX
        };
    }
    let drop = exponent + signed(bits);
    let amount = usize::try_from(drop.unsigned_abs()).unwrap_or(usize::MAX);
    let top = if drop >= 0 {
        numerator >> amount
    } else {
        numerator << amount
    };
    // Two factors, because 2^-1074 cannot be made by one call of powi. Both products are exact: the first is a normal
    // number, and the second is a double by the choice of the exponent.
    let power = |n: i64| f64::powi(2.0, i32::try_from(n).unwrap_or(0));
    let half = exponent / 2;
    i64::try_from(&top).map_or(f64::NAN, |top| {
        top as f64 * power(half) * power(exponent - half)
    })
}

impl Scalar for Ball {
    fn constant(&self, q: &Rational) -> Self {
        Self::from_rational(q, self.bits)
    }

    fn divided_by(&self, divisor: &Self) -> Result<Self, ExactError> {
        self.quotient(divisor)
            .ok_or_else(|| ExactError::DivisionByZero {
                divisor: divisor.to_string(),
            })
    }

    fn quarter_turn(&self) -> Result<(Self, Self), ExactError> {
        Ok(trigonometry::quarter_turn(self, self.bits))
    }

    fn pi_like(&self) -> Result<Self, ExactError> {
        Ok(Self::pi(self.bits))
    }

    fn scaled(&self, q: &Rational) -> Self {
        let (first, second) = (&self.lo * q.numer(), &self.hi * q.numer());
        let (least, greatest) = if q.is_negative() {
            (second, first)
        } else {
            (first, second)
        };
        Self {
            lo: floor_quotient(&least, q.denom()),
            hi: ceiling_quotient(&greatest, q.denom()),
            bits: self.bits,
        }
    }
}

impl ZeroTest for Ball {
    fn is_known_zero(&self) -> bool {
        self.sign() == Some(Ordering::Equal)
    }

    fn is_known_nonzero(&self) -> bool {
        !self.contains_zero()
    }
}
