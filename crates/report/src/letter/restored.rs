//! What is true of a paper with all corrections of a letter made.

use crate::glossary::plural;
use crate::statements::is_refuted;
use crate::text::{enumeration, visible};
use torse_syntax::taxonomy::Verdict;
use torse_typography::plain;
use torse_verdicts::outcome::{Outcome, PaperOutcome, Restoration, Restored};

/// What became of the claims with all corrections in force; none if nobody asked, or nothing is corrected.
pub(super) fn restored(paper: &PaperOutcome) -> Option<String> {
    let made = paper.restored.as_ref()?;
    let mut sentences = vec![];
    let (all, resting) = (made.corrected.len(), made.dependents.len());
    if all > 0 {
        let were = if all == 1 { "was" } else { "were" };
        sentences.push(format!(
            "With all corrections of this letter made, the {} that they concern {were} checked again: {}.",
            plural(all, "statement"),
            enumeration(&shares(paper, &made.corrected, "not corrected, and cannot stay as printed")),
        ));
    }
    if resting > 0 {
        let (rests, were) = match resting {
            1 => ("rests", "was"),
            _ => ("rest", "were"),
        };
        sentences.push(format!(
            "The {} that {rests} on these or on a corrected definition {were} checked with them: {}.",
            plural(resting, "other statement"),
            enumeration(&shares(paper, &made.dependents, "not true")),
        ));
    }
    let words = made.reworded.len();
    if words > 0 {
        let (are, them) = match words {
            1 => ("is", "it"),
            _ => ("are", "them"),
        };
        sentences.push(format!(
            "{} {are} of words alone; nothing is computed about {them} ({}).",
            plural(words, "change"),
            places(paper, made.reworded.iter().map(String::as_str)),
        ));
    }
    let is_restored = |outcome: &Outcome| concerns(made, &outcome.claim.id);
    let uncorrected = paper.claims.iter();
    let uncorrected: Vec<&str> = uncorrected
        .filter(|outcome| is_refuted(outcome) && !is_restored(outcome))
        .map(|outcome| outcome.claim.id.as_str())
        .collect();
    if !uncorrected.is_empty() {
        sentences.push(format!(
            "No correction is offered for {} ({}).",
            plural(uncorrected.len(), "false statement"),
            places(paper, uncorrected.into_iter()),
        ));
    }
    (!sentences.is_empty()).then(|| sentences.join(" "))
}

fn concerns(made: &Restoration, id: &str) -> bool {
    let mut decided = made.corrected.iter().chain(&made.dependents);
    decided.any(|own| own.claim == id) || made.reworded.iter().any(|own| own == id)
}

/// How many of the statements are true, and which are not; `refuted` says of a false one what that means.
fn shares(paper: &PaperOutcome, list: &[Restored], refuted: &str) -> Vec<String> {
    let of = |wanted: &[Verdict]| -> Vec<&Restored> {
        let list = list.iter();
        list.filter(|own| wanted.contains(&own.verdict)).collect()
    };
    let told = [
        (
            &[Verdict::Holds, Verdict::Definition, Verdict::Reproduced][..],
            ["is true", "are true"],
            false,
        ),
        (
            &[Verdict::Conditional],
            [
                "is true where what it divides by does not vanish",
                "are true where what they divide by does not vanish",
            ],
            false,
        ),
        (
            &[Verdict::Depends],
            [
                "still depends on the reading",
                "still depend on the reading",
            ],
            true,
        ),
        (
            &[Verdict::Undecided],
            ["is not decided", "are not decided"],
            true,
        ),
    ];
    let mut parts = vec![];
    let mut count = |listed: &[&Restored], [one, many]: [&str; 2], placed: bool| {
        let says = if listed.len() == 1 { one } else { many };
        let at = match placed {
            true => format!(
                " ({})",
                places(paper, listed.iter().map(|own| own.claim.as_str()))
            ),
            false => String::new(),
        };
        if !listed.is_empty() {
            parts.push(format!("{} {says}{at}", listed.len()));
        }
    };
    for (verdicts, says, placed) in told {
        count(&of(verdicts), says, placed);
    }
    let is_told = |of: &&Restored| {
        told.iter()
            .any(|(verdicts, ..)| verdicts.contains(&of.verdict))
    };
    let left: Vec<&Restored> = list.iter().filter(|own| !is_told(own)).collect();
    count(
        &left,
        [&format!("is {refuted}"), &format!("are {refuted}")],
        true,
    );
    parts
}

/// Where the paper has these claims, each place once.
fn places<'p>(paper: &'p PaperOutcome, ids: impl Iterator<Item = &'p str>) -> String {
    let find = |id: &str| paper.claims.iter().find(|outcome| outcome.claim.id == id);
    let mut places: Vec<String> = vec![];
    for outcome in ids.filter_map(find) {
        let place = visible(&plain(&outcome.claim.at));
        if !places.contains(&place) {
            places.push(place);
        }
    }
    places.join("; ")
}
