//! A proof of a statement, as a tree that follows the statement.

pub mod assumptions;
pub mod refutation;

use crate::enclosure::Enclosure;
use crate::evidence::Evidence;
use crate::family::{Nonnegative, Powers};
use crate::identity::{Combination, Identity};
use crate::order::{Excluded, Order};
use crate::polynomial::Polynomial;
use crate::ratio::{Constraint, Ratio};
use crate::sign::Sign;
use crate::wronskian::Wronskians;
use crate::zero_by_sign::ZeroBySign;
use assumptions::{Assumptions, Elimination, Sharpness};
use refutation::Refuted;
use serde::Serialize;
use std::collections::BTreeMap;

/// A proof that a statement is true on the whole domain, where its conditions do not vanish.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Proof<P> {
    /// An equation: the difference vanishes.
    Identity(Identity<P>),
    /// An equation: the difference is a combination of equations.
    Combination(Combination<P>),
    /// An equation: the difference can be nothing but zero.
    ZeroBySign(ZeroBySign<P>),
    /// A relation of order, by signs.
    Order(Box<Order<P>>),
    /// `!=`, by hypotheses.
    Excluded(Excluded<P>),
    /// Printed decimals agree.
    Enclosure(Enclosure<P>),
    /// A basis is nonnegative.
    Nonnegative(Nonnegative<P>),
    /// A basis diminishes variation.
    Powers(Powers<P>),
    /// A basis diminishes variation at some degrees.
    Wronskians(Wronskians),
    /// A proof with the ground on which it stands.
    On(Box<Assumptions<P>>),
    /// Both halves of `and`.
    Both(Box<Proof<P>>, Box<Proof<P>>),
    /// On all parts into which alternatives among the hypotheses cut the domain.
    Parts(Vec<Proof<P>>),
    /// All clauses of a statement written as a conjunction of alternatives.
    Clauses(Vec<Proof<P>>),
    /// One of several alternatives, by its place: everywhere, or where all others fail.
    Alternative {
        /// Its place among the parts of `or`, from the left.
        place: usize,
        /// Whether it is proved where the others fail, and not everywhere.
        where_others_fail: bool,
        /// The proof.
        proof: Box<Proof<P>>,
    },
    /// The second half of `implies`, where the first holds.
    Conclusion(Box<Proof<P>>),
    /// For all values of some integers, which are all there are.
    Instances(Vec<Instance<P>>),
    /// There is nothing to prove: no point.
    Nowhere(Emptiness<P>),
    /// `not p`: a point at which p fails.
    Exists(Box<Refuted<P>>),
    /// A proof whose conditions only say where the terms of the statement are defined.
    Defined(Box<Proof<P>>),
    /// Two proofs: where a polynomial is not zero, and where it is.
    Split(Box<Split<P>>),
}

/// What an equation determines is known only where the coefficient of the symbol is not zero: the domain falls into the points
/// at which it is not, and those at which it is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Split<P> {
    /// The coefficient, or whatever else a proof divides by.
    pub pivot: P,
    /// The proof where it is not zero.
    pub nonzero: Proof<P>,
    /// What is known where it is zero.
    pub zero: Zero<P>,
}

/// What is known of the points of a domain at which a polynomial is zero.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Zero<P> {
    /// The statement is true at all of them.
    Proved(Proof<P>),
    /// It fails at one: that the polynomial is not zero is a condition of the statement, and needed.
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
    /// The declared range of a symbol is empty.
    Range(String),
    /// A constraint holds nowhere.
    Constraint {
        /// The constraint.
        fails: Constraint<P>,
        /// Whether that is so where all others hold.
        others: bool,
    },
    /// Some term has no value anywhere.
    Undefined(String),
}

impl<P> Proof<P> {
    /// The same in other polynomials.
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
            Self::Split(split) => Proof::Split(Box::new(Split {
                pivot: change(&split.pivot),
                nonzero: split.nonzero.map(change),
                zero: match &split.zero {
                    Zero::Proved(proof) => Zero::Proved(proof.map(change)),
                    Zero::Fails(refuted) => Zero::Fails(refuted.map(change)),
                },
            })),
        }
    }

    /// The proofs that this one is made of, directly.
    #[must_use]
    pub fn parts(&self) -> Vec<&Self> {
        match self {
            Self::On(ground) => vec![&ground.proof],
            Self::Both(first, second) => vec![first, second],
            Self::Parts(proofs) | Self::Clauses(proofs) => proofs.iter().collect(),
            Self::Alternative { proof, .. } | Self::Conclusion(proof) | Self::Defined(proof) => {
                vec![proof]
            }
            Self::Instances(instances) => instances.iter().map(|one| &one.proof).collect(),
            Self::Split(split) => match &split.zero {
                Zero::Proved(zero) => vec![&split.nonzero, zero],
                Zero::Fails(_) => vec![&split.nonzero],
            },
            _ => vec![],
        }
    }

    /// What it rests on; of several proofs the weakest, and an identity is the strongest.
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
            // All instances, each decided, are an identity whatever decided them.
            Self::Instances(_) | Self::Nowhere(_) => Evidence::Identity,
            _ => {
                let parts = self.parts().into_iter().map(Self::evidence);
                parts.max().unwrap_or(Evidence::Identity)
            }
        }
    }

    /// What must not vanish for the proof to say something, in order; as the proofs inside met it, not yet taken apart.
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
            Self::Split(split) => match &split.zero {
                Zero::Proved(zero) => {
                    let nonzero = split.nonzero.conditions().into_iter();
                    let others = nonzero.filter(|condition| **condition != split.pivot);
                    others.chain(zero.conditions()).collect()
                }
                Zero::Fails(_) => split.nonzero.conditions(),
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

    /// The points at which the statement fails because a condition of the proof does, with what is zero there.
    #[must_use]
    pub fn excepted(&self) -> Vec<(&P, &Refuted<P>)> {
        let own = match self {
            Self::Split(split) => match &split.zero {
                Zero::Fails(refuted) => Some((&split.pivot, refuted)),
                Zero::Proved(_) => None,
            },
            _ => None,
        };
        let inside = self.parts().into_iter().flat_map(Self::excepted);
        own.into_iter().chain(inside).collect()
    }

    /// The constraints that the proof uses: those that a certificate of sign multiplies, splits off or cuts the box with, and
    /// equations that differences are combinations of. Ranges of single symbols count as coordinates, and are not listed.
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

impl Proof<Polynomial> {
    /// The steps in words, and what is known of the ranges.
    #[must_use]
    pub fn steps(&self) -> Vec<String> {
        let ranges = self.ranges();
        let ranges = ranges.iter().map(|range| range.text());
        self.reasons().into_iter().chain(ranges).collect()
    }

    /// What is known of the ranges of the whole statement: one half of a conjunction that fails beyond an end fails for both,
    /// and both have to be proved on a wider range. What some alternatives, instances or sides of a split say is nothing about all.
    fn ranges(&self) -> Vec<Sharpness<Polynomial>> {
        match self {
            Self::On(ground) => ground.ranges.clone(),
            Self::Both(first, second) => {
                let (first, second) = (first.ranges(), second.ranges());
                let is_said = |range: &Sharpness<Polynomial>| match range {
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

    /// The steps in words, without a look beyond the ranges.
    #[must_use]
    pub fn reasons(&self) -> Vec<String> {
        match self {
            Self::Identity(proof) => proof.steps(),
            Self::Combination(proof) => proof.steps(),
            Self::ZeroBySign(proof) => proof.steps(),
            Self::Order(proof) => proof.steps(),
            Self::Excluded(proof) => proof.steps(),
            Self::Enclosure(proof) => proof.steps(),
            Self::Nonnegative(proof) => proof.steps(),
            Self::Powers(proof) => proof.steps(),
            Self::Wronskians(proof) => proof.steps(),
            Self::On(ground) => {
                let roots = ground.eliminated.iter().filter_map(Elimination::step);
                roots.chain(ground.proof.reasons()).collect()
            }
            Self::Instances(instances) => instances.iter().map(Instance::step).collect(),
            Self::Nowhere(emptiness) => {
                vec![format!(
                    "no point is to be looked at: {}",
                    emptiness.reason()
                )]
            }
            Self::Split(split) => {
                let zero = match &split.zero {
                    Zero::Proved(_) => format!("where {} is zero it holds as well", split.pivot),
                    Zero::Fails(refuted) => {
                        let point: Vec<String> =
                            refuted.at().iter().map(|value| value.text()).collect();
                        let point = point.join(", ");
                        format!("where {} is zero it fails: {point}", split.pivot)
                    }
                };
                split.nonzero.reasons().into_iter().chain([zero]).collect()
            }
            Self::Exists(refuted) => {
                let mut steps = refuted.steps();
                let point: Vec<String> = refuted.at().iter().map(|value| value.text()).collect();
                let point = point.join(", ");
                steps.push(format!(
                    "a point where the negated statement fails: {point}"
                ));
                steps
            }
            _ => self.parts().into_iter().flat_map(Self::reasons).collect(),
        }
    }
}

impl Instance<Polynomial> {
    fn step(&self) -> String {
        let integers = self
            .integers
            .iter()
            .map(|(name, value)| format!("{name} = {value}"));
        let label = integers.collect::<Vec<_>>().join(", ");
        match &self.proof {
            Proof::Nowhere(emptiness) => {
                format!("says nothing for {label}: {}", emptiness.reason())
            }
            _ => format!("holds for {label}"),
        }
    }
}

impl<P> Emptiness<P> {
    /// The same in other polynomials.
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

    /// It in words.
    #[must_use]
    pub fn reason(&self) -> String
    where
        Ratio<P>: std::fmt::Display,
    {
        match self {
            Self::Range(name) => format!("the declared range of {name} is empty"),
            Self::Constraint { fails, others } => {
                let sign = fails.relation.sign();
                let others = match others {
                    false => "on the declared ranges",
                    true => "on the declared ranges where the other assumptions hold",
                };
                format!("{} {sign} 0 holds nowhere {others}", fails.value)
            }
            Self::Undefined(what) => what.clone(),
        }
    }
}
