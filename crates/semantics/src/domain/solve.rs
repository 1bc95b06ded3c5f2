//! The equations of a domain: some numbers of a draft are changed until all equations hold.
//!
//! This is Newton's method for a system with more unknowns than equations: the equations are expanded to first order
//! at the draft, elimination chooses the numbers to change, and these are moved to the zero of the expansion. It ends
//! at once, with exact numbers, if the equations are linear in the chosen numbers, and after a few rounds if one can be
//! solved after the other. Else the numbers are rounded to many digits and the point satisfies the equations nearly.

use super::draft::Draft;
use crate::arithmetic::Arithmetic;
use crate::evaluate::Evaluator;
use crate::gap::Work;
use crate::gradient::{Gradient, Gradients};
use crate::name::Name;
use crate::real::{Real, Reals};
use crate::scope::Scope;
use num_traits::{Signed, Zero};
use std::cmp::Ordering;
use std::collections::{BTreeMap, BTreeSet};
use torse_language::core::{Claim, Set, Statement, Term};
use torse_language::syntax::{Connective, Relation};
use torse_numbers::{Integer, Rational};

/// Precision of the rounds that are not exact.
const BITS: usize = 640;
/// An equation holds nearly if its sides differ by at most two to the minus this.
const NEAR_BITS: usize = 400;
/// A rounded number is taken for a simple rational one if they differ by at most two to the minus this, and the
/// denominator has at most so many bits.
const SNAP_BITS: usize = 380;
const SIMPLE_BITS: usize = 64;
/// Rounds with exact numbers, and all rounds.
const EXACT_ROUNDS: usize = 5;
const ROUNDS: usize = 16;
/// The most numbers that are candidates for a change.
const MAX_CANDIDATES: usize = 160;

/// How the equations are satisfied.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Solved {
    /// Exactly: the two sides of each are the same number.
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

/// Whether a hypothesis is a conjunction of equations, all of which [`solve`] looks at.
pub(crate) fn is_equations(statement: &Statement) -> bool {
    let mut pending = vec![statement];
    while let Some(statement) = pending.pop() {
        match statement {
            Statement::Join(Connective::And, a, b) => pending.extend([&**a, &**b]),
            Statement::Compare {
                relation: Relation::Equal,
                ..
            } => {}
            _ => return false,
        }
    }
    true
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
    let unknowns = unknowns(claim, draft, work)?;
    let mut rounded = false;
    for round in 0..ROUNDS {
        let found = |gaps: &[Slope]| {
            solved(gaps, rounded).map(|solved| match solved {
                Solved::Exactly => solved,
                Solved::Nearly => snapped(&equations, draft, work).unwrap_or(solved),
            })
        };
        // The values alone cost a fraction of the rates, which are not needed where the equations hold. Numbers that
        // were drawn by chance do not satisfy them.
        if round > 0
            && let Some(solved) = found(&expanded(&equations, draft, &|_| false, work)?.gaps)
        {
            return Some(solved);
        }
        // The unknowns alone mostly suffice.
        let some = expanded(&equations, draft, &|name| unknowns.contains(name), work)?;
        if let Some(solved) = found(&some.gaps) {
            return Some(solved);
        }
        let reals = Reals { bits: BITS, work };
        let few = columns(claim, &some, draft, &unknowns);
        let changes = match eliminated(few, &some.gaps, &reals) {
            Some(changes) => changes,
            None => {
                let all = expanded(&equations, draft, &|_| true, work)?;
                eliminated(columns(claim, &all, draft, &unknowns), &all.gaps, &reals)?
            }
        };
        for (name, change) in changes {
            let moved = reals.plus(&draft.value(&name)?, &change).ok()?;
            let exact = !matches!(moved, Real::Enclosed(_)) && round < EXACT_ROUNDS;
            rounded |= !exact;
            let value = if exact {
                moved
            } else {
                draft.round(&name);
                moved.ball(BITS).midpoint().into()
            };
            draft.set(&name, value);
        }
    }
    None
}

/// The numbers that the unknowns of the claim consist of.
fn unknowns(claim: &Claim, draft: &Draft<'_>, work: &Work) -> Option<BTreeSet<Name>> {
    let reals = Reals { bits: BITS, work };
    let values = |name: &Name| draft.value(name);
    let at = Evaluator::new(&reals, &values);
    let names = claim
        .unknowns
        .iter()
        .map(|unknown| at.names(unknown, &Scope::outermost()));
    let names: Vec<Vec<Name>> = names.collect::<Result<_, _>>().ok()?;
    Some(names.into_iter().flatten().collect())
}

/// How the equations hold, if they do.
fn solved(gaps: &[Slope], rounded: bool) -> Option<Solved> {
    if gaps.iter().all(|g| g.value.sign() == Some(Ordering::Equal)) {
        return Some(if rounded {
            Solved::Nearly
        } else {
            Solved::Exactly
        });
    }
    gaps.iter()
        .all(|gap| is_near(&gap.value))
        .then_some(Solved::Nearly)
}

/// Rounded numbers that are nearly simple rational ones are made so, if all equations hold exactly then.
fn snapped(equations: &[(&Term, &Term)], draft: &Draft<'_>, work: &Work) -> Option<Solved> {
    let before = draft.values();
    for name in draft.rounded() {
        if let Some(simple) = before
            .get(&name)
            .and_then(Real::as_rational)
            .and_then(simple)
        {
            draft.set(&name, simple.into());
        }
    }
    let exact = expanded(equations, draft, &|_| false, work).is_some_and(|found| {
        let mut gaps = found.gaps.iter();
        gaps.all(|gap| gap.value.sign() == Some(Ordering::Equal))
    });
    if exact {
        return Some(Solved::Exactly);
    }
    for (name, value) in before {
        draft.set(&name, value);
    }
    None
}

/// The rational number with a small denominator that agrees with a number to many digits, if there is one: a convergent
/// of its continued fraction.
fn simple(q: &Rational) -> Option<Rational> {
    let close = Rational::new(1.into(), Integer::ONE << SNAP_BITS);
    let largest = Integer::ONE << SIMPLE_BITS;
    let (mut rest, mut before, mut last) = (
        q.clone(),
        (Integer::ZERO, Integer::ONE),
        (Integer::ONE, Integer::ZERO),
    );
    loop {
        let whole = rest.floor();
        let digit = whole.to_integer();
        let next = (&digit * &last.0 + &before.0, &digit * &last.1 + &before.1);
        if next.1 > largest {
            return None;
        }
        let convergent = Rational::new(next.0.clone(), next.1.clone());
        if (&convergent - q).abs() <= close {
            return Some(convergent);
        }
        rest = (rest - whole).recip();
        (before, last) = (last, next);
    }
}

fn is_near(gap: &Real) -> bool {
    let bound = Rational::new(1.into(), Integer::ONE << NEAR_BITS);
    gap.ball(BITS).abs().upper() <= bound
}

/// Left minus right of an entry of an equation, to first order.
struct Slope {
    value: Real,
    /// The rates that are not zero.
    rates: BTreeMap<Name, Real>,
    /// The numbers that do not occur linearly.
    curved: BTreeSet<Name>,
}

/// All entries of all equations.
struct Expanded {
    gaps: Vec<Slope>,
    /// Numbers that cannot be moved a little.
    discrete: BTreeSet<Name>,
}

/// Expands the equations at the draft by the numbers that `moves` chooses; `None` where a term has no value.
fn expanded(
    equations: &[(&Term, &Term)],
    draft: &Draft<'_>,
    moves: &dyn Fn(&Name) -> bool,
    work: &Work,
) -> Option<Expanded> {
    let gradients = Gradients::new(Reals { bits: BITS, work });
    let values = |name: &Name| {
        let value = draft.value(name)?;
        Some(match moves(name) {
            true => gradients.variable(name, value),
            false => value.into(),
        })
    };
    let at = Evaluator::new(&gradients, &values);
    let slope = |gap: &Gradient| Slope {
        value: gap.value.clone(),
        rates: gradients.rates(gap),
        curved: gradients.curved(gap),
    };
    let mut gaps = vec![];
    for (left, right) in equations {
        let pairs = at
            .value(left)
            .ok()?
            .pairs(&at.value(right).ok()?, &gradients)
            .ok()?;
        for (x, y) in pairs {
            gaps.extend(x.minus(&y, &gradients).ok()?.as_number().map(slope));
        }
    }
    let discrete = gradients.discrete();
    Some(Expanded { gaps, discrete })
}

/// A number that may be changed, with the first derivatives of all gaps by it.
struct Column {
    name: Name,
    rates: Vec<Real>,
    /// What is changed first: unknowns of the claim, then what occurs linearly, numbers before integers, those without
    /// bounds before others.
    rank: (bool, bool, bool, bool, i64),
}

/// The numbers that the gaps change with, best candidates for a change first.
fn columns(
    claim: &Claim,
    expanded: &Expanded,
    draft: &Draft<'_>,
    unknowns: &BTreeSet<Name>,
) -> Vec<Column> {
    let changing = expanded.gaps.iter().flat_map(|gap| gap.rates.keys());
    let names: BTreeSet<&Name> = changing
        .filter(|name| !expanded.discrete.contains(*name))
        .collect();
    let mut columns = vec![];
    for name in names.into_iter().take(MAX_CANDIDATES) {
        let rate = |gap: &Slope| {
            let rate = gap.rates.get(name).cloned();
            rate.unwrap_or_else(|| Rational::zero().into())
        };
        let rates: Vec<Real> = expanded.gaps.iter().map(rate).collect();
        let moves = |rate: &Real| !matches!(rate.sign(), None | Some(Ordering::Equal));
        if !rates.iter().any(moves) {
            continue;
        }
        let set = claim.symbols.get(name.declared());
        let rank = (
            !unknowns.contains(name),
            expanded.gaps.iter().any(|gap| gap.curved.contains(name)),
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
fn eliminated(columns: Vec<Column>, gaps: &[Slope], a: &Reals<'_>) -> Option<BTreeMap<Name, Real>> {
    // Rows: the rates of all columns, then minus the gap.
    let mut rows: Vec<Vec<Real>> = gaps
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
