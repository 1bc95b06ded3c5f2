//! Members of a basis family: `g[i,k](x, mu, nu)`.

use super::quantity::Quantity;
use super::series::{Axis, Series, Target};
use super::value::Value;
use super::{Environment, Evaluator, indexed_recurrence, wrong_type};
use std::rc::Rc;
use std::sync::Arc;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::{Affine, Fraction};
use torse_core::{Family, Term};
use torse_syntax::fault::{Fault, Problem};
use torse_syntax::formula::Place;

/// The work of one step of the recursion, in units of a visited node.
const ROW_WORK: u64 = 1_500;

impl Evaluator<'_> {
    /// The function of this index and degree at its arguments.
    pub(super) fn member(
        &self,
        family: &Family,
        index: &Term,
        degree: &Term,
        arguments: &[Term],
        place: Place,
        bound: &Environment,
    ) -> Result<Value, Fault> {
        let name = &*family.name;
        let (index, degree) = (self.index(index, bound)?, self.index(degree, bound)?);
        let mut values = vec![];
        for argument in arguments {
            match self.in_angle(|| self.value(argument, bound))? {
                Value::Scalar(q) => match q.as_fraction() {
                    Some(f) => values.push(f.clone()),
                    None => return Err(super::symbolic_degree(argument.place)),
                },
                other => return Err(wrong_type(argument.place, other.kind(), "a number")),
            }
        }
        let power = degree.clone() - Affine::number(i64::from(family.degree));
        if let Some(n) = power.as_number() {
            let n = match injected(InjectedFault::DegreeBelowSeeds) {
                true => n.max(0),
                false => n,
            };
            let Ok(steps) = usize::try_from(n) else {
                let range = format!("{}..", family.degree);
                let name = format!("the degree of {name}");
                return Err(Fault::at(
                    place,
                    Problem::IndexOutside {
                        name,
                        index: degree.to_string(),
                        range,
                    },
                ));
            };
            let Some(position) = index.as_number() else {
                return Err(Fault::limit(
                    place,
                    format!("the function of index {index} of degree {degree}"),
                ));
            };
            if steps > 60 {
                return Err(Fault::limit(
                    place,
                    format!("degree {degree} is larger than 60"),
                ));
            }
            let row = self.row(family, steps, values, place, bound)?;
            let entry = usize::try_from(position)
                .ok()
                .and_then(|i| row.get(i).cloned());
            // Outside 0..k the functions are zero by convention, where the others have a value.
            let zero = || row.iter().fold(Fraction::zero(), keep_conditions);
            return Ok(entry.unwrap_or_else(zero).into());
        }
        // The operator is a power: it says nothing below the degree of the seeds.
        if self.declarations.least(&power).is_none_or(|n| n < 0) {
            return Err(Fault::limit(
                place,
                format!(
                    "the degree {degree} of {name} may be less than {}",
                    family.degree
                ),
            ));
        }
        let (operator, seeds) = self.in_angle(|| self.seeds(family, &values, place, bound))?;
        self.symbolic_degree.set(true);
        // Where seeds or factors divide, the functions have no value, whatever becomes of the series.
        let divisors = seeds.iter().chain([&operator.0, &operator.1]);
        let defined = divisors.fold(Fraction::integer(1), keep_conditions);
        let series = Quantity::from(Series::entry(Axis {
            operator,
            power,
            seeds,
            lowest: 0,
            target: Target::Entry(index),
        }));
        Ok(Value::Scalar(self.settled(series.times(&defined), place)?))
    }

    /// Step factors and seeds of a family at values of its variable and shape parameters.
    ///
    /// # Errors
    /// [`Fault`] when a seed is no plain formula.
    pub fn family(
        &self,
        family: &Family,
        values: &[Fraction],
    ) -> Result<((Fraction, Fraction), Vec<Fraction>), Fault> {
        self.seeds(family, values, super::value::UNPLACED, &Environment::new())
    }

    /// Step factors and seeds at the arguments (variable first, then shape parameters).
    pub(super) fn seeds(
        &self,
        family: &Family,
        values: &[Fraction],
        place: Place,
        outside: &Environment,
    ) -> Result<((Fraction, Fraction), Vec<Fraction>), Fault> {
        let bound = self.arguments(family, values, outside);
        let one = |term: &Term| self.factor(term, place, &bound);
        if family.counters.is_some() {
            return Err(indexed_recurrence::refused(family, place));
        }
        let seeds = family
            .seeds
            .iter()
            .map(one)
            .collect::<Result<Vec<_>, _>>()?;
        Ok(((one(&family.step.0)?, one(&family.step.1)?), seeds))
    }

    /// All functions of one numeric degree at these arguments, at the sample point when sampling; remembered.
    fn row(
        &self,
        family: &Family,
        steps: usize,
        values: Vec<Fraction>,
        place: Place,
        bound: &Environment,
    ) -> Result<Rc<[Fraction]>, Fault> {
        let key = (Arc::clone(&family.name), steps, self.in_angle.get());
        let same = |own: &[Fraction]| {
            own.len() == values.len() && own.iter().zip(&values).all(|(x, y)| x.is_identical(y))
        };
        if family.closed
            && let Some(known) = self.members.borrow().get(&key)
            && let Some((_, row)) = known.iter().find(|(own, _)| same(own))
        {
            return Ok(Rc::clone(row));
        }
        let row = match &family.counters {
            Some(counters) => {
                self.in_angle(|| self.counted(family, counters, &values, steps, (place, bound)))?
            }
            None => self.raised(family, &values, steps, (place, bound))?,
        };
        // The functions of one degree have values together: where a seed or a factor divides by zero none has one.
        let all = row.iter().fold(Fraction::zero(), keep_conditions);
        let row = row.into_iter().map(|f| f.under(all.conditions()));
        let row: Rc<[Fraction]> = row.map(|f| self.at_sample(f)).collect();
        if family.closed {
            super::memory::lasting(place)?;
            let mut members = self.members.borrow_mut();
            members
                .entry(key)
                .or_default()
                .push((values, Rc::clone(&row)));
        }
        Ok(row)
    }

    /// All functions after so many steps from the seeds.
    fn raised(
        &self,
        family: &Family,
        values: &[Fraction],
        steps: usize,
        (place, bound): (Place, &Environment),
    ) -> Result<Vec<Fraction>, Fault> {
        let (operator, seeds) = self.in_angle(|| self.seeds(family, values, place, bound))?;
        self.spend(ROW_WORK * (1 + steps as u64));
        let mut row = seeds;
        for _ in 0..steps {
            let mut next = vec![Fraction::zero(); row.len() + 1];
            for (i, function) in row.iter().enumerate() {
                for (offset, factor) in [&operator.0, &operator.1].into_iter().enumerate() {
                    if let Some(slot) = next.get_mut(i + offset) {
                        *slot = &*slot + &(factor * function);
                    }
                }
            }
            row = next;
        }
        Ok(row)
    }
}

/// The first value, which is defined only where the second one is, too.
fn keep_conditions(value: Fraction, other: &Fraction) -> Fraction {
    value.under(other.conditions())
}
