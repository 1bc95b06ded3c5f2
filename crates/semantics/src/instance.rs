//! Statements at fixed small integers, as identities.
//!
//! With every integer of the claim fixed, an equation is an identity of quotients of polynomials in the other symbols:
//! decided exactly, at every point where its divisors are not zero. That needs hypotheses that fix nothing but
//! integers; a claim with other equations is left to the points of its domain.

use crate::arithmetic::Arithmetic;
use crate::domain::constraints::constraints;
use crate::evaluate::Evaluator;
use crate::gap::{Gap, Undefined, Unknown, Work};
use crate::name::Name;
use crate::polynomial::{Polynomials, Quotient};
use crate::series::Series;
use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;
use torse_core::{Claim, Set, Statement};
use torse_numbers::rational::integer;
use torse_syntax::formula::{Connective, Relation};

/// How many values of an integer without an upper bound are taken.
const SPAN: i64 = 3;
/// How many values of a bounded one.
const RANGE: i64 = 12;
/// The most instances of one claim.
const MAX_INSTANCES: usize = 24;

/// Values of the integers of a claim.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Default)]
pub struct Instance(pub BTreeMap<Arc<str>, i64>);

impl fmt::Display for Instance {
    /// `k = 2, l = 4`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let parts: Vec<String> = self.0.iter().map(|(n, v)| format!("{n} = {v}")).collect();
        write!(f, "{}", parts.join(", "))
    }
}

/// What an equation is at one instance.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Identity {
    /// Both sides are the same function.
    Holds,
    /// They are not: the difference has so many terms.
    Differs {
        /// The number of terms.
        terms: usize,
    },
    /// The instance is no instance of the domain.
    Outside,
    /// A term is undefined at every point.
    Undefined(Undefined),
    /// Not decided here.
    Open(Unknown),
}

impl From<Gap> for Identity {
    fn from(gap: Gap) -> Self {
        match gap {
            Gap::Undefined(why) => Self::Undefined(why),
            Gap::Unknown(why) => Self::Open(why),
        }
    }
}

/// The smallest instances of a claim: all values of short ranges, the least ones of unbounded integers, in different
/// combinations. One empty instance for a claim without integers.
#[must_use]
pub fn instances(claim: &Claim) -> Vec<Instance> {
    let mut pending: Vec<(&Arc<str>, &Set)> = claim
        .symbols
        .iter()
        .filter(|(_, set)| matches!(set, Set::Integer { .. }))
        .collect();
    let mut all = vec![Instance::default()];
    // Integers whose bounds name others come after those.
    while !pending.is_empty() {
        let ready = pending.iter().position(|(_, set)| {
            bounds(set).all(|form| {
                form.multiples()
                    .all(|(name, _)| all.first().is_none_or(|first| first.0.contains_key(name)))
            })
        });
        let Some(ready) = ready else {
            return vec![];
        };
        let (name, set) = pending.remove(ready);
        all = all
            .iter()
            .flat_map(|instance| {
                values(set, instance).map(|value| {
                    let mut more = instance.clone();
                    more.0.insert(Arc::clone(name), value);
                    more
                })
            })
            .collect();
        if all.len() > MAX_INSTANCES {
            // The smallest ones, by the sum of the values.
            all.sort_by_key(|instance| instance.0.values().map(|v| v.abs()).sum::<i64>());
            all.truncate(MAX_INSTANCES);
        }
    }
    all
}

fn bounds(set: &Set) -> impl Iterator<Item = &torse_numbers::Affine> {
    let (least, most) = match set {
        Set::Integer { least, most } => (least.as_ref(), most.as_ref()),
        _ => (None, None),
    };
    least.into_iter().chain(most)
}

fn values(set: &Set, instance: &Instance) -> std::ops::RangeInclusive<i64> {
    let Set::Integer { least, most } = set else {
        return 0..=0;
    };
    let form = |form: &torse_numbers::Affine| {
        let mut multiples = form.multiples();
        multiples.try_fold(form.constant(), |sum, (name, multiple)| {
            sum.checked_add(multiple.checked_mul(*instance.0.get(name)?)?)
        })
    };
    let least = least.as_ref().and_then(form);
    match (least, most.as_ref().and_then(form)) {
        (Some(least), Some(most)) => least..=most.min(least.saturating_add(RANGE - 1)),
        (Some(least), None) => least..=least.saturating_add(SPAN - 1),
        (None, Some(most)) => most.saturating_sub(SPAN - 1)..=most,
        (None, None) => -1..=1,
    }
}

/// Decides a conjunction of equations about the domain of a claim at one instance, with a budget of work.
///
/// Only equations are identities: other statements are [`Identity::Open`].
#[must_use]
pub fn identity(
    claim: &Claim,
    statement: &Statement,
    instance: &Instance,
    work: &Work,
) -> Identity {
    let polynomials = Polynomials { work };
    let values = |name: &Name| {
        let declared = claim.symbols.get(name.declared())?;
        Some(match (name, declared) {
            (Name::Symbol(symbol), Set::Integer { .. }) => {
                polynomials.rational(&integer(*instance.0.get(symbol)?))
            }
            _ => Quotient::variable(name.clone()),
        })
    };
    let at = Evaluator::new(&polynomials, &values);
    decide(claim, statement, &at).unwrap_or_else(Identity::from)
}

type At<'a, 'b> = Evaluator<'a, Polynomials<'b>>;

fn decide(claim: &Claim, statement: &Statement, at: &At<'_, '_>) -> Result<Identity, Gap> {
    for (relation, left, right) in constraints(claim) {
        for gap in gaps(left, right, at)? {
            // An open condition on symbols leaves a function that is not zero somewhere different from zero.
            let Some(gap) = at.arithmetic.as_rational(&gap) else {
                if matches!(relation, Relation::Equal) {
                    let what = "an equation between symbols among the hypotheses";
                    return Err(Unknown::NotCovered { what }.into());
                }
                continue;
            };
            let sign = gap.cmp(&integer(0));
            let holds = match relation {
                Relation::Equal => sign.is_eq(),
                Relation::Different => sign.is_ne(),
                Relation::Less => sign.is_lt(),
                Relation::AtMost => sign.is_le(),
                Relation::Greater => sign.is_gt(),
                Relation::AtLeast => sign.is_ge(),
            };
            if !holds {
                return Ok(Identity::Outside);
            }
        }
    }
    let mut pending = vec![statement];
    let mut differs = None;
    while let Some(statement) = pending.pop() {
        match statement {
            Statement::Join(Connective::And, a, b) => pending.extend([&**b, &**a]),
            Statement::Compare {
                relation: Relation::Equal,
                left,
                right,
            } => {
                let terms = gaps(left, right, at)?.iter().map(Quotient::terms).max();
                differs = differs.max(terms.filter(|t| *t > 0));
            }
            _ => {
                let what = "a statement that is no equation";
                return Err(Unknown::NotCovered { what }.into());
            }
        }
    }
    Ok(differs.map_or(Identity::Holds, |terms| Identity::Differs { terms }))
}

fn gaps(
    left: &torse_core::Term,
    right: &torse_core::Term,
    at: &At<'_, '_>,
) -> Result<Vec<Quotient>, Gap> {
    let a = at.arithmetic;
    let pairs = at.value(left)?.pairs(&at.value(right)?, a)?;
    let gap = |(x, y): (Series<Quotient>, Series<Quotient>)| {
        let gap = x.minus(&y, a)?;
        gap.as_number()
            .cloned()
            .ok_or_else(|| Gap::shape("an infinitesimal to a comparison"))
    };
    pairs.into_iter().map(gap).collect()
}
