//! What is written into the outcome of a claim: what its file says, a decision, a correction.

use crate::condition::{self, nonzero};
use crate::meant::Meant;
use crate::outcome::{Outcome, SaidBy};
use crate::repair::subject::Subject;
use crate::{provenance, repair, replay, table};
use std::any::Any;
use torse_algebra::{Fraction, work};
use torse_prove::decide::{Decision, Refutation};
use torse_prove::evidence::Evidence;
use torse_prove::{decide_statement, formula};
use torse_syntax::derivation::{Claim, Figure, Written};
use torse_syntax::notation::{self, Formula};
use torse_syntax::words::{Kind, Verdict};

/// Formulas with more terms than this are not shown.
const MAX_SHOWN_TERMS: usize = 120;

/// What the file says of a claim, and what its statement rests on, if it states something that makes sense.
pub(crate) fn undecided(paper: &str, claim: &Claim, meant: Option<&Meant<'_>>) -> Outcome {
    let entry = &claim.entry;
    Outcome {
        id: entry.id.get_ref().clone(),
        paper: paper.to_owned(),
        at: entry.at.clone(),
        kind: entry.kind,
        verdict: Verdict::Undecided,
        evidence: None,
        printed: entry.printed.clone(),
        part_of: claim.whole().cloned(),
        reading: entry.reading.clone(),
        garbled: entry.garbled.as_ref().map(|text| text.get_ref().clone()),
        parsed: claim.statement.as_ref().map(|s| notation::formula(&s.expr)),
        assumed: provenance::assumed(claim),
        table: meant
            .map(|meant| table::of(&meant.claim, meant.statement, &meant.core))
            .unwrap_or_default(),
        readings: vec![],
        correction: None,
        data: None,
        derived: None,
        difference: None,
        conditions: vec![],
        witness: None,
        net: None,
        replay: None,
        grounds: None,
        contradiction: None,
        steps: vec![],
        finding: None,
        note: entry.note.clone(),
        uses: claim.uses.clone(),
        expect: entry.expect,
    }
}

/// The outcome of a claim whose decision panicked.
pub(crate) fn panicked(mut outcome: Outcome, panic: &(dyn Any + Send)) -> Outcome {
    let text = panic.downcast_ref::<&str>().copied();
    let text = text.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
    let message = text.unwrap_or("no message");
    outcome.steps = vec![format!("the engine failed on this claim: {message}")];
    outcome
}

/// What had to be assumed or replaced makes the verdict of a figure.
pub(crate) fn drawn(outcome: &mut Outcome, figure: &Figure) {
    outcome.verdict = figure.verdict();
    let entry = &figure.entry;
    let listed = |what: &str, list: &[String]| -> Vec<String> {
        list.iter().map(|item| format!("{what}: {item}")).collect()
    };
    let replaced = listed("our own in place of what is not printed", &entry.stand_in);
    outcome.steps.extend(replaced);
    outcome.steps.extend(listed("assumed", &entry.assumes));
}

/// Writes a decision into the outcome.
pub(crate) fn conclude(outcome: &mut Outcome, decision: Decision, statement: &Written) {
    outcome.steps = decision.steps();
    let conditions = decision.conditions().unwrap_or_default();
    replay::keep(outcome, &decision);
    match decision {
        Decision::Proven(proof) => {
            outcome.evidence = Some(proof.evidence());
            outcome.conditions = conditions.iter().map(nonzero).collect();
            outcome.verdict = if outcome.conditions.is_empty() {
                Verdict::Holds
            } else {
                Verdict::Conditional
            };
            if outcome.kind == Kind::Definition {
                outcome.verdict = Verdict::Definition;
            }
        }
        Decision::Refuted(refutation) => {
            outcome.verdict = Verdict::False;
            outcome.evidence = Some(refutation.refuted.evidence());
            refute(outcome, *refutation, statement);
        }
        Decision::Vacuous(_) => outcome.verdict = Verdict::Vacuous,
        Decision::Open { tried, .. } => {
            outcome.verdict = Verdict::Undecided;
            outcome.evidence = (!tried.is_empty()).then_some(Evidence::CheckedRange);
        }
    }
}

/// Writes a refutation into the outcome.
fn refute(outcome: &mut Outcome, refutation: Refutation, statement: &Written) {
    outcome.witness = Some(refutation.witness());
    if let Some((left, right)) = refutation.sides {
        let differing = left.iter().zip(&right).find(|(x, y)| x != y);
        if let Some((x, y)) = differing {
            outcome.difference = readable(&(x.clone() - y.clone()));
            // Derived is the side that is not the print.
            let left = Subject::is_left(&statement.expr);
            outcome.derived = readable(if left { y } else { x });
        }
    }
}

/// The formula, unless it is too long for anyone to read.
fn readable(value: &Fraction) -> Option<Formula> {
    (value.numerator().len() <= MAX_SHOWN_TERMS)
        .then(|| notation::formula(&formula::expression(value)))
}

/// Hypotheses that are ours and that the proof needs are conditions.
pub(crate) fn rest_on(outcome: &mut Outcome, needed: Vec<Formula>) {
    if !needed.is_empty() {
        outcome.verdict = Verdict::Conditional;
        outcome.conditions.extend(needed);
    }
}

/// Searches for what the paper meant. The outcome changes only when something is found.
///
/// # Errors
/// The limit that ended a search; what was found before stands.
pub(crate) fn correct(
    outcome: &mut Outcome,
    claim: &Claim,
    statement: &Written,
) -> Result<(), work::Spent> {
    // What a search that is over came to is nothing.
    fn found<T>(found: T) -> Result<T, work::Spent> {
        work::check().map(|()| found)
    }
    if repair::is_sought(outcome.kind) {
        outcome.correction = found(repair::search(claim, statement))?;
        if outcome.correction.is_some() {
            outcome.verdict = Verdict::Misprint;
            return Ok(());
        }
        // Derived anew is no slip of printing: the statement is false.
        outcome.correction = found(repair::ansatz::search(claim, statement))?;
        outcome.data = found(repair::entries::search(claim, statement))?;
    }
    if outcome.kind == Kind::Value && outcome.correction.is_none() && outcome.data.is_none() {
        outcome.data = found(repair::data::search(claim, statement))?;
    }
    Ok(())
}

/// The same of a correction.
pub(crate) fn correction_rests_on(outcome: &mut Outcome, claim: &Claim, budget: u64) {
    if !outcome
        .assumed
        .iter()
        .any(|h| matches!(h.from, SaidBy::Ours { .. }))
    {
        return;
    }
    let Some(correction) = &mut outcome.correction else {
        return;
    };
    let Some(statement) = condition::written(&correction.statement, &outcome.id) else {
        return;
    };
    let decided = work::within(budget, || decide_statement(claim, &statement));
    if let Ok(Ok(decision)) = decided {
        let weighed = provenance::weigh(claim, &statement, decision, budget);
        if let Some(conditions) = weighed.decision.conditions() {
            correction.conditions = conditions.iter().map(nonzero).collect();
        }
        let needed = provenance::conditions(claim, &weighed.needed);
        correction.conditions.extend(needed);
    }
}
