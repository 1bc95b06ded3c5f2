//! Faults of a paper for a letter to its authors, with computed numbers.

use crate::author_note;
use crate::outcome::{FaultChange, Outcome, PaperFault};
use torse_syntax::derivation::{AuthorNote, Corrigendum, DerivationError, Paper, Piece, Rewording};

/// The sentences before the first one with a number to be computed.
fn sentences_before_numbers(says: &AuthorNote) -> String {
    if let Some(whole) = says.without_holes() {
        return whole;
    }
    match says.pieces.first() {
        Some(Piece::Words(words)) => match words.rfind(". ") {
            Some(end) => words.get(..end).unwrap_or_default().to_owned(),
            None => String::new(),
        },
        _ => String::new(),
    }
}

/// Returns the faults that the files of a paper list, with their numbers filled in; decides nothing.
///
/// # Errors
/// A [`DerivationError`] for a hole that is not a number where the first claim of the fault fails.
pub fn faults(
    paper: &Paper,
    outcomes: &[Outcome],
) -> Result<Vec<PaperFault>, Box<DerivationError>> {
    let change = |of: &Rewording| FaultChange {
        claim: of.claim.clone(),
        printed: of.printed.clone(),
        reads: of.reads.clone(),
        remark: of.remark.clone(),
    };
    let says = |of: &Corrigendum| -> Result<String, Box<DerivationError>> {
        let first = of.shows.first();
        let claim = paper
            .claims
            .iter()
            .find(|claim| Some(claim.entry.id.get_ref()) == first);
        let outcome = outcomes
            .iter()
            .find(|outcome| Some(&outcome.claim.id) == first);
        match (claim, outcome) {
            (Some(claim), Some(outcome)) => {
                author_note::filled_in(claim, outcome.witness(), &of.says)
            }
            // The numbers belong to a claim that is not part of this run.
            _ => Ok(sentences_before_numbers(&of.says)),
        }
    };
    let fault = |of: &Corrigendum| -> Result<PaperFault, Box<DerivationError>> {
        Ok(PaperFault {
            id: of.id.clone(),
            at: of.at.clone(),
            part: of.part,
            says: says(of)?,
            shows: of.shows.clone(),
            changes: of.changes.iter().map(change).collect(),
        })
    };
    paper.corrigenda.iter().map(fault).collect()
}
