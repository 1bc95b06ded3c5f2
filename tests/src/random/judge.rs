//! What the engine says, against what is true.

use super::Kind;
use super::claim::{Claim, Truth};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use torse_language::derivation::{LoadError, Paper, Source, paper};
use torse_language::words::Verdict;
use torse_verdicts::Outcome;
use torse_verdicts::engine::decide_claim;

/// How an answer compares with the truth.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Judgement {
    /// Right.
    Right,
    /// Not decided, or right with a condition too many.
    Open,
    /// Wrong, and how.
    Wrong(String),
}

/// A paper of these claims, one file each.
///
/// # Errors
/// [`LoadError`] where a claim makes no sense.
pub fn paper_of(claims: &[&Claim]) -> Result<Paper, LoadError> {
    let files: Vec<String> = (0..claims.len()).map(|n| format!("{n}.toml")).collect();
    let quoted: Vec<String> = files.iter().map(|file| format!("\"{file}\"")).collect();
    let head = format!(
        "[paper]\nid = \"random\"\ntitle = \"-\"\nauthors = \"-\"\nvenue = \"-\"\nclaims = [{}]\n",
        quoted.join(", ")
    );
    paper(|name| {
        let place = files.iter().position(|file| file == name);
        let text = place
            .and_then(|place| claims.get(place))
            .map_or_else(|| head.clone(), |claim| claim.file());
        Ok(Arc::new(Source {
            name: name.to_owned(),
            text,
        }))
    })
}

/// The engine's answers, in the order of the claims.
///
/// # Errors
/// The message where a claim makes no sense or the engine fails.
pub fn outcomes(claims: &[&Claim]) -> Result<Vec<Result<Outcome, String>>, String> {
    let paper = paper_of(claims).map_err(|error| format!("{error:?}"))?;
    let decide = |claim| {
        catch_unwind(AssertUnwindSafe(|| decide_claim("random", claim)))
            .map_err(|_| "panic".to_owned())?
            .map_err(|error| format!("{error:?}"))
    };
    Ok(paper.claims.iter().map(decide).collect())
}

/// The engine's answer to one claim.
///
/// # Errors
/// As [`outcomes`].
pub fn outcome(claim: &Claim) -> Result<Outcome, String> {
    outcomes(&[claim])?
        .pop()
        .unwrap_or_else(|| Err("no claim".to_owned()))
}

/// Compares an answer, and a correction where there is one, with the truth.
#[must_use]
pub fn judge(claim: &Claim, answer: &Result<Outcome, String>) -> Judgement {
    let outcome = match answer {
        Ok(outcome) => outcome,
        Err(message) => return Judgement::Wrong(format!("error: {message}")),
    };
    let wrong = || {
        let witness = outcome.witness.as_ref().map(|w| &w.at);
        let correction = outcome.correction.as_ref().map(|c| &c.statement.text);
        let conditions: Vec<&str> = outcome.conditions.iter().map(|c| c.text.as_str()).collect();
        Judgement::Wrong(format!(
            "{:?}, witness {witness:?}, correction {correction:?}, conditions {conditions:?}",
            outcome.verdict
        ))
    };
    if let (Some(wanted), Some(correction)) = (&claim.wanted, &outcome.correction)
        && wanted.agrees(&correction.statement.text) == Some(false)
    {
        return wrong();
    }
    match (&claim.truth, outcome.verdict) {
        (_, Verdict::Undecided)
        | (Truth::Holds, Verdict::Conditional)
        // True of no point: not seen.
        | (Truth::Vacuous, Verdict::Holds | Verdict::Conditional) => Judgement::Open,
        (Truth::Holds, Verdict::Holds)
        | (Truth::Conditional, Verdict::Conditional)
        | (Truth::Vacuous, Verdict::Vacuous)
        | (Truth::Fails(_), Verdict::False | Verdict::Misprint) => Judgement::Right,
        _ => wrong(),
    }
}

/// What a run of one kind came to.
#[derive(Debug, Clone)]
pub struct Tally {
    /// The kind.
    pub kind: Kind,
    /// How many claims.
    pub claims: u64,
    /// The wrong answers: the claim's file, the truth, the answer.
    pub wrong: Vec<String>,
    /// How many were not decided.
    pub open: u64,
    /// One of those that were not decided.
    pub undecided: Vec<String>,
}

/// Claims `first..first + count` of a kind.
#[must_use]
pub fn run(kind: Kind, seed: u64, first: u64, count: u64) -> Tally {
    let mut tally = Tally {
        kind,
        claims: count,
        wrong: vec![],
        open: 0,
        undecided: vec![],
    };
    for number in first..first + count {
        let claim = kind.claim(seed, number);
        match judge(&claim, &outcome(&claim)) {
            Judgement::Right => (),
            Judgement::Open => {
                tally.open += 1;
                tally
                    .undecided
                    .push(format!("{}truth: {:?}\n", claim.file(), claim.truth));
            }
            Judgement::Wrong(how) => tally.wrong.push(format!(
                "{}truth: {:?}\nanswer: {how}\n",
                claim.file(),
                claim.truth
            )),
        }
    }
    tally
}
