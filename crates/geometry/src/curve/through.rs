//! Cubic splines through points.
//!
//! With parameters `t[0] < .. < t[n]`, steps `h[i] = t[i+1] - t[i]` and slopes `m[i]` the curve of class C2 solves
//!
//! ```text
//! h[i] m[i-1] + 2 (h[i-1] + h[i]) m[i] + h[i-1] m[i+1] = 3 (h[i] d[i-1] + h[i-1] d[i]),   d[i] = (P[i+1] - P[i]) / h[i]
//! ```
//!
//! at the inner points, and one equation at each end: `m[0] = T` (clamped), `2 m[0] + m[1] = 3 d[0]` (natural), or the
//! same equation round the joint (periodic). The system is diagonally dominant and solved on f64. Its solution, as
//! control points of a B-spline, is the curve from then on: exactly C2, and past the points by what rounding left,
//! which is measured exactly.

use super::Spline;
use crate::coordinate::Coordinate;
use crate::error::{GeometryError, Place, Result};
use crate::vector::{add, norm, scale, sub};
use torse_algebra::Rational;

/// How the parameters of the points grow with their distances.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spacing {
    /// By the distance.
    Chord,
    /// By the square root of the distance.
    Centripetal,
    /// By one.
    Uniform,
}

impl Spacing {
    /// All with their names in files.
    pub const ALL: [(&'static str, Self); 3] = [
        ("chord", Self::Chord),
        ("centripetal", Self::Centripetal),
        ("uniform", Self::Uniform),
    ];
}

/// What holds at the ends of a spline through points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum EndCondition {
    /// No second derivative.
    Natural,
    /// This direction; its length does not matter, the speed is that of the parameter.
    Tangent([f64; 3]),
}

/// A spline through points, and how far it passes by them.
#[derive(Debug, Clone, PartialEq)]
pub struct Interpolation {
    /// The curve.
    pub spline: Spline,
    /// A bound for the distance of each point from the curve's point at its parameter, exact up to its own rounding.
    pub distance: f64,
}

/// The cubic C2 spline through these points, in order.
///
/// Two points with natural ends are joined by a straight cubic.
///
/// # Errors
/// [`GeometryError::TooFew`] for fewer than two points, [`GeometryError::NotFinite`], [`GeometryError::Degenerate`] for
/// neighbours at one place and tangents without direction, and as [`Spline::new`].
///
/// ```
/// use torse_geometry::curve::{EndCondition, Spacing, interpolate};
/// let points = [[0.0, 0.0, 0.0], [3.0, 4.0, 0.0], [6.0, 4.0, 2.0], [9.0, 0.0, 2.0]];
/// let found = interpolate(&points, Spacing::Chord, [EndCondition::Natural; 2])?;
/// assert_eq!(found.spline.pieces()?.len(), 3);
/// assert!(found.distance < 1e-13);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn interpolate(
    points: &[[f64; 3]],
    spacing: Spacing,
    ends: [EndCondition; 2],
) -> Result<Interpolation> {
    let steps = steps(points, spacing)?;
    let slopes = differences(points, &steps);
    let n = steps.len();
    // Rows of the tridiagonal system: below, on, above the diagonal, right side.
    let mut rows = Vec::with_capacity(n + 1);
    let end = |condition: EndCondition, slope: &[f64; 3]| match condition {
        EndCondition::Natural => Ok(([2.0, 1.0], scale(&3.0, slope))),
        EndCondition::Tangent(direction) => {
            let length = norm(&direction);
            if !(length > 0.0 && length.is_finite()) {
                return Err(GeometryError::Degenerate {
                    what: "a tangent without direction",
                    at: Place::Whole,
                });
            }
            // The speed of the chord, so that the curve does not depend on how long the direction was written.
            Ok(([1.0, 0.0], scale(&(norm(slope) / length), &direction)))
        }
    };
    let ([on, above], right) = end(ends[0], &slopes[0])?;
    rows.push(([0.0, on, above], right));
    rows.extend(inner(&steps, &slopes));
    let ([on, below], right) = end(ends[1], &slopes[n - 1])?;
    rows.push(([below, on, 0.0], right));
    let tangents = tridiagonal(rows);
    let knots = sums(&steps);
    let mut all = vec![Rational::default(); 3];
    all.extend(knots.iter().cloned());
    all.extend(std::iter::repeat_n(
        knots.last().cloned().unwrap_or_default(),
        3,
    ));
    let mut control = vec![
        points[0],
        add(&points[0], &scale(&(steps[0] / 3.0), &tangents[0])),
    ];
    for i in 1..n {
        control.push(inner_control(
            points,
            &steps,
            &tangents,
            i,
            [i - 1, i, i + 1],
        ));
    }
    control.push(sub(&points[n], &scale(&(steps[n - 1] / 3.0), &tangents[n])));
    control.push(points[n]);
    let spline = Spline::new(3, all, exact_points(&control), None)?;
    measured(spline, points, &knots)
}

/// The closed cubic C2 spline through these points, in order and back to the first.
///
/// # Errors
/// As [`interpolate`], for at least three points; the first need not be repeated, and must not be.
///
/// ```
/// use torse_geometry::curve::{Spacing, interpolate_closed};
/// let ring = interpolate_closed(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]], Spacing::Chord)?;
/// let [from, to] = ring.spline.domain();
/// assert_eq!(ring.spline.point(&from)?, ring.spline.point(&to)?);
/// assert!(ring.distance < 1e-14);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn interpolate_closed(points: &[[f64; 3]], spacing: Spacing) -> Result<Interpolation> {
    let n = points.len();
    if n < 3 {
        return Err(GeometryError::TooFew {
            what: "points of a closed spline",
            needed: 3,
            given: n,
        });
    }
    let ring: Vec<[f64; 3]> = points.iter().chain(points.first()).copied().collect();
    let steps = steps(&ring, spacing)?;
    let slopes = differences(&ring, &steps);
    // Row i of the cyclic system stands for point i.
    let row = |i: usize| {
        let (before, after) = (steps[(i + n - 1) % n], steps[i]);
        let right = add(
            &scale(&(3.0 * after), &slopes[(i + n - 1) % n]),
            &scale(&(3.0 * before), &slopes[i]),
        );
        ([after, 2.0 * (before + after), before], right)
    };
    let tangents = cyclic((0..n).map(row).collect());
    let control: Vec<[f64; 3]> = (0..n)
        .map(|i| {
            inner_control(
                &ring,
                &steps,
                &tangents,
                i,
                [(i + n - 1) % n, i, (i + 1) % n],
            )
        })
        .collect();
    let knots = sums(&steps);
    // Control point j of the spline belongs to the intervals from j - 3 to j: its middle knot is j - 1.
    let rotated: Vec<[f64; 3]> = (0..n).map(|j| control[(j + n - 1) % n]).collect();
    let spline = Spline::periodic(3, &knots, exact_points(&rotated), None)?;
    measured(spline, points, &knots)
}

fn steps(points: &[[f64; 3]], spacing: Spacing) -> Result<Vec<f64>> {
    if points.len() < 2 {
        return Err(GeometryError::TooFew {
            what: "points of a spline",
            needed: 2,
            given: points.len(),
        });
    }
    crate::coordinate::check_finite("point", points.iter().flatten())?;
    let step = |(index, pair): (usize, &[[f64; 3]])| {
        let [x, y, z] = sub(&pair[1], &pair[0]);
        let chord = libm::hypot(libm::hypot(x, y), z);
        if !(chord > 0.0 && chord.is_finite()) {
            return Err(GeometryError::Degenerate {
                what: "a spline through two neighbours at one place",
                at: Place::Index(index + 1),
            });
        }
        Ok(match spacing {
            Spacing::Chord => chord,
            Spacing::Centripetal => chord.sqrt(),
            Spacing::Uniform => 1.0,
        })
    };
    points.windows(2).enumerate().map(step).collect()
}

fn differences(points: &[[f64; 3]], steps: &[f64]) -> Vec<[f64; 3]> {
    let pairs = points.windows(2).zip(steps);
    pairs
        .map(|(pair, h)| sub(&pair[1], &pair[0]).map(|c| c / h))
        .collect()
}

/// The equations at the inner points.
fn inner(steps: &[f64], slopes: &[[f64; 3]]) -> Vec<([f64; 3], [f64; 3])> {
    let pairs = steps.windows(2).zip(slopes.windows(2));
    pairs
        .map(|(h, d)| {
            let right = add(&scale(&(3.0 * h[1]), &d[0]), &scale(&(3.0 * h[0]), &d[1]));
            ([h[1], 2.0 * (h[0] + h[1]), h[0]], right)
        })
        .collect()
}

/// The solution of a tridiagonal system by elimination.
fn tridiagonal(mut rows: Vec<([f64; 3], [f64; 3])>) -> Vec<[f64; 3]> {
    for i in 1..rows.len() {
        let ([_, on, above], right) = rows[i - 1];
        let ([below, ..], _) = rows[i];
        let factor = below / on;
        rows[i].0[1] -= factor * above;
        rows[i].1 = sub(&rows[i].1, &scale(&factor, &right));
    }
    let mut solution: Vec<[f64; 3]> = vec![[0.0; 3]; rows.len()];
    let mut later = [0.0; 3];
    for (slot, ([_, on, above], right)) in solution.iter_mut().zip(&rows).rev() {
        later = sub(right, &scale(above, &later)).map(|c| c / on);
        *slot = later;
    }
    solution
}

/// The solution of a cyclic system: the two corners are taken out by the formula of Sherman and Morrison.
fn cyclic(mut rows: Vec<([f64; 3], [f64; 3])>) -> Vec<[f64; 3]> {
    let n = rows.len();
    let (upper, lower) = (rows[0].0[0], rows[n - 1].0[2]);
    let shift = -rows[0].0[1];
    rows[0].0[1] -= shift;
    rows[n - 1].0[1] -= upper * lower / shift;
    let solution = tridiagonal(rows.clone());
    let mut column = rows;
    for (i, row) in column.iter_mut().enumerate() {
        let entry = if i == 0 {
            shift
        } else if i == n - 1 {
            lower
        } else {
            0.0
        };
        row.1 = [entry; 3];
    }
    let column = tridiagonal(column);
    let ratio = upper / shift;
    let factor: [f64; 3] = std::array::from_fn(|k| {
        (solution[0][k] + ratio * solution[n - 1][k])
            / (1.0 + column[0][k] + ratio * column[n - 1][k])
    });
    let pairs = solution.iter().zip(&column);
    pairs
        .map(|(x, z)| std::array::from_fn(|k| x[k] - factor[k] * z[k]))
        .collect()
}

/// The control point whose middle knot is that of a point: the polar form at the knots before, at and after it.
/// `indices` are those of the step before, of the point and its step, and of the point after.
fn inner_control(
    points: &[[f64; 3]],
    steps: &[f64],
    tangents: &[[f64; 3]],
    i: usize,
    [before, at, after]: [usize; 3],
) -> [f64; 3] {
    let (h, previous) = (steps[at], steps[before]);
    // The inner Bezier points of the piece after the point.
    let first = add(&points[i], &scale(&(h / 3.0), &tangents[at]));
    let second = sub(&points[i + 1], &scale(&(h / 3.0), &tangents[after]));
    sub(&first, &scale(&(previous / h), &sub(&second, &first)))
}

/// The parameters of the points, exact sums of the steps.
fn sums(steps: &[f64]) -> Vec<Rational> {
    let mut at = Rational::default();
    let mut all = vec![at.clone()];
    for step in steps {
        at += crate::exact(*step);
        all.push(at.clone());
    }
    all
}

fn exact_points(points: &[[f64; 3]]) -> Vec<[Rational; 3]> {
    points.iter().map(|p| p.map(crate::exact)).collect()
}

/// The distances of the points from those of the spline at their parameters, over the rationals.
fn measured(spline: Spline, points: &[[f64; 3]], knots: &[Rational]) -> Result<Interpolation> {
    let pieces = spline.pieces()?;
    let start = Rational::default();
    let end = Rational::from_integer(1.into());
    let mut distance = 0.0_f64;
    for (index, (point, _)) in points.iter().zip(knots).enumerate() {
        let there = match pieces.get(index) {
            Some(piece) => piece.point(&start)?,
            None => match pieces.last() {
                Some(piece) => piece.point(&end)?,
                None => continue,
            },
        };
        let off: [f64; 3] = std::array::from_fn(|k| {
            (there[k].clone() - crate::exact(point[k]))
                .approximate()
                .abs()
        });
        distance = distance.max(off.iter().sum());
    }
    Ok(Interpolation { spline, distance })
}
