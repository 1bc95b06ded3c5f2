//! Sums: `sum(i, low, high, term)`.
//!
//! A sum over a known number of terms is added up. A sum over a symbolic range becomes a series when
//! its terms are members of a family of that degree, or binomial terms
//! `binom(n, i) u^(n-i) v^i = [E^i] (u + v E)^n`.

use super::quantity::Quantity;
use super::series::{Axis, Series, Target, here, split, with_index};
use super::value::{Value, Vector};
use super::{Environment, Evaluator, fitted, refilled, wrong_type};
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::{Affine, Fraction};
use torse_core::{BuiltIn, Node, Term, Variable};
use torse_syntax::fault::Fault;
use torse_syntax::formula::{Operator, Place};

/// The most terms that are added one by one.
const MAX_TERMS: i64 = 400;

impl Evaluator<'_> {
    /// The value of `sum(index, low, high, term)`.
    pub(super) fn sum(
        &self,
        index: &Variable,
        low: &Term,
        high: &Term,
        term: &Term,
        place: Place,
        bound: &Environment,
    ) -> Result<Value, Fault> {
        let (low, high) = (self.index(low, bound)?, self.index(high, bound)?);
        let Some(length) = (high.clone() - low.clone()).as_number() else {
            return self.symbolic_sum(index, &low, &high, term, place, bound);
        };
        if length >= MAX_TERMS {
            return Err(Fault::limit(
                place,
                format!("a sum of {} terms", length + 1),
            ));
        }
        let mut total: Option<Value> = None;
        let length = match injected(InjectedFault::EmptySumHasTerm) {
            true => length.max(0),
            false => length,
        };
        for offset in 0..=length {
            let here = low.clone() + Affine::number(offset);
            let mut inner = bound.clone();
            inner.insert(
                index.number(),
                Fraction::from(super::series::polynomial_of(&here)).into(),
            );
            let value = self.value(term, &inner)?;
            total = Some(match total {
                None => value,
                Some(sum) => added(&sum, &value, place)?,
            });
        }
        Ok(total.unwrap_or_else(|| Fraction::zero().into()))
    }

    fn symbolic_sum(
        &self,
        index: &Variable,
        low: &Affine,
        high: &Affine,
        term: &Term,
        place: Place,
        bound: &Environment,
    ) -> Result<Value, Fault> {
        let name = self.fresh(index.name());
        let mut inner = bound.clone();
        inner.insert(index.number(), Fraction::named(&name).into());
        let range = (name.clone(), low.clone(), high.clone());
        self.sums.borrow_mut().push(range);
        let value = match self.binomial_term(&name, term, &inner) {
            Ok(Some(value)) => Ok(value),
            Ok(None) => self.value(term, &inner),
            Err(fault) => Err(fault),
        };
        self.sums.borrow_mut().pop();
        let value = value?;
        // A divisor that depends on the index is a condition of every single term, not of the sum.
        let inside = |q: &&Quantity| {
            let mut divisors = q.conditions().into_iter();
            divisors.any(|p| p.symbols().iter().any(|s| s.depends_on(&name)))
        };
        if value.entries().iter().any(inside) {
            return Err(Fault::limit(
                place,
                "a sum of symbolic length over terms with divisors that depend on the index",
            ));
        }
        value.mapped(&|q: &Quantity| self.summed(q, &name, low, high, place))
    }

    /// Turns every entry series of a term into a sum series.
    fn summed(
        &self,
        term: &Quantity,
        index: &str,
        low: &Affine,
        high: &Affine,
        place: Place,
    ) -> Result<Quantity, Fault> {
        let refused = || Fault::limit(place, "this sum of symbolic length has no closed form here");
        let mut result = match term.plain.is_zero() {
            true => term.plain.clone().into(),
            false => {
                let each = self.each(&term.plain, index, low, high);
                each.ok_or_else(refused)?
            }
        };
        for series in &term.series {
            if let Some(swapped) = self.swapped(series, index, low, high) {
                result = result.plus(&swapped);
                continue;
            }
            for part in self.summed_series(series, index, low, high, place)? {
                result = result.plus(&self.settled(Quantity::from(part), place)?);
            }
        }
        Ok(result)
    }

    /// The sum over all values of `index` of a series with one entry that counts with the index.
    fn summed_series(
        &self,
        series: &Series,
        index: &str,
        low: &Affine,
        high: &Affine,
        place: Place,
    ) -> Result<Vec<Series>, Fault> {
        let refused = || Fault::limit(place, "this sum of symbolic length has no closed form here");
        // The index may count the coefficients, and nothing else: a step, a seed or a degree that depends on it makes
        // another operator of every term.
        let depends = series.axes.iter().any(|axis| axis.depends_on(index));
        if depends && !injected(InjectedFault::IndexLeftFree) {
            return Err(refused());
        }
        let (position, axis) = bearer(&series.axes, index).ok_or_else(refused)?;
        let Target::Entry(entry) = &axis.target else {
            return Err(refused());
        };
        let offset = (entry.clone() - Affine::symbol(index))
            .as_number()
            .ok_or_else(refused)?;
        // All coefficients must be inside the range: the sum is over the whole series.
        let starts = (low.clone() + Affine::number(offset - axis.lowest))
            .as_number()
            .is_some_and(|n| n <= 0);
        let ends = self
            .declarations
            .least(&(high.clone() + Affine::number(offset) - axis.top()))
            .is_some_and(|n| n >= 0);
        if !starts || !ends {
            return Err(refused());
        }
        // [E^(i + offset)] F applied to term(i) is [E^j] F applied to term(j - offset).
        let shifted = Affine::symbol(&here(position)) - Affine::number(offset);
        let moved = |points: &Fraction| {
            with_index(points, index, &shifted).map_err(|e| Fault::exact(place, e))
        };
        let whole = Axis {
            target: Target::Sum,
            ..axis.clone()
        };
        let mut result = vec![];
        for part in split(&series.factor, index).ok_or_else(refused)? {
            let summed = Series {
                factor: part.free,
                points: moved(&(series.points.clone() * part.points))?,
                ..series.with_axis(position, whole.clone())
            };
            result.extend(summed.weighted(position, offset, part.exponent));
        }
        Ok(result)
    }

    /// The term `binom(n, i) u^(n - i + c) v^(i + d) * rest` as an entry of `(u + v E)^n`, if it is one.
    fn binomial_term(
        &self,
        index: &str,
        term: &Term,
        bound: &Environment,
    ) -> Result<Option<Value>, Fault> {
        let mut factors = vec![];
        flatten(term, &mut factors);
        let here = Affine::symbol(index);
        let is_binomial = |e: &Term| matches!(&*e.node, Node::Apply(BuiltIn::Binomial, _));
        let Some(position) = factors.iter().position(|e| is_binomial(e)) else {
            return Ok(None);
        };
        let Node::Apply(_, arguments) = &*factors.remove(position).node else {
            return Ok(None);
        };
        let [top, bottom] = arguments.as_slice() else {
            return Ok(None);
        };
        let (power, chosen) = (self.index(top, bound)?, self.index(bottom, bound)?);
        let (Some(shift), None) = (
            (chosen.clone() - here.clone()).as_number(),
            power.as_number(),
        ) else {
            return Ok(None);
        };
        // (u + v E)^n is a polynomial in E for n >= 0 alone.
        if self.declarations.least(&power).is_none_or(|n| n < 0) {
            return Ok(None);
        }
        // Bases with exponents n - chosen + c and chosen + d.
        let (mut falling, mut rising) = (None, None);
        let mut rest: Value = Fraction::integer(1).into();
        for factor in factors {
            if let Node::Binary(Operator::Power, base, exponent) = &*factor.node {
                let exponent = self.index(exponent, bound)?;
                let down = (exponent.clone() - (power.clone() - chosen.clone())).as_number();
                let up = (exponent.clone() - chosen.clone()).as_number();
                let slot = match (down, up) {
                    (Some(extra), _) if falling.is_none() => Some((&mut falling, extra)),
                    (_, Some(extra)) if rising.is_none() => Some((&mut rising, extra)),
                    _ => None,
                };
                if let Some((slot, extra)) = slot {
                    let value = self.value(base, bound)?;
                    let Value::Scalar(q) = &value else {
                        return Ok(None);
                    };
                    let Some(base) = q.as_fraction().cloned() else {
                        return Ok(None);
                    };
                    let extra = i32::try_from(extra).ok().filter(|e| e.abs() <= 60);
                    let Some(extra) = extra else { return Ok(None) };
                    let more = base
                        .power(extra)
                        .map_err(|e| Fault::exact(factor.place, e))?;
                    rest = self.product(&rest, &more.into(), factor.place)?;
                    if !self.is_never_negative(&exponent) {
                        // The binomial is zero there, and the power has no value where its base is zero.
                        let divides = base.power(-1).map_err(|e| Fault::exact(factor.place, e))?;
                        let defined = Fraction::integer(1).under(divides.conditions());
                        rest = self.product(&rest, &defined.into(), factor.place)?;
                    }
                    *slot = Some(base);
                    continue;
                }
            }
            let value = self.value(factor, bound)?;
            rest = self.product(&rest, &value, factor.place)?;
        }
        let one = || Fraction::integer(1);
        let operator = (falling.unwrap_or_else(one), rising.unwrap_or_else(one));
        let index = here + Affine::number(shift);
        self.symbolic_degree.set(true);
        let series = Series::entry(Axis {
            operator,
            power,
            seeds: vec![one()],
            lowest: 0,
            target: Target::Entry(index),
        });
        Ok(Some(self.product(
            &rest,
            &Value::Scalar(series.into()),
            term.place,
        )?))
    }
}

impl Evaluator<'_> {
    /// Whether a form in the index of the innermost sum is at least 0 at both ends of the sum, whatever the integers are.
    fn is_never_negative(&self, form: &Affine) -> bool {
        let sums = self.sums.borrow();
        sums.last().is_some_and(|(index, low, high)| {
            [low, high].into_iter().all(|end| {
                let there = form.substituted(index, end);
                self.declarations.least(&there).is_some_and(|n| n >= 0)
            })
        })
    }
}

/// The factors of a product, numerators only; a quotient is kept whole.
fn flatten<'e>(term: &'e Term, into: &mut Vec<&'e Term>) {
    match &*term.node {
        Node::Binary(Operator::Multiply, a, b) => {
            flatten(a, into);
            flatten(b, into);
        }
        _ => into.push(term),
    }
}

/// The one axis whose entry depends on the index, read so that it counts up with the index; `None` if
/// there is no such axis or more than one.
fn bearer(axes: &[Axis], index: &str) -> Option<(usize, Axis)> {
    let multiple = |axis: &Axis| match &axis.target {
        Target::Entry(entry) => entry.multiple_of(index),
        Target::Sum | Target::Each(..) => 0,
    };
    let mut bearers = axes.iter().enumerate().filter(|(_, a)| multiple(a) != 0);
    let (position, axis) = bearers.next().filter(|_| bearers.next().is_none())?;
    let counts_down = multiple(axis) < 0;
    Some((
        position,
        if counts_down {
            axis.reversed()
        } else {
            axis.clone()
        },
    ))
}

fn added(a: &Value, b: &Value, place: Place) -> Result<Value, Fault> {
    if matches!((a, b), (Value::Truth(_), _) | (_, Value::Truth(_))) {
        return Err(wrong_type(place, b.kind(), "numbers or vectors"));
    }
    let (a, b) = fitted(a, b, place)?;
    let sums = a
        .entries()
        .into_iter()
        .zip(b.entries())
        .map(|(x, y)| x.plus(y))
        .collect();
    refilled(&a, sums)
}

/// A vector of quantities.
pub(super) fn vector(entries: Vec<Quantity>) -> Value {
    Value::Vector(Vector {
        entries,
        generic: false,
    })
}
