//! Decides the claims of a paper again with all corrections in force.
//!
//! Corrections must work together: each claim in which a fault shows is decided again, with the corrected definitions
//! of all faults and its own corrected statement. So is each refuted claim that has a correction and no listed fault, and
//! each claim that rests on one of these: a correction must not break what was true before.

use crate::consequences::users;
use crate::engine::decide_claim_within;
use crate::outcome::{Outcome, PaperOutcome, Restoration, Restored};
use rayon::prelude::*;
use std::collections::{BTreeMap, BTreeSet};
use torse_syntax::derivation::{
    Claim, CorrectedClaim, Corrigendum, DerivationError, Hypothesis, Origin, Paper, Provenance,
    Written,
};
use torse_syntax::formula::parse;
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::{Kind, Verdict};

/// Decides again the claims of a paper that a fault or a correction is about and those that rest on them, with all
/// corrections in force and this budget of work for each.
///
/// # Errors
/// A [`DerivationError`] if a corrected formula makes no sense.
pub fn restore(
    budget: u64,
    paper: &Paper,
    outcome: &PaperOutcome,
) -> Result<Restoration, Box<DerivationError>> {
    let found = |id: &str| outcome.claims.iter().find(|other| other.claim.id == id);
    let mut corrected: BTreeMap<&String, Claim> = BTreeMap::new();
    let mut reworded: BTreeSet<&String> = BTreeSet::new();
    // Two faults may change the words of one claim: what one of them restates is decided.
    let listed = paper.corrigenda.iter().flat_map(|own| &own.corrected);
    for of in listed {
        let id = of.claim.entry.id.get_ref();
        if !is_decidable(&of.claim) {
            reworded.insert(id);
        } else if of.restated || !corrected.contains_key(id) {
            corrected.insert(id, in_force(of, found(id)));
        }
    }
    reworded.retain(|id| !corrected.contains_key(id));
    for claim in &paper.claims {
        let id = claim.entry.id.get_ref();
        let misprint = found(id).filter(|own| own.verdict() == Verdict::Misprint);
        if let Some(outcome) = misprint
            && claim.entry.kind != Kind::Remark
            && !corrected.contains_key(id)
        {
            corrected.insert(id, repaired(claim, outcome));
        }
    }
    let decide = |claim: &Claim| -> Result<Restored, Box<DerivationError>> {
        decide_claim_within(budget, &paper.head.id, claim).map(|outcome| restored(&outcome))
    };
    let resting = dependents(paper, &corrected);
    let again = |(claim, redefined): &(&Claim, Option<Claim>)| match redefined {
        Some(redefined) => decide(redefined),
        // No formula of it has changed: neither has what is decided from the formulas alone.
        None => match found(claim.entry.id.get_ref()) {
            Some(outcome) => Ok(restored(outcome)),
            None => decide(claim),
        },
    };
    let in_order = paper.claims.iter().map(|claim| claim.entry.id.get_ref());
    let in_order: Vec<&String> = in_order.collect();
    let claims: Vec<&Claim> = in_order.iter().filter_map(|id| corrected.get(id)).collect();
    let of_words = in_order.iter().filter(|id| reworded.contains(*id));
    Ok(Restoration {
        corrected: claims
            .par_iter()
            .map(|claim| decide(claim))
            .collect::<Result<_, _>>()?,
        dependents: resting.par_iter().map(again).collect::<Result<_, _>>()?,
        reworded: of_words.map(|id| (*id).clone()).collect(),
    })
}

/// Whether a claim says something that can be decided.
fn is_decidable(claim: &Claim) -> bool {
    claim.statement.is_some() || !claim.readings.is_empty()
}

fn restored(outcome: &Outcome) -> Restored {
    Restored {
        claim: outcome.claim.id.clone(),
        verdict: outcome.verdict(),
        evidence: outcome.evidence(),
        conditions: outcome.conditions().to_vec(),
    }
}

/// The claims of the paper that rest on corrected ones, directly or through others, and those with a formula in which a
/// definition is corrected, these with the corrected definitions; in file order.
fn dependents<'p>(
    paper: &'p Paper,
    corrected: &BTreeMap<&String, Claim>,
) -> Vec<(&'p Claim, Option<Claim>)> {
    let uses = paper.claims.iter();
    let uses = uses.map(|claim| (claim.entry.id.get_ref().as_str(), claim.uses.as_slice()));
    let users = users(uses);
    let mut reached: BTreeSet<&str> = BTreeSet::new();
    let mut pending: Vec<&str> = corrected.keys().map(|id| id.as_str()).collect();
    while let Some(id) = pending.pop() {
        let direct = users.get(id).into_iter().flatten();
        pending.extend(direct.filter(|user| reached.insert(user)));
    }
    let others = paper.claims.iter().filter(|claim| {
        claim.entry.kind != Kind::Remark
            && is_decidable(claim)
            && !corrected.contains_key(claim.entry.id.get_ref())
    });
    let resting = others.filter_map(|claim| {
        let redefined = Corrigendum::redefined(&paper.corrigenda, claim);
        let rests = redefined.is_some() || reached.contains(claim.entry.id.get_ref().as_str());
        rests.then_some((claim, redefined))
    });
    resting.collect()
}

/// Returns a claim as it is decided again: restated by the files, or with the correction that was found.
pub(crate) fn in_force(corrected: &CorrectedClaim, outcome: Option<&Outcome>) -> Claim {
    match (corrected.restated, outcome) {
        (false, Some(outcome)) => repaired(&corrected.claim, outcome),
        _ => {
            // What the words leave open as printed, the corrected ones state.
            let mut restated = corrected.claim.clone();
            restated.entry.out_of_scope = None;
            restated.entry.underspecified = None;
            restated.entry.unstated = None;
            restated
        }
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
