//! Bases whose step depends on the index and the degree, such as the B-splines of a knot vector on one of its spans.
//!
//! Their functions are no coefficients of a power, so degree and index have to be numbers; the recursion is carried out
//! as it stands. A factor is looked at only where there is a function that it multiplies.

use super::{Environment, Evaluator, wrong_type};
use crate::evaluate::value::Value;
use torse_algebra::Fraction;
use torse_core::{Family, Term, Variable};
use torse_syntax::fault::Fault;
use torse_syntax::formula::Place;

/// The work of one function, in units of a visited node.
const FUNCTION_WORK: u64 = 1_500;

/// That a statement needs more of such a basis than its functions of numeric degree.
pub(super) fn refused(family: &Family, place: Place) -> Fault {
    let name = &family.name;
    let what = format!("the basis {name} at a symbolic degree: its step depends on the index");
    Fault::limit(place, what)
}

impl Evaluator<'_> {
    /// All functions after so many steps from the seeds.
    pub(super) fn counted(
        &self,
        family: &Family,
        (index, order): &(Variable, Variable),
        values: &[Fraction],
        steps: usize,
        (place, outside): (Place, &Environment),
    ) -> Result<Vec<Fraction>, Fault> {
        let mut bound = self.arguments(family, values, outside);
        let mut row = vec![];
        for seed in &family.seeds {
            row.push(self.factor(seed, place, &bound)?);
        }
        for step in 1..=steps {
            let degree = usize::from(family.degree) + step;
            bound.insert(order.number(), counter(degree));
            let mut next = vec![];
            for i in 0..=degree {
                self.spend(FUNCTION_WORK);
                bound.insert(index.number(), counter(i));
                let earlier = i.checked_sub(1).and_then(|i| row.get(i));
                let mut sum = Fraction::zero();
                for (factor, function) in [(&family.step.0, row.get(i)), (&family.step.1, earlier)]
                {
                    if let Some(function) = function {
                        let factor = self.factor(factor, place, &bound)?;
                        sum = sum + factor * function.clone();
                    }
                }
                next.push(sum);
            }
            row = next;
        }
        Ok(row)
    }

    /// The variables of a family at its arguments.
    pub(super) fn arguments(
        &self,
        family: &Family,
        values: &[Fraction],
        outside: &Environment,
    ) -> Environment {
        let mut bound = match family.closed {
            true => Environment::new(),
            false => outside.clone(),
        };
        for (variable, value) in family.variables.iter().zip(values) {
            bound.insert(variable.number(), value.clone().into());
        }
        bound
    }

    /// A seed or a factor of a step.
    pub(super) fn factor(
        &self,
        term: &Term,
        place: Place,
        bound: &Environment,
    ) -> Result<Fraction, Fault> {
        match self.value(term, bound)? {
            Value::Scalar(q) => q
                .as_fraction()
                .cloned()
                .ok_or_else(|| super::symbolic_degree(place)),
            other => Err(wrong_type(term.place, other.kind(), "a number")),
        }
    }
}

fn counter(n: usize) -> Value {
    Fraction::integer(i64::try_from(n).unwrap_or(i64::MAX)).into()
}
