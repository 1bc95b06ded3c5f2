//! How a letter ends: what is true with all corrections made, and how all of it was checked.

use super::restored::restored;
use crate::statements::is_refuted;
use crate::text::visible;
use std::collections::BTreeSet;
use torse_syntax::derivation::schema::is_worked;
use torse_verdicts::outcome::{Outcome, PaperOutcome};

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
                " {} false as printed; the proof assistant Rocq also accepted proofs of this for {}.",
                match refuted.len() {
                    1 => "One statement is".to_owned(),
                    n => format!("{n} statements, of which several may belong to one correction, are"),
                },
                match (proved == refuted.len(), proved) {
                    (true, 1) => "it".to_owned(),
                    (true, _) => "all of them".to_owned(),
                    (false, proved) => format!("{proved} of them"),
                },
            ));
        }
        list.push(text);
    }
    list.push(match is_worked(&paper.authors) {
        true => format!(
            "The command “torse report {}” writes a page with every statement, its verdict and its proof.",
            visible(&paper.slug)
        ),
        false => "A report with every statement of the paper, its verdict and its proof, also for Rocq, will be sent on request.".to_owned(),
    });
    list
}
