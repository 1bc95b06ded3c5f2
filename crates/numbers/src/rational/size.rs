//! Bounds on the size of numbers: results that would be too large are refused before they are computed.

use super::{Integer, Rational, RationalError};
use crate::scalar::ExactError;
use dashu_int::ops::BitTest;

impl Rational {
    /// The largest number of binary digits of a numerator or denominator that the checked operations return: about a
    /// million (315,653 decimal digits).
    pub const MAX_BITS: usize = 1 << 20;

    /// The longest decimal that [`Rational::from_decimal`] reads, in characters.
    pub const MAX_DECIMAL: usize = 315_000;

    /// The number of binary digits of the numerator or the denominator, whichever has more.
    ///
    /// ```
    /// use torse_numbers::rational::ratio;
    /// assert_eq!(ratio(-3, 16).map(|q| q.bits()), Some(5));
    /// ```
    #[must_use]
    pub fn bits(&self) -> usize {
        self.numer().bit_len().max(self.denom().bit_len())
    }

    /// The power with an integer exponent, if its size is within bounds.
    ///
    /// ```
    /// use torse_numbers::{ExactError, rational::integer};
    /// let tower = integer(9).checked_pow(200).and_then(|p| p.checked_pow(200));
    /// assert!(tower.as_ref().is_ok_and(|p| p.bits() == 126_798));
    /// let refused = tower.and_then(|p| p.checked_pow(200));
    /// assert!(matches!(refused, Err(ExactError::TooLarge { .. })));
    /// ```
    ///
    /// # Errors
    /// [`ExactError::TooLarge`] when the number of digits of the base times the exponent exceeds
    /// [`Rational::MAX_BITS`] (powers of 0, 1 and -1 are always computed);
    /// [`ExactError::DivisionByZero`] for a negative power of zero.
    pub fn checked_pow(&self, exponent: i32) -> Result<Self, ExactError> {
        let unit = self.is_integer() && self.bits() <= 1;
        if unit && self.numer().is_zero() && exponent < 0 {
            return Err(ExactError::DivisionByZero {
                divisor: self.to_string(),
            });
        }
        let size = usize::try_from(exponent.unsigned_abs()).unwrap_or(usize::MAX);
        let bits = self.bits().saturating_mul(size);
        if !unit && bits > Self::MAX_BITS {
            return Err(ExactError::TooLarge {
                bits,
                limit: Self::MAX_BITS,
            });
        }
        Ok(self.pow(exponent))
    }

    /// Returns the number if its size is within bounds: for chains of sums and products that may grow.
    ///
    /// # Errors
    /// [`ExactError::TooLarge`] when it has more than [`Rational::MAX_BITS`] binary digits.
    pub fn bounded(self) -> Result<Self, ExactError> {
        let (bits, limit) = (self.bits(), Self::MAX_BITS);
        if bits > limit {
            return Err(ExactError::TooLarge { bits, limit });
        }
        Ok(self)
    }

    /// Reads a decimal without sign and exponent, such as `12` or `0.125`.
    ///
    /// ```
    /// use torse_numbers::{Rational, rational::ratio};
    /// assert_eq!(Rational::from_decimal("0.125").ok(), ratio(1, 8));
    /// assert!(Rational::from_decimal(".5").is_err() && Rational::from_decimal("1e9").is_err());
    /// ```
    ///
    /// # Errors
    /// [`RationalError::TooLong`] beyond [`Rational::MAX_DECIMAL`] characters, before anything is computed;
    /// [`RationalError::NoInteger`] for a part that is not made of digits.
    pub fn from_decimal(text: &str) -> Result<Self, RationalError> {
        if text.len() > Self::MAX_DECIMAL {
            return Err(RationalError::TooLong {
                characters: text.len(),
                limit: Self::MAX_DECIMAL,
            });
        }
        let (whole, fraction) = text.split_once('.').unwrap_or((text, ""));
        let no_integer = |part: &str| RationalError::NoInteger {
            part: part.to_owned(),
        };
        for part in [whole, fraction] {
            if !part.bytes().all(|b| b.is_ascii_digit()) {
                return Err(no_integer(part));
            }
        }
        if whole.is_empty() || text.ends_with('.') {
            return Err(no_integer(text));
        }
        let digits = format!("{whole}{fraction}");
        let numerator: Integer = digits.parse().map_err(|_| no_integer(&digits))?;
        Ok(Self::new(numerator, Integer::from(10).pow(fraction.len())))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rational::{integer, ratio};

    #[test]
    fn powers_of_units_are_never_too_large() {
        for (base, power) in [(0, 0), (1, 1), (-1, -1)] {
            assert_eq!(integer(base).checked_pow(i32::MAX), Ok(integer(power)));
        }
        assert_eq!(integer(-1).checked_pow(i32::MIN), Ok(integer(1)));
        assert!(matches!(
            integer(0).checked_pow(-1),
            Err(ExactError::DivisionByZero { .. })
        ));
    }

    #[test]
    fn powers_within_bounds_are_powers() {
        let q = ratio(-3, 7).unwrap();
        for exponent in -9..=9 {
            assert_eq!(q.checked_pow(exponent), Ok(q.pow(exponent)));
        }
        let largest = integer(2).checked_pow(1 << 19).unwrap();
        assert_eq!(largest.bits(), (1 << 19) + 1);
        assert!(integer(2).checked_pow((1 << 19) + 1).is_err());
        assert!((&largest * &largest).bounded().is_err());
    }

    #[test]
    fn long_decimals_are_read_or_refused_at_once() {
        let longest = format!("0.{}", "7".repeat(Rational::MAX_DECIMAL - 2));
        let read = Rational::from_decimal(&longest).unwrap();
        assert!(read.bits() <= Rational::MAX_BITS);
        assert!(read < ratio(7, 9).unwrap() && read > ratio(777_777, 1_000_000).unwrap());
        assert!(matches!(
            Rational::from_decimal(&(longest + "7")),
            Err(RationalError::TooLong { .. })
        ));
    }
}
