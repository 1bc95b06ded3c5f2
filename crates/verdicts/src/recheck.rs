//! Repeats the cross-checks of verdicts, with more work.
//!
//! The [`net`] checks a verdict while it is decided, with little work. Here it is repeated with more work, at more and
//! other points, and equations at fixed small integers are decided exactly as identities of quotients of polynomials.
//! Every kind of verdict is covered: equations, order relations, `agrees`, properties of a basis, conditions on both
//! sides, corrections, refutations at their witness, empty domains.
//!
//! This does not prove a statement again, but an error of the prover passes only if the semantics makes the same error
//! independently.

use crate::existential;
use crate::judged::Net;
use crate::net::{self, Effort, Objection};
use crate::outcome::Outcome;
use torse_core::stack;
use torse_syntax::derivation::Claim;

/// The effort for a verdict here.
pub const THOROUGH_EFFORT: Effort = Effort {
    points: 60,
    budget: 6_000_000,
    condition_budget: 6_000_000,
    instance_budget: 1_000_000,
    seed: "again ",
};

/// Maximum work to find a witness again.
const MAX_WITNESS_WORK: u64 = 100_000_000;

/// The result of checking a verdict again.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Recheck {
    /// The semantics agrees at as many points as required.
    Netted(Net),
    /// It agrees at fewer points, or at none; the net has the reason.
    Decided(Net),
    /// It disagrees.
    Contradicted {
        /// The contradiction.
        found: String,
    },
    /// The claim has no verdict on a statement.
    Nothing,
}

/// Checks the verdict of a claim again.
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
    let witnessed = (!claim.existentials.is_empty())
        .then(|| existential::witnessed(claim, statement, MAX_WITNESS_WORK));
    let claim = witnessed.as_ref().unwrap_or(claim);
    match stack::deep(|| net::judged(outcome, claim, statement, &THOROUGH_EFFORT)) {
        None => Recheck::Nothing,
        Some(Ok(net)) if net.netted => Recheck::Netted(net),
        Some(Ok(net)) => Recheck::Decided(net),
        Some(Err(Objection::Contradiction(found))) => Recheck::Contradicted { found },
        Some(Err(Objection::Unconfirmed(why))) => Recheck::Decided(Net::without_points(&why)),
    }
}
