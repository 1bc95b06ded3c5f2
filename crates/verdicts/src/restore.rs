//! Decides the claims of a paper again with all corrections in force.
//!
//! Corrections must work together: each claim in which a fault shows is decided again, with the corrected definitions
//! of all faults and its own corrected statement. So is each refuted claim that has a correction and no listed fault.

use crate::engine::decide_claim_within;
use crate::outcome::{Outcome, PaperOutcome, Restored};
use rayon::prelude::*;
use torse_syntax::derivation::{
    Claim, CorrectedClaim, DerivationError, Hypothesis, Origin, Paper, Provenance, Written,
};
use torse_syntax::formula::parse;
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::{Kind, Verdict};

/// Decides again the claims of a paper that a fault or a correction is about, with all corrections in force and this
/// budget of work for each.
///
/// # Errors
/// A [`DerivationError`] if a corrected formula makes no sense.
pub fn restore(
    budget: u64,
    paper: &Paper,
    outcome: &PaperOutcome,
) -> Result<Vec<Restored>, Box<DerivationError>> {
    let found = |id: &str| outcome.claims.iter().find(|other| other.claim.id == id);
    // Of a claim that states nothing only the words change.
    let listed = paper.corrigenda.iter().flat_map(|of| &of.corrected);
    let listed = listed.filter(|of| of.claim.statement.is_some() || !of.claim.readings.is_empty());
    let mut corrected: Vec<Claim> = listed
        .map(|of| in_force(of, found(of.claim.entry.id.get_ref())))
        .collect();
    let is_listed = |id: &String| paper.corrigenda.iter().any(|of| of.shows.contains(id));
    corrected.extend(paper.claims.iter().filter_map(|claim| {
        let id = claim.entry.id.get_ref();
        let outcome = found(id).filter(|of| of.verdict() == Verdict::Misprint)?;
        (!is_listed(id) && outcome.claim.kind != Kind::Remark).then(|| repaired(claim, outcome))
    }));
    let decide = |claim: &Claim| -> Result<Restored, Box<DerivationError>> {
        let outcome = decide_claim_within(budget, &paper.head.id, claim)?;
        Ok(Restored {
            verdict: outcome.verdict(),
            evidence: outcome.evidence(),
            conditions: outcome.conditions().to_vec(),
            claim: outcome.claim.id,
        })
    };
    corrected.par_iter().map(decide).collect()
}

/// Returns a claim as it is decided again: restated by the files, or with the correction that was found.
pub(crate) fn in_force(corrected: &CorrectedClaim, outcome: Option<&Outcome>) -> Claim {
    match (corrected.restated, outcome) {
        (false, Some(outcome)) => repaired(&corrected.claim, outcome),
        _ => corrected.claim.clone(),
    }
}

/// Returns the claim with its corrected statement, and the conditions of the correction as assumptions.
fn repaired(claim: &Claim, outcome: &Outcome) -> Claim {
    let mut repaired = claim.clone();
    repaired.author_note = None;
    let written = |formula: &Formula, origin: &Origin| {
        let expr = parse(&formula.text).ok()?.placeless();
        let origin = origin.clone();
        Some(Written { expr, origin })
    };
    let Some(correction) = outcome.correction() else {
        return repaired;
    };
    let origin = &claim.origin;
    if let Some(statement) = written(&correction.statement, origin) {
        repaired.statement = Some(statement);
        let conditions = correction.conditions.iter();
        let conditions = conditions.filter_map(|formula| written(formula, origin));
        repaired
            .assumptions
            .extend(conditions.map(|formula| Hypothesis {
                formula,
                provenance: Provenance::Stated,
            }));
    }
    repaired
}
