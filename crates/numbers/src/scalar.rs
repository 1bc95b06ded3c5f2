//! One definition for all kinds of numbers.
//!
//! Bases, curves and plane families are written once over [`Scalar`] and run on `f64` (fast),
//! [`Rational`] (exact, where no transcendental number enters), balls (certified enclosures), jets
//! (derivatives) and exact fractions (identities). The trigonometric pair enters through one method,
//! [`Scalar::quarter_turn`], because every basis of this family uses sin(pi x/2) and cos(pi x/2).
//!
//! A scalar carries its own context: a ball its precision, a jet its order. Constants are therefore
//! made *like* an existing scalar with [`Scalar::constant`].

use crate::rational::{Rational, to_f64};
use num_traits::Zero;
use std::ops::{Add, Mul, Neg, Sub};

/// Why an exact or certified scalar could not carry out an operation.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ExactError {
    /// The divisor is zero, or is an enclosure that contains zero.
    #[error("division by zero (or by an enclosure that contains zero): {divisor}")]
    DivisionByZero {
        /// The divisor as text.
        divisor: String,
    },
    /// The sine and cosine of this quarter turn are not numbers of this kind.
    #[error("the sine and cosine of a quarter turn times {argument} are not exact here")]
    NoExactTurn {
        /// The argument as text.
        argument: String,
    },
    /// The result, or what it would be computed from, has too many binary digits.
    #[error("a number of {bits} binary digits is too large: at most {limit}")]
    TooLarge {
        /// The number of digits that the number has or may have.
        bits: usize,
        /// The largest number of digits allowed.
        limit: usize,
    },
    /// The exponential is not a number of this kind.
    #[error("the exponential of {argument} has no value here")]
    NoExponential {
        /// The exponent as text.
        argument: String,
    },
    /// The logarithm is not a number of this kind.
    #[error("the logarithm of {argument} has no value here")]
    NoLogarithm {
        /// The argument as text.
        argument: String,
    },
    /// The arc tangent is not a number of this kind.
    #[error("the arc tangent of {argument} has no value here")]
    NoArcTangent {
        /// The argument as text.
        argument: String,
    },
    /// The arc sine is not a number of this kind.
    #[error("the arc sine of {argument} has no value here")]
    NoArcSine {
        /// The argument as text.
        argument: String,
    },
    /// Pi is not a number of this kind.
    #[error("pi is not a number of this kind")]
    NoPi,
    /// A value that is not an integer form was substituted into an index.
    #[error("{value} cannot be substituted into the index of {member}")]
    NoIndex {
        /// The member of a family, as text.
        member: String,
        /// The substituted value, as text.
        value: String,
    },
    /// The square root is not a number of this kind.
    #[error("the square root of {radicand} does not exist here")]
    NoSquareRoot {
        /// The radicand as text.
        radicand: String,
    },
}

/// A commutative ring with partial division and the trigonometric pair of a quarter turn.
///
/// Implemented by `f64`, [`Rational`], [`Ball`](crate::Ball), `Jet` over any scalar, and `Fraction`. The ring
/// operators never fail; operations that may fail return a `Result`.
pub trait Scalar:
    Clone
    + std::fmt::Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
{
    /// The rational number `q` in the context of `self` (precision of a ball, order of a jet).
    #[must_use]
    fn constant(&self, q: &Rational) -> Self;

    /// Zero in the context of `self`.
    #[must_use]
    fn zero_like(&self) -> Self {
        self.constant(&Rational::zero())
    }

    /// One in the context of `self`.
    #[must_use]
    fn one_like(&self) -> Self {
        self.constant(&crate::rational::integer(1))
    }

    /// `self / divisor`.
    ///
    /// # Errors
    /// [`ExactError::DivisionByZero`] when the divisor is zero or its enclosure contains zero. `f64` refuses a zero
    /// divisor too, so that generic code never produces an infinity.
    fn divided_by(&self, divisor: &Self) -> Result<Self, ExactError>;

    /// `(sin(pi/2 * self), cos(pi/2 * self))`.
    ///
    /// # Errors
    /// [`ExactError::NoExactTurn`] where the pair is not a number of this kind: for rationals unless
    /// `self` is an integer, for fractions unless `self` is a plain variable or a multiple of 1/2.
    fn quarter_turn(&self) -> Result<(Self, Self), ExactError>;

    /// The number pi in the context of `self`. It enters when a quarter turn is differentiated.
    ///
    /// # Errors
    /// [`ExactError::NoPi`] where pi is not a number of this kind, as for rationals; the provided method returns this
    /// error.
    fn pi_like(&self) -> Result<Self, ExactError> {
        Err(ExactError::NoPi)
    }

    /// `self * q` for a rational `q`.
    #[must_use]
    fn scaled(&self, q: &Rational) -> Self {
        self.clone() * self.constant(q)
    }
}

impl Scalar for f64 {
    fn constant(&self, q: &Rational) -> Self {
        to_f64(q)
    }

    #[inline]
    fn divided_by(&self, divisor: &Self) -> Result<Self, ExactError> {
        if *divisor == 0.0 {
            return Err(ExactError::DivisionByZero {
                divisor: divisor.to_string(),
            });
        }
        Ok(self / divisor)
    }

    fn quarter_turn(&self) -> Result<(Self, Self), ExactError> {
        Ok(libm::sincos(self * std::f64::consts::FRAC_PI_2))
    }

    fn pi_like(&self) -> Result<Self, ExactError> {
        Ok(std::f64::consts::PI)
    }
}

impl Scalar for Rational {
    fn constant(&self, q: &Rational) -> Self {
        q.clone()
    }

    fn divided_by(&self, divisor: &Self) -> Result<Self, ExactError> {
        if divisor.is_zero() {
            return Err(ExactError::DivisionByZero {
                divisor: divisor.to_string(),
            });
        }
        Ok(self / divisor)
    }

    fn quarter_turn(&self) -> Result<(Self, Self), ExactError> {
        let no_exact_turn = || ExactError::NoExactTurn {
            argument: self.to_string(),
        };
        if !self.is_integer() {
            return Err(no_exact_turn());
        }
        let four = crate::Integer::from(4);
        let turns = crate::rational::remainder(self.numer(), &four);
        let quarter = u8::try_from(turns).map_err(|_| no_exact_turn())?;
        let number = crate::rational::integer;
        Ok(match quarter {
            0 => (number(0), number(1)),
            1 => (number(1), number(0)),
            2 => (number(0), number(-1)),
            _ => (number(-1), number(0)),
        })
    }
}

/// Tests whether a number is zero.
///
/// For an exact number exactly one of the two answers is yes. For an enclosure both may be no. Both are never yes.
pub trait ZeroTest {
    /// Whether the number is certainly zero.
    fn is_known_zero(&self) -> bool;

    /// Whether the number is certainly not zero.
    fn is_known_nonzero(&self) -> bool;
}

impl ZeroTest for f64 {
    fn is_known_zero(&self) -> bool {
        *self == 0.0
    }

    fn is_known_nonzero(&self) -> bool {
        self.abs() > 0.0
    }
}

impl ZeroTest for crate::Integer {
    fn is_known_zero(&self) -> bool {
        self.is_zero()
    }

    fn is_known_nonzero(&self) -> bool {
        !self.is_zero()
    }
}

impl ZeroTest for Rational {
    fn is_known_zero(&self) -> bool {
        self.is_zero()
    }

    fn is_known_nonzero(&self) -> bool {
        !self.is_zero()
    }
}
