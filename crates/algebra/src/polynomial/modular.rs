//! Images of polynomials modulo a prime: fast upper bounds for degrees of common divisors.

use super::Polynomial;
use crate::rational::{Integer, remainder};
use crate::symbol::Symbol;

/// The Mersenne prime 2^61 - 1.
const PRIME: u64 = (1 << 61) - 1;

fn times(a: u64, b: u64) -> u64 {
    // Below 2^61, so the remainder fits.
    u64::try_from(u128::from(a) * u128::from(b) % u128::from(PRIME)).unwrap_or(0)
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
    let values: Vec<Option<u64>> = p
        .symbols()
        .iter()
        .map(|s| {
            if s == main {
                None
            } else {
                all.binary_search(s).ok().map(number)
            }
        })
        .collect();
    let mut result = vec![0; usize::from(p.degree_in(main)) + 1];
    for (row, coefficient) in p.rows().zip(&p.coefficients) {
        let mut term = residue(coefficient);
        let mut degree = 0;
        for (exponent, value) in row.iter().zip(&values) {
            match value {
                None => degree = usize::from(*exponent),
                Some(value) => term = times(term, power(*value, u64::from(*exponent))),
            }
        }
        if let Some(slot) = result.get_mut(degree) {
            *slot = (*slot + term) % PRIME;
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
