//! The field of residues modulo the Mersenne prime `2^61 - 1`.

use crate::rational::{Integer, remainder};

/// The Mersenne prime 2^61 - 1.
pub const PRIME: u64 = (1 << 61) - 1;

/// Reduces a number below 2^64: since 2^61 is congruent to 1, the high bits are added to the low bits.
pub(crate) fn folded(n: u64) -> u64 {
    let sum = (n & PRIME) + (n >> 61);
    if sum >= PRIME { sum - PRIME } else { sum }
}

/// The sum of two residues.
#[must_use]
pub fn plus(a: u64, b: u64) -> u64 {
    folded(a + b)
}

/// The product of two residues.
#[must_use]
#[allow(clippy::cast_possible_truncation)]
pub fn times(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b);
    // The product is below 2^122, so both parts are below 2^61.
    folded((product as u64 & PRIME) + (product >> 61) as u64)
}

/// The difference of two residues.
#[must_use]
pub fn minus(a: u64, b: u64) -> u64 {
    if a >= b { a - b } else { a + PRIME - b }
}

/// The power of a residue.
#[must_use]
pub fn power(base: u64, mut exponent: u64) -> u64 {
    let (mut result, mut base) = (1, base);
    while exponent > 0 {
        if exponent % 2 == 1 {
            result = times(result, base);
        }
        base = times(base, base);
        exponent /= 2;
    }
    result
}

/// The inverse of a residue, by Fermat's theorem; `None` for zero.
#[must_use]
pub fn inverse(a: u64) -> Option<u64> {
    (a != 0).then(|| power(a, PRIME - 2))
}

/// The residue of an integer.
#[must_use]
pub fn residue(n: &Integer) -> u64 {
    if let Ok(small) = i64::try_from(n) {
        let size = folded(small.unsigned_abs());
        return if small < 0 { minus(0, size) } else { size };
    }
    let modulus = Integer::from(PRIME);
    u64::try_from(remainder(n, &modulus)).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn folding_gives_the_remainder(a in 0..PRIME, b in 0..PRIME, n in any::<u64>(), z in any::<i64>()) {
            let remainder_of = |n: u128| n % u128::from(PRIME);
            prop_assert_eq!(u128::from(folded(n)), remainder_of(n.into()));
            prop_assert_eq!(u128::from(times(a, b)), remainder_of(u128::from(a) * u128::from(b)));
            let far = Integer::from(z) + Integer::from(PRIME) * Integer::from(PRIME);
            prop_assert_eq!(residue(&Integer::from(z)), residue(&far));
        }
    }
}
