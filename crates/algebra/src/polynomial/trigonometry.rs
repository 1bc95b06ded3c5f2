//! Sine and cosine of a quarter turn times a polynomial, if they are polynomials; and the polynomial ring as a
//! [`Scalar`].
//!
//! The argument may be a rational combination of variables plus a multiple of 1/6. Sums of angles are expanded by the
//! addition theorems, a fraction of the angle of a variable is a symbol of its own, and values at multiples of 15
//! degrees are exact.

use super::Polynomial;
use super::primes::prime_factors;
use crate::fault_injection::{InjectedFault, injected};
use crate::rational::{Rational, integer, ratio, remainder};
use crate::scalar::{ExactError, Scalar, ZeroTest};
use crate::symbol::{Angle, Symbol, Unit};
use num_traits::{One, Signed, ToPrimitive, Zero};
use std::sync::Arc;

/// The largest multiple of the angle of a variable that is expanded, and the largest number of parts.
pub(super) const MAX_MULTIPLE: u64 = 64;

type Pair = (Polynomial, Polynomial);

/// (sin, cos) of the sum of two angles.
fn sum_of_angles((s1, c1): &Pair, (s2, c2): &Pair) -> Pair {
    if injected(InjectedFault::AngleSum) {
        return (&(s1 * c2) + &(c1 * s2), &(c1 * c2) + &(s1 * s2));
    }
    (&(s1 * c2) + &(c1 * s2), &(c1 * c2) - &(s1 * s2))
}

/// (sin, cos) of `turns` quarter turns for multiples of 1/6.
fn constant_angle(turns: &Rational) -> Option<Pair> {
    let sixths = (turns * integer(6)).to_integer();
    if Rational::from_integer(sixths.clone()) != turns * integer(6) {
        return None;
    }
    let sixths = remainder(&sixths, &crate::Integer::from(24)).to_i64()?;
    let root = |prime: u32| {
        Polynomial::symbol(Symbol::Root(prime)).scaled(&ratio(1, 2).unwrap_or_else(Rational::one))
    };
    let half = || Polynomial::constant(&ratio(1, 2).unwrap_or_else(Rational::one));
    // sin of n * 15 degrees in the first quadrant: at 15 and 75 degrees (sqrt(6) -+ sqrt(2))/4.
    let sine = |n: i64| -> Option<Polynomial> {
        Some(match n {
            0 => Polynomial::zero(),
            1 => &root(2) * &(&root(3) - &half()),
            5 => &root(2) * &(&root(3) + &half()),
            2 => half(),
            3 => root(2),
            4 => root(3),
            6 => Polynomial::integer(1),
            _ => return None,
        })
    };
    let at = |n: i64| -> Option<Polynomial> {
        let n = n.rem_euclid(24);
        match n {
            0..=6 => sine(n),
            7..=12 => sine(12 - n),
            13..=18 => sine(n - 12).map(|p| -p),
            _ => sine(24 - n).map(|p| -p),
        }
    };
    Some((at(sixths)?, at(sixths + 6)?))
}

/// (sin, cos) of an integer multiple of the angle of a variable.
pub(super) fn multiple_of(name: &Arc<str>, angle: Angle, multiple: i64) -> Pair {
    let sine = Polynomial::symbol(Symbol::Sin(Arc::clone(name), angle));
    let cosine = Polynomial::symbol(Symbol::Cos(Arc::clone(name), angle));
    let once = (if multiple < 0 { -sine } else { sine }, cosine);
    (1..multiple.unsigned_abs()).fold(once.clone(), |sum, _| sum_of_angles(&sum, &once))
}

/// (sin, cos) of an integer multiple of the arc tangent of a fraction whose squares add up to a prime.
fn multiple_of_arc(above: u32, below: u32, multiple: i64) -> Option<Pair> {
    let prime = u64::from(above) * u64::from(above) + u64::from(below) * u64::from(below);
    let prime = u32::try_from(prime).ok()?;
    let root = Polynomial::symbol(Symbol::Root(prime));
    let part = |n: u32| root.scaled(&Rational::new(n.into(), prime.into()));
    let sine = if multiple < 0 {
        -part(above)
    } else {
        part(above)
    };
    let once = (sine, part(below));
    let none = (Polynomial::zero(), Polynomial::integer(1));
    Some((0..multiple.unsigned_abs()).fold(none, |sum, _| sum_of_angles(&sum, &once)))
}

/// (sin, cos) of a polynomial argument in the given unit.
pub(crate) fn pair(argument: &Polynomial, unit: Unit) -> Result<Pair, ExactError> {
    let refused = || ExactError::NoExactTurn {
        argument: argument.to_string(),
    };
    let mut total: Pair = (Polynomial::zero(), Polynomial::integer(1));
    for term in argument.terms() {
        let part = match (term.powers.as_slice(), unit) {
            ([], Unit::QuarterTurn) => constant_angle(&term.coefficient).ok_or_else(refused)?,
            ([(Symbol::Named(name), 1)], _) => {
                let multiple = term.coefficient.numer().to_i64().ok_or_else(refused)?;
                let parts = term.coefficient.denom().to_u16().ok_or_else(refused)?;
                if multiple.unsigned_abs() > MAX_MULTIPLE || u64::from(parts) > MAX_MULTIPLE {
                    return Err(refused());
                }
                multiple_of(name, Angle { unit, parts }, multiple)
            }
            ([(Symbol::Arc(above, below), 1)], Unit::Radian) => {
                let multiple = term.coefficient.is_integer();
                let multiple = multiple.then(|| term.coefficient.numer().to_i64());
                let multiple = multiple.flatten().ok_or_else(refused)?;
                if multiple.unsigned_abs() > MAX_MULTIPLE {
                    return Err(refused());
                }
                multiple_of_arc(*above, *below, multiple).ok_or_else(refused)?
            }
            _ => return Err(refused()),
        };
        total = sum_of_angles(&total, &part);
    }
    Ok(total)
}

impl Polynomial {
    /// `(sin(self), cos(self))` with `self` in radians: a rational combination of variables and multiples of pi/12.
    /// Multiples of pi/2 * x are treated as quarter turns of the variable x.
    ///
    /// # Errors
    /// [`ExactError::NoExactTurn`] when the sine and cosine are not polynomials in the symbols of this ring.
    pub fn sine_cosine(&self) -> Result<(Self, Self), ExactError> {
        let by_pi = self.coefficients_in(&Symbol::Pi);
        let refused = || ExactError::NoExactTurn {
            argument: self.to_string(),
        };
        if by_pi.len() > 2 {
            return Err(refused());
        }
        let radians = by_pi.first().cloned().unwrap_or_else(Self::zero);
        let turns = by_pi
            .get(1)
            .cloned()
            .unwrap_or_else(Self::zero)
            .scaled(&integer(2));
        Ok(sum_of_angles(
            &pair(&radians, Unit::Radian)?,
            &pair(&turns, Unit::QuarterTurn)?,
        ))
    }

    /// The positive square root of a nonnegative rational number, as a rational multiple of square
    /// roots of primes.
    ///
    /// # Errors
    /// [`ExactError::NoSquareRoot`] for negative numbers and for those whose square-free part has a prime factor
    /// above one million; [`ExactError::TooLarge`] for a radicand whose parts have more than 2^14 binary digits
    /// together, because prime factors are found by trial division.
    ///
    /// ```
    /// use torse_algebra::{Polynomial, rational::ratio};
    /// assert_eq!(Polynomial::square_root(&ratio(9, 8).unwrap()).unwrap().to_string(), "3/4*sqrt(2)");
    /// ```
    pub fn square_root(radicand: &Rational) -> Result<Self, ExactError> {
        let refused = || ExactError::NoSquareRoot {
            radicand: radicand.to_string(),
        };
        if radicand.is_negative() {
            return Err(refused());
        }
        // sqrt(a/b) = sqrt(a b) / b
        let root = Self::constant(&Rational::new(1.into(), radicand.denom().clone()));
        if radicand.is_zero() {
            return Ok(Self::zero());
        }
        let factors = prime_factors(&(radicand.numer() * radicand.denom()))?.ok_or_else(refused)?;
        factors.iter().try_fold(root, |root, (prime, exponent)| {
            Ok(&root * &root_factor(prime, *exponent).ok_or_else(refused)?)
        })
    }
}

/// sqrt(prime^exponent).
fn root_factor(prime: &crate::Integer, exponent: usize) -> Option<Polynomial> {
    let integer_part = Polynomial::constant(&Rational::from_integer(prime.pow(exponent / 2)));
    if exponent.is_multiple_of(2) {
        return Some(integer_part);
    }
    Some(&integer_part * &Polynomial::symbol(Symbol::Root(u32::try_from(prime.clone()).ok()?)))
}

impl Scalar for Polynomial {
    fn constant(&self, q: &Rational) -> Self {
        Polynomial::constant(q)
    }

    fn divided_by(&self, divisor: &Self) -> Result<Self, ExactError> {
        self.exact_quotient(divisor)
            .ok_or_else(|| ExactError::DivisionByZero {
                divisor: divisor.to_string(),
            })
    }

    fn quarter_turn(&self) -> Result<(Self, Self), ExactError> {
        pair(self, Unit::QuarterTurn)
    }

    fn pi_like(&self) -> Result<Self, ExactError> {
        Ok(Self::symbol(Symbol::Pi))
    }

    fn scaled(&self, q: &Rational) -> Self {
        Polynomial::scaled(self, q)
    }
}

impl ZeroTest for Polynomial {
    fn is_known_zero(&self) -> bool {
        self.is_zero()
    }

    fn is_known_nonzero(&self) -> bool {
        !self.is_zero()
    }
}
