//! Checks variation diminution at some degrees by positive Wronskians.

use super::assumptions::Domain;
use super::expand::Expander;
use super::gap::{CheckError, Unsupported, Wrong};
use super::quotient::Quotient;
use super::value::Value;
use torse_certificate::polynomial::Polynomial;
use torse_certificate::symbol::Symbol;
use torse_certificate::wronskian::{Operator, Seeds, Unfit, Wronskians, cell};
use torse_core::{Degrees, Family};

/// Checks every degree, on both halves of the interval.
///
/// The hypotheses are not used: a result for the whole box of the declared ranges holds on every part of it.
pub fn check(
    domain: &Domain<'_>,
    family: &Family,
    degrees: Degrees,
    own: &Wronskians,
) -> Result<(), CheckError> {
    let listed = own.degrees.iter().map(|at| at.degree);
    if !listed.eq(degrees.least..=degrees.most) || degrees.least < family.degree {
        return Err(Wrong::Instances.into());
    }
    let seeds = seeds(domain, family)?;
    let mirrored = seeds.mirrored();
    if let Some(exchange) = own.exchange
        && seeds.exchanged(exchange) != mirrored
    {
        return Err(Wrong::Equation.into());
    }
    let front = Operator::new(seeds).map_err(unfit)?;
    let back = Operator::new(mirrored).map_err(unfit)?;
    for at in &own.degrees {
        cell::check(&front, at.degree, &at.front).map_err(unfit)?;
        match (&at.back, own.exchange) {
            (Some(half), _) => cell::check(&back, at.degree, half).map_err(unfit)?,
            (None, Some(_)) => {}
            (None, None) => return Err(Wrong::NotFilled(1).into()),
        }
    }
    Ok(())
}

fn unfit(unfit: Unfit) -> CheckError {
    match unfit {
        Unfit::Make(what) => Unsupported::Construct(what).into(),
        other => Wrong::Wronskians(other).into(),
    }
}

/// The expanded seeds of a family whose step is `1 - x`, `x` on a part of [0, 1].
fn seeds(domain: &Domain<'_>, family: &Family) -> Result<Seeds, CheckError> {
    let expander = Expander::new(domain.work, &|_| None);
    let symbol = |name: &str| Polynomial::symbol(Symbol::named(name));
    let arguments = family.variables.iter();
    let arguments: Vec<Value> = arguments
        .map(|variable| Value::Number(symbol(variable.name()).into()))
        .collect();
    let ([keep, shift], seeds) = expander.factors_and_seeds(family, &arguments)?;
    let x: Quotient = symbol(family.variable()).into();
    let rest = Quotient::number(torse_numbers::rational::integer(1)).minus(&x, domain.work)?;
    if !keep.equals(&rest, domain.work)? || !shift.equals(&x, domain.work)? {
        return Err(Unsupported::Construct("another step than 1 - x and x").into());
    }
    let mut functions = vec![];
    for seed in &seeds {
        if seed.denominator(domain.work)? != Polynomial::one() {
            return Err(Unsupported::Construct("a seed with a divisor").into());
        }
        let refined = seed.above.refined();
        functions.push(refined.ok_or(Unsupported::Large)?);
    }
    let declared = |name: &str| domain.claim.symbols.get(name);
    Seeds::declared(&functions, family.variable(), &declared).map_err(unfit)
}
