//! `torse verify --proofs DIR`: the proofs of verdicts, written for other programs.
//!
//! One file a paper, `DIR/PAPER.json`: an object whose `claims` are those with a proof or a refutation, in file order.
//! A claim has its `id`, the `reading` of the sentence that it is about (or null), what it `states`, the `verdict`,
//! whether the proof is `replayed`, and `rests_on`: `{"proof": {"conditions": [...], "of": ...}}` or
//! `{"refutation": ...}`, in the form that the crate `torse-certificate` documents.

use crate::exit::Failure;
use crate::format::pretty_json;
use serde::Serialize;
use std::path::Path;
use torse_certificate::Polynomial;
use torse_report::{ReportError, glossary, write_file};
use torse_verdicts::certificate::DecisionCertificate;
use torse_verdicts::outcome::{Outcome, PaperOutcome};

#[derive(Serialize)]
struct Paper<'a> {
    paper: &'a str,
    claims: Vec<Claim<'a>>,
}

#[derive(Serialize)]
struct Claim<'a> {
    id: &'a str,
    reading: Option<&'a str>,
    states: Option<&'a str>,
    verdict: &'static str,
    replayed: bool,
    rests_on: DecisionCertificate<Polynomial>,
}

/// Writes a file for each paper. All of them are made before the first is written, and each appears whole.
pub fn write(folder: &Path, papers: &[PaperOutcome]) -> Result<(), Failure> {
    let made = papers.iter().map(|paper| {
        let mut claims = vec![];
        for outcome in &paper.claims {
            claims.extend(claim(&outcome.claim.id, None, outcome));
            for reading in outcome.readings() {
                claims.extend(claim(
                    &outcome.claim.id,
                    Some(&reading.name),
                    &reading.outcome,
                ));
            }
        }
        let text = pretty_json(&Paper {
            paper: &paper.slug,
            claims,
        })?;
        Ok((folder.join(format!("{}.json", paper.slug)), text))
    });
    let made: Vec<_> = made.collect::<Result<_, ReportError>>()?;
    for (path, text) in made {
        write_file(&path, text.as_bytes())?;
    }
    Ok(())
}

fn claim<'a>(id: &'a str, reading: Option<&'a str>, outcome: &'a Outcome) -> Option<Claim<'a>> {
    let certificate = outcome.finding.certificate()?;
    Some(Claim {
        id,
        reading,
        states: outcome.parsed().map(|formula| formula.text.as_str()),
        verdict: glossary::verdict(outcome.verdict()).key,
        replayed: outcome.replay().is_some_and(|replay| replay.replayed),
        rests_on: certificate.plain(),
    })
}
