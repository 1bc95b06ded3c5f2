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

/// A point at which the printed statement fails, with both sides.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Witness {
    /// Values of the symbols, in the order of the file: name and exact value.
    pub at: Vec<(String, String)>,
    /// The left side there, exact.
    pub left: String,
    /// The right side there, exact.
    pub right: String,
    /// The left side as an enclosure in decimals.
    pub left_decimal: String,
    /// The right side as an enclosure in decimals.
    pub right_decimal: String,
}
