//! Images of polynomials modulo a prime: fast upper bounds for degrees of common divisors.

use super::Polynomial;
use crate::rational::{Integer, remainder};
use crate::symbol::Symbol;

/// The Mersenne prime 2^61 - 1.
const PRIME: u64 = (1 << 61) - 1;

/// The residue of a number below 2^64: as 2^61 is 1, the high bits are added to the low ones.
fn folded(n: u64) -> u64 {
    let sum = (n & PRIME) + (n >> 61);
    if sum >= PRIME { sum - PRIME } else { sum }
}

/// The product of two residues.
#[allow(clippy::cast_possible_truncation)]
fn times(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b);
    // Below 2^122: both parts are below 2^61.
    folded((product as u64 & PRIME) + (product >> 61) as u64)
}

fn minus(a: u64, b: u64) -> u64 {
    if a >= b { a - b } else { a + PRIME - b }
}

fn power(base: u64, mut exponent: u64) -> u64 {
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

fn residue(n: &Integer) -> u64 {
    if let Ok(small) = i64::try_from(n) {
        let size = folded(small.unsigned_abs());
        return if small < 0 { minus(0, size) } else { size };
    }
    let modulus = Integer::from(PRIME);
    u64::try_from(remainder(n, &modulus)).unwrap_or(0)
}

/// A fixed pseudo-random residue for the n-th symbol (a splitmix step).
fn number(n: usize) -> u64 {
    let mut z = (n as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    (z ^ (z >> 31)) % PRIME
}

/// The polynomial in `main` alone, ascending, with the other symbols replaced by fixed numbers (the
/// same for every polynomial: `all` lists the symbols that get numbers). Denominators are units and
/// left out.
fn image(p: &Polynomial, main: &Symbol, all: &[Symbol]) -> Vec<u64> {
    // The powers of the number of each symbol, up to its degree; none for `main`.
    let powers = |symbol: &Symbol| {
        let value = match all.binary_search(symbol) {
            Ok(position) if symbol != main => number(position),
            _ => return vec![],
        };
        let degree = usize::from(p.degree_in(symbol));
        let next = |power: &u64| Some(times(*power, value));
        std::iter::successors(Some(1), next)
            .take(degree + 1)
            .collect()
    };
    let values: Vec<Vec<u64>> = p.symbols().iter().map(powers).collect();
    let mut result = vec![0; usize::from(p.degree_in(main)) + 1];
    for (row, coefficient) in p.rows().zip(&p.body.coefficients) {
        let mut term = residue(coefficient);
        let mut degree = 0;
        for (exponent, powers) in row.iter().zip(&values) {
            match powers.get(usize::from(*exponent)) {
                None => degree = usize::from(*exponent),
                Some(1) => {}
                Some(power) => term = times(term, *power),
            }
        }
        if let Some(slot) = result.get_mut(degree) {
            *slot = folded(*slot + term);
        }
    }
    result
}

fn trim(p: &mut Vec<u64>) {
    while p.last() == Some(&0) {
        p.pop();
    }
}

/// The degree of the gcd of two polynomials over the prime field.
fn gcd_degree(mut a: Vec<u64>, mut b: Vec<u64>) -> usize {
    trim(&mut a);
    trim(&mut b);
    while let Some(lead) = b.last().copied() {
        let inverse = power(lead, PRIME - 2);
        while a.len() >= b.len() {
            let factor = times(a.last().copied().unwrap_or(0), inverse);
            let shift = a.len() - b.len();
            for (slot, c) in a.iter_mut().skip(shift).zip(&b) {
                *slot = minus(*slot, times(factor, *c));
            }
            a.pop();
            trim(&mut a);
        }
        std::mem::swap(&mut a, &mut b);
    }
    a.len().saturating_sub(1)
}

/// An upper bound for the degree in `main` of the gcd of two nonzero polynomials.
pub(super) fn gcd_degree_bound(a: &Polynomial, b: &Polynomial, main: &Symbol) -> u16 {
    let all = super::add::common_symbols(a, b);
    let (image_a, image_b) = (image(a, main, &all), image(b, main, &all));
    let trivial = a.degree_in(main).min(b.degree_in(main));
    // The bound needs one leading coefficient that does not vanish in the image.
    if image_a.last() == Some(&0) && image_b.last() == Some(&0) {
        return trivial;
    }
    u16::try_from(gcd_degree(image_a, image_b))
        .unwrap_or(trivial)
        .min(trivial)
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
