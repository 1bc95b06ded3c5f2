//! Equality: the normal form of the difference.
//!
//! A zero normal form proves the identity wherever no divisor vanishes (see
//! [`torse_algebra::polynomial`]); a nonzero one is refuted by a point of the domain. For symbolic
//! degrees the series cancel for every degree or not at all (see [`crate::evaluate::series`]).

use super::domain::Domain;
use super::{Decision, Refutation, witness};
use crate::evaluate::Evaluator;
use crate::evaluate::value::{NOWHERE, Value};
use crate::evidence::Evidence;
use torse_algebra::{Fraction, Polynomial};
use torse_language::fault::Fault;
use torse_language::syntax::Relation;

/// Decides `left == right` on the domain.
///
/// # Errors
/// A [`Fault`] when a divisor is zero identically.
pub fn decide(
    left: &Value,
    right: &Value,
    domain: &Domain<'_>,
    evaluator: &Evaluator<'_>,
) -> Result<Decision, Fault> {
    let pairs: Vec<_> = left.entries().into_iter().zip(right.entries()).collect();
    let mut conditions = vec![];
    let mut failing = None;
    let mut terms = 0;
    for (position, (x, y)) in pairs.iter().enumerate() {
        let difference = x.minus(y);
        terms += difference.plain.numerator().len();
        if difference
            .vanishes()
            .map_err(|e| Fault::exact(NOWHERE, e))?
        {
            conditions.extend(difference.conditions());
            conditions.extend(x.conditions());
            conditions.extend(y.conditions());
        } else {
            failing = Some((position, difference));
            break;
        }
    }
    let Some((position, difference)) = failing else {
        conditions.sort();
        conditions.dedup();
        let conditions = witness::nonconstant(conditions);
        if evaluator.met_symbolic_degree() {
            return Ok(Decision::Proven {
                evidence: Evidence::Induction,
                conditions,
                steps: vec![
                    "both sides are written with the step of the recursion as an operator on the seeds".to_owned(),
                    "the difference has no terms, for every degree at once".to_owned(),
                ],
            });
        }
        return Ok(Decision::identity(
            conditions,
            format!("the normal form of the difference has {terms} terms"),
        ));
    };
    let Some(plain) = difference.as_fraction() else {
        return Err(Fault::limit(
            NOWHERE,
            "two sums of symbolic degree do not cancel",
        ));
    };
    let sides = |values: &Value| {
        values
            .entries()
            .into_iter()
            .map(|q| q.as_fraction().cloned())
            .collect::<Option<Vec<Fraction>>>()
    };
    let (Some(lefts), Some(rights)) = (sides(left), sides(right)) else {
        return Err(Fault::limit(
            NOWHERE,
            "two sums of symbolic degree do not cancel",
        ));
    };
    let mut steps = vec![format!(
        "the normal form of the difference has {} terms",
        plain.numerator().len()
    )];
    if lefts.len() > 1 {
        steps.push(format!("entry {} differs", position + 1));
    }
    if let Some(conditions) = follows(left, right, domain) {
        return Ok(Decision::identity(
            conditions,
            "each difference is a multiple of an equation that is assumed".to_owned(),
        ));
    }
    let point = witness::find(
        plain,
        &lefts.iter().chain(&rights).collect::<Vec<_>>(),
        domain,
        Relation::Different,
    );
    let completed = point.and_then(|point| witness::described(&point, &lefts, &rights));
    Ok(match completed {
        Some(witness) => Decision::Refuted(Box::new(Refutation { witness, sides: Some((lefts, rights)), steps, evidence: Evidence::Witness })),
        None => Decision::Open {
            reason: "the two sides differ as formulas, but no point of the domain was found where they do".to_owned(),
            tried: vec!["simple rational points of the domain".to_owned()],
        },
    })
}

/// The conditions under which every difference is a multiple of an assumed equation, if it is.
fn follows(left: &Value, right: &Value, domain: &Domain<'_>) -> Option<Vec<Polynomial>> {
    let assumed: Vec<&Fraction> = domain
        .constraints
        .iter()
        .filter(|c| c.relation == Relation::Equal)
        .map(|c| &c.value)
        .collect();
    let mut conditions = vec![];
    for (x, y) in left.entries().into_iter().zip(right.entries()) {
        let difference = x.minus(y).as_fraction()?.clone();
        let multiple = |c: &&Fraction| {
            difference
                .numerator()
                .exact_quotient(c.numerator())
                .is_some()
        };
        if !difference.is_zero() && !assumed.iter().any(multiple) {
            return None;
        }
        conditions.extend(difference.conditions().to_vec());
    }
    (!assumed.is_empty()).then(|| witness::nonconstant(conditions))
}

/// Some point of the domain with both sides there.
#[must_use]
pub fn sample(
    left: &Value,
    right: &Value,
    domain: &Domain<'_>,
) -> Option<crate::evidence::Witness> {
    let plain = |value: &Value| {
        value
            .entries()
            .into_iter()
            .map(|q| q.as_fraction().cloned())
            .collect::<Option<Vec<Fraction>>>()
    };
    let (left, right) = (plain(left)?, plain(right)?);
    let all = left
        .iter()
        .chain(&right)
        .cloned()
        .fold(Fraction::zero(), |sum, f| sum + f.clone() * f);
    let sides: Vec<&Fraction> = left.iter().chain(&right).collect();
    let point = witness::find(&all, &sides, domain, Relation::AtLeast)?;
    witness::described(&point, &left, &right)
}
