//! Numbers `r + m sqrt(d)` with rational r and m: sums, products and quotients of those with one d are exact.
//!
//! So a polynomial is decided exactly at a quadratic irrational, where an enclosure would leave open whether it is zero.

use dashu_int::ops::{BitTest, SquareRoot};
use num_traits::{Signed, Zero};
use std::cmp::Ordering;
use std::fmt;
use torse_numbers::rational::integer;
use torse_numbers::{Ball, Integer, Rational, Scalar};

/// Squares of the numbers up to this one are taken out of a radicand, so that `sqrt(8)` and `sqrt(2)` have one radicand.
const MAX_FACTOR: i64 = 60;
/// The roots of longer radicands are enclosed: exact numbers with them grow too long.
const MAX_RADICAND_BITS: usize = 64;

/// `rational + multiple * sqrt(radicand)`: the multiple is not zero, and the radicand is positive and no square.
#[derive(Debug, Clone, PartialEq)]
pub struct Surd {
    rational: Rational,
    multiple: Rational,
    radicand: Integer,
}

/// The result of an operation on surds.
pub(crate) enum Exact {
    Rational(Rational),
    Surd(Surd),
}

impl Exact {
    /// The square root of a rational number; `None` for a negative one, and for a surd with a long radicand.
    pub(crate) fn root(q: &Rational) -> Option<Self> {
        // The root of n/d is that of n d, over d.
        let mut radicand = q.numer() * q.denom();
        if radicand < Integer::ZERO {
            return None;
        }
        let floor = Integer::from(radicand.clone().into_parts().1.sqrt());
        if &floor * &floor == radicand {
            return Some(Self::Rational(Rational::new(floor, q.denom().clone())));
        }
        let mut multiple = Rational::new(1.into(), q.denom().clone());
        for factor in 2..=MAX_FACTOR {
            let square = Integer::from(factor * factor);
            while (&radicand % &square).is_zero() {
                radicand = &radicand / &square;
                multiple *= integer(factor);
            }
        }
        (radicand.bit_len() <= MAX_RADICAND_BITS).then(|| {
            Self::Surd(Surd {
                rational: Rational::zero(),
                multiple,
                radicand,
            })
        })
    }
}

impl Surd {
    /// `rational + multiple * sqrt(radicand)`, for a radicand that is positive and no square.
    fn simplified(rational: Rational, multiple: Rational, radicand: &Integer) -> Exact {
        if multiple.is_zero() {
            return Exact::Rational(rational);
        }
        Exact::Surd(Self {
            rational,
            multiple,
            radicand: radicand.clone(),
        })
    }

    /// The sum with a rational number.
    pub(crate) fn plus_rational(&self, q: &Rational) -> Exact {
        Self::simplified(&self.rational + q, self.multiple.clone(), &self.radicand)
    }

    /// The product with a rational number.
    pub(crate) fn times_rational(&self, q: &Rational) -> Exact {
        Self::simplified(&self.rational * q, &self.multiple * q, &self.radicand)
    }

    /// The sum of two; `None` if their radicands differ.
    pub(crate) fn plus(&self, other: &Self) -> Option<Exact> {
        (self.radicand == other.radicand).then(|| {
            let rational = &self.rational + &other.rational;
            Self::simplified(rational, &self.multiple + &other.multiple, &self.radicand)
        })
    }

    /// The product of two; `None` if their radicands differ and it is no multiple of one root.
    pub(crate) fn times(&self, other: &Self) -> Option<Exact> {
        let (a, b) = (&self.rational, &self.multiple);
        let (c, d) = (&other.rational, &other.multiple);
        if self.radicand == other.radicand {
            let rational = a * c + b * d * self.square();
            return Some(Self::simplified(rational, a * d + b * c, &self.radicand));
        }
        if !a.is_zero() || !c.is_zero() {
            return None;
        }
        let (radicand, multiple) = (&self.radicand * &other.radicand, b * d);
        Some(match Exact::root(&Rational::from_integer(radicand))? {
            Exact::Rational(root) => Exact::Rational(root * multiple),
            Exact::Surd(root) => root.times_rational(&multiple),
        })
    }

    /// `1/self`. The norm `r^2 - m^2 d` is not zero, since d is no square.
    pub(crate) fn inverse(&self) -> Exact {
        let norm =
            &self.rational * &self.rational - &self.multiple * &self.multiple * self.square();
        let multiple = -(&self.multiple / &norm);
        Self::simplified(&self.rational / &norm, multiple, &self.radicand)
    }

    fn square(&self) -> Rational {
        Rational::from_integer(self.radicand.clone())
    }

    /// The sign; a surd is not zero.
    pub(crate) fn sign(&self) -> Ordering {
        let of = |q: &Rational| q.cmp(&Rational::zero());
        let (rational, multiple) = (of(&self.rational), of(&self.multiple));
        if rational == multiple || rational == Ordering::Equal {
            return multiple;
        }
        // The part of greater size decides.
        let first = &self.rational * &self.rational;
        let second = &self.multiple * &self.multiple * self.square();
        if first > second { rational } else { multiple }
    }

    /// The enclosure of this precision.
    pub(crate) fn ball(&self, bits: usize) -> Ball {
        let square = Ball::from_rational(&self.square(), bits);
        let root = square.sqrt().unwrap_or(square);
        Ball::from_rational(&self.rational, bits) + root.scaled(&self.multiple)
    }

    /// The rational numbers of which it is made.
    pub(crate) fn parts(&self) -> [Rational; 3] {
        [self.rational.clone(), self.multiple.clone(), self.square()]
    }
}

impl fmt::Display for Surd {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            rational,
            multiple,
            radicand,
        } = self;
        match (rational.is_zero(), multiple.is_negative()) {
            (true, _) => write!(f, "{multiple}*sqrt({radicand})"),
            (false, true) => write!(f, "{rational}-{}*sqrt({radicand})", multiple.abs()),
            (false, false) => write!(f, "{rational}+{multiple}*sqrt({radicand})"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_numbers::rational::ratio;

    fn root(n: i64, d: i64) -> Surd {
        let root = Exact::root(&ratio(n, d).unwrap());
        root.and_then(Exact::surd).unwrap()
    }

    #[test]
    fn roots_of_one_radicand_are_one_number() {
        let (two, eight, half) = (root(2, 1), root(8, 1), root(1, 2));
        assert_eq!(eight.to_string(), "2*sqrt(2)");
        assert_eq!(half.to_string(), "1/2*sqrt(2)");
        assert!(matches!(two.times(&eight), Some(Exact::Rational(q)) if q == integer(4)));
        assert!(two.plus(&root(3, 1)).is_none());
        let six = two.times(&root(3, 1)).and_then(Exact::surd).unwrap();
        assert_eq!(six.to_string(), "1*sqrt(6)");
        let twelve = root(6, 1).times(&two).and_then(Exact::surd).unwrap();
        assert_eq!(twelve.to_string(), "2*sqrt(3)");
        assert!(matches!(Exact::root(&integer(9)), Some(Exact::Rational(q)) if q == integer(3)));
        assert!(Exact::root(&integer(-2)).is_none());
    }

    #[test]
    fn signs_are_those_of_the_doubles_and_inverses_multiply_to_one() {
        for (a, b, n) in [
            (3, -2, 2),
            (-3, 2, 2),
            (1, 1, 5),
            (-7, 4, 3),
            (7, -4, 3),
            (0, -1, 7),
        ] {
            let Some(Exact::Surd(surd)) = root(n, 1)
                .times_rational(&integer(b))
                .surd()
                .map(|s| s.plus_rational(&integer(a)))
            else {
                unreachable!("the radicand is no square")
            };
            let value = a as f64 + b as f64 * (n as f64).sqrt();
            assert_eq!(Some(surd.sign()), value.partial_cmp(&0.0), "{surd}");
            let (low, high) = surd.ball(100).to_f64_bounds();
            assert!(low <= value + 1e-9 && value - 1e-9 <= high, "{surd}");
            let Exact::Surd(inverse) = surd.inverse() else {
                unreachable!("an inverse of a surd is one")
            };
            assert!(matches!(surd.times(&inverse), Some(Exact::Rational(q)) if q == integer(1)));
        }
    }

    impl Exact {
        fn surd(self) -> Option<Surd> {
            match self {
                Self::Surd(surd) => Some(surd),
                Self::Rational(_) => None,
            }
        }
    }
}
