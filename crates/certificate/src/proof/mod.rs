//! Proofs of statements, as trees that follow the structure of the statement.

pub mod assumptions;
pub mod refutation;

use crate::enclosure::Enclosure;
use crate::evidence::Evidence;
use crate::family::{Nonnegative, Powers};
use crate::identity::{Combination, Identity};
use crate::order::{Excluded, Order};
use crate::ratio::Constraint;
use crate::sign::Sign;
use crate::wronskian::Wronskians;
use crate::zero_by_sign::ZeroBySign;
use assumptions::{Assumptions, Sharpness};
use refutation::Refuted;
use serde::Serialize;
use std::collections::BTreeMap;

/// A proof that a statement is true on the whole domain wherever its conditions do not vanish.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Proof<P> {
    /// An equation: the difference vanishes.
    Identity(Identity<P>),
    /// An equation: the difference is a combination of equations.
    Combination(Combination<P>),
    /// An equation: the signs of polynomials imply that the difference is zero.
    ZeroBySign(ZeroBySign<P>),
    /// A relation of order, by signs.
    Order(Box<Order<P>>),
    /// `!=`: the hypotheses exclude equality.
    Excluded(Excluded<P>),
    /// Printed decimals agree.
    Enclosure(Enclosure<P>),
    /// A basis is nonnegative.
    Nonnegative(Nonnegative<P>),
    /// A basis diminishes variation.
    Powers(Powers<P>),
    /// A basis diminishes variation at some degrees.
    Wronskians(Wronskians),
    /// A proof together with its assumptions.
    On(Box<Assumptions<P>>),
    /// Both halves of `and`.
    Both(Box<Proof<P>>, Box<Proof<P>>),
    /// A proof for each part into which disjunctions among the hypotheses divide the domain.
    Parts(Vec<Proof<P>>),
    /// A proof of each clause of a statement in conjunctive form.
    Clauses(Vec<Proof<P>>),
    /// A proof of one of several alternatives, either everywhere or where all others fail.
    Alternative {
        /// The position of the alternative among the parts of `or`, from the left.
        place: usize,
        /// Whether the alternative is proved only where all others fail.
        where_others_fail: bool,
        /// The proof.
        proof: Box<Proof<P>>,
    },
    /// A proof of the conclusion of `implies`, where the premise holds.
    Conclusion(Box<Proof<P>>),
    /// A proof for each combination of values of some integers, which have no other values.
    Instances(Vec<Instance<P>>),
    /// The domain is empty, so there is nothing to prove.
    Nowhere(Emptiness<P>),
    /// `not p`, by a point at which p fails.
    Exists(Box<Refuted<P>>),
    /// A proof whose conditions only say where the terms of the statement are defined.
    Defined(Box<Proof<P>>),
    /// A proof of a part of the statement that shows the whole, with polynomials that are nonzero where all terms of
    /// the whole are defined.
    Within {
        /// The polynomials.
        conditions: Vec<P>,
        /// The proof.
        proof: Box<Proof<P>>,
    },
    /// A case split: a proof where a polynomial is nonzero, and one where it is zero.
    Split(Box<Split<P>>),
    /// A case split: proofs where the argument of an absolute value is not negative, and where it is not positive.
    Sides(Box<Sides<P>>),
}

/// A case split at an absolute value, the root of a square.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Sides<P> {
    /// The symbol that stands for the absolute value.
    pub root: String,
    /// The proof where its argument is zero or more.
    pub above: Proof<P>,
    /// The proof where its argument is zero or less.
    pub below: Proof<P>,
}

/// A case split at a pivot. An equation determines a symbol only where the coefficient of the symbol is nonzero, so
/// the domain is divided into the points where the coefficient is nonzero and those where it is zero.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Split<P> {
    /// The coefficient, or another divisor of a proof.
    pub pivot: P,
    /// The proof where the pivot is nonzero.
    pub nonzero: Proof<P>,
    /// The result where the pivot is zero.
    pub zero: ZeroSide<P>,
}

/// The result for the points of a domain at which a polynomial is zero.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ZeroSide<P> {
    /// The statement is true at all of them.
    Proved(Proof<P>),
    /// The statement fails at one of them, so that the pivot is nonzero is a necessary condition.
    Fails(Refuted<P>),
}

/// A proof for chosen values of integers.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Instance<P> {
    /// The values.
    pub integers: BTreeMap<String, i64>,
    /// The proof.
    pub proof: Proof<P>,
}

/// Why no point satisfies the hypotheses.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Emptiness<P> {
    /// The declared range of this symbol is empty.
    Range(String),
    /// A constraint holds nowhere.
    Constraint {
        /// The constraint.
        fails: Constraint<P>,
        /// Whether it fails only where all other constraints hold.
        others: bool,
    },
    /// This term has no value anywhere.
    Undefined(String),
}

impl<P> Proof<P> {
    /// The proof with further conditions, which say where the statement is defined.
    #[must_use]
    pub fn within(self, conditions: Vec<P>) -> Self {
        match conditions.is_empty() {
            true => self,
            false => Self::Within {
                conditions,
                proof: Box::new(self),
            },
        }
    }

    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Proof<Q> {
        let one = |proof: &Self| Box::new(proof.map(change));
        let all = |proofs: &[Self]| proofs.iter().map(|proof| proof.map(change)).collect();
        match self {
            Self::Identity(proof) => Proof::Identity(proof.map(change)),
            Self::Combination(proof) => Proof::Combination(proof.map(change)),
            Self::ZeroBySign(proof) => Proof::ZeroBySign(proof.map(change)),
            Self::Order(proof) => Proof::Order(Box::new(proof.map(change))),
            Self::Excluded(proof) => Proof::Excluded(proof.map(change)),
            Self::Enclosure(proof) => Proof::Enclosure(proof.map(change)),
            Self::Nonnegative(proof) => Proof::Nonnegative(proof.map(change)),
            Self::Powers(proof) => Proof::Powers(proof.map(change)),
            Self::Wronskians(proof) => Proof::Wronskians(proof.clone()),
            Self::On(ground) => Proof::On(Box::new(ground.map(change))),
            Self::Both(first, second) => Proof::Both(one(first), one(second)),
            Self::Parts(proofs) => Proof::Parts(all(proofs)),
            Self::Clauses(proofs) => Proof::Clauses(all(proofs)),
            Self::Alternative {
                place,
                where_others_fail,
                proof,
            } => Proof::Alternative {
                place: *place,
                where_others_fail: *where_others_fail,
                proof: one(proof),
            },
            Self::Conclusion(proof) => Proof::Conclusion(one(proof)),
            Self::Instances(instances) => {
                let instance = |instance: &Instance<P>| Instance {
                    integers: instance.integers.clone(),
                    proof: instance.proof.map(change),
                };
                Proof::Instances(instances.iter().map(instance).collect())
            }
            Self::Nowhere(emptiness) => Proof::Nowhere(emptiness.map(change)),
            Self::Exists(refuted) => Proof::Exists(Box::new(refuted.map(change))),
            Self::Defined(proof) => Proof::Defined(one(proof)),
            Self::Within { conditions, proof } => Proof::Within {
                conditions: conditions.iter().map(change).collect(),
                proof: one(proof),
            },
            Self::Split(split) => Proof::Split(Box::new(Split {
                pivot: change(&split.pivot),
                nonzero: split.nonzero.map(change),
                zero: match &split.zero {
                    ZeroSide::Proved(proof) => ZeroSide::Proved(proof.map(change)),
                    ZeroSide::Fails(refuted) => ZeroSide::Fails(refuted.map(change)),
                },
            })),
            Self::Sides(sides) => Proof::Sides(Box::new(Sides {
                root: sides.root.clone(),
                above: sides.above.map(change),
                below: sides.below.map(change),
            })),
        }
    }

    /// The direct parts of the proof.
    #[must_use]
    pub fn parts(&self) -> Vec<&Self> {
        match self {
            Self::On(ground) => vec![&ground.proof],
            Self::Both(first, second) => vec![first, second],
            Self::Parts(proofs) | Self::Clauses(proofs) => proofs.iter().collect(),
            Self::Alternative { proof, .. }
            | Self::Conclusion(proof)
            | Self::Defined(proof)
            | Self::Within { proof, .. } => vec![proof],
            Self::Instances(instances) => instances.iter().map(|one| &one.proof).collect(),
            Self::Split(split) => match &split.zero {
                ZeroSide::Proved(zero) => vec![&split.nonzero, zero],
                ZeroSide::Fails(_) => vec![&split.nonzero],
            },
            Self::Sides(sides) => vec![&sides.above, &sides.below],
            _ => vec![],
        }
    }

    /// The evidence: for several proofs the weakest one, where an identity is the strongest.
    #[must_use]
    pub fn evidence(&self) -> Evidence {
        match self {
            Self::Identity(proof) => proof.by.evidence(),
            Self::Combination(proof) => proof.by.evidence(),
            Self::ZeroBySign(proof) => proof.evidence(),
            Self::Order(_) | Self::Excluded(_) | Self::Wronskians(_) => Evidence::Inequality,
            Self::Enclosure(proof) if proof.is_exact() => Evidence::Identity,
            Self::Enclosure(_) => Evidence::Enclosure,
            Self::Nonnegative(_) | Self::Powers(_) => Evidence::Induction,
            Self::Exists(_) => Evidence::Witness,
            // If all instances are decided, the evidence counts as an identity, however each was decided.
            Self::Instances(_) | Self::Nowhere(_) => Evidence::Identity,
            _ => {
                let parts = self.parts().into_iter().map(Self::evidence);
                parts.max().unwrap_or(Evidence::Identity)
            }
        }
    }

    /// Polynomials that must be nonzero for the proof to apply, sorted; as the inner proofs contain them, not
    /// factored.
    #[must_use]
    pub fn conditions(&self) -> Vec<&P>
    where
        P: Ord,
    {
        let mut all: Vec<&P> = match self {
            Self::Identity(proof) => proof.divisors.iter().collect(),
            Self::Combination(proof) => proof.divisors.iter().collect(),
            Self::ZeroBySign(proof) => proof.divisors.iter().collect(),
            Self::Order(proof) => proof.divisors.iter().collect(),
            Self::Excluded(proof) => proof.divisors.iter().collect(),
            Self::On(ground) => ground.conditions.iter().collect(),
            Self::Defined(_) => vec![],
            Self::Within { conditions, proof } => {
                proof.conditions().into_iter().chain(conditions).collect()
            }
            Self::Split(split) => match &split.zero {
                ZeroSide::Proved(zero) => {
                    let nonzero = split.nonzero.conditions().into_iter();
                    let others = nonzero.filter(|condition| **condition != split.pivot);
                    others.chain(zero.conditions()).collect()
                }
                ZeroSide::Fails(_) => split.nonzero.conditions(),
            },
            _ => self
                .parts()
                .into_iter()
                .flat_map(Self::conditions)
                .collect(),
        };
        all.sort();
        all.dedup();
        all
    }

    /// The exceptions of case splits: each pivot where the statement fails if it vanishes, with the refutation.
    #[must_use]
    pub fn excepted(&self) -> Vec<(&P, &Refuted<P>)> {
        let own = match self {
            Self::Split(split) => match &split.zero {
                ZeroSide::Fails(refuted) => Some((&split.pivot, refuted)),
                ZeroSide::Proved(_) => None,
            },
            _ => None,
        };
        let inside = self.parts().into_iter().flat_map(Self::excepted);
        own.into_iter().chain(inside).collect()
    }

    /// The constraints that the proof uses: those that a certificate of sign multiplies, splits off as factors or
    /// excludes pieces with, and the equations of combinations. Ranges of single symbols count as coordinates, and
    /// are not listed.
    #[must_use]
    pub fn hypotheses(&self) -> Vec<&Constraint<P>> {
        let mut found = vec![];
        self.collect_hypotheses(&[], &mut found);
        found
    }

    fn collect_hypotheses<'p>(
        &'p self,
        constraints: &'p [Constraint<P>],
        found: &mut Vec<&'p Constraint<P>>,
    ) {
        match self {
            Self::Order(order) => {
                let used = order.signs.iter().flat_map(|sign| sign.constraints());
                found.extend(used.filter_map(|place| constraints.get(place)));
            }
            Self::ZeroBySign(forced) => {
                let used = forced.signs().flat_map(Sign::constraints);
                found.extend(used.filter_map(|place| constraints.get(place)));
            }
            Self::On(ground) => ground.proof.collect_hypotheses(&ground.constraints, found),
            _ => {
                for part in self.parts() {
                    part.collect_hypotheses(constraints, found);
                }
            }
        }
    }
}

impl<P: Clone + PartialEq> Proof<P> {
    /// The results about ranges for the whole statement. If one half of a conjunction fails beyond an end, the
    /// conjunction does; for a wider range both halves must be proved. Results for single alternatives, instances or
    /// cases of a split say nothing about the whole.
    #[must_use]
    pub fn ranges(&self) -> Vec<Sharpness<P>> {
        match self {
            Self::On(ground) => ground.ranges.clone(),
            Self::Both(first, second) => {
                let (first, second) = (first.ranges(), second.ranges());
                let is_said = |range: &Sharpness<P>| match range {
                    Sharpness::Fails { .. } => true,
                    Sharpness::Wider { .. } => second.contains(range),
                };
                let mut both: Vec<_> = first.into_iter().filter(is_said).collect();
                let fails = second
                    .iter()
                    .filter(|range| matches!(range, Sharpness::Fails { .. }));
                for range in fails {
                    if !both.contains(range) {
                        both.push(range.clone());
                    }
                }
                both
            }
            _ => vec![],
        }
    }
}

impl<P> Emptiness<P> {
    /// Converts every polynomial.
    pub fn map<Q>(&self, change: &dyn Fn(&P) -> Q) -> Emptiness<Q> {
        match self {
            Self::Range(name) => Emptiness::Range(name.clone()),
            Self::Constraint { fails, others } => Emptiness::Constraint {
                fails: fails.map(change),
                others: *others,
            },
            Self::Undefined(what) => Emptiness::Undefined(what.clone()),
        }
    }
}
