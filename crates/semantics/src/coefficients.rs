//! `coefficients`: the derivatives of forms by symbols, and what these are where equations determine unknowns.
//!
//! In a claim with `given` equations G(v, U) = 0 the unknowns U are functions of the other symbols, and a form F(v, U) is
//! read with them put in. Its coefficient of v is dF/dv along the solutions, by the theorem on implicit functions:
//! `F_v + F_U a` with `G_U a = -G_v`.

use crate::arithmetic::Arithmetic;
use crate::evaluate::{Evaluator, Outcome, Sc};
use crate::expansion::{Expanded, Slope};
use crate::gap::{Gap, Undefined, Unknown};
use crate::name::Name;
use crate::series::Series;
use crate::value::{Value, transposed};
use std::sync::Arc;
use torse_core::{Node, Source, Statement, Term};
use torse_syntax::formula::{Connective, Relation};

/// Terms to be equal in pairs.
type Equations<'a> = Vec<(&'a Term, Option<&'a Term>)>;
type Row<A> = Vec<Series<<A as Arithmetic>::Number>>;

/// The rates of all entries by one number.
fn rates<A: Arithmetic>(expanded: &Expanded<A::Number>, name: &Name, a: &A) -> Row<A> {
    let rate = |slope: &Slope<A::Number>| match slope.rates.get(name) {
        Some(rate) => Series::Number(rate.clone()),
        None => Series::integer(0, a),
    };
    expanded.gaps.iter().map(rate).collect()
}

impl<A: Arithmetic> Evaluator<'_, A> {
    /// One row for each form, one column for each symbol.
    ///
    /// Without equations a form has to be linear: its second derivatives are zero. Along solutions that is not asked, as
    /// they mostly satisfy the equations nearly.
    pub(crate) fn coefficients(
        &self,
        forms: &Term,
        symbols: &Term,
        scope: &Sc<'_, A>,
    ) -> Outcome<A> {
        let names = self.names(symbols, scope)?;
        let columns = match self.solved() {
            Some((equations, unknowns)) => {
                self.along(forms, &names, &equations, unknowns, scope)?
            }
            None if self.arithmetic.work().known().is_linear(forms, symbols) => {
                self.together(forms, &names, scope)?
            }
            None => {
                let columns = names.iter().map(|name| self.linear(forms, name, scope));
                columns.collect::<Result<_, _>>()?
            }
        };
        Ok(Value::matrix(transposed(&columns)))
    }

    /// The coefficients of forms that are linear in all symbols together, which do not depend on what the symbols are worth.
    fn together(
        &self,
        forms: &Term,
        names: &[Name],
        scope: &Sc<'_, A>,
    ) -> Result<Vec<Row<A>>, Gap> {
        let a = self.arithmetic;
        let closed = a.work().known().is_closed(forms) && scope.innermost_symbol().is_none();
        let moves = |name: &Name| names.contains(name);
        let values = |name: &Name| match moves(name) {
            true => Some(a.integer(0)),
            false => (self.values)(name),
        };
        // One evaluation has all rates, where the arithmetic has any.
        if closed && let Ok(expanded) = a.first_order(&[(forms, None)], &values, &moves) {
            return Ok(names.iter().map(|name| rates(&expanded, name, a)).collect());
        }
        // Else each is what the forms are worth where its symbol is 1 and the others are 0, less what they are worth where all
        // are 0.
        let none = self.where_one_is_unit(forms, names, None, scope)?;
        let column = |name| -> Result<Row<A>, Gap> {
            let unit = self.where_one_is_unit(forms, names, Some(name), scope)?;
            let pairs = unit.iter().zip(&none);
            pairs.map(|(one, none)| one.minus(none, a)).collect()
        };
        names.iter().map(column).collect()
    }

    /// What forms are worth where one of these symbols is 1, and all others are 0.
    fn where_one_is_unit(
        &self,
        forms: &Term,
        names: &[Name],
        unit: Option<&Name>,
        scope: &Sc<'_, A>,
    ) -> Result<Row<A>, Gap> {
        let Some((name, others)) = names.split_first() else {
            return self.entries(forms, scope);
        };
        let value = Series::integer(i64::from(unit == Some(name)), self.arithmetic);
        self.where_one_is_unit(forms, others, unit, &scope.changed(name.clone(), value))
    }

    /// The derivatives of forms that are linear in each symbol.
    fn linear(&self, forms: &Term, name: &Name, scope: &Sc<'_, A>) -> Result<Row<A>, Gap> {
        let a = self.arithmetic;
        let own = self.symbol(name.clone(), scope)?;
        let level = scope.level + 1;
        let inner = scope.changed(name.clone(), own.shifted(level, 2, a));
        let values = self.entries(forms, &inner)?;
        for value in &values {
            match value.coefficient(level, 2, a).is_zero(a) {
                Some(true) => {}
                Some(false) => return Err(Undefined::NotLinear.into()),
                None => return Err(Unknown::Precision.into()),
            }
        }
        Ok(values.iter().map(|v| v.coefficient(level, 1, a)).collect())
    }

    /// The given equations, and their unknowns.
    fn solved(&self) -> Option<(Equations<'_>, &[Term])> {
        let claim = self.claim.filter(|claim| !claim.unknowns.is_empty())?;
        let given = claim
            .hypotheses
            .iter()
            .filter(|h| h.source == Source::Given);
        let mut pending: Vec<&Statement> = given.map(|hypothesis| &hypothesis.statement).collect();
        let mut equations = vec![];
        while let Some(statement) = pending.pop() {
            match statement {
                Statement::Join(Connective::And, a, b) => pending.extend([&**a, &**b]),
                Statement::Compare {
                    relation: Relation::Equal,
                    left,
                    right,
                } => equations.push((left, Some(right))),
                _ => {}
            }
        }
        Some((equations, &claim.unknowns))
    }

    /// The derivatives of forms along the solutions of equations.
    fn along(
        &self,
        forms: &Term,
        names: &[Name],
        equations: &Equations<'_>,
        unknowns: &[Term],
        scope: &Sc<'_, A>,
    ) -> Result<Vec<Row<A>>, Gap> {
        let mut free = vec![];
        for unknown in unknowns {
            free.extend(self.names(unknown, scope)?);
        }
        let not_covered = |what| Gap::from(Unknown::NotCovered { what });
        if names.iter().any(|name| free.contains(name)) {
            let what = "a coefficient of an unknown of the given equations";
            return Err(not_covered(what));
        }
        // In the equations nothing is put in, and they do not know the variables of a binder either.
        if !self.arithmetic.work().known().is_closed(forms) || scope.innermost_symbol().is_some() {
            return Err(not_covered("a form with the variable of a binder"));
        }
        let a = self.arithmetic;
        let moves = |name: &Name| names.contains(name) || free.contains(name);
        let forms = a.first_order(&[(forms, None)], self.values, &moves)?;
        let gaps = a.first_order(equations, self.values, &moves)?;
        let mut discrete = forms.discrete.union(&gaps.discrete);
        if discrete.any(&moves) {
            return Err(Undefined::NotDifferentiable.into());
        }
        let of_gaps = |names: &[Name]| names.iter().map(|name| rates(&gaps, name, a)).collect();
        let (rows, right): (Vec<Row<A>>, Vec<Row<A>>) = (of_gaps(&free), of_gaps(names));
        let changes = self.eliminated(&rows, &right)?;
        let mut columns = vec![];
        for (name, changes) in names.iter().zip(changes) {
            let mut column = rates(&forms, name, a);
            for (unknown, change) in free.iter().zip(&changes) {
                for (entry, rate) in column.iter_mut().zip(rates(&forms, unknown, a)) {
                    *entry = entry.plus(&rate.times(change, a)?, a)?;
                }
            }
            columns.push(column);
        }
        Ok(columns)
    }

    /// The numbers of a term.
    fn entries(&self, term: &Term, scope: &Sc<'_, A>) -> Result<Row<A>, Gap> {
        Ok(self
            .term(term, scope)?
            .numbers()
            .into_iter()
            .cloned()
            .collect())
    }

    /// For each right side the x with `sum of x[k] columns[k] = -right`.
    fn eliminated(&self, columns: &[Row<A>], right: &[Row<A>]) -> Result<Vec<Row<A>>, Gap> {
        let a = self.arithmetic;
        let height = columns.first().map_or(0, Vec::len);
        let all = || columns.iter().chain(right);
        let mut rows: Vec<Row<A>> = (0..height)
            .map(|r| all().filter_map(|column| column.get(r).cloned()).collect())
            .collect();
        let mut done = vec![];
        for place in 0..columns.len() {
            let is_unit = |row: &Row<A>| row.get(place).and_then(|x| x.is_zero(a)) == Some(false);
            let Some(pivot) = rows.iter().position(is_unit) else {
                let what = "an unknown that the given equations do not determine";
                return Err(Unknown::NotCovered { what }.into());
            };
            let lead = rows.swap_remove(pivot);
            let Some(leading) = lead.get(place).cloned() else {
                continue;
            };
            let lead: Row<A> = lead
                .iter()
                .map(|x| x.over(&leading, a))
                .collect::<Result<_, _>>()?;
            for row in rows.iter_mut().chain(&mut done) {
                let Some(factor) = row.get(place).cloned() else {
                    continue;
                };
                if factor.is_zero(a) == Some(true) {
                    continue;
                }
                for (entry, other) in row.iter_mut().zip(&lead) {
                    *entry = entry.minus(&factor.times(other, a)?, a)?;
                }
            }
            done.push(lead);
        }
        let solution = |column: usize| -> Row<A> {
            let values = done
                .iter()
                .filter_map(|row| row.get(columns.len() + column));
            values.map(|x| x.negated(a)).collect()
        };
        Ok((0..right.len()).map(solution).collect())
    }

    /// The numbers of a point that a list of symbols, coordinates and members consists of.
    pub(crate) fn names(&self, term: &Term, scope: &Sc<'_, A>) -> Result<Vec<Name>, Gap> {
        let not_covered = || {
            Gap::from(Unknown::NotCovered {
                what: "a formula where a symbol is needed",
            })
        };
        Ok(match &*term.node {
            Node::List(items) => {
                let names = items.iter().map(|item| self.names(item, scope));
                names.collect::<Result<Vec<_>, _>>()?.concat()
            }
            Node::Opened { body, .. } => self.names(body, scope)?,
            Node::Symbol(name) | Node::Vector(name, None) => vec![Name::Symbol(Arc::clone(name))],
            Node::Vector(name, Some(dimension)) => (1..=*dimension)
                .map(|c| Name::Coordinate(Arc::clone(name), c))
                .collect(),
            Node::Member(points, indices) => {
                let indices: Vec<i64> = indices
                    .iter()
                    .map(|i| self.integer(i, "an index", scope))
                    .collect::<Result<_, _>>()?;
                let member = |c| Name::Member(Arc::clone(&points.name), indices.clone(), c);
                match points.dimension {
                    None | Some(1) => vec![member(None)],
                    Some(d) => (1..=d).map(|c| member(Some(c))).collect(),
                }
            }
            Node::Entry(of, indices) => {
                let all = self.names(of, scope)?;
                let [index] = indices.as_slice() else {
                    return Err(not_covered());
                };
                let index = self.integer(index, "an index", scope)?;
                let position = usize::try_from(index - 1).ok();
                let name = position.and_then(|p| all.get(p).cloned());
                vec![name.ok_or_else(not_covered)?]
            }
            _ => return Err(not_covered()),
        })
    }
}
