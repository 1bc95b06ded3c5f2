//! What a verdict is about: net and checker look at the same claim, which is brought to core terms once for both.

use crate::outcome::Outcome;
use crate::provenance;
use torse_language::core;
use torse_language::derivation::{Claim, Written};

/// What a verdict is about: the claim without what the proof was found not to need, and the same in core terms.
pub(crate) struct Meant<'s> {
    pub claim: Claim,
    pub statement: &'s Written,
    pub core: core::Claim,
}

impl<'s> Meant<'s> {
    /// Nothing for a claim that makes no sense.
    pub fn new(outcome: &Outcome, claim: &Claim, statement: &'s Written) -> Option<Self> {
        let claim = provenance::without(claim, &provenance::unneeded(claim, outcome));
        let core = core::Claim::new(&claim, statement).ok()?;
        Some(Self {
            claim,
            statement,
            core,
        })
    }
}
