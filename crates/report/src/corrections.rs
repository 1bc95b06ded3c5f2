//! Errors and their corrections, most consequential first.

use crate::findings::{self, Finding};
use crate::glossary;
use crate::names::printed_names;
use crate::sentence;
use crate::text::visible;
use crate::view::{CorrectionView, FormulaView, correction, formula};
use serde::Serialize;
use std::collections::BTreeSet;
use torse_syntax::taxonomy::{Kind, Verdict};
use torse_typography::{Prose, compared, spans};
use torse_verdicts::consequences::{Fate, consequences};
use torse_verdicts::outcome::{Outcome, PaperFault, PaperOutcome};

/// A statement that is false as printed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Corrected {
    /// Its number, its print, and the finding.
    pub finding: Finding,
    /// The words of the paper and their correction, if a file describes the fault.
    pub reworded: Option<Reworded>,
    /// The corrected statement, if a correction or a true form is proved.
    pub correction: Option<CorrectionView>,
    /// The statement as understood, if there is no correction.
    pub stated: Option<FormulaView>,
    /// Where it fails, and by how much.
    pub why: Option<Prose>,
    /// The same with the whole point.
    pub why_in_full: Option<Prose>,
    /// What in it may be an artefact of our copy of the paper.
    pub garbled: Option<Prose>,
    /// What checked it beside the prover, for a sentence; none if nothing did.
    pub checked_by: Option<&'static str>,
    /// How many statements depend on it.
    pub resting: usize,
    /// How many of them fail too.
    pub falling: usize,
}

/// Words of the paper and their correction, with the differences marked.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Reworded {
    /// As printed.
    pub printed: Prose,
    /// Corrected.
    pub reads: Prose,
}

/// The description of a claim's fault in the files.
pub(crate) fn reworded(outcome: &Outcome, faults: &[PaperFault]) -> Option<Reworded> {
    let mut changes = faults.iter().flat_map(|fault| &fault.changes);
    let change = changes.find(|change| change.claim == outcome.claim.id)?;
    let names = printed_names(outcome);
    let [printed, reads] = compared(&visible(&change.printed), &visible(&change.reads), &names);
    Some(Reworded { printed, reads })
}

/// Whether a claim of the paper is false as printed.
pub(crate) fn is_refuted(outcome: &Outcome) -> bool {
    matches!(outcome.verdict(), Verdict::False | Verdict::Misprint)
        && outcome.claim.kind != Kind::Remark
}

/// Whether a claim that depends on a refuted one and is false too has a fault of its own, which the files describe apart.
fn has_other_fault(id: &str, cause: &Outcome, faults: &[PaperFault]) -> bool {
    let mut own = faults.iter().filter(|fault| fault.shows_in(id)).peekable();
    own.peek().is_some() && !own.any(|fault| fault.shows_in(&cause.claim.id))
}

/// The statements that depend on a refuted claim, and those of them that fail by the same fault.
pub(crate) fn dependents<'p>(
    outcome: &Outcome,
    paper: &'p PaperOutcome,
) -> (usize, Vec<&'p Outcome>) {
    let all: Vec<&Outcome> = paper.claims.iter().collect();
    let resting = consequences(&outcome.claim.id, &all);
    let falling = resting
        .iter()
        .filter(|of| of.fate == Fate::Falls && !has_other_fault(&of.id, outcome, &paper.faults))
        .filter_map(|of| paper.claims.iter().find(|claim| claim.claim.id == of.id));
    (resting.len(), falling.collect())
}

/// Returns the positions of the refuted claims: theorems and algorithms first, of these and of the others those with most
/// dependents, and possible artefacts of our copy last.
pub(crate) fn ranked(paper: &PaperOutcome) -> Vec<(usize, (usize, usize))> {
    let refuted = paper.claims.iter().enumerate();
    let refuted = refuted.filter(|(_, claim)| is_refuted(claim));
    let mut list: Vec<_> = refuted
        .map(|(position, claim)| {
            let (resting, falling) = dependents(claim, paper);
            let weight = (resting, falling.len());
            (position, weight, rank(claim), claim.claim.garbled.is_some())
        })
        .collect();
    list.sort_by_key(|(position, weight, rank, garbled)| {
        (
            *garbled,
            *rank > 0,
            std::cmp::Reverse(weight.0),
            *rank,
            *position,
        )
    });
    list.into_iter()
        .map(|(position, weight, ..)| (position, weight))
        .collect()
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

/// Theorems and algorithms come first; among other statements with equally many dependents, formulas come before remarks.
fn rank(outcome: &Outcome) -> usize {
    match outcome.claim.kind {
        _ if is_named(outcome) => 0,
        Kind::Construction | Kind::Property | Kind::Identity | Kind::Inequality => 1,
        Kind::Value | Kind::Definition => 2,
        _ => 3,
    }
}

/// Collects the corrections of a paper.
pub(crate) fn corrections(
    paper: &PaperOutcome,
    anchors: &[String],
    accepted: &BTreeSet<String>,
) -> Vec<Corrected> {
    let claims = &paper.claims;
    let view = |(position, (resting, falling)): (usize, (usize, usize))| {
        let claim = claims.get(position)?;
        let names = printed_names(claim);
        let prose = |text: &str| spans(&visible(text), &names);
        let parsed = claim.parsed();
        Some(Corrected {
            finding: findings::about(claim, anchors.get(position)?, &paper.faults),
            reworded: reworded(claim, &paper.faults),
            correction: (claim.correction()).map(|repair| correction(parsed, repair, &names)),
            stated: match claim.correction() {
                Some(_) => None,
                None => parsed.map(|of| formula(of, &names)),
            },
            // Without a finding and a correction, the sentence says where the statement fails.
            why: (claim.claim.author_note.is_some() || claim.correction().is_some())
                .then(|| sentence::failure(claim))
                .flatten()
                .map(|text| prose(&sentence::capital(&text))),
            why_in_full: sentence::failure_in_full(claim).map(|text| prose(&text)),
            garbled: claim.claim.garbled.as_deref().map(prose),
            checked_by: glossary::level(claim, accepted.contains(&claim.claim.id))
                .and_then(glossary::checked_by),
            resting,
            falling,
        })
    };
    ranked(paper).into_iter().filter_map(view).collect()
}
