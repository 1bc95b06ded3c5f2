//! Equality where no point was found at which the sides differ: the difference may have no choice but to be zero.
//!
//! A number that is neither negative nor positive is zero, one whose square is not positive, and one whose product with
//! numbers that are not zero is zero. The first two are questions of sign, where assumed equations help; the third is one
//! of ideals.

use super::domain::Domain;
use super::sign::nonnegative;
use super::witness;
use crate::evaluate::value::Value;
use crate::ideal;
use torse_algebra::{Fraction, Polynomial};
use torse_certificate::zero_by_sign::{Zero, ZeroBySign};
use torse_syntax::formula::Relation;

/// The most terms of a difference whose square is looked at.
const MAX_TERMS: usize = 8;
/// The most factors that are assumed not to vanish.
const MAX_FACTORS: usize = 4;

/// Why all differences are zero, if that is found.
pub(super) fn forced(
    left: &Value,
    right: &Value,
    domain: &Domain<'_>,
) -> Option<ZeroBySign<Polynomial>> {
    if domain.constraints.is_empty() {
        return None;
    }
    let (mut entries, mut conditions) = (vec![], vec![]);
    for (x, y) in left.entries().into_iter().zip(right.entries()) {
        let difference = x.minus(y).as_fraction()?.clone();
        entries.push(zero(&difference, domain)?);
        conditions.extend(difference.conditions().to_vec());
    }
    conditions.sort();
    conditions.dedup();
    Some(ZeroBySign {
        entries,
        divisors: witness::nonconstant(conditions),
    })
}

fn zero(difference: &Fraction, domain: &Domain<'_>) -> Option<Zero<Polynomial>> {
    let numerator = difference.numerator();
    if numerator.is_zero() {
        return Some(Zero::Identically);
    }
    product(numerator, domain)
        .or_else(|| between(numerator, domain))
        .or_else(|| square(numerator, domain))
}

fn product(numerator: &Polynomial, domain: &Domain<'_>) -> Option<Zero<Polynomial>> {
    let of = |relation: Relation| {
        let constraints = domain.constraints.iter();
        let own = constraints.filter(move |c| c.relation == relation);
        own.map(|c| c.value.numerator().clone())
    };
    let factors: Vec<Polynomial> = of(Relation::Different).take(MAX_FACTORS).collect();
    let equations: Vec<Polynomial> = of(Relation::Equal).collect();
    if factors.is_empty() || equations.is_empty() {
        return None;
    }
    let product = factors.iter().fold(numerator.clone(), |p, f| &p * f);
    let multipliers = ideal::multipliers(&product, &equations)?;
    Some(Zero::Product {
        equations,
        multipliers,
    })
}

fn between(numerator: &Polynomial, domain: &Domain<'_>) -> Option<Zero<Polynomial>> {
    let above = nonnegative(numerator, domain)?;
    let below = nonnegative(&-numerator, domain)?;
    Some(Zero::Between(Box::new([above, below])))
}

fn square(numerator: &Polynomial, domain: &Domain<'_>) -> Option<Zero<Polynomial>> {
    if numerator.len() > MAX_TERMS {
        return None;
    }
    let sign = nonnegative(&-numerator.power(2), domain)?;
    Some(Zero::Square {
        root: numerator.clone(),
        sign: Box::new(sign),
    })
}
