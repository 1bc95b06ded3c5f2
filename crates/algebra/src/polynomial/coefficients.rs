//! Arithmetic of coefficients in a product of polynomials.
//!
//! The layout of the rows (`dense`, `sparse`) and the arithmetic of the coefficients are chosen independently. An
//! arithmetic is chosen only if a bound computed from the factors proves that no sum can overflow.

use crate::rational::Integer;
use dashu_int::ops::BitTest;

/// An arithmetic for sums of products.
pub(super) trait Coefficients {
    /// A coefficient of a factor.
    type Factor;
    /// A sum of products of two coefficients.
    type Sum: Clone;

    /// The empty sum.
    fn zero(&self) -> Self::Sum;
    /// Adds the product of `x` and `y`.
    fn add_product(&self, sum: &mut Self::Sum, x: &Self::Factor, y: &Self::Factor);
    /// Whether a sum is zero.
    fn is_zero(&self, sum: &Self::Sum) -> bool;
    /// The value of a sum.
    fn value(&self, sum: Self::Sum) -> Integer;
}

/// The largest number of bits of a coefficient.
fn bits(coefficients: &[Integer]) -> usize {
    coefficients.iter().map(BitTest::bit_len).max().unwrap_or(0)
}

/// A bound of the bits, without the sign, of every coefficient of the product: a coefficient is a sum of at most as
/// many products as the shorter factor has terms.
fn sum_bits(a: &[Integer], b: &[Integer]) -> usize {
    let collisions = usize::BITS - a.len().min(b.len()).leading_zeros();
    bits(a) + bits(b) + collisions as usize
}

/// Every coefficient as a machine integer, if all fit.
fn converted<'a, T: TryFrom<&'a Integer>>(coefficients: &'a [Integer]) -> Option<Vec<T>> {
    coefficients.iter().map(|c| T::try_from(c).ok()).collect()
}

/// One-word factors, two-word sums.
pub(super) struct Words;

impl Words {
    /// Converts the coefficients of the factors; `None` if a sum could overflow.
    pub(super) fn factors(a: &[Integer], b: &[Integer]) -> Option<(Vec<i64>, Vec<i64>)> {
        if sum_bits(a, b) > 127 {
            return None;
        }
        Some((converted(a)?, converted(b)?))
    }
}

impl Coefficients for Words {
    type Factor = i64;
    type Sum = i128;

    fn zero(&self) -> i128 {
        0
    }

    fn add_product(&self, sum: &mut i128, x: &i64, y: &i64) {
        *sum += i128::from(*x) * i128::from(*y);
    }

    fn is_zero(&self, sum: &i128) -> bool {
        *sum == 0
    }

    fn value(&self, sum: i128) -> Integer {
        Integer::from(sum)
    }
}

/// Two-word factors, four-word sums.
pub(super) struct DoubleWords;

/// An integer of 256 bits in two's complement.
#[derive(Clone, Copy)]
pub(super) struct FourWords {
    low: u128,
    high: i128,
}

impl DoubleWords {
    /// Converts the coefficients of the factors; `None` if a sum could overflow.
    pub(super) fn factors(a: &[Integer], b: &[Integer]) -> Option<(Vec<i128>, Vec<i128>)> {
        if sum_bits(a, b) > 255 {
            return None;
        }
        Some((converted(a)?, converted(b)?))
    }
}

impl Coefficients for DoubleWords {
    type Factor = i128;
    type Sum = FourWords;

    fn zero(&self) -> FourWords {
        FourWords { low: 0, high: 0 }
    }

    fn add_product(&self, sum: &mut FourWords, x: &i128, y: &i128) {
        let (low, high) = x.cast_unsigned().carrying_mul(y.cast_unsigned(), 0);
        // As an unsigned number, a negative factor is too large by 2^128.
        let excess = ((x >> 127) & y).wrapping_add((y >> 127) & x);
        let (low, carry) = sum.low.overflowing_add(low);
        sum.low = low;
        sum.high = sum
            .high
            .wrapping_add(high.cast_signed())
            .wrapping_sub(excess)
            .wrapping_add(i128::from(carry));
    }

    fn is_zero(&self, sum: &FourWords) -> bool {
        sum.low == 0 && sum.high == 0
    }

    fn value(&self, sum: FourWords) -> Integer {
        let mut bytes = [0; 32];
        let (low, high) = bytes.split_at_mut(16);
        low.copy_from_slice(&sum.low.to_le_bytes());
        high.copy_from_slice(&sum.high.to_le_bytes());
        Integer::from_le_bytes(&bytes)
    }
}

/// Integers of any size.
pub(super) struct Integers;

impl Coefficients for Integers {
    type Factor = Integer;
    type Sum = Integer;

    fn zero(&self) -> Integer {
        Integer::ZERO
    }

    fn add_product(&self, sum: &mut Integer, x: &Integer, y: &Integer) {
        *sum += x * y;
    }

    fn is_zero(&self, sum: &Integer) -> bool {
        sum.is_zero()
    }

    fn value(&self, sum: Integer) -> Integer {
        sum
    }
}
