//! Faults of a paper with their corrections, in the order of its letter.

use crate::faults::{FaultPart, PlacedFault, faults};
use crate::glossary::{self, Term};
use crate::letter::{Item, item};
use crate::names::printed_names;
use crate::statements::is_refuted;
use crate::text::{name, visible};
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use torse_typography::{Prose, spans};
use torse_verdicts::outcome::{Outcome, PaperOutcome};

/// A fault: what the letter says of it, and the statements in which it shows.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Corrected {
    /// What the letter says of it.
    pub item: Item,
    /// The statements in which it shows.
    pub shows: Vec<ShownIn>,
    /// The verdict on the first false one of these.
    pub verdict: Term,
    /// What in it may be an artefact of our copy of the paper.
    pub garbled: Option<Prose>,
    /// What checked all false ones of them beside the prover, for a sentence; none if nothing did, or not all in the same way.
    pub checked_by: Option<&'static str>,
    /// How many other statements depend on them.
    pub resting: usize,
    /// How many of those are false by this fault too.
    pub falling: usize,
}

impl Corrected {
    /// Whether it shows in the claim with this identifier for links.
    pub(crate) fn shows_at(&self, anchor: &str) -> bool {
        self.shows.iter().any(|shown| shown.anchor == anchor)
    }
}

/// A statement in which a fault shows.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ShownIn {
    /// The id without the paper's slug.
    pub name: String,
    /// The claim's identifier for links.
    pub anchor: String,
    /// The verdict on it.
    pub verdict: Term,
}

/// Collects the faults of one part of the letter. `anchors` holds the claims' identifiers for links, by position, and
/// `accepted` the ids of the claims whose proofs the kernel accepted.
pub(crate) fn corrections(
    paper: &PaperOutcome,
    part: FaultPart,
    anchors: &[String],
    accepted: &BTreeSet<String>,
) -> Vec<Corrected> {
    let claims = paper.claims.iter().map(|outcome| outcome.claim.id.as_str());
    let anchors: BTreeMap<&str, &String> = claims.zip(anchors).collect();
    let of_part = faults(paper).into_iter().filter(|fault| fault.part == part);
    of_part
        .filter_map(|fault| {
            let lead = fault.lead()?;
            let shown = |outcome: &&Outcome| {
                Some(ShownIn {
                    name: visible(name(&outcome.claim.id)),
                    anchor: (*anchors.get(outcome.claim.id.as_str())?).clone(),
                    verdict: glossary::verdict(outcome.verdict()),
                })
            };
            let garbled = fault.shows.iter();
            let garbled = garbled.filter_map(|own| Some((own, own.claim.garbled.as_deref()?)));
            Some(Corrected {
                item: item(&fault, paper)?,
                shows: fault.shows.iter().filter_map(shown).collect(),
                verdict: glossary::verdict(lead.verdict()),
                garbled: (garbled.map(|(of, text)| spans(&visible(text), &printed_names(of))))
                    .next(),
                checked_by: checked_by(&fault, accepted),
                resting: fault.resting,
                falling: fault.falling,
            })
        })
        .collect()
}

/// What checked all false statements of a fault; none if they were not all checked in the same way.
fn checked_by(fault: &PlacedFault<'_>, accepted: &BTreeSet<String>) -> Option<&'static str> {
    let refuted = fault.shows.iter().filter(|claim| is_refuted(claim));
    let mut ways = refuted.map(|claim| {
        let level = glossary::level(claim, accepted.contains(&claim.claim.id));
        level.and_then(glossary::checked_by)
    });
    let first = ways.next()??;
    ways.all(|way| way == Some(first)).then_some(first)
}
