//! Errors and their corrections, most consequential first.

use crate::findings::{self, Finding};
use crate::glossary;
use crate::names::printed_names;
use crate::sentence;
use crate::statements::{dependents, is_named, is_refuted};
use crate::text::visible;
use crate::view::{CorrectionView, FormulaView, correction, formula};
use serde::Serialize;
use std::collections::BTreeSet;
use torse_syntax::taxonomy::Kind;
use torse_typography::{Prose, compared, spans};
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
