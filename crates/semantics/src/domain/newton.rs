//! One step of Newton's method for systems with more unknowns than equations, over any arithmetic: equations are
//! expanded to first order, and elimination finds the changes that make them hold.

use super::Domain;
use super::stream::Stream;
use crate::arithmetic::Arithmetic;
use crate::expansion::{Expanded, Slope};
use crate::gradient::{Gradient, Gradients};
use crate::name::Name;
use crate::no_value::NoValue;
use crate::tree::{Reading, Values};
use num_traits::Zero;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use torse_numbers::Rational;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::Expr;

/// The largest number of unknowns that are considered for a change.
const MAX_CANDIDATES: usize = 160;

/// The two sides of an equation.
pub(crate) type Equation<'a> = (&'a Expr, &'a Expr);

/// Expands the differences of the sides of equations to first order at these values. The numbers that `moves` accepts
/// are the variables.
///
/// # Errors
/// [`NoValue`] if a side is undefined or its value is unknown.
pub(crate) fn expanded<A: Arithmetic>(
    reading: &Reading<'_>,
    equations: &[Equation<'_>],
    base: A,
    value: &dyn Fn(&Name) -> Option<A::Number>,
    moves: &dyn Fn(&Name) -> bool,
) -> Result<Expanded<A::Number>, NoValue> {
    let gradients = Gradients::new(base);
    let known = RefCell::new(BTreeMap::new());
    let values = |name: &Name| {
        if let Some(gradient) = known.borrow().get(name) {
            return Some(Gradient::clone(gradient));
        }
        let value = value(name)?;
        let gradient = if moves(name) {
            gradients.variable(name, value)
        } else {
            Gradient::constant(value)
        };
        known.borrow_mut().insert(name.clone(), gradient.clone());
        Some(gradient)
    };
    let slope = |gap: &Gradient<A::Number>| Slope {
        value: gap.value.clone(),
        rates: gradients.rates(gap),
        curved: gradients.curved(gap),
    };
    let gaps = differences(reading, equations, &gradients, &values)?;
    Ok(Expanded {
        gaps: gaps.iter().map(slope).collect(),
        discrete: gradients.discrete(),
        multiplied: gradients.multiplied(),
    })
}

/// The differences of the sides: as [`expanded`] without variables, but cheaper.
///
/// # Errors
/// [`NoValue`] if a side is undefined or its value is unknown.
pub(crate) fn differences<A: Arithmetic>(
    reading: &Reading<'_>,
    equations: &[Equation<'_>],
    a: &A,
    value: &dyn Fn(&Name) -> Option<A::Number>,
) -> Result<Vec<A::Number>, NoValue> {
    let values = Values {
        number: value,
        near: false,
        fails: &|_| false,
    };
    reading.differences(equations, a, values)
}

/// An unknown that may be changed, with the derivatives of all differences by it.
struct Column<N> {
    name: Name,
    rates: Vec<N>,
    /// The order in which unknowns are changed: unknowns of the claim first, then those that occur linearly, real
    /// numbers before integers, unbounded ones before bounded ones.
    rank: (bool, bool, bool, bool, i64),
}

/// The changes of the unknowns that make all differences zero to first order; `None` if there are none. A difference
/// that no unknown changes must be zero already.
pub(crate) fn changes<A: Arithmetic>(
    domain: &Domain<'_>,
    expanded: &Expanded<A::Number>,
    stream: &Stream,
    unknowns: &BTreeSet<Name>,
    a: &A,
    holds: &dyn Fn(&A::Number) -> bool,
) -> Option<BTreeMap<Name, A::Number>> {
    let columns = columns(domain, expanded, stream, unknowns, a);
    eliminated(&columns, &expanded.gaps, a, holds)
}

/// The unknowns that change the differences, the best candidates first.
fn columns<A: Arithmetic>(
    domain: &Domain<'_>,
    expanded: &Expanded<A::Number>,
    stream: &Stream,
    unknowns: &BTreeSet<Name>,
    a: &A,
) -> Vec<Column<A::Number>> {
    let changing = expanded.gaps.iter().flat_map(|gap| gap.rates.keys());
    let names: BTreeSet<&Name> = changing
        .filter(|name| !expanded.discrete.contains(*name))
        .collect();
    let mut columns = vec![];
    for name in names.into_iter().take(MAX_CANDIDATES) {
        let rate = |gap: &Slope<A::Number>| {
            let rate = gap.rates.get(name).cloned();
            rate.unwrap_or_else(|| a.rational(&Rational::zero()))
        };
        let rates: Vec<A::Number> = expanded.gaps.iter().map(rate).collect();
        if !rates.iter().any(|rate| a.is_zero(rate) == Some(false)) {
            continue;
        }
        let set = domain.set(name);
        let rank = (
            !unknowns.contains(name),
            expanded.gaps.iter().any(|gap| gap.curved.contains(name)),
            matches!(set, Some(SymbolKind::Integer { .. })),
            matches!(set, Some(SymbolKind::Real(i)) if i.lower.is_some() || i.upper.is_some()),
            stream.below(&format!("{name} rank"), 1000),
        );
        columns.push(Column {
            name: name.clone(),
            rates,
            rank,
        });
    }
    columns.sort_by_key(|c| c.rank);
    columns
}

/// Solves by elimination for the changes of the columns; `None` if no changes make all differences zero.
fn eliminated<A: Arithmetic>(
    columns: &[Column<A::Number>],
    gaps: &[Slope<A::Number>],
    a: &A,
    holds: &dyn Fn(&A::Number) -> bool,
) -> Option<BTreeMap<Name, A::Number>> {
    // Each row holds the derivatives by all columns, then the negative difference.
    let mut rows: Vec<Vec<A::Number>> = gaps
        .iter()
        .enumerate()
        .map(|(r, gap)| {
            let rates = columns.iter().filter_map(|c| c.rates.get(r).cloned());
            rates
                .chain(std::iter::once(a.negated(&gap.value)))
                .collect()
        })
        .collect();
    let mut pivots = vec![];
    let mut done = 0;
    for (position, column) in columns.iter().enumerate() {
        let nonzero = |row: &Vec<A::Number>| {
            row.get(position)
                .is_some_and(|x| a.is_zero(x) == Some(false))
        };
        let Some(pivot) = rows.iter().skip(done).position(nonzero) else {
            continue;
        };
        rows.swap(done, done + pivot);
        let lead = rows.get(done)?.clone();
        let leading = lead.get(position)?;
        for (r, row) in rows.iter_mut().enumerate() {
            if r == done || !nonzero(row) {
                continue;
            }
            let factor = a.over(row.get(position)?, leading).ok()?;
            for (slot, other) in row.iter_mut().zip(&lead) {
                *slot = a.minus(slot, &a.times(&factor, other).ok()?).ok()?;
            }
        }
        pivots.push((done, position, column));
        done += 1;
        if done == rows.len() {
            break;
        }
    }
    // A difference that no unknown changes must be zero.
    for row in rows.iter().skip(done) {
        if row.last().is_some_and(|gap| !holds(gap)) {
            return None;
        }
    }
    let mut changes = BTreeMap::new();
    for (row, position, column) in pivots {
        let row = rows.get(row)?;
        let change = a.over(row.last()?, row.get(position)?).ok()?;
        changes.insert(column.name.clone(), change);
    }
    Some(changes)
}
