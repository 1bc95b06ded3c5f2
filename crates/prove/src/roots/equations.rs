//! Roots whose radicands are squares where equations hold: `sqrt(x^2 + y^2)` is 1 under `x^2 + y^2 == 1`.

use super::square::root_of;
use super::{Resolved, not_negative};
use crate::decide::domain::Domain;
use crate::ideal;
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Polynomial, Rational, Symbol};
use torse_certificate::proof::assumptions::EquationMultiple;
use torse_syntax::formula::Relation;

/// The longest radicand, the most equations, and the most values that are tried.
const MAX_TERMS: usize = 40;
const MAX_EQUATIONS: usize = 8;
const MAX_VALUES: usize = 6;

/// The value of a root of this radicand by the equations of the domain, if it is found: one multiple of one of them may leave a
/// square, or several together leave that of 1 or of a symbol in them.
pub(super) fn resolved(radicand: &Fraction, domain: &Domain<'_>) -> Option<Resolved> {
    let radicand = radicand.as_polynomial()?;
    let equations: Vec<(usize, Polynomial)> = domain
        .constraints
        .iter()
        .enumerate()
        .filter(|(_, c)| c.relation == Relation::Equal)
        .map(|(place, c)| (place, c.value.numerator().clone()))
        .take(MAX_EQUATIONS)
        .collect();
    let shares = |(_, equation): &(usize, Polynomial)| {
        let mut symbols = equation.symbols().iter();
        symbols.any(|s| radicand.symbols().contains(s))
    };
    if radicand.len() > MAX_TERMS || !equations.iter().any(shares) {
        return None;
    }
    equations
        .iter()
        .find_map(|(place, equation)| by_one(radicand, *place, equation, domain))
        .or_else(|| by_several(radicand, &equations, domain))
}

/// By a multiple of one equation that cancels a term of the radicand.
fn by_one(
    radicand: &Polynomial,
    place: usize,
    equation: &Polynomial,
    domain: &Domain<'_>,
) -> Option<Resolved> {
    let mut tried: Vec<Rational> = vec![];
    for own in equation.terms() {
        for term in radicand.terms().filter(|term| term.powers == own.powers) {
            let multiple = term.coefficient / own.coefficient.clone();
            if tried.contains(&multiple) {
                continue;
            }
            let rest = radicand - &equation.scaled(&multiple);
            let found = root_of(&rest.into()).and_then(|value| not_negative(&value, domain));
            if let Some(found) = found {
                let multiple = Polynomial::constant(&multiple);
                let multiples = vec![EquationMultiple {
                    equation: place,
                    multiple,
                }];
                return Some(Resolved { multiples, ..found });
            }
            tried.push(multiple);
        }
    }
    None
}

/// By all equations together, if the radicand less the square of a simple value is in their ideal.
fn by_several(
    radicand: &Polynomial,
    equations: &[(usize, Polynomial)],
    domain: &Domain<'_>,
) -> Option<Resolved> {
    let plain: Vec<Polynomial> = equations.iter().map(|(_, e)| e.clone()).collect();
    let mut symbols: Vec<&Symbol> = plain.iter().flat_map(|e| e.symbols()).collect();
    symbols.sort();
    symbols.dedup();
    let is_root = |s: &Symbol| domain.roots.iter().any(|root| root.symbol == *s);
    let named = symbols
        .into_iter()
        .filter(|s| matches!(s, Symbol::Named(_)) && !is_root(s));
    let named = named.map(|s| Polynomial::symbol(s.clone()));
    let values = std::iter::once(Polynomial::constant(&integer(1))).chain(named);
    values.take(MAX_VALUES).find_map(|value| {
        let row = ideal::multipliers(&(radicand - &value.power(2)), &plain)?;
        let found = not_negative(&Fraction::from(value), domain)?;
        let used = row.into_iter().zip(equations);
        let used = used.filter(|(multiple, _)| !multiple.is_zero());
        let multiples = used.map(|(multiple, (place, _))| EquationMultiple {
            equation: *place,
            multiple,
        });
        Some(Resolved {
            multiples: multiples.collect(),
            ..found
        })
    })
}
