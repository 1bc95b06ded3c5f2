//! The faults of a paper in the order in which letters and reports tell of them.

use crate::statements::{dependents, is_limited, is_named, is_refuted};
use std::cmp::Reverse;
use std::collections::BTreeSet;
use torse_syntax::derivation::LetterPart;
use torse_verdicts::outcome::{Outcome, PaperFault, PaperOutcome};

/// A fault: one that the files describe, or a refuted statement to which none is assigned.
#[derive(Debug)]
pub(crate) struct PlacedFault<'p> {
    /// The part of a letter that tells of it.
    pub part: FaultPart,
    /// What the files say of it; none of a refuted statement to which no fault is assigned.
    pub described: Option<&'p PaperFault>,
    /// The statements in which it shows, in the order of the files; never empty.
    pub shows: Vec<&'p Outcome>,
}

/// Returns the faults of a paper, part by part, the weightiest of a part first.
///
/// A fault that the files describe is one, wherever it shows; one that shows in no false or limited statement is left out.
/// Each refuted statement to which no fault is assigned is one of its own, so that none is left out.
pub(crate) fn faults(paper: &PaperOutcome) -> Vec<PlacedFault<'_>> {
    let claims = &paper.claims;
    let find = |id: &String| claims.iter().find(|outcome| outcome.claim.id == *id);
    let described = paper.faults.iter().filter_map(|fault| {
        let shows: Vec<&Outcome> = fault.shows.iter().filter_map(find).collect();
        Some(PlacedFault {
            part: fault_part(fault, &shows)?,
            described: Some(fault),
            shows,
        })
    });
    let is_assigned = |id: &str| paper.faults.iter().any(|fault| fault.shows_in(id));
    let alone = claims
        .iter()
        .filter(|outcome| is_refuted(outcome) && !is_assigned(&outcome.claim.id))
        .map(|outcome| PlacedFault {
            part: part(&[outcome]).unwrap_or(FaultPart::Correction),
            described: None,
            shows: vec![outcome],
        });
    let mut list: Vec<PlacedFault<'_>> = described.chain(alone).collect();
    list.sort_by_cached_key(|fault| (fault.part, FaultWeight::new(&fault.shows, paper)));
    list
}

/// The parts of a letter, in their order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum FaultPart {
    Correction,
    Condition,
    Question,
}

/// What makes one fault come before another in a part of a letter: theorems, propositions and algorithms first, then the
/// faults that concern most statements, then the order of the paper.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
struct FaultWeight {
    is_unnamed: bool,
    concerned: Reverse<usize>,
    position: usize,
}

impl FaultWeight {
    fn new(shows: &[&Outcome], paper: &PaperOutcome) -> Self {
        let mut concerned = BTreeSet::new();
        for claim in shows
            .iter()
            .filter(|claim| is_limited(claim) || is_refuted(claim))
        {
            concerned.insert(claim.claim.id.as_str());
            let (_, falling) = dependents(claim, paper);
            concerned.extend(falling.iter().map(|other| other.claim.id.as_str()));
        }
        let position = paper.claims.iter().position(|claim| {
            let mut shown = shows.iter();
            shown.any(|shown| shown.claim.id == claim.claim.id)
        });
        Self {
            is_unnamed: !shows.iter().any(|claim| is_named(claim)),
            concerned: Reverse(concerned.len()),
            position: position.unwrap_or(usize::MAX),
        }
    }
}

/// The part that the files name, or else that the verdicts ask for; none if all is true in which the fault is said to show.
fn fault_part(fault: &PaperFault, shows: &[&Outcome]) -> Option<FaultPart> {
    match fault.part {
        _ if shows.is_empty() => None,
        Some(LetterPart::Correction) => Some(FaultPart::Correction),
        Some(LetterPart::Condition) => Some(FaultPart::Condition),
        None => part(shows),
    }
}

/// Where a fault belongs; nowhere if all is true in which it is said to show.
fn part(shows: &[&Outcome]) -> Option<FaultPart> {
    let mut refuted = shows.iter().filter(|claim| is_refuted(claim)).peekable();
    if refuted.peek().is_some() {
        return Some(
            match refuted.all(|outcome| outcome.claim.garbled.is_some()) {
                true => FaultPart::Question,
                false => FaultPart::Correction,
            },
        );
    }
    if !shows.is_empty() && shows.iter().all(|outcome| outcome.claim.garbled.is_some()) {
        return Some(FaultPart::Question);
    }
    let is_condition = shows.iter().any(|claim| is_limited(claim));
    is_condition.then_some(FaultPart::Condition)
}
