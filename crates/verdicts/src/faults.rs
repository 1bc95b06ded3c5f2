//! What the authors of a paper are told, and what becomes of its claims with all corrections in force.
//!
//! A set of corrections is worth something as a whole: each claim in which a fault shows is decided again, with the corrected
//! definitions of all faults and its own corrected statement. So is each refuted claim of which a correction was found and
//! of which no fault is told.

use crate::engine::decide_claim_within;
use crate::finding;
use crate::outcome::{FaultChange, Outcome, PaperFault, PaperOutcome, Restored};
use rayon::prelude::*;
use torse_syntax::derivation::{
    Claim, Corrigendum, DerivationError, Hypothesis, Origin, Paper, Provenance, Rewording, Written,
};
use torse_syntax::formula::parse;
use torse_syntax::notation::Formula;
use torse_syntax::words::{Kind, Verdict};

/// The faults of which the files of a paper tell, with their numbers filled in; nothing is decided.
///
/// # Errors
/// A [`DerivationError`] at a hole that is no number where the first claim of the fault fails.
pub fn faults(
    paper: &Paper,
    outcomes: &[Outcome],
) -> Result<Vec<PaperFault>, Box<DerivationError>> {
    let change = |of: &Rewording| FaultChange {
        claim: of.claim.clone(),
        printed: of.printed.clone(),
        reads: of.reads.clone(),
        remark: of.remark.clone(),
    };
    let says = |of: &Corrigendum| -> Result<String, Box<DerivationError>> {
        let first = of.shows.first();
        let claim = paper
            .claims
            .iter()
            .find(|claim| Some(claim.entry.id.get_ref()) == first);
        let outcome = outcomes.iter().find(|outcome| Some(&outcome.id) == first);
        match (claim, outcome) {
            (Some(claim), Some(outcome)) => finding::filled_in(claim, outcome, &of.says),
            // Its numbers are those of a claim that this run does not have.
            _ => Ok(of.says.without_holes().unwrap_or_default()),
        }
    };
    let fault = |of: &Corrigendum| -> Result<PaperFault, Box<DerivationError>> {
        Ok(PaperFault {
            id: of.id.clone(),
            at: of.at.clone(),
            says: says(of)?,
            shows: of.shows.clone(),
            changes: of.changes.iter().map(change).collect(),
        })
    };
    paper.corrigenda.iter().map(fault).collect()
}

/// Decides the claims of a paper again that a fault or a correction is about, all corrections in force, with this budget of
/// work for each.
///
/// # Errors
/// A [`DerivationError`] when a corrected formula does not make sense.
pub fn restore(
    budget: u64,
    paper: &Paper,
    outcome: &PaperOutcome,
) -> Result<Vec<Restored>, Box<DerivationError>> {
    let found = |id: &str| outcome.claims.iter().find(|claim| claim.id == id);
    let told = paper.corrigenda.iter().flat_map(|of| &of.corrected);
    let mut corrected: Vec<Claim> = told
        .map(|of| {
            let id = of.claim.entry.id.get_ref();
            match (of.restated, found(id)) {
                (false, Some(outcome)) => repaired(&of.claim, outcome),
                _ => of.claim.clone(),
            }
        })
        .collect();
    let is_told = |id: &String| paper.corrigenda.iter().any(|of| of.shows.contains(id));
    corrected.extend(paper.claims.iter().filter_map(|claim| {
        let id = claim.entry.id.get_ref();
        let outcome = found(id).filter(|of| of.verdict == Verdict::Misprint)?;
        (!is_told(id) && outcome.kind != Kind::Remark).then(|| repaired(claim, outcome))
    }));
    let decide = |claim: &Claim| -> Result<Restored, Box<DerivationError>> {
        let outcome = decide_claim_within(budget, &paper.head.id, claim)?;
        Ok(Restored {
            claim: outcome.id,
            verdict: outcome.verdict,
            evidence: outcome.evidence,
            conditions: outcome.conditions,
        })
    };
    corrected.par_iter().map(decide).collect()
}

/// The claim with the correction that was found of it, under the conditions of that.
fn repaired(claim: &Claim, outcome: &Outcome) -> Claim {
    let mut repaired = claim.clone();
    repaired.finding = None;
    let written = |formula: &Formula, origin: &Origin| {
        let expr = parse(&formula.text).ok()?.placeless();
        let origin = origin.clone();
        Some(Written { expr, origin })
    };
    let Some(correction) = &outcome.correction else {
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
