//! A claim as its file states it, for readers: plain data.

use crate::dependencies::Dependencies;
use serde::Serialize;
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::{Kind, Verdict};

/// The content of a claim's file, and the dependencies of its statement.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ClaimRecord {
    /// The id of the inventory, `paper/name`.
    pub id: String,
    /// The paper's slug.
    pub paper: String,
    /// The place in the paper.
    pub at: String,
    /// The kind of statement.
    pub kind: Kind,
    /// The statement as printed, verbatim.
    pub printed: String,
    /// The inventory id of the sentence that this claim is a part of.
    pub part_of: Option<String>,
    /// How our copy of the text was read where it is garbled or unclear.
    pub reading: Option<String>,
    /// What in the finding may be an artefact of our copy of the paper.
    pub garbled: Option<String>,
    /// The statement as the engine understood it.
    pub parsed: Option<Formula>,
    /// Whether the statement compares a formula with anything but itself.
    pub compared: bool,
    /// The hypotheses under which it was decided: ranges of which the files say where they are from, assumptions, given
    /// equations.
    pub assumed: Vec<Assumed>,
    /// The other dependencies of the statement: declared sets, definitions, unknowns.
    pub table: Dependencies,
    /// The file's sentence about the finding, with its numbers computed; none if nothing was decided.
    pub author_note: Option<String>,
    /// Anything a reader should know.
    pub note: Option<String>,
    /// Claims that this one rests on.
    pub uses: Vec<String>,
    /// The verdict the derivation file expects, if it states one.
    pub expect: Option<Verdict>,
}

/// A hypothesis with its source.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Assumed {
    /// Its form in the file.
    pub role: Role,
    /// The assumption, as understood; for a set that is no range of numbers, in words.
    pub formula: Formula,
    /// Its source.
    pub from: HypothesisSource,
    /// Whether the proof needs it, if it is ours and was tried.
    pub needed: Option<bool>,
}

/// The form of a hypothesis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Role {
    /// The declared set of a symbol.
    Range,
    /// An assumption.
    Assume,
    /// An equation that determines unknowns.
    Given,
}

/// The source of a hypothesis.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "from")]
pub enum HypothesisSource {
    /// The file states it as part of the statement, without a source.
    Stated,
    /// The paper says it.
    Printed {
        /// Its words.
        quote: String,
        /// The id of the claim whose print contains them.
        claim: String,
    },
    /// The paper does not say it.
    Ours {
        /// Why it is assumed.
        reason: String,
    },
}
