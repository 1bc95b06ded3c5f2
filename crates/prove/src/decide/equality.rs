//! Equality: the normal form of the difference.
//!
//! A zero normal form proves the identity wherever no divisor vanishes (see
//! [`torse_algebra::polynomial`]); a nonzero one is refuted by a point of the domain. For symbolic
//! degrees the series cancel for every degree or not at all (see [`crate::evaluate::series`]).

use super::domain::Domain;
use super::value::Proof;
use super::zero_by_sign::forced;
use super::{Decision, Refutation, witness, witness_search};
use crate::evaluate::Evaluator;
use crate::evaluate::value::{UNPLACED, Value};
use crate::{ideal, roots};
use torse_algebra::{Fraction, Polynomial};
use torse_certificate::identity::{Combination, Equations, Identity, Vanishing};
use torse_certificate::point::{Comparison, Counterexample};
use torse_syntax::fault::Fault;
use torse_syntax::formula::Relation;

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
    for (position, (x, y)) in pairs.iter().enumerate() {
        let difference = x.minus(y);
        if difference
            .vanishes()
            .map_err(|e| Fault::exact(UNPLACED, e))?
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
        return Ok(Decision::Proven(Proof::Identity(Identity {
            by: vanishing(evaluator),
            in_order: false,
            divisors: witness::nonconstant(conditions),
        })));
    };
    let Some(plain) = difference.as_fraction() else {
        return Err(Fault::limit(
            UNPLACED,
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
            UNPLACED,
            "two sums of symbolic degree do not cancel",
        ));
    };
    let by_roots = || follows_by_roots(left, right, domain, evaluator);
    if let Some(combination) = follows(left, right, domain, evaluator).or_else(by_roots) {
        return Ok(Decision::Proven(Proof::Combination(combination)));
    }
    let point = witness_search::find(
        plain,
        &lefts.iter().chain(&rights).collect::<Vec<_>>(),
        domain,
        Relation::Different,
    );
    let kind = Comparison::Equation {
        entry: position,
        terms: plain.numerator().len(),
    };
    let completed = point.and_then(|point| witness::described(&point, kind, &lefts, &rights));
    Ok(match completed {
        Some(point) => Decision::Refuted(Box::new(Refutation::at(point).with_sides(lefts, rights))),
        None => follows_from_several(left, right, domain, evaluator)
            .map(Proof::Combination)
            .or_else(|| forced(left, right, domain).map(Proof::ZeroBySign))
            .map_or_else(no_difference_found, Decision::Proven),
    })
}

/// The sides differ as formulas, and nobody knows where.
fn no_difference_found() -> Decision {
    Decision::open(
        "the two sides differ as formulas, but no point of the domain was found where they do",
        &["simple rational points of the domain"],
    )
}

/// How a difference without terms vanishes, by what the evaluator met.
pub(crate) fn vanishing(evaluator: &Evaluator<'_>) -> Vanishing {
    match evaluator.met_symbolic_degree() {
        true => Vanishing::Series,
        false => Vanishing::NormalForm,
    }
}

/// Every difference as a multiple of an assumed equation, if it is one.
pub(crate) fn follows(
    left: &Value,
    right: &Value,
    domain: &Domain<'_>,
    evaluator: &Evaluator<'_>,
) -> Option<Combination<Polynomial>> {
    combined(left, right, domain, evaluator, |numerator, equations| {
        let mut row = vec![Polynomial::zero(); equations.len()];
        let quotients = equations.iter().map(|e| numerator.exact_quotient(e));
        let mut found = row.iter_mut().zip(quotients);
        let (slot, quotient) = found.find_map(|(slot, q)| Some((slot, q?)))?;
        *slot = quotient;
        Some(row)
    })
}

/// Every difference as a sum of multiples of the equations of roots, if these reduce it to zero.
pub(crate) fn follows_by_roots(
    left: &Value,
    right: &Value,
    domain: &Domain<'_>,
    evaluator: &Evaluator<'_>,
) -> Option<Combination<Polynomial>> {
    if domain.roots.is_empty() {
        return None;
    }
    combined(left, right, domain, evaluator, |numerator, equations| {
        roots::multipliers(numerator, equations, &domain.roots)
    })
}

/// Every difference as a sum of multiples of assumed equations, if that is found.
pub(crate) fn follows_from_several(
    left: &Value,
    right: &Value,
    domain: &Domain<'_>,
    evaluator: &Evaluator<'_>,
) -> Option<Combination<Polynomial>> {
    combined(left, right, domain, evaluator, ideal::multipliers)
}

/// Every difference by the multipliers of the assumed equations.
fn combined(
    left: &Value,
    right: &Value,
    domain: &Domain<'_>,
    evaluator: &Evaluator<'_>,
    multipliers_of: impl Fn(&Polynomial, &[Polynomial]) -> Option<Vec<Polynomial>>,
) -> Option<Combination<Polynomial>> {
    let constraints = domain.constraints.iter();
    let equations: Vec<Polynomial> = constraints
        .filter(|c| c.relation == Relation::Equal)
        .map(|c| c.value.numerator().clone())
        .collect();
    if equations.is_empty() {
        return None;
    }
    let (mut conditions, mut multipliers) = (vec![], vec![]);
    for (x, y) in left.entries().into_iter().zip(right.entries()) {
        let difference = x.minus(y).as_fraction()?.clone();
        multipliers.push(match difference.is_zero() {
            true => vec![Polynomial::zero(); equations.len()],
            false => multipliers_of(difference.numerator(), &equations)?,
        });
        conditions.extend(difference.conditions().to_vec());
    }
    let used = |row: &Vec<Polynomial>| row.iter().filter(|m| !m.is_zero()).count();
    Some(Combination {
        of: match multipliers.iter().any(|row| used(row) > 1) {
            true => Equations::Together,
            false => Equations::Assumed,
        },
        equations,
        multipliers,
        divisors: witness::nonconstant(conditions),
        by: vanishing(evaluator),
    })
}

/// Some point of the domain with both sides there.
#[must_use]
pub fn sample(
    left: &Value,
    right: &Value,
    domain: &Domain<'_>,
) -> Option<Counterexample<Polynomial>> {
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
    let point = witness_search::find(&all, &sides, domain, Relation::AtLeast)?;
    witness::described(&point, Comparison::Domain, &left, &right)
}
