//! Results for decided statements, each kind with its own data: plain data.

use crate::certificate::DecisionCertificate;
use crate::correction::{Correction, DataCorrection};
use serde::Serialize;
use std::sync::Arc;
use torse_prove::evidence::{Evidence, Witness};
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::{Kind, Verdict};

/// A figure that was drawn.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct FigureFinding {
    /// `partial` if data had to be assumed or replaced.
    pub verdict: Verdict,
    /// Data that had to be assumed or replaced, in words; they make the figure `partial`.
    pub steps: Vec<String>,
}

/// A statement that is not decided.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct UndecidedStatement {
    /// Why, in words.
    pub steps: Vec<String>,
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
    /// The steps of the proof, in words.
    pub steps: Vec<String>,
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
    /// The steps of the refutation, in words.
    pub steps: Vec<String>,
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

/// A domain without points.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct EmptyDomain {
    /// The steps that show it, in words.
    pub steps: Vec<String>,
}

impl UndecidedStatement {
    /// Makes a result that nothing was tried, for this reason.
    pub fn because(why: impl Into<String>) -> Self {
        Self {
            steps: vec![why.into()],
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

    /// A proved correction.
    #[must_use]
    pub fn correction(&self) -> Option<&Correction> {
        match self.repair.as_ref()? {
            Repair::Misprint(correction) | Repair::Derived(correction) => Some(correction),
        }
    }
}
