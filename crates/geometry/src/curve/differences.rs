//! Taylor coefficients of Bezier curves of high degree, from the differences of their control points:
//!
//! ```text
//! G^(m)(x)/m! = C(k, m) sum_i B[i,k-m](x) D^m R[i],     B[i,d](x) = C(d, i) x^i (1-x)^(d-i).
//! ```
//!
//! A point takes `3 k` products, where the recursion of the basis takes `k^2`; and of a wide enclosure of `x` the
//! derivatives are as wide as the differences make them, not as the control points themselves.

use crate::coordinate::Coordinate;
use crate::error::Result;
use crate::vector::{blended, scale, sub};
use std::ops::RangeInclusive;
use torse_algebra::{Integer, Rational};

/// The degrees that are worth it, and whose binomial coefficients stay below `2^63`.
pub(super) const DEGREES: RangeInclusive<usize> = 9..=64;

/// Doubles hold natural numbers up to this one.
const HELD: u128 = 1 << 53;

/// The binomial coefficient `C(n, k)`, like `x`.
fn binomial<S: Coordinate>(x: &S, n: usize, k: usize) -> S {
    let wide = |n: usize| u128::try_from(n).unwrap_or(u128::MAX);
    let value = (1..=k).fold(1_u128, |c, i| c * wide(n + 1 - i) / wide(i));
    match usize::try_from(value) {
        Ok(small) if value <= HELD => x.natural(small),
        // Also what 32 bits do not hold.
        _ => x.constant(&Rational::from_integer(Integer::from(value))),
    }
}

/// `1, x, .., x^degree`.
fn powers<S: Coordinate>(x: &S, degree: usize) -> Vec<S> {
    std::iter::successors(Some(x.one()), |power| Some(power.clone() * x.clone()))
        .take(degree + 1)
        .collect()
}

/// The Taylor coefficients at `x` of the Bezier curve with these control points.
pub(super) fn series<S: Coordinate, const D: usize>(
    points: &[[S; D]],
    x: &S,
    order: usize,
) -> Result<Vec<[S; D]>> {
    crate::coordinate::check_finite("curve parameter", [x])?;
    let degree = points.len().saturating_sub(1);
    let (up, down) = (powers(x, degree), powers(&(x.one() - x.clone()), degree));
    let mut differences = points.to_vec();
    let mut coefficients = Vec::with_capacity(order.saturating_add(1));
    for m in 0..=order {
        if differences.is_empty() {
            coefficients.push(std::array::from_fn(|_| x.zero()));
            continue;
        }
        let lower = differences.len() - 1;
        let pairs = up.iter().zip(down.iter().take(lower + 1).rev()).enumerate();
        let row: Vec<S> = pairs
            .map(|(i, (a, b))| binomial(x, lower, i) * (a.clone() * b.clone()))
            .collect();
        let point = blended(&row, &differences)?;
        coefficients.push(scale(&binomial(x, degree, m), &point));
        let steps = differences.iter().zip(differences.iter().skip(1));
        differences = steps.map(|(a, b)| sub(b, a)).collect();
    }
    Ok(coefficients)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::basis::{Basis, Bernstein};
    use torse_algebra::rational::{integer, ratio};

    #[test]
    fn differences_and_the_recursion_of_the_basis_give_the_same_numbers() {
        for degree in [9_i64, 22, 64] {
            let points: Vec<[Rational; 1]> = (0..=degree)
                .map(|k| [ratio(k * k * (k % 5 - 2), 7).unwrap_or_default()])
                .collect();
            let x = ratio(3, 11).unwrap_or_default();
            let found = series(&points, &x, 3).unwrap();
            let rows = Bernstein.series_rows(points.len() - 1, &x, 3).unwrap();
            for (found, row) in found.iter().zip(&rows) {
                assert_eq!(*found, blended(row, &points).unwrap());
            }
        }
    }

    #[test]
    fn a_power_has_its_own_derivatives() {
        // x^12 has the control points 0, .., 0, 1; its derivatives at 1/2 are 12 11 .. / 2^(12-m).
        let mut points = vec![[integer(0)]; 13];
        points[12] = [integer(1)];
        let half = ratio(1, 2).unwrap_or_default();
        let found = series(&points, &half, 14).unwrap();
        assert_eq!(found[0], [ratio(1, 4096).unwrap_or_default()]);
        assert_eq!(found[2], [ratio(66, 1024).unwrap_or_default()]);
        assert_eq!(found[12], [integer(1)]);
        assert_eq!(found[14], [integer(0)]);
    }
}
