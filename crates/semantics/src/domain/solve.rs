//! Solving the equations of a domain: some numbers of a draft are changed until all equations hold.
//!
//! This is Newton's method for a system with more unknowns than equations: expand the equations to first order at the
//! draft, choose the numbers to change by elimination, and move them to the zero of the expansion. It ends after one
//! step, with exact numbers, if the equations are linear in the chosen numbers, and after a few steps if they can be
//! solved one after the other. Otherwise the numbers are rounded to many digits, and the point satisfies the
//! equations only approximately.

use super::Domain;
use super::draft::Draft;
use super::newton::{Equation, changes, differences, expanded};
use crate::arithmetic::Arithmetic;
use crate::name::Name;
use crate::no_value::Work;
use crate::real::{Real, Reals, length};
use dashu_int::ops::BitTest;
use num_traits::Signed;
use std::cmp::Ordering;
use std::collections::BTreeSet;
use torse_numbers::rational::floor_quotient;
use torse_numbers::{Integer, Rational};

/// The precision of steps that are not exact, in bits.
const BITS: usize = 640;
/// An equation holds approximately if its sides differ by at most `2^-NEAR_BITS`.
const NEAR_BITS: usize = 400;
/// In the last step no number may move by more than `2^-SETTLED_BITS`. This excludes equations such as `tanh(x) == 1`,
/// whose sides come arbitrarily close although there is no solution.
const SETTLED_BITS: usize = 100;
/// A rounded number is replaced by a simple rational one if they differ by at most `2^-SNAP_BITS` and the denominator
/// has at most `SIMPLE_BITS` bits.
const SNAP_BITS: usize = 380;
const SIMPLE_BITS: usize = 64;
/// The number of exact steps, and of all steps. Numbers that are solved for one after the other stay short. Where the
/// method only converges, they double in length in each step, and are rounded beyond `MAX_EXACT_BITS`.
const EXACT_ROUNDS: usize = 5;
const ROUNDS: usize = 16;
const MAX_EXACT_BITS: usize = 320;
/// In each step rounded numbers must gain at least `PLACES` binary places. If they fail to do so `MAX_LAPSES` times,
/// there is no solution nearby, or a double one, for which the method gains two places a step and would need far too
/// many steps.
const PLACES: usize = 4;
const MAX_LAPSES: usize = 4;

/// How well the equations hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Solved {
    /// Exactly: the two sides of each equation are equal.
    Exactly,
    /// Approximately: see [`NEAR_BITS`].
    Nearly,
}

/// Changes the draft until the equations hold; `None` if that fails.
pub(crate) fn solve(domain: &Domain<'_>, draft: &Draft<'_>, work: &Work) -> Option<Solved> {
    let equations = domain.equations();
    let reading = domain.reading;
    if equations.is_empty() {
        return Some(Solved::Exactly);
    }
    let unknowns = unknowns(domain, draft, work);
    // Sums and products of long fractions cost many times as much as those of balls.
    let value = |name: &Name| {
        let value = draft.value(name)?;
        Some(if draft.is_rounded(name) {
            value.ball(BITS).into()
        } else {
            value
        })
    };
    let expanded = |moves: &dyn Fn(&Name) -> bool| {
        expanded(reading, &equations, Reals::new(BITS, work), &value, moves).ok()
    };
    let values = || differences(reading, &equations, &Reals::new(BITS, work), &value).ok();
    let (mut rounded, mut settled) = (false, false);
    let (mut places, mut lapses) = (0, 0);
    // The numbers that one step has determined, if all equations are linear.
    let mut determined: Option<Vec<Name>> = None;
    for round in 0..ROUNDS {
        let found = |gaps: &[&Real]| match solved(gaps, rounded)? {
            Solved::Nearly => match snapped(domain, &equations, draft, work) {
                None => settled.then_some(Solved::Nearly),
                exactly => exactly,
            },
            exactly => Some(exactly),
        };
        // Evaluating the equations costs a fraction of their derivatives, which are not needed if the equations hold
        // already. In the first round they do not, since the numbers are random.
        if round > 0 {
            let values = values()?;
            let gaps: Vec<&Real> = values.iter().collect();
            if let Some(solved) = found(&gaps) {
                if round == 1 && solved == Solved::Exactly {
                    draft.determine(determined.into_iter().flatten());
                }
                return Some(solved);
            }
            if rounded {
                let now = gaps
                    .iter()
                    .map(|gap| gap.ball(BITS).leading_zeros())
                    .min()?;
                lapses += usize::from(now < places + PLACES);
                places = now;
                if lapses > MAX_LAPSES {
                    return None;
                }
            }
        }
        // Changing the unknowns of the claim mostly suffices.
        let by_unknowns = expanded(&|name| unknowns.contains(name))?;
        let gaps: Vec<&Real> = by_unknowns.gaps.iter().map(|gap| &gap.value).collect();
        if let Some(solved) = found(&gaps) {
            return Some(solved);
        }
        let reals = Reals::new(BITS, work);
        let changes = |expanded| {
            let stream = draft.stream();
            changes(domain, expanded, stream, &unknowns, &reals, &is_near)
        };
        let (used, changes) = match changes(&by_unknowns) {
            Some(changes) if !changes.is_empty() || draft.rounded().is_empty() => {
                (by_unknowns, changes)
            }
            _ => {
                let all = expanded(&|_| true)?;
                let changes = changes(&all)?;
                (all, changes)
            }
        };
        determined = (round == 0 && used.is_linear()).then(|| changes.keys().cloned().collect());
        settled = match changes.is_empty() {
            // Of rounded numbers the rates may be lost in the rounding, and say nothing of where a zero is.
            true => draft.rounded().is_empty(),
            false => changes
                .values()
                .all(|change| is_within(change, SETTLED_BITS)),
        };
        for (name, change) in changes {
            let moved = reals.plus(&draft.value(&name)?, &change).ok()?;
            let exact = match &moved {
                Real::Rational(q) => {
                    round == 0 || (round < EXACT_ROUNDS && length(q) <= MAX_EXACT_BITS)
                }
                Real::Turned(_) | Real::Surd(_) => round < EXACT_ROUNDS,
                Real::Enclosed(_) => false,
            };
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

/// The numbers of which the unknowns of the claim consist.
pub(crate) fn unknowns(domain: &Domain<'_>, draft: &Draft<'_>, work: &Work) -> BTreeSet<Name> {
    let reals = Reals::new(BITS, work);
    let values = |name: &Name| draft.value(name);
    let names = domain.unknowns.iter();
    let names = names.filter_map(|tree| domain.reading.names_in(tree, &reals, &values).ok());
    names.flatten().collect()
}

/// How well the equations hold, if they do.
fn solved(gaps: &[&Real], rounded: bool) -> Option<Solved> {
    if gaps.iter().all(|g| g.sign() == Some(Ordering::Equal)) {
        return Some(if rounded {
            Solved::Nearly
        } else {
            Solved::Exactly
        });
    }
    gaps.iter()
        .all(|gap| is_near(gap))
        .then_some(Solved::Nearly)
}

/// Replaces rounded numbers that are close to simple rational ones, if all equations then hold exactly.
fn snapped(
    domain: &Domain<'_>,
    equations: &[Equation<'_>],
    draft: &Draft<'_>,
    work: &Work,
) -> Option<Solved> {
    let before = draft.values();
    for name in draft.rounded() {
        if let Some(simple) = before
            .get(&name)
            .and_then(Real::as_rational)
            .and_then(simplest_nearby)
        {
            draft.set(&name, simple.into());
        }
    }
    let value = |name: &Name| draft.value(name);
    let found = differences(domain.reading, equations, &Reals::new(BITS, work), &value);
    let exact = found.is_ok_and(|gaps| {
        let mut gaps = gaps.iter();
        gaps.all(|gap| gap.sign() == Some(Ordering::Equal))
    });
    if exact {
        return Some(Solved::Exactly);
    }
    for (name, value) in before {
        draft.set(&name, value);
    }
    None
}

/// The rational number with a small denominator that agrees with `q` to many digits, if there is one: a convergent of
/// the continued fraction of `q`.
fn simplest_nearby(q: &Rational) -> Option<Rational> {
    let (numerator, denominator) = (q.numer(), q.denom());
    // The quotients in Euclid's algorithm are the terms of the continued fraction.
    let (mut above, mut below) = (numerator.clone(), denominator.clone());
    let (mut before, mut last) = ((Integer::ZERO, Integer::ONE), (Integer::ONE, Integer::ZERO));
    loop {
        let digit = floor_quotient(&above, &below);
        let next = (&digit * &last.0 + &before.0, &digit * &last.1 + &before.1);
        if next.1.bit_len() > SIMPLE_BITS {
            return None;
        }
        let apart = &next.0 * denominator - numerator * &next.1;
        if apart.abs() << SNAP_BITS <= &next.1 * denominator {
            return Some(Rational::new(next.0, next.1));
        }
        (above, below) = (below.clone(), above - digit * below);
        (before, last) = (last, next);
    }
}

fn is_near(gap: &Real) -> bool {
    is_within(gap, NEAR_BITS)
}

/// Whether the size of a number is at most two to the minus `bits`.
fn is_within(number: &Real, bits: usize) -> bool {
    match number {
        Real::Rational(number) => number.numer().abs() << bits <= *number.denom(),
        _ => number.ball(BITS).is_within(bits),
    }
}
