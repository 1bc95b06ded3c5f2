//! Equations that follow from those among the hypotheses, without solving these.

use super::{Decider, Instance};
use crate::combination::multipliers;
use crate::context::{ProofContext, SolvePolicy};
use crate::decide::{self, equality, instances};
use crate::divisors::{open_conditions, unrooted};
use crate::evaluate::value::Statement;
use std::rc::Rc;
use torse_algebra::{Fraction, Polynomial};
use torse_certificate::identity::{Combination, Equations, Vanishing};
use torse_core as core;
use torse_syntax::formula::Relation;

impl Decider<'_> {
    /// An equation as a combination of the given ones, without solving these, if it is one, with the conditions that it
    /// leaves.
    pub(super) fn unsolved(
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
        let ground = ProofContext::assumed(
            &self.claim,
            elaborator,
            &fixed,
            SolvePolicy::Always,
            &self.nonzero,
        )
        .ok()?;
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
    pub(super) fn uneliminated(
        &self,
        statement: &core::Statement,
        instance: &Instance,
    ) -> Option<(ProofContext<'_>, Combination<Polynomial>, Vec<Polynomial>)> {
        if !self.claim.unknowns.is_empty() {
            return None;
        }
        let fixed = instances::fixed(instance);
        let elaborator = Rc::clone(&self.elaborator);
        let ground = ProofContext::assumed(
            &self.claim,
            elaborator,
            &fixed,
            SolvePolicy::Safely,
            &self.nonzero,
        )
        .ok()?;
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
}
