//! What a verdict rests on, as data.

use torse_algebra::Polynomial;
use torse_proof::{Proof, Refuted};
use torse_prove::decide::Decision;

/// What a verdict rests on, as data.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Grounds {
    /// A proof, and what must not vanish for it to say something.
    Proven(Proof<Polynomial>, Vec<Polynomial>),
    /// A refutation.
    Refuted(Refuted<Polynomial>),
}

impl Grounds {
    /// Those of a decision that has some.
    #[must_use]
    pub fn of(decision: &Decision) -> Option<Self> {
        match decision {
            Decision::Proven(proof) => {
                Some(Self::Proven(proof.clone(), decision.conditions()?))
            }
            Decision::Refuted(refutation) => Some(Self::Refuted(refutation.refuted.clone())),
            Decision::Vacuous(_) | Decision::Open { .. } => None,
        }
    }
}
