//! The level *replayed*: a checker without search goes through the proof of a verdict.
//!
//! The checker ([`torse_proof::check`]) knows the core claim and the proof, and nothing of the prover. A proof that it
//! rejects is a contradiction: the claim is undecided then. What it cannot follow is not replayed, and says why. A
//! correction is a proof of its own.

use crate::grounds::Grounds;
use crate::outcome::{Outcome, Replay};
use crate::{condition, provenance};
use std::sync::Arc;
use torse_algebra::work;
use torse_language::core;
use torse_language::derivation::{Claim, Written};
use torse_language::words::Verdict;
use torse_proof::check::{self, Unchecked, Work};
use torse_prove::decide::Decision;
use torse_prove::decide_statement;

/// Replays what a verdict rests on, and the proof of its correction, for which so much work may be spent to find it again.
/// Nothing where there is no proof.
///
/// # Errors
/// What the checker finds wrong.
pub fn replayed(
    outcome: &Outcome,
    claim: &Claim,
    statement: &Written,
    budget: u64,
) -> Option<Result<Replay, String>> {
    let grounds = outcome.grounds.as_ref()?;
    // The proof does without what it was found not to need.
    let claim = &provenance::without(claim, &provenance::unneeded(claim, outcome));
    let mut replay = match checked(claim, statement, grounds)? {
        Ok(replay) => replay,
        Err(wrong) => return Some(Err(wrong)),
    };
    let refuted = matches!(outcome.verdict, Verdict::False | Verdict::Misprint);
    if let Some(correction) = outcome.correction.as_ref().filter(|_| refuted) {
        let own = || {
            let written = condition::written(&correction.statement, &outcome.id)?;
            let decided = work::within(budget, || decide_statement(claim, &written));
            let grounds = Grounds::of(&decided.ok()?.ok()?)?;
            checked(claim, &written, &grounds)
        };
        let none = || Ok(Replay::beyond("the correction was not proved again"));
        match own().unwrap_or_else(none) {
            Ok(own) => replay.correction = Some(Box::new(own)),
            Err(wrong) => return Some(Err(format!("the correction: {wrong}"))),
        }
    }
    Some(Ok(replay))
}

/// What the checker says; nothing for a claim that makes no sense.
fn checked(
    claim: &Claim,
    statement: &Written,
    grounds: &Grounds,
) -> Option<Result<Replay, String>> {
    let core = core::Claim::new(claim, statement).ok()?;
    let work = Work::new(check::WORK);
    let origin = &statement.origin;
    let found = match grounds.plain() {
        Grounds::Proof { conditions, of } => check::proves(&core, origin, &conditions, &of, &work),
        Grounds::Refutation(refuted) => check::refutes(&core, origin, &refuted, &work),
    };
    Some(match found {
        Ok(()) => Ok(Replay::done()),
        Err(Unchecked::Beyond(why)) => Ok(Replay::beyond(&why.to_string())),
        Err(wrong @ Unchecked::Wrong(_)) => Err(wrong.to_string()),
    })
}

/// Keeps what a decision rests on.
pub fn keep(outcome: &mut Outcome, decision: &Decision) {
    outcome.grounds = Grounds::of(decision).map(Arc::new);
}
