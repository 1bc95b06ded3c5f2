//! `integral(f, x, a, b)`: the difference of an antiderivative at the ends.
//!
//! In normal form the integrand is a sum of `x^j t` with monomials t in the sines, cosines and exponentials of x, over what does not
//! change with x. Derivation maps the span of finitely many such t, those that it makes of the given ones, into itself if angles
//! and exponents are linear in x. So an antiderivative is sought as `sum of x^j G_j` with the G_j of that span, from the highest j down:
//!
//! `G_j' = f_j - (j + 1) G_(j+1)`,
//!
//! linear equations for the coefficients of G_j, in which the constant of `G_(j+1)` is an unknown too: it takes away what has no
//! antiderivative in the span, the constants. An exponential E in the denominator goes
//! with the sought one, `(G/E)' = (G' - r G)/E` for `E' = r E`. What is found is **differentiated**, and is used only if that gives f back. Then, by
//! the fundamental theorem, `F(b) - F(a)` is the integral, wherever the denominators of F do not vanish: f is continuous.

use super::quantity::Quantity;
use super::value::Value;
use super::{Environment, Evaluator, angles};
use std::collections::{BTreeMap, BTreeSet};
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::matrix::Matrix;
use torse_algebra::{Fraction, Polynomial, Symbol};
use torse_core::{Term, Variable};
use torse_syntax::fault::Fault;
use torse_syntax::formula::Place;

/// The most monomials in sines, cosines and exponentials.
const MAX_SPAN: usize = 33;
/// The highest power of the variable.
const MAX_POWER: u16 = 64;

impl Evaluator<'_> {
    /// The integral of the body by its variable.
    pub(super) fn integral(
        &self,
        variable: &Variable,
        [low, high]: [&Term; 2],
        body: &Term,
        place: Place,
        bound: &Environment,
    ) -> Result<Value, Fault> {
        let enclosing = self.derivatives.get();
        let name = self.differential(variable.name(), enclosing);
        let mut inner = bound.clone();
        inner.insert(variable.number(), Fraction::named(&name).into());
        self.derivatives.set(enclosing + 1);
        let body = self.value(body, &inner);
        self.derivatives.set(enclosing);
        let zero = Value::from(Fraction::zero());
        let (body, _) = angles::in_finest(body?, zero, place)?;
        let whole = body.mapped(&|q: &Quantity| {
            let what = "an integral of a sum of symbolic degree";
            let function = q.as_fraction().ok_or_else(|| Fault::limit(place, what))?;
            let found = antiderivative(function, &name);
            let found = found.map_err(|what| Fault::limit(place, what))?;
            Ok::<Quantity, Fault>(found.into())
        })?;
        let at = |end: &Term| {
            let end = self.number(end, bound)?;
            self.placed(&whole, &name, &end, place)
        };
        let (from, to) = (at(low)?, at(high)?);
        if injected(InjectedFault::LowerEndForgotten) {
            return Ok(to);
        }
        let values = to.entries().into_iter().zip(from.entries());
        let values = values.map(|(to, from)| to.minus(from)).collect();
        super::refilled(&to, values)
    }
}

/// Monomials in functions of the variable, each with the coefficients of the powers of the variable beside it.
type Split = BTreeMap<Polynomial, BTreeMap<u16, Polynomial>>;

/// A polynomial by its monomials in functions of the variable.
fn split(p: &Polynomial, name: &str) -> Split {
    let mut found = Split::new();
    for term in p.terms() {
        let (mut function, mut rest) = (
            Polynomial::integer(1),
            Polynomial::constant(&term.coefficient),
        );
        let mut power = 0;
        for (symbol, exponent) in term.powers {
            let factor = || Polynomial::symbol(symbol.clone()).power(u32::from(exponent));
            match symbol {
                Symbol::Named(own) if **own == *name => power = exponent,
                symbol if symbol.depends_on(name) => function = &function * &factor(),
                _ => rest = &rest * &factor(),
            }
        }
        let slot = found.entry(function).or_default();
        let slot = slot.entry(power).or_insert_with(Polynomial::zero);
        *slot = &*slot + &rest;
    }
    found
}

/// What has this function for its derivative by the name; the reason if nothing is found.
fn antiderivative(function: &Fraction, name: &str) -> Result<Fraction, &'static str> {
    let moves = |p: &Polynomial| p.symbols().iter().any(|s| s.depends_on(name));
    // The exponential below, and its rate over itself: `(G/E)' = (G' - r G)/E` where `E' = r E`.
    let (mut exponential, mut decay) = (Polynomial::integer(1), Polynomial::zero());
    for (p, n) in function.denominator_factors().filter(|(p, _)| moves(p)) {
        let quotient = "an integral of a quotient by what changes with its variable";
        if !is_exponential(p) {
            return Err(quotient);
        }
        let rate = Fraction::from(p.derivative(name)).over(&p.clone().into());
        let rate = rate.ok().and_then(|rate| rate.as_polynomial().cloned());
        let rate = rate.filter(|rate| !moves(rate)).ok_or(NOT_LINEAR)?;
        decay = &decay + &rate.scaled(&torse_algebra::rational::integer(i64::from(n)));
        exponential = &exponential * &p.power(n);
    }
    // Where one of them vanishes between the ends the integrand has no value there, and the integral none.
    let mut recorded = function.conditions().iter();
    if recorded.any(|p| moves(p) && !is_exponential(p)) {
        return Err("an integral of a quotient that may have no value between the ends");
    }
    let above = split(function.numerator(), name);
    let powers = above.values().flat_map(BTreeMap::keys).copied();
    let highest = powers.max().unwrap_or(0);
    if highest >= MAX_POWER {
        return Err("an integral of so high a power");
    }
    let one = exponential;
    let (span, mut rates) = span(above.keys().cloned().chain([one.clone()]).collect(), name)?;
    for (function, rate) in &mut rates {
        let slot = rate
            .entry(function.clone())
            .or_insert_with(Polynomial::zero);
        *slot = &*slot - &decay;
    }
    // The equation for the coefficients of G_j; in the place of the constant, which has no rate, stands the one before it.
    let entry = |row: usize, column: usize| -> Fraction {
        let (Some(row), Some(column)) = (span.get(row), span.get(column)) else {
            return Fraction::zero();
        };
        if *column == one {
            return Fraction::integer(i64::from(*row == one));
        }
        let rate = rates.get(column).and_then(|rate| rate.get(row));
        rate.map_or_else(Fraction::zero, |rate| rate.clone().into())
    };
    let strange = "an integral without such an antiderivative";
    let size = span.len();
    let matrix = Matrix::from_fn(size, size, entry).map_err(|_| strange)?;
    let mut whole = Fraction::zero();
    let mut next = vec![Fraction::zero(); size];
    let variable = Fraction::named(name);
    let power = |j: u16| variable.power(i32::from(j)).map_err(|_| strange);
    for j in (0..=highest).rev() {
        let right: Vec<Fraction> = (span.iter().zip(&next))
            .map(|(function, next)| {
                let own = above.get(function).and_then(|all| all.get(&j));
                let own = own.map_or_else(Fraction::zero, |p| p.clone().into());
                own - Fraction::integer(i64::from(j) + 1) * next.clone()
            })
            .collect();
        let right = Matrix::column(right).map_err(|_| strange)?;
        let solution = matrix.solve(&right).map_err(|_| strange)?;
        let mut own = vec![];
        for (place, function) in span.iter().enumerate() {
            let value = solution.get(place, 0).cloned().ok_or(strange)?;
            let value = value.without_conditions();
            if *function == one {
                let constant = value.over(&Fraction::integer(i64::from(j) + 1));
                let constant = constant.map_err(|_| strange)? * Fraction::from(one.clone());
                whole = whole + constant * power(j + 1)?;
                own.push(Fraction::zero());
                continue;
            }
            whole = whole + value.clone() * Fraction::from(function.clone()) * power(j)?;
            own.push(value);
        }
        next = own;
    }
    let below = Fraction::from(function.denominator());
    let whole = whole.over(&below).map_err(|_| strange)?;
    // What the elimination divided by on its way matters no more: where no denominator vanishes the derivative is right.
    let divisors: Vec<Polynomial> = (whole.denominator_factors())
        .map(|(factor, _)| factor.clone())
        .filter(|factor| !factor.is_constant())
        .collect();
    let whole = whole.without_conditions();
    match (whole.derivative(name) - function.clone().without_conditions()).is_zero() {
        true => Ok(whole.under(&divisors).under(function.conditions())),
        false => Err(strange),
    }
}

const NOT_LINEAR: &str = "an integral of an exponential that is not linear in its variable";

/// Whether a polynomial is an exponential alone.
fn is_exponential(p: &Polynomial) -> bool {
    match p.symbols() {
        [symbol @ Symbol::Exp(_)] => *p == Polynomial::symbol(symbol.clone()),
        _ => false,
    }
}

/// The coefficients of a derivative.
type Rates = BTreeMap<Polynomial, BTreeMap<Polynomial, Polynomial>>;

/// All monomials in functions of the variable that derivation makes of these, in order, and what it makes of each.
fn span(
    mut pending: Vec<Polynomial>,
    name: &str,
) -> Result<(Vec<Polynomial>, Rates), &'static str> {
    let mut span: BTreeSet<Polynomial> = BTreeSet::new();
    let mut rates = Rates::new();
    while let Some(function) = pending.pop() {
        if !span.insert(function.clone()) {
            continue;
        }
        if span.len() > MAX_SPAN {
            return Err("an integral of so many products of sines, cosines and exponentials");
        }
        let mut rate = BTreeMap::new();
        for (inner, powers) in split(&function.derivative(name), name) {
            for (power, coefficient) in powers {
                if power > 0 {
                    return Err(NOT_LINEAR);
                }
                rate.insert(inner.clone(), coefficient);
            }
            pending.push(inner);
        }
        rates.insert(function, rate);
    }
    Ok((span.into_iter().collect(), rates))
}
