//! A claim in core terms: dependencies, cross-check and checker use the same one, which is elaborated once.

use crate::provenance;
use std::borrow::Cow;
use torse_core as core;
use torse_syntax::derivation::{Claim, Written};

/// A claim, a statement on its domain, and both in core terms.
#[derive(Debug, Clone)]
pub(crate) struct ElaboratedClaim<'c> {
    pub claim: Cow<'c, Claim>,
    pub statement: &'c Written,
    pub core: core::Claim,
}

impl<'c> ElaboratedClaim<'c> {
    /// Elaborates a claim with its own statement; none if it has no statement or makes no sense.
    pub fn with_own_statement(claim: &'c Claim) -> Option<Self> {
        Self::new(claim, claim.statement.as_ref()?)
    }

    /// Elaborates a statement on the domain of a claim; none if it makes no sense.
    pub fn new(claim: &'c Claim, statement: &'c Written) -> Option<Self> {
        Self::elaborated(Cow::Borrowed(claim), statement)
    }

    /// Elaborates the claim with only the hypotheses that the proof uses; none if it makes no sense without the others.
    pub fn without_unneeded(&self, needed: &[Option<bool>]) -> Option<Cow<'_, Self>> {
        let unneeded = provenance::unneeded(&self.claim, needed);
        if unneeded.is_empty() {
            return Some(Cow::Borrowed(self));
        }
        let fewer = provenance::without(&self.claim, &unneeded);
        Self::elaborated(Cow::Owned(fewer), self.statement).map(Cow::Owned)
    }

    fn elaborated(claim: Cow<'c, Claim>, statement: &'c Written) -> Option<Self> {
        let core = torse_elaborate::elaborate(&claim, statement).ok()?;
        Some(Self {
            claim,
            statement,
            core,
        })
    }
}
