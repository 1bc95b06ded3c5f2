//! The level *replayed*: a checker without search goes through the proof of a verdict.
//!
//! The checker ([`torse_checker`]) knows the core claim and the proof, and nothing of the prover. A proof that it
//! rejects is a contradiction: the claim is undecided then. What it cannot follow is not replayed, and says why. A
//! correction is a proof of its own.

use crate::condition;
use crate::grounds::Grounds;
use crate::judged::Replay;
use crate::meant::Meant;
use crate::statement::{ProvedStatement, RefutedStatement};
use torse_algebra::work;
use torse_checker::{Unchecked, Work};
use torse_core as core;
use torse_prove::decide_statement;
use torse_syntax::derivation::Origin;

/// Replays a proof.
///
/// # Errors
/// What the checker finds wrong.
pub(crate) fn proof(proved: &ProvedStatement, meant: &Meant<'_>) -> Result<Replay, String> {
    checked(&meant.core, &meant.statement.origin, &proved.grounds)
}

/// Replays a refutation, and the proof of its correction, for which so much work may be spent to find it again.
///
/// # Errors
/// What the checker finds wrong.
pub(crate) fn refutation(
    refuted: &RefutedStatement,
    meant: &Meant<'_>,
    budget: u64,
) -> Result<Replay, String> {
    let Some(grounds) = &refuted.grounds else {
        return Ok(Replay::beyond("that there is no other number"));
    };
    let mut replay = checked(&meant.core, &meant.statement.origin, grounds)?;
    if let Some(correction) = refuted.correction() {
        let claim = &meant.claim;
        let own = || {
            let written = condition::written(&correction.statement, claim.entry.id.get_ref())?;
            let decided = work::within(budget, || decide_statement(claim, &written));
            let grounds = Grounds::of(&decided.ok()?.ok()?)?;
            let core = torse_elaborate::elaborate(claim, &written).ok()?;
            Some(checked(&core, &written.origin, &grounds))
        };
        let none = || Ok(Replay::beyond("the correction was not proved again"));
        let own = own().unwrap_or_else(none);
        let own = own.map_err(|wrong| format!("the correction: {wrong}"))?;
        replay.correction = Some(Box::new(own));
    }
    Ok(replay)
}

/// What the checker says.
fn checked(core: &core::Claim, origin: &Origin, grounds: &Grounds) -> Result<Replay, String> {
    let work = Work::new(torse_checker::WORK);
    let found = match grounds.plain() {
        Grounds::Proof { conditions, of } => {
            torse_checker::proves(core, origin, &conditions, &of, &work)
        }
        Grounds::Refutation(refuted) => torse_checker::refutes(core, origin, &refuted, &work),
    };
    match found {
        Ok(()) => Ok(Replay::done()),
        Err(Unchecked::Beyond(why)) => Ok(Replay::beyond(&why.to_string())),
        Err(wrong @ Unchecked::Wrong(_)) => Err(wrong.to_string()),
    }
}
