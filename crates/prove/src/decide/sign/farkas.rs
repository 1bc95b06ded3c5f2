//! Nonnegative multiples of assumptions that add up to a polynomial, by linear programming.
//!
//! **Theorem** (Farkas 1902, Motzkin 1936). Let p and c_1, ..., c_n be linear. If p >= 0 wherever all c_i >= 0, and there is
//! such a point, then `p = m_1 c_1 + ... + m_n c_n + r` with numbers m_i >= 0 and r >= 0. p > 0 there, if r > 0 or m_i > 0 for
//! an assumption that is strict.
//!
//! So for linear polynomials the search is complete, whatever their number. Others are read as linear forms in their
//! monomials, which is a search like any other. The numbers are found by the [simplex method](super::super::simplex).

use super::certificate::{Certificate, Piece, Reason};
use crate::decide::simplex::Tableau;
use num_traits::{Signed, Zero};
use std::collections::BTreeMap;
use torse_algebra::rational::integer;
use torse_algebra::{Polynomial, Rational, Symbol};

/// The most assumptions that are combined; of more, the first so many are.
const MAX_ASSUMPTIONS: usize = 80;
/// The most terms of a polynomial that takes part.
const MAX_TERMS: usize = 12;

/// A certificate that the polynomial is a sum of nonnegative multiples of the assumptions and a nonnegative number; a strict one if
/// there is one.
pub(super) fn combination(
    polynomial: &Polynomial,
    assumed: &[(Polynomial, bool)],
) -> Option<Certificate> {
    if polynomial.len() > MAX_TERMS {
        return None;
    }
    let useful: Vec<(usize, &Polynomial, bool)> = assumed
        .iter()
        .enumerate()
        .filter(|(_, (p, _))| p.as_constant().is_none() && p.len() <= MAX_TERMS)
        .map(|(number, (p, strict))| (number, p, *strict))
        .take(MAX_ASSUMPTIONS)
        .collect();
    let parts: Vec<&Polynomial> = useful.iter().map(|(_, part, _)| *part).collect();
    let counts: Vec<bool> = useful.iter().map(|(_, _, strict)| *strict).collect();
    // What is left counts too.
    let positive: Vec<bool> = counts.iter().copied().chain([true]).collect();
    let found = equations(polynomial, &parts)?.solution(&positive)?;
    let (rest, multiples) = found.split_last()?;
    let multipliers: Vec<(usize, Rational)> = useful
        .iter()
        .zip(multiples)
        .filter(|(_, multiple)| !multiple.is_zero())
        .map(|((number, _, _), multiple)| (*number, multiple.clone()))
        .collect();
    let strict = rest.is_positive()
        || multiples
            .iter()
            .zip(&counts)
            .any(|(multiple, strict)| *strict && multiple.is_positive());
    Some(Certificate {
        strict,
        squares: vec![],
        multipliers,
        factors: vec![],
        rest: Polynomial::constant(rest),
        pieces: vec![Piece {
            region: vec![],
            reason: Reason::Coefficients,
        }],
    })
}

/// A monomial, as a key.
type Powers = Vec<(Symbol, u16)>;

fn coefficients(polynomial: &Polynomial) -> BTreeMap<Powers, Rational> {
    let powers = |list: &[(&Symbol, u16)]| list.iter().map(|(s, e)| ((*s).clone(), *e)).collect();
    let terms = polynomial.terms();
    terms
        .map(|term| (powers(&term.powers), term.coefficient))
        .collect()
}

/// `parts[0] m_0 + ... + r = polynomial`, an equation for each monomial; `None` if some monomial of the polynomial occurs in no
/// part.
fn equations(polynomial: &Polynomial, parts: &[&Polynomial]) -> Option<Tableau> {
    let goal = coefficients(polynomial);
    let parts: Vec<_> = parts.iter().map(|part| coefficients(part)).collect();
    let constant: Powers = vec![];
    let mut monomials: Vec<&Powers> = goal
        .keys()
        .chain(parts.iter().flat_map(|p| p.keys()))
        .collect();
    monomials.push(&constant);
    monomials.sort();
    monomials.dedup();
    let equation = |monomial: &&Powers| {
        let entry = |own: &BTreeMap<Powers, Rational>| {
            own.get(*monomial).cloned().unwrap_or_else(Rational::zero)
        };
        let rest = integer(i64::from(monomial.is_empty()));
        let left = parts.iter().map(entry).chain([rest]);
        left.chain([entry(&goal)]).collect()
    };
    Tableau::new(monomials.iter().map(equation).collect(), parts.len() + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn linear(terms: &[(&str, i64)], constant: i64) -> Polynomial {
        let start = Polynomial::constant(&integer(constant));
        terms.iter().fold(start, |sum, (name, coefficient)| {
            &sum + &Polynomial::symbol(Symbol::named(name)).scaled(&integer(*coefficient))
        })
    }

    /// The sum that a certificate names.
    fn sum(certificate: &Certificate, assumed: &[(Polynomial, bool)]) -> Polynomial {
        let multipliers = certificate.multipliers.iter();
        multipliers.fold(certificate.rest.clone(), |sum, (number, multiple)| {
            assert!(multiple.is_positive());
            &sum + &assumed
                .get(*number)
                .map_or(Polynomial::zero(), |(p, _)| p.scaled(multiple))
        })
    }

    #[test]
    fn a_chain_of_any_length_gives_the_distance_of_its_ends() {
        let names: Vec<String> = (0..30).map(|n| format!("u{n}")).collect();
        let step = |n: usize| linear(&[(names[n + 1].as_str(), 1), (names[n].as_str(), -1)], 0);
        let assumed: Vec<(Polynomial, bool)> = (0..29).map(|n| (step(n), n == 17)).collect();
        let ends = linear(&[("u29", 1), ("u0", -1)], 0);
        let found = combination(&ends, &assumed).expect("it is their sum");
        assert!(found.strict);
        assert_eq!(found.multipliers.len(), 29);
        assert_eq!(sum(&found, &assumed), ends);
        let reversed = combination(&-&ends, &assumed);
        assert!(reversed.is_none());
    }

    #[test]
    fn a_vertex_of_a_polygon_bounds_what_it_maximises() {
        // x + 2 y <= 4, 3 x + y <= 6, x >= 0, y >= 0: the largest x + y is 14/5.
        let assumed = vec![
            (linear(&[("x", -1), ("y", -2)], 4), false),
            (linear(&[("x", -3), ("y", -1)], 6), false),
            (linear(&[("x", 1)], 0), false),
            (linear(&[("y", 1)], 0), false),
        ];
        let bound = |fifths: i64| linear(&[("x", -5), ("y", -5)], fifths);
        let weak = combination(&bound(14), &assumed).expect("it holds");
        assert!(!weak.strict);
        assert_eq!(sum(&weak, &assumed), bound(14));
        let strict = combination(&bound(15), &assumed).expect("it holds");
        assert!(strict.strict);
        assert_eq!(sum(&strict, &assumed), bound(15));
        assert!(combination(&bound(13), &assumed).is_none());
    }

    #[test]
    fn a_contradiction_makes_everything_positive() {
        // x > 1 and x < 0.
        let assumed = vec![
            (linear(&[("x", 1)], -1), true),
            (linear(&[("x", -1)], 0), true),
        ];
        let goal = linear(&[], -7);
        let found = combination(&goal, &assumed).expect("there is no point");
        assert!(found.strict);
        assert_eq!(sum(&found, &assumed), goal);
    }
}
