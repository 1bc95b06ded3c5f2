//! What the engine says, against what is true.
//!
//! There are three judges: the construction of the claim, which knows whether it is true, the engine, and the semantics,
//! which is asked at points of its own. No two of them may contradict each other.

use super::Kind;
use super::claim::{Claim, States, Truth};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use torse_semantics::tree::Reading;
use torse_semantics::{SampleStatistics, judge_samples};
use torse_syntax::derivation::{self, LoadError, Paper, Source, paper};
use torse_syntax::formula::parse;
use torse_syntax::taxonomy::Verdict;
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
        Ok(Arc::new(Source::new(name, text)))
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

/// The points at which the semantics is asked, and its work.
const POINTS: u64 = 20;
const BUDGET: u64 = 200_000;

/// What the semantics finds of a claim: at points of another stream than those under the engine's verdicts.
///
/// # Errors
/// The message where the claim makes no sense.
pub fn semantics(claim: &Claim) -> Result<SampleStatistics, String> {
    // Numbers that the claim seeks are what the construction knows.
    let claim = &Claim {
        exists: claim.witnesses.clone(),
        ..claim.clone()
    };
    let paper = paper_of(&[claim]).map_err(|error| format!("{error:?}"))?;
    let written: &derivation::Claim = paper.claims.first().ok_or("no claim")?;
    let statement = written.statement.as_ref().ok_or("no statement")?;
    let core =
        torse_elaborate::elaborate(written, statement).map_err(|fault| format!("{fault:?}"))?;
    let seed = format!("second judge {}", claim.id());
    let names = core.symbols.keys().map(|name| &**name);
    let reading = Reading::new(written, &statement.expr, names);
    Ok(judge_samples(&reading, &[], &seed, POINTS, BUDGET))
}

/// What contradicts the construction of a claim, if anything.
#[must_use]
pub fn contradiction(claim: &Claim, points: &SampleStatistics) -> Option<String> {
    match (&claim.truth, &points.failing) {
        (Truth::Vacuous, _) if points.found > 0 => Some("its domain has points".to_owned()),
        (Truth::Holds | Truth::Conditional, Some(point)) => {
            Some(format!("the semantics finds it false at {point}"))
        }
        // Where a premise is false the witness needs no value.
        (Truth::Holds, None)
            if points.undefined > 0
                && (claim.witnesses.is_empty() || !claim.states.text().contains(" implies ")) =>
        {
            Some("the semantics finds it undefined somewhere".to_owned())
        }
        _ => None,
    }
}

/// Whether the semantics alone says what the construction says: false where it is false, true at all points else.
#[must_use]
pub fn seconded(claim: &Claim, points: &SampleStatistics) -> bool {
    match claim.truth {
        Truth::Fails(_) => points.failing.is_some(),
        Truth::Vacuous => points.found == 0,
        Truth::Holds | Truth::Conditional => points.enough,
    }
}

/// Compares an answer, and a correction where there is one, with the truth.
#[must_use]
pub fn judge(claim: &Claim, answer: &Result<Outcome, String>) -> Judgement {
    let outcome = match answer {
        Ok(outcome) => outcome,
        Err(message) => return Judgement::Wrong(format!("error: {message}")),
    };
    if let Some(found) = outcome.contradiction() {
        return Judgement::Wrong(format!("internal contradiction: {found}"));
    }
    let wrong = || {
        let witness = outcome.witness().map(|w| &w.at);
        let correction = outcome.correction().map(|c| &c.statement.text);
        let conditions: Vec<&str> = outcome
            .conditions()
            .iter()
            .map(|c| c.text.as_str())
            .collect();
        Judgement::Wrong(format!(
            "{:?}, witness {witness:?}, correction {correction:?}, conditions {conditions:?}",
            outcome.verdict()
        ))
    };
    if let Some(correction) = outcome.correction() {
        let (text, always) = (&correction.statement.text, correction.conditions.is_empty());
        let wanted = claim.wanted.as_ref().filter(|_| keeps_left(claim, text));
        if wanted.is_some_and(|wanted| wanted.agrees(text) == Some(false))
            || always && fails_somewhere(claim, text)
        {
            return wrong();
        }
    }
    match (&claim.truth, outcome.verdict()) {
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

/// Whether a corrected statement has the left side of the printed one: what the right side should be is known of that alone.
fn keeps_left(claim: &Claim, corrected: &str) -> bool {
    let left = |text: &str| {
        let whole = parse(text).ok()?;
        Some(whole.parts().first()?.placeless())
    };
    left(&claim.states.text()) == left(corrected)
}

/// Whether the semantics finds a point at which a corrected statement is false.
fn fails_somewhere(claim: &Claim, corrected: &str) -> bool {
    let corrected = Claim {
        states: States::Other(corrected.to_owned()),
        ..claim.clone()
    };
    semantics(&corrected).is_ok_and(|points| points.failing.is_some())
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
    /// Those that were not decided.
    pub undecided: Vec<String>,
    /// How many the semantics decides by itself as they were made.
    pub seconded: u64,
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
        seconded: 0,
    };
    for number in first..first + count {
        let claim = kind.claim(seed, number);
        let text = || format!("{}truth: {:?}\n", claim.file(), claim.truth);
        match semantics(&claim) {
            Err(message) => tally.wrong.push(format!("{}error: {message}\n", text())),
            Ok(points) => {
                if let Some(how) = contradiction(&claim, &points) {
                    tally.wrong.push(format!("{}{how}\n", text()));
                }
                tally.seconded += u64::from(seconded(&claim, &points));
            }
        }
        match judge(&claim, &outcome(&claim)) {
            Judgement::Right => (),
            Judgement::Open => {
                tally.open += 1;
                tally.undecided.push(text());
            }
            Judgement::Wrong(how) => tally.wrong.push(format!("{}answer: {how}\n", text())),
        }
    }
    tally
}
