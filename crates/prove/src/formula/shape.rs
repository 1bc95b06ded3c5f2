//! One polynomial, or one quotient of factors, as one would write it: term by term, collected by powers of pi, factors in
//! their usual order.

use super::build::{Summand, coefficient, positive_first, power, product, rank, sum, symbol};
use super::factor::{Factored, unit_binomial};
use num_traits::{One, Signed};
use std::cmp::Reverse;
use torse_algebra::polynomial::Term;
use torse_algebra::{Polynomial, Rational, Symbol};
use torse_syntax::formula::{Expr, Operator};

/// `above / below * tail`, the sign apart.
pub(super) fn ratio(above: &Factored, below: &Factored, tail: Option<Expr>) -> Summand {
    let (above, below) = above.cancelled(below);
    let content = &above.content / &below.content;
    let negative = content.is_negative();
    let content = content.abs();
    let mut factors = written(&above);
    if below.factors.is_empty() {
        // 1/4*x*y
        if factors.is_empty() && tail.is_none() {
            factors.push(Expr::number(&content));
        } else {
            factors.splice(0..0, coefficient(&content));
        }
    } else {
        // 3*x/(4*y)
        let number = |n: &torse_algebra::Integer| coefficient(&Rational::from_integer(n.clone()));
        factors.splice(0..0, number(content.numer()));
        let mut divisors = number(content.denom());
        divisors.extend(written(&below));
        factors = vec![product(factors).with(Operator::Divide, product(divisors))];
    }
    factors.extend(tail);
    Summand {
        negative,
        body: product(factors),
    }
}

/// The factors but the content: single symbols first, in the order of a product, then sums.
fn written(factored: &Factored) -> Vec<Expr> {
    let mut factors: Vec<&(Polynomial, u32)> = factored.factors.iter().collect();
    // Short sums first, and (k - 2)*(k - 3) rather than the other way round.
    factors.sort_by_key(|(p, _)| {
        let rank = match p.symbols() {
            [symbol] if p.len() == 1 => rank(symbol),
            _ => u8::MAX,
        };
        (rank, p.len(), p.symbols(), Reverse(p))
    });
    factors
        .into_iter()
        .map(|(p, exponent)| power(shape(p), *exponent))
        .collect()
}

/// A sum without factors pulled out of the whole: term by term, or collected by powers of pi.
pub(super) fn shape(p: &Polynomial) -> Expr {
    let expanded = sum(terms(p));
    match collected(p) {
        Some(collected) if collected.size() <= expanded.size() => collected,
        _ => expanded,
    }
}

/// Term by term.
fn terms(p: &Polynomial) -> Vec<Summand> {
    let terms = positive_first(p.terms().map(|term| monomial(&term)).collect());
    if unit_binomial(p) && terms.iter().all(|term| !term.negative) {
        // 1 + mu
        return terms.into_iter().rev().collect();
    }
    terms
}

fn monomial(term: &Term<'_>) -> Summand {
    let mut powers = term.powers.clone();
    powers.sort_by_key(|(symbol, _)| rank(symbol));
    let mut factors = coefficient(&term.coefficient.abs());
    factors.extend(
        powers
            .into_iter()
            .map(|(s, n)| power(symbol(s), u32::from(n))),
    );
    Summand {
        negative: term.coefficient.is_negative(),
        body: product(factors),
    }
}

/// `(k - 2)*(k - 3) + pi*(k - 2)*(1 + mu)`: by powers of pi, each coefficient factored.
fn collected(p: &Polynomial) -> Option<Expr> {
    let one = Factored::product(std::iter::empty());
    let powers = p.coefficients_in(&Symbol::Pi);
    if powers.iter().filter(|c| !c.is_zero()).count() < 2 {
        return None;
    }
    let mut all = vec![];
    for (exponent, coefficient) in (0u32..).zip(&powers) {
        if coefficient.is_zero() {
            continue;
        }
        let mut factored = Factored::new(coefficient);
        if exponent == 0 && factored.factors.len() == 1 && factored.content.abs().is_one() {
            // Nothing to gain from brackets around the part without pi.
            all.extend(terms(coefficient));
            continue;
        }
        if exponent > 0 {
            factored
                .factors
                .push((Polynomial::symbol(Symbol::Pi), exponent));
        }
        all.push(ratio(&factored, &one, None));
    }
    Some(sum(positive_first(all)))
}
