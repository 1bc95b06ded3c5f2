//! Signs of polynomials in roots: symbols w that are not negative, with `w^2 == r`.
//!
//! Squares of roots are replaced by their radicands, multiples of the equations of the roots; what is left may be a difference
//! a - b with a >= 0 and a^2 >= b^2, and the squares have fewer roots in them. So `sqrt(x^2 + 1) >= 1` comes from `x^2 >= 0`, and
//! `norm(p + q) <= norm(p) + norm(q)` from Lagrange's identity by two such steps.

use super::proof::{Proof, Shown, equations};
use super::{Sign, without_equations};
use crate::decide::domain::Domain;
use torse_algebra::rational::integer;
use torse_algebra::{Polynomial, Rational, Symbol};

/// The most terms of a difference of which squares are compared, and of the squares.
const MAX_TERMS: usize = 16;
const MAX_SQUARES: usize = 200;
/// How often squares are compared.
const MAX_STEPS: usize = 2;

/// That the polynomial is zero or more, if roots show it.
pub(super) fn proof(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<(Sign, Proof)> {
    let is_root = |symbol: &Symbol| domain.roots.iter().any(|root| root.symbol == *symbol);
    if domain.roots.is_empty() || !polynomial.symbols().iter().any(is_root) {
        return None;
    }
    let proof = shown(polynomial, domain, MAX_STEPS)?;
    let sign = match proof.strict() {
        true => Sign::Positive,
        false => Sign::Nonnegative,
    };
    Some((sign, proof))
}

/// A proof that the polynomial is zero or more, by so many comparisons of squares at most.
fn shown(polynomial: &Polynomial, domain: &Domain<'_>, steps: usize) -> Option<Proof> {
    let (multiples, rest) = reduced(polynomial, domain);
    let weakly = |(sign, _): &(Sign, Proof)| matches!(sign, Sign::Positive | Sign::Nonnegative);
    let plain = without_equations(&rest, domain).filter(weakly);
    let proof = match plain {
        Some((_, proof)) => proof,
        None => by_squares(&rest, domain, steps.checked_sub(1)?)?,
    };
    let along = |proof: Proof, (place, multiple, whole): (usize, Polynomial, Polynomial)| Proof {
        polynomial: whole,
        shown: Shown::Along(place, multiple, Box::new(proof)),
    };
    Some(multiples.into_iter().rev().fold(proof, along))
}

/// As a - b, where a has the terms that nothing makes negative, or those of them with a root: `sqrt((x - 1)^2) >= x - 1`.
fn by_squares(polynomial: &Polynomial, domain: &Domain<'_>, steps: usize) -> Option<Proof> {
    if polynomial.len() > MAX_TERMS {
        return None;
    }
    let terms = terms_from_zero(polynomial, domain);
    let is_root = |symbol: &Symbol| domain.roots.iter().any(|root| root.symbol == *symbol);
    let (rooted, others): (Vec<_>, Vec<_>) = terms
        .iter()
        .partition(|term| term.symbols().iter().any(is_root));
    let added = |sum: Polynomial, term: &&Polynomial| &sum + *term;
    let rooted = rooted.iter().fold(Polynomial::zero(), added);
    let all = others.iter().fold(rooted.clone(), added);
    let by_all = as_difference(polynomial, &all, domain, steps);
    by_all.or_else(|| match others.is_empty() {
        true => None,
        false => as_difference(polynomial, &rooted, domain, steps),
    })
}

/// The terms that nothing makes negative.
fn terms_from_zero(polynomial: &Polynomial, domain: &Domain<'_>) -> Vec<Polynomial> {
    let from_zero = |symbol: &Symbol| {
        let lower = domain.interval(symbol).lower;
        lower.is_some_and(|bound| bound.value.is_zero())
    };
    let terms = polynomial.terms().filter_map(|term| {
        let mut symbols = term.powers.iter().map(|(symbol, _)| *symbol);
        (term.coefficient > Rational::default() && symbols.all(from_zero)).then(|| {
            let powers = term.powers.iter();
            let start = Polynomial::constant(&term.coefficient);
            powers.fold(start, |product, (symbol, exponent)| {
                &product * &Polynomial::symbol((*symbol).clone()).power(u32::from(*exponent))
            })
        })
    });
    terms.collect()
}

/// As `larger - smaller`, by the squares of both.
fn as_difference(
    polynomial: &Polynomial,
    larger: &Polynomial,
    domain: &Domain<'_>,
    steps: usize,
) -> Option<Proof> {
    let smaller = larger - polynomial;
    let squares = &larger.power(2) - &smaller.power(2);
    if larger.is_zero() || smaller.is_zero() || squares.len() > MAX_SQUARES {
        return None;
    }
    let difference = shown(&squares, domain, steps)?;
    let (sign, larger) = without_equations(larger, domain)?;
    matches!(sign, Sign::Positive | Sign::Nonnegative).then(|| Proof {
        polynomial: polynomial.clone(),
        shown: Shown::Squares(Box::new([larger, difference])),
    })
}

/// The multiples of equations of roots that are subtracted, each with what it is subtracted from, and the rest, in which no root
/// has a square. Later roots are made of those before them.
fn reduced(
    polynomial: &Polynomial,
    domain: &Domain<'_>,
) -> (Vec<(usize, Polynomial, Polynomial)>, Polynomial) {
    let (mut multiples, mut rest) = (vec![], polynomial.clone());
    for root in domain.roots.iter().rev() {
        let equation = equations(domain).find(|(_, value)| defines(value, &root.symbol));
        let Some((place, equation)) = equation else {
            continue;
        };
        let multiple = quotient(&rest, equation, &root.symbol);
        if !multiple.is_zero() {
            let left = &rest - &(&multiple * equation);
            multiples.push((place, multiple, std::mem::replace(&mut rest, left)));
        }
    }
    (multiples, rest)
}

/// Whether it is a number times w^2, and something without w.
fn defines(equation: &Polynomial, root: &Symbol) -> bool {
    match equation.coefficients_in(root).as_slice() {
        [_, linear, square] => linear.is_zero() && square.as_constant().is_some(),
        _ => false,
    }
}

/// The quotient by an equation of second degree in a symbol with a number before the square and no linear term.
fn quotient(polynomial: &Polynomial, equation: &Polynomial, root: &Symbol) -> Polynomial {
    let mut coefficients = polynomial.coefficients_in(root);
    let own = equation.coefficients_in(root);
    let mut quotient = Polynomial::zero();
    let [constant, _, square] = own.as_slice() else {
        return quotient;
    };
    let Some(number) = square.as_constant() else {
        return quotient;
    };
    while coefficients.len() > 2 {
        let exponent = coefficients.len() - 2;
        let Some(lead) = coefficients.pop() else {
            break;
        };
        let lead = lead.scaled(&(integer(1) / number.clone()));
        if let Some(lower) = exponent
            .checked_sub(1)
            .and_then(|k| coefficients.get_mut(k))
        {
            *lower = &*lower - &(&lead * constant);
        }
        let power =
            Polynomial::symbol(root.clone()).power(u32::try_from(exponent - 1).unwrap_or(0));
        quotient = &quotient + &(&lead * &power);
    }
    quotient
}
