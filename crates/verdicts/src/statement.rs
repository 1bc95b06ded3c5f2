//! Results for decided statements, each kind with its own data: plain data.

use crate::certificate::DecisionCertificate;
use crate::correction::{Correction, DataCorrection};
use serde::Serialize;
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_algebra::Polynomial;
use torse_certificate::Refuted;
use torse_certificate::point::{Comparison, Failure};
use torse_certificate::proof::Emptiness;
use torse_certificate::proof::assumptions::Sharpness;
use torse_prove::evidence::{Evidence, Witness};
use torse_prove::existential::FoundWitness;
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::{Kind, Verdict};

/// A figure that was drawn.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FigureFinding {
    /// `partial` if data had to be assumed or replaced.
    pub verdict: Verdict,
    /// Data that the paper does not print. These and the next two make the figure `partial`.
    pub missing: Vec<String>,
    /// Data of ours in place of what is not printed.
    pub replaced: Vec<String>,
    /// Data that had to be assumed.
    pub assumed: Vec<String>,
}

/// A statement that is not decided.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct UndecidedStatement {
    /// Why, in words: the reason first, then what was tried.
    pub reasons: Vec<String>,
    /// The instances that were tried, if any were.
    pub evidence: Option<Evidence>,
}

/// An answer of the prover that a cross-check contradicts.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Contradiction {
    /// The verdict of the prover.
    pub claimed: Verdict,
    /// The contradiction.
    pub found: String,
}

/// A statement with a proof.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ProvedStatement {
    /// The evidence of the proof.
    pub evidence: Evidence,
    /// The conditions under which it is true: divisors that must not vanish, then the needed hypotheses of ours.
    pub conditions: Vec<Formula>,
    /// For each hypothesis of the claim, in their order, whether the proof needs it; none for those that were not
    /// tried.
    pub needed: Vec<Option<bool>>,
    /// The proof, as data.
    #[serde(skip)]
    pub certificate: Arc<DecisionCertificate>,
    /// What is shown of the ranges of its parameters.
    #[serde(skip)]
    pub ranges: Vec<Sharpness<Polynomial>>,
    /// The numbers found for those that the claim says there are.
    pub witnesses: Vec<FoundWitness>,
}

/// A statement with a counterexample.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct RefutedStatement {
    /// The evidence of the refutation.
    pub evidence: Evidence,
    /// The counterexample.
    pub witness: Option<Witness>,
    /// Left side minus right side in normal form.
    pub difference: Option<Formula>,
    /// The derived right side in the paper's own shape.
    pub derived: Option<Formula>,
    /// The refutation, as data; none if a separate proof shows that no other number will do.
    #[serde(skip)]
    pub certificate: Option<Arc<DecisionCertificate>>,
    /// The correction.
    pub repair: Option<Repair>,
    /// A change of the data that explains a refuted value.
    pub data: Option<DataCorrection>,
    /// Whether the search for a small edit that repairs it ended before all were tried.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub search_ended_early: bool,
    /// Of a conjunction, what is found of each part.
    pub parts: Vec<PartFinding>,
    /// Of a claim that there is a number: that no number will do.
    pub no_number: Option<NoNumber>,
}

/// A proved correction of a refuted statement.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Repair {
    /// A slip of the print is corrected.
    Misprint(Correction),
    /// The statement is derived anew.
    Derived(Correction),
}

/// What is found of a part of a conjunction.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct PartFinding {
    /// The part.
    pub part: Formula,
    /// What is found.
    pub finding: PartVerdict,
}

/// What is found of a part of a conjunction, without its data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PartVerdict {
    /// It holds.
    Holds(Evidence),
    /// It holds under a condition.
    Conditional(Evidence),
    /// It fails.
    Fails,
    /// No point satisfies the hypotheses.
    Vacuous,
    /// It is not decided.
    Undecided,
}

/// A proof that no number will do at a point of the domain: the opposite of the statement holds there for all.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct NoNumber {
    /// The names of the numbers.
    pub names: Vec<String>,
    /// The point: names and exact values; empty if it is so everywhere.
    pub at: Vec<(String, String)>,
    /// The opposite of the statement.
    pub opposite: Formula,
}

/// A domain without points.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct EmptyDomain {
    /// Why it has none.
    #[serde(skip)]
    pub emptiness: Emptiness<Polynomial>,
    /// The numbers found for those that the claim says there are.
    pub witnesses: Vec<FoundWitness>,
}

impl UndecidedStatement {
    /// Makes a result that nothing was tried, for this reason.
    pub fn because(why: impl Into<String>) -> Self {
        Self {
            reasons: vec![why.into()],
            evidence: None,
        }
    }
}

impl ProvedStatement {
    /// Returns the verdict for a claim of this kind.
    #[must_use]
    pub fn verdict(&self, kind: Kind) -> Verdict {
        let rests_on_ours = self.needed.contains(&Some(true));
        match (kind, self.conditions.is_empty()) {
            (Kind::Definition, _) if !rests_on_ours => Verdict::Definition,
            (_, true) => Verdict::Holds,
            (_, false) => Verdict::Conditional,
        }
    }
}

impl RefutedStatement {
    /// Returns the verdict: `false`, or `misprint` if a slip explains it.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        match self.repair {
            Some(Repair::Misprint(_)) => Verdict::Misprint,
            Some(Repair::Derived(_)) | None => Verdict::False,
        }
    }

    /// Returns the part of a conjunction that fails; none if the statement has no parts.
    #[must_use]
    pub fn failing_part(&self) -> Option<&Formula> {
        let mut parts = self.parts.iter();
        let failing = parts.find(|part| part.finding == PartVerdict::Fails)?;
        Some(&failing.part)
    }

    /// Returns the values of the integers at which the statement fails, if it is refuted for an instance.
    #[must_use]
    pub fn instance(&self) -> Option<&BTreeMap<String, i64>> {
        match self.refutation()? {
            Refuted::Instance { integers, .. } => Some(integers),
            Refuted::At(_) | Refuted::Denied { .. } => None,
        }
    }

    /// Returns the numbers, from 1 on, of the entries of a vector or matrix in which the sides differ; none for a number.
    #[must_use]
    pub fn differing_entries(&self) -> Vec<usize> {
        match self.refutation().map(|own| &own.counterexample().failure) {
            Some(Failure::Sides {
                kind: Comparison::Equation { entry, .. },
                left,
                ..
            }) if left.len() > 1 => vec![entry + 1],
            Some(Failure::Printed(enclosure)) if enclosure.entries.len() > 1 => {
                enclosure.differing()
            }
            _ => vec![],
        }
    }

    fn refutation(&self) -> Option<&Refuted<Polynomial>> {
        match self.certificate.as_deref()? {
            DecisionCertificate::Refutation(refuted) => Some(refuted),
            DecisionCertificate::Proof { .. } => None,
        }
    }

    /// A proved correction.
    #[must_use]
    pub fn correction(&self) -> Option<&Correction> {
        match self.repair.as_ref()? {
            Repair::Misprint(correction) | Repair::Derived(correction) => Some(correction),
        }
    }
}
