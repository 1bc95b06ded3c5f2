//! Replays a proof by other means than those that found it.
//!
//! No tensors, no halving: each coefficient comes from the terms by the polar form (Ramshaw 1987). On
//! `[a, b]` the Bernstein coefficient `b_j` of degree `d` is the symmetric multiaffine form of the
//! polynomial at `d - j` arguments `a` and `j` arguments `b`, and that of `x^e` is the elementary symmetric
//! polynomial of degree `e` in these arguments, divided by `C(d, e)`.

use super::{BernsteinCertificate, Term, degrees_of};
use crate::positivity::{CertificateError, RationalBox};
use crate::rational::{Integer, Rational};
use num_traits::{One, Zero};

/// Checks that the certificate proves its claim about this polynomial on this box.
///
/// # Errors
/// [`CertificateError`] says what is wrong.
pub fn check_certificate(
    terms: &[Term],
    region: &RationalBox,
    certificate: &BernsteinCertificate,
) -> Result<(), CertificateError> {
    let degrees = degrees_of(terms, region)?;
    let pieces: Vec<&RationalBox> = certificate.leaves.iter().map(|leaf| &leaf.region).collect();
    if !region.is_filled_by(&pieces) {
        return Err(CertificateError::NotFilled {
            pieces: pieces.len(),
        });
    }
    for (piece, leaf) in certificate.leaves.iter().enumerate() {
        let stated = certificate.positivity.admits_number(&leaf.least);
        let least = least_coefficient(terms, &leaf.region, &degrees);
        if !stated || least.as_ref() != Some(&leaf.least) {
            return Err(CertificateError::PieceFails { piece });
        }
    }
    Ok(())
}

fn least_coefficient(terms: &[Term], region: &RationalBox, degrees: &[usize]) -> Option<Rational> {
    // polar[axis][j][e]: the polar form of x^e.
    let polar: Vec<Vec<Vec<Rational>>> = region
        .sides()
        .iter()
        .zip(degrees)
        .map(|(side, &d)| (0..=d).map(|j| polar_forms(side, d, j)).collect())
        .collect();
    let count: usize = degrees.iter().map(|d| d + 1).product();
    let coefficient = |place: usize| {
        let mut rest = place;
        let index: Vec<usize> = degrees
            .iter()
            .map(|d| {
                let index = rest % (d + 1);
                rest /= d + 1;
                index
            })
            .collect();
        terms.iter().fold(Rational::zero(), |sum, (exponents, c)| {
            let factors = polar.iter().zip(&index).zip(exponents);
            sum + factors.fold(c.clone(), |product, ((polar, &j), &e)| {
                product * &polar[j][e as usize]
            })
        })
    };
    (0..count).map(coefficient).min()
}

/// The polar forms of `1, x, ..., x^d` at `d - j` arguments `a` and `j` arguments `b`: the coefficients of
/// `(1 + a y)^(d-j) (1 + b y)^j`, divided by the binomials `C(d, e)`, those of `(1 + y)^d`.
fn polar_forms((a, b): &(Rational, Rational), d: usize, j: usize) -> Vec<Rational> {
    let arguments = || std::iter::repeat_n(a, d - j).chain(std::iter::repeat_n(b, j));
    let one = Rational::one();
    let symmetric = elementary(arguments());
    let binomials = elementary(std::iter::repeat_n(&one, d));
    symmetric
        .into_iter()
        .zip(binomials)
        .map(|(e, binomial)| e / binomial)
        .collect()
}

/// The elementary symmetric polynomials of the arguments, degree by degree.
fn elementary<'a>(arguments: impl Iterator<Item = &'a Rational>) -> Vec<Rational> {
    let mut coefficients = vec![Rational::from_integer(Integer::ONE)];
    for x in arguments {
        coefficients.push(Rational::zero());
        for i in (1..coefficients.len()).rev() {
            coefficients[i] = &coefficients[i] + x * &coefficients[i - 1];
        }
    }
    coefficients
}
