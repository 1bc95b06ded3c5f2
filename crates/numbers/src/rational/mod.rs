//! The rational numbers, exact and with a correct order.
//!
//! [`Rational`] wraps `num_rational::Ratio` over `dashu_int::IBig`, whose arithmetic was measured to be 3 to 8 times
//! faster than that of `num-bigint`. The inner type is private because its order cannot be trusted: `Ratio` compares
//! through the floor of a quotient, and `dashu_int` (0.4 to 0.6.2) returns 0 instead of -1 for the floor of a
//! quotient between -1 and 0, because its truncated quotient 0 carries no sign. So `-1/2 > 0` holds for the inner
//! type, `floor`, `ceil` and `round` are wrong in the same way, and `==` and hashing recurse once for each step of
//! Euclid's algorithm. Its ring operations are correct, and only they are used here; this module implements order,
//! equality, hash and rounding itself.
//!
//! Both rest on one theorem: the form in lowest terms with a positive denominator is unique. Hence numbers are equal
//! if and only if their parts are, and `a/b < c/d` if and only if `a d < c b`.

mod machine;
mod operators;
mod order;
mod rounding;
mod size;
mod text;

pub(crate) use rounding::ceiling_quotient;
pub use rounding::{floor_quotient, remainder};
pub use text::RationalError;

use num_traits::{Signed, ToPrimitive, Zero};

/// Integers of any size.
///
/// Do not use the floor functions of `num_integer` on them: they are wrong for quotients between -1 and 0 (see the
/// [module](self)). For residues use [`remainder`].
pub type Integer = dashu_int::IBig;

#[allow(
    clippy::disallowed_types,
    reason = "the one place where the inner type has a name"
)]
type Inner = num_rational::Ratio<Integer>;

/// A rational number of any size, always in lowest terms with a positive denominator.
///
/// Implements the usual operators, by value and by reference; `num_traits` provides zero, one, signs and sums. The
/// order is that of the number line:
///
/// ```
/// use torse_numbers::rational::{integer, ratio};
/// let minus_half = ratio(-1, 2).unwrap();
/// assert!(minus_half < integer(0));
/// assert_eq!(minus_half.floor(), integer(-1));
/// assert_eq!(minus_half.clone().max(integer(-1)), minus_half);
/// ```
#[derive(Clone)]
pub struct Rational(Inner);

impl Rational {
    /// The number `numerator / denominator`, in lowest terms.
    ///
    /// # Panics
    /// When the denominator is zero, as the division of machine integers does. Where it may be zero use
    /// [`Rational::checked_new`].
    #[inline]
    #[must_use]
    pub fn new(numerator: Integer, denominator: Integer) -> Self {
        Self(Inner::new(numerator, denominator))
    }

    /// Returns the number `numerator / denominator` in lowest terms, or `None` if the denominator is zero.
    ///
    /// ```
    /// use torse_numbers::{Integer, Rational};
    /// assert_eq!(Rational::checked_new(Integer::ONE, Integer::ZERO), None);
    /// ```
    #[inline]
    #[must_use]
    pub fn checked_new(numerator: Integer, denominator: Integer) -> Option<Self> {
        (!denominator.is_zero()).then(|| Self::new(numerator, denominator))
    }

    /// Makes a number of parts that are in lowest terms already; the denominator is positive.
    #[inline]
    pub(crate) fn in_lowest_terms(numerator: Integer, denominator: Integer) -> Self {
        debug_assert!(denominator.is_positive());
        Self(Inner::new_raw(numerator, denominator))
    }

    /// An integer as a rational number.
    #[inline]
    #[must_use]
    pub fn from_integer(n: Integer) -> Self {
        Self(Inner::from_integer(n))
    }

    /// The numerator, which carries the sign.
    #[inline]
    #[must_use]
    pub fn numer(&self) -> &Integer {
        self.0.numer()
    }

    /// The denominator, positive.
    #[inline]
    #[must_use]
    pub fn denom(&self) -> &Integer {
        self.0.denom()
    }

    /// The numerator and the denominator.
    #[inline]
    #[must_use]
    pub fn into_parts(self) -> (Integer, Integer) {
        self.0.into_raw()
    }

    /// Whether the number is an integer.
    #[inline]
    #[must_use]
    pub fn is_integer(&self) -> bool {
        self.denom().is_one()
    }

    /// One over the number.
    ///
    /// # Panics
    /// When the number is zero; [`Scalar::divided_by`](crate::Scalar::divided_by) returns an error instead.
    #[inline]
    #[must_use]
    pub fn recip(&self) -> Self {
        Self(self.0.recip())
    }

    /// The power with an integer exponent; the zeroth power is one.
    ///
    /// # Panics
    /// When the number is zero and the exponent negative.
    #[inline]
    #[must_use]
    pub fn pow(&self, exponent: i32) -> Self {
        // Powers of numbers in lowest terms are in lowest terms.
        let size = exponent.unsigned_abs() as usize;
        let power = Self::in_lowest_terms(self.numer().pow(size), self.denom().pow(size));
        if exponent < 0 { power.recip() } else { power }
    }
}

impl Default for Rational {
    /// Zero.
    #[inline]
    fn default() -> Self {
        Self::zero()
    }
}

impl From<Integer> for Rational {
    #[inline]
    fn from(n: Integer) -> Self {
        Self::from_integer(n)
    }
}

impl From<i64> for Rational {
    #[inline]
    fn from(n: i64) -> Self {
        Self::from_integer(n.into())
    }
}

/// The rational number `numerator / denominator` of two machine integers.
///
/// Returns `None` when `denominator` is zero.
///
/// ```
/// use torse_numbers::rational::ratio;
/// assert_eq!(ratio(2, -4), ratio(-1, 2));
/// assert_eq!(ratio(1, 0), None);
/// ```
#[must_use]
pub fn ratio(numerator: i64, denominator: i64) -> Option<Rational> {
    Rational::checked_new(numerator.into(), denominator.into())
}

/// The integer `n` as a rational number.
#[must_use]
pub fn integer(n: i64) -> Rational {
    Rational::from(n)
}

/// Returns a double within a few units in the last place of `q`, finite for every rational in the range of doubles.
/// It is meant for display and as a starting point of searches; nothing may be decided by it.
///
/// ```
/// use torse_numbers::rational::{ratio, to_f64};
/// assert_eq!(ratio(1, 4).map(|q| to_f64(&q)), Some(0.25));
/// let least = ratio(1, 2).map(|half| to_f64(&half.pow(1022)));
/// assert_eq!(least, Some(f64::MIN_POSITIVE));
/// ```
#[must_use]
pub fn to_f64(q: &Rational) -> f64 {
    if q.is_zero() {
        return 0.0;
    }
    // Scale so that the integer quotient has at least 64 significant bits.
    let bits =
        |n: &Integer| i64::try_from(dashu_int::ops::BitTest::bit_len(n)).unwrap_or(i64::MAX / 4);
    let shift = 66 - (bits(q.numer()) - bits(q.denom()));
    let magnitude = q.numer().abs();
    let amount = usize::try_from(shift.unsigned_abs()).unwrap_or(usize::MAX / 64);
    let quotient = if shift >= 0 {
        (magnitude << amount) / q.denom()
    } else {
        magnitude / (q.denom().clone() << amount)
    };
    // In two steps: the power of two alone may be too small for a double although the product is not.
    let exponent = i32::try_from((-shift).clamp(-2200, 2200)).unwrap_or(0);
    let (first, second) = (exponent / 2, exponent - exponent / 2);
    let leading = ToPrimitive::to_f64(&quotient).unwrap_or(f64::INFINITY);
    let value = leading * f64::powi(2.0, first) * f64::powi(2.0, second);
    if q.is_negative() { -value } else { value }
}
