//! From the prover's decision to a statement that can be cross-checked: the decision as data, and the correction of a
//! refuted statement.

use crate::certificate::DecisionCertificate;
use crate::condition::{self, nonzero};
use crate::correction::{Correction, DataCorrection};
use crate::provenance::MinimizedProof;
use crate::repair::subject::Subject;
use crate::statement::{
    EmptyDomain, FigureFinding, ProvedStatement, RefutedStatement, Repair, UndecidedStatement,
};
use crate::{provenance, repair, words};
use std::sync::Arc;
use torse_algebra::{Fraction, work};
use torse_prove::decide::{Decision, Refutation};
use torse_prove::evidence::Evidence;
use torse_prove::{decide_statement, formula};
use torse_syntax::derivation::{Claim, Figure, Written};
use torse_syntax::notation::{self, Formula};
use torse_syntax::taxonomy::Kind;

/// Formulas with more terms than this are not shown.
const MAX_SHOWN_TERMS: usize = 120;

/// The prover's answer about a statement, before any check.
#[derive(Debug)]
pub(crate) enum Conclusion {
    Proved(ProvedStatement),
    Refuted(Box<RefutedStatement>),
    Vacuous(EmptyDomain),
    Undecided(UndecidedStatement),
}

/// Converts a decision on the statement of a claim; needed hypotheses of ours become conditions of a proof.
pub(crate) fn conclude(
    claim: &Claim,
    statement: &Written,
    minimized: MinimizedProof,
) -> Conclusion {
    let MinimizedProof { decision, needed } = minimized;
    let divisors = decision.conditions().unwrap_or_default();
    match decision {
        Decision::Proven(proof) => {
            let ours = provenance::conditions(claim, &needed);
            Conclusion::Proved(ProvedStatement {
                evidence: proof.evidence(),
                ranges: proof.ranges(),
                witnesses: vec![],
                conditions: divisors.iter().map(nonzero).chain(ours).collect(),
                needed: provenance::by_hypothesis(claim, &needed),
                certificate: Arc::new(DecisionCertificate::Proof {
                    conditions: divisors,
                    of: proof,
                }),
            })
        }
        Decision::Refuted(refutation) => {
            Conclusion::Refuted(Box::new(refuted(*refutation, statement)))
        }
        Decision::Vacuous(emptiness) => Conclusion::Vacuous(EmptyDomain {
            emptiness,
            witnesses: vec![],
        }),
        Decision::Open(unsettled) => Conclusion::Undecided(UndecidedStatement {
            evidence: unsettled.has_tried().then_some(Evidence::CheckedRange),
            reasons: words::unsettled(&unsettled),
        }),
    }
}

/// A refutation, with the sides of the first comparison that fails.
fn refuted(refutation: Refutation, statement: &Written) -> RefutedStatement {
    let witness = Some(refutation.witness());
    let sides = refutation.sides.as_ref();
    let differing =
        sides.and_then(|(left, right)| left.iter().zip(right).find(|(left, right)| left != right));
    let difference = differing.and_then(|(left, right)| readable(&(left.clone() - right.clone())));
    // The derived formula is the side we computed, not the printed one.
    let derived = differing.and_then(|(left, right)| {
        let is_left = Subject::is_left(&statement.expr);
        readable(if is_left { right } else { left })
    });
    RefutedStatement {
        evidence: refutation.refuted.evidence(),
        witness,
        difference,
        derived,
        certificate: Some(Arc::new(DecisionCertificate::Refutation(
            refutation.refuted,
        ))),
        repair: None,
        data: None,
        search_ended_early: false,
        parts: vec![],
        no_number: None,
    }
}

/// Returns the formula, unless it is too long to read.
fn readable(value: &Fraction) -> Option<Formula> {
    (value.numerator().len() <= MAX_SHOWN_TERMS)
        .then(|| notation::formula(&formula::expression(value)))
}

/// Decides the verdict of a figure: it depends on what had to be assumed or replaced.
pub(crate) fn drawn(claim: &Claim, figure: &Figure) -> FigureFinding {
    let entry = &figure.entry;
    FigureFinding {
        verdict: figure.verdict(),
        missing: claim.entry.underspecified.iter().cloned().collect(),
        replaced: entry.stand_in.clone(),
        assumed: entry.assumes.clone(),
    }
}

/// The correction, as far as it is found with this work.
#[derive(Debug, Default)]
pub(crate) struct Correcting {
    pub repair: Option<Repair>,
    pub data: Option<DataCorrection>,
    /// Whether the work was used up before all small edits were tried.
    pub ended_early: bool,
}

/// Searches for a correction. A search that ends at a limit found nothing; earlier results stand.
pub(crate) fn correct(claim: &Claim, statement: &Written, budget: u64) -> Correcting {
    let mut found = Correcting::default();
    let _ = work::within(budget, || search(claim, statement, &mut found));
    found.repair = found.repair.map(|repair| match repair {
        Repair::Misprint(own) => Repair::Misprint(under_ours(own, claim, budget)),
        Repair::Derived(own) => Repair::Derived(under_ours(own, claim, budget)),
    });
    found
}

/// The searches in turn.
///
/// # Errors
/// The limit that ended a search.
fn search(
    claim: &Claim,
    statement: &Written,
    correcting: &mut Correcting,
) -> Result<(), work::Spent> {
    // The result of a search that ran out of work is discarded.
    fn unless_spent<T>(result: T) -> Result<T, work::Spent> {
        work::check().map(|()| result)
    }
    let kind = claim.entry.kind;
    if repair::is_sought(kind) {
        correcting.ended_early = true;
        let search = unless_spent(repair::search(claim, statement))?;
        correcting.ended_early = search.ended_early;
        if let Some(slip) = search.correction {
            correcting.repair = Some(Repair::Misprint(slip));
            return Ok(());
        }
        // A side that is derived anew is not a slip of printing: the statement is false.
        let derived = unless_spent(repair::ansatz::search(claim, statement))?;
        correcting.repair = derived.map(Repair::Derived);
        correcting.data = unless_spent(repair::entries::search(claim, statement))?;
    }
    if kind == Kind::Value && correcting.repair.is_none() && correcting.data.is_none() {
        correcting.data = unless_spent(repair::data::search(claim, statement))?;
    }
    Ok(())
}

/// Adds the hypotheses of ours that its proof needs to a correction.
fn under_ours(correction: Correction, claim: &Claim, budget: u64) -> Correction {
    if !provenance::has_ours(claim) {
        return correction;
    }
    let id = claim.entry.id.get_ref();
    let Some(statement) = condition::written(&correction.statement, id) else {
        return correction;
    };
    let decided = work::within(budget, || decide_statement(claim, &statement));
    let Ok(Ok(decision)) = decided else {
        return correction;
    };
    let minimized = provenance::minimize_hypotheses(claim, &statement, decision, budget);
    let conditions = match minimized.decision.conditions() {
        Some(divisors) => divisors.iter().map(nonzero).collect(),
        None => correction.conditions,
    };
    let ours = provenance::conditions(claim, &minimized.needed);
    Correction {
        conditions: conditions.into_iter().chain(ours).collect(),
        ..correction
    }
}
