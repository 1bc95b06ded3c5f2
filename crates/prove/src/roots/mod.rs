//! Roots of formulas: symbols w with `w^2 == r` and `w >= 0` ([`torse_core::Claim::rooted`]).
//!
//! A root is resolved where a value v of it is found: w is v wherever v^2 is r and v >= 0. So the root of a square is that of
//! which it is the square, with the sign that it has on the domain, and the root of r times the square of k is k times the root
//! of r. Those that are left are symbols; a polynomial in them is reduced by their equations. Since `w^2` is r, w vanishes where
//! r does and nowhere else.

mod equations;
pub(crate) mod square;

use crate::decide::domain::Domain;
use crate::decide::root::Root;
use crate::decide::sign;
use square::root_of;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::{Fraction, Polynomial};
use torse_certificate::proof::assumptions::EquationMultiple;
use torse_certificate::sign::Sign;

/// Radicands of more terms than this are not examined for their sign.
const MAX_EXAMINED: usize = 60;
/// The most roots of which two are multiplied to make another one.
const MAX_PAIRED: usize = 8;

/// What a root is, and the sign of numerator times denominator of that.
pub struct Resolved {
    /// The value.
    pub value: Fraction,
    /// What shows that it is not negative.
    pub sign: Sign<Polynomial>,
    /// Multiples of the assumed equations that make the square of the value the radicand.
    pub multiples: Vec<EquationMultiple<Polynomial>>,
}

/// The value of a root of this radicand, if it is found: from squares in it, and from the roots that are known.
#[must_use]
pub fn resolved(radicand: &Fraction, domain: &Domain<'_>) -> Option<Resolved> {
    let radicand = &reduced(radicand, &domain.roots)?;
    // A root of other symbols has no part in this one.
    let symbols = radicand.symbols();
    let shares = |root: &&Root| {
        let own = root.radicand.symbols();
        own.is_empty() || own.iter().any(|symbol| symbols.contains(symbol))
    };
    let known: Vec<&Root> = domain.roots.iter().filter(shares).collect();
    let mut products: Vec<Vec<&Root>> = vec![vec![]];
    products.extend(known.iter().map(|root| vec![*root]));
    for (place, first) in known.iter().enumerate().take(MAX_PAIRED) {
        let later = known.iter().take(MAX_PAIRED).skip(place + 1);
        products.extend(later.map(|second| vec![*first, *second]));
    }
    products
        .iter()
        .find_map(|roots| as_multiple(radicand, roots, domain))
        .or_else(|| equations::resolved(radicand, domain))
}

/// The root as a multiple of these.
fn as_multiple(radicand: &Fraction, roots: &[&Root], domain: &Domain<'_>) -> Option<Resolved> {
    let mut rest = radicand.clone();
    for root in roots {
        rest = rest.over(&root.radicand).ok()?;
    }
    let factor = root_of(&rest)?;
    let symbols = roots
        .iter()
        .map(|root| Fraction::symbol(root.symbol.clone()));
    let value = symbols.fold(factor, |product, root| product * root);
    // Where the radicand has a value the root has one, whatever was divided by on the way to it.
    let value = value.without_conditions();
    let difference = value.clone() * value.clone() - radicand.clone();
    if !reduced(&difference, &domain.roots)?.is_zero() {
        return None;
    }
    let known = |divisor: &Polynomial| {
        radicand.conditions().contains(divisor)
            || domain.assumes_nonzero(divisor)
            || sign::never_zero(divisor, domain)
    };
    if !value.conditions().iter().all(known) {
        return None;
    }
    not_negative(&value, domain)
}

/// A value or its negative, whichever is nowhere negative.
fn not_negative(value: &Fraction, domain: &Domain<'_>) -> Option<Resolved> {
    [value.clone(), -value.clone()]
        .into_iter()
        .find_map(|value| {
            let product = value.numerator() * &value.denominator();
            let shown = match injected(InjectedFault::RootSignIgnored) {
                true => product.power(2),
                false => product,
            };
            let sign = (shown.len() <= MAX_EXAMINED)
                .then(|| sign::nonnegative(&shown, domain))
                .flatten()?;
            Some(Resolved {
                value,
                sign,
                multiples: vec![],
            })
        })
}

/// The value of one of the roots that are known, in terms of the others, if it is found.
#[must_use]
pub fn resolved_by_others(domain: &Domain<'_>) -> Option<(Root, Resolved)> {
    domain.roots.iter().find_map(|root| {
        let mut others = domain.clone();
        others.roots.retain(|other| {
            let mut symbols = other.radicand.symbols().into_iter();
            other.symbol != root.symbol && symbols.all(|symbol| symbol != root.symbol)
        });
        let found = resolved(&root.radicand, &others)?;
        let own = found.value.symbols().contains(&root.symbol);
        (!own).then(|| (root.clone(), found))
    })
}

/// The value with the squares of roots replaced by what they are.
#[must_use]
pub fn reduced(value: &Fraction, roots: &[Root]) -> Option<Fraction> {
    let above = reduced_polynomial(value.numerator(), roots)?;
    let below = reduced_polynomial(&value.denominator(), roots)?;
    above.over(&below).ok()
}

fn reduced_polynomial(polynomial: &Polynomial, roots: &[Root]) -> Option<Fraction> {
    let mut value = Fraction::from(polynomial.clone());
    // A later radicand may contain earlier roots.
    for root in roots.iter().rev() {
        if value.numerator().degree_in(&root.symbol) < 2 {
            continue;
        }
        let below = value.denominator();
        let mut sum = Fraction::zero();
        let mut power = Fraction::integer(1);
        let own = Fraction::symbol(root.symbol.clone());
        let coefficients = value.numerator().coefficients_in(&root.symbol);
        for pair in coefficients.chunks(2) {
            let mut both = pair.iter();
            let even = both.next().cloned().unwrap_or_else(Polynomial::zero);
            let odd = both.next().cloned().unwrap_or_else(Polynomial::zero);
            let part = Fraction::from(even) + Fraction::from(odd) * own.clone();
            sum = sum + part * power.clone();
            power = power * root.radicand.clone();
        }
        value = sum.over(&below.into()).ok()?;
    }
    Some(value)
}

/// The multipliers of equations of which some say what roots are, that make the polynomial times a product of denominators
/// of radicands; nothing if the roots do not reduce it to zero.
#[must_use]
pub fn multipliers(
    polynomial: &Polynomial,
    equations: &[Polynomial],
    roots: &[Root],
) -> Option<Vec<Polynomial>> {
    let mut row = vec![Polynomial::zero(); equations.len()];
    let mut rest = polynomial.clone();
    for root in roots.iter().rev() {
        let mut degree = rest.degree_in(&root.symbol);
        if degree < 2 {
            continue;
        }
        let is_own = |equation: &&Polynomial| equation.degree_in(&root.symbol) == 2;
        let own = root.radicand.numerator();
        let below = root.radicand.denominator();
        let square = Polynomial::symbol(root.symbol.clone()).power(2);
        let equation = &(&square * &below) - own;
        if equation.is_zero() || own.degree_in(&root.symbol) > 0 {
            return None;
        }
        let place = equations
            .iter()
            .position(|e| is_own(&e) && proportion(e, &equation).is_some())?;
        let scale = proportion(equations.get(place)?, &equation)?;
        while degree >= 2 {
            let lead = rest.coefficients_in(&root.symbol).pop()?;
            let power = Polynomial::symbol(root.symbol.clone()).power(u32::from(degree) - 2);
            let multiple = &lead * &power;
            // below*rest - lead*w^(d-2)*(below*w^2 - above) has a lower degree.
            rest = &(&rest * &below) - &(&multiple * &equation);
            for multiplier in &mut row {
                *multiplier = &*multiplier * &below;
            }
            if let Some(slot) = row.get_mut(place) {
                *slot = &*slot + &multiple.scaled(&scale);
            }
            degree = rest.degree_in(&root.symbol);
        }
    }
    rest.is_zero().then_some(row)
}

/// The number by which the first has to be multiplied to make the second, if there is one.
fn proportion(first: &Polynomial, second: &Polynomial) -> Option<torse_algebra::Rational> {
    let quotient = second.exact_quotient(first)?;
    quotient.as_constant()
}

/// The polynomial with what it vanishes with in place of roots that divide it: their radicands.
#[must_use]
pub fn unrooted(polynomial: &Polynomial, roots: &[Root]) -> Polynomial {
    let mut rest = polynomial.clone();
    for root in roots.iter().rev() {
        let own = Polynomial::symbol(root.symbol.clone());
        while !rest.is_zero()
            && let Some(quotient) = rest.exact_quotient(&own)
        {
            rest = &quotient * root.radicand.numerator();
        }
    }
    rest
}

/// The most terms of a polynomial whose norm is looked at; the checker has the same limit.
const MAX_NORMED: usize = 12;

/// A polynomial without roots that is a multiple of this one: `x - y` for `sqrt(x) - sqrt(y)`. Where it is not zero neither is the
/// polynomial. `None` for one without roots, or a long one.
///
/// The checker computes its own on its own polynomials (`crates/checker/src/root.rs`), so that it does not inherit a fault of this one.
#[must_use]
pub fn norm(polynomial: &Polynomial, roots: &[Root]) -> Option<Polynomial> {
    let mut value = reduced_polynomial(polynomial, roots)?.numerator().clone();
    let has = |value: &Polynomial| {
        let mut symbols = roots.iter().map(|root| &root.symbol);
        symbols.any(|symbol| value.symbols().contains(symbol))
    };
    if !has(&value) && value == *polynomial {
        return None;
    }
    for root in roots.iter().rev() {
        if value.len() > MAX_NORMED {
            return None;
        }
        if let [even, odd] = value.coefficients_in(&root.symbol).as_slice() {
            let squared = &odd.power(2) * root.radicand.numerator();
            value = &(&even.power(2) * &root.radicand.denominator()) - &squared;
            value = reduced_polynomial(&value, roots)?.numerator().clone();
        }
    }
    (!has(&value)).then_some(value)
}
