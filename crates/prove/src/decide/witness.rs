//! Counterexamples: simple points of the domain at which a statement fails.
//!
//! Symbols get values one after the other, simplest candidates first; a value is kept only if the
//! difference of the two sides stays a nonzero polynomial in the symbols that are left and no divisor
//! vanishes. A nonzero polynomial has a nonzero value on every grid that is fine enough, so the search
//! goes back only where assumptions bind.

use super::candidates::{Turns, is_whole};
use super::domain::Domain;
use super::nondegenerate::make_nondegenerate;
use super::order::truth;
use super::real_symbol::RealSymbol;
use super::value::{fraction, plain_symbol, quotient};
use std::collections::BTreeMap;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::{Fraction, Polynomial, Symbol, Unit};
use torse_certificate::Ratio;
use torse_certificate::point::{Comparison, Counterexample, Failure, Value};
use torse_core as core;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::Relation;

/// The most values tried in one search.
const MAX_TRIES: usize = 6_000;
/// The values of each symbol that are tried once more where that was not enough: of a real number without bounds one of each sign.
const FEW: usize = 5;

/// A point: exact values of symbols, in order.
pub type Point = BTreeMap<Symbol, Fraction>;

/// Replaces a symbol (and the functions of it) by a value.
fn placed(value: &Fraction, symbol: &Symbol, at: &Fraction) -> Option<Fraction> {
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

/// A point of the domain at which `wanted` holds for the fraction that is passed in, no divisor of it, of what is
/// `also` to be known there, or of the statement vanishes, and every constraint holds; with the values of eliminated symbols.
///
/// None where the index of a point is symbolic: two names may be one point then, which small instances tell apart.
#[must_use]
pub fn find(
    difference: &Fraction,
    also: &[&Fraction],
    domain: &Domain<'_>,
    wanted: Relation,
) -> Option<Point> {
    near(difference, also, domain, wanted, None)
}

/// The same, with this value of a symbol tried first.
#[must_use]
pub fn near(
    difference: &Fraction,
    also: &[&Fraction],
    domain: &Domain<'_>,
    wanted: Relation,
    first: Option<(&RealSymbol, &Fraction)>,
) -> Option<Point> {
    let mut constraints: Vec<(Fraction, Relation)> = domain
        .constraints
        .iter()
        .chain(&domain.defined)
        .filter(|_| !injected(InjectedFault::WitnessAnywhere))
        .map(|c| (c.value.clone(), c.relation))
        .collect();
    let recorded = also.iter().flat_map(|f| f.conditions());
    let divisors = domain
        .pivots()
        .iter()
        .chain(&domain.divisors)
        .chain(recorded);
    constraints.extend(divisors.map(|p| (p.clone().into(), Relation::Different)));
    let mut everything = vec![difference];
    everything.extend(also);
    everything.extend(constraints.iter().map(|(value, _)| value));
    everything.extend(domain.solved().iter().map(|(_, value)| value));
    let mut symbols = free_symbols(&everything);
    let symbolic = |s: &Symbol| matches!(s, Symbol::Indexed(_, index) if index.iter().any(|i| i.as_number().is_none()));
    if symbols.iter().any(symbolic) {
        return None;
    }
    bounding_integers(&mut symbols, domain);
    // Roots and logarithms last: the others determine them.
    symbols.sort_by_key(|symbol| domain.is_implicit(symbol));
    let candidates: Vec<(Symbol, Vec<Fraction>)> = symbols
        .into_iter()
        .map(|s| {
            let turns = turns(&everything, &s);
            let mut values = domain.candidates(&s, turns);
            if turns != Turns::None {
                // Where sines and cosines are exact first, also those that the difference does not have any more.
                values.sort_by_key(|at| also.iter().any(|f| placed(f, &s, at).is_none()));
            }
            if let Some((own, value)) = first
                && *own.symbol() == s
                && domain.admits(own, value)
            {
                values.insert(0, value.clone());
            }
            (s, values)
        })
        .collect();
    let mut search = Search {
        domain,
        wanted,
        tries: 0,
        point: Point::new(),
    };
    let found = search.run(difference.clone(), &constraints, &candidates) || {
        // Where the first symbols have many values, the last ones get no turn.
        let few = candidates.iter().map(|(symbol, values)| {
            let few = values.iter().take(FEW).cloned();
            (symbol.clone(), few.collect())
        });
        search.tries = 0;
        search.point.clear();
        search.run(difference.clone(), &constraints, &few.collect::<Vec<_>>())
    };
    let point = found.then(|| std::mem::take(&mut search.point))?;
    let fails = |point: &Point| search.fails_at(difference, &constraints, point);
    let mut point = make_nondegenerate(point, domain.declarations, &fails);
    for (symbol, value) in domain.solved() {
        let value = at_point(value, &point)?;
        point.insert(symbol.clone(), value);
    }
    Some(point)
}

/// Adds the integers in whose terms the ranges of others are declared.
fn bounding_integers(symbols: &mut Vec<Symbol>, domain: &Domain<'_>) {
    let mut place = 0;
    while let Some(symbol) = symbols.get(place).cloned() {
        place += 1;
        let Symbol::Named(name) = symbol else {
            continue;
        };
        let Some(SymbolKind::Integer { least, most }) = domain.declarations.symbol(&name) else {
            continue;
        };
        for form in least.iter().chain(most) {
            for (other, _) in form.multiples() {
                let other = Symbol::named(other);
                let mut values = domain.solved().iter().chain(&domain.chosen);
                if !values.any(|(s, _)| *s == other) && !symbols.contains(&other) {
                    // Parameters come before points.
                    symbols.insert(0, other);
                    place += 1;
                }
            }
        }
    }
}

struct Search<'a> {
    domain: &'a Domain<'a>,
    wanted: Relation,
    tries: usize,
    point: Point,
}

impl Search<'_> {
    fn run(
        &mut self,
        value: Fraction,
        constraints: &[(Fraction, Relation)],
        left: &[(Symbol, Vec<Fraction>)],
    ) -> bool {
        if value.is_zero()
            && matches!(
                self.wanted,
                Relation::Different | Relation::Less | Relation::Greater
            )
        {
            return false;
        }
        let Some(((symbol, values), rest)) = left.split_first() else {
            // An unsettled sign is no point of the domain.
            let settled = |(c, relation): &(Fraction, Relation)| truth(c, *relation) == Some(true);
            return truth(&value, self.wanted) == Some(true)
                && constraints.iter().all(settled)
                && self.integers_in_range(&self.point);
        };
        // A constraint that has become a number must hold.
        let fails = |(c, relation): &(Fraction, Relation)| truth(c, *relation) == Some(false);
        if constraints.iter().any(fails) {
            return false;
        }
        let own = match self.domain.is_implicit(symbol) {
            true => self.domain.implicit_values(symbol, constraints),
            false => values.clone(),
        };
        for at in &own {
            self.tries += 1;
            if self.tries > MAX_TRIES {
                return false;
            }
            let Some(next) = placed(&value, symbol, at) else {
                continue;
            };
            let moved: Option<Vec<(Fraction, Relation)>> = constraints
                .iter()
                .map(|(c, r)| Some((placed(c, symbol, at)?, *r)))
                .collect();
            let Some(moved) = moved else {
                continue;
            };
            let admitted = !moved.iter().any(fails);
            self.point.insert(symbol.clone(), at.clone());
            if self.run(next, &moved, rest) {
                return true;
            }
            self.point.remove(symbol);
            // Another value would change nothing.
            if admitted && !self.matters(symbol, &value, constraints) {
                return false;
            }
        }
        false
    }

    /// Whether more than its own range hangs on the value of a symbol.
    fn matters(
        &self,
        symbol: &Symbol,
        value: &Fraction,
        constraints: &[(Fraction, Relation)],
    ) -> bool {
        let ties = |(c, _): &(Fraction, Relation)| {
            let own = free_symbols(&[c]);
            own.len() > 1 && own.contains(symbol)
        };
        self.domain.is_integer(symbol)
            || self.domain.is_implicit(symbol)
            || free_symbols(&[value]).contains(symbol)
            || constraints.iter().any(ties)
    }

    /// Whether a point with values for all symbols is one of those that are sought.
    fn fails_at(
        &self,
        value: &Fraction,
        constraints: &[(Fraction, Relation)],
        point: &Point,
    ) -> bool {
        let settled = |(value, relation): (&Fraction, Relation)| {
            at_point(value, point).is_some_and(|value| truth(&value, relation) == Some(true))
        };
        let met = |(value, relation): &(Fraction, Relation)| settled((value, *relation));
        settled((value, self.wanted))
            && constraints.iter().all(met)
            && self.integers_in_range(point)
    }

    /// Whether every integer of the point, also one that is eliminated, is an integer and respects its bounds, which may name
    /// others.
    fn integers_in_range(&self, point: &Point) -> bool {
        let mut all = point.clone();
        all.extend(self.domain.chosen.iter().cloned());
        for (symbol, value) in self.domain.solved() {
            let Some(value) = at_point(value, point) else {
                return false;
            };
            all.insert(symbol.clone(), value);
        }
        all.iter().all(|(symbol, at)| {
            let Symbol::Named(name) = symbol else {
                return true;
            };
            let Some(SymbolKind::Integer { least, most }) = self.domain.declarations.symbol(name)
            else {
                return true;
            };
            let bound = |form: &Option<torse_algebra::Affine>, relation: Relation| {
                form.as_ref().is_none_or(|form| {
                    let value: Fraction = crate::evaluate::series::polynomial_of(form).into();
                    at_point(&value, &all)
                        .is_some_and(|value| truth(&(at.clone() - value), relation) == Some(true))
                })
            };
            is_whole(at) && bound(least, Relation::AtLeast) && bound(most, Relation::AtMost)
        })
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
