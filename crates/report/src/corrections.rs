//! What is false as printed, and what is to be read instead, in the order of what rests on it.

use crate::findings::{self, Finding};
use crate::glossary::{self, Term};
use crate::math::{Names, Prose, compared, spans};
use crate::sentence;
use crate::text::visible;
use crate::view::{CorrectionView, FormulaView, correction, formula};
use serde::Serialize;
use std::collections::BTreeSet;
use torse_syntax::taxonomy::{Kind, Verdict};
use torse_verdicts::consequences::{Fate, consequences};
use torse_verdicts::outcome::{Outcome, PaperFault, PaperOutcome};

/// A statement that is false as printed.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Corrected {
    /// Which it is, what is printed, and what was found.
    pub finding: Finding,
    /// The words of the paper and what is to be read instead, where the files tell of the fault.
    pub reworded: Option<Reworded>,
    /// What is to be read instead, where a correction or a true form is proved.
    pub correction: Option<CorrectionView>,
    /// The statement as understood, where there is no correction.
    pub stated: Option<FormulaView>,
    /// Where it fails, and by how much.
    pub why: Option<Prose>,
    /// The same with the whole point.
    pub why_in_full: Option<Prose>,
    /// What in it may be a confusion of the copy at hand.
    pub garbled: Option<Prose>,
    /// How the verdict was checked.
    pub level: Option<Term>,
    /// How many statements rest on it.
    pub resting: usize,
    /// How many of them fall.
    pub falling: usize,
}

/// Words of the paper and what is to be read instead, with what differs marked.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Reworded {
    /// As printed.
    pub printed: Prose,
    /// To be read.
    pub reads: Prose,
}

/// What the files tell of a claim's fault.
pub(crate) fn reworded(outcome: &Outcome, faults: &[PaperFault]) -> Option<Reworded> {
    let mut changes = faults.iter().flat_map(|fault| &fault.changes);
    let change = changes.find(|change| change.claim == outcome.claim.id)?;
    let names = Names::new(outcome);
    let [printed, reads] = compared(&visible(&change.printed), &visible(&change.reads), &names);
    Some(Reworded { printed, reads })
}

/// Whether a claim of the paper is false as printed.
pub(crate) fn is_refuted(outcome: &Outcome) -> bool {
    matches!(outcome.verdict(), Verdict::False | Verdict::Misprint)
        && outcome.claim.kind != Kind::Remark
}

/// How many statements rest on a claim, and how many of them fall.
pub(crate) fn weight(outcome: &Outcome, all: &[&Outcome]) -> (usize, usize) {
    let resting = consequences(&outcome.claim.id, all);
    let falling = resting.iter().filter(|of| of.fate == Fate::Falls).count();
    (resting.len(), falling)
}

/// The positions of the refuted claims: what most rests on first; what may be a confusion of the copy last.
pub(crate) fn ranked(claims: &[Outcome]) -> Vec<(usize, (usize, usize))> {
    let all: Vec<&Outcome> = claims.iter().collect();
    let refuted = claims.iter().enumerate();
    let refuted = refuted.filter(|(_, claim)| is_refuted(claim));
    let mut list: Vec<_> = refuted
        .map(|(position, claim)| {
            let weight = weight(claim, &all);
            (position, weight, rank(claim), claim.claim.garbled.is_some())
        })
        .collect();
    list.sort_by_key(|(position, weight, rank, garbled)| {
        (*garbled, std::cmp::Reverse(weight.0), *rank, *position)
    });
    list.into_iter()
        .map(|(position, weight, ..)| (position, weight))
        .collect()
}

/// Of statements on which as much rests, theorems and formulas come before remarks.
fn rank(outcome: &Outcome) -> usize {
    let named = ["Theorem", "Proposition", "Algorithm"];
    let named = named.iter().any(|word| outcome.claim.at.contains(word))
        && !outcome.claim.at.contains("proof of");
    match outcome.claim.kind {
        _ if named => 0,
        Kind::Construction | Kind::Property | Kind::Identity | Kind::Inequality => 1,
        Kind::Value | Kind::Definition => 2,
        _ => 3,
    }
}

/// The corrections of a paper.
pub(crate) fn corrections(
    paper: &PaperOutcome,
    anchors: &[String],
    accepted: &BTreeSet<String>,
) -> Vec<Corrected> {
    let claims = &paper.claims;
    let view = |(position, (resting, falling)): (usize, (usize, usize))| {
        let claim = claims.get(position)?;
        let names = Names::new(claim);
        let prose = |text: &str| spans(&visible(text), &names);
        let parsed = claim.parsed();
        Some(Corrected {
            finding: findings::about(claim, anchors.get(position)?),
            reworded: reworded(claim, &paper.faults),
            correction: (claim.correction()).map(|repair| correction(parsed, repair, &names)),
            stated: match claim.correction() {
                Some(_) => None,
                None => parsed.map(|of| formula(of, &names)),
            },
            // Without a finding and a correction the sentence says where it fails.
            why: (claim.claim.author_note.is_some() || claim.correction().is_some())
                .then(|| sentence::failure(claim))
                .flatten()
                .map(|text| prose(&text)),
            why_in_full: sentence::failure_in_full(claim).map(|text| prose(&text)),
            garbled: claim.claim.garbled.as_deref().map(prose),
            level: glossary::level(claim, accepted.contains(&claim.claim.id)),
            resting,
            falling,
        })
    };
    ranked(claims).into_iter().filter_map(view).collect()
}
