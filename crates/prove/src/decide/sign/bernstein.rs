//! Bernstein coefficients on a part of the box, and what they tell.

use super::coordinates::{Coordinates, Region};
use crate::decide::domain::truth;
use std::collections::BTreeMap;
use torse_algebra::planted::{Planted, planted};
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Polynomial, Rational, Symbol};
use torse_language::syntax::Relation;

/// The most Bernstein coefficients computed.
const MAX_PIECES: usize = 20_000;

/// `Some(true)` if the coefficients show the polynomial to be positive on the region, `Some(false)` for
/// nonnegative, `None` if they do not tell.
///
/// A polynomial with nonnegative coefficients is positive if on every face of the region that belongs to
/// the domain some coefficient is positive: the Bernstein polynomials of a face are positive inside it.
pub fn sign(polynomial: &Polynomial, coordinates: &Coordinates, region: &Region) -> Option<bool> {
    let mut pieces = vec![polynomial.clone()];
    let mut faces: Vec<Vec<Face>> = vec![];
    let ends = coordinates.closed_ends(region);
    for ((side, place), (lower, upper)) in coordinates.sides.iter().zip(region).zip(ends) {
        let (count, split) = split(&pieces, &side.symbol, place);
        pieces = split;
        if pieces.len() > MAX_PIECES {
            return None;
        }
        let face = |first, last| Face { first, last };
        let low = lower.then(|| face(0, 1));
        let high = upper.then(|| face(count - 1, count));
        faces.push(
            [Some(face(0, count)), low, high]
                .into_iter()
                .flatten()
                .collect(),
        );
    }
    let mut positive = vec![];
    for piece in &pieces {
        let sign = ray_sign(piece)?;
        if !sign.nonnegative {
            return None;
        }
        positive.push(if coordinates.rays_open {
            sign.somewhere
        } else {
            sign.constant
        });
    }
    Some(every_face_positive(&positive, &faces) || planted(Planted::ZeroTakenForPositive))
}

/// A range of Bernstein indices of one coordinate.
#[derive(Clone, Copy)]
struct Face {
    first: usize,
    last: usize,
}

/// Whether every choice of one face a coordinate contains a positive entry. The entries are in row-major
/// order: the last coordinate varies fastest.
fn every_face_positive(positive: &[bool], faces: &[Vec<Face>]) -> bool {
    let Some((own, rest)) = faces.split_first() else {
        return positive.first().copied().unwrap_or(false);
    };
    let count = own.first().map_or(1, |face| face.last).max(1);
    let stride = positive.len() / count;
    own.iter().all(|face| {
        let merged: Vec<bool> = (0..stride)
            .map(|offset| {
                (face.first..face.last).any(|i| positive.get(i * stride + offset) == Some(&true))
            })
            .collect();
        every_face_positive(&merged, rest)
    })
}

/// Every piece in the Bernstein form of one coordinate on an interval, all of the same degree: the number
/// of coefficients of a piece, and all of them.
fn split(
    pieces: &[Polynomial],
    symbol: &Symbol,
    (low, high): &(Rational, Rational),
) -> (usize, Vec<Polynomial>) {
    let t = Polynomial::symbol(symbol.clone());
    let moved = &Polynomial::constant(low) + &t.scaled(&(high - low));
    let unmoved = *low == integer(0) && *high == integer(1);
    let degrees = pieces.iter().map(|p| usize::from(p.degree_in(symbol)));
    let degree = degrees.max().unwrap_or(0);
    let mut result = vec![];
    for piece in pieces {
        let coefficients = if unmoved {
            piece.coefficients_in(symbol)
        } else {
            piece
                .substituted(|s| (s == symbol).then(|| moved.clone()))
                .coefficients_in(symbol)
        };
        for j in 0..=degree {
            // b_j = sum over i <= j of binom(j, i) / binom(degree, i) c_i
            let terms = coefficients.iter().take(j + 1).enumerate();
            result.push(terms.fold(Polynomial::zero(), |sum, (i, c)| {
                &sum + &c.scaled(&(binomial(j, i) / binomial(degree, i)))
            }));
        }
    }
    (degree + 1, result)
}

fn binomial(n: usize, k: usize) -> Rational {
    (0..k).fold(integer(1), |product, i| {
        let (top, below) = (
            i64::try_from(n - i).unwrap_or(i64::MAX),
            i64::try_from(i + 1).unwrap_or(i64::MAX),
        );
        product * integer(top) / integer(below)
    })
}

/// What the coefficients of a polynomial in nonnegative symbols, pi and roots tell.
struct RaySign {
    /// Every coefficient is nonnegative.
    nonnegative: bool,
    /// The constant one is positive.
    constant: bool,
    /// Some coefficient is positive.
    somewhere: bool,
}

fn ray_sign(polynomial: &Polynomial) -> Option<RaySign> {
    // Group by the powers of the nonnegative symbols; the coefficients are numbers.
    let mut groups: BTreeMap<Polynomial, Polynomial> = BTreeMap::new();
    for term in polynomial.terms() {
        let (mut powers, mut number) = (
            Polynomial::integer(1),
            Polynomial::constant(&term.coefficient),
        );
        for (symbol, exponent) in term.powers {
            let power = Polynomial::symbol(symbol.clone()).power(u32::from(exponent));
            if matches!(symbol, Symbol::Pi | Symbol::Root(_)) {
                number = &number * &power;
            } else {
                powers = &powers * &power;
            }
        }
        let entry = groups.entry(powers).or_insert_with(Polynomial::zero);
        *entry = &*entry + &number;
    }
    let mut sign = RaySign {
        nonnegative: true,
        constant: false,
        somewhere: false,
    };
    for (powers, number) in groups {
        let number = Fraction::from(number);
        sign.nonnegative &= truth(&number, Relation::AtLeast)?;
        let positive = truth(&number, Relation::Greater)?;
        sign.somewhere |= positive;
        sign.constant |= positive && powers.is_one();
    }
    Some(sign)
}
