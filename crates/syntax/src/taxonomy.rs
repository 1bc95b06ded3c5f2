//! The classification of claims: the kind of statement that the paper makes, and the verdict on it.
//!
//! A derivation file states the kind, and may state the expected verdict.

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
    /// A property that is stated in words.
    Property,
    /// A construction.
    Construction,
    /// A figure.
    Figure,
    /// A checkable remark.
    Prose,
    /// A statement of ours that the paper does not make.
    Remark,
}

/// The verdict on a printed statement.
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
    /// The sentence has several readings, and its truth depends on the reading.
    Depends,
    /// Not decided; the reason and the attempts are stated.
    Undecided,
    /// No point satisfies the hypotheses.
    Vacuous,
    /// A definition, found to be well formed.
    Definition,
    /// The data needed to decide are not printed.
    Underspecified,
    /// The statement is outside the scope of this program; the reason is stated.
    OutOfScope,
    /// A figure redrawn from printed data alone.
    Reproduced,
    /// A figure redrawn under listed assumptions.
    Partial,
}

/// A sign that a statement may differ from what the paper prints.
#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, serde::Deserialize,
)]
#[serde(rename_all = "kebab-case")]
pub enum Flag {
    /// The two sides of an equation are identical formulas.
    EqualSides,
    /// The statement contains nothing that the paper defines.
    NothingOfThePaper,
    /// A printed number does not occur in the statement.
    LacksNumber,
    /// A printed name does not occur in the statement.
    LacksName,
    /// A printed relation does not occur in the statement.
    LacksRelation,
    /// A number in the statement is not printed.
    AddsNumber,
    /// A name in the statement is not printed.
    AddsName,
    /// A relation in the statement is not printed.
    AddsRelation,
    /// The words of a correction and the statement that is decided with it have different numbers, names, relations or signs.
    ReadsOtherwise,
    /// A formula in the words of a correction has other values than what is decided with it.
    ReadsAnotherFormula,
    /// The conclusion is among the hypotheses.
    AssumedConclusion,
    /// The statement has fewer parts than the sentence.
    ShortConjunction,
    /// A sentence about every degree is stated for one degree.
    OneDegree,
    /// A sentence about vectors is stated for one coordinate.
    OneCoordinate,
    /// A universal sentence is stated for one instance.
    OneInstance,
    /// No mutant of the statement is refuted, so a slip in it would go unnoticed.
    NoMutant,
    /// The reading mentions something that is not stated.
    UnstatedReading,
    /// A sentence with a relation has no statement.
    UnstatedRelation,
    /// A hypothesis of ours is not needed.
    UnneededHypothesis,
    /// The quotation for a hypothesis does not state the hypothesis.
    QuoteSaysOtherwise,
    /// What is excused by the copy is a sign, a relation or the number of an equation, which no defect of a copy explains.
    GarbledExcuse,
    /// A range or a hypothesis has no source.
    UnsourcedRange,
    /// A fault is said to show in the claim, and its verdict is none that a fault could be told by.
    AccusedWithoutVerdict,
    /// A sentence has readings, and its correction replaces nothing but letters, indices or numbers.
    CorrectedReading,
    /// Another paper prints the same words, and they have another verdict there.
    SamePrint,
}
