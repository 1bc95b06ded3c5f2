//! Where the terms of a statement have values, if it is decided for each value of some integers.

use super::{Decider, Instance};
use crate::context::{ProofContext, SolvePolicy};
use crate::decide::domain::{Constraint, Domain};
use crate::decide::root::Root;
use crate::decide::{Decision, instances};
use crate::divisors::{divisors, in_finest_parts, never_zero, open_conditions, unrooted};
use crate::evaluate::Evaluator;
use crate::evaluate::value::{Statement, Value};
use crate::roots;
use crate::term_divisors::term_divisors;
use std::collections::BTreeMap;
use std::rc::Rc;
use torse_algebra::{Polynomial, Symbol};
use torse_core as core;
use torse_syntax::fault::{Fault, Problem};
use torse_syntax::formula::Relation;

impl Decider<'_> {
    /// Whether a fault says that a term of the statement, and none of a hypothesis, divides by zero for these values of integers.
    pub(super) fn divides_by_zero(&self, fault: &Fault, instance: &Instance) -> bool {
        matches!(*fault.problem, Problem::ZeroDivisor { .. }) && self.ground(instance).is_ok()
    }

    /// A proof by values of integers for some of which a divisor of the statement is zero: under the conditions that the divisors of the
    /// statement as it stands are not, open where these do not exclude each of those values.
    pub(super) fn where_defined(
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
            false => Decision::open(
                format!("a divisor is zero for {}", instances::label(first)),
                &[],
            ),
        }
    }

    /// What the terms of the statement divide by, as they are written.
    pub(super) fn term_divisors(
        &self,
        statement: &core::Statement,
        ground: &ProofContext<'_>,
    ) -> Vec<Polynomial> {
        term_divisors(statement, &self.claim, &ground.branch.evaluator)
    }

    /// The domain where the statement itself has a value: a proof is asked for nothing else, and these divisors are among its conditions.
    pub(super) fn where_it_has_a_value<'g>(
        &self,
        statement: &core::Statement,
        value: &Statement,
        ground: &ProofContext<'g>,
    ) -> Domain<'g> {
        let mut there = ground.branch.domain.clone();
        for divisor in [divisors(value), self.term_divisors(statement, ground)].concat() {
            there.constraints.push(Constraint {
                value: divisor.into(),
                relation: Relation::Different,
            });
        }
        there
    }

    /// What the statement divides by, whatever the values of integers are, as far as no hypothesis says that it is not zero; as it is
    /// written where a hypothesis is solved by dividing. Where there is no formula for all integers, what it divides by for each value
    /// of those with short ranges; `None` where there is none for these.
    pub(crate) fn definedness(&self, statement: &core::Statement) -> Option<Vec<Polynomial>> {
        let all = self.definedness_at(statement, &Instance::new());
        all.or_else(|| {
            let instances = self.finite_instances()?;
            let each = instances.iter();
            let each = each.map(|instance| self.definedness_at(statement, instance));
            Some(each.collect::<Option<Vec<_>>>()?.concat())
        })
    }

    fn definedness_at(
        &self,
        statement: &core::Statement,
        instance: &Instance,
    ) -> Option<Vec<Polynomial>> {
        let ground = self.ground(instance).ok()?;
        if !ground.branch.splits().is_empty() {
            let mut written = self.written_divisors(statement)?;
            written.retain(|p| self.may_vanish(p));
            return Some(written);
        }
        let value = ground.branch.evaluator.truth(statement).ok()?;
        let written = self.term_divisors(statement, &ground);
        let divisors = unrooted(&[divisors(&value), written].concat(), &ground);
        Some(open_conditions(divisors, &ground))
    }

    /// What the statement divides by, before any symbol has a value.
    pub(crate) fn written_divisors(&self, statement: &core::Statement) -> Option<Vec<Polynomial>> {
        let evaluator = Evaluator::with(Rc::clone(&self.elaborator));
        let mut roots = vec![];
        for (name, radicand) in self.claim.roots() {
            let Value::Scalar(radicand) = evaluator.term(radicand).ok()? else {
                return None;
            };
            roots.push(Root {
                symbol: Symbol::named(name),
                radicand: radicand.as_fraction()?.clone(),
            });
        }
        let value = evaluator.truth(statement).ok()?;
        let written = term_divisors(statement, &self.claim, &evaluator);
        let all = [divisors(&value), written].concat();
        let plain: Vec<Polynomial> = all.iter().map(|p| roots::unrooted(p, &roots)).collect();
        Some(in_finest_parts(&plain))
    }

    /// Whether nothing says that a polynomial in the symbols as they are written is not zero on the domain.
    pub(crate) fn may_vanish(&self, polynomial: &Polynomial) -> bool {
        let elaborator = Rc::clone(&self.elaborator);
        let (nothing, how) = (BTreeMap::new(), SolvePolicy::Safely);
        let ground = ProofContext::assumed(&self.claim, elaborator, &nothing, how, &[]);
        let Ok(ground) = ground else {
            return true;
        };
        let Ok(there) = ground.branch.resolved(&polynomial.clone().into()) else {
            return true;
        };
        let factors = unrooted(std::slice::from_ref(there.numerator()), &ground);
        !factors.iter().all(|factor| never_zero(factor, &ground))
    }
}
