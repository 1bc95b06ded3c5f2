//! Statements at fixed small integers, as identities.
//!
//! With every integer of the claim fixed, an equation is an identity of quotients of polynomials in the other
//! symbols, which is decided exactly at every point where no divisor vanishes. This requires hypotheses that
//! constrain only integers; claims with other equations are checked at points of their domain.

use crate::arithmetic::Arithmetic;
use crate::domain::Domain;
use crate::name::Name;
use crate::no_value::{NoValue, Undefined, Unknown, Work};
use crate::polynomial::{Polynomials, Quotient};
use crate::tree::{Reading, Values};
use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;
use torse_numbers::rational::integer;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{Connective, Expr, Node, Relation};

/// The number of values taken for an integer without an upper bound.
const SPAN: i64 = 3;
/// The largest number of values taken for a bounded integer.
const RANGE: i64 = 12;
/// The largest number of instances of one claim.
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

/// The result for an equation at one instance.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Identity {
    /// Both sides are the same function.
    Holds,
    /// The sides are different functions.
    Differs {
        /// The number of terms of the difference.
        terms: usize,
    },
    /// The instance does not belong to the domain.
    Outside,
    /// A term is undefined at every point.
    Undefined(Undefined),
    /// Not decided here.
    Open(Unknown),
}

impl From<NoValue> for Identity {
    fn from(gap: NoValue) -> Self {
        match gap {
            NoValue::Undefined(why) => Self::Undefined(why),
            NoValue::Unknown(why) => Self::Open(why),
        }
    }
}

/// The smallest instances of a claim: all values of short ranges and the smallest values of unbounded integers, in
/// different combinations. A claim without integers has one empty instance; one that asks for numbers has none, since its
/// equations are identities in no number that it asks for.
#[must_use]
pub fn instances(reading: &Reading<'_>) -> Vec<Instance> {
    if reading.seeks() {
        return vec![];
    }
    let mut pending: Vec<(Arc<str>, &SymbolKind)> = reading
        .names()
        .filter_map(|name| Some((Arc::from(name), reading.declarations().symbol(name)?)))
        .filter(|(_, set)| matches!(set, SymbolKind::Integer { .. }))
        .collect();
    let mut all = vec![Instance::default()];
    // Integers whose bounds refer to others come after those.
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
                    more.0.insert(Arc::clone(&name), value);
                    more
                })
            })
            .collect();
        if all.len() > MAX_INSTANCES {
            // Keep the smallest ones by the sum of the absolute values.
            all.sort_by_key(|instance| instance.0.values().map(|v| v.abs()).sum::<i64>());
            all.truncate(MAX_INSTANCES);
        }
    }
    all
}

fn bounds(set: &SymbolKind) -> impl Iterator<Item = &torse_numbers::Affine> {
    let (least, most) = match set {
        SymbolKind::Integer { least, most } => (least.as_ref(), most.as_ref()),
        _ => (None, None),
    };
    least.into_iter().chain(most)
}

fn values(set: &SymbolKind, instance: &Instance) -> std::ops::RangeInclusive<i64> {
    let SymbolKind::Integer { least, most } = set else {
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

/// Decides a conjunction of equations about the domain of a claim at one instance, within a budget of work.
///
/// Only equations can be identities; other statements are [`Identity::Open`].
#[must_use]
pub fn identity(reading: &Reading<'_>, instance: &Instance, work: &Work) -> Identity {
    let polynomials = Polynomials { work };
    let values = |name: &Name| {
        let declared = reading.declarations().symbol(name.declared())?;
        Some(match (name, declared) {
            (Name::Symbol(symbol), SymbolKind::Integer { .. }) => {
                polynomials.rational(&integer(*instance.0.get(symbol)?))
            }
            _ => Quotient::variable(name.clone()),
        })
    };
    let gaps = |left: &Expr, right: &Expr| {
        let values = Values {
            number: &values,
            near: false,
            fails: &|_| false,
        };
        reading.differences(&[(left, right)], &polynomials, values)
    };
    decide(reading, &polynomials, &gaps).unwrap_or_else(Identity::from)
}

/// The differences of two sides.
type Gaps<'g> = dyn Fn(&Expr, &Expr) -> Result<Vec<Quotient>, NoValue> + 'g;

fn decide(
    reading: &Reading<'_>,
    polynomials: &Polynomials<'_>,
    gaps: &Gaps<'_>,
) -> Result<Identity, NoValue> {
    for (relation, left, right) in &Domain::new(reading).constraints {
        for gap in gaps(left, right)? {
            // A condition `!= 0` on symbols removes only a set of measure zero, so a nonzero function remains nonzero
            // somewhere.
            let Some(gap) = polynomials.as_rational(&gap) else {
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
    let mut pending = vec![reading.tree()];
    let mut differs = None;
    while let Some(tree) = pending.pop() {
        let definition = match &tree.node {
            Node::Name(name) => reading.declarations().definition(name),
            _ => None,
        };
        match (&tree.node, definition) {
            (_, Some(definition)) => pending.push(&definition.body.expr),
            (Node::Join(Connective::And, a, b), _) => pending.extend([&**b, &**a]),
            (Node::Compare(first, rest), _)
                if rest
                    .iter()
                    .all(|(relation, _)| *relation == Relation::Equal) =>
            {
                let mut left = &**first;
                for (_, right) in rest {
                    let terms = gaps(left, right)?.iter().map(Quotient::terms).max();
                    differs = differs.max(terms.filter(|t| *t > 0));
                    left = right;
                }
            }
            _ => {
                let what = "a statement that is no equation";
                return Err(Unknown::NotCovered { what }.into());
            }
        }
    }
    Ok(differs.map_or(Identity::Holds, |terms| Identity::Differs { terms }))
}
