//! Running claims: from a loaded paper to outcomes.

use crate::faults::faults;
use crate::outcome::{Outcome, PaperOutcome};
use crate::pending_claim::PendingClaim;
use rayon::prelude::*;
use torse_syntax::derivation::{Claim, DerivationError, Paper};

/// Default work for a claim: many times what the hardest claims of the papers take.
pub const STANDARD_WORK: u64 = 500_000_000;

/// Decides all claims of a paper, in parallel; the outcomes have the order of the file. Calls `done` once for each
/// claim, from any thread.
///
/// # Errors
/// The first claim, in file order, whose formulas make no sense.
pub fn run(paper: &Paper, done: &(dyn Fn() + Sync)) -> Result<PaperOutcome, Box<DerivationError>> {
    let outcomes: Vec<Result<Outcome, Box<DerivationError>>> = paper
        .claims
        .par_iter()
        .map(|claim| {
            let outcome = decide_claim(&paper.head.id, claim);
            done();
            outcome
        })
        .collect();
    let claims: Vec<Outcome> = outcomes.into_iter().collect::<Result<_, _>>()?;
    Ok(PaperOutcome {
        slug: paper.head.id.clone(),
        title: paper.head.title.clone(),
        authors: paper.head.authors.clone(),
        venue: paper.head.venue.clone(),
        faults: faults(paper, &claims)?,
        claims,
        restored: None,
    })
}

/// Decides one claim. If the engine panics, the claim is undecided, with the message of the panic as the reason; other
/// claims are not affected.
///
/// # Errors
/// A [`DerivationError`] if a formula of the claim makes no sense.
pub fn decide_claim(paper: &str, claim: &Claim) -> Result<Outcome, Box<DerivationError>> {
    decide_claim_within(STANDARD_WORK, paper, claim)
}

/// Decides one claim with another budget of work, in the units of [`torse_algebra::work`]: this much for the verdict,
/// and as much again for the search for a correction. A claim that needs more is undecided, with that reason.
///
/// # Errors
/// A [`DerivationError`] if a formula of the claim makes no sense.
pub fn decide_claim_within(
    budget: u64,
    paper: &str,
    claim: &Claim,
) -> Result<Outcome, Box<DerivationError>> {
    PendingClaim::verdict(budget, paper, claim)?.complete()
}
