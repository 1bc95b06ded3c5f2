//! What makes a statement weigh in a paper: whether it is false, whether a theorem says it, what depends on it.

use torse_syntax::taxonomy::{Kind, Verdict};
use torse_verdicts::consequences::{Fate, consequences};
use torse_verdicts::outcome::{Outcome, PaperFault, PaperOutcome};

/// Whether a claim of the paper is false as printed.
pub(crate) fn is_refuted(outcome: &Outcome) -> bool {
    matches!(outcome.verdict(), Verdict::False | Verdict::Misprint)
        && outcome.claim.kind != Kind::Remark
}

/// What has conditions or readings, and words of which nothing is to be decided.
pub(crate) fn is_limited(claim: &Outcome) -> bool {
    matches!(
        claim.verdict(),
        Verdict::Conditional | Verdict::Depends | Verdict::Underspecified | Verdict::OutOfScope
    )
}

/// Whether a claim is of a theorem, proposition or algorithm itself, and not of its proof or of a line after it.
pub(crate) fn is_named(outcome: &Outcome) -> bool {
    let at = &outcome.claim.at;
    let named = ["Theorem", "Proposition", "Algorithm"];
    named.iter().any(|word| at.contains(word))
        && !["proof of", "after ", "before "]
            .iter()
            .any(|word| at.contains(word))
}

/// What depends on a statement.
pub(crate) struct Dependents<'p> {
    /// The ids of all statements that do, directly or through others.
    pub resting: Vec<String>,
    /// Those of them that fail by the same fault.
    pub falling: Vec<&'p Outcome>,
}

/// Finds what depends on a statement.
pub(crate) fn dependents<'p>(outcome: &Outcome, paper: &'p PaperOutcome) -> Dependents<'p> {
    let all: Vec<&Outcome> = paper.claims.iter().collect();
    let resting = consequences(&outcome.claim.id, &all);
    let falling = resting
        .iter()
        .filter(|own| own.fate == Fate::Falls && !has_other_fault(&own.id, outcome, &paper.faults))
        .filter_map(|own| paper.claims.iter().find(|claim| claim.claim.id == own.id));
    Dependents {
        falling: falling.collect(),
        resting: resting.iter().map(|own| own.id.clone()).collect(),
    }
}

/// Whether a claim that depends on a refuted one and is false too has a fault of its own, which the files describe apart.
fn has_other_fault(id: &str, cause: &Outcome, faults: &[PaperFault]) -> bool {
    let mut own = faults.iter().filter(|fault| fault.shows_in(id)).peekable();
    own.peek().is_some() && !own.any(|fault| fault.shows_in(&cause.claim.id))
}
