//! Findings besides the corrections, in plain words: a sentence for each claim that a reader must know of.

use crate::glossary::{self, Term};
use crate::names::printed_names;
use crate::sentence;
use crate::text::{beginning, name, visible};
use serde::Serialize;
use std::collections::BTreeMap;
use torse_syntax::taxonomy::{Kind, Verdict};
use torse_typography::{PrintedNames, Prose, in_words, plain, spans};
use torse_verdicts::outcome::{Outcome, PaperFault, PaperOutcome};

/// Maximum number of quoted characters of the print.
const MAX_QUOTATION_LENGTH: usize = 300;

/// The verdicts that a reader must know of, the gravest first.
const REPORTED_VERDICTS: [Verdict; 6] = [
    Verdict::False,
    Verdict::Misprint,
    Verdict::Conditional,
    Verdict::Depends,
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

/// Returns the findings about the statements of a paper, graver verdicts first and then in file order; remarks are not the
/// paper's.
///
/// `anchors` holds the claims' identifiers for links, by position.
pub(crate) fn collect_findings(paper: &PaperOutcome, anchors: &[String]) -> Vec<Finding> {
    let mut findings = Vec::new();
    for verdict in REPORTED_VERDICTS {
        for (claim, anchor) in paper.claims.iter().zip(anchors) {
            if claim.verdict() == verdict && claim.claim.kind != Kind::Remark {
                findings.push(about(claim, anchor, &paper.faults));
            }
        }
    }
    findings
}

/// Returns the findings about the claims of a paper, by id, as plain text: for outputs without formulas.
#[must_use]
pub fn findings_in_words(paper: &PaperOutcome) -> BTreeMap<String, String> {
    let found = paper.claims.iter().filter_map(|outcome| {
        let words = finding_in_words(outcome, &paper.faults)?;
        Some((visible(&outcome.claim.id), words))
    });
    found.collect()
}

/// Returns the finding about a claim as plain text; `faults` are those of its paper. None if there is nothing to know of it.
#[must_use]
pub fn finding_in_words(outcome: &Outcome, faults: &[PaperFault]) -> Option<String> {
    let is_reported = REPORTED_VERDICTS.contains(&outcome.verdict());
    is_reported.then(|| in_words(&in_full(outcome, faults, &printed_names(outcome))))
}

fn in_full(outcome: &Outcome, faults: &[PaperFault], names: &PrintedNames) -> Prose {
    spans(&visible(&sentence::short_sentence(outcome, faults)), names)
}

/// Returns the finding about a claim.
pub(crate) fn about(outcome: &Outcome, anchor: &str, faults: &[PaperFault]) -> Finding {
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
        text: in_full(outcome, faults, &names),
    }
}
