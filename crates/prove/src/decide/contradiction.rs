//! Domains without points.

use super::domain::{Constraint, Domain};
use super::order::truth;
use super::sign::{Sign, of};
use super::value::quotient;
use torse_algebra::planted::{Planted, planted};
use torse_algebra::{Affine, Polynomial};
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
    let mut others = domain.clone();
    others.constraints.remove(number);
    let sign = c.value.as_polynomial().and_then(|p| of(p, &others));
    match c.relation {
        Relation::Less => matches!(sign, Some(Sign::Positive | Sign::Nonnegative)),
        Relation::AtMost => sign == Some(Sign::Positive),
        Relation::Greater => matches!(sign, Some(Sign::Negative | Sign::Nonpositive)),
        Relation::AtLeast if planted(Planted::ClosedEndExcluded) => {
            matches!(sign, Some(Sign::Negative | Sign::Nonpositive))
        }
        Relation::AtLeast => sign == Some(Sign::Negative),
        Relation::Equal => matches!(sign, Some(Sign::Positive | Sign::Negative)),
        Relation::Different => false,
    }
}
