//! Splits conjunctions: finds which part of a refuted one fails, and which parts hold, with their evidence.

use torse_algebra::work::Allowance;
use torse_prove::decide::Decision;
use torse_prove::evidence::Evidence;
use torse_prove::with_prepared;
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::{Connective, Expr, Node};
use torse_syntax::notation;

/// Up to so many parts may each take the full work; more of them share it.
const MAX_PARTS_WITH_FULL_WORK: u64 = 50;

/// Returns what is true of each part, a line each; nothing if the statement is no conjunction. The results of the first
/// parts are given; each further part may take this work, and all together `MAX_PARTS_WITH_FULL_WORK` times as
/// much.
#[must_use]
pub fn part_by_part(
    claim: &Claim,
    statement: &Written,
    mut known: Vec<String>,
    budget: u64,
) -> Vec<String> {
    let parts = conjuncts(&statement.expr);
    if parts.len() < 2 {
        return vec![];
    }
    let undecided = || "is not decided".to_owned();
    if known.len() < parts.len() {
        let mut allowance = Allowance::new(budget, budget.saturating_mul(MAX_PARTS_WITH_FULL_WORK));
        // A formula that makes no sense was refused with the verdict.
        let _ = with_prepared(claim, statement, |prepared| {
            for number in known.len()..parts.len() {
                let decided = allowance.within(|| prepared.decide_part(number));
                known.push(match decided {
                    Ok(Ok(Some(decision))) => word(&decision),
                    _ => undecided(),
                });
            }
            Ok(())
        });
    }
    known.resize_with(parts.len(), undecided);
    let described = parts.iter().zip(&known);
    described
        .map(|(part, word)| format!("the part `{}` {word}", notation::text(part)))
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

/// Describes the finding about a part.
pub(crate) fn word(decision: &Decision) -> String {
    match decision {
        Decision::Proven(proof) => {
            let by = match proof.evidence() {
                Evidence::Identity => "an identity",
                Evidence::Induction => "induction",
                Evidence::Inequality => "a certificate of sign",
                Evidence::Enclosure => "certified digits",
                Evidence::Witness => "an exact point",
                Evidence::CheckedRange | Evidence::Sampled => "instances that were tried",
            };
            match proof.conditions().is_empty() {
                true => format!("holds, by {by}"),
                false => format!("holds under a condition, by {by}"),
            }
        }
        Decision::Refuted(_) => "fails".to_owned(),
        Decision::Vacuous(_) => "says nothing: no point satisfies the hypotheses".to_owned(),
        Decision::Open { .. } => "is not decided".to_owned(),
    }
}
