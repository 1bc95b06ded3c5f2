//! Signs of polynomials that are linear in the square of a symbol between two numbers: `1 - b^2 sin^2(x - y)` for b in (-1, 1).

use super::certificate::{Certificate, Piece, Reason};
use super::proof::{Proof, Shown};
use super::{Sign, without_equations};
use crate::decide::domain::Domain;
use crate::roots::square::root_of;
use num_traits::Signed;
use torse_algebra::rational::integer;
use torse_algebra::{Polynomial, Rational, Symbol};

/// The longest polynomial that is looked at.
const MAX_TERMS: usize = 30;

/// A sign of the polynomial, if it is linear in a square and has one where that is smallest and where it is largest.
pub(super) fn proof(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<(Sign, Proof)> {
    if polynomial.len() > MAX_TERMS || !domain.part.is_empty() {
        return None;
    }
    let mut symbols = polynomial.symbols().iter();
    symbols.find_map(|symbol| {
        let found = in_square_of(symbol, polynomial, domain);
        found.or_else(|| {
            let (sign, proof) = in_square_of(symbol, &-polynomial, domain)?;
            Some((sign.negated(), proof))
        })
    })
}

fn in_square_of(
    symbol: &Symbol,
    polynomial: &Polynomial,
    domain: &Domain<'_>,
) -> Option<(Sign, Proof)> {
    let coefficients = polynomial.coefficients_in(symbol);
    let ([constant, linear, square], Symbol::Named(_)) = (coefficients.as_slice(), symbol) else {
        return None;
    };
    let interval = domain.interval(symbol);
    let (lower, upper) = (interval.lower?, interval.upper?);
    let ends = (lower.value.as_rational()?, upper.value.as_rational()?);
    let bound: Rational = ends.0.abs().max(ends.1.abs());
    if !linear.is_zero() || bound <= integer(0) {
        return None;
    }
    let inside = |closed: bool, end: Rational| !closed || end.abs() < bound;
    let open = inside(lower.closed, ends.0) && inside(upper.closed, ends.1);
    let at_zero = not_negative(constant, domain)?;
    let at_bound = not_negative(&(constant + &square.scaled(&(&bound * &bound))), domain)?;
    let strict = at_zero.strict() && (at_bound.strict() || open);
    let sign = match strict {
        true => Sign::Positive,
        false => Sign::Nonnegative,
    };
    let shown = Shown::Even(symbol.clone(), bound, Box::new([at_zero, at_bound]), strict);
    let proof = Proof {
        polynomial: polynomial.clone(),
        shown,
    };
    Some((sign, proof))
}

/// That a polynomial is zero or more: by inequalities, or as a square.
fn not_negative(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<Proof> {
    let wanted = |(sign, _): &(Sign, Proof)| matches!(sign, Sign::Positive | Sign::Nonnegative);
    let found = without_equations(polynomial, domain).filter(wanted);
    found.map(|(_, proof)| proof).or_else(|| {
        let root = root_of(&polynomial.clone().into())?;
        let root = root.as_polynomial()?.clone();
        let certificate = Certificate {
            strict: false,
            squares: vec![(integer(1), root)],
            multipliers: vec![],
            factors: vec![],
            rest: Polynomial::zero(),
            pieces: vec![Piece {
                region: vec![],
                reason: Reason::Coefficients,
            }],
        };
        Some(Proof {
            polynomial: polynomial.clone(),
            shown: Shown::Whole(certificate),
        })
    })
}
