//! From statements to decisions.
//!
//! Equality is decided by normal forms ([`equality`]), printed decimals by certified enclosures
//! ([`agreement`]), order by proofs of sign on the declared domain ([`sign`]). A refutation always
//! comes with a point of the domain at which the statement fails ([`witness`]); "not proved" alone is
//! never "false". Statements whose symbolic degree cannot be carried are tried at small degrees
//! ([`instances`]), which can refute them but not prove them.

pub mod agreement;
pub mod domain;
pub mod equality;
pub mod family;
pub mod instances;
pub mod sign;
pub mod witness;

use crate::evaluate::Evaluator;
use crate::evaluate::fault::Fault;
use crate::evaluate::value::{FamilyProperty, Statement};
use crate::outcome::{Evidence, Witness};
use crate::syntax::{Connective, Relation};
use domain::Domain;
use torse_algebra::{Fraction, Polynomial};

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
        Statement::Family { property, basis } => match property {
            FamilyProperty::Nonnegative => family::nonnegative(basis, domain, evaluator),
            FamilyProperty::Independent => family::independent(basis, domain, evaluator),
            FamilyProperty::VariationDiminishing => family::variation_diminishing(basis, domain, evaluator),
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
            Ok(match second {
                proven @ Decision::Proven { .. } => proven,
                _ => Decision::Open {
                    reason: "neither alternative is proved on the whole domain".to_owned(),
                    tried: vec!["each alternative on its own".to_owned()],
                },
            })
        }
        Statement::Not(inner) => negation(inner, domain, evaluator),
        Statement::Join(Connective::Implies, ..) => Ok(Decision::Open {
            reason: "an implication; state its premise as an assumption".to_owned(),
            tried: vec![],
        }),
    }
}

/// `not p`: a universal statement about p itself ("p fails everywhere") is not meant; `not (a == b)`
/// states that the two sides are different somewhere, as formulas.
fn negation(
    inner: &Statement,
    domain: &Domain,
    evaluator: &Evaluator<'_>,
) -> Result<Decision, Fault> {
    Ok(match decide(inner, domain, evaluator)? {
        Decision::Refuted(refutation) => Decision::Proven {
            evidence: Evidence::Witness,
            conditions: vec![],
            steps: refutation
                .steps
                .into_iter()
                .chain(std::iter::once(format!(
                    "a point where it fails: {}",
                    refutation
                        .witness
                        .at
                        .iter()
                        .map(|(n, v)| format!("{n} = {v}"))
                        .collect::<Vec<_>>()
                        .join(", ")
                )))
                .collect(),
        },
        Decision::Proven { .. } => Decision::Open {
            reason: "the negated statement holds identically".to_owned(),
            tried: vec!["the statement without `not`".to_owned()],
        },
        open @ Decision::Open { .. } => open,
    })
}

/// A conjunction of decisions, neither of which is a refutation unless the second is.
fn both(first: Decision, second: Decision) -> Decision {
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
        (open @ Decision::Open { .. }, _) | (_, open) => open,
    }
}
