//! How a letter ends: what is true with all corrections made, and how all of it was checked.

use super::opening::is_example;
use crate::glossary::plural;
use crate::statements::is_refuted;
use crate::text::{enumeration, visible};
use std::collections::BTreeSet;
use torse_syntax::taxonomy::Verdict;
use torse_typography::plain;
use torse_verdicts::outcome::{Outcome, PaperOutcome, Restored};

pub(super) fn closing(
    paper: &PaperOutcome,
    corrections: usize,
    accepted: &BTreeSet<String>,
) -> Vec<String> {
    let mut list = vec![];
    list.extend(restored(paper));
    if corrections > 0 {
        let refuted: Vec<&Outcome> = paper
            .claims
            .iter()
            .filter(|claim| is_refuted(claim))
            .collect();
        let proved = refuted
            .iter()
            .filter(|outcome| accepted.contains(&outcome.claim.id))
            .count();
        let mut text =
            "The counterexamples were computed exactly; the decimals in them are rounded."
                .to_owned();
        if proved > 0 {
            text.push_str(&format!(
                " The proof assistant Rocq also accepted {}; they stand in the folder proofs of torse {}.",
                match proved == refuted.len() {
                    true => "proofs of all refutations".to_owned(),
                    false => format!(
                        "proofs of {proved} of the {}",
                        plural(refuted.len(), "refutation")
                    ),
                },
                env!("CARGO_PKG_VERSION"),
            ));
        }
        list.push(text);
    }
    list.push(match is_example(&paper.authors) {
        true => format!(
            "The command “torse report {}” writes a page with every statement, its verdict and its proof.",
            visible(&paper.slug)
        ),
        false => "A report with every statement of the paper, its verdict and its proof will be sent on request.".to_owned(),
    });
    list
}

/// What became of the claims with all corrections in force; none if nobody asked.
fn restored(paper: &PaperOutcome) -> Option<String> {
    let of = |wanted: Verdict| {
        let list = paper.restored.iter().filter(move |of| of.verdict == wanted);
        list.collect::<Vec<&Restored>>()
    };
    let (holds, limited) = (
        of(Verdict::Holds).len() + of(Verdict::Definition).len(),
        of(Verdict::Conditional).len(),
    );
    let all = paper.restored.len();
    if all == 0 {
        return None;
    }
    let mut text = format!(
        "With all corrections of this letter made, the {} that they concern {} decided again: ",
        plural(all, "statement"),
        if all == 1 { "was" } else { "were" }
    );
    let mut parts = vec![];
    if holds > 0 {
        parts.push(format!(
            "{holds} {} true",
            if holds == 1 { "is" } else { "are" }
        ));
    }
    if limited > 0 {
        let verb = if limited == 1 { "is" } else { "are" };
        parts.push(format!(
            "{limited} {verb} true where what they divide by does not vanish"
        ));
    }
    let ambiguous = of(Verdict::Depends);
    if !ambiguous.is_empty() {
        let verb = if ambiguous.len() == 1 {
            "depends"
        } else {
            "depend"
        };
        let (count, places) = (ambiguous.len(), places(paper, &ambiguous));
        parts.push(format!("{count} still {verb} on the reading ({places})"));
    }
    let settled = [
        Verdict::Holds,
        Verdict::Definition,
        Verdict::Conditional,
        Verdict::Depends,
    ];
    let left = paper.restored.iter();
    let left: Vec<&Restored> = left.filter(|of| !settled.contains(&of.verdict)).collect();
    if !left.is_empty() {
        let verb = if left.len() == 1 { "is" } else { "are" };
        let (count, places) = (left.len(), places(paper, &left));
        parts.push(format!(
            "{count} {verb} not corrected, and cannot stay as printed ({places})"
        ));
    }
    text.push_str(&enumeration(&parts));
    text.push('.');
    let is_restored = |outcome: &Outcome| {
        let mut restored = paper.restored.iter();
        restored.any(|of| of.claim == outcome.claim.id)
    };
    let uncorrected = paper.claims.iter();
    let uncorrected: Vec<String> = uncorrected
        .filter(|outcome| is_refuted(outcome) && !is_restored(outcome))
        .map(|outcome| visible(&plain(&outcome.claim.at)))
        .collect();
    if !uncorrected.is_empty() {
        text.push_str(&format!(
            " No correction is offered for {} ({}).",
            plural(uncorrected.len(), "false statement"),
            uncorrected.join("; ")
        ));
    }
    Some(text)
}

/// Where the paper has these claims, each place once.
fn places(paper: &PaperOutcome, of: &[&Restored]) -> String {
    let find = |of: &&Restored| {
        paper
            .claims
            .iter()
            .find(|outcome| outcome.claim.id == of.claim)
    };
    let mut places: Vec<String> = vec![];
    for outcome in of.iter().filter_map(find) {
        let place = visible(&plain(&outcome.claim.at));
        if !places.contains(&place) {
            places.push(place);
        }
    }
    places.join("; ")
}
