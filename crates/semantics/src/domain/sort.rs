//! Chains of order among the hypotheses, such as `t[1] < t[2] < x`: the drawn numbers are sorted instead of being
//! rejected.
//!
//! Numbers in the wrong order are exchanged, and equal ones that must differ are moved apart, until all comparisons
//! between two numbers hold. Whether the point lies in the domain is checked afterwards, as for all points.

use super::Domain;
use super::constraints::Constraint;
use super::draft::Draft;
use crate::arithmetic::Arithmetic;
use crate::name::Name;
use crate::no_value::Work;
use crate::real::{Real, Reals};
use std::cmp::Ordering;
use torse_numbers::rational::ratio;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{Expr, Node, Relation};

/// The largest number of passes over all comparisons.
const ROUNDS: usize = 24;
/// The precision at which inexact numbers are compared, in bits.
const BITS: usize = 128;

/// Sorts the numbers of a draft according to the hypotheses of a claim.
pub(crate) fn sorted(domain: &Domain<'_>, draft: &Draft<'_>, work: &Work) {
    let reals = Reals::new(BITS, work);
    let chain: Vec<(Name, Name, bool)> = {
        let values = |name: &Name| draft.value(name);
        let declarations = domain.reading.declarations();
        let name = |tree: &Expr| {
            // Only names (possibly with indices) are considered; formulas cannot be ordered by exchanging numbers.
            let head = match &tree.node {
                Node::Index(head, _) => &head.node,
                node => node,
            };
            let Node::Name(head) = head else {
                return None;
            };
            let set = declarations.symbol(head)?;
            let is_real = matches!(set, SymbolKind::Real(_) | SymbolKind::Family { .. });
            if declarations.definition(head).is_some() || !is_real {
                return None;
            }
            let names = domain.reading.names_in(tree, &reals, &values).ok()?;
            let [name] = <[Name; 1]>::try_from(names).ok()?;
            Some(name)
        };
        let link = |(relation, left, right): &Constraint<'_>| {
            let (low, high, strict) = match relation {
                Relation::Less => (left, right, true),
                Relation::AtMost => (left, right, false),
                Relation::Greater => (right, left, true),
                Relation::AtLeast => (right, left, false),
                Relation::Equal | Relation::Different => return None,
            };
            Some((name(low)?, name(high)?, strict))
        };
        domain.constraints.iter().filter_map(link).collect()
    };
    for _ in 0..ROUNDS {
        let mut changed = false;
        for (low, high, strict) in &chain {
            let (Some(a), Some(b)) = (draft.value(low), draft.value(high)) else {
                return;
            };
            let Some(order) = reals.minus(&b, &a).ok().and_then(|gap| gap.sign()) else {
                return;
            };
            match order {
                Ordering::Greater => continue,
                Ordering::Equal if !strict => continue,
                Ordering::Equal => {
                    let step = ratio(1, 2).map(Real::from);
                    let Some(apart) = step.and_then(|step| reals.plus(&b, &step).ok()) else {
                        return;
                    };
                    draft.set(high, apart);
                }
                Ordering::Less => {
                    draft.set(low, b);
                    draft.set(high, a);
                }
            }
            changed = true;
        }
        if !changed {
            return;
        }
    }
}
