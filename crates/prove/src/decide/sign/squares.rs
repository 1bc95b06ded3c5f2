//! Sums of squares: polynomials that are nowhere negative, whatever their symbols are.
//!
//! A polynomial is a quadratic form in monomials m_1, ..., m_n: those whose squares it contains, and the number one. A
//! term with an odd exponent is a product of two of them. Completing squares, one monomial after the other and the number one
//! last, leaves `d_1 (m_1 + ...)^2 + ... + d_n`, and if no d is negative neither is the polynomial. Of several pairs of
//! monomials for one term the first is taken: this finds many sums of squares, and not all.
//!
//! Sines and cosines count as symbols too, after `sin^2 + cos^2`, which is one, has made all terms of equal degree in those of each
//! angle: `1 - sin(x - y)^2` is then `(cos(x) cos(y) + sin(x) sin(y))^2`.

use super::certificate::{Certificate, Piece, Reason};
use crate::decide::domain::Domain;
use std::collections::{BTreeMap, BTreeSet};
use torse_algebra::rational::{integer, ratio};
use torse_algebra::{Polynomial, Rational, Symbol};

/// The most terms of a polynomial that is examined.
const MAX_TERMS: usize = 60;
/// The most monomials.
const MAX_MONOMIALS: usize = 24;

/// Exponents of symbols, without zeros.
type Monomial = BTreeMap<Symbol, u16>;

fn polynomial(monomial: &Monomial) -> Polynomial {
    let one = Polynomial::integer(1);
    monomial.iter().fold(one, |product, (symbol, exponent)| {
        &product * &Polynomial::symbol(symbol.clone()).power(u32::from(*exponent))
    })
}

fn product(a: &Monomial, b: &Monomial) -> Monomial {
    let mut result = a.clone();
    for (symbol, exponent) in b {
        *result.entry(symbol.clone()).or_insert(0) += exponent;
    }
    result
}

/// A certificate that the polynomial is a sum of squares and a number that is not negative. It is positive where the number is, or
/// where an assumption excludes that all that is squared is zero.
#[must_use]
pub(super) fn squares(value: &Polynomial, domain: &Domain<'_>) -> Option<Certificate> {
    if value.len() > MAX_TERMS || value.as_constant().is_some() {
        return None;
    }
    let mut terms: BTreeMap<Monomial, Rational> = BTreeMap::new();
    for term in value.terms() {
        let mut monomial = Monomial::new();
        for (symbol, exponent) in &term.powers {
            // Numbers would have to be enclosed, and exponentials are not independent.
            if matches!(
                symbol,
                Symbol::Pi | Symbol::Root(_) | Symbol::Log(_) | Symbol::Arc(..) | Symbol::Exp(_)
            ) {
                return None;
            }
            monomial.insert((*symbol).clone(), *exponent);
        }
        terms.insert(monomial, term.coefficient.clone());
    }
    let (monomials, mut form) = gram(&homogeneous(terms)?)?;
    let mut found = vec![];
    // The number one comes last: what is left for it is the least value that is shown.
    for place in 0..monomials.len() {
        let own: Vec<Rational> = form.get(place)?.clone();
        let pivot = own.get(place)?.clone();
        if pivot < integer(0) {
            return None;
        }
        if pivot == integer(0) {
            if own.iter().skip(place).any(|entry| *entry != integer(0)) {
                return None;
            }
            continue;
        }
        let mut root = Polynomial::zero();
        for (entry, monomial) in own.iter().zip(&monomials).skip(place) {
            root = &root + &polynomial(monomial).scaled(&(entry / &pivot));
        }
        for (row, entry) in form.iter_mut().zip(&own).skip(place + 1) {
            let factor = entry / &pivot;
            for (slot, other) in row.iter_mut().zip(&own).skip(place + 1) {
                *slot -= &factor * other;
            }
        }
        found.push((pivot, root));
    }
    let number = |(_, root): &(Rational, Polynomial)| root.as_constant().is_some();
    let rest = match found.pop_if(|last| number(last)) {
        Some((pivot, _)) => pivot,
        None => integer(0),
    };
    let roots: Vec<&Polynomial> = found.iter().map(|(_, root)| root).collect();
    Some(Certificate {
        strict: rest > integer(0) || domain.excludes_common_zero(&roots),
        squares: found,
        multipliers: vec![],
        factors: vec![],
        rest: Polynomial::constant(&rest),
        pieces: vec![Piece {
            region: vec![],
            reason: Reason::Coefficients,
        }],
    })
}

/// The terms, those of lower degree in sine and cosine of an angle times powers of the sum of their squares; `None` where the degrees of
/// two terms differ by an odd number, or there are too many terms.
fn homogeneous(mut terms: BTreeMap<Monomial, Rational>) -> Option<BTreeMap<Monomial, Rational>> {
    let symbols = terms.keys().flat_map(Monomial::keys);
    let sines = symbols.filter_map(|symbol| match symbol {
        Symbol::Sin(name, angle) | Symbol::Cos(name, angle) => Some((name.clone(), *angle)),
        _ => None,
    });
    let angles: BTreeSet<_> = sines.collect();
    for (name, angle) in angles {
        let pair = [Symbol::Sin(name.clone(), angle), Symbol::Cos(name, angle)];
        let degree = |monomial: &Monomial| -> u16 {
            pair.iter().filter_map(|symbol| monomial.get(symbol)).sum()
        };
        let highest = terms.keys().map(degree).max()?;
        while let Some(low) = terms.keys().find(|own| degree(own) < highest).cloned() {
            let value = terms.remove(&low)?;
            if (highest - degree(&low)) % 2 == 1 || terms.len() > MAX_TERMS {
                return None;
            }
            for symbol in &pair {
                let raised = product(&low, &Monomial::from([(symbol.clone(), 2)]));
                *terms.entry(raised).or_insert_with(|| integer(0)) += &value;
            }
        }
        terms.retain(|_, value| *value != integer(0));
    }
    Some(terms)
}

/// The monomials, the number one last, and the symmetric matrix of the form in them.
fn gram(terms: &BTreeMap<Monomial, Rational>) -> Option<(Vec<Monomial>, Vec<Vec<Rational>>)> {
    let even = |monomial: &Monomial| monomial.values().all(|exponent| exponent % 2 == 0);
    let mut monomials: Vec<Monomial> = terms
        .iter()
        .filter(|(monomial, value)| even(monomial) && **value > integer(0) && !monomial.is_empty())
        .map(|(monomial, _)| monomial.iter().map(|(s, e)| (s.clone(), e / 2)).collect())
        .collect();
    monomials.push(Monomial::new());
    if monomials.len() > MAX_MONOMIALS {
        return None;
    }
    let size = monomials.len();
    let mut form = vec![vec![integer(0); size]; size];
    let half = ratio(1, 2)?;
    for (monomial, value) in terms {
        let square = (0..size).find(|n| {
            let own = monomials.get(*n);
            own.is_some_and(|own| product(own, own) == *monomial)
        });
        let pair = || {
            (0..size).find_map(|low| {
                let a = monomials.get(low)?;
                let fits = |b: &Monomial| product(a, b) == *monomial;
                let high = monomials.iter().skip(low + 1).position(fits)?;
                Some((low, low + 1 + high))
            })
        };
        match square {
            Some(n) => *form.get_mut(n)?.get_mut(n)? += value,
            None => {
                let (low, high) = pair()?;
                *form.get_mut(low)?.get_mut(high)? += value * &half;
                *form.get_mut(high)?.get_mut(low)? += value * &half;
            }
        }
    }
    Some((monomials, form))
}
