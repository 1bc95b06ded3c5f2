//! Deciding one comparison, or another statement without structure, on a domain without alternatives: symbolically, or
//! where a symbolic degree cannot be carried at small values of the integers.

use crate::combination::multipliers;
use crate::context::{ProofContext, RootMode, SolvePolicy};
use crate::decide::contradiction::contradiction;
use crate::decide::domain::branch::written;
use crate::decide::domain::{Constraint, Domain};
use crate::decide::value::Proof;
use crate::decide::{self, Decision, conditions, equality, exponential, instances, sign, witness};
use crate::evaluate::Evaluator;
use crate::evaluate::series::polynomial_of;
use crate::evaluate::value::{Statement, Value};
use crate::roots;
use std::cell::OnceCell;
use std::collections::BTreeMap;
use std::rc::Rc;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::{Fraction, Polynomial, Symbol, work};
use torse_certificate::Refuted;
use torse_certificate::identity::{Combination, Equations, Vanishing};
use torse_certificate::proof::Emptiness;
use torse_certificate::proof::assumptions::Sharpness;
use torse_certificate::sign::Sign;
use torse_core::{self as core};
use torse_elaborate::Elaborator;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::fault::{Fault, Problem};
use torse_syntax::formula::{Place, Relation};
/// The values of some integers.
pub(crate) type Instance = BTreeMap<String, i64>;

/// A claim whose hypotheses are comparisons.
pub(crate) struct Decider<'a> {
    pub claim: core::Claim,
    pub(crate) elaborator: Rc<Elaborator<'a>>,
    /// The domain with no integer fixed and roots as symbols, once it was made: every part of a statement starts from it.
    ground: OnceCell<ProofContext<'a>>,
}

impl<'a> Decider<'a> {
    pub fn new(claim: core::Claim, elaborator: Rc<Elaborator<'a>>) -> Self {
        Self {
            claim,
            elaborator,
            ground: OnceCell::new(),
        }
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
        ProofContext::with_roots(&self.claim, Rc::clone(&self.elaborator), &fixed, roots)
    }

    /// A statement that is no conjunction and no negation.
    pub fn single(&self, statement: &core::Statement) -> Result<Decision, Fault> {
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
        let decision = instances::combined(decided, complete, &reason);
        Ok(self.where_defined(statement, decision, &divided))
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
        let (mut decided, mut divided) = (vec![], vec![]);
        for assignment in assignments {
            match self.symbolic(statement, &assignment) {
                Ok(Decision::Open { .. }) => return Ok(None),
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
            Decision::Open { .. } => None,
            decision => Some(decision),
        })
    }

    /// Whether a fault says that a term of the statement, and none of a hypothesis, divides by zero for these values of integers.
    fn divides_by_zero(&self, fault: &Fault, instance: &Instance) -> bool {
        matches!(*fault.problem, Problem::ZeroDivisor { .. }) && self.ground(instance).is_ok()
    }

    /// A proof by values of integers for some of which a divisor of the statement is zero: under the conditions that the divisors of the
    /// statement as it stands are not, open where these do not exclude each of those values.
    fn where_defined(
        &self,
        statement: &core::Statement,
        decision: Decision,
        divided: &[Instance],
    ) -> Decision {
        let (Decision::Proven(proof), Some(first)) = (&decision, divided.first()) else {
            return decision;
        };
        let conditions = self.definedness(statement).unwrap_or_default();
        let is_excluded = |instance: &Instance| {
            let value = |symbol: &Symbol| match symbol {
                Symbol::Named(name) => Some(Polynomial::integer(*instance.get(&**name)?)),
                _ => None,
            };
            let mut values = conditions.iter().map(|one| one.substituted(value));
            values.any(|condition| condition.is_zero())
        };
        match divided.iter().all(is_excluded) {
            true => Decision::Proven(proof.clone().within(conditions)),
            false => Decision::Open {
                reason: format!("a divisor is zero for {}", instances::label(first)),
                tried: vec![],
            },
        }
    }

    /// What the statement divides by, whatever the values of integers are, as far as no hypothesis says that it is not zero; `None` where a
    /// hypothesis is solved by dividing, or there is no formula for all integers.
    fn definedness(&self, statement: &core::Statement) -> Option<Vec<Polynomial>> {
        let ground = self.ground(&Instance::new()).ok()?;
        let value = ground.branch.evaluator.truth(statement).ok()?;
        let divisors = unrooted(&divisors(&value), &ground);
        let is_whole = ground.branch.splits().is_empty();
        is_whole.then(|| open_conditions(divisors, &ground))
    }

    /// An equation as a combination of the given ones, without solving these, if it is one, with the conditions that it
    /// leaves.
    fn unsolved(
        &self,
        statement: &core::Statement,
        instance: &Instance,
        by: Vanishing,
    ) -> Option<(ProofContext<'_>, Combination<Polynomial>, Vec<Polynomial>)> {
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
        let elaborator = Rc::clone(&self.elaborator);
        let ground =
            ProofContext::assumed(&self.claim, elaborator, &fixed, SolvePolicy::Always).ok()?;
        let (forms, unknowns) = (
            ground.given(&self.claim).ok()?,
            ground.unknowns(&self.claim).ok()?,
        );
        let Ok(Statement::Compare { left, right, .. }) = ground.branch.evaluator.truth(statement)
        else {
            return None;
        };
        let pairs = left.entries().into_iter().zip(right.entries());
        let differences: Option<Vec<Fraction>> = pairs
            .map(|(x, y)| x.minus(y).as_fraction().cloned())
            .collect();
        let differences = differences?;
        let multipliers = multipliers(&differences, &forms, &unknowns)?;
        let sides = left.entries().into_iter().chain(right.entries());
        let divisors = sides.flat_map(|side| side.conditions());
        let of = |all: &[Fraction]| -> Vec<Polynomial> {
            all.iter().flat_map(|f| f.conditions().to_vec()).collect()
        };
        let conditions: Vec<Polynomial> =
            divisors.chain(of(&differences)).chain(of(&forms)).collect();
        let open = open_conditions(unrooted(&conditions, &ground), &ground);
        let combination = Combination {
            of: Equations::Given,
            equations: forms.iter().map(|f| f.numerator().clone()).collect(),
            multipliers,
            divisors: decide::witness::nonconstant(conditions),
            by,
        };
        Some((ground, combination, open))
    }

    /// An equation as a combination of the assumed ones as they stand, where solving these would divide by what may vanish,
    /// if it is one, with the conditions that it leaves.
    fn uneliminated(
        &self,
        statement: &core::Statement,
        instance: &Instance,
    ) -> Option<(ProofContext<'_>, Combination<Polynomial>, Vec<Polynomial>)> {
        if !self.claim.unknowns.is_empty() {
            return None;
        }
        let fixed = instances::fixed(instance);
        let elaborator = Rc::clone(&self.elaborator);
        let ground =
            ProofContext::assumed(&self.claim, elaborator, &fixed, SolvePolicy::Safely).ok()?;
        let Ok(Statement::Compare {
            relation: Relation::Equal,
            left,
            right,
        }) = ground.branch.evaluator.truth(statement)
        else {
            return None;
        };
        let (domain, evaluator) = (&ground.branch.domain, &ground.branch.evaluator);
        let combination = equality::follows(&left, &right, domain, evaluator)
            .or_else(|| equality::follows_from_several(&left, &right, domain, evaluator))?;
        let open = open_conditions(unrooted(&combination.divisors, &ground), &ground);
        Some((ground, combination, open))
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
        if rooted && matches!(decision, Decision::Open { .. }) {
            let ground = self.ground_where(instance, RootMode::Solved);
            let again = ground.and_then(|ground| self.on_ground(statement, instance, ground));
            if let Ok(decided @ (Decision::Proven(_) | Decision::Refuted(_))) = again {
                return Ok(decided);
            }
        }
        if matches!(decision, Decision::Open { .. })
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
                    let divisors = divisors(&whole);
                    let defined = index_ranges(&whole, &self.claim, &ground.branch.evaluator);
                    if !divisors.is_empty() || !defined.is_empty() {
                        ground.branch.domain.divisors = divisors;
                        ground.branch.domain.defined = defined;
                        decision = decide::decide(
                            &value,
                            &ground.branch.domain,
                            &ground.branch.evaluator,
                        )?;
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
        let conditions = open_conditions(met.clone(), &ground);
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
        let ranges = decide::ranges(&value, &ground.branch.domain, &ground.branch.evaluator)?;
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

/// What never vanishes, by its sign: on the declared sets, whatever else is assumed, so that eliminations may rest on it; or
/// under all assumptions.
type Nonzero = (Vec<Sign<Polynomial>>, Vec<Sign<Polynomial>>);

/// Those of the factors of divisors that were met, and are no conditions. A radicand whose factors have no sign of their own has
/// one as a whole: `y^2` where `y^2 > 1`.
fn nonzero(mut met: Vec<Polynomial>, conditions: &[Polynomial], domain: &Domain<'_>) -> Nonzero {
    // Roots were taken for positive where their radicands are.
    let is_positive = |root: &&decide::root::Root| {
        domain.assumes_nonzero(&Polynomial::symbol(root.symbol.clone()))
    };
    let roots = domain.roots.iter().filter(is_positive);
    let mut radicands = domain.positive_radicands.clone();
    radicands.extend(roots.map(|root| root.radicand.numerator().clone()));
    met.extend(radicands.iter().cloned());
    let met = conditions::separated(&met);
    let declared = Domain::new(domain.declarations);
    let (mut signs, mut apart, mut without_sign) = (vec![], vec![], vec![]);
    for divisor in met {
        if conditions.contains(&divisor) {
            continue;
        }
        match sign::positive(&divisor, &declared) {
            Some(sign) => signs.push(sign),
            // A hypothesis says it, or no integers make it zero.
            None if domain.assumes_nonzero(&divisor) => {}
            None => {
                let rest = domain.without_assumed(&divisor);
                let sign = sign::positive(&rest, domain);
                match sign.or_else(|| sign::positive_square(&rest, domain)) {
                    Some(sign) => apart.push(sign),
                    None => without_sign.push(divisor),
                }
            }
        }
    }
    let is_whole = |radicand: &&Polynomial| {
        let mut factors = without_sign.iter();
        factors.any(|factor| radicand.exact_quotient(factor).is_some())
    };
    let whole = radicands.iter().filter(is_whole);
    apart.extend(whole.filter_map(|radicand| sign::positive(radicand, domain)));
    // That a root is positive follows from the sign of its radicand, which has to come before what the root occurs in.
    apart.sort_by_key(|sign| {
        let mut last_first = domain.roots.iter().rev();
        let last = last_first.position(|root| sign.polynomial.symbols().contains(&root.symbol));
        last.map_or(0, |behind| domain.roots.len() - behind)
    });
    (signs, apart)
}

/// Whether a fault says that a term is defined nowhere.
fn undefined(fault: &Fault) -> bool {
    matches!(
        *fault.problem,
        Problem::IndexOutside { .. } | Problem::ZeroDivisor { .. }
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

/// That the indices of all members of families in a statement are in their ranges, where these name integers.
fn index_ranges(
    statement: &Statement,
    claim: &core::Claim,
    evaluator: &Evaluator<'_>,
) -> Vec<Constraint> {
    let mut found = vec![];
    let sides = decide::comparisons(statement).into_iter();
    for value in sides.flat_map(|(left, right)| [left, right]) {
        let entries = value.entries().into_iter();
        let symbols = entries.filter_map(|q| Some(q.as_fraction()?.symbols()));
        for symbol in symbols.flatten() {
            let Symbol::Indexed(name, index) = &symbol else {
                continue;
            };
            let Some(SymbolKind::Family { ranges, .. }) = claim.symbols.get(name) else {
                continue;
            };
            for (index, (least, most)) in index.iter().zip(ranges) {
                for gap in [index.clone() - least.clone(), most.clone() - index.clone()] {
                    let gap = evaluator.affine_fixed(&gap);
                    if gap.as_number().is_none_or(|n| n < 0) {
                        found.push(Constraint {
                            value: polynomial_of(&gap).into(),
                            relation: Relation::AtLeast,
                        });
                    }
                }
            }
        }
    }
    found
}

/// Whether a condition is a factor of a divisor.
fn divides(condition: &Polynomial, divisor: &Polynomial) -> bool {
    condition == divisor
        || condition.len() < divisor.len() && divisor.exact_quotient(condition).is_some()
}

/// The divisors, factor by factor, with radicands for roots, which vanish where these do.
fn unrooted(divisors: &[Polynomial], ground: &ProofContext<'_>) -> Vec<Polynomial> {
    let roots = &ground.branch.domain.roots;
    let plain: Vec<Polynomial> = divisors.iter().map(|p| roots::unrooted(p, roots)).collect();
    conditions::separated(&plain)
}

/// The conditions, factor by factor, that neither the hypotheses state nor the domain implies: divisors of the statement, and
/// those of eliminations, of which what they made of the claim says nothing.
fn open_conditions(mut conditions: Vec<Polynomial>, ground: &ProofContext<'_>) -> Vec<Polynomial> {
    let domain = &ground.branch.domain;
    let pivots = domain.pivots();
    let settled = |p: &Polynomial| {
        pivots.iter().any(|pivot| divides(p, pivot))
            || domain.assumes_nonzero(p)
            || sign::never_zero(&domain.without_assumed(p), domain)
            || roots::norm(p, &domain.roots).is_some_and(|norm| domain.assumes_nonzero(&norm))
    };
    conditions.retain(|p| !settled(p));
    conditions.extend(ground.branch.splits().iter().cloned());
    conditions.retain(|_| !injected(InjectedFault::ConditionDropped));
    conditions.sort();
    conditions.dedup();
    conditions
}
