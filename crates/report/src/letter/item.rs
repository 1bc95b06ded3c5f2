//! An item of a letter: where a fault is, what is printed there, and what is to be read instead.

use super::counterexample::{counterexample, is_about_a_letter, is_in_one_coordinate};
use crate::faults::PlacedFault;
use crate::names::printed_names;
use crate::sentence;
use crate::text::visible;
use crate::view::{CorrectionView, correction};
use serde::Serialize;
use torse_typography::{PrintedNames, Prose, compared, in_words, quotation, spans};
use torse_verdicts::outcome::{Outcome, PaperFault, PaperOutcome};

/// A fault.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Item {
    /// Where it is.
    pub heading: Prose,
    /// What is wrong, in a sentence.
    pub says: Prose,
    /// What is printed and what is to be read.
    pub changes: Vec<ItemChange>,
    /// An exact counterexample.
    pub why: Option<Prose>,
    /// Whether its points and vectors are numbers: one coordinate of them, which stands for all.
    pub in_one_coordinate: bool,
    /// Where it shows besides.
    pub also: Vec<Prose>,
}

impl Item {
    /// What stands before the counterexample.
    pub(crate) fn why_label(&self) -> &'static str {
        match self.in_one_coordinate {
            true => "Counterexample, for one coordinate",
            false => "Counterexample",
        }
    }
}

/// Words of the paper, and what is to be read instead.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ItemChange {
    /// Where they stand, if there is more than one place; none where that is the place of the change before.
    pub at: Option<Prose>,
    /// The words.
    pub printed: Prose,
    /// What is to be read instead; none where the words say what is not so and no others are offered.
    pub reads: Option<Prose>,
    /// A correction that was found for the formula by which the words were understood.
    pub formula: Option<CorrectionView>,
}

/// The item of a fault, the same in a letter and in a report; none of a fault that shows nowhere.
pub(crate) fn item(fault: &PlacedFault<'_>, paper: &PaperOutcome) -> Option<Item> {
    match fault.described {
        Some(described) => Some(item_of_fault(described, &fault.shows, paper)),
        None => fault
            .shows
            .first()
            .map(|outcome| item_without_fault(outcome)),
    }
}

fn item_of_fault(fault: &PaperFault, shows: &[&Outcome], paper: &PaperOutcome) -> Item {
    let find = |id: &String| paper.claims.iter().find(|outcome| outcome.claim.id == *id);
    let mut names = shows
        .first()
        .map(|claim| printed_names(claim))
        .unwrap_or_default();
    for claim in shows.iter().skip(1) {
        names.extend(printed_names(claim));
    }
    let several = fault.changes.len() > 1;
    let mut before = None;
    let mut changes: Vec<ItemChange> = (fault.changes.iter())
        .filter_map(|change| {
            let claim = find(&change.claim)?;
            let [printed, reads] =
                compared(&visible(&change.printed), &visible(&change.reads), &names);
            // A place is named once for all changes that follow one another there.
            let at = Some(place(claim)).filter(|at| several && before.as_ref() != Some(at));
            before = at.clone().or(before.take());
            Some(ItemChange {
                at,
                printed,
                reads: Some(reads),
                formula: None,
            })
        })
        .collect();
    // Of a sentence for which no other is offered, the words.
    if changes.is_empty() {
        changes.extend(shows.first().map(|outcome| ItemChange {
            at: None,
            printed: quotation(&visible(&outcome.claim.printed), &names),
            reads: None,
            formula: None,
        }));
    }
    let changed = |claim: &&&Outcome| {
        fault
            .changes
            .iter()
            .any(|change| change.claim == claim.claim.id)
    };
    let heading = match &fault.at {
        Some(at) => spans(&visible(at), &names),
        None => shows.first().map(|claim| place(claim)).unwrap_or_default(),
    };
    // Places at which the item is already: its heading, or a part or the whole of that, and those of its changes.
    let own = in_words(&heading);
    let mut here: Vec<Prose> = (fault.changes.iter())
        .filter_map(|change| find(&change.claim).map(place))
        .collect();
    let mut also: Vec<Prose> = vec![];
    for claim in shows
        .iter()
        .filter(|claim| !changed(claim))
        .skip(usize::from(fault.changes.is_empty()))
    {
        let place = place(claim);
        let words = in_words(&place);
        let is_here = own.starts_with(&words) || words.starts_with(&own) || here.contains(&place);
        if !is_here {
            here.push(place.clone());
            also.push(place);
        }
    }
    let refuted = shows
        .iter()
        .filter(|claim| !is_about_a_letter(fault, claim))
        .find_map(|claim| Some((counterexample(claim)?, is_in_one_coordinate(claim))));
    Item {
        heading,
        says: spans(&visible(&sentence::finished(&fault.says)), &names),
        changes,
        in_one_coordinate: refuted.as_ref().is_some_and(|(_, one)| *one),
        why: refuted.map(|(why, _)| why),
        also,
    }
}

/// The item of a refuted statement to which no fault is assigned.
fn item_without_fault(outcome: &Outcome) -> Item {
    let names = printed_names(outcome);
    let formula = (outcome.correction()).map(|repair| correction(outcome.parsed(), repair, &names));
    let change = match (
        &outcome.claim.author_note,
        outcome.correction(),
        &outcome.claim.note,
    ) {
        (Some(finding), ..) => Some(sentence::finished(finding)),
        (None, Some(repair), _) => Some(with_changes(&repair.edits)),
        (None, None, Some(note)) => Some(note.clone()),
        (None, None, None) => None,
    };
    // Where nothing else is known it is the counterexample that says what is wrong, and it is said once.
    let why = change.is_some().then(|| counterexample(outcome)).flatten();
    let says = change.unwrap_or_else(|| {
        let failure = sentence::failure_in_full(outcome);
        failure.map_or_else(String::new, |text| sentence::finished(&text))
    });
    Item {
        heading: place(outcome),
        says: spans(&visible(&says), &names),
        changes: vec![ItemChange {
            at: None,
            printed: quotation(&visible(&outcome.claim.printed), &names),
            reads: None,
            formula,
        }],
        in_one_coordinate: why.is_some() && is_in_one_coordinate(outcome),
        why,
        also: vec![],
    }
}

/// Says by which edits a statement becomes true.
fn with_changes(edits: &[String]) -> String {
    let count = match edits.len() {
        1 => "one change",
        _ => "these changes",
    };
    sentence::finished(&format!("It holds with {count}: {}", edits.join("; ")))
}

fn place(outcome: &Outcome) -> Prose {
    spans(&visible(&outcome.claim.at), &PrintedNames::default())
}
