//! Splits conjunctions: finds which part of a refuted one fails, and which parts hold, with their evidence.

use crate::statement::{PartFinding, PartVerdict};
use torse_algebra::work::Allowance;
use torse_prove::decide::Decision;
use torse_prove::with_prepared;
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::{Connective, Expr, Node};
use torse_syntax::notation;

/// Up to so many parts may each take the full work; more of them share it.
const MAX_PARTS_WITH_FULL_WORK: u64 = 50;

/// Returns what is found of each part; nothing if the statement is no conjunction. The results of the first
/// parts are given; each further part may take this work, and all together `MAX_PARTS_WITH_FULL_WORK` times as
/// much.
#[must_use]
pub fn part_by_part(
    claim: &Claim,
    statement: &Written,
    mut decided: Vec<PartVerdict>,
    budget: u64,
) -> Vec<PartFinding> {
    let parts = conjuncts(&statement.expr);
    if parts.len() < 2 {
        return vec![];
    }
    if decided.len() < parts.len() {
        let mut allowance = Allowance::new(budget, budget.saturating_mul(MAX_PARTS_WITH_FULL_WORK));
        // A formula that makes no sense was refused with the verdict.
        let _ = with_prepared(claim, statement, |prepared| {
            for number in decided.len()..parts.len() {
                let decision = allowance.within(|| prepared.decide_part(number));
                decided.push(match decision {
                    Ok(Ok(Some(decision))) => verdict(&decision),
                    _ => PartVerdict::Undecided,
                });
            }
            Ok(())
        });
    }
    decided.resize(parts.len(), PartVerdict::Undecided);
    let found = parts.iter().zip(decided);
    found
        .map(|(part, finding)| PartFinding {
            part: notation::formula(part),
            finding,
        })
        .collect()
}

/// Returns the statements that a conjunction joins.
#[must_use]
pub fn conjuncts(expr: &Expr) -> Vec<&Expr> {
    match &expr.node {
        Node::Join(Connective::And, a, b) => [conjuncts(a), conjuncts(b)].concat(),
        _ => vec![expr],
    }
}

/// Returns the finding about a part.
pub(crate) fn verdict(decision: &Decision) -> PartVerdict {
    match decision {
        Decision::Proven(proof) if proof.conditions().is_empty() => {
            PartVerdict::Holds(proof.evidence())
        }
        Decision::Proven(proof) => PartVerdict::Conditional(proof.evidence()),
        Decision::Refuted(_) => PartVerdict::Fails,
        Decision::Vacuous(_) => PartVerdict::Vacuous,
        Decision::Open(_) => PartVerdict::Undecided,
    }
}
