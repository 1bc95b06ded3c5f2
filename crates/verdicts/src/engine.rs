//! Running claims: from a loaded paper to outcomes.

use crate::condition::{self, nonzero};
use crate::finding;
use crate::outcome::{Outcome, PaperOutcome, ReadingOutcome, SaidBy};
use crate::repair::subject::Subject;
use crate::{conjunction, net, provenance, readings, repair, replay, table};
use rayon::prelude::*;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use torse_algebra::{Fraction, work};
use torse_language::core::Elaborator;
use torse_language::derivation::{Claim, DerivationError, Figure, Finding, Paper, Written};
use torse_language::notation::{self, Formula};
use torse_language::words::{Kind, Verdict};
use torse_prove::decide::{Decision, Refutation};
use torse_prove::evidence::Evidence;
use torse_prove::{decide_statement, formula};

/// The work that a claim may cost unless more is asked for: many times what the hardest claims of the papers take.
pub const STANDARD_WORK: u64 = 500_000_000;
/// Formulas with more terms than this are not shown.
const MAX_SHOWN_TERMS: usize = 120;

/// Decides all claims of a paper, in parallel; the outcomes are in the order of the file. `done` is
/// called once a claim, from any thread.
///
/// # Errors
/// The first claim, in file order, whose formulas do not make sense.
pub fn run(paper: &Paper, done: &(dyn Fn() + Sync)) -> Result<PaperOutcome, Box<DerivationError>> {
    let outcomes: Vec<Result<Outcome, Box<DerivationError>>> = paper
        .claims
        .par_iter()
        .map(|claim| {
            let outcome = decide_claim(&paper.head.id, claim);
            done();
            outcome
        })
        .collect();
    Ok(PaperOutcome {
        slug: paper.head.id.clone(),
        title: paper.head.title.clone(),
        authors: paper.head.authors.clone(),
        venue: paper.head.venue.clone(),
        claims: outcomes.into_iter().collect::<Result<_, _>>()?,
    })
}

/// Decides one claim. A claim that makes the engine panic is undecided, with the panic's message as the reason: it takes
/// no other claim with it.
///
/// # Errors
/// A [`DerivationError`] when a formula of the claim does not make sense.
pub fn decide_claim(paper: &str, claim: &Claim) -> Result<Outcome, Box<DerivationError>> {
    decide_claim_within(STANDARD_WORK, paper, claim)
}

/// The same with another budget of work, in the units of [`work`]: as much for the verdict, and as much again for the
/// search for a correction. A claim that needs more is undecided, and says so.
///
/// # Errors
/// A [`DerivationError`] when a formula of the claim does not make sense.
pub fn decide_claim_within(
    budget: u64,
    paper: &str,
    claim: &Claim,
) -> Result<Outcome, Box<DerivationError>> {
    let outcome = undecided(paper, claim);
    // What the closure could leave half done are values of its own and memory of formulas already evaluated.
    let decided = catch_unwind(AssertUnwindSafe(|| {
        let mut decided = decided(outcome.clone(), claim, budget)?;
        // What is not decided has no finding to tell.
        if decided.verdict != Verdict::Undecided {
            let told = work::within(budget / 20, || finding::told(claim, &decided));
            decided.finding = told.unwrap_or(Ok(None))?;
        }
        Ok(decided)
    }));
    decided.unwrap_or_else(|panic| Ok(panicked(outcome, &*panic)))
}

/// The outcome of a claim whose decision panicked.
fn panicked(mut outcome: Outcome, panic: &(dyn Any + Send)) -> Outcome {
    let text = panic.downcast_ref::<&str>().copied();
    let text = text.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
    let message = text.unwrap_or("no message");
    outcome.steps = vec![format!("the engine failed on this claim: {message}")];
    outcome
}

/// What the file says of a claim.
fn undecided(paper: &str, claim: &Claim) -> Outcome {
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
        table: table::of(claim),
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

fn decided(
    mut outcome: Outcome,
    claim: &Claim,
    budget: u64,
) -> Result<Outcome, Box<DerivationError>> {
    let entry = &claim.entry;
    check_finding(claim)?;
    if let Some(figure) = &claim.figure {
        outcome.steps.extend(entry.underspecified.clone());
        drawn(&mut outcome, figure);
        return Ok(outcome);
    }
    if let Some(missing) = &entry.underspecified {
        outcome.verdict = Verdict::Underspecified;
        outcome.steps.push(missing.clone());
        return Ok(outcome);
    }
    if let Some(reason) = &entry.out_of_scope {
        outcome.verdict = Verdict::OutOfScope;
        outcome.steps.push(reason.clone());
        return Ok(outcome);
    }
    if !claim.readings.is_empty() {
        return read(outcome, claim, budget);
    }
    let Some(statement) = &claim.statement else {
        if entry.kind == Kind::Figure {
            outcome
                .steps
                .push("all data are printed; deciding a figure means drawing it".to_owned());
            return Ok(outcome);
        }
        outcome.verdict = Verdict::Definition;
        return Ok(outcome);
    };
    match work::within(budget, || decide_statement(claim, statement)) {
        Ok(decision) => {
            let decision =
                decision.map_err(|fault| Box::new(fault.into_error(&statement.origin)))?;
            let weighed = provenance::weigh(claim, statement, decision, budget / 5);
            conclude(&mut outcome, weighed.decision, statement);
            provenance::record(&mut outcome, claim, &weighed.needed);
            rest_on(&mut outcome, provenance::conditions(claim, &weighed.needed));
            if outcome.verdict == Verdict::False {
                let parts = conjunction::part_by_part(claim, statement, budget / 50);
                outcome.steps.extend(parts);
                // A correction that is not found within the budget is none; the verdict stands.
                let _ = work::within(budget / 5, || correct(&mut outcome, claim, statement));
                correction_rests_on(&mut outcome, claim, budget / 5);
            }
        }
        Err(out) => outcome.steps = vec![out.to_string()],
    }
    net::cast(&mut outcome, claim, statement);
    net::replay(&mut outcome, claim, statement, budget / 5);
    Ok(outcome)
}

/// The formulas of a finding make sense where the claim is.
fn check_finding(claim: &Claim) -> Result<(), Box<DerivationError>> {
    let elaborator = Elaborator::new(&claim.declarations);
    for hole in claim.finding.iter().flat_map(Finding::holes) {
        let term = elaborator.term(&hole.expr);
        term.map_err(|fault| Box::new(fault.into_error(&hole.origin)))?;
    }
    Ok(())
}

/// Decides the readings of a sentence, each as a claim.
fn read(mut outcome: Outcome, claim: &Claim, budget: u64) -> Result<Outcome, Box<DerivationError>> {
    let mut found = vec![];
    for reading in &claim.readings {
        let (name, says) = (reading.name.clone(), reading.says.clone());
        let outcome = decide_claim_within(budget, &outcome.paper, &reading.claim)?;
        found.push(ReadingOutcome {
            name,
            says,
            outcome,
        });
    }
    readings::conclude(&mut outcome, found);
    Ok(outcome)
}

/// Hypotheses that are ours and that the proof needs are conditions.
fn rest_on(outcome: &mut Outcome, needed: Vec<Formula>) {
    if !needed.is_empty() {
        outcome.verdict = Verdict::Conditional;
        outcome.conditions.extend(needed);
    }
}

/// The same of a correction.
fn correction_rests_on(outcome: &mut Outcome, claim: &Claim, budget: u64) {
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

/// What had to be assumed or replaced makes the verdict of a figure.
fn drawn(outcome: &mut Outcome, figure: &Figure) {
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
fn conclude(outcome: &mut Outcome, decision: Decision, statement: &Written) {
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

/// Searches for what the paper meant. The outcome changes only when something is found.
fn correct(outcome: &mut Outcome, claim: &Claim, statement: &Written) {
    if repair::is_sought(outcome.kind) {
        outcome.correction = repair::search(claim, statement);
        if outcome.correction.is_some() {
            outcome.verdict = Verdict::Misprint;
            return;
        }
        // Derived anew is no slip of printing: the statement is false.
        outcome.correction = repair::ansatz::search(claim, statement);
        outcome.data = repair::entries::search(claim, statement);
    }
    if outcome.kind == Kind::Value && outcome.correction.is_none() && outcome.data.is_none() {
        outcome.data = repair::data::search(claim, statement);
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;
    use torse_language::derivation::{LoadError, Source, paper};

    #[test]
    fn a_claim_that_makes_the_engine_panic_is_undecided_with_the_reason() {
        let text = |name: &str| match name {
            "paper.toml" => {
                "[paper]\nid = 'p'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']\n"
            }
            _ => {
                "[[claim]]\nid = 'p/a'\nat = ''\nkind = 'identity'\nprinted = ''\nstates = '1 == 1'\n"
            }
        };
        let read = |name: &str| -> Result<Arc<Source>, LoadError> {
            let (name, text) = (name.to_owned(), text(name).to_owned());
            Ok(Arc::new(Source { name, text }))
        };
        let paper = paper(read).unwrap();
        let claim = &paper.claims[0];
        for panic in [
            Box::new("why") as Box<dyn Any + Send>,
            Box::new("why".to_owned()),
        ] {
            let outcome = panicked(undecided("p", claim), &*panic);
            assert_eq!(outcome.verdict, Verdict::Undecided);
            assert_eq!(outcome.steps, ["the engine failed on this claim: why"]);
        }
        assert_eq!(decide_claim("p", claim).unwrap().verdict, Verdict::Holds);
    }
}
