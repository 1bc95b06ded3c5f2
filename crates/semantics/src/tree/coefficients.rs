//! `coefficients`: SEMANTICS.md, "Terms".
//!
//! Every symbol is moved in turn, to first order, or to second order if linearity has to be checked. With given
//! equations the unknowns U are functions of the other symbols v, and the derivative is taken along the solutions:
//! `F_v + F_U a` with `G_U a = -G_v`.

use super::environment::{Environment, Part};
use super::evaluate::{Evaluator, Given, Outcome};
use crate::arithmetic::Arithmetic;
use crate::linear;
use crate::no_value::{NoValue, Undefined, Unknown};
use crate::series::Series;
use crate::value::{Value, transposed};
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{Connective, Expr, Node, Relation};

type Place<'a, A> = Environment<'a, <A as Arithmetic>::Number>;
type Numbers<A> = Vec<Series<<A as Arithmetic>::Number>>;
/// The values of forms in an environment.
type Values<'v, 'a, A> = dyn Fn(&Place<'a, A>) -> Result<Numbers<A>, NoValue> + 'v;
/// A number of the point: its symbol, and which number of the symbol.
type Moving<'a> = (&'a str, Part);

impl<'a, A: Arithmetic> Evaluator<'a, '_, A> {
    /// One row for each form, one column for each symbol.
    pub(super) fn coefficients(
        &self,
        forms: &'a Expr,
        symbols: &'a Expr,
        place: &Place<'a, A>,
    ) -> Outcome<A> {
        let moving = self.moving_parts(symbols, place)?;
        let value = |place: &Place<'a, A>| Ok(entries(&self.value(forms, place)?));
        let mut columns = vec![];
        let given = self.given.borrow().clone();
        match &given {
            None => {
                for part in &moving {
                    columns.push(self.linear_rates(part, place, &value)?);
                }
            }
            Some(given) => {
                // The equations themselves are evaluated without solutions put in.
                self.given.replace(None);
                let along = self.solutions(given, &moving, place);
                self.given.replace(Some(given.clone()));
                let along = along?;
                let free = self.unknowns(given, place)?;
                let mut by_unknown = vec![];
                for part in &free {
                    by_unknown.push(self.rates(part, 1, place, &value)?.0);
                }
                for (part, changes) in moving.iter().zip(along) {
                    let mut column = self.rates(part, 1, place, &value)?.0;
                    for (rates, change) in by_unknown.iter().zip(&changes) {
                        for (entry, rate) in column.iter_mut().zip(rates) {
                            let share = rate.times(change, self.arithmetic)?;
                            *entry = entry.plus(&share, self.arithmetic)?;
                        }
                    }
                    columns.push(column);
                }
            }
        }
        Ok(Value::matrix(transposed(&columns)))
    }

    /// First and second coefficients of numbers by one number that is moved.
    fn rates(
        &self,
        (symbol, part): &Moving<'a>,
        order: usize,
        place: &Place<'a, A>,
        value: &Values<'_, 'a, A>,
    ) -> Result<(Numbers<A>, Numbers<A>), NoValue> {
        let a = self.arithmetic;
        let own = self.symbol(symbol, part, place)?;
        let mut second = vec![];
        let first = self.at_new_level(|level| {
            let moved = own.shifted(level, order, a);
            let inside = self.moving(symbol, part.clone(), moved, place);
            let values = value(&inside)?;
            second = values.iter().map(|v| v.coefficient(level, 2, a)).collect();
            Ok(Value::vector(
                values.iter().map(|v| v.coefficient(level, 1, a)).collect(),
            ))
        })?;
        Ok((first.entries()?, second))
    }

    fn linear_rates(
        &self,
        part: &Moving<'a>,
        place: &Place<'a, A>,
        value: &Values<'_, 'a, A>,
    ) -> Result<Numbers<A>, NoValue> {
        let (first, second) = self.rates(part, 2, place, value)?;
        for coefficient in &second {
            match coefficient.is_zero(self.arithmetic) {
                Some(true) => {}
                Some(false) => return Err(Undefined::NotLinear.into()),
                None => return Err(Unknown::Precision.into()),
            }
        }
        Ok(first)
    }

    fn unknowns(
        &self,
        given: &Given<'a>,
        place: &Place<'a, A>,
    ) -> Result<Vec<Moving<'a>>, NoValue> {
        let mut all = vec![];
        for unknown in &given.unknowns {
            all.extend(self.moving_parts(unknown, &place.outside())?);
        }
        Ok(all)
    }

    /// For each symbol, the derivatives of the unknowns along the solutions of the equations.
    fn solutions(
        &self,
        given: &Given<'a>,
        moving: &[Moving<'a>],
        place: &Place<'a, A>,
    ) -> Result<Vec<Numbers<A>>, NoValue> {
        let a = self.arithmetic;
        let free = self.unknowns(given, place)?;
        if moving.iter().any(|part| free.contains(part)) {
            let what = "a coefficient of an unknown of the given equations";
            return Err(Unknown::NotCovered { what }.into());
        }
        let outside = place.outside();
        let mut equations = vec![];
        for tree in &given.equations {
            self.equations(tree, &mut equations)?;
        }
        let gaps = |place: &Place<'a, A>| {
            let mut gaps = vec![];
            for (left, right) in &equations {
                let (left, right) = (self.value(left, place)?, self.value(right, place)?);
                for (x, y) in left.pairs(&right, a)? {
                    gaps.push(x.minus(&y, a)?);
                }
            }
            Ok(gaps)
        };
        let columns = |parts: &[Moving<'a>]| -> Result<Vec<Numbers<A>>, NoValue> {
            let each = parts
                .iter()
                .map(|part| self.rates(part, 1, &outside, &gaps));
            each.map(|rates| Ok(rates?.0)).collect()
        };
        let (by_unknowns, by_symbols) = (columns(&free)?, columns(moving)?);
        // Redundant rows are consistent, since the point satisfies the equations.
        let solved = linear::solved_columns(&by_unknowns, &by_symbols, a)?;
        solved.ok_or_else(|| {
            let what = "an unknown that the given equations do not determine";
            Unknown::NotCovered { what }.into()
        })
    }

    /// The equations of which a hypothesis is a conjunction; names of definitions are opened.
    fn equations(
        &self,
        tree: &'a Expr,
        all: &mut Vec<(&'a Expr, &'a Expr)>,
    ) -> Result<(), NoValue> {
        match &tree.node {
            Node::Join(Connective::And, a, b) => {
                self.equations(a, all)?;
                self.equations(b, all)?;
            }
            Node::Compare(first, rest) => {
                let mut left = &**first;
                for (relation, right) in rest {
                    if *relation == Relation::Equal {
                        all.push((left, right));
                    }
                    left = right;
                }
            }
            Node::Name(name) => {
                if let Some(definition) = self.declarations.definition(name) {
                    let _deeper = self.deeper()?;
                    self.equations(&definition.body.expr, all)?;
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// The numbers of the point that a list of symbols, coordinates and members denotes.
    pub(super) fn moving_parts(
        &self,
        tree: &'a Expr,
        place: &Place<'a, A>,
    ) -> Result<Vec<Moving<'a>>, NoValue> {
        let none = || NoValue::shape("a formula where a symbol is needed");
        match &tree.node {
            Node::List(items) => {
                let items = items.iter().map(|item| self.moving_parts(item, place));
                Ok(items.collect::<Result<Vec<_>, _>>()?.concat())
            }
            Node::Name(name) => {
                if place.local(name).is_some() {
                    return Err(none());
                }
                if let Some(definition) = self.declarations.definition(name) {
                    if !definition.parameters.is_empty() {
                        return Err(none());
                    }
                    let _deeper = self.deeper()?;
                    return self.moving_parts(&definition.body.expr, &place.outside());
                }
                match self.declarations.symbol(name) {
                    Some(SymbolKind::Real(_) | SymbolKind::Vector(None)) => {
                        Ok(vec![(name, Part::Whole)])
                    }
                    Some(SymbolKind::Vector(Some(dimension))) => {
                        let all = (1..=*dimension).map(|c| (name.as_str(), Part::Coordinate(c)));
                        Ok(all.collect())
                    }
                    _ => Err(none()),
                }
            }
            Node::Index(head, indices) => {
                if let Node::Name(name) = &head.node
                    && place.local(name).is_none()
                    && self.declarations.definition(name).is_none()
                    && let Some(SymbolKind::Family { dimension, ranges }) =
                        self.declarations.symbol(name)
                {
                    let values = indices.iter().map(|i| self.integer(i, "an index", place));
                    let mut values: Vec<i64> = values.collect::<Result<_, _>>()?;
                    let is_point = dimension.is_some_and(|d| d > 1);
                    let has_entry =
                        is_point && !ranges.is_empty() && values.len() == ranges.len() + 1;
                    let entry = if has_entry { values.pop() } else { None };
                    self.check_ranges(name, ranges, &values)?;
                    let member = |c| (name.as_str(), Part::Member(values.clone(), c));
                    return match (dimension, entry) {
                        (Some(d), Some(c)) => {
                            let c = u8::try_from(c).ok().filter(|c| (1..=*d).contains(c));
                            Ok(vec![member(Some(c.ok_or_else(none)?))])
                        }
                        (Some(d), None) if is_point => {
                            Ok((1..=*d).map(|c| member(Some(c))).collect())
                        }
                        _ => Ok(vec![member(None)]),
                    };
                }
                let all = self.moving_parts(head, place)?;
                let [index] = indices.as_slice() else {
                    return Err(none());
                };
                let index = self.integer(index, "an index", place)?;
                let position = index.checked_sub(1).and_then(|p| usize::try_from(p).ok());
                let part = position.and_then(|p| all.get(p).cloned());
                Ok(vec![part.ok_or_else(none)?])
            }
            _ => Err(none()),
        }
    }
}

fn entries<N: Clone + PartialEq + std::fmt::Debug>(value: &Value<N>) -> Vec<Series<N>> {
    value.numbers().into_iter().cloned().collect()
}
