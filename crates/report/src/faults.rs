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
    /// How many other statements depend on the false and limited ones of these.
    pub resting: usize,
    /// How many of those are false by this fault too.
    pub falling: usize,
    weight: FaultWeight,
}

impl<'p> PlacedFault<'p> {
    fn new(
        part: FaultPart,
        described: Option<&'p PaperFault>,
        shows: Vec<&'p Outcome>,
        paper: &'p PaperOutcome,
    ) -> Self {
        let (mut own, mut resting, mut falling) =
            (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
        for claim in shows
            .iter()
            .filter(|shown| is_limited(shown) || is_refuted(shown))
        {
            own.insert(claim.claim.id.as_str());
            let found = dependents(claim, paper);
            resting.extend(found.resting);
            falling.extend(found.falling.iter().map(|other| other.claim.id.as_str()));
        }
        falling.retain(|id| !own.contains(id));
        resting.retain(|id| !shows.iter().any(|shown| shown.claim.id == *id));
        let position = paper.claims.iter().position(|claim| {
            let mut shown = shows.iter();
            shown.any(|shown| shown.claim.id == claim.claim.id)
        });
        Self {
            resting: resting.len(),
            falling: falling.len(),
            weight: FaultWeight {
                is_unnamed: !shows.iter().any(|claim| is_named(claim)),
                concerned: Reverse(own.len() + falling.len()),
                position: position.unwrap_or(usize::MAX),
            },
            part,
            described,
            shows,
        }
    }

    /// The first false statement in which it shows, or else the first of all.
    pub(crate) fn lead(&self) -> Option<&'p Outcome> {
        let mut shows = self.shows.iter();
        let refuted = shows.find(|claim| is_refuted(claim));
        refuted.or(self.shows.first()).copied()
    }
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
        let part = fault_part(fault, &shows)?;
        Some(PlacedFault::new(part, Some(fault), shows, paper))
    });
    let is_assigned = |id: &str| paper.faults.iter().any(|fault| fault.shows_in(id));
    let alone = claims
        .iter()
        .filter(|outcome| is_refuted(outcome) && !is_assigned(&outcome.claim.id))
        .map(|outcome| {
            let part = part(&[outcome]).unwrap_or(FaultPart::Correction);
            PlacedFault::new(part, None, vec![outcome], paper)
        });
    let mut list: Vec<PlacedFault<'_>> = described.chain(alone).collect();
    list.sort_by_key(|fault| (fault.part, fault.weight));
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
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct FaultWeight {
    is_unnamed: bool,
    concerned: Reverse<usize>,
    position: usize,
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
