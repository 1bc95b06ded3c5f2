//! What a verdict rests on, as data.

use serde::Serialize;
use torse_algebra::Polynomial;
use torse_certificate::{Proof, Refuted};
use torse_prove::decide::Decision;
use torse_prove::decide::value::plain;

/// What a verdict rests on.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Grounds<P = Polynomial> {
    /// A proof.
    Proof {
        /// What must not vanish for it to say something, as factors of which none divides another.
        conditions: Vec<P>,
        /// The proof.
        of: Proof<P>,
    },
    /// A refutation.
    Refutation(Refuted<P>),
}

impl Grounds {
    /// Those of a decision that has some.
    #[must_use]
    pub fn of(decision: &Decision) -> Option<Self> {
        match decision {
            Decision::Proven(proof) => Some(Self::Proof {
                conditions: decision.conditions()?,
                of: proof.clone(),
            }),
            Decision::Refuted(refutation) => Some(Self::Refutation(refutation.refuted.clone())),
            Decision::Vacuous(_) | Decision::Open { .. } => None,
        }
    }

    /// The same in plain polynomials, as it is checked and written.
    #[must_use]
    pub fn plain(&self) -> Grounds<torse_certificate::Polynomial> {
        match self {
            Self::Proof { conditions, of } => Grounds::Proof {
                conditions: conditions.iter().map(plain).collect(),
                of: of.map(&plain),
            },
            Self::Refutation(refuted) => Grounds::Refutation(refuted.map(&plain)),
        }
    }
}
