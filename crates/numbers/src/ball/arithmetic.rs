//! The ring operations and the quotient, rounded outward once.

use super::{Ball, Toward, shifted_down};
use crate::rational::Integer;
use crate::rational::{ceiling_quotient, floor_quotient};
use num_traits::Signed;
use std::ops::{Add, Mul, Neg, Sub};

/// The operands at their common precision.
fn aligned<'a>(a: &'a Ball, b: &'a Ball, storage: &'a mut Option<Ball>) -> (&'a Ball, &'a Ball) {
    match a.bits.cmp(&b.bits) {
        std::cmp::Ordering::Equal => (a, b),
        std::cmp::Ordering::Less => (storage.insert(a.rescaled(b.bits)), b),
        std::cmp::Ordering::Greater => (a, storage.insert(b.rescaled(a.bits))),
    }
}

fn sum(a: &Ball, b: &Ball) -> Ball {
    Ball {
        lo: &a.lo + &b.lo,
        hi: &a.hi + &b.hi,
        bits: a.bits,
    }
}

fn difference(a: &Ball, b: &Ball) -> Ball {
    Ball {
        lo: &a.lo - &b.hi,
        hi: &a.hi - &b.lo,
        bits: a.bits,
    }
}

/// The extremes of `x y` over a rectangle, in units of `4^-bits`. They are attained at corners, and the signs of the
/// factors determine at which ones.
fn extremes(a: &Ball, b: &Ball) -> (Integer, Integer) {
    match (Side::from_ball(a), Side::from_ball(b)) {
        (Side::Right, _) => from_the_right(a, b),
        (_, Side::Right) => from_the_right(b, a),
        (Side::Left, _) => from_the_right(&-a, &-b),
        (_, Side::Left) => from_the_right(&-b, &-a),
        (Side::Both, Side::Both) => (
            (&a.lo * &b.hi).min(&a.hi * &b.lo),
            (&a.lo * &b.lo).max(&a.hi * &b.hi),
        ),
    }
}

fn product(a: &Ball, b: &Ball) -> Ball {
    let (lo, hi) = extremes(a, b);
    rounded(&lo, &hi, a.bits)
}

/// Rounds outward from units of `4^-bits` to units of `2^-bits`.
fn rounded(lo: &Integer, hi: &Integer, bits: usize) -> Ball {
    Ball {
        lo: shifted_down(lo, bits, Toward::MinusInfinity),
        hi: shifted_down(hi, bits, Toward::PlusInfinity),
        bits,
    }
}

/// Where a ball lies with respect to zero.
#[derive(Clone, Copy)]
enum Side {
    Right,
    Left,
    Both,
}

impl Side {
    fn from_ball(ball: &Ball) -> Self {
        if !ball.lo.is_negative() {
            Self::Right
        } else if !ball.hi.is_positive() {
            Self::Left
        } else {
            Self::Both
        }
    }
}

/// The extremes of `x y` for `x >= 0`, in units of `4^-bits`.
fn from_the_right(x: &Ball, y: &Ball) -> (Integer, Integer) {
    (
        if y.lo.is_negative() {
            &x.hi * &y.lo
        } else {
            &x.lo * &y.lo
        },
        if y.hi.is_negative() {
            &x.lo * &y.hi
        } else {
            &x.hi * &y.hi
        },
    )
}

impl Ball {
    /// The sum of the products of pairs at a precision of `bits`, rounded only once.
    ///
    /// ```
    /// use torse_numbers::{Ball, rational::{integer, ratio}};
    /// let ball = |n, d| Ball::from_rational(&ratio(n, d).unwrap(), 8);
    /// let (row, column) = ([ball(1, 2), ball(-3, 4)], [ball(5, 1), ball(1, 256)]);
    /// let sum = Ball::dot(row.iter().zip(&column), 8);
    /// assert!(sum.contains(&(ratio(5, 2).unwrap() - ratio(3, 1024).unwrap())));
    /// assert!(sum.width() <= ratio(1, 256).unwrap());
    /// ```
    #[must_use]
    pub fn dot<'a>(pairs: impl IntoIterator<Item = (&'a Self, &'a Self)>, bits: usize) -> Self {
        let bits = bits.min(Self::MAX_BITS);
        let (mut least, mut greatest) = (Integer::ZERO, Integer::ZERO);
        for (a, b) in pairs {
            let (mut own, mut other) = (None, None);
            let a = if a.bits == bits {
                a
            } else {
                own.insert(a.rescaled(bits))
            };
            let b = if b.bits == bits {
                b
            } else {
                other.insert(b.rescaled(bits))
            };
            let (lo, hi) = extremes(a, b);
            least += lo;
            greatest += hi;
        }
        rounded(&least, &greatest, bits)
    }

    /// Returns `self / divisor`, or `None` if the divisor contains zero.
    pub(super) fn quotient(&self, divisor: &Self) -> Option<Self> {
        let mut storage = None;
        let (x, y) = aligned(self, divisor, &mut storage);
        match Side::from_ball(y) {
            _ if y.contains_zero() => None,
            Side::Left => (-x).quotient(&-y),
            _ => Some(Self {
                // For y > 0 a quotient is least with the least x, over the largest y if x >= 0.
                lo: floor_quotient(
                    &(&x.lo << x.bits),
                    if x.lo.is_negative() { &y.lo } else { &y.hi },
                ),
                hi: ceiling_quotient(
                    &(&x.hi << x.bits),
                    if x.hi.is_negative() { &y.hi } else { &y.lo },
                ),
                bits: x.bits,
            }),
        }
    }
}

impl Neg for &Ball {
    type Output = Ball;

    fn neg(self) -> Ball {
        Ball {
            lo: -&self.hi,
            hi: -&self.lo,
            bits: self.bits,
        }
    }
}

impl Neg for Ball {
    type Output = Ball;

    fn neg(self) -> Ball {
        Ball {
            lo: -self.hi,
            hi: -self.lo,
            bits: self.bits,
        }
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $function:ident) => {
        impl $trait<&Ball> for &Ball {
            type Output = Ball;

            fn $method(self, other: &Ball) -> Ball {
                let mut storage = None;
                let (a, b) = aligned(self, other, &mut storage);
                $function(a, b)
            }
        }

        impl $trait for Ball {
            type Output = Ball;

            fn $method(self, other: Ball) -> Ball {
                (&self).$method(&other)
            }
        }
    };
}

operator!(Add, add, sum);
operator!(Sub, sub, difference);
operator!(Mul, mul, product);
