//! What the engine found of a paper: plain data, handed to the report and the command.

pub use crate::finding::{Outcome, ReadingOutcome};
use serde::Serialize;
use torse_prove::evidence::Evidence;
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::Verdict;

/// A paper and its decided claims, in file order.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct PaperOutcome {
    /// The paper's slug, for instance `gbt-developable`.
    pub slug: String,
    /// The title.
    pub title: String,
    /// The authors, one line.
    pub authors: String,
    /// Where it appeared.
    pub venue: String,
    /// The outcomes.
    pub claims: Vec<Outcome>,
    /// The faults of which the authors are told.
    pub faults: Vec<PaperFault>,
    /// What the claims are with all corrections in force; empty where nobody asked.
    pub restored: Vec<Restored>,
}

/// A fault of a paper, wherever it shows.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct PaperFault {
    /// Its id.
    pub id: String,
    /// Where the paper has it, if that is not the place of the first claim.
    pub at: Option<String>,
    /// What is wrong, in one sentence.
    pub says: String,
    /// The ids of the claims in which it shows.
    pub shows: Vec<String>,
    /// What is to be read instead.
    pub changes: Vec<FaultChange>,
}

/// Words of a paper, and what is to be read instead.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FaultChange {
    /// The id of the claim in whose print they stand.
    pub claim: String,
    /// The words.
    pub printed: String,
    /// What is to be read instead.
    pub reads: String,
    /// The id of the remark that states it.
    pub remark: Option<String>,
}

/// A claim decided again, with all corrections of its paper in force.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Restored {
    /// The id of the claim.
    pub claim: String,
    /// What is true of the corrected statement.
    pub verdict: Verdict,
    /// What that rests on.
    pub evidence: Option<Evidence>,
    /// Its conditions.
    pub conditions: Vec<Formula>,
}
