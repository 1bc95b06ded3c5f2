//! Findings besides the corrections, in plain words: a sentence for each claim that a reader must know of.

use crate::glossary::{self, Term};
use crate::names::printed_names;
use crate::sentence;
use crate::text::{beginning, name, visible};
use serde::Serialize;
use std::collections::BTreeMap;
use torse_syntax::taxonomy::Verdict;
use torse_typography::{PrintedNames, Prose, in_words, plain, spans};
use torse_verdicts::outcome::Outcome;

/// Maximum number of quoted characters of the print.
const MAX_QUOTATION_LENGTH: usize = 300;

/// The verdicts that a reader must know of, the gravest first.
const REPORTED_VERDICTS: [Verdict; 5] = [
    Verdict::False,
    Verdict::Misprint,
    Verdict::Conditional,
    Verdict::Vacuous,
    Verdict::Undecided,
];

/// One finding.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// The claim's id.
    pub id: String,
    /// The id without the paper's slug.
    pub name: String,
    /// The claim's identifier for links.
    pub anchor: String,
    /// The place in the paper.
    pub at: String,
    /// The verdict.
    pub verdict: Term,
    /// The statement as printed, or its beginning.
    pub printed: Prose,
    /// The finding, in words.
    pub text: Prose,
}

/// Returns the findings about `claims`, graver verdicts first and then in file order.
///
/// `anchors` holds the claims' identifiers for links, by position.
pub(crate) fn collect_findings(claims: &[Outcome], anchors: &[String]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for verdict in REPORTED_VERDICTS {
        for (claim, anchor) in claims.iter().zip(anchors) {
            if claim.verdict() == verdict {
                findings.push(about(claim, anchor));
            }
        }
    }
    findings
}

/// Returns the findings about `claims`, by id, as plain text: for outputs without formulas.
#[must_use]
pub fn findings_in_words(claims: &[Outcome]) -> BTreeMap<String, String> {
    let chosen = claims
        .iter()
        .filter(|claim| REPORTED_VERDICTS.contains(&claim.verdict()));
    let found = chosen.map(|outcome| {
        let sentence = in_full(outcome, &printed_names(outcome));
        (visible(&outcome.claim.id), in_words(&sentence))
    });
    found.collect()
}

fn in_full(outcome: &Outcome, names: &PrintedNames) -> Prose {
    spans(&visible(&sentence::short_sentence(outcome)), names)
}

/// Returns the finding about a claim.
pub(crate) fn about(outcome: &Outcome, anchor: &str) -> Finding {
    let names = printed_names(outcome);
    Finding {
        id: visible(&outcome.claim.id),
        name: visible(name(&outcome.claim.id)),
        anchor: anchor.to_owned(),
        at: visible(&plain(&outcome.claim.at)),
        verdict: glossary::verdict(outcome.verdict()),
        printed: spans(
            &visible(&beginning(&outcome.claim.printed, MAX_QUOTATION_LENGTH)),
            &names,
        ),
        text: in_full(outcome, &names),
    }
}
