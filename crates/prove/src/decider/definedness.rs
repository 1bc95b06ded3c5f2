//! Where the terms of a statement have values, if it is decided for each value of some integers.

use super::{Decider, Instance};
use crate::context::ProofContext;
use crate::decide::{Decision, instances};
use crate::divisors::{divisors, open_conditions, unrooted};
use crate::term_divisors::term_divisors;
use torse_algebra::{Polynomial, Symbol};
use torse_core as core;
use torse_syntax::fault::{Fault, Problem};

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
            false => Decision::Open {
                reason: format!("a divisor is zero for {}", instances::label(first)),
                tried: vec![],
            },
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

    /// What the statement divides by, whatever the values of integers are, as far as no hypothesis says that it is not zero; `None` where a
    /// hypothesis is solved by dividing, or there is no formula for all integers.
    pub(crate) fn definedness(&self, statement: &core::Statement) -> Option<Vec<Polynomial>> {
        let ground = self.ground(&Instance::new()).ok()?;
        let value = ground.branch.evaluator.truth(statement).ok()?;
        let written = self.term_divisors(statement, &ground);
        let divisors = unrooted(&[divisors(&value), written].concat(), &ground);
        let is_whole = ground.branch.splits().is_empty();
        is_whole.then(|| open_conditions(divisors, &ground))
    }
}
