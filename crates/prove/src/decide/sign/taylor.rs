//! Signs of polynomials in a variable and its sine, cosine and exponential: partial sums of the series of these take their places,
//! higher and higher ones, until all coefficients have a sign.

use super::proof::{Proof, Shown};
use super::simple_places::is_negative_somewhere;
use super::{Sign, line, without_equations};
use crate::decide::domain::Domain;
use crate::decide::order::truth;
use crate::decide::value::plain_symbol;
use torse_algebra::{Fraction, Polynomial, Symbol};
use torse_certificate::taylor::{Exponent, PartialSum};
use torse_syntax::formula::Relation;

/// The most functions in one polynomial, and its most terms.
const MAX_FUNCTIONS: usize = 2;
const MAX_TERMS: usize = 30;
/// How many partial sums of each function are tried. Those of sines and cosines go up by four degrees, those of exponentials by one.
const MAX_LEVELS: u32 = 6;
const MAX_EXPONENTIAL_LEVELS: u32 = 12;

/// A sign of the polynomial, if partial sums show it.
pub(super) fn proof(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<(Sign, Proof)> {
    let functions: Vec<&Symbol> = polynomial
        .symbols()
        .iter()
        .filter(|s| matches!(s, Symbol::Sin(..) | Symbol::Cos(..) | Symbol::Exp(_)))
        .collect();
    if functions.is_empty() || functions.len() > MAX_FUNCTIONS || polynomial.len() > MAX_TERMS {
        return None;
    }
    // Functions without their variable are better off as they are.
    let names = functions.iter().flat_map(|f| f.names());
    let mut beside = names.map(|name| Symbol::Named(name.clone()));
    if !domain.part.is_empty() || !beside.all(|s| polynomial.symbols().contains(&s)) {
        return None;
    }
    let negative = -polynomial;
    let mut sides: Vec<&Polynomial> = vec![polynomial, &negative];
    sides.retain(|own| !is_negative_somewhere(own, domain));
    let is_exponential = |function: &&Symbol| matches!(function, Symbol::Exp(_));
    let levels = match functions.iter().any(is_exponential) {
        true => MAX_EXPONENTIAL_LEVELS,
        false => MAX_LEVELS,
    };
    for level in 0..levels {
        for below in 0..1_u32 << functions.len() {
            let bounds = functions.iter().enumerate().map(|(place, function)| {
                let is_lower = below & (1 << place) == 0;
                bound(function, is_lower, level)
            });
            let Some(bounds) = bounds.collect::<Option<Vec<PartialSum>>>() else {
                continue;
            };
            for own in &sides {
                if let Some((sign, proof)) = shown(own, &functions, bounds.clone(), domain) {
                    return Some(match **own == negative {
                        true => (sign.negated(), proof),
                        false => (sign, proof),
                    });
                }
            }
        }
    }
    None
}

/// The partial sum of this level on one side; none is above an exponential.
fn bound(function: &Symbol, is_lower: bool, level: u32) -> Option<PartialSum> {
    let (exponent, degree) = match (function, is_lower) {
        (Symbol::Exp(exponent), true) => {
            let [(variable, 1)] = exponent.powers() else {
                return None;
            };
            let exponent = Exponent {
                variable: (**variable).into(),
                parts: exponent.parts(),
            };
            (Some(exponent), level)
        }
        (Symbol::Exp(_), false) => return None,
        (Symbol::Sin(..), true) => (None, 3 + 4 * level),
        (Symbol::Sin(..), false) => (None, 1 + 4 * level),
        (_, true) => (None, 2 + 4 * level),
        (_, false) => (None, 4 * level),
    };
    Some(PartialSum {
        symbol: plain_symbol(function),
        exponent,
        degree,
    })
}

/// That the polynomial is zero or more, by these partial sums.
fn shown(
    polynomial: &Polynomial,
    functions: &[&Symbol],
    bounds: Vec<PartialSum>,
    domain: &Domain<'_>,
) -> Option<(Sign, Proof)> {
    let gap = |place: usize| Symbol::named(&format!("#{place}"));
    let (mut values, mut positive) = (vec![], vec![]);
    for (place, (function, bound)) in functions.iter().zip(&bounds).enumerate() {
        let name = function.names().next()?;
        let lower = domain.interval(&Symbol::Named(name.clone())).lower;
        let from = |relation| {
            let end = lower.as_ref()?;
            truth(&end.value, relation)
        };
        let (_, from_zero) = bound.variable()?;
        if from_zero && from(Relation::AtLeast) != Some(true) {
            return None;
        }
        let beyond = from(Relation::Greater) == Some(true);
        let open =
            lower.as_ref().is_some_and(|end| !end.closed) && from(Relation::AtLeast) == Some(true);
        positive.push(bound.is_strict() && (beyond || open));
        let sum = sum(name, bound)?;
        let own = Polynomial::symbol(gap(place));
        values.push(match bound.is_lower()? {
            true => &sum + &own,
            false => &sum - &own,
        });
    }
    let moved = polynomial.substituted(|symbol| {
        let place = functions.iter().position(|function| *function == symbol)?;
        values.get(place).cloned()
    });
    let (mut terms, mut strict) = (vec![], false);
    for (exponents, coefficient) in by_gaps(&moved, bounds.len(), &gap) {
        let wanted = |(sign, _): &(Sign, Proof)| matches!(sign, Sign::Positive | Sign::Nonnegative);
        let (sign, proof) = without_equations(&coefficient, domain)
            .filter(wanted)
            .or_else(|| line::not_negative(&coefficient, domain, &[]))?;
        let mut gaps = exponents.iter().zip(&positive);
        let all = gaps.all(|(exponent, positive)| *exponent == 0 || *positive);
        strict |= sign == Sign::Positive && all;
        terms.push((exponents, proof));
    }
    let sign = match strict {
        true => Sign::Positive,
        false => Sign::Nonnegative,
    };
    let proof = Proof {
        polynomial: polynomial.clone(),
        shown: Shown::Taylor(bounds, terms, strict),
    };
    Some((sign, proof))
}

/// A partial sum in the polynomials of this room.
fn sum(name: &str, bound: &PartialSum) -> Option<Polynomial> {
    let mut argument = Fraction::named(name);
    if bound.in_quarter_turns() {
        let quarter = Fraction::symbol(Symbol::Pi)
            .over(&Fraction::integer(2))
            .ok()?;
        argument = argument * quarter;
    }
    let argument = argument.as_polynomial()?.clone();
    let terms = bound.terms();
    Some(
        terms.fold(Polynomial::zero(), |sum, (exponent, coefficient)| {
            &sum + &argument.power(exponent).scaled(&coefficient)
        }),
    )
}

/// The coefficients of products of gaps.
fn by_gaps(
    polynomial: &Polynomial,
    count: usize,
    gap: &dyn Fn(usize) -> Symbol,
) -> Vec<(Vec<u32>, Polynomial)> {
    let mut all = vec![(vec![], polynomial.clone())];
    for place in 0..count {
        let symbol = gap(place);
        let mut next = vec![];
        for (exponents, rest) in all {
            for (exponent, coefficient) in (0_u32..).zip(rest.coefficients_in(&symbol)) {
                if !coefficient.is_zero() {
                    next.push(([exponents.as_slice(), &[exponent]].concat(), coefficient));
                }
            }
        }
        all = next;
    }
    all
}
