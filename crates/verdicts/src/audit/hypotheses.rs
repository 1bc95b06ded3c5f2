//! Flags hypotheses of ours that the proof does not need.

use super::{RaisedFlag, Subject, one_flag_for};
use torse_syntax::taxonomy::Flag;

/// Returns the hypotheses that were tried and are not needed.
pub(super) fn unneeded(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    let assumed = subject.outcome.claim.assumed.iter();
    let unneeded = assumed.filter(|hypothesis| hypothesis.needed == Some(false));
    let unneeded = unneeded.map(|h| format!("`{}`", h.formula.text)).collect();
    one_flag_for(Flag::UnneededHypothesis, "proved without", unneeded)
}
