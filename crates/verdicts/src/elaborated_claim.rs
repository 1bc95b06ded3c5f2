//! What a verdict is about: its table, its net and the checker look at the same claim, which is brought to core terms once
//! for all of them.

use crate::provenance;
use std::borrow::Cow;
use torse_core as core;
use torse_syntax::derivation::{Claim, Written};

/// What a verdict is about: a claim, a statement on its domain, and both in core terms.
#[derive(Debug, Clone)]
pub(crate) struct ElaboratedClaim<'c> {
    pub claim: Cow<'c, Claim>,
    pub statement: &'c Written,
    pub core: core::Claim,
}

impl<'c> ElaboratedClaim<'c> {
    /// A claim with its own statement; nothing where it states nothing, or what makes no sense.
    pub fn own(claim: &'c Claim) -> Option<Self> {
        Self::new(claim, claim.statement.as_ref()?)
    }

    /// A statement on the domain of a claim; nothing where it makes no sense.
    pub fn new(claim: &'c Claim, statement: &'c Written) -> Option<Self> {
        Self::of(Cow::Borrowed(claim), statement)
    }

    /// The claim with only the hypotheses that the proof uses; nothing where it makes no sense without the others.
    pub fn without_unneeded(&self, needed: &[Option<bool>]) -> Option<Cow<'_, Self>> {
        let unneeded = provenance::unneeded(&self.claim, needed);
        if unneeded.is_empty() {
            return Some(Cow::Borrowed(self));
        }
        let fewer = provenance::without(&self.claim, &unneeded);
        Self::of(Cow::Owned(fewer), self.statement).map(Cow::Owned)
    }

    fn of(claim: Cow<'c, Claim>, statement: &'c Written) -> Option<Self> {
        let core = torse_elaborate::elaborate(&claim, statement).ok()?;
        Some(Self {
            claim,
            statement,
            core,
        })
    }
}
