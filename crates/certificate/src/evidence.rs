//! The evidence for an answer.
//!
//! Verdict and evidence are separate: the verdict says what is true of the printed statement, the evidence says how
//! that was established.

use serde::Serialize;

/// The kind of evidence for a verdict.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, serde::Deserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Evidence {
    /// A zero normal form.
    Identity,
    /// A proof for every degree at once.
    Induction,
    /// A certificate of sign.
    Inequality,
    /// A certified enclosure.
    Enclosure,
    /// An exact counterexample.
    Witness,
    /// Every degree up to a bound; not a proof for all degrees.
    CheckedRange,
    /// Sample points; not a proof.
    Sampled,
}

impl Evidence {
    /// Returns its name, as files and tables write it.
    ///
    /// ```
    /// assert_eq!(torse_certificate::Evidence::CheckedRange.word(), "checked-range");
    /// ```
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Identity => "identity",
            Self::Induction => "induction",
            Self::Inequality => "inequality",
            Self::Enclosure => "enclosure",
            Self::Witness => "witness",
            Self::CheckedRange => "checked-range",
            Self::Sampled => "sampled",
        }
    }
}
