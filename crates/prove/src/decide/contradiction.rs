//! Domains without points.

use super::domain::{Constraint, Domain};
use super::order::truth;
use super::sign::{Sign, sign};
use super::value::quotient;
use num_traits::Signed;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::rational::integer;
use torse_algebra::{Affine, Polynomial, Rational};
use torse_certificate::proof::Emptiness;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::Relation;

/// A constraint that no point of the declared ranges satisfies that satisfies the others, if one is known; an empty
/// range is one.
#[must_use]
pub fn contradiction(domain: &Domain<'_>, symbols: &[String]) -> Option<Emptiness<Polynomial>> {
    symbols
        .iter()
        .find_map(|name| empty_range(domain, name))
        .or_else(|| {
            let mut numbered = domain.constraints.iter().enumerate();
            let (_, failing) = numbered.find(|(number, c)| fails(domain, *number, c))?;
            Some(Emptiness::Constraint {
                fails: torse_certificate::Constraint {
                    value: quotient(&failing.value),
                    relation: failing.relation,
                },
                others: domain.constraints.len() > 1,
            })
        })
}

fn empty_range(domain: &Domain<'_>, name: &str) -> Option<Emptiness<Polynomial>> {
    let empty = || Some(Emptiness::Range(name.to_owned()));
    match domain.declarations.symbol(name)? {
        SymbolKind::Real(_) => {
            let interval = domain.declared(name);
            let (low, high) = (interval.lower?, interval.upper?);
            let relation = match low.closed && high.closed {
                true => Relation::AtMost,
                false => Relation::Less,
            };
            let gap = low.value - high.value;
            (truth(&gap, relation) == Some(false)).then(empty).flatten()
        }
        SymbolKind::Integer { least, most } => {
            let gap: Affine = least.clone()? - most.clone()?;
            let positive = domain.declarations.least(&gap).is_some_and(|n| n > 0);
            positive.then(empty).flatten()
        }
        _ => None,
    }
}

fn fails(domain: &Domain<'_>, number: usize, c: &Constraint) -> bool {
    if c.value.is_zero() {
        return matches!(
            c.relation,
            Relation::Different | Relation::Less | Relation::Greater
        );
    }
    if let Some(holds) = truth(&c.value, c.relation) {
        return !holds;
    }
    if c.relation == Relation::Different {
        return false;
    }
    if c.relation == Relation::Equal && has_no_integer_root(domain, c.value.numerator()) {
        return true;
    }
    let mut others = domain.clone();
    others.constraints.remove(number);
    let sign = c.value.as_polynomial().and_then(|p| sign(p, &others));
    match c.relation {
        Relation::Less => matches!(sign, Some(Sign::Positive | Sign::Nonnegative)),
        Relation::AtMost => sign == Some(Sign::Positive),
        Relation::Greater => matches!(sign, Some(Sign::Negative | Sign::Nonpositive)),
        Relation::AtLeast if injected(InjectedFault::ClosedEndExcluded) => {
            matches!(sign, Some(Sign::Negative | Sign::Nonpositive))
        }
        Relation::AtLeast => sign == Some(Sign::Negative),
        Relation::Equal => matches!(sign, Some(Sign::Positive | Sign::Negative)),
        Relation::Different => false,
    }
}

/// Integers beyond this are not tried one by one.
const MAX_TRIED: i64 = 1_000;

/// Whether an equation in one integer alone has no integer solution. By Cauchy's bound a solution is not larger than 1 and the
/// largest quotient of a coefficient by the leading one.
fn has_no_integer_root(domain: &Domain<'_>, polynomial: &Polynomial) -> bool {
    let [symbol] = polynomial.symbols() else {
        return false;
    };
    if !domain.is_integer(symbol) {
        return false;
    }
    let coefficients = polynomial.coefficients_in(symbol);
    let numbers = coefficients.iter().map(Polynomial::as_constant);
    let Some(numbers) = numbers.collect::<Option<Vec<Rational>>>() else {
        return false;
    };
    let Some((leading, rest)) = numbers.split_last() else {
        return false;
    };
    let bound = rest.iter().map(|c| (c / leading).abs()).max();
    let bound = bound.map(|largest| (largest + integer(1)).ceil().to_integer());
    let bound = bound.and_then(|bound| i64::try_from(bound).ok());
    let Some(bound) = bound.filter(|bound| *bound <= MAX_TRIED) else {
        return false;
    };
    let value = |n: i64| {
        let from_above = numbers.iter().rev();
        from_above.fold(integer(0), |sum, c| sum * integer(n) + c)
    };
    (-bound..=bound).all(|n| value(n) != integer(0))
}
