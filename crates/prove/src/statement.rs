//! Deciding the statement of a claim: symbolically, or, where a symbolic degree cannot be carried, at small degrees.

use crate::case::Case;
use crate::decide::{self, Decision, instances, sign};
use crate::evidence::Evidence;
use std::collections::BTreeMap;
use torse_algebra::{Fraction, Polynomial};
use torse_language::derivation::{Claim, Written};
use torse_language::fault::Fault;

/// Decides a statement in the setting of a claim: symbolically, or else by instances.
///
/// # Errors
/// [`Fault`] for formulas that do not make sense; limits of the engine end as [`Decision::Open`].
pub fn decide_statement(claim: &Claim, statement: &Written) -> Result<Decision, Fault> {
    let reason = match symbolic(claim, statement, BTreeMap::new()) {
        Ok(Decision::Open { reason, tried }) => (reason, tried),
        Ok(decision) => return Ok(decision),
        Err(fault) if fault.is_limit() => (fault.problem.to_string(), vec![]),
        Err(fault) => return Err(fault),
    };
    let exprs: Vec<_> = std::iter::once(statement)
        .chain(&claim.given)
        .chain(&claim.assumptions)
        .map(|w| &w.expr)
        .collect();
    let integers = instances::integers_used(&exprs, &claim.declarations);
    if integers.is_empty() {
        return Ok(Decision::Open {
            reason: reason.0,
            tried: reason.1,
        });
    }
    let (assignments, complete) = instances::assignments(&integers, &claim.declarations);
    let mut decided = vec![];
    for assignment in assignments {
        let decision = match symbolic(claim, statement, instances::fixed(&assignment)) {
            Ok(decision) => decision,
            Err(fault) if fault.is_limit() => Decision::Open {
                reason: fault.problem.to_string(),
                tried: vec![],
            },
            Err(fault) => return Err(fault),
        };
        let ends = !decision.is_proven()
            || matches!(
                decision,
                Decision::Proven {
                    evidence: Evidence::Witness,
                    ..
                }
            );
        decided.push((assignment, decision));
        if ends {
            break;
        }
    }
    Ok(instances::combined(decided, complete, &reason.0))
}

fn symbolic(
    claim: &Claim,
    statement: &Written,
    fixed: BTreeMap<String, Fraction>,
) -> Result<Decision, Fault> {
    let case = Case::new(claim, statement, fixed)?;
    if let Some(reason) = case.domain.contradiction() {
        return Ok(Decision::Vacuous { reason });
    }
    let decision = decide::decide(&case.statement, &case.domain, &case.evaluator)?;
    Ok(match decision {
        // Conditions that the assumptions state or the domain implies are no conditions.
        Decision::Proven {
            evidence,
            conditions,
            steps,
        } => Decision::Proven {
            evidence,
            conditions: open_conditions(conditions, &case),
            steps: [
                steps,
                decide::ranges(&case.statement, &case.domain, &case.evaluator)?,
            ]
            .concat(),
        },
        other => other,
    })
}

fn open_conditions(conditions: Vec<Polynomial>, case: &Case<'_>) -> Vec<Polynomial> {
    decide::conditions::separated(&conditions)
        .into_iter()
        .filter(|p| !case.domain.assumes_nonzero(p) && !sign::never_zero(p, &case.domain))
        .collect()
}
