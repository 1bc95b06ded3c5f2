//! Polynomials in a variable and its exponentials at simple places: a search for a sign that one of them refutes is spared.

use crate::decide::domain::Domain;
use crate::decide::interval::Bound;
use crate::decide::order::truth;
use std::sync::Arc;
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Polynomial, Scalar as _, Symbol};
use torse_syntax::formula::Relation;

/// The variable of all exponentials of a polynomial.
pub(super) fn variable(polynomial: &Polynomial) -> Option<&Arc<str>> {
    let is_exponential = |symbol: &&Symbol| matches!(symbol, Symbol::Exp(_));
    let exponentials = polynomial.symbols().iter().filter(is_exponential);
    let mut names = exponentials.flat_map(Symbol::names);
    let first = names.next()?;
    names.all(|name| name == first).then_some(first)
}

/// Whether a polynomial in one variable and its exponentials is negative at a simple place of the domain: it is not worth a search.
pub(super) fn is_negative_somewhere(polynomial: &Polynomial, domain: &Domain<'_>) -> bool {
    let Some(name) = variable(polynomial) else {
        return false;
    };
    let own = Symbol::Named(Arc::clone(name));
    let interval = domain.interval(&own);
    let places = [-3, -1, 1, 4, 12].map(|quarters| integer(quarters) / integer(4));
    places.into_iter().any(|place| {
        let place = Fraction::from(Polynomial::constant(&place));
        let is_within = |end: Option<&Bound>, relation| {
            end.is_none_or(|end| {
                truth(&(place.clone() - end.value.clone()), relation) == Some(true)
            })
        };
        let value = |symbol: &Symbol| match symbol {
            symbol if *symbol == own => Some(place.clone()),
            Symbol::Exp(exponent) => {
                let part = integer(1) / integer(i64::from(exponent.parts()));
                let power = exponent.powers().first()?.1;
                let exponent = place.power(i32::from(power)).ok()?.scaled(&part);
                exponent.exponential().ok()
            }
            _ => None,
        };
        is_within(interval.lower.as_ref(), Relation::AtLeast)
            && is_within(interval.upper.as_ref(), Relation::AtMost)
            && Fraction::from(polynomial.clone())
                .substituted(value)
                .is_ok_and(|there| truth(&there, Relation::Less) == Some(true))
    })
}
