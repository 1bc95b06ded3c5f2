//! Whether series cancel: one canonical form, then coefficient by coefficient.

use super::weight::split;
use super::{Axis, Series, Target, here, with_index, with_indices};
use std::collections::BTreeMap;
use torse_algebra::{Affine, ExactError, Fraction, Polynomial, Symbol};

/// Whether a sum of series is zero for all degrees: groups comparable series, brings each group to its
/// smallest powers and adds the seeds. `true` is a proof; `false` means that some group did not cancel.
///
/// # Errors
/// [`ExactError`] when a denominator of the points vanishes.
pub fn vanishes(all: &[Series]) -> Result<bool, ExactError> {
    let mut pending = vec![];
    for series in all {
        for part in canonical(series)? {
            pending.push(in_order(part)?);
        }
    }
    while let Some(first) = pending.pop() {
        let (mut group, rest): (Vec<Series>, Vec<Series>) =
            pending.into_iter().partition(|s| comparable(s, &first));
        pending = rest;
        group.push(first);
        if !cancels(&group) {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Whether a group of comparable series cancels.
fn cancels(group: &[Series]) -> bool {
    let Some(first) = group.first() else {
        return true;
    };
    // How many steps more than the first series each one has, axis by axis.
    let excess = |series: &Series| -> Vec<i64> {
        let axes = series.axes.iter().zip(&first.axes);
        axes.map(|(own, other)| (own.power.clone() - other.power.clone()).constant())
            .collect()
    };
    let smallest = group.iter().map(excess).reduce(|a, b| {
        let pairs = a.into_iter().zip(b);
        pairs.map(|(x, y)| x.min(y)).collect()
    });
    let mut total: BTreeMap<Vec<i64>, Fraction> = BTreeMap::new();
    for series in group {
        let mut terms = vec![(vec![], series.factor.clone())];
        let steps = excess(series).into_iter().zip(smallest.iter().flatten());
        for (axis, (own, least)) in series.axes.iter().zip(steps) {
            let seeds = axis.raised(own - least).unwrap_or_default();
            terms = terms
                .iter()
                .flat_map(|(exponents, factor)| {
                    seeds
                        .iter()
                        .zip(axis.lowest..)
                        .map(move |(seed, exponent)| {
                            let exponents = exponents.iter().copied().chain([exponent]).collect();
                            (exponents, factor.clone() * seed.clone())
                        })
                })
                .collect();
        }
        for (exponents, value) in terms {
            let slot = total.entry(exponents).or_insert_with(Fraction::zero);
            *slot = slot.clone() + value;
        }
    }
    total.values().all(Fraction::is_zero)
}

/// Whether both have the same steps, comparable powers and the same targets.
fn comparable(one: &Series, other: &Series) -> bool {
    one.axes.len() == other.axes.len()
        && one.axes.iter().zip(&other.axes).all(|(a, b)| {
            let gap = a.power.clone() - b.power.clone();
            a.target == b.target && a.operator == b.operator && gap.as_number().is_some()
        })
        && one.points == other.points
}

/// The same as series that can be compared: an index that counts down is read from the other end, points
/// that begin at an offset are shifted, and powers of the index of an entry are taken into the operator.
fn canonical(series: &Series) -> Result<Vec<Series>, ExactError> {
    let mut parts = vec![series.clone()];
    for (position, axis) in series.axes.iter().enumerate() {
        let mut next = vec![];
        for part in parts {
            match &axis.target {
                Target::Sum => next.push(aligned(&part, position, axis)?),
                Target::Each(..) => next.push(part.clone()),
                Target::Entry(_) => next.extend(absorbed(&part, position, &from_zero(axis))),
            }
        }
        parts = next;
    }
    Ok(parts)
}

/// The series with this axis, an entry, and without powers of its index in the factor where there are any.
fn absorbed(series: &Series, position: usize, axis: &Axis) -> Vec<Series> {
    let whole = series.with_axis(position, axis.clone());
    let Target::Entry(index) = &axis.target else {
        return vec![whole];
    };
    let mut names = index.multiples();
    let (Some((name, 1)), None) = (names.next(), names.next()) else {
        return vec![whole];
    };
    let Some(parts) = split(&series.factor, name) else {
        return vec![whole];
    };
    let weighted = parts.into_iter().flat_map(|part| {
        let whole = Series {
            factor: part.free * part.points,
            ..whole.clone()
        };
        whole.weighted(position, 0, part.exponent)
    });
    weighted.collect()
}

/// An entry whose index counts up and has no offset.
fn from_zero(axis: &Axis) -> Axis {
    let counts_down = |index: &Affine| {
        let mut multiples = index.multiples();
        multiples.any(|(name, multiple)| multiple < 0 && axis.power.multiple_of(name) == 0)
    };
    let mut axis = match &axis.target {
        // [E^index] F(E) = [E^(top - index)] of F read backwards.
        Target::Entry(index) if counts_down(index) => axis.reversed(),
        _ => axis.clone(),
    };
    if let Target::Entry(index) = &mut axis.target {
        // [E^(i + c)] F = [E^i] of E^(-c) F.
        let offset = index.constant();
        axis.lowest -= offset;
        *index = index.clone() - Affine::number(offset);
    }
    axis
}

/// A sum in which the index of the first points counts up and has no offset.
fn aligned(series: &Series, position: usize, axis: &Axis) -> Result<Series, ExactError> {
    let name = here(position);
    let first = |points: &Fraction| -> Option<Affine> {
        let symbols = points.symbols().into_iter();
        let mut indices = symbols.filter_map(|symbol| match symbol {
            Symbol::Indexed(_, index) => index.into_iter().find(|i| i.multiple_of(&name) != 0),
            _ => None,
        });
        indices.next()
    };
    let (mut axis, mut points) = (axis.clone(), series.points.clone());
    if first(&points).is_some_and(|index| index.multiple_of(&name) < 0) {
        let back = axis.top() - Affine::symbol(&name);
        points = with_index(&points, &name, &back)?;
        axis = axis.reversed();
    }
    if let Some(index) = first(&points) {
        let offset = index.constant();
        let back = Affine::symbol(&name) - Affine::number(offset);
        points = with_index(&points, &name, &back)?;
        axis.lowest += offset;
    }
    Ok(Series {
        points,
        ..series.with_axis(position, axis)
    })
}

/// What the order of axes is decided by: steps, powers up to a number, and entries.
type Rank = (
    Vec<(Vec<Polynomial>, Affine, Option<Affine>)>,
    Vec<Polynomial>,
);

/// The axes in the order of least rank. Several axes of one rank stay as they are.
fn in_order(series: Series) -> Result<Series, ExactError> {
    let parts = |f: &Fraction| vec![f.numerator().clone(), f.denominator()];
    let rank = |series: &Series| -> Rank {
        let axes = series.axes.iter().map(|axis| {
            let step = [parts(&axis.operator.0), parts(&axis.operator.1)].concat();
            let power = axis.power.clone() - Affine::number(axis.power.constant());
            let entry = match &axis.target {
                Target::Entry(index) | Target::Each(_, index) => Some(index.clone()),
                Target::Sum => None,
            };
            (step, power, entry)
        });
        (axes.collect(), parts(&series.points))
    };
    let count = series.axes.len();
    if count < 2 {
        return Ok(series);
    }
    let mut best: Option<(Rank, Series)> = None;
    for order in orders(count) {
        let axes: Vec<Axis> = order
            .iter()
            .filter_map(|&old| series.axes.get(old).cloned())
            .collect();
        let forms = order
            .iter()
            .enumerate()
            .map(|(new, &old)| (here(old), Affine::symbol(&here(new))))
            .collect();
        let candidate = Series {
            axes,
            factor: series.factor.clone(),
            points: with_indices(&series.points, &forms)?,
        };
        let rank = rank(&candidate);
        if best.as_ref().is_none_or(|(least, _)| rank < *least) {
            best = Some((rank, candidate));
        }
    }
    Ok(best.map_or(series, |(_, candidate)| candidate))
}

/// All orders of the numbers below `count`.
fn orders(count: usize) -> Vec<Vec<usize>> {
    (0..count).fold(vec![vec![]], |orders, next| {
        let longer = orders.iter().flat_map(|order: &Vec<usize>| {
            (0..=order.len()).map(move |place| {
                let mut order = order.clone();
                order.insert(place, next);
                order
            })
        });
        longer.collect()
    })
}
