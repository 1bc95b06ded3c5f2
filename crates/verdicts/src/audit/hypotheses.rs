//! Flags hypotheses of ours that the proof does not need.

use super::{Sign, Subject, listed};
use torse_syntax::taxonomy::Flag;

/// Returns the hypotheses that were tried and are not needed.
pub(super) fn unneeded(subject: &Subject<'_>) -> Vec<Sign> {
    let assumed = subject.outcome.claim.assumed.iter();
    let unneeded = assumed.filter(|hypothesis| hypothesis.needed == Some(false));
    let unneeded = unneeded.map(|h| format!("`{}`", h.formula.text)).collect();
    listed(Flag::UnneededHypothesis, "proved without", unneeded)
}
