//! Doubles as the exact numbers that they are.

use torse_algebra::{Ball, Integer, Rational};

/// The rational number that a finite f64 is; zero for NaN and infinities, which no object here holds.
///
/// ```
/// use torse_algebra::rational::ratio;
/// assert_eq!(Some(torse_geometry::exact(0.375)), ratio(3, 8));
/// assert_eq!(torse_geometry::exact(-0.1) + torse_geometry::exact(0.1), ratio(0, 1).unwrap());
/// ```
#[must_use]
pub fn exact(value: f64) -> Rational {
    if !value.is_finite() {
        return Rational::from_integer(Integer::ZERO);
    }
    let bits = value.to_bits();
    let exponent = (bits >> 52) & 0x7ff;
    let fraction = bits & ((1 << 52) - 1);
    let (mantissa, power) = if exponent == 0 {
        (fraction, 0)
    } else {
        (fraction | 1 << 52, exponent - 1)
    };
    let signed = if value.is_sign_negative() {
        -Integer::from(mantissa)
    } else {
        Integer::from(mantissa)
    };
    // value = mantissa * 2^(power - 1074)
    let power = usize::try_from(power).unwrap_or(0);
    match power.checked_sub(1074) {
        Some(up) => Rational::from_integer(signed << up),
        None => Rational::new(signed, Integer::ONE << (1074 - power)),
    }
}

/// Returns the middle of two rational numbers.
pub(crate) fn middle_of(from: &Rational, to: &Rational) -> Rational {
    (from.clone() + to.clone()) * Rational::new(1.into(), 2.into())
}

/// The ball of this precision around a finite f64, exact when `bits` is large enough (1074 always is).
#[must_use]
pub fn exact_ball(value: f64, bits: usize) -> Ball {
    Ball::from_rational(&exact(value), bits)
}
