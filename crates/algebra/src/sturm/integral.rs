//! Polynomials with integer coefficients, ascending, without trailing zeros; the empty list is zero.
//!
//! All results are correct up to a *positive* factor, which changes no sign.

use crate::rational::{Integer, Rational};
use num_integer::Integer as _;
use num_traits::Signed;
use std::cmp::Ordering;

/// A positive multiple of the polynomial with coprime integer coefficients.
pub(super) fn cleared(coefficients: &[Rational]) -> Vec<Integer> {
    let common = coefficients
        .iter()
        .fold(Integer::ONE, |lcm, c| lcm.lcm(c.denom()));
    primitive(
        coefficients
            .iter()
            .map(|c| c.numer() * (&common / c.denom()))
            .collect(),
    )
}

/// Divides by the greatest common divisor of the coefficients and drops trailing zeros.
fn primitive(mut polynomial: Vec<Integer>) -> Vec<Integer> {
    let length = polynomial
        .iter()
        .rposition(|c| !c.is_zero())
        .map_or(0, |last| last + 1);
    polynomial.truncate(length);
    let content = polynomial.iter().fold(Integer::ZERO, |gcd, c| {
        // A gcd of one stays one.
        if gcd.is_one() || c.is_zero() {
            gcd
        } else if gcd.is_zero() {
            c.abs()
        } else {
            gcd.gcd(c)
        }
    });
    if content > Integer::ONE {
        for c in &mut polynomial {
            *c = &*c / &content;
        }
    }
    polynomial
}

/// The derivative.
pub(super) fn derivative(polynomial: &[Integer]) -> Vec<Integer> {
    primitive(
        (1_u32..)
            .zip(polynomial.iter().skip(1))
            .map(|(k, c)| c * k)
            .collect(),
    )
}

/// A positive multiple of `-(a mod b)`, for nonzero `b`.
pub(super) fn negated_remainder(a: &[Integer], b: &[Integer]) -> Vec<Integer> {
    let Some((leading, lower)) = b.split_last() else {
        return Vec::new();
    };
    let mut rest = a.to_vec();
    while rest.len() >= b.len() {
        let Some(top) = rest.pop() else { break };
        // abs(leading) * rest - sign(leading) * top * x^shift * b, whose leading terms cancel.
        let shift = rest.len() - lower.len();
        let factor = if leading.is_negative() { -top } else { top };
        let scale = leading.abs();
        for c in &mut rest {
            *c = &*c * &scale;
        }
        for (c, d) in rest[shift..].iter_mut().zip(lower) {
            *c = &*c - &factor * d;
        }
        rest = primitive(rest);
    }
    rest.into_iter().map(|c| -c).collect()
}

/// A positive multiple of `a / b`, for a primitive divisor `b` of `a`. The quotient has integer coefficients (Gauss).
pub(super) fn exact_quotient(a: &[Integer], b: &[Integer]) -> Vec<Integer> {
    let Some((leading, lower)) = b.split_last() else {
        return a.to_vec();
    };
    let mut rest = a.to_vec();
    let mut quotient = Vec::new();
    while rest.len() >= b.len() {
        let Some(top) = rest.pop() else { break };
        let factor = top / leading;
        let shift = rest.len() - lower.len();
        for (c, d) in rest[shift..].iter_mut().zip(lower) {
            *c = &*c - &factor * d;
        }
        quotient.push(factor);
    }
    quotient.reverse();
    quotient
}

/// The sign at a rational point, from `denominator^degree * p(numerator/denominator)` by Horner's rule.
pub(super) fn sign_at(polynomial: &[Integer], x: &Rational) -> Ordering {
    let mut power = Integer::ONE;
    let mut sum = Integer::ZERO;
    for c in polynomial.iter().rev() {
        sum = sum * x.numer() + c * &power;
        power *= x.denom();
    }
    sum.cmp(&Integer::ZERO)
}

/// The sign at plus or minus infinity, on the side of `direction`.
pub(super) fn sign_at_infinity(polynomial: &[Integer], direction: Ordering) -> Ordering {
    let leading = polynomial
        .last()
        .map_or(Ordering::Equal, |c| c.cmp(&Integer::ZERO));
    let odd = polynomial.len().is_multiple_of(2);
    if odd && direction.is_lt() {
        leading.reverse()
    } else {
        leading
    }
}

/// A power of two that exceeds the absolute value of every root: `1 + max abs(c_i / c_n)` (Cauchy).
pub(super) fn root_bound(polynomial: &[Integer]) -> Rational {
    use dashu_int::ops::BitTest;
    let bits = |c: &Integer| c.bit_len();
    let largest = polynomial.iter().map(bits).max().unwrap_or(0);
    // abs(c_i / c_n) < 2^largest / 2^(leading - 1).
    let exponent = (largest + 1).saturating_sub(polynomial.last().map_or(0, bits));
    Rational::from_integer(Integer::ONE << (exponent + 1))
}
