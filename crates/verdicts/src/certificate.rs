//! What a verdict rests on, as data.

use crate::condition::nonzero;
use serde::Serialize;
use torse_algebra::Polynomial;
use torse_certificate::{Proof, Refuted};
use torse_prove::decide::value::plain;
use torse_prove::decide::{Decision, Refutation};
use torse_prove::evidence::Witness;
use torse_syntax::notation::Formula;

/// What a verdict rests on.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum DecisionCertificate<P = Polynomial> {
    /// A proof.
    Proof {
        /// Factors that must not vanish for the proof to say something; none divides another.
        conditions: Vec<P>,
        /// The proof.
        of: Proof<P>,
    },
    /// A refutation.
    Refutation(Refuted<P>),
}

impl DecisionCertificate {
    /// Takes the proof or refutation of a decision that has one.
    #[must_use]
    pub fn from_decision(decision: &Decision) -> Option<Self> {
        match decision {
            Decision::Proven(proof) => Some(Self::Proof {
                conditions: decision.conditions()?,
                of: proof.clone(),
            }),
            Decision::Refuted(refutation) => Some(Self::Refutation(refutation.refuted.clone())),
            Decision::Vacuous(_) | Decision::Open { .. } => None,
        }
    }

    /// Whether it proves the statement without a condition.
    #[must_use]
    pub fn is_unconditional_proof(&self) -> bool {
        matches!(self, Self::Proof { conditions, .. } if conditions.is_empty())
    }

    /// The points at which the statement fails because a condition does, each with the condition.
    #[must_use]
    pub fn excepted(&self) -> Vec<(Formula, Witness)> {
        let Self::Proof { of, .. } = self else {
            return vec![];
        };
        let excepted = of.excepted().into_iter();
        let point = |(condition, refuted): (&Polynomial, &Refuted<Polynomial>)| {
            let refutation = Refutation {
                refuted: refuted.clone(),
                sides: None,
            };
            (nonzero(condition), refutation.witness())
        };
        excepted.map(point).collect()
    }

    /// The points at which the parts p of `fails(p)` are false.
    #[must_use]
    pub fn denials(&self) -> Vec<Witness> {
        fn collect(proof: &Proof<Polynomial>, found: &mut Vec<Witness>) {
            if let Proof::Exists(refuted) = proof {
                let refutation = Refutation {
                    refuted: Refuted::clone(refuted),
                    sides: None,
                };
                found.push(refutation.witness());
            }
            for part in proof.parts() {
                collect(part, found);
            }
        }
        let mut found = vec![];
        if let Self::Proof { of, .. } = self {
            collect(of, &mut found);
        }
        found
    }

    /// The same in plain polynomials, as it is checked and written.
    #[must_use]
    pub fn plain(&self) -> DecisionCertificate<torse_certificate::Polynomial> {
        match self {
            Self::Proof { conditions, of } => DecisionCertificate::Proof {
                conditions: conditions.iter().map(plain).collect(),
                of: of.map(&plain),
            },
            Self::Refutation(refuted) => DecisionCertificate::Refutation(refuted.map(&plain)),
        }
    }
}
