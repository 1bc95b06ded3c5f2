//! The other side of what a decision divides by.
//!
//! An equation `p x + r = 0` says what x is where p is not zero. So what is decided with the value of x is decided for those
//! points of the domain alone, and p is a condition of it. The points at which p is zero are decided apart, from the
//! hypotheses as they stand and `p == 0`: nothing of what they became under `p != 0` is known there.
//!
//! | where p is not zero | where it is | the statement |
//! |---|---|---|
//! | proved, or no point | proved, or no point | proved |
//! | proved | refuted | proved under the condition `p != 0`, with the point at which it is needed |
//! | proved | open | proved under the condition `p != 0` |
//! | open, or no point | refuted | refuted |
//! | refuted | | refuted |

use crate::context::{Besides, ProofContext, RootMode};
use crate::decide::value::Proof;
use crate::decide::{Decision, instances};
use crate::decider::{Decider, Instance};
use std::rc::Rc;
use torse_algebra::{Polynomial, work};
use torse_certificate::Refuted;
use torse_certificate::proof::{Split, ZeroSide};
use torse_core as core;
use torse_syntax::fault::Fault;

/// The most divisors of a decision whose other sides are looked at.
const MAX_SPLITS: usize = 4;
/// The work that one side may take.
const SIDE_WORK: u64 = 10_000_000;
/// The values of integers at which a side is looked at where it is open for all of them.
const FEW: usize = 3;

impl Decider<'_> {
    /// Looks at the other sides of what a decision divided by. A proof on one side is left out of the conditions, a refutation
    /// there refutes what is open, and where there are no points on this side the other sides are all there is.
    pub fn split(
        &self,
        statement: &core::Statement,
        instance: &Instance,
        mut decision: Decision,
        splits: Vec<Polynomial>,
    ) -> Decision {
        // Coefficients are those of what the solutions of the given equations make of a form: on the other side there are none.
        let terms = statement.terms().into_iter();
        let mut reading = terms.filter(|term| term.applies(core::BuiltIn::Coefficients));
        if !self.claim.unknowns.is_empty() && reading.next().is_some() {
            return decision;
        }
        let sides = match &decision {
            Decision::Proven(_) => decision.conditions().unwrap_or_default(),
            Decision::Open(_) => splits,
            Decision::Refuted(_) | Decision::Vacuous(_) => vec![],
        };
        let nowhere = matches!(&decision, Decision::Proven(proof) if is_nowhere(proof));
        let (mut emptiness, mut all_empty) = (None, nowhere);
        for pivot in sides.into_iter().take(MAX_SPLITS) {
            let zero = work::within(SIDE_WORK, || self.on_side(statement, instance, &pivot));
            let zero = match zero {
                Ok(Ok(Decision::Vacuous(why))) => {
                    emptiness = Some(why.clone());
                    Decision::Proven(Proof::Nowhere(why))
                }
                Ok(Ok(zero)) => zero,
                Ok(Err(_)) | Err(_) => continue,
            };
            match (&decision, zero) {
                (Decision::Proven(nonzero), Decision::Proven(zero))
                    if zero.conditions().is_empty() =>
                {
                    all_empty &= is_nowhere(&zero);
                    decision = parted(pivot, nonzero, ZeroSide::Proved(zero));
                }
                (Decision::Open(_), refuted @ Decision::Refuted(_)) => return refuted,
                (_, refuted @ Decision::Refuted(_)) if nowhere => return refuted,
                (Decision::Proven(nonzero), Decision::Refuted(refutation)) => {
                    decision = parted(pivot, nonzero, ZeroSide::Fails(refutation.refuted));
                }
                _ => {}
            }
        }
        match (nowhere, decision.conditions(), emptiness) {
            // No point on any side.
            (true, Some(conditions), Some(why)) if all_empty && conditions.is_empty() => {
                Decision::Vacuous(why)
            }
            (true, Some(conditions), _) if !conditions.is_empty() => Decision::open(
                "there are no points but where a divisor of an elimination vanishes",
                &[],
            ),
            _ => decision,
        }
    }

    /// The decision where a polynomial is zero; where it is open for all integers a refutation at small ones.
    fn on_side(
        &self,
        statement: &core::Statement,
        instance: &Instance,
        zero: &Polynomial,
    ) -> Result<Decision, Fault> {
        let found = self.at_zero(statement, instance, zero);
        let open = match &found {
            Ok(decision) => matches!(decision, Decision::Open(_)),
            Err(fault) => fault.is_limit(),
        };
        if !open || !instance.is_empty() {
            return found;
        }
        let (assignments, _) = self.instances();
        for integers in assignments
            .into_iter()
            .filter(|one| !one.is_empty())
            .take(FEW)
        {
            if let Ok(Decision::Refuted(mut refutation)) = self.at_zero(statement, &integers, zero)
            {
                refutation.refuted = Refuted::Instance {
                    integers,
                    refuted: Box::new(refutation.refuted),
                };
                return Ok(Decision::Refuted(refutation));
            }
        }
        found
    }

    fn at_zero(
        &self,
        statement: &core::Statement,
        instance: &Instance,
        zero: &Polynomial,
    ) -> Result<Decision, Fault> {
        let fixed = instances::fixed(instance);
        let elaborator = Rc::clone(&self.elaborator);
        let besides = Besides {
            zero: std::slice::from_ref(zero),
            nonzero: &self.nonzero,
        };
        let roots = RootMode::Symbols;
        let ground = ProofContext::on_side(&self.claim, elaborator, &fixed, roots, besides)?;
        self.on_ground(statement, instance, ground)
    }
}

/// A proof where a polynomial is not zero, with what is known where it is.
fn parted(pivot: Polynomial, nonzero: &Proof, zero: ZeroSide<Polynomial>) -> Decision {
    Decision::Proven(Proof::Split(Box::new(Split {
        pivot,
        nonzero: nonzero.clone(),
        zero,
    })))
}

/// Whether a proof says that there is no point, as far as it goes.
fn is_nowhere(proof: &Proof) -> bool {
    match proof {
        Proof::Nowhere(_) => true,
        Proof::On(ground) => is_nowhere(&ground.proof),
        _ => false,
    }
}
