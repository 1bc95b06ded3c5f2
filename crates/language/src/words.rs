//! The words of claims: what kind of statement the paper makes, and what is true of it.
//!
//! A derivation file says the kind, and may say the verdict that it expects.

use serde::Serialize;

/// What kind of statement the paper makes.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, serde::Deserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// A definition.
    Definition,
    /// An equation said to hold identically.
    Identity,
    /// An inequality on a range.
    Inequality,
    /// A printed value.
    Value,
    /// A property in words.
    Property,
    /// Something that is built.
    Construction,
    /// A figure.
    Figure,
    /// A checkable remark.
    Prose,
}

/// What is true of the printed statement.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, serde::Deserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// True as printed.
    Holds,
    /// True under an extra condition, which is stated.
    Conditional,
    /// False as printed; a small correction is proved.
    Misprint,
    /// False, with an exact counterexample.
    False,
    /// Not decided; the reason and what was tried are stated.
    Undecided,
    /// No point satisfies the assumptions.
    Vacuous,
    /// A definition, found to be well formed.
    Definition,
    /// The data needed to decide are not printed.
    Underspecified,
    /// Not a statement this engine is for; the reason is stated.
    OutOfScope,
    /// A figure redrawn from printed data alone.
    Reproduced,
    /// A figure redrawn under listed assumptions.
    Partial,
}
