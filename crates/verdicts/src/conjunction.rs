//! Conjunctions: their parts, and of a refuted one which part fails, which hold and by what.

use torse_algebra::work::Allowance;
use torse_prove::decide::Decision;
use torse_prove::evidence::Evidence;
use torse_prove::with_prepared;
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::{Connective, Expr, Node};
use torse_syntax::notation;

/// So many parts may take all the work that one may; more of them have to share it.
const WITH_ALL_WORK: u64 = 50;

/// What is true of each part, a line each; nothing for what is no conjunction. What the first parts are is known; each
/// further one may take so much work, and all together fifty times as much.
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
        let mut allowance = Allowance::new(budget, budget.saturating_mul(WITH_ALL_WORK));
        // A formula without sense was refused with the verdict.
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
    let told = parts.iter().zip(&known);
    told.map(|(part, word)| format!("the part `{}` {word}", notation::text(part)))
        .collect()
}

/// The statements that a conjunction joins.
#[must_use]
pub fn conjuncts(expr: &Expr) -> Vec<&Expr> {
    match &expr.node {
        Node::Join(Connective::And, a, b) => [conjuncts(a), conjuncts(b)].concat(),
        _ => vec![expr],
    }
}

/// What a part is found to be.
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
        Decision::Vacuous(_) => "says nothing: no point satisfies the assumptions".to_owned(),
        Decision::Open { .. } => "is not decided".to_owned(),
    }
}
