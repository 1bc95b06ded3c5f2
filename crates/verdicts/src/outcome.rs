//! The results for a paper: plain data for report and command.

pub use crate::finding::{Outcome, ReadingOutcome};
use serde::Serialize;
use torse_prove::evidence::Evidence;
use torse_syntax::derivation::LetterPart;
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
    /// What is true with all corrections in force; none if not requested.
    pub restored: Option<Restoration>,
}

/// A fault of a paper, wherever it shows.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct PaperFault {
    /// Its id.
    pub id: String,
    /// The place in the paper, if it is not that of the first claim.
    pub at: Option<String>,
    /// The part of a letter that lists it, if not the one that the verdicts of its claims ask for.
    pub part: Option<LetterPart>,
    /// The fault, in one sentence.
    pub says: String,
    /// The ids of the claims in which it shows.
    pub shows: Vec<String>,
    /// The corrected words.
    pub changes: Vec<FaultChange>,
}

impl PaperFault {
    /// Whether it shows in the claim with this id.
    #[must_use]
    pub fn shows_in(&self, id: &str) -> bool {
        self.shows.iter().any(|shown| shown == id)
    }
}

/// Words of a paper and their correction.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FaultChange {
    /// The id of the claim whose print contains them.
    pub claim: String,
    /// The words.
    pub printed: String,
    /// The corrected words.
    pub reads: String,
    /// The id of the remark that states the correction.
    pub remark: Option<String>,
}

/// A paper with all of its corrections made.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct Restoration {
    /// The claims that the corrections are about.
    pub corrected: Vec<Restored>,
    /// The other claims that rest on these, or on a corrected definition.
    pub dependents: Vec<Restored>,
    /// The ids of claims of which only the words change: nothing is computed about them.
    pub reworded: Vec<String>,
}

/// A claim decided again, with all corrections of its paper in force.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Restored {
    /// The id of the claim.
    pub claim: String,
    /// The verdict of the corrected statement.
    pub verdict: Verdict,
    /// Its evidence.
    pub evidence: Option<Evidence>,
    /// Its conditions.
    pub conditions: Vec<Formula>,
}
