//! What is said of a statement that was decided, each kind with what that kind has: plain data.

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
    /// What had to be assumed or replaced makes the verdict.
    pub verdict: Verdict,
    /// What had to be assumed or replaced, in words.
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

/// What the prover calls settled and one of its judges does not.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Contradiction {
    /// The verdict that would have been.
    pub claimed: Verdict,
    /// What was found instead.
    pub found: String,
}

/// A statement with a proof.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct ProvedStatement {
    /// What the proof is.
    pub evidence: Evidence,
    /// The conditions under which it is true: divisors that must not vanish, then the needed hypotheses of ours.
    pub conditions: Vec<Formula>,
    /// Of each hypothesis of the claim, in their order, whether the proof needs it; nothing of those that were not tried.
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
    /// What the refutation is.
    pub evidence: Evidence,
    /// The counterexample.
    pub witness: Option<Witness>,
    /// Left side minus right side in normal form.
    pub difference: Option<Formula>,
    /// The derived right side in the paper's own shape.
    pub derived: Option<Formula>,
    /// The refutation, as data; none where that no other number will do was shown aside.
    #[serde(skip)]
    pub certificate: Option<Arc<DecisionCertificate>>,
    /// What it should have statement.
    pub repair: Option<Repair>,
    /// A change of the data that explains a refuted value.
    pub data: Option<DataCorrection>,
    /// The steps of the refutation, in words.
    pub steps: Vec<String>,
}

/// What a refuted statement should have statement, proved.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Repair {
    /// A slip of the print is mended.
    Misprint(Correction),
    /// The statement is derived anew.
    Derived(Correction),
}

/// A domain without points.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct EmptyDomain {
    /// The steps by which that is seen, in words.
    pub steps: Vec<String>,
}

impl UndecidedStatement {
    /// Nothing was tried, for this reason.
    pub fn because(why: impl Into<String>) -> Self {
        Self {
            steps: vec![why.into()],
            evidence: None,
        }
    }
}

impl ProvedStatement {
    /// What is true of the statement of a claim of this kind.
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
    /// What is true of the statement: it is false, or a misprint if the slip is known.
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
