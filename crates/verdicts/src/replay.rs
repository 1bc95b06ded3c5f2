//! The level *replayed*: a checker without search goes through the proof of a verdict.
//!
//! The checker ([`torse_checker`]) knows the core claim and the proof, and nothing of the prover. A proof that it
//! rejects is a contradiction: the claim is undecided then. What it cannot follow is not replayed, and says why. A
//! correction is a proof of its own.

use crate::condition;
use crate::grounds::Grounds;
use crate::meant::Meant;
use crate::outcome::{Outcome, Replay};
use std::sync::Arc;
use torse_algebra::work;
use torse_checker::{Unchecked, Work};
use torse_core as core;
use torse_prove::decide::Decision;
use torse_prove::decide_statement;
use torse_syntax::derivation::Origin;
use torse_syntax::words::Verdict;

/// Replays what a verdict rests on, and the proof of its correction, for which so much work may be spent to find it again.
/// Nothing where there is no proof.
///
/// # Errors
/// What the checker finds wrong.
pub(crate) fn replayed(
    outcome: &Outcome,
    meant: &Meant<'_>,
    budget: u64,
) -> Option<Result<Replay, String>> {
    let grounds = outcome.grounds.as_ref()?;
    let claim = &meant.claim;
    let mut replay = match checked(&meant.core, &meant.statement.origin, grounds) {
        Ok(replay) => replay,
        Err(wrong) => return Some(Err(wrong)),
    };
    let refuted = matches!(outcome.verdict, Verdict::False | Verdict::Misprint);
    if let Some(correction) = outcome.correction.as_ref().filter(|_| refuted) {
        let own = || {
            let written = condition::written(&correction.statement, &outcome.id)?;
            let decided = work::within(budget, || decide_statement(claim, &written));
            let grounds = Grounds::of(&decided.ok()?.ok()?)?;
            let core = torse_elaborate::elaborate(claim, &written).ok()?;
            Some(checked(&core, &written.origin, &grounds))
        };
        let none = || Ok(Replay::beyond("the correction was not proved again"));
        match own().unwrap_or_else(none) {
            Ok(own) => replay.correction = Some(Box::new(own)),
            Err(wrong) => return Some(Err(format!("the correction: {wrong}"))),
        }
    }
    Some(Ok(replay))
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

/// Keeps what a decision rests on.
pub fn keep(outcome: &mut Outcome, decision: &Decision) {
    outcome.grounds = Grounds::of(decision).map(Arc::new);
}
