//! Images of polynomials modulo a prime: fast upper bounds for degrees of common divisors.

use super::Polynomial;
use crate::mersenne::{PRIME, minus, plus, power, residue, times};
use crate::symbol::Symbol;

/// A fixed pseudo-random residue for the n-th symbol (a splitmix step).
fn number(n: usize) -> u64 {
    let mut z = (n as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    (z ^ (z >> 31)) % PRIME
}

/// The images of the polynomial in each of the `mains`, ascending, with the other symbols replaced by fixed numbers
/// that are the same for every polynomial (`all` lists the symbols that get numbers). Denominators are units and are
/// left out.
///
/// Each term is evaluated once, with the numbers of all symbols; then the power of the main symbol is divided out,
/// which is possible because no number is zero.
fn images(p: &Polynomial, mains: &[&Symbol], all: &[Symbol]) -> Vec<Vec<u64>> {
    let degrees = degrees(p);
    let values = p
        .symbols()
        .iter()
        .map(|symbol| all.binary_search(symbol).map_or(1, number));
    let values: Vec<u64> = values.collect();
    let powers = |(value, degree): (&u64, &u16)| powers_up_to(*value, *degree);
    let forth: Vec<Vec<u64>> = values.iter().zip(&degrees).map(powers).collect();
    let mut images = vec![];
    for main in mains {
        // A symbol that does not occur has no column, and its image is a constant.
        let column = p.symbols().binary_search(main).ok();
        let own = column.and_then(|c| Some((*values.get(c)?, *degrees.get(c)?)));
        let (value, degree) = own.unwrap_or((1, 0));
        let back = powers_up_to(power(value, PRIME - 2), degree);
        images.push((column, back, vec![0; usize::from(degree) + 1]));
    }
    for (row, coefficient) in p.rows().zip(&p.body.coefficients) {
        let mut term = residue(coefficient);
        for (exponent, powers) in row.iter().zip(&forth) {
            if *exponent > 0
                && let Some(power) = powers.get(usize::from(*exponent))
            {
                term = times(term, *power);
            }
        }
        for (column, back, image) in &mut images {
            let exponent = column.and_then(|c| row.get(c)).copied().unwrap_or(0);
            let exponent = usize::from(exponent);
            if let (Some(power), Some(slot)) = (back.get(exponent), image.get_mut(exponent)) {
                *slot = plus(*slot, times(term, *power));
            }
        }
    }
    images.into_iter().map(|(_, _, image)| image).collect()
}

/// The degree in each symbol, in their order.
fn degrees(p: &Polynomial) -> Vec<u16> {
    let mut degrees = vec![0; p.symbols().len()];
    for row in p.rows() {
        for (degree, exponent) in degrees.iter_mut().zip(row) {
            *degree = (*degree).max(*exponent);
        }
    }
    degrees
}

/// The powers of a residue: `1, value, ..., value^degree`.
fn powers_up_to(value: u64, degree: u16) -> Vec<u64> {
    let next = |power: &u64| Some(times(*power, value));
    let powers = std::iter::successors(Some(1), next);
    powers.take(usize::from(degree) + 1).collect()
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

/// Upper bounds for the degrees in `mains` of the gcd of two nonzero polynomials.
pub(super) fn gcd_degree_bounds(a: &Polynomial, b: &Polynomial, mains: &[&Symbol]) -> Vec<u16> {
    let all = super::add::common_symbols(a, b);
    let (images_a, images_b) = (images(a, mains, &all), images(b, mains, &all));
    let bound = |(image_a, image_b): (Vec<u64>, Vec<u64>)| {
        let trivial = u16::try_from(image_a.len().min(image_b.len()).saturating_sub(1));
        let trivial = trivial.unwrap_or(u16::MAX);
        // The bound is valid only if one of the leading coefficients does not vanish in the image.
        if image_a.last() == Some(&0) && image_b.last() == Some(&0) {
            return trivial;
        }
        u16::try_from(gcd_degree(image_a, image_b))
            .unwrap_or(trivial)
            .min(trivial)
    };
    images_a.into_iter().zip(images_b).map(bound).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rational::Integer;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn an_image_is_the_value_at_the_numbers_of_all_other_symbols(
            terms in proptest::collection::vec((-9..10_i64, 0..4_u32, 0..4_u32, 0..4_u32), 1..6),
        ) {
            let symbol = |name| Polynomial::named(name);
            let monomial = |&(c, i, j, k): &(i64, u32, u32, u32)| {
                let xy = &symbol("x").power(i) * &symbol("y").power(j);
                &(&Polynomial::integer(c) * &xy) * &symbol("z").power(k)
            };
            let p = terms.iter().map(monomial).fold(Polynomial::zero(), |sum, t| &sum + &t);
            prop_assume!(!p.is_zero());
            let all = ["x", "y", "z"].map(Symbol::named);
            let mains: Vec<&Symbol> = all.iter().collect();
            for (place, image) in images(&p, &mains, &all).into_iter().enumerate() {
                let mut naive = vec![0; image.len()];
                for &(c, i, j, k) in &terms {
                    let exponents = [i, j, k];
                    let others = (0..3).filter(|n| *n != place);
                    let values = others.map(|n| power(number(n), exponents[n].into()));
                    let term = values.fold(residue(&Integer::from(c)), times);
                    // A power that cancels leaves no term of its degree.
                    match naive.get_mut(exponents[place] as usize) {
                        Some(slot) => *slot = plus(*slot, term),
                        None => prop_assert!(terms.len() > 1),
                    }
                }
                prop_assert_eq!(image, naive);
            }
        }
    }
}
