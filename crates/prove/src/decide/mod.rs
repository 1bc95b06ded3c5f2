//! Procedures that decide one kind of statement.
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
mod inner_point;
pub mod instances;
pub mod interval;
pub mod logarithm;
pub mod nondegenerate;
pub mod open_arc;
pub mod order;
mod point_search;
pub mod real_symbol;
mod render;
pub mod root;
pub mod sharpness;
pub mod sign;
mod simplex;
pub mod value;
pub mod variation;
pub mod witness;
pub mod witness_search;
mod wronskian;
mod zero_by_sign;

use crate::evaluate::Evaluator;
use crate::evaluate::value::{Statement, Value};
use crate::evidence::Witness;
use domain::{Constraint, Domain};
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::{Fraction, Polynomial};
use torse_certificate::Refuted;
use torse_certificate::point::Counterexample;
use torse_certificate::proof::assumptions::Sharpness;
use torse_certificate::proof::{Emptiness, Instance};
use torse_core::FamilyProperty;
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Connective, Relation};
use value::Proof;

/// What is known about a statement.
#[derive(Debug, Clone)]
pub enum Decision {
    /// True on the whole domain, where the conditions of the proof do not vanish.
    Proven(Proof),
    /// False, with a point of the domain.
    Refuted(Box<Refutation>),
    /// No point satisfies the hypotheses.
    Vacuous(Emptiness<Polynomial>),
    /// Neither.
    Open(Unsettled),
}

/// Why a statement is neither proved nor refuted.
#[derive(Debug, Clone)]
pub struct Unsettled {
    /// The reason: what was not settled, or the limit that was met.
    pub reason: String,
    /// The instances that are proved.
    pub instances: Vec<Instance<Polynomial>>,
    /// What was tried.
    pub tried: Vec<String>,
}

impl Unsettled {
    /// Whether instances or methods were tried.
    #[must_use]
    pub fn has_tried(&self) -> bool {
        !self.instances.is_empty() || !self.tried.is_empty()
    }
}

/// How a statement fails.
#[derive(Debug, Clone)]
pub struct Refutation {
    /// The point, or what is denied and true.
    pub refuted: Refuted<Polynomial>,
    /// Both sides before any symbol got a value, entry by entry, where they are plain.
    pub sides: Option<(Vec<Fraction>, Vec<Fraction>)>,
}

impl Refutation {
    /// At this point.
    #[must_use]
    pub fn at(point: Counterexample<Polynomial>) -> Self {
        Self {
            refuted: Refuted::At(point),
            sides: None,
        }
    }

    /// The same with the sides as formulas.
    #[must_use]
    pub fn with_sides(self, left: Vec<Fraction>, right: Vec<Fraction>) -> Self {
        Self {
            sides: Some((left, right)),
            ..self
        }
    }

    /// The point in words.
    #[must_use]
    pub fn witness(&self) -> Witness {
        render::witness(&self.refuted)
    }
}

impl Decision {
    /// Whether this is a proof.
    #[must_use]
    pub fn is_proven(&self) -> bool {
        matches!(self, Self::Proven(_))
    }

    /// Whether this is a refutation.
    #[must_use]
    pub fn is_refuted(&self) -> bool {
        matches!(self, Self::Refuted(_))
    }

    /// Open for this reason, after these were tried.
    #[must_use]
    pub fn open(reason: impl Into<String>, tried: &[&str]) -> Self {
        Self::Open(Unsettled {
            reason: reason.into(),
            instances: vec![],
            tried: tried.iter().map(|one| (*one).to_owned()).collect(),
        })
    }

    /// The conditions of a proof, as factors of which none divides another.
    #[must_use]
    pub fn conditions(&self) -> Option<Vec<Polynomial>> {
        match self {
            Self::Proven(proof) => {
                let conditions: Vec<Polynomial> = proof.conditions().into_iter().cloned().collect();
                Some(conditions::separated(&conditions))
            }
            _ => None,
        }
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
        } if family::restricts_variable(basis, domain) => Ok(Decision::open(
            format!(
                "a hypothesis speaks of {}, the variable of the basis",
                basis.variable()
            ),
            &[],
        )),
        Statement::Family { family: basis, .. }
            if let Some(divisor) = family::vanishing_divisor(basis, domain, evaluator)? =>
        {
            Ok(Decision::open(
                format!("a function of the basis divides by {divisor}, which may be zero"),
                &[],
            ))
        }
        Statement::Family {
            property,
            family: basis,
        } => match property {
            FamilyProperty::Nonnegative => family::nonnegative(basis, domain, evaluator),
            FamilyProperty::Independent => family::independent(basis, domain, evaluator),
            FamilyProperty::VariationDiminishing(degrees) => {
                variation::diminishing(basis, *degrees, domain, evaluator)
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
            if let Decision::Proven(proof) = first {
                return Ok(Decision::Proven(alternative(0, false, proof)));
            }
            let second = decide(b, domain, evaluator)?;
            let closed = |s: &Statement| !has_negation(s);
            // Where the second fails the first has to hold: a proof there proves, and a point there refutes both.
            if closed(a)
                && let Some(failing) = failure(b)
            {
                let mut there = domain.clone();
                there.constraints.extend(failing);
                match decide(a, &there, evaluator)? {
                    Decision::Proven(proof) => {
                        return Ok(Decision::Proven(alternative(0, true, proof)));
                    }
                    refuted @ Decision::Refuted(_) => return Ok(refuted),
                    Decision::Vacuous(_) | Decision::Open(_) => {}
                }
            }
            Ok(match (first, second) {
                (_, Decision::Proven(proof)) => Decision::Proven(alternative(1, false, proof)),
                // Two refutations that need no point are refutations at every point.
                (Decision::Refuted(x), Decision::Refuted(y))
                    if x.refuted.counterexample().at.is_empty()
                        && y.refuted.counterexample().at.is_empty()
                        && closed(a)
                        && closed(b) =>
                {
                    Decision::Refuted(y)
                }
                _ => Decision::open(
                    "neither alternative is proved on the whole domain",
                    &["each alternative on its own"],
                ),
            })
        }
        Statement::Not(inner) => {
            let decided = decide(inner, domain, evaluator)?;
            Ok(negated(decided, || sampled(inner, domain)))
        }
        Statement::Join(Connective::Implies, ..) => Ok(Decision::open(
            "an implication; state its premise as an assumption",
            &[],
        )),
    }
}

/// What is known about the ranges of the parameters of a proved statement about order.
///
/// # Errors
/// A [`Fault`] when the seeds of a family cannot be evaluated.
pub fn ranges(
    statement: &Statement,
    domain: &Domain,
    evaluator: &Evaluator<'_>,
) -> Result<Vec<Sharpness<Polynomial>>, Fault> {
    let bounds = match statement {
        Statement::Family {
            property: FamilyProperty::Nonnegative,
            family: basis,
        } => family::bounds(basis, evaluator)?,
        _ => sharpness::bounds(statement),
    };
    Ok(sharpness::all(&bounds, domain))
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

/// One of several alternatives.
pub(crate) fn alternative(place: usize, where_others_fail: bool, proof: Proof) -> Proof {
    Proof::Alternative {
        place,
        where_others_fail,
        proof: Box::new(proof),
    }
}

/// `not p`: p does not hold at every point of the domain. A point where p fails proves it; a proof of p
/// refutes it, and any point of the domain shows it.
pub(crate) fn negated(
    decided: Decision,
    anywhere: impl FnOnce() -> Option<Refuted<Polynomial>>,
) -> Decision {
    match decided {
        Decision::Refuted(refutation) => {
            Decision::Proven(Proof::Exists(Box::new(refutation.refuted)))
        }
        Decision::Proven(proof) if proof.conditions().is_empty() => match anywhere() {
            Some(point) => Decision::Refuted(Box::new(Refutation {
                refuted: Refuted::Denied {
                    proof: Box::new(proof),
                    anywhere: Box::new(point),
                },
                sides: None,
            })),
            None => Decision::open(
                "the negated statement holds, but no point of the domain was found",
                &[],
            ),
        },
        // Where a condition fails the negated statement may fail: the proof knows a point, or it does not.
        Decision::Proven(proof) => match proof.excepted().into_iter().next() {
            Some((_, refuted)) => Decision::Proven(Proof::Exists(Box::new(refuted.clone()))),
            None => Decision::open("the negated statement is proved under conditions only", &[]),
        },
        undecided @ (Decision::Open(_) | Decision::Vacuous(_)) => undecided,
    }
}

/// A point of the domain, with both sides of the first comparison that has plain ones.
pub(crate) fn sampled(statement: &Statement, domain: &Domain<'_>) -> Option<Refuted<Polynomial>> {
    let mut sides = comparisons(statement).into_iter();
    let point = sides.find_map(|(left, right)| equality::sample(left, right, domain));
    point.map(Refuted::At)
}

/// The sides of all comparisons in a statement.
pub(crate) fn comparisons(statement: &Statement) -> Vec<(&Value, &Value)> {
    match statement {
        Statement::Compare { left, right, .. } => vec![(left, right)],
        Statement::Join(_, a, b) => [comparisons(a), comparisons(b)].concat(),
        Statement::Not(inner) => comparisons(inner),
        Statement::Agrees { .. } | Statement::Family { .. } => vec![],
    }
}

/// A conjunction of decisions, neither of which is a refutation unless the second is.
pub(crate) fn both(first: Decision, second: Decision) -> Decision {
    if injected(InjectedFault::SecondHalfIgnored) {
        return first;
    }
    match (first, second) {
        (_, refuted @ Decision::Refuted(_)) => refuted,
        (Decision::Proven(first), Decision::Proven(second)) => {
            Decision::Proven(Proof::Both(Box::new(first), Box::new(second)))
        }
        (Decision::Proven(_), other) | (other, _) => other,
    }
}
