//! Sentences with more than one honest reading.
//!
//! Each reading is decided as a claim of its own. Where all have the same verdict it is that of the sentence; where they
//! differ it is `depends`, which accuses nobody.

use crate::outcome::{Net, Outcome, ReadingOutcome};
use torse_syntax::words::Verdict;

/// Writes into the outcome what its readings say together.
pub fn conclude(outcome: &mut Outcome, readings: Vec<ReadingOutcome>) {
    let lines = readings.iter().map(|reading| {
        let verdict = word(reading.outcome.verdict);
        format!("read as “{}” ({}): {verdict}", reading.name, reading.says)
    });
    outcome.steps = lines.collect();
    let verdicts = readings.iter().map(|reading| reading.outcome.verdict);
    let mut verdicts: Vec<Verdict> = verdicts.collect();
    verdicts.dedup();
    match (verdicts.as_slice(), readings.as_slice()) {
        ([verdict], [first, ..]) => {
            outcome.verdict = *verdict;
            agree(outcome, &first.outcome, &readings);
        }
        _ => outcome.verdict = Verdict::Depends,
    }
    let contradiction = readings
        .iter()
        .find_map(|reading| reading.outcome.contradiction.clone());
    if contradiction.is_some() {
        outcome.verdict = Verdict::Undecided;
        outcome.contradiction = contradiction;
    }
    outcome.readings = readings;
}

/// All readings have one verdict: it rests on the weakest evidence, under the conditions of all, and the witness and
/// correction shown are those of the first.
fn agree(outcome: &mut Outcome, first: &Outcome, readings: &[ReadingOutcome]) {
    let all = || readings.iter().map(|reading| &reading.outcome);
    outcome.evidence = all().map(|of| of.evidence).max().flatten();
    for condition in all().flat_map(|of| &of.conditions) {
        if !outcome.conditions.contains(condition) {
            outcome.conditions.push(condition.clone());
        }
    }
    outcome.parsed.clone_from(&first.parsed);
    outcome.witness.clone_from(&first.witness);
    outcome.difference.clone_from(&first.difference);
    outcome.derived.clone_from(&first.derived);
    outcome.correction.clone_from(&first.correction);
    let nets: Option<Vec<&Net>> = all().map(|of| of.net.as_ref()).collect();
    let nets = nets.unwrap_or_default();
    let weakest = nets.into_iter().min_by_key(|net| (net.netted, net.decided));
    outcome.net = weakest.cloned();
}

fn word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Holds => "it holds",
        Verdict::Conditional => "it holds under a condition",
        Verdict::Misprint => "it is a misprint",
        Verdict::False => "it is false",
        Verdict::Undecided => "it is undecided",
        Verdict::Vacuous => "no point satisfies its assumptions",
        Verdict::Definition => "it is a definition",
        Verdict::Depends
        | Verdict::Underspecified
        | Verdict::OutOfScope
        | Verdict::Reproduced
        | Verdict::Partial => "it is not decided",
    }
}
