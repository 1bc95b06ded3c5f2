//! Degenerate plane families: all parallel, or all through one line.

use super::{Plane, normal_of};
use crate::coordinate::Coordinate;
use crate::error::{GeometryError, Result};

/// Refuses control planes of rank two or less, which envelop no surface: parallel ones, and pencils
/// (all planes of the family then share one line).
pub(super) fn check<S: Coordinate>(planes: &[Plane<S>]) -> Result<()> {
    let Some(first) = planes.first() else {
        return Ok(());
    };
    let a = normal_of(first);
    let Some(index) = planes.iter().position(|p| !parallel(&a, &normal_of(p))) else {
        return Err(GeometryError::ParallelPlanes {
            first: 0,
            second: planes.len().saturating_sub(1),
        });
    };
    let spanned = |c: &Plane<S>| {
        planes
            .get(index)
            .is_some_and(|second| dependent([first, second, c]))
    };
    if planes.iter().all(spanned) {
        return Err(GeometryError::Pencil {
            first: 0,
            second: index,
        });
    }
    Ok(())
}

fn parallel<S: Coordinate>(a: &[S; 3], b: &[S; 3]) -> bool {
    [(1, 2), (2, 0), (0, 1)]
        .into_iter()
        .all(|(i, j)| minor(&[a, b], [i, j]).vanishes())
}

/// Whether three planes are linearly dependent: all four minors vanish.
fn dependent<S: Coordinate>(planes: [&Plane<S>; 3]) -> bool {
    let [a, b, c] = planes;
    (0..4).all(|left_out| {
        let kept: Vec<usize> = (0..4).filter(|&i| i != left_out).collect();
        let [i, j, k] = kept.as_slice() else {
            return true;
        };
        let expansion = [(*i, [*j, *k]), (*j, [*k, *i]), (*k, [*i, *j])]
            .map(|(column, others)| minor(&[b, c], others).times(&a[column]));
        let [x, y, z] = expansion;
        x.plus(y).plus(z).vanishes()
    })
}

/// A value with the sum of the absolute values of the terms that it was added up from.
struct Weighed<S> {
    value: S,
    magnitude: S,
}

impl<S: Coordinate> Weighed<S> {
    fn times(self, factor: &S) -> Self {
        Self {
            value: self.value * factor.clone(),
            magnitude: self.magnitude * factor.magnitude(),
        }
    }

    fn plus(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            magnitude: self.magnitude + other.magnitude,
        }
    }

    fn vanishes(&self) -> bool {
        self.value.cancels(&self.magnitude)
    }
}

fn minor<S: Coordinate, const D: usize>([a, b]: &[&[S; D]; 2], [i, j]: [usize; 2]) -> Weighed<S> {
    let (p, q) = (a[i].clone() * b[j].clone(), a[j].clone() * b[i].clone());
    Weighed {
        magnitude: p.magnitude() + q.magnitude(),
        value: p - q,
    }
}
