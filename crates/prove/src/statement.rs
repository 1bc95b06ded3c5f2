//! Deciding the statement of a claim.
//!
//! A claim says that its statement is true at every point of its domain at which it is defined. So a conjunction is
//! decided part by part, and `not p` is proved by one point at which p fails. Every other statement is decided
//! symbolically, or, where a symbolic degree cannot be carried, at small values of the integers.

use crate::alternatives;
use crate::case::Ground;
use crate::combination::follows;
use crate::decide::contradiction::contradiction;
use crate::decide::{self, Decision, conditions, exponential, instances, sign};
use crate::evaluate::value::{Statement, Value};
use crate::evidence::{Evidence, Witness};
use std::collections::BTreeMap;
use std::rc::Rc;
use torse_algebra::planted::{Planted, planted};
use torse_algebra::{Fraction, Polynomial};
use torse_language::core::{self, Elaborator};
use torse_language::derivation::declarations::SymbolKind;
use torse_language::derivation::{Claim, Origin, Written};
use torse_language::fault::{Fault, Problem};
use torse_language::syntax::{Connective, Relation};

/// Decides a statement on the domain of a claim: the claim's own, or another one in its place.
///
/// # Errors
/// [`Fault`] when a formula makes no sense.
pub fn decide_statement(claim: &Claim, statement: &Written) -> Result<Decision, Fault> {
    let elaborator = Rc::new(Elaborator::new(&claim.declarations));
    let core = core::Claim::elaborated(&elaborator, claim, statement)?;
    let parts = Parts::of(alternatives::parts(&core), &elaborator, &statement.origin);
    let decision = parts
        .decide(&core.statement)
        .map_err(|fault| fault.within(&statement.origin))?;
    Ok(match decision {
        // The parts of a conjunction may have factors of one another as their conditions.
        Decision::Proven {
            evidence,
            conditions,
            steps,
        } => Decision::Proven {
            evidence,
            conditions: conditions::separated(&conditions),
            steps,
        },
        other => other,
    })
}

/// The values of some integers.
type Instance = BTreeMap<String, i64>;

/// The domain of a claim, cut into parts without alternatives.
struct Parts<'a> {
    deciders: Vec<Decider<'a>>,
    elaborator: Rc<Elaborator<'a>>,
    /// Where the statement is written.
    origin: &'a Origin,
}

/// A claim whose hypotheses are comparisons.
struct Decider<'a> {
    claim: core::Claim,
    elaborator: Rc<Elaborator<'a>>,
}

impl<'a> Parts<'a> {
    fn of(claims: Vec<core::Claim>, elaborator: &Rc<Elaborator<'a>>, origin: &'a Origin) -> Self {
        let decider = |claim| Decider {
            claim,
            elaborator: Rc::clone(elaborator),
        };
        Self {
            deciders: claims.into_iter().map(decider).collect(),
            elaborator: Rc::clone(elaborator),
            origin,
        }
    }

    fn decide(&self, statement: &core::Statement) -> Result<Decision, Fault> {
        match statement {
            core::Statement::Join(Connective::And, a, b) => {
                let first = self.decide(a)?;
                if first.is_refuted() {
                    return Ok(first);
                }
                Ok(decide::both(first, self.decide(b)?))
            }
            core::Statement::Not(inner) => {
                let decided = self.everywhere_defined(self.decide(inner)?);
                let anywhere = || self.deciders.iter().find_map(|part| part.anywhere(inner));
                Ok(decide::negated(decided, anywhere))
            }
            core::Statement::Join(Connective::Implies, premise, conclusion) => {
                match self.under(&[premise], true, conclusion)? {
                    Some(decision) => Ok(decision),
                    None => self.everywhere(statement),
                }
            }
            core::Statement::Join(Connective::Or, ..) => match alternatives::clauses(statement) {
                Some(clauses) => {
                    let clauses = clauses.iter().map(|clause| self.alternative(clause));
                    conjoined(clauses)
                }
                None => self.everywhere(statement),
            },
            other => self.everywhere(other),
        }
    }

    /// A proof without the conditions that only say where its own terms are defined: those that no eliminated symbol
    /// brought in.
    fn everywhere_defined(&self, decision: Decision) -> Decision {
        match decision {
            Decision::Proven {
                evidence,
                conditions,
                steps,
            } if !conditions.is_empty()
                && self.deciders.iter().all(Decider::brings_no_divisors) =>
            {
                Decision::Proven {
                    evidence,
                    conditions: vec![],
                    steps,
                }
            }
            other => other,
        }
    }

    /// Alternatives: proved if one is, or one is where all others fail. A denial among them is true or false of the whole
    /// domain: a false one is no alternative.
    fn alternative(&self, literals: &[&core::Statement]) -> Result<Decision, Fault> {
        let (mut left, mut decisions, mut false_denial) = (vec![], vec![], None);
        for literal in literals {
            let decision = self.decide(literal)?;
            match &decision {
                Decision::Proven { conditions, .. } if conditions.is_empty() => {
                    return Ok(decision);
                }
                Decision::Refuted(_) if denies(literal) => false_denial = Some(decision),
                _ => {
                    left.push(*literal);
                    decisions.push(decision);
                }
            }
        }
        if left.len() <= 1
            && let Some(decision) = decisions.pop().or(false_denial)
        {
            return Ok(decision);
        }
        for (place, conclusion) in left.iter().enumerate().rev() {
            let others = [&left[..place], &left[place + 1..]].concat();
            let found = self.under(&others, false, conclusion)?;
            let settles = |found: &Decision| match found {
                Decision::Proven { conditions, .. } => conditions.is_empty(),
                found => found.is_refuted(),
            };
            if let Some(found) = found.filter(settles) {
                return Ok(found);
            }
        }
        Ok(Decision::Open {
            reason: "no alternative is proved on the whole domain".to_owned(),
            tried: vec!["each alternative on its own, and where the others fail".to_owned()],
        })
    }

    /// A statement that is decided as it is, on every part.
    fn everywhere(&self, statement: &core::Statement) -> Result<Decision, Fault> {
        conjoined(self.deciders.iter().map(|part| part.single(statement)))
    }

    /// The conclusion where all premises are true, or all are false: at every other point the statement is true. `None` if
    /// a premise cannot be assumed, or one of them denies something of the whole domain.
    fn under(
        &self,
        premises: &[&core::Statement],
        truth: bool,
        conclusion: &core::Statement,
    ) -> Result<Option<Decision>, Fault> {
        if premises.iter().any(|p| denies(p)) || denies(conclusion) {
            return Ok(None);
        }
        let mut there = vec![];
        for part in &self.deciders {
            let Some(claims) = alternatives::under(&part.claim, premises, truth, self.origin)
            else {
                return Ok(None);
            };
            there.extend(claims);
        }
        let there = Parts::of(there, &self.elaborator, self.origin);
        Ok(Some(match there.decide(conclusion) {
            // No point, or none at which the premises are so: the second is a proof.
            Ok(Decision::Vacuous { reason }) => match self.everywhere(conclusion)? {
                vacuous @ Decision::Vacuous { .. } => vacuous,
                _ => Decision::Proven {
                    evidence: Evidence::Identity,
                    conditions: vec![],
                    steps: vec![format!("no point is to be looked at: {reason}")],
                },
            },
            Ok(decision) => decision,
            Err(fault) if fault.is_limit() => Decision::Open {
                reason: fault.problem.to_string(),
                tried: vec![],
            },
            Err(fault) => return Err(fault),
        }))
    }
}

/// Whether something is denied of the whole domain.
fn denies(statement: &core::Statement) -> bool {
    match statement {
        core::Statement::Not(_) => true,
        core::Statement::Join(_, a, b) => denies(a) || denies(b),
        _ => false,
    }
}

/// The decision from those on all parts of a domain, or of all parts of a statement. A part without points says nothing.
fn conjoined(parts: impl Iterator<Item = Result<Decision, Fault>>) -> Result<Decision, Fault> {
    let mut whole: Option<Decision> = None;
    for part in parts {
        let part = part?;
        if part.is_refuted() {
            return Ok(part);
        }
        whole = Some(match (whole, part) {
            (None, part) | (Some(Decision::Vacuous { .. }), part) => part,
            (Some(known), Decision::Vacuous { .. }) => known,
            (Some(known), part) => decide::both(known, part),
        });
    }
    Ok(whole.unwrap_or(Decision::Open {
        reason: "no part of the domain".to_owned(),
        tried: vec![],
    }))
}

impl Decider<'_> {
    /// Whether no eliminated symbol brought in a divisor.
    fn brings_no_divisors(&self) -> bool {
        let ground = self.ground(&Instance::new());
        ground.is_ok_and(|g| {
            let mut solved = g.domain.solved.iter();
            g.domain.pivots.is_empty() && solved.all(|(_, v)| v.conditions().is_empty())
        })
    }

    /// A point of the domain at which both sides of the first comparison are defined.
    fn anywhere(&self, statement: &core::Statement) -> Option<Witness> {
        let at = |instance: &Instance| {
            let ground = self.ground(instance).ok()?;
            let value = ground.evaluator.truth(statement).ok()?;
            let mut witness = decide::sampled(&value, &ground.domain)?;
            let known = witness.at.clone();
            let integers = instance
                .iter()
                .filter(|(n, _)| known.iter().all(|(name, _)| name != *n))
                .map(|(n, v)| (n.clone(), v.to_string()));
            witness.at.splice(0..0, integers);
            Some(witness)
        };
        at(&Instance::new()).or_else(|| {
            let (assignments, _) = self.instances();
            assignments.iter().take(8).find_map(at)
        })
    }

    /// Small values of the integers of the claim, and whether they are all there are.
    fn instances(&self) -> (Vec<Instance>, bool) {
        let declarations = self.elaborator.declarations();
        let integers = instances::ordered(
            self.claim
                .symbols
                .iter()
                .filter(|(_, set)| matches!(set, SymbolKind::Integer { .. }))
                .map(|(name, _)| name.to_string())
                .collect(),
            declarations,
        );
        instances::assignments(&integers, declarations)
    }

    fn ground(&self, instance: &Instance) -> Result<Ground<'_>, Fault> {
        Ground::new(
            &self.claim,
            Rc::clone(&self.elaborator),
            &instances::fixed(instance),
        )
    }

    /// A statement that is no conjunction and no negation.
    fn single(&self, statement: &core::Statement) -> Result<Decision, Fault> {
        let (reason, tried) = match self.symbolic(statement, &Instance::new()) {
            Ok(Decision::Open { reason, tried }) => (reason, tried),
            Ok(decision) => return Ok(decision),
            Err(fault) if fault.is_limit() => (fault.problem.to_string(), vec![]),
            Err(fault) => return Err(fault),
        };
        if let Some(decision) = self.by_finite_ranges(statement)? {
            return Ok(decision);
        }
        let (assignments, complete) = self.instances();
        if assignments.iter().all(Instance::is_empty) {
            return Ok(Decision::Open { reason, tried });
        }
        let mut decided = vec![];
        let far = instances::far(&assignments, self.elaborator.declarations());
        for (number, assignment) in assignments.iter().chain(&far).enumerate() {
            // Greater integers are for statements that say nothing about small ones.
            let silent = |(_, d): &(Instance, Decision)| matches!(d, Decision::Vacuous { .. });
            if number >= assignments.len() && (complete || !decided.iter().all(silent)) {
                break;
            }
            let decision = match self.symbolic(statement, assignment) {
                Ok(decision) => decision,
                // Some term is defined at no point of the instance, so the statement says nothing there.
                Err(fault) if undefined(&fault) => Decision::Vacuous {
                    reason: fault.problem.to_string(),
                },
                Err(fault) if fault.is_limit() => Decision::Open {
                    reason: fault.problem.to_string(),
                    tried: vec![],
                },
                Err(fault) => return Err(fault),
            };
            let ends = matches!(decision, Decision::Refuted(_) | Decision::Open { .. });
            decided.push((assignment.clone(), decision));
            if ends {
                break;
            }
        }
        Ok(instances::combined(decided, complete, &reason))
    }

    /// A proof by cases over the integers with short ranges of numbers, the others kept symbolic; or a refutation.
    fn by_finite_ranges(&self, statement: &core::Statement) -> Result<Option<Decision>, Fault> {
        let finite = |set: &SymbolKind| {
            matches!(set, SymbolKind::Integer { least: Some(a), most: Some(b) }
                if a.as_number().is_some() && b.as_number().is_some())
        };
        let chosen: Vec<String> = self
            .claim
            .symbols
            .iter()
            .filter(|(_, set)| finite(set))
            .map(|(name, _)| name.to_string())
            .collect();
        let (assignments, complete) =
            instances::assignments(&chosen, self.elaborator.declarations());
        if chosen.is_empty() || !complete {
            return Ok(None);
        }
        let mut decided = vec![];
        for assignment in assignments {
            match self.symbolic(statement, &assignment) {
                Ok(Decision::Open { .. }) => return Ok(None),
                Ok(decision) => decided.push((assignment, decision)),
                Err(fault) if undefined(&fault) => decided.push((
                    assignment,
                    Decision::Vacuous {
                        reason: fault.problem.to_string(),
                    },
                )),
                Err(fault) if fault.is_limit() => return Ok(None),
                Err(fault) => return Err(fault),
            }
        }
        Ok(Some(instances::combined(decided, true, "")))
    }

    /// The conditions under which an equation follows from the given ones without solving these, if it does.
    fn unsolved(
        &self,
        statement: &core::Statement,
        instance: &Instance,
    ) -> Option<Vec<Polynomial>> {
        let core::Statement::Compare {
            relation: Relation::Equal,
            left,
            right,
        } = statement
        else {
            return None;
        };
        // Coefficients are those of what the solutions make of a form.
        let reads_solutions = |term: &core::Term| term.applies(core::BuiltIn::Coefficients);
        if self.claim.unknowns.is_empty() || reads_solutions(left) || reads_solutions(right) {
            return None;
        }
        let fixed = instances::fixed(instance);
        let ground = Ground::assumed(&self.claim, Rc::clone(&self.elaborator), &fixed).ok()?;
        let (forms, unknowns) = (
            ground.given(&self.claim).ok()?,
            ground.unknowns(&self.claim).ok()?,
        );
        let Ok(Statement::Compare { left, right, .. }) = ground.evaluator.truth(statement) else {
            return None;
        };
        let pairs = left.entries().into_iter().zip(right.entries());
        let differences: Option<Vec<Fraction>> = pairs
            .map(|(x, y)| x.minus(y).as_fraction().cloned())
            .collect();
        let differences = differences?;
        if !follows(&differences, &forms, &unknowns) {
            return None;
        }
        let sides = left.entries().into_iter().chain(right.entries());
        let divisors = sides.flat_map(|side| side.conditions());
        let of = |all: &[Fraction]| -> Vec<Polynomial> {
            all.iter().flat_map(|f| f.conditions().to_vec()).collect()
        };
        let conditions: Vec<Polynomial> =
            divisors.chain(of(&differences)).chain(of(&forms)).collect();
        Some(open_conditions(&conditions, &ground))
    }

    /// The decision with some integers fixed.
    fn symbolic(
        &self,
        statement: &core::Statement,
        instance: &Instance,
    ) -> Result<Decision, Fault> {
        let mut ground = self.ground(instance)?;
        let names: Vec<String> = self
            .claim
            .symbols
            .keys()
            .map(ToString::to_string)
            .filter(|name| !instance.contains_key(name))
            .collect();
        if let Some(reason) = contradiction(&ground.domain, &names) {
            // Where a divisor of the elimination vanishes, the constraints may say something else.
            return Ok(match ground.domain.pivots.is_empty() {
                true => Decision::Vacuous { reason },
                false => Decision::Open {
                    reason,
                    tried: vec![],
                },
            });
        }
        let value = ground.evaluator.truth(statement)?;
        ground
            .domain
            .order_exponentials(&exponential::symbols_of(&value));
        let mut decision = decide::decide(&value, &ground.domain, &ground.evaluator)?;
        if decision.is_refuted() {
            // A point at which some other part of the claim is undefined refutes nothing.
            match ground.evaluator.truth(&self.claim.statement) {
                Ok(whole) => {
                    let divisors = divisors(&whole);
                    if !divisors.is_empty() {
                        ground.domain.divisors = divisors;
                        decision = decide::decide(&value, &ground.domain, &ground.evaluator)?;
                    }
                }
                Err(fault) if undefined(&fault) => return Err(fault),
                Err(fault) => {
                    return Ok(Decision::Open {
                        reason: fault.problem.to_string(),
                        tried: vec![],
                    });
                }
            }
        }
        let Decision::Proven {
            evidence,
            conditions,
            steps,
        } = decision
        else {
            return Ok(decision);
        };
        let mut conditions = conditions;
        if !is_equality(&value) {
            conditions.extend(ground.domain.pivots.iter().cloned());
        }
        let mut conditions = open_conditions(&conditions, &ground);
        let mut steps = steps;
        if !conditions.is_empty()
            && let Some(weaker) = self.unsolved(statement, instance)
            && weaker
                .iter()
                .all(|condition| conditions.contains(condition))
            && weaker.len() < conditions.len()
        {
            conditions = weaker;
            steps.push("the difference is a combination of the given equations".to_owned());
        }
        Ok(Decision::Proven {
            evidence,
            conditions,
            steps: [
                steps,
                decide::ranges(&value, &ground.domain, &ground.evaluator)?,
            ]
            .concat(),
        })
    }
}

/// Whether a fault says that a term is defined nowhere.
fn undefined(fault: &Fault) -> bool {
    matches!(
        *fault.problem,
        Problem::IndexOutside { .. } | Problem::ZeroDivisor { .. }
    )
}

fn is_equality(statement: &Statement) -> bool {
    matches!(
        statement,
        Statement::Compare {
            relation: Relation::Equal,
            ..
        }
    )
}

/// Everything that the terms of a statement were divided by.
fn divisors(statement: &Statement) -> Vec<Polynomial> {
    let of = |value: &Value| -> Vec<Polynomial> {
        let entries = value.entries().into_iter();
        entries.flat_map(|q| q.conditions()).collect()
    };
    let mut all = match statement {
        Statement::Compare { left, right, .. } => [of(left), of(right)].concat(),
        Statement::Agrees { values, .. } => {
            let recorded = values.iter().flat_map(Fraction::conditions);
            recorded.cloned().collect()
        }
        Statement::Family { .. } => vec![],
        Statement::Join(_, a, b) => [divisors(a), divisors(b)].concat(),
        Statement::Not(inner) => divisors(inner),
    };
    all.sort();
    all.dedup();
    all
}

/// The conditions that neither the hypotheses state nor the domain implies.
fn open_conditions(conditions: &[Polynomial], ground: &Ground<'_>) -> Vec<Polynomial> {
    conditions::separated(conditions)
        .into_iter()
        .filter(|_| !planted(Planted::ConditionDropped))
        .filter(|p| !ground.domain.assumes_nonzero(p) && !sign::never_zero(p, &ground.domain))
        .collect()
}
