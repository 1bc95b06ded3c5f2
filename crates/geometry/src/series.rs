//! Truncated Taylor series as plain coefficient lists (index `n` holds `f^(n)(x) / n!`).
//!
//! Basis rows and ruling jets need only sums, products and quotients of short series over any
//! [`Coordinate`]; lists keep the coefficients next to each other and need no context.

use crate::coordinate::Coordinate;
use torse_algebra::ExactError;

/// The series of `sin(pi t/2)` and `cos(pi t/2)` at `t = x`: coefficient `n` is
/// `(pi/2)^n / n!` times `s, c, -s, -c` in turn (and `c, -s, -c, s`).
pub(crate) fn quarter_turn<S: Coordinate>(
    x: &S,
    order: usize,
) -> Result<(Vec<S>, Vec<S>), ExactError> {
    let (s, c) = x.turn()?;
    let (mut sine, mut cosine) = (vec![s.clone()], vec![c.clone()]);
    if order == 0 {
        return Ok((sine, cosine));
    }
    let half_pi = x.half_pi()?;
    let (mut ds, mut dc) = (s, c);
    for n in 1..=order {
        let step = half_pi.divided_by(&x.natural(n))?;
        // d/dt (sin, cos) = pi/2 (cos, -sin)
        (ds, dc) = (dc * step.clone(), -(ds * step));
        sine.push(ds.clone());
        cosine.push(dc.clone());
    }
    Ok((sine, cosine))
}

/// `1 - f`.
pub(crate) fn one_minus<S: Coordinate>(f: &[S]) -> Vec<S> {
    f.iter()
        .enumerate()
        .map(|(n, v)| {
            if n == 0 {
                v.one() - v.clone()
            } else {
                -v.clone()
            }
        })
        .collect()
}

/// `f g`, truncated to the shorter of both.
pub(crate) fn product<S: Coordinate>(f: &[S], g: &[S]) -> Vec<S> {
    let length = f.len().min(g.len());
    (0..length)
        .filter_map(|n| {
            f.iter()
                .zip(g.iter().take(n + 1).rev())
                .map(|(a, b)| a.clone() * b.clone())
                .reduce(|sum, term| sum + term)
        })
        .collect()
}

/// `f / g`, truncated to the shorter of both.
pub(crate) fn quotient<S: Coordinate>(f: &[S], g: &[S]) -> Result<Vec<S>, ExactError> {
    let mut result: Vec<S> = Vec::with_capacity(f.len().min(g.len()));
    let Some(lead) = g.first() else {
        return Ok(result);
    };
    for (n, (numerator, _)) in f.iter().zip(g).enumerate() {
        let known = result
            .iter()
            .zip(g.iter().skip(1).take(n).rev())
            .map(|(q, d)| q.clone() * d.clone())
            .reduce(|sum, term| sum + term);
        let rest = match known {
            Some(known) => numerator.clone() - known,
            None => numerator.clone(),
        };
        result.push(rest.divided_by(lead)?);
    }
    Ok(result)
}

/// `f + g`.
pub(crate) fn sum<S: Coordinate>(f: &[S], g: &[S]) -> Vec<S> {
    f.iter()
        .zip(g)
        .map(|(a, b)| a.clone() + b.clone())
        .collect()
}

/// `f - g`.
pub(crate) fn difference<S: Coordinate>(f: &[S], g: &[S]) -> Vec<S> {
    f.iter()
        .zip(g)
        .map(|(a, b)| a.clone() - b.clone())
        .collect()
}

/// `f'`, one coefficient shorter.
pub(crate) fn derivative<S: Coordinate>(f: &[S]) -> Vec<S> {
    f.iter()
        .enumerate()
        .skip(1)
        .map(|(n, v)| v.natural(n) * v.clone())
        .collect()
}

/// The vector product of two vector series.
pub(crate) fn cross<S: Coordinate>(a: &[Vec<S>; 3], b: &[Vec<S>; 3]) -> [Vec<S>; 3] {
    let minor = |i: usize, j: usize| difference(&product(&a[i], &b[j]), &product(&a[j], &b[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// The scalar product of two vector series.
pub(crate) fn dot<S: Coordinate>(a: &[Vec<S>; 3], b: &[Vec<S>; 3]) -> Vec<S> {
    let partial = sum(&product(&a[0], &b[0]), &product(&a[1], &b[1]));
    sum(&partial, &product(&a[2], &b[2]))
}

/// The derivatives `f, f', f'', ..` from the Taylor coefficients.
pub(crate) fn to_derivatives<S: Coordinate>(f: &mut [S]) {
    let Some(first) = f.first() else { return };
    let mut factorial = first.one();
    for (n, v) in f.iter_mut().enumerate().skip(2) {
        factorial = factorial * v.natural(n);
        *v = v.clone() * factorial.clone();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use torse_algebra::rational::{Rational, ratio};

    fn q(list: &[i64]) -> Vec<Rational> {
        list.iter().filter_map(|&n| ratio(n, 1)).collect()
    }

    #[test]
    fn a_quotient_times_its_divisor_is_the_dividend() {
        let (f, g) = (q(&[3, -1, 4, 1, -5]), q(&[2, 7, 1, 8, 2]));
        let h = quotient(&f, &g).unwrap();
        assert_eq!(product(&h, &g), f);
    }

    #[test]
    fn the_product_rule_holds_for_series() {
        let (f, g) = (q(&[3, -1, 4, 1, -5]), q(&[2, 7, 1, 8, 2]));
        let left = derivative(&product(&f, &g));
        let right = sum(&product(&derivative(&f), &g), &product(&f, &derivative(&g)));
        assert_eq!(left[..4], right[..4]);
    }

    #[test]
    fn the_turn_series_solves_its_differential_equation() {
        let (s, c) = quarter_turn(&0.3_f64, 6).unwrap();
        for (ds, c) in derivative(&s).iter().zip(&c) {
            assert!((ds - std::f64::consts::FRAC_PI_2 * c).abs() < 1e-14);
        }
    }
}
