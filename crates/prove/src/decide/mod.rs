//! From statements to decisions.
//!
//! Equality is decided by normal forms ([`equality`]), printed decimals by certified enclosures
//! ([`agreement`]), order by proofs of sign on the declared domain ([`sign`]). A refutation always
//! comes with a point of the domain at which the statement fails ([`witness`]); "not proved" alone is
//! never "false". Statements whose symbolic degree cannot be carried are tried at small degrees
//! ([`instances`]), which can refute them but not prove them.

pub mod agreement;
pub mod angle;
pub mod candidates;
pub mod conditions;
pub mod contradiction;
pub mod domain;
pub mod equality;
pub mod exponential;
pub mod family;
pub mod instances;
pub mod interval;
pub mod lively;
pub mod order;
pub mod sharpness;
pub mod sign;
pub mod variation;
pub mod witness;

use crate::evaluate::Evaluator;
use crate::evaluate::value::{Statement, Value};
use crate::evidence::{Evidence, Witness};
use domain::{Constraint, Domain};
use torse_algebra::planted::{Planted, planted};
use torse_algebra::{Fraction, Polynomial};
use torse_language::core::FamilyProperty;
use torse_language::fault::Fault;
use torse_language::syntax::{Connective, Relation};

/// What is known about a statement.
#[derive(Debug, Clone)]
pub enum Decision {
    /// True on the whole domain, where the conditions do not vanish.
    Proven {
        /// What the proof rests on.
        evidence: Evidence,
        /// Divisors that were used: the proof holds where none of them is zero.
        conditions: Vec<Polynomial>,
        /// The steps, in words.
        steps: Vec<String>,
    },
    /// False, with a point of the domain.
    Refuted(Box<Refutation>),
    /// No point satisfies the assumptions.
    Vacuous {
        /// The assumption that fails everywhere.
        reason: String,
    },
    /// Neither.
    Open {
        /// Why.
        reason: String,
        /// What was tried.
        tried: Vec<String>,
    },
}

/// How a statement fails.
#[derive(Debug, Clone)]
pub struct Refutation {
    /// The point and both sides there.
    pub witness: Witness,
    /// Both sides before any symbol got a value, entry by entry, where they are plain.
    pub sides: Option<(Vec<Fraction>, Vec<Fraction>)>,
    /// The steps, in words.
    pub steps: Vec<String>,
    /// What it rests on: the point, or, where something is denied, the proof of what is denied.
    pub evidence: Evidence,
}

impl Decision {
    /// Proven, from nothing but an identity.
    fn identity(conditions: Vec<Polynomial>, step: String) -> Self {
        Self::Proven {
            evidence: Evidence::Identity,
            conditions,
            steps: vec![step],
        }
    }

    /// Whether this is a proof.
    #[must_use]
    pub fn is_proven(&self) -> bool {
        matches!(self, Self::Proven { .. })
    }

    /// Whether this is a refutation.
    #[must_use]
    pub fn is_refuted(&self) -> bool {
        matches!(self, Self::Refuted(_))
    }
}

/// Decides a statement on a domain.
///
/// # Errors
/// A [`Fault`] when an exact operation fails on the way.
pub fn decide(
    statement: &Statement,
    domain: &Domain,
    evaluator: &Evaluator<'_>,
) -> Result<Decision, Fault> {
    match statement {
        Statement::Compare {
            relation: Relation::Equal,
            left,
            right,
            ..
        } => equality::decide(left, right, domain, evaluator),
        Statement::Compare {
            relation,
            left,
            right,
            ..
        } => sign::compare(*relation, left, right, domain),
        Statement::Agrees { values, printed } => Ok(agreement::decide(values, printed)),
        Statement::Family {
            property,
            family: basis,
        } => match property {
            FamilyProperty::Nonnegative => family::nonnegative(basis, domain, evaluator),
            FamilyProperty::Independent => family::independent(basis, domain, evaluator),
            FamilyProperty::VariationDiminishing => {
                variation::diminishing(basis, domain, evaluator)
            }
        },
        Statement::Join(Connective::And, a, b) => {
            let first = decide(a, domain, evaluator)?;
            if first.is_refuted() {
                return Ok(first);
            }
            let second = decide(b, domain, evaluator)?;
            Ok(both(first, second))
        }
        Statement::Join(Connective::Or, a, b) => {
            let first = decide(a, domain, evaluator)?;
            if first.is_proven() {
                return Ok(first);
            }
            let second = decide(b, domain, evaluator)?;
            let closed = |s: &Statement| !has_negation(s);
            // Where the second fails the first has to hold: a proof there proves, and a point there refutes both.
            if closed(a)
                && let Some(failing) = failure(b)
            {
                let mut there = domain.clone();
                there.constraints.extend(failing);
                let decided = decide(a, &there, evaluator)?;
                if decided.is_proven() || decided.is_refuted() {
                    return Ok(decided);
                }
            }
            Ok(match (first, second) {
                (_, proven @ Decision::Proven { .. }) => proven,
                // Two refutations that need no point are refutations at every point.
                (Decision::Refuted(x), Decision::Refuted(y))
                    if x.witness.at.is_empty()
                        && y.witness.at.is_empty()
                        && closed(a)
                        && closed(b) =>
                {
                    Decision::Refuted(y)
                }
                _ => Decision::Open {
                    reason: "neither alternative is proved on the whole domain".to_owned(),
                    tried: vec!["each alternative on its own".to_owned()],
                },
            })
        }
        Statement::Not(inner) => {
            let decided = decide(inner, domain, evaluator)?;
            Ok(negated(decided, || sampled(inner, domain)))
        }
        Statement::Join(Connective::Implies, ..) => Ok(Decision::Open {
            reason: "an implication; state its premise as an assumption".to_owned(),
            tried: vec![],
        }),
    }
}

/// What is known about the ranges of the parameters of a proved statement about order, in words.
///
/// # Errors
/// A [`Fault`] when the seeds of a family cannot be evaluated.
pub fn ranges(
    statement: &Statement,
    domain: &Domain,
    evaluator: &Evaluator<'_>,
) -> Result<Vec<String>, Fault> {
    let bounded = match statement {
        Statement::Family {
            property: FamilyProperty::Nonnegative,
            family: basis,
        } => family::bounded(basis, evaluator)?,
        _ => sharpness::bounded(statement),
    };
    Ok(sharpness::steps(&bounded, domain))
}

/// The constraints under which a statement fails, if they are a conjunction.
fn failure(statement: &Statement) -> Option<Vec<Constraint>> {
    match statement {
        Statement::Compare {
            relation,
            left,
            right,
        } => {
            let (lefts, rights) = (left.entries(), right.entries());
            let ([x], [y]) = (lefts.as_slice(), rights.as_slice()) else {
                return None;
            };
            let value = x.minus(y).as_fraction()?.clone();
            let relation = relation.opposite();
            Some(vec![Constraint { value, relation }])
        }
        Statement::Join(Connective::Or, a, b) => Some([failure(a)?, failure(b)?].concat()),
        _ => None,
    }
}

/// Whether a negation stands anywhere in the statement: it speaks of the whole domain, not of one point.
fn has_negation(statement: &Statement) -> bool {
    match statement {
        Statement::Not(_) => true,
        Statement::Join(_, a, b) => has_negation(a) || has_negation(b),
        _ => false,
    }
}

/// `not p`: p does not hold at every point of the domain. A point where p fails proves it; a proof of p
/// refutes it, and any point of the domain shows it.
pub(crate) fn negated(decided: Decision, anywhere: impl FnOnce() -> Option<Witness>) -> Decision {
    match decided {
        Decision::Refuted(refutation) => {
            let at = refutation
                .witness
                .at
                .iter()
                .map(|(name, value)| format!("{name} = {value}"));
            let point = at.collect::<Vec<_>>().join(", ");
            let mut steps = refutation.steps;
            steps.push(format!(
                "a point where the negated statement fails: {point}"
            ));
            Decision::Proven {
                evidence: Evidence::Witness,
                conditions: vec![],
                steps,
            }
        }
        Decision::Proven {
            conditions,
            steps,
            evidence,
        } if conditions.is_empty() => match anywhere() {
            Some(witness) => {
                let first = "the negated statement is proved: it holds everywhere".to_owned();
                let steps = std::iter::once(first).chain(steps).collect();
                Decision::Refuted(Box::new(Refutation {
                    witness,
                    sides: None,
                    steps,
                    evidence,
                }))
            }
            None => Decision::Open {
                reason: "the negated statement holds, but no point of the domain was found"
                    .to_owned(),
                tried: steps,
            },
        },
        Decision::Proven { steps, .. } => Decision::Open {
            reason: "the negated statement is proved under conditions only".to_owned(),
            tried: steps,
        },
        undecided @ (Decision::Open { .. } | Decision::Vacuous { .. }) => undecided,
    }
}

/// A point of the domain, with both sides of the first comparison that has plain ones.
pub(crate) fn sampled(statement: &Statement, domain: &Domain<'_>) -> Option<Witness> {
    comparisons(statement)
        .into_iter()
        .find_map(|(left, right)| equality::sample(left, right, domain))
}

/// The sides of all comparisons in a statement.
fn comparisons(statement: &Statement) -> Vec<(&Value, &Value)> {
    match statement {
        Statement::Compare { left, right, .. } => vec![(left, right)],
        Statement::Join(_, a, b) => [comparisons(a), comparisons(b)].concat(),
        Statement::Not(inner) => comparisons(inner),
        Statement::Agrees { .. } | Statement::Family { .. } => vec![],
    }
}

/// A conjunction of decisions, neither of which is a refutation unless the second is.
pub(crate) fn both(first: Decision, second: Decision) -> Decision {
    if planted(Planted::SecondHalfIgnored) {
        return first;
    }
    match (first, second) {
        (_, refuted @ Decision::Refuted(_)) => refuted,
        (
            Decision::Proven {
                evidence: e1,
                conditions: c1,
                steps: s1,
            },
            Decision::Proven {
                evidence: e2,
                conditions: c2,
                steps: s2,
            },
        ) => {
            let mut conditions = [c1, c2].concat();
            conditions.sort();
            conditions.dedup();
            // The weaker kind of evidence names the whole: an identity is the strongest.
            Decision::Proven {
                evidence: e1.max(e2),
                conditions,
                steps: [s1, s2].concat(),
            }
        }
        (Decision::Proven { .. }, other) | (other, _) => other,
    }
}
