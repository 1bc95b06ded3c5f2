//! Basis functions of core terms, from the seeds.

use super::scope::Scope;
use super::terms::{Number, Terms};
use std::rc::Rc;
use std::sync::Arc;
use torse_core::{Family, Variable, stack};
use torse_semantics::{Class, NoValue, Series, Undefined, Unknown, Value};

/// Maximum degree.
const MAX_DEGREE: i64 = 60;

impl Terms<'_> {
    /// Returns all functions of a degree at these arguments, row by row from the seeds: `g[i,j+1] = a g[i,j] + b
    /// g[i-1,j]`.
    pub fn row(
        &self,
        family: &Arc<Family>,
        degree: i64,
        arguments: Vec<Value<Class>>,
        scope: &Scope<'_>,
    ) -> Result<Rc<[Series<Class>]>, NoValue> {
        if degree < i64::from(family.degree) {
            return Err(Undefined::BelowSeeds {
                name: family.name.to_string(),
                degree,
                least: family.degree,
            }
            .into());
        }
        if degree > MAX_DEGREE {
            return Err(Unknown::Large { what: "a degree" }.into());
        }
        let family_key = (Arc::as_ptr(family).addr(), scope.moved_as);
        let key = (family_key, degree, arguments);
        // If seeds or step depend on a binder, the arguments alone do not determine the functions.
        let alike = family.closed;
        if alike && let Some((_, known)) = self.rows.borrow().iter().find(|(own, _)| *own == key) {
            return Ok(Rc::clone(known));
        }
        let row =
            stack::deep(|| self.recursion(family, degree, (&family.variables, &key.2), scope));
        let row: Rc<[_]> = row?.into();
        if alike {
            let mut rows = self.rows.borrow_mut();
            if rows.len() >= 24 {
                rows.remove(0);
            }
            rows.push((key, Rc::clone(&row)));
        }
        Ok(row)
    }

    fn recursion(
        &self,
        family: &Family,
        degree: i64,
        (variables, arguments): (&[Variable], &[Value<Class>]),
        scope: &Scope<'_>,
    ) -> Result<Vec<Series<Class>>, NoValue> {
        if let (Some((variable, variables)), Some((argument, arguments))) =
            (variables.split_first(), arguments.split_first())
        {
            let inside = scope.with(variable, argument.clone());
            return self.recursion(family, degree, (variables, arguments), &inside);
        }
        let seeds = family.seeds.iter().map(|seed| self.number(seed, scope));
        let mut row = seeds.collect::<Result<Vec<_>, _>>()?;
        let factors = [&family.step.0, &family.step.1];
        if family.counters.is_none() && degree > i64::from(family.degree) {
            // The factors are the same for all functions.
            let [keep, shift] = factors;
            let factors = [self.number(keep, scope)?, self.number(shift, scope)?];
            for k in i64::from(family.degree) + 1..=degree {
                let next = (0..=k).map(|i| {
                    self.next(&row, i, &|part| {
                        factors
                            .get(part)
                            .cloned()
                            .ok_or_else(|| NoValue::shape("a step"))
                    })
                });
                row = next.collect::<Result<_, _>>()?;
            }
            return Ok(row);
        }
        for k in i64::from(family.degree) + 1..=degree {
            let next = (0..=k).map(|i| {
                let Some((index, order)) = &family.counters else {
                    return Err(NoValue::shape("a step"));
                };
                let scope = scope.with(order, self.integer_value(k));
                let scope = scope.with(index, self.integer_value(i));
                self.next(&row, i, &|part| {
                    let factor = factors.get(part).ok_or_else(|| NoValue::shape("a step"))?;
                    self.number(factor, &scope)
                })
            });
            row = next.collect::<Result<_, _>>()?;
        }
        Ok(row)
    }

    /// Returns a function from those of one degree less; a factor whose coefficient is zero is not evaluated.
    fn next(
        &self,
        before: &[Series<Class>],
        index: i64,
        factor: &dyn Fn(usize) -> Number,
    ) -> Number {
        let a = self.arithmetic;
        let at = |place: i64| usize::try_from(place).ok().and_then(|p| before.get(p));
        let mut sum = Series::integer(0, a);
        for (part, function) in [at(index), at(index - 1)].into_iter().enumerate() {
            if let Some(function) = function {
                sum = sum.plus(&factor(part)?.times(function, a)?, a)?;
            }
        }
        Ok(sum)
    }
}
