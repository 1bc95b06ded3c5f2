//! What geometry asks of a scalar beyond the ring operations: whether it is finite, and its sign as
//! far as it is known.
//!
//! The papers' ranges ("mu in [-1, 1]", "gamma > 0") are checked once, at the door, for every kind of
//! scalar: a value is refused when it *provably* violates its range. A formal parameter or a ball
//! that straddles the bound has no known sign and passes; the answer is then an identity or an
//! enclosure and carries its own conditions.

use std::cmp::Ordering;
use torse_algebra::{
    Ball, ExactError, Fraction, Integer, Jet, Rational, Scalar, Symbol, rational::to_f64,
};

use crate::error::{GeometryError, Result};

/// A scalar that can be a coordinate, a weight or a shape parameter.
pub trait Coordinate: Scalar + Send + Sync {
    /// `false` for NaN and infinities.
    #[must_use]
    fn is_finite(&self) -> bool {
        true
    }

    /// The order relation to zero, or `None` where it is not known (formal symbols, balls that
    /// contain zero, NaN).
    #[must_use]
    fn sign(&self) -> Option<Ordering>;

    /// The nearest f64, the middle of a ball, the value of a jet; NaN for an expression that is no number.
    /// For messages and plots: nothing is decided by it.
    #[must_use]
    fn approximate(&self) -> f64;

    /// The `e` with `2^e <= |self| < 2^(e+1)` where the scalar has a range that can be left (f64, also
    /// denormal); `None` for zero, for what is not finite, and for scalars of any size.
    #[must_use]
    fn exponent(&self) -> Option<i32> {
        None
    }

    /// `self * 2^power`, exact unless it leaves the range or the precision of the scalar.
    #[must_use]
    fn times_two_to(&self, power: i32) -> Self {
        let size = Integer::ONE << usize::try_from(power.unsigned_abs()).unwrap_or(usize::MAX);
        let (above, below) = if power >= 0 {
            (size, Integer::ONE)
        } else {
            (Integer::ONE, size)
        };
        self.scaled(&Rational::new(above, below))
    }

    /// Half of pi in the context of `self`: what differentiating a quarter turn brings in.
    ///
    /// # Errors
    /// [`ExactError::NoPi`] where pi is not a number of this kind (rationals).
    fn half_pi(&self) -> Result<Self, ExactError> {
        self.pi_like()?.divided_by(&self.natural(2))
    }

    /// The absolute value where rounding can occur, otherwise the number itself; only for
    /// [`Coordinate::cancels`].
    #[must_use]
    fn magnitude(&self) -> Self {
        self.clone()
    }

    /// Whether this sum of products cannot be told from zero, given the sum of the absolute values of
    /// its terms: exactly zero on exact scalars, within the rounding of the evaluation on f64.
    #[must_use]
    fn cancels(&self, _magnitude: &Self) -> bool {
        self.sign() == Some(Ordering::Equal)
    }

    /// `(sin(pi/2 * self), cos(pi/2 * self))`, exact at the ends 0 and 1 of the unit interval on every
    /// scalar, so that curves end in their last control point. On f64 the unit interval has a kernel of
    /// its own, with the same bits on every machine.
    ///
    /// # Errors
    /// As [`Scalar::quarter_turn`].
    fn turn(&self) -> Result<(Self, Self), ExactError> {
        self.quarter_turn()
    }

    /// [`Coordinate::turn`] of all `xs` into `sines` and `cosines`, as far as the three reach.
    ///
    /// # Errors
    /// As [`Coordinate::turn`].
    fn turns(xs: &[Self], sines: &mut [Self], cosines: &mut [Self]) -> Result<(), ExactError> {
        for ((x, sine), cosine) in xs.iter().zip(sines).zip(cosines) {
            (*sine, *cosine) = x.turn()?;
        }
        Ok(())
    }

    /// For an enclosure much wider than rounding, its centre and what is left, `self = centre + rest`: curves
    /// then expand about the centre, because the width of their direct evaluation would count `x` and
    /// `1 - x` as if they were independent. `None` for a number.
    #[must_use]
    fn centred(&self) -> Option<(Self, Self)> {
        None
    }

    /// Zero like `self`; the same as [`Scalar::zero_like`], without the detour through rationals
    /// where speed matters.
    #[must_use]
    fn zero(&self) -> Self {
        self.zero_like()
    }

    /// One like `self`; see [`Coordinate::zero`].
    #[must_use]
    fn one(&self) -> Self {
        self.one_like()
    }

    /// A small natural number like `self`.
    #[must_use]
    fn natural(&self, n: usize) -> Self {
        self.constant(&Rational::from_integer(n.into()))
    }
}

impl Coordinate for f64 {
    fn is_finite(&self) -> bool {
        f64::is_finite(*self)
    }

    fn sign(&self) -> Option<Ordering> {
        self.partial_cmp(&0.0)
    }

    fn approximate(&self) -> f64 {
        *self
    }

    fn exponent(&self) -> Option<i32> {
        let field = |x: f64| i32::try_from(x.to_bits() >> 52 & 0x7ff).unwrap_or(0) - 1023;
        match field(*self) {
            1024 => None,
            -1023 if *self == 0.0 => None,
            // Denormal: into the normal range first.
            -1023 => Some(field(self * f64::powi(2.0, 64)) - 64),
            e => Some(e),
        }
    }

    #[inline(always)]
    fn times_two_to(&self, power: i32) -> Self {
        let [first, second, third] = powers_of_two(power);
        self * first * second * third
    }

    fn half_pi(&self) -> Result<Self, ExactError> {
        Ok(std::f64::consts::FRAC_PI_2)
    }

    fn magnitude(&self) -> Self {
        self.abs()
    }

    /// Sums of at most eight products of at most four factors: each term carries at most eight roundings.
    fn cancels(&self, magnitude: &Self) -> bool {
        self.abs() <= 8.0 * f64::EPSILON * magnitude
    }

    #[inline]
    fn turn(&self) -> Result<(Self, Self), ExactError> {
        if (0.0..=1.0).contains(self) {
            return Ok(crate::turn::of_unit(*self));
        }
        Ok(libm::sincos(std::f64::consts::FRAC_PI_2 * self))
    }

    #[inline(always)]
    fn turns(xs: &[f64], sines: &mut [f64], cosines: &mut [f64]) -> Result<(), ExactError> {
        let each = xs.iter().zip(sines).zip(cosines);
        let inside = |x: &f64| (*x >= 0.0) & (*x <= 1.0);
        if xs.iter().fold(true, |all, x| all & inside(x)) {
            // Without a branch inside, the loop runs on vector registers.
            for ((x, sine), cosine) in each {
                (*sine, *cosine) = crate::turn::of_unit(*x);
            }
        } else {
            for ((x, sine), cosine) in each {
                (*sine, *cosine) = x.turn()?;
            }
        }
        Ok(())
    }

    fn zero(&self) -> Self {
        0.0
    }

    fn one(&self) -> Self {
        1.0
    }

    #[allow(clippy::cast_precision_loss)]
    fn natural(&self, n: usize) -> Self {
        n as f64
    }
}

/// Three normal numbers whose product is `2^power`, from end to end of the range of f64.
#[inline(always)]
pub(crate) fn powers_of_two(power: i32) -> [f64; 3] {
    let (first, rest) = (power.clamp(-700, 700), power - power.clamp(-700, 700));
    let (second, third) = (rest.clamp(-700, 700), rest - rest.clamp(-700, 700));
    [first, second, third.clamp(-1000, 1000)]
        .map(|e| f64::from_bits(u64::from((e + 1023).unsigned_abs()) << 52))
}

impl Coordinate for Rational {
    fn sign(&self) -> Option<Ordering> {
        Some(self.numer().cmp(&Integer::ZERO))
    }

    fn approximate(&self) -> f64 {
        to_f64(self)
    }
}

impl Coordinate for Fraction {
    fn sign(&self) -> Option<Ordering> {
        if self.is_zero() {
            return Some(Ordering::Equal);
        }
        self.as_rational().and_then(|q| q.sign())
    }

    fn approximate(&self) -> f64 {
        if self.is_zero() {
            return 0.0;
        }
        self.as_rational().map_or(f64::NAN, |q| q.approximate())
    }

    fn half_pi(&self) -> Result<Self, ExactError> {
        Self::symbol(Symbol::Pi).divided_by(&self.natural(2))
    }
}

impl Coordinate for Ball {
    fn sign(&self) -> Option<Ordering> {
        Ball::sign(self)
    }

    fn approximate(&self) -> f64 {
        to_f64(&self.midpoint())
    }

    fn centred(&self) -> Option<(Self, Self)> {
        let rounding = Rational::new(Integer::ONE, Integer::ONE << (self.bits() / 2));
        let wide = self.width() > rounding;
        let centre = Self::from_rational(&self.midpoint(), self.bits());
        wide.then(|| (centre.clone(), self - &centre))
    }
}

/// A jet has the sign of its value, and is zero when all its coefficients are.
impl<S: Coordinate> Coordinate for Jet<S> {
    fn is_finite(&self) -> bool {
        self.coefficients().iter().all(Coordinate::is_finite)
    }

    fn sign(&self) -> Option<Ordering> {
        match self.value().sign()? {
            Ordering::Equal => self
                .coefficients()
                .iter()
                .all(is_zero)
                .then_some(Ordering::Equal),
            sign => Some(sign),
        }
    }

    fn approximate(&self) -> f64 {
        self.value().approximate()
    }
}

/// Refuses NaN and infinities.
pub(crate) fn check_finite<'a, S: Coordinate + 'a>(
    what: &'static str,
    values: impl IntoIterator<Item = &'a S>,
) -> Result<()> {
    for (index, value) in values.into_iter().enumerate() {
        if !value.is_finite() {
            return Err(GeometryError::NotFinite {
                what,
                index,
                value: value.approximate(),
            });
        }
    }
    Ok(())
}

/// Refuses what is not finite or provably not positive.
pub(crate) fn check_positive<S: Coordinate>(name: &'static str, value: &S) -> Result<()> {
    check_finite(name, [value])?;
    match value.sign() {
        Some(Ordering::Less | Ordering::Equal) => Err(GeometryError::OutOfRange {
            name,
            value: value.approximate(),
            range: "(0, infinity)",
        }),
        _ => Ok(()),
    }
}

/// Refuses what is not finite or provably outside [-1, 1].
pub(crate) fn check_shape<S: Coordinate>(name: &'static str, value: &S) -> Result<()> {
    check_finite(name, [value])?;
    let one = value.one();
    let above = (value.clone() - one.clone()).sign() == Some(Ordering::Greater);
    let below = (value.clone() + one).sign() == Some(Ordering::Less);
    if above || below {
        return Err(GeometryError::OutOfRange {
            name,
            value: value.approximate(),
            range: "[-1, 1]",
        });
    }
    Ok(())
}

/// Whether a value is known to be exactly zero.
pub(crate) fn is_zero<S: Coordinate>(value: &S) -> bool {
    value.sign() == Some(Ordering::Equal)
}
