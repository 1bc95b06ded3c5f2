//! Deciding one comparison, or another statement without structure, on a domain without alternatives: symbolically, or
//! where a symbolic degree cannot be carried at small values of the integers.

mod definedness;
mod equations;

use crate::context::{Besides, ProofContext, RootMode};
use crate::decide::contradiction::contradiction;
use crate::decide::domain::branch::written;
use crate::decide::value::Proof;
use crate::decide::{self, Decision, equality, exponential, instances, witness};
use crate::divisors::{
    Nonzero, divisors, in_finest_parts, index_ranges, nonzero, open_conditions, unrooted,
    written_ranges,
};
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::rc::Rc;
use torse_algebra::{Polynomial, work};
use torse_certificate::Refuted;
use torse_certificate::proof::Emptiness;
use torse_certificate::proof::assumptions::Sharpness;
use torse_core::{self as core};
use torse_elaborate::Elaborator;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::fault::{Fault, Problem};
use torse_syntax::formula::Place;

/// The values of some integers.
pub(crate) type Instance = BTreeMap<String, i64>;

/// A claim whose hypotheses are comparisons.
pub(crate) struct Decider<'a> {
    pub claim: core::Claim,
    pub(crate) elaborator: Rc<Elaborator<'a>>,
    /// Polynomials that are assumed not to be zero, besides the hypotheses.
    pub(crate) nonzero: Vec<Polynomial>,
    /// The domain with no integer fixed and roots as symbols, once it was made: every part of a statement starts from it.
    ground: OnceCell<ProofContext<'a>>,
}

impl<'a> Decider<'a> {
    pub fn new(claim: core::Claim, elaborator: Rc<Elaborator<'a>>) -> Self {
        Self {
            claim,
            elaborator,
            nonzero: vec![],
            ground: OnceCell::new(),
        }
    }

    /// The same where these polynomials are not zero.
    pub fn where_nonzero(&self, nonzero: &[Polynomial]) -> Self {
        Self {
            nonzero: nonzero.to_vec(),
            ..Self::new(self.claim.clone(), Rc::clone(&self.elaborator))
        }
    }

    /// Whether values that equations give to symbols divide by what may vanish.
    pub fn divides_by_splits(&self) -> bool {
        let ground = self.ground(&Instance::new());
        ground.is_ok_and(|ground| !ground.branch.splits().is_empty())
    }

    /// How many eliminations the domain takes, if none of them brings in a divisor.
    pub fn undivided_eliminations(&self) -> Option<usize> {
        let branch = self.ground(&Instance::new()).ok()?.branch;
        let mut solved = branch.domain.solved().iter();
        let undivided =
            branch.domain.pivots().is_empty() && solved.all(|(_, v)| v.conditions().is_empty());
        undivided.then(|| branch.eliminated().len())
    }

    /// A point of the domain at which both sides of the first comparison are defined.
    pub fn anywhere(&self, statement: &core::Statement) -> Option<Refuted<Polynomial>> {
        let at = |instance: &Instance| {
            let ground = self.ground(instance).ok()?;
            let value = ground.branch.evaluator.truth(statement).ok()?;
            let mut point = decide::sampled(&value, &ground.branch.domain)?;
            let own = point.counterexample_mut();
            witness::complete(own, &self.claim, instance, &ground.branch.domain);
            Some(match instance.is_empty() {
                true => point,
                false => Refuted::Instance {
                    integers: instance.clone(),
                    refuted: Box::new(point),
                },
            })
        };
        at(&Instance::new()).or_else(|| {
            let (assignments, _) = self.instances();
            assignments.iter().take(8).find_map(at)
        })
    }

    /// Small values of the integers of the claim, and whether they are all there are.
    pub(crate) fn instances(&self) -> (Vec<Instance>, bool) {
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

    fn ground(&self, instance: &Instance) -> Result<ProofContext<'a>, Fault> {
        if !instance.is_empty() {
            return self.ground_where(instance, RootMode::Symbols);
        }
        if let Some(known) = self.ground.get() {
            return Ok(known.clone());
        }
        let made = self.ground_where(instance, RootMode::Symbols)?;
        // What a job that is over came to would be that of all later parts.
        work::check().map_err(|limit| Fault::limit(Place::default(), limit.to_string()))?;
        Ok(self.ground.get_or_init(|| made).clone())
    }

    fn ground_where(
        &self,
        instance: &Instance,
        roots: RootMode,
    ) -> Result<ProofContext<'a>, Fault> {
        let fixed = instances::fixed(instance);
        let (elaborator, zero) = (Rc::clone(&self.elaborator), [].as_slice());
        let nonzero = &self.nonzero;
        ProofContext::on_side(
            &self.claim,
            elaborator,
            &fixed,
            roots,
            Besides { zero, nonzero },
        )
    }

    /// A statement that is no conjunction and no negation.
    pub fn single(&self, statement: &core::Statement) -> Result<Decision, Fault> {
        let symbolic = match self.symbolic(statement, &Instance::new()) {
            Ok(decision) => decision,
            Err(fault) if fault.is_limit() => Decision::open(fault.problem.to_string(), &[]),
            Err(fault) => return Err(fault),
        };
        let Decision::Open(unsettled) = symbolic else {
            return Ok(symbolic);
        };
        if let Some(decision) = self.by_finite_ranges(statement)? {
            return Ok(decision);
        }
        let (assignments, complete) = self.instances();
        if assignments.iter().all(Instance::is_empty) {
            return Ok(Decision::Open(unsettled));
        }
        let (mut decided, mut divided) = (vec![], vec![]);
        let far = instances::far(&assignments, self.elaborator.declarations());
        for (number, assignment) in assignments.iter().chain(&far).enumerate() {
            // Greater integers are for statements that say nothing about small ones.
            let silent = |(_, d): &(Instance, Decision)| matches!(d, Decision::Vacuous(_));
            if number >= assignments.len() && (complete || !decided.iter().all(silent)) {
                break;
            }
            let decision = match self.symbolic(statement, assignment) {
                Ok(decision) => decision,
                // Some term is defined at no point of the instance, so the statement says nothing there.
                Err(fault) if undefined(&fault) => {
                    if self.divides_by_zero(&fault, assignment) {
                        divided.push(assignment.clone());
                    }
                    Decision::Vacuous(Emptiness::Undefined(fault.problem.to_string()))
                }
                Err(fault) if fault.is_limit() => Decision::open(fault.problem.to_string(), &[]),
                Err(fault) => return Err(fault),
            };
            let ends = matches!(decision, Decision::Refuted(_) | Decision::Open(_));
            decided.push((assignment.clone(), decision));
            if ends {
                break;
            }
        }
        let decision = instances::combined(decided, complete, &unsettled.reason);
        Ok(self.where_defined(statement, decision, &divided))
    }

    /// All values of the integers with short ranges of numbers, if there are such integers.
    pub(crate) fn finite_instances(&self) -> Option<Vec<Instance>> {
        let finite = |set: &SymbolKind| {
            matches!(set, SymbolKind::Integer { least: Some(a), most: Some(b) }
                if a.as_number().is_some() && b.as_number().is_some())
        };
        let symbols = self.claim.symbols.iter();
        let chosen = symbols.filter(|(_, set)| finite(set));
        let chosen: Vec<String> = chosen.map(|(name, _)| name.to_string()).collect();
        let declarations = self.elaborator.declarations();
        let (assignments, complete) = instances::assignments(&chosen, declarations);
        (!chosen.is_empty() && complete).then_some(assignments)
    }

    /// A proof by cases over the integers with short ranges of numbers, the others kept symbolic; or a refutation.
    fn by_finite_ranges(&self, statement: &core::Statement) -> Result<Option<Decision>, Fault> {
        let Some(assignments) = self.finite_instances() else {
            return Ok(None);
        };
        let (mut decided, mut divided) = (vec![], vec![]);
        for assignment in assignments {
            match self.symbolic(statement, &assignment) {
                Ok(Decision::Open(_)) => return Ok(None),
                Ok(decision) => decided.push((assignment, decision)),
                Err(fault) if undefined(&fault) => {
                    if self.divides_by_zero(&fault, &assignment) {
                        divided.push(assignment.clone());
                    }
                    let why = Emptiness::Undefined(fault.problem.to_string());
                    decided.push((assignment, Decision::Vacuous(why)));
                }
                Err(fault) if fault.is_limit() => return Ok(None),
                Err(fault) => return Err(fault),
            }
        }
        let decision = instances::combined(decided, true, "");
        Ok(match self.where_defined(statement, decision, &divided) {
            Decision::Open(_) => None,
            decision => Some(decision),
        })
    }

    /// The decision with some integers fixed. Where roots are left that settle nothing as symbols, what they are the roots of
    /// is written by them.
    fn symbolic(
        &self,
        statement: &core::Statement,
        instance: &Instance,
    ) -> Result<Decision, Fault> {
        let ground = self.ground(instance)?;
        let rooted = !ground.branch.domain.roots.is_empty();
        let splits = ground.branch.splits().to_vec();
        let has_divisors = !splits.is_empty();
        let decision = self.on_ground(statement, instance, ground)?;
        let decision = self.split(statement, instance, decision, splits);
        if rooted && matches!(decision, Decision::Open(_)) {
            let ground = self.ground_where(instance, RootMode::Solved);
            let again = ground.and_then(|ground| self.on_ground(statement, instance, ground));
            if let Ok(decided @ (Decision::Proven(_) | Decision::Refuted(_))) = again {
                return Ok(decided);
            }
        }
        if matches!(decision, Decision::Open(_))
            && has_divisors
            && let Some((kept, combination, conditions)) = self.uneliminated(statement, instance)
            && conditions.is_empty()
        {
            let met = unrooted(&combination.divisors, &kept);
            let nonzero = nonzero(met, &conditions, &kept.branch.domain);
            let combination = Proof::Combination(combination);
            return Ok(proved(kept, combination, (conditions, nonzero), vec![]));
        }
        Ok(decision)
    }

    pub(crate) fn on_ground(
        &self,
        statement: &core::Statement,
        instance: &Instance,
        mut ground: ProofContext<'_>,
    ) -> Result<Decision, Fault> {
        let names: Vec<String> = self
            .claim
            .symbols
            .keys()
            .map(ToString::to_string)
            .filter(|name| !instance.contains_key(name))
            .collect();
        if let Some(emptiness) = contradiction(&ground.branch.domain, &names) {
            // Where a divisor of the elimination vanishes, the constraints may say something else.
            return Ok(match ground.branch.splits().is_empty() {
                true => Decision::Vacuous(emptiness),
                false => proved(
                    ground.clone(),
                    Proof::Nowhere(emptiness),
                    (ground.branch.splits().to_vec(), (vec![], vec![])),
                    vec![],
                ),
            });
        }
        let value = ground.branch.evaluator.truth(statement)?;
        ground
            .branch
            .domain
            .order_exponentials(&exponential::symbols_of(&value));
        let mut decision = decide::decide(&value, &ground.branch.domain, &ground.branch.evaluator)?;
        if decision.is_refuted() {
            // A point at which some other part of the claim is undefined refutes nothing.
            match ground.branch.evaluator.truth(&self.claim.statement) {
                Ok(whole) => {
                    let mut divisors = divisors(&whole);
                    // Nor does one at which a part of a hypothesis is.
                    let mut defined = index_ranges(&whole, &self.claim, &ground.branch.evaluator);
                    for hypothesis in &self.claim.hypotheses {
                        divisors.extend(self.term_divisors(&hypothesis.statement, &ground));
                        let evaluator = &ground.branch.evaluator;
                        defined.extend(written_ranges(&hypothesis.statement, evaluator));
                    }
                    divisors.extend(self.term_divisors(&self.claim.statement, &ground));
                    if !divisors.is_empty() || !defined.is_empty() {
                        ground.branch.domain.divisors = divisors;
                        ground.branch.domain.defined = defined;
                        decision = decide::decide(
                            &value,
                            &ground.branch.domain,
                            &ground.branch.evaluator,
                        )?;
                    }
                    if matches!(decision, Decision::Open(_)) {
                        let there = self.where_it_has_a_value(statement, &value, &ground);
                        decision = decide::decide(&value, &there, &ground.branch.evaluator)?;
                    }
                }
                Err(fault) if undefined(&fault) => return Err(fault),
                Err(fault) => {
                    return Ok(Decision::open(fault.problem.to_string(), &[]));
                }
            }
        }
        let proof = match decision {
            Decision::Proven(proof) => proof,
            Decision::Refuted(mut refutation) => {
                let point = refutation.refuted.counterexample_mut();
                witness::complete(point, &self.claim, instance, &ground.branch.domain);
                return Ok(Decision::Refuted(refutation));
            }
            other => return Ok(other),
        };
        let met: Vec<Polynomial> = proof.conditions().into_iter().cloned().collect();
        let met = unrooted(&met, &ground);
        let written = self.term_divisors(statement, &ground);
        let all = [met.clone(), unrooted(&written, &ground)].concat();
        let conditions = open_conditions(in_finest_parts(&all), &ground);
        if !conditions.is_empty()
            && let Some((unsolved, combination, weaker)) = self.unsolved(
                statement,
                instance,
                equality::vanishing(&ground.branch.evaluator),
            )
            && weaker
                .iter()
                .all(|condition| conditions.contains(condition))
            && weaker.len() < conditions.len()
        {
            let nonzero = nonzero(met, &weaker, &unsolved.branch.domain);
            let combination = Proof::Combination(combination);
            return Ok(proved(unsolved, combination, (weaker, nonzero), vec![]));
        }
        if !conditions.is_empty()
            && !ground.branch.eliminated().is_empty()
            && let Some((kept, combination, weaker)) = self.uneliminated(statement, instance)
            && weaker
                .iter()
                .all(|condition| conditions.contains(condition))
            && weaker.len() < conditions.len()
        {
            let met = unrooted(&combination.divisors, &kept);
            let nonzero = nonzero(met, &weaker, &kept.branch.domain);
            let combination = Proof::Combination(combination);
            return Ok(proved(kept, combination, (weaker, nonzero), vec![]));
        }
        // What a symbol, a root or a divisor is on the declared ranges, it need not be beyond them.
        let domain = &ground.branch.domain;
        let depends_on_ranges = !ground.branch.eliminated().is_empty()
            || !domain.roots.is_empty()
            || !domain.logarithms.is_empty()
            || !all.is_empty();
        let ranges = match depends_on_ranges {
            true => vec![],
            false => decide::ranges(&value, domain, &ground.branch.evaluator)?,
        };
        let nonzero = nonzero(met, &conditions, &ground.branch.domain);
        Ok(proved(ground, proof, (conditions, nonzero), ranges))
    }
}

/// A proof on its ground.
fn proved(
    ground: ProofContext<'_>,
    proof: Proof,
    (conditions, (nonzero, apart)): (Vec<Polynomial>, Nonzero),
    ranges: Vec<Sharpness<Polynomial>>,
) -> Decision {
    Decision::Proven(Proof::On(Box::new(
        torse_certificate::proof::assumptions::Assumptions {
            constraints: written(&ground.branch.domain.constraints),
            eliminated: ground.branch.eliminated().to_vec(),
            proof,
            conditions,
            nonzero,
            apart,
            ranges,
        },
    )))
}

/// Whether a fault says that a term is defined nowhere.
fn undefined(fault: &Fault) -> bool {
    matches!(
        *fault.problem,
        Problem::IndexOutside { .. } | Problem::ZeroDivisor { .. }
    )
}
