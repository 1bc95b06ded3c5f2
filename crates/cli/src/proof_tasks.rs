//! What is to be proved for the kernel, from the outcomes of a run.

use crate::run::Run;
use std::collections::BTreeMap;
use torse_rocq::solutions::{Solved, solutions};
use torse_rocq::task::ProofTask;
use torse_syntax::derivation::{Claim, Paper};
use torse_verdicts::certificate::DecisionCertificate;
use torse_verdicts::outcome::Outcome;

/// Returns the proof tasks of all claims and readings that have outcomes, paper by paper.
pub fn proof_tasks<'c>(papers: &'c [Paper], run: &Run) -> Vec<(String, Vec<ProofTask<'c>>)> {
    let outcomes: BTreeMap<&str, &Outcome> =
        run.outcomes().map(|o| (o.claim.id.as_str(), o)).collect();
    let of = |paper: &'c Paper| {
        let mut found = vec![];
        for claim in &paper.claims {
            let id = claim.entry.id.get_ref();
            let Some(outcome) = outcomes.get(id.as_str()) else {
                continue;
            };
            found.push(proof_task(id.clone(), claim, outcome));
            for (reading, outcome) in claim.readings.iter().zip(outcome.readings()) {
                let id = format!("{id}.{}", reading.name);
                found.push(proof_task(id, &reading.claim, &outcome.outcome));
            }
        }
        (paper.head.id.clone(), found)
    };
    papers.iter().map(of).collect()
}

fn proof_task<'c>(id: String, claim: &'c Claim, outcome: &Outcome) -> ProofTask<'c> {
    let texts = |formulas: &[torse_syntax::notation::Formula]| -> Vec<String> {
        formulas
            .iter()
            .map(|formula| formula.text.clone())
            .collect()
    };
    let correction = outcome.correction();
    ProofTask {
        id,
        claim,
        verdict: outcome.verdict(),
        evidence: outcome.evidence(),
        conditions: texts(outcome.conditions()),
        correction: correction.map(|c| (c.statement.text.clone(), texts(&c.conditions))),
        witness: outcome
            .witness()
            .map_or_else(Vec::new, |witness| witness.at.clone()),
        solved: outcome
            .finding
            .certificate()
            .map_or_else(Vec::new, given_values),
    }
}

/// Returns the values that the proof of a verdict obtains from `given` equations.
fn given_values(certificate: &DecisionCertificate) -> Vec<Solved> {
    match certificate.plain() {
        DecisionCertificate::Proof { of, .. } => solutions(&of),
        DecisionCertificate::Refutation(_) => vec![],
    }
}
