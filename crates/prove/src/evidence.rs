//! What an answer rests on, and counterexamples in words.

use serde::Serialize;

pub use torse_certificate::Evidence;

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
