//! Sums: `sum(i, low, high, term)`.
//!
//! A sum over a known number of terms is added up. A sum over a symbolic range becomes a series when
//! its terms are members of a family of that degree, or binomial terms
//! `binom(n, i) u^(n-i) v^i = [E^i] (u + v E)^n`.

use super::fault::Fault;
use super::quantity::Quantity;
use super::series::{HERE, Series, Target, with_index};
use super::value::{Value, Vector};
use super::{Bindings, Evaluator, fitted, refilled, wrong_type};
use crate::syntax::{Expr, Node, Operator, Place};
use torse_algebra::{Affine, Fraction, Symbol};

/// The most terms that are added one by one.
const MAX_TERMS: i64 = 400;

impl Evaluator<'_> {
    /// The value of `sum(index, low, high, term)`.
    pub(super) fn sum(
        &self,
        index: &str,
        low: &Expr,
        high: &Expr,
        term: &Expr,
        place: Place,
        bound: &Bindings,
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
        for offset in 0..=length {
            let here = low.clone() + Affine::number(offset);
            let mut inner = bound.clone();
            inner.insert(
                index.to_owned(),
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
        index: &str,
        low: &Affine,
        high: &Affine,
        term: &Expr,
        place: Place,
        bound: &Bindings,
    ) -> Result<Value, Fault> {
        let name = format!("{index}\u{b0}");
        let mut inner = bound.clone();
        inner.insert(index.to_owned(), Fraction::named(&name).into());
        let value = match self.binomial_term(&name, term, &inner)? {
            Some(value) => value,
            None => self.value(term, &inner)?,
        };
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
        if !term.plain.is_zero() {
            return Err(refused());
        }
        let mut result = Quantity::from(Fraction::zero());
        for series in &term.series {
            let Target::Entry(entry) = &series.target else {
                return Err(refused());
            };
            let here = Affine::symbol(index);
            let offset = (entry.clone() - here.clone())
                .as_number()
                .ok_or_else(refused)?;
            // All coefficients must be inside the range: the sum is over the whole series.
            let top = series.power.clone()
                + Affine::number(
                    series.lowest + i64::try_from(series.seeds.len()).unwrap_or(i64::MAX) - 1,
                );
            let starts = (low.clone() + Affine::number(offset - series.lowest))
                .as_number()
                .is_some_and(|n| n <= 0);
            let ends = self
                .declarations
                .least(&(high.clone() + Affine::number(offset) - top))
                .is_some_and(|n| n >= 0);
            if !starts || !ends {
                return Err(refused());
            }
            // [E^(i + offset)] F applied to term(i) is [E^j] F applied to term(j - offset).
            let shifted = Affine::symbol(HERE) - Affine::number(offset);
            for (factor, points) in split(&series.factor, index).ok_or_else(refused)? {
                let points =
                    with_index(&points, index, &shifted).map_err(|e| Fault::exact(place, e))?;
                let part = Series {
                    factor,
                    target: Target::Sum(points),
                    ..series.clone()
                };
                result = result.plus(&self.settled(Quantity::from(part), place)?);
            }
        }
        Ok(result)
    }

    /// The term `binom(n, i) u^(n - i + c) v^(i + d) * rest` as an entry of `(u + v E)^n`, if it is one.
    fn binomial_term(
        &self,
        index: &str,
        term: &Expr,
        bound: &Bindings,
    ) -> Result<Option<Value>, Fault> {
        let mut factors = vec![];
        flatten(term, &mut factors);
        let here = Affine::symbol(index);
        let is_binomial = |e: &Expr| {
            matches!(&e.node, Node::Call(head, arguments)
            if matches!(&head.node, Node::Name(n) if n == "binom") && arguments.len() == 2)
        };
        let Some(position) = factors.iter().position(|e| is_binomial(e)) else {
            return Ok(None);
        };
        let Node::Call(_, arguments) = &factors.remove(position).node else {
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
        // Bases with exponents n - chosen + c and chosen + d.
        let (mut falling, mut rising) = (None, None);
        let mut rest: Value = Fraction::integer(1).into();
        for factor in factors {
            if let Node::Binary(Operator::Power, base, exponent) = &factor.node {
                let exponent = self.index(exponent, bound)?;
                let down = (exponent.clone() - (power.clone() - chosen.clone())).as_number();
                let up = (exponent - chosen.clone()).as_number();
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
        let series = Series {
            operator,
            power,
            seeds: vec![one()],
            lowest: 0,
            factor: one(),
            target: Target::Entry(index),
        };
        Ok(Some(self.product(
            &rest,
            &Value::Scalar(series.into()),
            term.place,
        )?))
    }
}

/// The factors of a product, numerators only; a quotient is kept whole.
fn flatten<'e>(expr: &'e Expr, into: &mut Vec<&'e Expr>) {
    match &expr.node {
        Node::Binary(Operator::Multiply, a, b) => {
            flatten(a, into);
            flatten(b, into);
        }
        _ => into.push(expr),
    }
}

/// Writes a factor as a sum of (free of the index) * (points at the index).
fn split(factor: &Fraction, index: &str) -> Option<Vec<(Fraction, Fraction)>> {
    use torse_algebra::Polynomial;
    let denominator_free = factor
        .denominator_factors()
        .all(|(p, _)| !p.symbols().iter().any(|s| s.depends_on(index)));
    if !denominator_free {
        return None;
    }
    let mut groups: std::collections::BTreeMap<Polynomial, Polynomial> =
        std::collections::BTreeMap::new();
    for term in factor.numerator().terms() {
        let (mut free, mut points) = (
            Polynomial::constant(&term.coefficient),
            Polynomial::integer(1),
        );
        for (symbol, exponent) in term.powers {
            let power = Polynomial::symbol(symbol.clone()).power(u32::from(exponent));
            match symbol {
                Symbol::Indexed(..) if symbol.depends_on(index) => points = &points * &power,
                _ if symbol.depends_on(index) => return None,
                _ => free = &free * &power,
            }
        }
        let entry = groups.entry(points).or_insert_with(Polynomial::zero);
        *entry = &*entry + &free;
    }
    let denominator: Fraction = factor.denominator().into();
    groups
        .into_iter()
        .map(|(points, free)| {
            let free = Fraction::from(free)
                .over(&denominator)
                .ok()?
                .under(factor.conditions());
            Some((free, Fraction::from(points)))
        })
        .collect()
}

fn added(a: &Value, b: &Value, place: Place) -> Result<Value, Fault> {
    if matches!(
        (a, b),
        (Value::Function(_) | Value::Truth(_), _) | (_, Value::Function(_) | Value::Truth(_))
    ) {
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
