//! Counterexamples: points of the domain at which a statement fails, and what is said of them.

use super::candidates::Turns;
use super::domain::Domain;
use super::order::truth;
use super::value::{fraction, plain_symbol, quotient};
use std::collections::BTreeMap;
use torse_algebra::{Fraction, Polynomial, Symbol, Unit};
use torse_certificate::Ratio;
use torse_certificate::point::{Comparison, Counterexample, Failure, Value};
use torse_core as core;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::Relation;

/// A point: exact values of symbols, in order.
pub type Point = BTreeMap<Symbol, Fraction>;

/// Replaces a symbol (and the functions of it) by a value.
pub(super) fn placed(value: &Fraction, symbol: &Symbol, at: &Fraction) -> Option<Fraction> {
    match symbol {
        Symbol::Named(name) => value.at(name, at).ok(),
        _ => value
            .substituted(|s| (s == symbol).then(|| at.clone()))
            .ok(),
    }
}

/// The value of a fraction at a point.
#[must_use]
pub fn at_point(value: &Fraction, point: &Point) -> Option<Fraction> {
    point.iter().try_fold(value.clone(), |value, (symbol, at)| {
        placed(&value, symbol, at)
    })
}

/// The free symbols of fractions: names and points, also those that occur only under a function.
#[must_use]
pub fn free_symbols(values: &[&Fraction]) -> Vec<Symbol> {
    let mut all: Vec<Symbol> = values
        .iter()
        .flat_map(|v| {
            v.symbols()
                .into_iter()
                .chain(v.conditions().iter().flat_map(|p| p.symbols().to_vec()))
        })
        .flat_map(|s| match s {
            Symbol::Indexed(..) => vec![s],
            // A number has no names.
            _ => s.names().cloned().map(Symbol::Named).collect(),
        })
        .collect();
    all.sort();
    all.dedup();
    // Parameters and variables first: then the points can be as simple as possible.
    all.sort_by_key(|s| matches!(s, Symbol::Indexed(..)));
    all
}

/// The functions under which a variable stands.
#[must_use]
pub fn turns(values: &[&Fraction], symbol: &Symbol) -> Turns {
    let Symbol::Named(name) = symbol else {
        return Turns::None;
    };
    let angles = values
        .iter()
        .flat_map(|v| v.symbols())
        .filter_map(|s| match s {
            Symbol::Sin(n, angle) | Symbol::Cos(n, angle) if n == *name => Some(angle),
            _ => None,
        });
    // Quarter turns before radians, the finest part of the unit.
    match angles.min_by_key(|angle| (angle.unit, std::cmp::Reverse(angle.parts))) {
        None => Turns::None,
        Some(angle) if angle.unit == Unit::QuarterTurn => Turns::Quarter(angle.parts),
        Some(angle) => Turns::Radian(angle.parts),
    }
}

/// The point with the values that both sides have there; `None` where a divisor vanishes.
#[must_use]
pub fn described(
    point: &Point,
    kind: Comparison,
    left: &[Fraction],
    right: &[Fraction],
) -> Option<Counterexample<Polynomial>> {
    let side = |values: &[Fraction]| -> Option<Vec<Ratio<Polynomial>>> {
        let there = values.iter().map(|v| at_point(v, point));
        there.map(|value| Some(quotient(&value?))).collect()
    };
    Some(Counterexample {
        at: values(point),
        others: vec![],
        failure: Failure::Sides {
            kind,
            left: side(left)?,
            right: side(right)?,
        },
    })
}

/// The values of the symbols, in their order.
#[must_use]
pub fn values(point: &Point) -> Vec<Value<Polynomial>> {
    let value = |(symbol, value): (&Symbol, &Fraction)| Value {
        symbol: plain_symbol(symbol),
        value: quotient(value),
    };
    point.iter().map(value).collect()
}

/// Gives values to the numbers of a claim that a counterexample says nothing of, for they play no role: the first of their
/// sets.
pub(crate) fn complete(
    point: &mut Counterexample<Polynomial>,
    claim: &core::Claim,
    integers: &BTreeMap<String, i64>,
    domain: &Domain<'_>,
) {
    let mut known: BTreeMap<String, i64> = integers.clone();
    for value in &point.at {
        let number = fraction(&value.value).and_then(|value| value.as_rational());
        let whole = number.filter(|q| q.is_integer());
        let whole = whole.and_then(|q| i64::try_from(&q.to_integer()).ok());
        known.extend(whole.map(|n| (value.symbol.to_string(), n)));
    }
    // An end of a range that names an integer without a value is looked at again when that has one.
    for _ in 0..claim.symbols.len() {
        for (name, set) in &claim.symbols {
            let own = plain_symbol(&Symbol::Named(name.clone()));
            let has = |v: &Value<Polynomial>| v.symbol == own;
            let given = point.at.iter().any(has) || point.others.iter().any(has);
            if given || integers.contains_key(&**name) {
                continue;
            }
            let value = match set {
                SymbolKind::Real(_) => {
                    let mut values = domain.candidates(&Symbol::Named(name.clone()), Turns::None);
                    (!values.is_empty()).then(|| values.remove(0))
                }
                SymbolKind::Integer { least, most } => {
                    let end = least.as_ref().or(most.as_ref());
                    let number = |form: &torse_algebra::Affine| {
                        let mut terms = form.multiples();
                        terms.try_fold(form.constant(), |sum, (other, n)| {
                            sum.checked_add(known.get(other)?.checked_mul(n)?)
                        })
                    };
                    let chosen = end.map_or(Some(0), number);
                    known.extend(chosen.map(|n| (name.to_string(), n)));
                    chosen.map(Fraction::integer)
                }
                SymbolKind::Vector(_) | SymbolKind::Family { .. } => None,
            };
            point.others.extend(value.map(|value| Value {
                symbol: own,
                value: quotient(&value),
            }));
        }
    }
}

/// Divisors that are constants are no conditions.
#[must_use]
pub fn nonconstant(conditions: Vec<Polynomial>) -> Vec<Polynomial> {
    conditions
        .into_iter()
        .filter(|p| {
            let number = p.symbols().iter().all(Symbol::is_number);
            !number || truth(&p.clone().into(), Relation::Different) != Some(true)
        })
        .collect()
}
