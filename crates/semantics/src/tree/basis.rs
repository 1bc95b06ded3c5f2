//! Members of families, and basis functions: SEMANTICS.md, "Terms".

use super::environment::{Environment, Part};
use super::evaluate::{Evaluator, Outcome};
use crate::arithmetic::Arithmetic;
use crate::name::Name;
use crate::no_value::{NoValue, Undefined, Unknown};
use crate::series::Series;
use crate::value::Value;
use std::rc::Rc;
use std::sync::Arc;
use torse_numbers::Affine;
use torse_numbers::stack;
use torse_syntax::derivation::declarations::Basis;
use torse_syntax::formula::Expr;

/// The largest degree.
const MAX_DEGREE: i64 = 60;

type Place<'a, A> = Environment<'a, <A as Arithmetic>::Number>;
/// The functions of one degree.
pub(super) type Row<A> = Rc<[Series<<A as Arithmetic>::Number>]>;

impl<'a, A: Arithmetic> Evaluator<'a, '_, A> {
    /// A member of a family. It is undefined if an index is outside of its declared range; ranges are evaluated at
    /// the point, whatever is moved. For points with several coordinates, an additional index selects a coordinate.
    pub(super) fn member(
        &self,
        name: &'a str,
        dimension: Option<u8>,
        ranges: &[(Affine, Affine)],
        indices: &'a [Expr],
        place: &Place<'a, A>,
    ) -> Outcome<A> {
        let has_entry = !ranges.is_empty()
            && indices.len() == ranges.len() + 1
            && dimension.is_some_and(|n| n > 1);
        let (indices, entry) = indices.split_at(indices.len() - usize::from(has_entry));
        if !ranges.is_empty() && indices.len() != ranges.len() {
            return Err(NoValue::shape("a number of indices"));
        }
        let indices = indices.iter().map(|i| self.integer(i, "an index", place));
        let indices: Vec<i64> = indices.collect::<Result<_, _>>()?;
        self.check_ranges(name, ranges, &indices)?;
        let coordinate = |c| self.symbol(name, &Part::Member(indices.clone(), c), place);
        let value = match dimension {
            None | Some(1) => Value::Number(coordinate(None)?),
            Some(d) => {
                let all = (1..=d).map(|c| coordinate(Some(c)));
                Value::vector(all.collect::<Result<_, _>>()?)
            }
        };
        self.entry(value, entry, place)
    }

    /// Fails if an index is outside of its declared range.
    pub(super) fn check_ranges(
        &self,
        name: &str,
        ranges: &[(Affine, Affine)],
        indices: &[i64],
    ) -> Result<(), NoValue> {
        for (index, (low, high)) in indices.iter().zip(ranges) {
            let (low, high) = (self.form(low)?, self.form(high)?);
            if !(low..=high).contains(index) {
                return Err(Undefined::IndexOutside {
                    name: name.to_owned(),
                    index: *index,
                    low,
                    high,
                }
                .into());
            }
        }
        Ok(())
    }

    /// The value of an index form at the point.
    pub(super) fn form(&self, form: &Affine) -> Result<i64, NoValue> {
        let large = || Unknown::Large { what: "a bound" };
        let mut total = form.constant();
        for (name, multiple) in form.multiples() {
            let number = (self.point.values)(&Name::Symbol(Arc::from(name)));
            let number = number.ok_or_else(|| super::evaluate::no_value(name))?;
            let rational = self.arithmetic.as_rational(&number);
            let rational = rational.ok_or(Unknown::Precision)?;
            if !rational.is_integer() {
                return Err(Undefined::NoInteger { what: "a bound" }.into());
            }
            let value = i64::try_from(&rational.to_integer()).map_err(|_| large())?;
            let product = value.checked_mul(multiple).ok_or_else(large)?;
            total = total.checked_add(product).ok_or_else(large)?;
        }
        Ok(total)
    }

    /// The basis that a name denotes here.
    pub(super) fn basis_named(&self, name: &str, place: &Place<'a, A>) -> Option<&'a Basis> {
        let hidden = place.local(name).is_some() || self.declarations.definition(name).is_some();
        if hidden {
            return None;
        }
        self.declarations.basis(name).map(|basis| &**basis)
    }

    /// `B[i,k](x, mu)`: the function i of degree k. Arguments that are left out are the declared names, as they are
    /// outside of local bindings.
    pub(super) fn basis_function(
        &self,
        name: &str,
        basis: &'a Basis,
        indices: &'a [Expr],
        arguments: &'a [Expr],
        place: &Place<'a, A>,
    ) -> Outcome<A> {
        let [index, degree] = indices else {
            return Err(NoValue::shape("a number of indices"));
        };
        let mut values = vec![];
        for argument in arguments {
            values.push(self.value(argument, place)?);
        }
        values.extend(self.left_out(basis, arguments.len(), place)?);
        let index = self.integer(index, "an index", place)?;
        let degree = self.integer(degree, "a degree", place)?;
        let row = self.row(name, basis, degree, values, place)?;
        let function = usize::try_from(index).ok().and_then(|i| row.get(i));
        Ok(function.map_or_else(|| self.integer_value(0), |f| Value::Number(f.clone())))
    }

    /// The values of the arguments of a basis from this position on, by their names.
    pub(super) fn left_out(
        &self,
        basis: &'a Basis,
        from: usize,
        place: &Place<'a, A>,
    ) -> Result<Vec<Value<A::Number>>, NoValue> {
        if from > basis.parameters.len() + 1 {
            return Err(NoValue::shape("a number of arguments"));
        }
        let names = std::iter::once(&basis.variable).chain(&basis.parameters);
        let outside = place.outside();
        let values = names
            .skip(from)
            .map(|name| self.named_value(name, &outside));
        values.collect()
    }

    /// All functions of one degree, computed from the seeds by `g[i,k] = a g[i,k-1] + b g[i-1,k-1]`.
    pub(super) fn row(
        &self,
        name: &str,
        basis: &'a Basis,
        degree: i64,
        arguments: Vec<Value<A::Number>>,
        place: &Place<'a, A>,
    ) -> Result<Row<A>, NoValue> {
        let least = i64::from(basis.degree);
        if degree < least || (basis.is_list && degree != least) {
            return Err(Undefined::BelowSeeds {
                name: name.to_owned(),
                degree,
                least: basis.degree,
            }
            .into());
        }
        if degree > MAX_DEGREE {
            return Err(Unknown::Large { what: "a degree" }.into());
        }
        let outside = place.outside();
        let Some(first) = basis.seeds.first() else {
            return Err(NoValue::shape("a basis without functions"));
        };
        let parts = || {
            let steps = [&basis.step.0, &basis.step.1];
            let parts = basis.seeds.iter().chain(steps);
            parts.map(|part| &part.expr).collect()
        };
        let key = (degree, arguments);
        self.remembered_row(&first.expr, key, &outside, parts, |arguments| {
            let names = std::iter::once(&basis.variable).chain(&basis.parameters);
            let bound = names.zip(arguments);
            let inside = bound.fold(outside.clone(), |inside, (name, value)| {
                inside.with_local(name, value.clone(), false)
            });
            stack::deep(|| self.recursion(basis, degree, &inside)).map(Rc::from)
        })
    }

    fn recursion(
        &self,
        basis: &'a Basis,
        degree: i64,
        inside: &Place<'a, A>,
    ) -> Result<Vec<Series<A::Number>>, NoValue> {
        let a = self.arithmetic;
        let _deeper = self.deeper()?;
        let seeds = basis.seeds.iter();
        let mut row: Vec<Series<A::Number>> = seeds
            .map(|seed| self.number(&seed.expr, inside))
            .collect::<Result<_, _>>()?;
        let (keep, shift) = (&basis.step.0.expr, &basis.step.1.expr);
        // If the step does not depend on index and degree, its factors are evaluated once.
        let mut factors = None;
        for k in i64::from(basis.degree) + 1..=degree {
            let mut next = Vec::with_capacity(row.len() + 1);
            for i in 0..=k {
                let [keep, shift] = match &basis.counters {
                    None => {
                        let known = match factors.take() {
                            None => [self.number(keep, inside)?, self.number(shift, inside)?],
                            Some(known) => known,
                        };
                        factors = Some(known.clone());
                        known.map(Some)
                    }
                    // A factor without a function to multiply is not evaluated.
                    Some((index, order)) => {
                        let inside = inside
                            .with_local(order, self.integer_value(k), true)
                            .with_local(index, self.integer_value(i), true);
                        let factor = |tree, counts: bool| {
                            counts.then(|| self.number(tree, &inside)).transpose()
                        };
                        [factor(keep, i < k)?, factor(shift, i > 0)?]
                    }
                };
                let at = |place: i64| usize::try_from(place).ok().and_then(|p| row.get(p));
                let mut sum = Series::integer(0, a);
                for (factor, function) in [(keep, at(i)), (shift, at(i - 1))] {
                    if let (Some(factor), Some(function)) = (factor, function) {
                        sum = sum.plus(&factor.times(function, a)?, a)?;
                    }
                }
                next.push(sum);
            }
            row = next;
        }
        Ok(row)
    }
}
