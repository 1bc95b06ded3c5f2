//! Verdicts judged once more, thoroughly.
//!
//! The [`net`] under a verdict is cast while it is decided, with little work. Here it is cast again: with
//! more work, at more and other points, and equations at fixed small integers as identities of quotients of polynomials,
//! which decides them exactly there. Every kind of verdict is looked at: equations, order relations, `agrees`,
//! properties of a basis, conditions on both sides, corrections, refutations at their witness, empty domains.
//!
//! That proves no statement again, but an error of the prover would have to be made here once more, in other words, to
//! pass.

use crate::existential;
use crate::judged::Net;
use crate::net::{self, Effort, Objection};
use crate::outcome::Outcome;
use torse_core::stack;
use torse_syntax::derivation::Claim;

/// What a verdict has to pass here.
pub const THOROUGH: Effort = Effort {
    points: 60,
    budget: 6_000_000,
    beyond: 6_000_000,
    polynomials: 1_000_000,
    seed: "again ",
};

/// The work that finding a witness again may take.
const WITNESS: u64 = 100_000_000;

/// What judging a verdict again gave.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Recheck {
    /// The semantics agrees at as many points as are wanted.
    Netted(Net),
    /// It agrees at fewer, or at none; the net says why.
    Decided(Net),
    /// It does not agree.
    Contradicted {
        /// What was found.
        found: String,
    },
    /// There is no verdict on a statement.
    Nothing,
}

/// Judges the verdict of a claim again.
#[must_use]
pub fn claim(claim: &Claim, outcome: &Outcome) -> Recheck {
    if let Some(found) = outcome.contradiction() {
        return Recheck::Contradicted {
            found: found.to_owned(),
        };
    }
    let Some(statement) = &claim.statement else {
        return Recheck::Nothing;
    };
    let witnessed =
        (!claim.existentials.is_empty()).then(|| existential::witnessed(claim, statement, WITNESS));
    let claim = witnessed.as_ref().unwrap_or(claim);
    match stack::deep(|| net::judged(outcome, claim, statement, &THOROUGH)) {
        None => Recheck::Nothing,
        Some(Ok(net)) if net.netted => Recheck::Netted(net),
        Some(Ok(net)) => Recheck::Decided(net),
        Some(Err(Objection::Contradiction(found))) => Recheck::Contradicted { found },
        Some(Err(Objection::Unseen(why))) => Recheck::Decided(Net::uncovered(&why)),
    }
}
