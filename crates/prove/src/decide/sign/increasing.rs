//! Signs of polynomials in a variable and its functions, by their derivatives: what is not negative at zero and increases from there
//! is not negative.
//!
//! **Theorem.** Let f be differentiable on the interval from 0 to t and c be a number. If `f(0) >= 0` and `f' - c*f >= 0` on it then
//! `f(t) >= 0`; it is positive if `f(0)` is. If `f(0) >= 0`, `f'(0) == c*f(0)` and `f'' - 2*c*f' + c^2*f >= 0` on it, the same is
//! true, also for negative t.
//!
//! *Proof.* The derivatives of `g = f*exp(-c*x)` are `f' - c*f` and `f'' - 2*c*f' + c^2*f` times `exp(-c*x)`. So in the first case g
//! increases from `f(0)`; in the second one its derivative is zero at 0 and increases, so that g is smallest there.
//!
//! A point of the domain has the whole interval from 0 in the domain where nothing but numbers bounds the variable: all other
//! constraints with it are left out.

use super::growth::{at_zero, slope};
use super::proof::{Proof, Shown};
use super::simple_places::{is_negative_somewhere, variable};
use super::{Sign, line, taylor, without_equations};
use crate::decide::domain::{Constraint, Domain};
use crate::decide::interval::Bound;
use crate::decide::order::truth;
use std::cell::Cell;
use std::sync::Arc;
use torse_algebra::rational::integer;
use torse_algebra::{Polynomial, Rational, Symbol};
use torse_syntax::formula::Relation;

/// The longest polynomial that is looked at, and how often one is differentiated.
const MAX_TERMS: usize = 24;
const MAX_DEPTH: u32 = 3;
/// How many signs are asked for in one search.
const MAX_ATTEMPTS: u32 = 16;
/// The highest power of an exponential.
const MAX_POWER: u32 = 4;

/// A sign of the polynomial that its derivatives show.
pub(super) fn proof(polynomial: &Polynomial, domain: &Domain<'_>) -> Option<(Sign, Proof)> {
    if !domain.part.is_empty() {
        return None;
    }
    let search = Search {
        left: Cell::new(MAX_ATTEMPTS),
    };
    let not_negative = |own: &Polynomial| match is_negative_somewhere(own, domain) {
        true => None,
        false => search.not_negative(own, domain, MAX_DEPTH),
    };
    not_negative(polynomial).or_else(|| {
        let (sign, proof) = not_negative(&-polynomial)?;
        Some((sign.negated(), proof))
    })
}

/// What a search has spent.
struct Search {
    /// How many signs may still be asked for.
    left: Cell<u32>,
}

impl Search {
    fn not_negative(
        &self,
        polynomial: &Polynomial,
        domain: &Domain<'_>,
        depth: u32,
    ) -> Option<(Sign, Proof)> {
        if polynomial.len() > MAX_TERMS || depth == 0 {
            return None;
        }
        self.along(variable(polynomial)?, polynomial, domain, depth)
    }

    /// That the polynomial is not negative, by its derivatives by this variable.
    fn along(
        &self,
        name: &Arc<str>,
        polynomial: &Polynomial,
        domain: &Domain<'_>,
        depth: u32,
    ) -> Option<(Sign, Proof)> {
        let symbol = Symbol::Named(Arc::clone(name));
        let around = domain_along(&symbol, polynomial, domain)?;
        let start = at_zero(polynomial, name)?;
        let (start_sign, start_proof) = self.shown(&start, &around, 0)?;
        let interval = around.interval(&symbol);
        let (lower, upper) = (interval.lower.as_ref(), interval.upper.as_ref());
        let from_zero = lower.is_some_and(|end| end.value.is_zero());
        let is_open = lower.is_some_and(|end| !end.closed);
        let is_beyond = |end: Option<&Bound>, relation| {
            end.is_some_and(|end| truth(&end.value, relation) != Some(true))
        };
        // The intervals from zero are parts of that of the variable.
        if is_beyond(lower, Relation::AtMost) || is_beyond(upper, Relation::AtLeast) {
            return None;
        }
        let order = if from_zero { 1 } else { 2 };
        for rate in rates(polynomial) {
            let Some(slope) = slope(polynomial, name, &rate, order) else {
                continue;
            };
            let Some((slope_sign, slope_proof)) = self.shown(&slope, &around, depth - 1) else {
                continue;
            };
            let grows = from_zero && is_open && slope_sign == Sign::Positive;
            let strict = start_sign == Sign::Positive || grows;
            let sign = match strict {
                true => Sign::Positive,
                false => Sign::Nonnegative,
            };
            let own = Box::new([start_proof, slope_proof]);
            let shown = Shown::Increasing(symbol, rate, order, own, strict);
            let polynomial = polynomial.clone();
            return Some((sign, Proof { polynomial, shown }));
        }
        None
    }

    /// That a polynomial is not negative: by other means, or by its derivatives again.
    fn shown(
        &self,
        polynomial: &Polynomial,
        domain: &Domain<'_>,
        depth: u32,
    ) -> Option<(Sign, Proof)> {
        self.left.set(self.left.get().checked_sub(1)?);
        if is_negative_somewhere(polynomial, domain) {
            return None;
        }
        let wanted = |(sign, _): &(Sign, Proof)| matches!(sign, Sign::Positive | Sign::Nonnegative);
        without_equations(polynomial, domain)
            .filter(wanted)
            .or_else(|| line::proof(polynomial, domain, &[]).filter(wanted))
            .or_else(|| taylor::proof(polynomial, domain).filter(wanted))
            .or_else(|| self.not_negative(polynomial, domain, depth))
    }
}

/// The numbers c of `f' - c*f`: up to the highest power of an exponential, those in the middle first.
fn rates(polynomial: &Polynomial) -> Vec<Rational> {
    let exponentials = polynomial
        .symbols()
        .iter()
        .filter_map(|symbol| match symbol {
            Symbol::Exp(exponent) => {
                Some((u32::from(polynomial.degree_in(symbol)), exponent.parts()))
            }
            _ => None,
        });
    let Some((highest, parts)) = exponentials.max() else {
        return vec![];
    };
    let highest = i64::from(highest.min(MAX_POWER));
    let mut powers: Vec<i64> = (0..=highest).collect();
    powers.sort_by_key(|power| (2 * power - highest).abs());
    let rate = |power| integer(power) / integer(i64::from(parts));
    powers.into_iter().map(rate).collect()
}

/// A domain around this one that contains the interval from zero to each of its points; none if what else is known of the variable
/// cannot be left out.
fn domain_along<'a>(
    variable: &Symbol,
    polynomial: &Polynomial,
    domain: &Domain<'a>,
) -> Option<Domain<'a>> {
    let name = variable.names().next()?;
    let depends = |symbols: &[Symbol]| symbols.iter().any(|s| s.depends_on(name));
    let roots = domain.roots.iter().map(|root| &root.radicand);
    let logarithms = domain.logarithms.iter().map(|own| &own.argument);
    let arcs = domain.arcs.iter().map(|own| &own.argument);
    let mut arguments = roots.chain(logarithms).chain(arcs);
    if domain.is_integer(variable) || arguments.any(|own| depends(&own.symbols())) {
        return None;
    }
    // What is true of exponentials everywhere stays, in its place.
    let bare = Domain::new(domain.declarations);
    let mut symbols = polynomial.symbols().to_vec();
    symbols.push(variable.clone());
    let everywhere = bare.with_ordered_exponentials(&symbols);
    let is_known = |own: &Constraint| {
        let mut all = everywhere.constraints.iter();
        all.any(|c| c.relation == own.relation && c.value == own.value)
    };
    let mut around = domain.clone();
    for constraint in &mut around.constraints {
        let symbols = constraint.value.symbols();
        let is_end = symbols == [variable.clone()]
            && constraint
                .value
                .as_polynomial()
                .is_some_and(|p| p.degree_in(variable) == 1)
            && !matches!(constraint.relation, Relation::Equal | Relation::Different);
        if depends(&symbols) && !is_end && !is_known(constraint) {
            constraint.value = Polynomial::zero().into();
            constraint.relation = Relation::AtLeast;
        }
    }
    Some(around)
}
