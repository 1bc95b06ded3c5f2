//! The two stages of a claim: its verdict, and what a refuted one should have said.
//!
//! A reader waits for verdicts, and the search for corrections takes longer than many of them. So a run decides all
//! claims first and then searches corrections of the refuted ones. A claim is reported when it has passed both stages.

use crate::claim_record::ClaimRecord;
use crate::conclusion::{Conclusion, conclude, correct, drawn};
use crate::dependencies::{self, Dependencies};
use crate::elaborated_claim::ElaboratedClaim;
use crate::finding::Finding;
use crate::finding::Readings;
use crate::outcome::{Outcome, ReadingOutcome};
use crate::statement::{PartVerdict, RefutedStatement};
use crate::{audit, author_note, conjunction, existential, net, provenance};
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use torse_algebra::work;
use torse_core::stack;
use torse_elaborate::Elaborator;
use torse_prove::decide::Decision;
use torse_prove::with_prepared;
use torse_syntax::derivation::{AuthorNote, Claim, DerivationError, Written};
use torse_syntax::fault::Problem;
use torse_syntax::notation;
use torse_syntax::taxonomy::{Kind, Verdict};

/// A claim whose verdict is decided.
#[derive(Debug)]
pub struct PendingClaim<'c> {
    paper: String,
    claim: &'c Claim,
    budget: u64,
    table: Dependencies,
    remaining: Remaining<'c>,
}

/// The remaining work.
#[derive(Debug)]
enum Remaining<'c> {
    /// None.
    Nothing(Finding),
    /// The search for a correction of a refuted statement, and its cross-check; and the results for the parts of a
    /// conjunction.
    Correction(
        Box<ElaboratedClaim<'c>>,
        Box<RefutedStatement>,
        Vec<PartVerdict>,
    ),
    /// The remaining work for each reading of a sentence, by name and words.
    Readings(Vec<(String, String, PendingClaim<'c>)>),
}

impl<'c> PendingClaim<'c> {
    /// Decides a claim with this budget of work, in the units of [`work`]. If the engine panics, the claim is
    /// undecided, with the message of the panic as the reason; other claims are not affected.
    ///
    /// # Errors
    /// A [`DerivationError`] if a formula of the claim makes no sense.
    pub fn verdict(
        budget: u64,
        paper: &str,
        claim: &'c Claim,
    ) -> Result<Self, Box<DerivationError>> {
        stack::deep(|| {
            let elaborated = ElaboratedClaim::with_own_statement(claim);
            let table = elaborated
                .as_ref()
                .map(|elaborated| {
                    dependencies::find_dependencies(
                        &elaborated.claim,
                        elaborated.statement,
                        &elaborated.core,
                    )
                })
                .unwrap_or_default();
            // Unwind-safe: the closure mutates only its own values and idempotent caches.
            let decided = catch_unwind(AssertUnwindSafe(|| {
                decided(paper, claim, elaborated, budget)
            }));
            let remaining = match decided {
                Ok(decided) => decided?,
                Err(panic) => Remaining::Nothing(panicked(&*panic)),
            };
            Ok(Self {
                paper: paper.to_owned(),
                claim,
                budget,
                table,
                remaining,
            })
        })
    }

    /// Whether a correction is still to be searched for.
    #[must_use]
    pub fn seeks_correction(&self) -> bool {
        match &self.remaining {
            Remaining::Nothing(_) => false,
            Remaining::Correction(..) => true,
            Remaining::Readings(all) => all.iter().any(|(_, _, stage)| stage.seeks_correction()),
        }
    }

    /// Searches for a correction of a refuted claim, and makes the outcome.
    ///
    /// # Errors
    /// A [`DerivationError`] if a formula of the finding makes no sense.
    pub fn complete(self) -> Result<Outcome, Box<DerivationError>> {
        stack::deep(|| self.completed())
    }

    fn completed(self) -> Result<Outcome, Box<DerivationError>> {
        let (claim, budget, paper) = (self.claim, self.budget, &self.paper);
        let found = catch_unwind(AssertUnwindSafe(|| {
            let finding = self.remaining.finding(claim, budget)?;
            let note = author_note_of(claim, &finding, budget)?;
            Ok::<_, Box<DerivationError>>((finding, note))
        }));
        let (finding, note) = match found {
            Ok(found) => found?,
            Err(panic) => (panicked(&*panic), None),
        };
        Ok(Outcome {
            claim: record(paper, claim, self.table, finding.needed(), note),
            finding,
        })
    }
}

impl Remaining<'_> {
    /// Does the remaining work.
    fn finding(self, claim: &Claim, budget: u64) -> Result<Finding, Box<DerivationError>> {
        match self {
            Self::Nothing(finding) => Ok(finding),
            Self::Correction(elaborated, refuted, parts) => {
                let statement = elaborated.statement;
                let parts = conjunction::part_by_part(claim, statement, parts, budget / 50);
                let correcting = correct(claim, statement, budget / 5);
                let refuted = RefutedStatement {
                    repair: correcting.repair,
                    data: correcting.data,
                    search_ended_early: correcting.ended_early,
                    parts,
                    ..*refuted
                };
                Ok(net::refuted(refuted, &elaborated, budget / 5))
            }
            Self::Readings(all) => {
                let complete = |(name, says, stage): (String, String, PendingClaim<'_>)| -> Result<_, Box<DerivationError>> {
                    let outcome = stage.complete()?;
                    Ok(ReadingOutcome {
                        name,
                        says,
                        outcome,
                    })
                };
                let all: Result<Vec<_>, _> = all.into_iter().map(complete).collect();
                Ok(Finding::Readings(Readings::new(all?)))
            }
        }
    }
}

/// Returns the file's sentence about the finding, with its numbers; none for an undecided claim.
fn author_note_of(
    claim: &Claim,
    finding: &Finding,
    budget: u64,
) -> Result<Option<String>, Box<DerivationError>> {
    if finding.verdict(claim.entry.kind) == Verdict::Undecided {
        return Ok(None);
    }
    let witness = finding
        .refuted()
        .and_then(|refuted| refuted.witness.as_ref());
    work::within(budget / 20, || {
        author_note::finding_sentence(claim, witness)
    })
    .unwrap_or(Ok(None))
}

/// Returns the record of a claim: its file's content, and its dependencies.
fn record(
    paper: &str,
    claim: &Claim,
    table: Dependencies,
    needed: &[Option<bool>],
    author_note: Option<String>,
) -> ClaimRecord {
    let entry = &claim.entry;
    ClaimRecord {
        id: entry.id.get_ref().clone(),
        paper: paper.to_owned(),
        at: entry.at.clone(),
        kind: entry.kind,
        printed: entry.printed.clone(),
        part_of: claim.sentence_id().cloned(),
        reading: entry.reading.clone(),
        garbled: entry.garbled.as_ref().map(|text| text.get_ref().clone()),
        parsed: claim.statement.as_ref().map(|s| notation::formula(&s.expr)),
        compared: audit::compares(claim),
        assumed: provenance::assumed(claim, needed),
        table,
        author_note,
        note: entry.note.clone(),
        uses: claim.uses.clone(),
        expect: entry.expect,
    }
}

/// Returns the finding for a claim whose decision panicked.
fn panicked(panic: &(dyn Any + Send)) -> Finding {
    let text = panic.downcast_ref::<&str>().copied();
    let text = text.or_else(|| panic.downcast_ref::<String>().map(String::as_str));
    let message = text.unwrap_or("no message");
    Finding::undecided(format!("the engine failed on this claim: {message}"))
}

/// Returns the finding, cross-checked unless it is refuted, and the remaining work.
fn decided<'c>(
    paper: &str,
    claim: &'c Claim,
    elaborated: Option<ElaboratedClaim<'c>>,
    budget: u64,
) -> Result<Remaining<'c>, Box<DerivationError>> {
    check_author_note(claim)?;
    if let Some(finding) = undisputed(claim) {
        return Ok(Remaining::Nothing(finding));
    }
    if !claim.readings.is_empty() {
        return Ok(Remaining::Readings(read(paper, claim, budget)?));
    }
    let Some(statement) = &claim.statement else {
        return Ok(Remaining::Nothing(Finding::Definition));
    };
    if !claim.existentials.is_empty() {
        return existential::decided(claim, statement, budget).map(Remaining::Nothing);
    }
    stated(claim, statement, elaborated, budget)
}

/// Returns the finding of a claim that needs no decision.
fn undisputed(claim: &Claim) -> Option<Finding> {
    let entry = &claim.entry;
    if let Some(figure) = &claim.figure {
        return Some(Finding::Figure(drawn(claim, figure)));
    }
    if let Some(missing) = &entry.underspecified {
        return Some(Finding::Underspecified(missing.clone()));
    }
    if let Some(reason) = &entry.out_of_scope {
        return Some(Finding::OutOfScope(reason.clone()));
    }
    if let Some(reason) = &entry.unstated {
        return Some(Finding::Unstated(reason.clone()));
    }
    let is_bare = claim.statement.is_none() && claim.readings.is_empty();
    (is_bare && entry.kind == Kind::Figure)
        .then(|| Finding::undecided("all data are printed; deciding a figure means drawing it"))
}

/// Decides a statement.
fn stated<'c>(
    claim: &'c Claim,
    statement: &'c Written,
    elaborated: Option<ElaboratedClaim<'c>>,
    budget: u64,
) -> Result<Remaining<'c>, Box<DerivationError>> {
    let undecided = |why: String| Ok(Remaining::Nothing(Finding::undecided(why)));
    let mut parts = vec![];
    let decided = work::within(budget, || {
        let mut tell = |part: &Decision| parts.push(conjunction::verdict(part));
        with_prepared(claim, statement, |prepared| prepared.decide(&mut tell))
    });
    let decision = match decided {
        Ok(Ok(decision)) => decision,
        // The meaning of the formulas is not reached here: the author is not to blame.
        Ok(Err(fault)) if matches!(*fault.problem, Problem::Limit { .. }) => {
            return undecided(fault.problem.to_string());
        }
        Ok(Err(fault)) => return Err(Box::new(fault.into_error(&statement.origin))),
        Err(spent) => return undecided(spent.to_string()),
    };
    let Some(elaborated) = elaborated else {
        return undecided(
            "the statement was decided, but cannot be read back for the cross-check".into(),
        );
    };
    let minimized = provenance::minimize_hypotheses(claim, statement, decision, budget / 5);
    Ok(match conclude(claim, statement, minimized) {
        Conclusion::Proved(proved) => Remaining::Nothing(net::proved(proved, &elaborated)),
        Conclusion::Refuted(refuted) => Remaining::Correction(Box::new(elaborated), refuted, parts),
        Conclusion::Vacuous(empty) => Remaining::Nothing(net::vacuous(empty, &elaborated)),
        Conclusion::Undecided(open) => Remaining::Nothing(Finding::Undecided(open)),
    })
}

/// Decides the readings of a sentence, each as a claim.
fn read<'c>(
    paper: &str,
    claim: &'c Claim,
    budget: u64,
) -> Result<Vec<(String, String, PendingClaim<'c>)>, Box<DerivationError>> {
    let readings = claim.readings.iter();
    readings
        .map(|reading| {
            let stage = PendingClaim::verdict(budget, paper, &reading.claim)?;
            Ok((reading.name.clone(), reading.says.clone(), stage))
        })
        .collect()
}

/// The formulas of a sentence of the file make sense in the context of the claim.
fn check_author_note(claim: &Claim) -> Result<(), Box<DerivationError>> {
    let elaborator = Elaborator::new(&claim.declarations);
    for hole in claim.author_note.iter().flat_map(AuthorNote::holes) {
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

    /// Makes a paper whose claims state these.
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
            Ok(Arc::new(Source::new(name, text)))
        };
        paper(read).unwrap()
    }

    #[test]
    fn a_refuted_claim_has_its_verdict_before_its_correction() {
        let paper = stating(&["x + x == 2*x", "(x + 1)^2 == x^2 + 3*x + 1"]);
        let mut stages = paper
            .claims
            .iter()
            .map(|claim| PendingClaim::verdict(1_000_000, "p", claim).unwrap());
        let (right, slip) = (stages.next().unwrap(), stages.next().unwrap());
        assert!(!right.seeks_correction());
        assert_eq!(right.complete().unwrap().verdict(), Verdict::Holds);
        assert!(slip.seeks_correction());
        let found = slip.complete().unwrap();
        assert_eq!(found.verdict(), Verdict::Misprint);
        assert!(found.correction().is_some() && found.net().is_some());
    }

    #[test]
    fn a_claim_that_makes_the_engine_panic_is_undecided_with_the_reason() {
        let paper = stating(&["1 == 1"]);
        let claim = &paper.claims[0];
        for panic in [
            Box::new("why") as Box<dyn Any + Send>,
            Box::new("why".to_owned()),
        ] {
            let finding = panicked(&*panic);
            assert_eq!(finding.verdict(claim.entry.kind), Verdict::Undecided);
            let expected = Finding::undecided("the engine failed on this claim: why");
            assert_eq!(finding, expected);
        }
        let stage = PendingClaim::verdict(1_000_000, "p", claim).unwrap();
        assert_eq!(stage.complete().unwrap().verdict(), Verdict::Holds);
    }
}
