//! The two stages of a claim: its verdict, and what a refuted one should have said.
//!
//! Verdicts are what a reader waits for, and the search for corrections takes longer than many of them; so a run decides
//! all claims first and goes through the refuted ones after that. A claim is told in full when it is through both.

use crate::concluded::{
    conclude, correct, correction_rests_on, drawn, panicked, rest_on, undecided,
};
use crate::meant::Meant;
use crate::outcome::{Outcome, ReadingOutcome};
use crate::{conjunction, finding, net, provenance, readings, sought};
use std::panic::{AssertUnwindSafe, catch_unwind};
use torse_algebra::work;
use torse_core::stack;
use torse_elaborate::Elaborator;
use torse_prove::decide::Decision;
use torse_prove::with_prepared;
use torse_syntax::derivation::{Claim, DerivationError, Finding};
use torse_syntax::fault::Problem;
use torse_syntax::words::{Kind, Verdict};

/// A claim whose verdict is decided.
#[derive(Debug)]
pub struct Stage<'c> {
    paper: String,
    claim: &'c Claim,
    budget: u64,
    outcome: Outcome,
    left: Left<'c>,
}

/// What is left to do.
#[derive(Debug)]
enum Left<'c> {
    /// Nothing.
    Nothing,
    /// The search for a correction of what is refuted, and its net; and what is known of the parts of a conjunction.
    Correction(Box<Meant<'c>>, Vec<String>),
    /// What is left of each reading of a sentence, by name and words.
    Readings(Vec<(String, String, Stage<'c>)>),
}

impl<'c> Stage<'c> {
    /// Decides a claim with this budget of work, in the units of [`work`]. A claim that makes the engine panic is undecided,
    /// with the panic's message as the reason: it takes no other claim with it.
    ///
    /// # Errors
    /// A [`DerivationError`] when a formula of the claim does not make sense.
    pub fn verdict(
        budget: u64,
        paper: &str,
        claim: &'c Claim,
    ) -> Result<Self, Box<DerivationError>> {
        stack::deep(|| Self::decided(budget, paper, claim))
    }

    fn decided(budget: u64, paper: &str, claim: &'c Claim) -> Result<Self, Box<DerivationError>> {
        let meant = Meant::own(claim);
        let outcome = undecided(paper, claim, meant.as_ref());
        // What the closure could leave half done are values of its own and memory of formulas already evaluated.
        let found = catch_unwind(AssertUnwindSafe(|| {
            decided(outcome.clone(), claim, meant, budget)
        }));
        let (outcome, left) = match found {
            Ok(found) => found?,
            Err(panic) => (panicked(outcome, &*panic), Left::Nothing),
        };
        Ok(Self {
            paper: paper.to_owned(),
            claim,
            budget,
            outcome,
            left,
        })
    }

    /// Whether a correction is still to be sought.
    #[must_use]
    pub fn seeks_correction(&self) -> bool {
        match &self.left {
            Left::Nothing => false,
            Left::Correction(..) => true,
            Left::Readings(all) => all.iter().any(|(_, _, stage)| stage.seeks_correction()),
        }
    }

    /// Seeks a correction of what is refuted, and tells what was found.
    ///
    /// # Errors
    /// A [`DerivationError`] when a formula of the finding does not make sense.
    pub fn complete(self) -> Result<Outcome, Box<DerivationError>> {
        stack::deep(|| self.completed())
    }

    fn completed(self) -> Result<Outcome, Box<DerivationError>> {
        let (claim, budget, paper) = (self.claim, self.budget, self.paper);
        let told = catch_unwind(AssertUnwindSafe(|| {
            let mut outcome = self.outcome;
            match self.left {
                Left::Nothing => {}
                Left::Correction(meant, parts) => {
                    let statement = meant.statement;
                    let parts = conjunction::part_by_part(claim, statement, parts, budget / 50);
                    outcome.steps.extend(parts);
                    corrected(&mut outcome, claim, &meant, budget);
                }
                Left::Readings(all) => {
                    let mut found = vec![];
                    for (name, says, stage) in all {
                        let outcome = stage.complete()?;
                        found.push(ReadingOutcome {
                            name,
                            says,
                            outcome,
                        });
                    }
                    readings::conclude(&mut outcome, found);
                }
            }
            // What is not decided has no finding to tell.
            if outcome.verdict != Verdict::Undecided {
                let told = work::within(budget / 20, || finding::told(claim, &outcome));
                outcome.finding = told.unwrap_or(Ok(None))?;
            }
            Ok(outcome)
        }));
        told.unwrap_or_else(|panic| {
            let outcome = undecided(&paper, claim, Meant::own(claim).as_ref());
            Ok(panicked(outcome, &*panic))
        })
    }
}

/// Seeks what a refuted claim should have said, and nets both.
fn corrected(outcome: &mut Outcome, claim: &Claim, meant: &Meant<'_>, budget: u64) {
    // A correction that is not found within the budget is none; the verdict stands.
    let _ = work::within(budget / 5, || correct(outcome, claim, meant.statement));
    correction_rests_on(outcome, claim, budget / 5);
    net::secure(outcome, meant, budget / 5);
}

/// The verdict of a claim, netted unless it is refuted, and what is left to do.
fn decided<'c>(
    mut outcome: Outcome,
    claim: &'c Claim,
    meant: Option<Meant<'c>>,
    budget: u64,
) -> Result<(Outcome, Left<'c>), Box<DerivationError>> {
    let entry = &claim.entry;
    check_finding(claim)?;
    if let Some(figure) = &claim.figure {
        outcome.steps.extend(entry.underspecified.clone());
        drawn(&mut outcome, figure);
        return Ok((outcome, Left::Nothing));
    }
    if let Some(missing) = &entry.underspecified {
        outcome.verdict = Verdict::Underspecified;
        outcome.steps.push(missing.clone());
        return Ok((outcome, Left::Nothing));
    }
    if let Some(reason) = &entry.out_of_scope {
        outcome.verdict = Verdict::OutOfScope;
        outcome.steps.push(reason.clone());
        return Ok((outcome, Left::Nothing));
    }
    if !claim.readings.is_empty() {
        let readings = read(&outcome, claim, budget)?;
        return Ok((outcome, Left::Readings(readings)));
    }
    let Some(statement) = &claim.statement else {
        if entry.kind == Kind::Figure {
            outcome
                .steps
                .push("all data are printed; deciding a figure means drawing it".to_owned());
            return Ok((outcome, Left::Nothing));
        }
        outcome.verdict = Verdict::Definition;
        return Ok((outcome, Left::Nothing));
    };
    if !claim.sought.is_empty() {
        sought::decided(&mut outcome, claim, statement, budget)?;
        return Ok((outcome, Left::Nothing));
    }
    let mut parts = vec![];
    let decided = work::within(budget, || {
        let mut tell = |part: &Decision| parts.push(conjunction::word(part));
        with_prepared(claim, statement, |prepared| prepared.decide(&mut tell))
    });
    match decided {
        // What the formulas mean is not reached here: the author is not to blame.
        Ok(Err(fault)) if matches!(*fault.problem, Problem::Limit { .. }) => {
            outcome.steps = vec![fault.problem.to_string()];
        }
        Ok(decision) => {
            let decision =
                decision.map_err(|fault| Box::new(fault.into_error(&statement.origin)))?;
            let weighed = provenance::weigh(claim, statement, decision, budget / 5);
            conclude(&mut outcome, weighed.decision, statement);
            provenance::record(&mut outcome, claim, &weighed.needed);
            rest_on(&mut outcome, provenance::conditions(claim, &weighed.needed));
            if outcome.verdict == Verdict::False {
                let left = |meant| Left::Correction(Box::new(meant), parts);
                return Ok((outcome, meant.map_or(Left::Nothing, left)));
            }
        }
        Err(out) => outcome.steps = vec![out.to_string()],
    }
    if let Some(meant) = &meant {
        net::secure(&mut outcome, meant, budget / 5);
    }
    Ok((outcome, Left::Nothing))
}

/// Decides the readings of a sentence, each as a claim.
fn read<'c>(
    outcome: &Outcome,
    claim: &'c Claim,
    budget: u64,
) -> Result<Vec<(String, String, Stage<'c>)>, Box<DerivationError>> {
    let readings = claim.readings.iter();
    readings
        .map(|reading| {
            let stage = Stage::verdict(budget, &outcome.paper, &reading.claim)?;
            Ok((reading.name.clone(), reading.says.clone(), stage))
        })
        .collect()
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

#[cfg(test)]
mod tests {
    use super::*;
    use std::any::Any;
    use std::sync::Arc;
    use torse_syntax::derivation::{LoadError, Source, paper};

    /// A paper whose claims state these.
    fn stating(statements: &[&str]) -> torse_syntax::derivation::Paper {
        let claim = |(n, states): (usize, &&str)| {
            format!(
                "[[claim]]\nid = 'p/{n}'\nat = ''\nkind = 'identity'\nprinted = ''\nstates = '{states}'\n"
            )
        };
        let claims: String = statements.iter().enumerate().map(claim).collect();
        let head = "[paper]\nid = 'p'\ntitle = ''\nauthors = ''\nvenue = ''\nclaims = ['c.toml']\n\
                    [symbols]\nx = { in = \"(-inf, inf)\" }\n";
        let read = |name: &str| -> Result<Arc<Source>, LoadError> {
            let text = if name == "paper.toml" { head } else { &claims };
            let (name, text) = (name.to_owned(), text.to_owned());
            Ok(Arc::new(Source { name, text }))
        };
        paper(read).unwrap()
    }

    #[test]
    fn a_refuted_claim_has_its_verdict_before_its_correction() {
        let paper = stating(&["x + x == 2*x", "(x + 1)^2 == x^2 + 3*x + 1"]);
        let mut stages = paper
            .claims
            .iter()
            .map(|claim| Stage::verdict(1_000_000, "p", claim).unwrap());
        let (right, slip) = (stages.next().unwrap(), stages.next().unwrap());
        assert!(!right.seeks_correction());
        assert_eq!(right.complete().unwrap().verdict, Verdict::Holds);
        assert!(slip.seeks_correction());
        assert_eq!(slip.outcome.verdict, Verdict::False);
        let told = slip.complete().unwrap();
        assert_eq!(told.verdict, Verdict::Misprint);
        assert!(told.correction.is_some() && told.net.is_some());
    }

    #[test]
    fn a_claim_that_makes_the_engine_panic_is_undecided_with_the_reason() {
        let paper = stating(&["1 == 1"]);
        let claim = &paper.claims[0];
        for panic in [
            Box::new("why") as Box<dyn Any + Send>,
            Box::new("why".to_owned()),
        ] {
            let outcome = panicked(undecided("p", claim, None), &*panic);
            assert_eq!(outcome.verdict, Verdict::Undecided);
            assert_eq!(outcome.steps, ["the engine failed on this claim: why"]);
        }
        let stage = Stage::verdict(1_000_000, "p", claim).unwrap();
        assert_eq!(stage.complete().unwrap().verdict, Verdict::Holds);
    }
}
