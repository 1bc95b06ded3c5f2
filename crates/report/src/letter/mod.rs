//! The letter to the authors of a paper: what is to be corrected, fault by fault, in the notation of the paper.
//!
//! A fault that files tell of has one item, wherever it shows, with the words of the paper and what is to be read instead.
//! A refuted statement to which no fault is assigned has an item of its own, so that none is left out. What may be a slip of the
//! copy at hand is asked, and not claimed; conditions that the text should state have a part of their own.

mod closing;
mod counterexample;
mod item;
mod opening;
mod restored;

pub(crate) use item::item;
pub use item::{Item, ItemChange};
pub use opening::Scope;

use crate::faults::{FaultPart, faults};
use crate::text::visible;
use closing::closing;
use opening::{example, opening, salutation};
use serde::Serialize;
use std::collections::BTreeSet;
use torse_syntax::derivation::schema::is_worked;
use torse_syntax::taxonomy::{Kind, Verdict};
use torse_verdicts::outcome::{Outcome, PaperOutcome};

/// Who writes a letter, and when. Without a sender it is a draft.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct Envelope {
    /// The name of the sender.
    pub sender: Option<String>,
    /// The date, as it is to be written.
    pub date: Option<String>,
}

impl Envelope {
    /// The envelope with what could act on the text around it spelled out.
    #[must_use]
    pub fn cleared(&self) -> Self {
        let clear = |text: &Option<String>| text.as_deref().map(|text| visible(text.trim()));
        Self {
            sender: clear(&self.sender).filter(|name| !name.is_empty()),
            date: clear(&self.date).filter(|date| !date.is_empty()),
        }
    }
}

/// What a letter says.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Letter {
    /// How the authors are addressed; none of a worked example, which has no authors to write to.
    pub salutation: Option<String>,
    /// How much of the paper was decided.
    pub scope: Scope,
    /// What the letter is about, and how the statements were decided.
    pub opening: String,
    /// What is false and how it is to be corrected, the most consequential first.
    pub corrections: Vec<Item>,
    /// Conditions that the text should state.
    pub conditions: Vec<Item>,
    /// What may be right in print, and a slip of the copy at hand.
    pub questions: Vec<Item>,
    /// What is true with all corrections in force, and how all of it was checked.
    pub closing: Vec<String>,
}

/// The letter about a paper.
pub(crate) fn letter(paper: &PaperOutcome, accepted: &BTreeSet<String>) -> Letter {
    let claims = &paper.claims;
    let placed: Vec<(FaultPart, Item)> = (faults(paper).iter())
        .filter_map(|fault| Some((fault.part, item(fault, paper)?)))
        .collect();
    let take = |wanted: FaultPart| -> Vec<Item> {
        let of = placed.iter().filter(|(part, _)| *part == wanted);
        of.map(|(_, item)| item.clone()).collect()
    };
    let corrections = take(FaultPart::Correction);
    let conditions = take(FaultPart::Condition);
    // What the print may say itself needs no counterexample.
    let asked = |item: Item| Item { why: None, ..item };
    let questions: Vec<Item> = take(FaultPart::Question).into_iter().map(asked).collect();
    let is_open = |outcome: &&Outcome| {
        outcome.verdict() == Verdict::Undecided && outcome.claim.kind != Kind::Remark
    };
    let open: Vec<&Outcome> = claims.iter().filter(is_open).collect();
    let scope = Scope::new(claims);
    Letter {
        scope,
        salutation: (!is_worked(&paper.authors)).then(|| salutation(&visible(&paper.authors))),
        opening: match is_worked(&paper.authors) {
            true => example(corrections.len()),
            false => opening(
                scope,
                [corrections.len(), conditions.len(), questions.len()],
                &open,
            ),
        },
        closing: closing(paper, corrections.len(), accepted),
        corrections,
        conditions,
        questions,
    }
}
