//! The level *replayed*: a checker without search goes through the proof of a verdict.
//!
//! The checker ([`torse_checker`]) sees the core claim and the proof, and nothing of the prover. A rejected proof is a
//! contradiction: the claim is then undecided. A proof that it cannot follow is not replayed, with the reason. A
//! correction has a proof of its own.

use crate::certificate::DecisionCertificate;
use crate::condition;
use crate::elaborated_claim::ElaboratedClaim;
use crate::judged::Replay;
use crate::statement::{ProvedStatement, RefutedStatement};
use torse_algebra::work;
use torse_checker::{CheckError, Work};
use torse_core as core;
use torse_prove::decide_statement;
use torse_syntax::derivation::{Claim, Origin};
use torse_syntax::notation::Formula;

/// Replays a proof.
///
/// # Errors
/// The error that the checker finds.
pub(crate) fn proof(
    proved: &ProvedStatement,
    elaborated: &ElaboratedClaim<'_>,
) -> Result<Replay, String> {
    check(
        &elaborated.core,
        &elaborated.statement.origin,
        &proved.certificate,
    )
}

/// Replays a refutation, and the proof of its correction; `budget` bounds the work to find that proof again.
///
/// # Errors
/// The error that the checker finds.
pub(crate) fn refutation(
    refuted: &RefutedStatement,
    elaborated: &ElaboratedClaim<'_>,
    budget: u64,
) -> Result<Replay, String> {
    let Some(certificate) = &refuted.certificate else {
        return Ok(Replay::out_of_reach("the proof that no other number works"));
    };
    let mut replay = check(&elaborated.core, &elaborated.statement.origin, certificate)?;
    if let Some(correction) = refuted.correction() {
        let own = match decided(&elaborated.claim, &correction.statement, budget) {
            Some((_, answer)) => answer,
            None => Ok(Replay::out_of_reach("the correction was not proved again")),
        };
        let own = own.map_err(|wrong| format!("the correction: {wrong}"))?;
        replay.correction = Some(Box::new(own));
    }
    Ok(replay)
}

/// Decides a statement about the domain of a claim with so much work, and returns the certificate with what the checker
/// says of it; nothing where the statement is not decided.
pub(crate) fn decided(
    claim: &Claim,
    statement: &Formula,
    budget: u64,
) -> Option<(DecisionCertificate, Result<Replay, String>)> {
    let written = condition::written(statement, claim.entry.id.get_ref())?;
    let decided = work::within(budget, || decide_statement(claim, &written));
    let certificate = DecisionCertificate::from_decision(&decided.ok()?.ok()?)?;
    let core = torse_elaborate::elaborate(claim, &written).ok()?;
    let answer = check(&core, &written.origin, &certificate);
    Some((certificate, answer))
}

/// What the checker says of a proof or a refutation.
///
/// # Errors
/// What is wrong with it.
fn check(
    core: &core::Claim,
    origin: &Origin,
    certificate: &DecisionCertificate,
) -> Result<Replay, String> {
    let work = Work::new(torse_checker::WORK);
    let found = match certificate.plain() {
        DecisionCertificate::Proof { conditions, of } => {
            torse_checker::proves(core, origin, &conditions, &of, &work)
        }
        DecisionCertificate::Refutation(refuted) => {
            torse_checker::refutes(core, origin, &refuted, &work)
        }
    };
    match found {
        Ok(()) => Ok(Replay::accepted()),
        Err(CheckError::Unsupported(why)) => Ok(Replay::out_of_reach(&why.to_string())),
        Err(wrong @ CheckError::Wrong(_)) => Err(wrong.to_string()),
    }
}
