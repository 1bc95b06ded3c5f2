//! A claim as its file has it, for its readers: plain data.

use crate::dependencies::Dependencies;
use serde::Serialize;
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::{Kind, Verdict};

/// What the file of a claim says, and what its statement rests on.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ClaimRecord {
    /// The id of the inventory, `paper/name`.
    pub id: String,
    /// The paper's slug.
    pub paper: String,
    /// Where the paper says it.
    pub at: String,
    /// What kind of statement it is.
    pub kind: Kind,
    /// The statement as printed, verbatim.
    pub printed: String,
    /// The id in the inventory of the sentence of which this is a part.
    pub part_of: Option<String>,
    /// How our copy of the text was read, where it is garbled or unclear.
    pub reading: Option<String>,
    /// What in the finding may be a confusion of the copy at hand.
    pub garbled: Option<String>,
    /// The statement as the engine understood it.
    pub parsed: Option<Formula>,
    /// The hypotheses under which it was decided: ranges of which the files say where they are from, assumptions, given
    /// equations.
    pub assumed: Vec<Assumed>,
    /// What the statement rests on besides: declared sets, definitions, unknowns.
    pub table: Dependencies,
    /// The sentence in which the file tells what was found, with its numbers computed; none where nothing was decided.
    pub author_note: Option<String>,
    /// Anything a reader should know.
    pub note: Option<String>,
    /// Claims this one rests on.
    pub uses: Vec<String>,
    /// The verdict the derivation file expects, if it states one.
    pub expect: Option<Verdict>,
}

/// A hypothesis, and whose it is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Assumed {
    /// In what form it stands in the file.
    pub role: Role,
    /// What is assumed, as understood; a set that is no range of numbers in words.
    pub formula: Formula,
    /// Where it is from.
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

/// Where a hypothesis is from.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case", tag = "from")]
pub enum HypothesisSource {
    /// It is part of the statement as the file states it; nothing is said of the print.
    Stated,
    /// The paper says it.
    Printed {
        /// In these words.
        quote: String,
        /// The id of the claim in whose print they stand.
        claim: String,
    },
    /// The paper does not say it.
    Ours {
        /// Why it is assumed.
        reason: String,
    },
}
