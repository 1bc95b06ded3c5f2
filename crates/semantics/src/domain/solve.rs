//! The equations of a domain: some numbers of a draft are changed until all equations hold.
//!
//! This is Newton's method for a system with more unknowns than equations: the equations are expanded to first order
//! at the draft, elimination chooses the numbers to change, and these are moved to the zero of the expansion. It ends
//! at once, with exact numbers, if the equations are linear in the chosen numbers, and after a few rounds if one can be
//! solved after the other. Else the numbers are rounded to many digits and the point satisfies the equations nearly.

use super::draft::Draft;
use crate::arithmetic::Arithmetic;
use crate::evaluate::{Evaluator, Scope};
use crate::gap::{Gap, Work};
use crate::name::Name;
use crate::real::{Real, Reals};
use std::collections::BTreeMap;
use torse_language::core::{Claim, Set, Statement, Term};
use torse_language::syntax::{Connective, Relation};
use torse_numbers::{Integer, Rational};

/// Precision of the rounds that are not exact.
const BITS: usize = 640;
/// An equation holds nearly if its sides differ by at most two to the minus this.
const NEAR_BITS: usize = 400;
/// Rounds with exact numbers, and all rounds.
const EXACT_ROUNDS: usize = 5;
const ROUNDS: usize = 16;
/// The most numbers that are candidates for a change.
const MAX_CANDIDATES: usize = 160;

/// How the equations are satisfied.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Solved {
    /// Exactly.
    Exactly,
    /// Nearly: see [`NEAR_BITS`].
    Nearly,
}

/// The comparisons that every point of the domain satisfies: those of conjunctions of hypotheses.
pub(crate) fn constraints(claim: &Claim) -> Vec<(Relation, &Term, &Term)> {
    let mut pending: Vec<&Statement> = claim
        .hypotheses
        .iter()
        .rev()
        .map(|h| &h.statement)
        .collect();
    let mut all = vec![];
    while let Some(statement) = pending.pop() {
        match statement {
            Statement::Join(Connective::And, a, b) => pending.extend([&**b, &**a]),
            Statement::Compare {
                relation,
                left,
                right,
            } => all.push((*relation, left, right)),
            _ => {}
        }
    }
    all
}

/// The equations among them.
fn equations(claim: &Claim) -> Vec<(&Term, &Term)> {
    constraints(claim)
        .into_iter()
        .filter(|(relation, ..)| *relation == Relation::Equal)
        .map(|(_, left, right)| (left, right))
        .collect()
}

/// Changes the draft until the equations hold; `None` if that does not succeed.
pub(crate) fn solve(claim: &Claim, draft: &Draft<'_>, work: &Work) -> Option<Solved> {
    let equations = equations(claim);
    if equations.is_empty() {
        return Some(Solved::Exactly);
    }
    let mut rounded = false;
    for round in 0..ROUNDS {
        let reals = Reals { bits: BITS, work };
        let values = |name: &Name| draft.value(name);
        let at = Evaluator::new(&reals, &values);
        let gaps = gaps(&equations, &at).ok()?;
        if gaps.iter().all(|g| reals.is_zero(g) == Some(true)) {
            return Some(if rounded {
                Solved::Nearly
            } else {
                Solved::Exactly
            });
        }
        if gaps.iter().all(is_near) {
            return Some(Solved::Nearly);
        }
        let changes = step(claim, &equations, &gaps, &at, draft)?;
        for (name, change) in changes {
            let moved = reals.plus(&draft.value(&name)?, &change).ok()?;
            let exact = matches!(moved, Real::Exact { .. }) && round < EXACT_ROUNDS;
            rounded |= !exact;
            let value = if exact {
                moved
            } else {
                moved.ball(BITS).midpoint().into()
            };
            draft.set(&name, value);
        }
    }
    None
}

fn is_near(gap: &Real) -> bool {
    let bound = Rational::new(1.into(), Integer::ONE << NEAR_BITS);
    gap.ball(BITS).abs().upper() <= bound
}

/// Left minus right of every entry of every equation.
fn gaps(equations: &[(&Term, &Term)], at: &Evaluator<'_, Reals<'_>>) -> Result<Vec<Real>, Gap> {
    let mut all = vec![];
    for (left, right) in equations {
        for (x, y) in at.value(left)?.pairs(&at.value(right)?, at.arithmetic)? {
            all.extend(x.minus(&y, at.arithmetic)?.as_number().cloned());
        }
    }
    Ok(all)
}

/// A number that may be changed, with the first derivatives of all gaps by it.
struct Column {
    name: Name,
    rates: Vec<Real>,
    /// What is changed first: unknowns of the claim, then what occurs linearly, numbers before integers, those without
    /// bounds before others.
    rank: (bool, bool, bool, bool, i64),
}

/// The changes that make the first-order expansion of all gaps zero.
fn step(
    claim: &Claim,
    equations: &[(&Term, &Term)],
    gaps: &[Real],
    at: &Evaluator<'_, Reals<'_>>,
    draft: &Draft<'_>,
) -> Option<BTreeMap<Name, Real>> {
    let a = at.arithmetic;
    let mut unknowns = vec![];
    for unknown in &claim.unknowns {
        unknowns.extend(at.names(unknown, &Scope::outermost()).ok()?);
    }
    // The unknowns alone mostly suffice.
    let few = columns(claim, equations, gaps, at, draft, &unknowns, &unknowns);
    eliminated(few, gaps, a).or_else(|| {
        let all = draft.names();
        let all = all.get(..MAX_CANDIDATES.min(all.len())).unwrap_or(&[]);
        eliminated(
            columns(claim, equations, gaps, at, draft, &unknowns, all),
            gaps,
            a,
        )
    })
}

/// The columns of these names, best candidates for a change first.
fn columns(
    claim: &Claim,
    equations: &[(&Term, &Term)],
    gaps: &[Real],
    at: &Evaluator<'_, Reals<'_>>,
    draft: &Draft<'_>,
    unknowns: &[Name],
    names: &[Name],
) -> Vec<Column> {
    let a = at.arithmetic;
    let mut columns = vec![];
    for name in names {
        let Ok((rates, curved)) = rates(equations, name, at) else {
            continue;
        };
        if rates.len() != gaps.len() || rates.iter().all(|r| a.is_zero(r) != Some(false)) {
            continue;
        }
        let set = claim.symbols.get(name.declared());
        let rank = (
            !unknowns.contains(name),
            curved,
            matches!(set, Some(Set::Integer { .. })),
            matches!(set, Some(Set::Real(i)) if i.lower.is_some() || i.upper.is_some()),
            draft.stream().below(&format!("{name} rank"), 1000),
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

/// Eliminates: what the columns have to be changed by; `None` if they cannot make all gaps zero.
fn eliminated(columns: Vec<Column>, gaps: &[Real], a: &Reals<'_>) -> Option<BTreeMap<Name, Real>> {
    // Rows: the rates of all columns, then minus the gap.
    let mut rows: Vec<Vec<Real>> = gaps
        .iter()
        .enumerate()
        .map(|(r, gap)| {
            let rates = columns.iter().filter_map(|c| c.rates.get(r).cloned());
            rates.chain(std::iter::once(a.negated(gap))).collect()
        })
        .collect();
    let mut pivots = vec![];
    let mut done = 0;
    for (position, column) in columns.iter().enumerate() {
        let nonzero = |row: &Vec<Real>| {
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
    // An equation that nothing can change must hold.
    for row in rows.iter().skip(done) {
        if row.last().is_some_and(|gap| !is_near(gap)) {
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

/// The first derivatives of all gaps by a number, and whether a second one is not zero.
fn rates(
    equations: &[(&Term, &Term)],
    name: &Name,
    at: &Evaluator<'_, Reals<'_>>,
) -> Result<(Vec<Real>, bool), Gap> {
    let a = at.arithmetic;
    let (mut rates, mut curved) = (vec![], false);
    for (left, right) in equations {
        let [_, left, left_second] = at.expansion(left, name, &Scope::outermost())?;
        let [_, right, right_second] = at.expansion(right, name, &Scope::outermost())?;
        for (x, y) in left.pairs(&right, a)? {
            rates.extend(x.minus(&y, a)?.as_number().cloned());
        }
        for (x, y) in left_second.pairs(&right_second, a)? {
            curved |= x.minus(&y, a)?.is_zero(a) != Some(true);
        }
    }
    Ok((rates, curved))
}
