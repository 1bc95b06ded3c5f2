//! What an answer rests on.
//!
//! Verdict and evidence are two axes and never merged: the verdict says what is true of the printed
//! statement, the evidence says what the answer rests on.

use serde::Serialize;

/// What a verdict rests on.
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
    /// Every degree up to a bound, no more.
    CheckedRange,
    /// Sample points, no more.
    Sampled,
}
