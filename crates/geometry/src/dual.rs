//! First derivatives by arithmetic, without a list for each number.
//!
//! A [`Dual`] is a Taylor series of order one, `value + slope t` modulo `t^2`, as two plain numbers: what
//! [`Jet`](torse_algebra::Jet) is of any order on the heap. Unrolling and certificates ask for nothing beyond it, many
//! thousand times.

use crate::coordinate::Coordinate;
use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};
use torse_algebra::{ExactError, Rational, Scalar};

/// A number and its derivative.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Dual<S> {
    pub(crate) value: S,
    pub(crate) slope: S,
}

impl<S: Coordinate> Dual<S> {
    /// A number that does not depend on the variable.
    pub(crate) fn constant_of(value: S) -> Self {
        let slope = value.zero();
        Self { value, slope }
    }

    /// The values of some coordinates, and their slopes.
    pub(crate) fn split<const D: usize>(coordinates: [Self; D]) -> [[S; D]; 2] {
        let values = coordinates.each_ref().map(|c| c.value.clone());
        [values, coordinates.map(|c| c.slope)]
    }
}

impl<S: Scalar> Add for Dual<S> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            slope: self.slope + other.slope,
        }
    }
}

impl<S: Scalar> Sub for Dual<S> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self {
            value: self.value - other.value,
            slope: self.slope - other.slope,
        }
    }
}

impl<S: Scalar> Neg for Dual<S> {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            value: -self.value,
            slope: -self.slope,
        }
    }
}

impl<S: Scalar> Mul for Dual<S> {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self {
            slope: self.value.clone() * other.slope + self.slope * other.value.clone(),
            value: self.value * other.value,
        }
    }
}

impl<S: Coordinate> Scalar for Dual<S> {
    fn constant(&self, q: &Rational) -> Self {
        Self::constant_of(self.value.constant(q))
    }

    fn zero_like(&self) -> Self {
        Self::constant_of(self.value.zero())
    }

    fn one_like(&self) -> Self {
        Self::constant_of(self.value.one())
    }

    /// `q = a/b`, `q' = (a' - b' q)/b`.
    fn divided_by(&self, divisor: &Self) -> Result<Self, ExactError> {
        let value = self.value.divided_by(&divisor.value)?;
        let slope = self.slope.clone() - divisor.slope.clone() * value.clone();
        Ok(Self {
            slope: slope.divided_by(&divisor.value)?,
            value,
        })
    }

    fn quarter_turn(&self) -> Result<(Self, Self), ExactError> {
        let (sine, cosine) = self.value.quarter_turn()?;
        let half = Rational::new(1.into(), 2.into());
        let speed = self.value.pi_like()?.scaled(&half) * self.slope.clone();
        let along = |value: S, slope: S| Self {
            value,
            slope: speed.clone() * slope,
        };
        Ok((along(sine.clone(), cosine.clone()), along(cosine, -sine)))
    }

    fn pi_like(&self) -> Result<Self, ExactError> {
        self.value.pi_like().map(Self::constant_of)
    }

    fn scaled(&self, q: &Rational) -> Self {
        Self {
            value: self.value.scaled(q),
            slope: self.slope.scaled(q),
        }
    }
}

impl<S: Coordinate> Coordinate for Dual<S> {
    fn is_finite(&self) -> bool {
        self.value.is_finite() && self.slope.is_finite()
    }

    /// The sign of the value; zero when the slope is zero as well.
    fn sign(&self) -> Option<Ordering> {
        match self.value.sign()? {
            Ordering::Equal => self.slope.sign().filter(|sign| sign.is_eq()),
            sign => Some(sign),
        }
    }

    fn approximate(&self) -> f64 {
        self.value.approximate()
    }

    fn times_two_to(&self, power: i32) -> Self {
        Self {
            value: self.value.times_two_to(power),
            slope: self.slope.times_two_to(power),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_algebra::Jet;
    use torse_algebra::rational::{integer, ratio};

    #[test]
    fn a_dual_number_is_a_series_of_order_one() {
        let x = Dual {
            value: integer(3),
            slope: integer(1),
        };
        let t = Jet::variable(integer(3), 1);
        let f = |x: &Dual<Rational>| {
            let square = x.clone() * x.clone();
            (square.clone() - x.one_like())
                .divided_by(&(square + x.clone()))
                .unwrap()
        };
        let g = |t: &Jet<Rational>| {
            let square = t.clone() * t.clone();
            (square.clone() - t.one_like())
                .divided_by(&(square + t.clone()))
                .unwrap()
        };
        let (dual, jet) = (f(&x), g(&t));
        // (x^2 - 1)/(x^2 + x) = 1 - 1/x.
        assert_eq!(
            [&dual.value, &dual.slope],
            [&ratio(2, 3).unwrap(), &ratio(1, 9).unwrap()]
        );
        assert_eq!(jet.coefficients(), [dual.value, dual.slope]);
    }

    #[test]
    fn the_slopes_of_a_quarter_turn_are_those_of_the_series() {
        let (s, c) = Dual {
            value: 0.3_f64,
            slope: 2.0,
        }
        .quarter_turn()
        .unwrap();
        let (sine, cosine) = Jet::from_coefficients(0.3_f64, [2.0])
            .quarter_turn()
            .unwrap();
        for (dual, jet) in [(s, sine), (c, cosine)] {
            assert_eq!(dual.value, *jet.value());
            assert!((dual.slope - jet.coefficients()[1]).abs() < 1e-15);
        }
    }
}
