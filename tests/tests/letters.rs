//! What readers of letters, reports and findings meet: the paper's language, and no sentence of the engine.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "helpers of tests")]

use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use torse_report::model::Report;
use torse_report::{Envelope, erratum_latex, erratum_markdown, findings_in_words};
use torse_syntax::derivation::{Paper, load};
use torse_syntax::words::Verdict;
use torse_verdicts::PaperOutcome;
use torse_verdicts::engine::{STANDARD_WORK, run};
use torse_verdicts::restore::restore;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

static LOADED: LazyLock<Vec<Paper>> =
    LazyLock::new(|| load(&root().join("derivations")).expect("the derivations load"));

static PAPERS: LazyLock<Vec<PaperOutcome>> = LazyLock::new(|| {
    let decided = LOADED.iter().map(|paper| run(paper, &|| ()));
    let decided = decided.map(|paper| paper.expect("every formula makes sense"));
    decided.collect()
});

/// What no reader is to meet: names and sentences of the engine, and slips of grammar.
const PATTERNS: [&str; 16] = [
    "printed_",
    "printed(z",
    "{printed}",
    "what it denies",
    "cannot be widened",
    "says nothing against",
    "0 is 0",
    "1/2*sqrt",
    "entry 1, ",
    "1 decimals",
    " 1 terms",
    " 1 statements",
    " 1 conditions",
    "1 of 8 need ",
    "1 places",
    "no correction is proved",
];

/// What a text has of that, with what stands around it.
fn found(text: &str, whose: &str) -> Vec<String> {
    let mut list = vec![];
    for pattern in PATTERNS {
        for (at, _) in text.match_indices(pattern) {
            let from = text.floor_char_boundary(at.saturating_sub(60));
            let to = text.ceil_char_boundary((at + 60).min(text.len()));
            list.push(format!("{whose}: {pattern:?} in {:?}", &text[from..to]));
        }
    }
    list
}

#[test]
fn no_letter_and_no_finding_has_a_sentence_of_the_engine() {
    let mut all = vec![];
    for paper in PAPERS.iter() {
        let report = Report::new(paper, &[]);
        let letter = erratum_markdown(&report, &Envelope::default());
        all.extend(found(&letter, &format!("{}-erratum.md", paper.slug)));
        let tex = erratum_latex(&report, &Envelope::default());
        assert!(tex.contains("\\begin{document}"));
        for (id, text) in findings_in_words(&paper.claims) {
            all.extend(found(&text, &id));
        }
    }
    assert!(all.is_empty(), "{}", all.join("\n"));
}

#[test]
fn every_fault_shows_in_claims_that_do_not_hold_and_no_refuted_claim_of_the_papers_is_left_to_itself()
 {
    for paper in PAPERS.iter() {
        let find = |id: &String| paper.claims.iter().find(|claim| claim.id == *id).unwrap();
        for fault in &paper.faults {
            for id in &fault.shows {
                let verdict = find(id).verdict;
                let faulty = [
                    Verdict::False,
                    Verdict::Misprint,
                    Verdict::Conditional,
                    Verdict::Depends,
                ];
                assert!(
                    faulty.contains(&verdict),
                    "{}: {id} is {verdict:?}",
                    fault.id
                );
            }
        }
        if paper.faults.is_empty() {
            continue;
        }
        let refuted = paper.claims.iter().filter(|claim| {
            matches!(claim.verdict, Verdict::False | Verdict::Misprint)
                && claim.kind != torse_syntax::words::Kind::Remark
        });
        let untold: Vec<&str> = refuted
            .filter(|claim| {
                !paper
                    .faults
                    .iter()
                    .any(|fault| fault.shows.contains(&claim.id))
            })
            .map(|claim| claim.id.as_str())
            .collect();
        assert!(untold.is_empty(), "{untold:?}");
    }
}

#[test]
fn with_all_corrections_in_force_every_claim_that_has_one_is_true() {
    for (paper, outcome) in LOADED.iter().zip(PAPERS.iter()) {
        let restored = restore(STANDARD_WORK, paper, outcome).expect("every formula makes sense");
        for claim in restored {
            let fault = outcome
                .faults
                .iter()
                .find(|fault| fault.shows.contains(&claim.claim));
            // Of some faults the authors alone know what was meant.
            if fault.is_some_and(|fault| fault.changes.is_empty()) {
                continue;
            }
            let repaired = [Verdict::Holds, Verdict::Conditional, Verdict::Definition];
            assert!(
                repaired.contains(&claim.verdict),
                "{}: {:?}",
                claim.claim,
                claim.verdict
            );
        }
    }
}
