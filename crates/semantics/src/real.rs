//! Real numbers at a point: exact as long as they are `r + t pi` with rational r and t, enclosed by a ball beyond.
//!
//! So a polynomial at a rational point is decided exactly, and `sin(pi/2*x)` at 0 or 1 as well.

use crate::arithmetic::Arithmetic;
use crate::gap::{Gap, Undefined, Unknown, Work};
use dashu_int::ops::{BitTest, SquareRoot};
use num_traits::{One, Signed, Zero};
use std::cmp::Ordering;
use std::fmt;
use torse_numbers::rational::{integer, ratio};
use torse_numbers::{Ball, Integer, Rational, Scalar};

/// The longest numerator or denominator of an exact number, in bits; beyond it is enclosed.
const MAX_EXACT_BITS: usize = 3000;
/// The largest integer part of an enclosed number, in bits.
const MAX_SIZE_BITS: u64 = 20_000;

/// A real number.
#[derive(Debug, Clone, PartialEq)]
pub enum Real {
    /// `rational + turns * pi`.
    Exact {
        /// The rational part.
        rational: Rational,
        /// The multiple of pi.
        turns: Rational,
    },
    /// A number of this ball.
    Enclosed(Ball),
}

impl From<Rational> for Real {
    fn from(rational: Rational) -> Self {
        Self::Exact {
            rational,
            turns: Rational::zero(),
        }
    }
}

impl fmt::Display for Real {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exact { rational, turns } if turns.is_zero() => write!(f, "{rational}"),
            Self::Exact { rational, turns } => {
                if !rational.is_zero() {
                    write!(f, "{rational}")?;
                }
                let sign = match (turns.is_negative(), rational.is_zero()) {
                    (true, _) => "-",
                    (false, true) => "",
                    (false, false) => "+",
                };
                let size = turns.abs();
                if !size.numer().is_one() {
                    write!(f, "{sign}{}*pi", size.numer())?;
                } else {
                    write!(f, "{sign}pi")?;
                }
                if size.is_integer() {
                    Ok(())
                } else {
                    write!(f, "/{}", size.denom())
                }
            }
            Self::Enclosed(ball) => write!(f, "{}", ball.decimal(20)),
        }
    }
}

impl Real {
    /// The ball of this precision.
    #[must_use]
    pub fn ball(&self, bits: usize) -> Ball {
        match self {
            Self::Exact { rational, turns } if turns.is_zero() => {
                Ball::from_rational(rational, bits)
            }
            Self::Exact { rational, turns } => {
                Ball::from_rational(rational, bits) + Ball::pi(bits).scaled(turns)
            }
            Self::Enclosed(ball) => ball.clone(),
        }
    }

    /// How the number compares with zero, if that is known.
    ///
    /// An exact number always is: `r + t pi` is zero for r = t = 0 only, because pi is irrational.
    #[must_use]
    pub fn sign(&self) -> Option<Ordering> {
        match self {
            Self::Exact { rational, turns } if turns.is_zero() => {
                Some(rational.cmp(&Rational::zero()))
            }
            Self::Exact { .. } => [128, 1024, 8192]
                .into_iter()
                .find_map(|bits| self.ball(bits).sign()),
            Self::Enclosed(ball) => ball.sign(),
        }
    }

    /// The rational number, if it is known to be one.
    #[must_use]
    pub fn as_rational(&self) -> Option<&Rational> {
        match self {
            Self::Exact { rational, turns } => turns.is_zero().then_some(rational),
            Self::Enclosed(_) => None,
        }
    }

    /// A double near the number, for display.
    #[must_use]
    pub fn to_f64(&self) -> f64 {
        let (low, high) = self.ball(80).to_f64_bounds();
        f64::midpoint(low, high)
    }
}

/// The arithmetic of real numbers, with balls of this precision.
#[derive(Debug)]
pub struct Reals<'a> {
    /// Binary digits after the point.
    pub bits: usize,
    /// The budget.
    pub work: &'a Work,
}

fn length(q: &Rational) -> usize {
    q.numer().bit_len().max(q.denom().bit_len())
}

impl Reals<'_> {
    fn exact(&self, rational: Rational, turns: Rational) -> Real {
        let real = Real::Exact { rational, turns };
        match &real {
            Real::Exact { rational, turns }
                if length(rational).max(length(turns)) > MAX_EXACT_BITS =>
            {
                Real::Enclosed(real.ball(self.bits))
            }
            _ => real,
        }
    }
}

/// Whether a number is known to be this integer.
fn is_exactly(a: &Real, n: i64) -> bool {
    a.as_rational().is_some_and(|q| *q == integer(n))
}

/// `sin(pi t)` where it is rational and t is rational.
fn rational_sine(t: &Rational) -> Option<Rational> {
    let sixths = t * integer(6);
    if !sixths.is_integer() {
        return None;
    }
    // The remainder of the truncated division has the sign of the numerator.
    let part = i64::try_from(&(sixths.to_integer() % Integer::from(12))).ok()?;
    Some(match part.rem_euclid(12) {
        0 | 6 => Rational::zero(),
        3 => Rational::one(),
        9 => -Rational::one(),
        1 | 5 => ratio(1, 2)?,
        7 | 11 => ratio(-1, 2)?,
        _ => return None,
    })
}

/// The root of a rational number that is a square.
fn rational_root(q: &Rational) -> Option<Rational> {
    let root = |n: &Integer| {
        let root = Integer::from(n.clone().into_parts().1.sqrt());
        (&root * &root == *n).then_some(root)
    };
    Some(Rational::new(root(q.numer())?, root(q.denom())?))
}

impl Arithmetic for Reals<'_> {
    type Number = Real;

    fn rational(&self, value: &Rational) -> Real {
        self.exact(value.clone(), Rational::zero())
    }

    fn pi(&self) -> Real {
        Real::Exact {
            rational: Rational::zero(),
            turns: Rational::one(),
        }
    }

    fn plus(&self, a: &Real, b: &Real) -> Result<Real, Gap> {
        // Nothing is done where a side is zero, or a factor one.
        if is_exactly(a, 0) {
            return Ok(b.clone());
        }
        if is_exactly(b, 0) {
            return Ok(a.clone());
        }
        self.work.spend(1)?;
        Ok(match (a, b) {
            (
                Real::Exact { rational, turns },
                Real::Exact {
                    rational: r,
                    turns: t,
                },
            ) => self.exact(rational + r, turns + t),
            _ => Real::Enclosed(a.ball(self.bits) + b.ball(self.bits)),
        })
    }

    fn negated(&self, a: &Real) -> Real {
        match a {
            Real::Exact { rational, turns } => Real::Exact {
                rational: -rational,
                turns: -turns,
            },
            Real::Enclosed(ball) => Real::Enclosed(-ball),
        }
    }

    fn times(&self, a: &Real, b: &Real) -> Result<Real, Gap> {
        if is_exactly(a, 0) || is_exactly(b, 0) {
            return Ok(Rational::zero().into());
        }
        if is_exactly(a, 1) {
            return Ok(b.clone());
        }
        if is_exactly(b, 1) {
            return Ok(a.clone());
        }
        self.work.spend(1)?;
        for (a, b) in [(a, b), (b, a)] {
            if let (Some(q), Real::Exact { rational, turns }) = (a.as_rational(), b) {
                let turns = match turns.is_zero() {
                    true => Rational::zero(),
                    false => q * turns,
                };
                return Ok(self.exact(q * rational, turns));
            }
        }
        if self.bit_length(a).unwrap_or(0) + self.bit_length(b).unwrap_or(0) > MAX_SIZE_BITS {
            return Err(Unknown::Large { what: "a number" }.into());
        }
        Ok(Real::Enclosed(a.ball(self.bits) * b.ball(self.bits)))
    }

    fn over(&self, a: &Real, b: &Real) -> Result<Real, Gap> {
        self.work.spend(2)?;
        match b.sign() {
            None => return Err(Unknown::Precision.into()),
            Some(Ordering::Equal) => return Err(Undefined::ZeroDivisor.into()),
            Some(_) => {}
        }
        if let (
            Real::Exact { rational, turns },
            Real::Exact {
                rational: r,
                turns: t,
            },
        ) = (a, b)
        {
            if t.is_zero() {
                let turns = match turns.is_zero() {
                    true => Rational::zero(),
                    false => turns / r,
                };
                return Ok(self.exact(rational / r, turns));
            }
            if rational * t == turns * r {
                return Ok(self.exact(turns / t, Rational::zero()));
            }
        }
        let quotient = a.ball(self.bits).divided_by(&b.ball(self.bits));
        quotient
            .map(Real::Enclosed)
            .map_err(|_| Unknown::Precision.into())
    }

    fn square_root(&self, a: &Real) -> Result<Real, Gap> {
        self.work.spend(4)?;
        if a.sign() == Some(Ordering::Less) {
            return Err(Undefined::NegativeRoot.into());
        }
        if let Some(root) = a.as_rational().and_then(rational_root) {
            return Ok(root.into());
        }
        let root = a.ball(self.bits).sqrt();
        root.map(Real::Enclosed)
            .map_err(|_| Unknown::Precision.into())
    }

    fn sine_cosine(&self, a: &Real) -> Result<(Real, Real), Gap> {
        self.work.spend(16)?;
        let Real::Exact { rational, turns } = a else {
            let (sine, cosine) = a.ball(self.bits).sin_cos();
            return Ok((Real::Enclosed(sine), Real::Enclosed(cosine)));
        };
        if !rational.is_zero() {
            let (sine, cosine) = a.ball(self.bits).sin_cos();
            return Ok((Real::Enclosed(sine), Real::Enclosed(cosine)));
        }
        // The quarter turns of a rational number of half turns are enclosed best from the number itself.
        let half = Rational::new(1.into(), 2.into());
        let quarters = Ball::from_rational(&(turns * integer(2)), self.bits);
        let (sine, cosine) = quarters.quarter_turn().map_err(|_| Unknown::Precision)?;
        let known = |exact: Option<Rational>, ball| exact.map_or(Real::Enclosed(ball), Real::from);
        Ok((
            known(rational_sine(turns), sine),
            known(rational_sine(&(turns + half)), cosine),
        ))
    }

    fn is_zero(&self, a: &Real) -> Option<bool> {
        a.sign().map(|sign| sign == Ordering::Equal)
    }

    fn as_rational(&self, a: &Real) -> Option<Rational> {
        a.as_rational().cloned()
    }

    fn bit_length(&self, a: &Real) -> Option<u64> {
        let bits = match a {
            Real::Exact { rational, turns } => {
                let whole =
                    |q: &Rational| (q.numer().bit_len() + 1).saturating_sub(q.denom().bit_len());
                whole(rational).max(whole(turns) + 2)
            }
            Real::Enclosed(ball) => {
                let (low, high) = ball.to_f64_bounds();
                let size = low.abs().max(high.abs());
                if size < 1e300 {
                    // A power of two above the size: doubles below this bound have small exponents.
                    (size.log2().max(0.0).ceil() as usize) + 1
                } else {
                    ball.abs()
                        .upper()
                        .numer()
                        .bit_len()
                        .saturating_sub(ball.bits())
                }
            }
        };
        u64::try_from(bits).ok()
    }
}
