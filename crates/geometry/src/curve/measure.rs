//! Curvature, torsion and arc length of f64 curves, weighted ones included.

use super::{SpaceCurve, derivatives_of};
use crate::error::{GeometryError, Place, Result};
use crate::vector::{cross, det, norm};

/// The curvature `|G' x G''| / |G'|^3` at `x`.
///
/// # Errors
/// [`GeometryError::Degenerate`] where the curve stands still.
///
/// ```
/// use torse_geometry::curve::{curvature, ellipse_arc};
/// let circle = ellipse_arc(&[0.0; 3], &[2.0, 0.0, 0.0], &[0.0, 2.0, 0.0])?;
/// assert!((curvature(&circle, 0.3)? - 0.5).abs() < 1e-15);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn curvature(curve: &impl SpaceCurve<f64>, x: f64) -> Result<f64> {
    let jet = derivatives(curve, x, 2)?;
    let [_, d1, d2] = jet.as_slice() else {
        return Err(still(x));
    };
    let speed = norm(d1);
    if speed > 0.0 {
        Ok(norm(&cross(d1, d2)) / speed.powi(3))
    } else {
        Err(still(x))
    }
}

/// The torsion `det(G', G'', G''') / |G' x G''|^2` at `x`.
///
/// # Errors
/// [`GeometryError::Degenerate`] where the curvature vanishes, at inflections and on straight lines.
///
/// ```
/// use torse_geometry::{Bernstein, Curve, curve::torsion};
/// // (t, t^2, t^3) has torsion 3 and curvature 2 at t = 0.
/// let third = 1.0 / 3.0;
/// let cubic = vec![[0.0; 3], [third, 0.0, 0.0], [2.0 * third, third, 0.0], [1.0, 1.0, 1.0]];
/// assert!((torsion(&Curve::new(Bernstein, cubic)?, 0.0)? - 3.0).abs() < 1e-14);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn torsion(curve: &impl SpaceCurve<f64>, x: f64) -> Result<f64> {
    let jet = derivatives(curve, x, 3)?;
    let [_, d1, d2, d3] = jet.as_slice() else {
        return Err(still(x));
    };
    let binormal = norm(&cross(d1, d2));
    if binormal > 0.0 {
        Ok(det(d1, d2, d3) / (binormal * binormal))
    } else {
        Err(still(x))
    }
}

fn derivatives<const D: usize>(
    curve: &impl SpaceCurve<f64, D>,
    x: f64,
    order: usize,
) -> Result<Vec<[f64; D]>> {
    derivatives_of(&curve.space_jet(&x, order)?, order)
}

fn still(x: f64) -> GeometryError {
    GeometryError::Degenerate {
        what: "the curve has no frame",
        at: Place::Parameter(x),
    }
}

/// The smallest interval that [`arc_length`] halves to, as a number of halvings.
const MAX_DEPTH: u32 = 40;
/// The most intervals that [`arc_length`] visits: about a second of work.
const MAX_INTERVALS: usize = 200_000;

/// The arc length over `[from, to]` with an absolute error estimated to be at most `accuracy`.
///
/// Adaptive Gauss-Legendre: five points on an interval against five on each half; the difference
/// bounds the error of the better value as soon as the speed is smooth at that size.
///
/// # Errors
/// [`GeometryError::OutOfRange`] unless `accuracy > 0`, [`GeometryError::NotConverged`] when the
/// accuracy is out of reach of f64.
///
/// ```
/// use torse_geometry::curve::{arc_length, ellipse_arc};
/// let circle = ellipse_arc(&[0.0, 0.0], &[2.0, 0.0], &[0.0, 2.0])?;
/// assert!((arc_length(&circle, [0.0, 1.0], 1e-12)? - std::f64::consts::PI).abs() < 1e-12);
/// // The same quarter circle as a weighted parabola, at another speed.
/// use torse_geometry::{Bernstein, RationalCurve};
/// let points = [[2.0, 0.0], [2.0, 2.0], [0.0, 2.0]];
/// let weighted = RationalCurve::new(Bernstein, &points, vec![1.0, 1.0, 2.0])?;
/// assert!((arc_length(&weighted, [0.0, 1.0], 1e-12)? - std::f64::consts::PI).abs() < 1e-12);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn arc_length<const D: usize>(
    curve: &impl SpaceCurve<f64, D>,
    [from, to]: [f64; 2],
    accuracy: f64,
) -> Result<f64> {
    let speed = |x: f64| -> Result<f64> {
        let jet = derivatives(curve, x, 1)?;
        jet.get(1).map(norm).ok_or_else(|| still(x))
    };
    integrate(speed, [from, to], accuracy, "arc length")
}

/// Adaptive Gauss-Legendre quadrature; see [`arc_length`].
pub(crate) fn integrate(
    f: impl Fn(f64) -> Result<f64>,
    [from, to]: [f64; 2],
    accuracy: f64,
    what: &'static str,
) -> Result<f64> {
    if !(accuracy > 0.0 && from.is_finite() && to.is_finite()) {
        return Err(GeometryError::OutOfRange {
            name: "accuracy",
            value: accuracy,
            range: "(0, infinity) on a finite interval",
        });
    }
    let gauss = |a: f64, b: f64| -> Result<f64> {
        let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
        let mut sum = GAUSS_CENTRE * f(middle)?;
        for (node, weight) in GAUSS_PAIRS {
            sum += weight * (f(middle - half * node)? + f(middle + half * node)?);
        }
        Ok(half * sum)
    };
    let mut open = vec![(from, to, gauss(from, to)?, accuracy, 0_u32)];
    let (mut total, mut lost, mut visited) = (0.0, 0.0_f64, 0_usize);
    while let Some((a, b, whole, allowed, depth)) = open.pop() {
        visited += 1;
        let middle = 0.5 * (a + b);
        let (left, right) = (gauss(a, middle)?, gauss(middle, b)?);
        let error = (left + right - whole).abs();
        // Below this the difference is rounding, not truncation.
        let rounding = 8.0 * f64::EPSILON * (left.abs() + right.abs());
        if error <= allowed.max(rounding) {
            total += left + right;
            lost += error.min(allowed);
        } else if depth >= MAX_DEPTH || visited > MAX_INTERVALS {
            return Err(GeometryError::NotConverged {
                what,
                reached: lost + error,
                demanded: accuracy,
            });
        } else {
            open.push((a, middle, left, 0.5 * allowed, depth + 1));
            open.push((middle, b, right, 0.5 * allowed, depth + 1));
        }
    }
    Ok(total)
}

/// Nodes and weights of the five-point Gauss-Legendre rule on [-1, 1] (exact to degree 9).
const GAUSS_CENTRE: f64 = 128.0 / 225.0;
const GAUSS_PAIRS: [(f64, f64); 2] = [
    (0.538_469_310_105_683, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];
