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
    /// An equation that is claimed to hold identically.
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
    /// A statement of ours that the paper does not make.
    Remark,
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
    /// The sentence has more than one reading, and what is true of it depends on the reading.
    Depends,
    /// Not decided; the reason and what was tried are stated.
    Undecided,
    /// No point satisfies the hypotheses.
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

/// A sign that a statement may not be what the paper prints.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, serde::Deserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Flag {
    /// The sides of an equation are equal as they are written.
    EqualSides,
    /// Nothing occurs in the statement that the paper defines.
    NothingOfThePaper,
    /// A number of the print does not occur in the statement.
    LacksNumber,
    /// A name of the print does not occur in the statement.
    LacksName,
    /// A relation of the print does not occur in the statement.
    LacksRelation,
    /// A number of the statement does not occur in the print.
    AddsNumber,
    /// A name of the statement does not occur in the print.
    AddsName,
    /// A relation of the statement does not occur in the print.
    AddsRelation,
    /// What is stated is among the hypotheses.
    AssumedConclusion,
    /// The statement has fewer parts than the sentence.
    ShortConjunction,
    /// A sentence about every degree is stated for one.
    OneDegree,
    /// A sentence about vectors is stated for one coordinate.
    OneCoordinate,
    /// A sentence about all is stated for one instance.
    OneInstance,
    /// No slip in the statement would be noticed.
    NoMutant,
    /// The reading speaks of what is not stated.
    UnstatedReading,
    /// Nothing is stated of a sentence with a relation.
    UnstatedRelation,
    /// A hypothesis of ours is not needed.
    UnneededHypothesis,
    /// The quotation of a hypothesis does not say it.
    QuoteSaysOtherwise,
    /// What is excused by the copy is a sign, a relation or the number of an equation, which no defect of a copy explains.
    GarbledExcuse,
}
