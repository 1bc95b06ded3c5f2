//! Points: numbers for names, and whether they belong to a domain.

use super::constraints::is_equations;
use super::draft::Draft;
use super::solve::{Solved, solve};
use super::sort::sorted;
use super::{Domain, set};
use crate::judge::Judge;
use crate::judgement::Judgement;
use crate::name::Name;
use crate::no_value::Work;
use crate::real::Real;
use std::collections::BTreeMap;
use std::fmt;
use torse_numbers::Affine;
use torse_syntax::derivation::declarations::{Declarations, SymbolKind};
use torse_syntax::formula::Expr;

/// A point: a number for each symbol, coordinate and member that a statement needs.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Point {
    /// The numbers.
    pub values: BTreeMap<Name, Real>,
    /// Whether the equations of the domain could not be solved exactly, so that they hold only to more than 100
    /// digits.
    pub near: bool,
}

impl fmt::Display for Point {
    /// `a = 1/2, P[0][1] = 3`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts: Vec<String> = self
            .values
            .iter()
            .map(|(name, value)| format!("{name} = {value}"))
            .collect();
        write!(f, "{}", parts.join(", "))
    }
}

/// Why a point does not belong to a domain.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Outside {
    /// A number is not in its declared set.
    #[error("{name} is outside of its declared set")]
    Set {
        /// The name.
        name: String,
    },
    /// A hypothesis is not true there.
    #[error("hypothesis {} is {judgement} there", .number + 1)]
    Hypothesis {
        /// Its position among the hypotheses of the claim.
        number: usize,
        /// The judgement of the hypothesis there.
        judgement: Judgement,
    },
}

/// Checks that every number lies in its declared set; if the numbers satisfy equations only approximately, also after
/// small changes. The error names the first one that does not, or is not known to.
pub(crate) fn check_sets(
    declarations: &Declarations,
    values: &BTreeMap<Name, Real>,
    near: bool,
) -> Result<(), Outside> {
    for (name, value) in values {
        let inside = match declarations.symbol(name.declared()) {
            None => false,
            Some(SymbolKind::Real(interval)) => set::contains(interval, value, near) == Some(true),
            Some(SymbolKind::Integer { least, most }) => {
                is_in_range(value, least.as_ref(), most.as_ref(), values)
            }
            Some(SymbolKind::Vector(_) | SymbolKind::Family { .. }) => true,
        };
        if !inside {
            return Err(Outside::Set {
                name: name.to_string(),
            });
        }
    }
    Ok(())
}

fn is_in_range(
    value: &Real,
    least: Option<&Affine>,
    most: Option<&Affine>,
    values: &BTreeMap<Name, Real>,
) -> bool {
    let Some(value) = whole(value) else {
        return false;
    };
    let form = |form: &Affine| {
        let mut multiples = form.multiples();
        multiples.try_fold(form.constant(), |sum, (name, multiple)| {
            let value = whole(values.get(&Name::Symbol(name.into()))?)?;
            sum.checked_add(multiple.checked_mul(value)?)
        })
    };
    least.is_none_or(|low| form(low).is_some_and(|low| low <= value))
        && most.is_none_or(|high| form(high).is_some_and(|high| value <= high))
}

/// The value as a machine integer, if it is one.
fn whole(value: &Real) -> Option<i64> {
    let value = value.as_rational().filter(|v| v.is_integer())?;
    i64::try_from(&value.to_integer()).ok()
}

/// Checks that every hypothesis is true, except those that are `known` to be.
pub(crate) fn check_hypotheses<'a>(
    judge: &Judge<'_, 'a>,
    domain: &Domain<'a>,
    known: impl Fn(&Expr) -> bool,
) -> Result<(), Outside> {
    let at = judge.evaluators();
    let at = at.each(judge);
    for (number, tree) in domain.hypotheses.iter().enumerate() {
        if known(tree) {
            continue;
        }
        let judgement = at.truth(tree);
        if judgement != Judgement::True {
            return Err(Outside::Hypothesis { number, judgement });
        }
    }
    Ok(())
}

/// Changes a draft until it is a point of the domain; a statement may then draw further numbers. Returns whether the
/// point satisfies its equations only approximately, and `None` if it cannot be made a point of the domain.
pub(crate) fn completed(domain: &Domain<'_>, draft: &Draft<'_>, work: &Work) -> Option<bool> {
    sorted(domain, draft, work);
    let solved = solve(domain, draft, work)?;
    let near = solved == Solved::Nearly;
    let declarations = domain.reading.declarations();
    let judge = Judge {
        reading: domain.reading,
        values: &|name| draft.value(name),
        near,
        fails: &|_| false,
        work,
    };
    // Check the sets first, because that is cheap.
    draft
        .look(|values| check_sets(declarations, values, near))
        .ok()?;
    check_hypotheses(&judge, domain, |h| !near && is_equations(declarations, h)).ok()?;
    draft
        .look(|values| check_sets(declarations, values, near))
        .ok()?;
    (!draft.empty.get()).then_some(near)
}
