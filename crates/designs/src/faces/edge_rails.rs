//! Pieces of edges as rails: the planes they lie in, and their control points.

use super::words;
use std::f64::consts::FRAC_PI_2;
use torse_geometry::basis::BasisShape;
use torse_geometry::curve::EllipticHelix;
use torse_geometry::prelude::{Point, Rail, RailCurve};
use torse_geometry::vector::{add, cross, dot, norm, scale, sub, unit};

/// Points within this share of their size of a plane are in it.
const FLAT: f64 = 1e-9;

/// Returns a piece that begins and ends in the given points.
pub(super) fn ending(rail: &Rail, [first, last]: [Option<Point>; 2]) -> Result<Rail, String> {
    if first.is_none() && last.is_none() {
        return Ok(rail.clone());
    }
    let (mut points, weights) = match rail.curve() {
        RailCurve::Elliptic(arc) => return ending(&quadratic(arc)?, [first, last]),
        RailCurve::Plain(curve) => (curve.points().to_vec(), None),
        RailCurve::Weighted(curve) => {
            let (points, weights): (Vec<Point>, Vec<f64>) = curve
                .homogeneous()
                .map(|(point, w)| (point.map(|c| c / w), *w))
                .unzip();
            (points, Some(weights))
        }
    };
    if let (Some(point), Some(slot)) = (first, points.first_mut()) {
        *slot = point;
    }
    if let (Some(point), Some(slot)) = (last, points.last_mut()) {
        *slot = point;
    }
    match weights {
        Some(weights) => Rail::weighted(BasisShape::Bernstein, &points, &weights),
        None => Rail::bezier(&points),
    }
    .map_err(words)
}

/// Returns an arc of less than half a turn as a curve of degree two with weights.
pub(super) fn quadratic(arc: &EllipticHelix) -> Result<Rail, String> {
    let [from, to] = *arc.range();
    let half = 0.5 * (to - from).abs() * FRAC_PI_2;
    let cosine = libm::cos(half);
    if *arc.rise() != [0.0; 3] || cosine <= 0.0 {
        return Err("an edge is no arc of an ellipse of less than half a turn".to_owned());
    }
    let [x, y] = arc.axes();
    let (sine, along) = libm::sincos(0.5 * (from + to) * FRAC_PI_2);
    let middle = add(&scale(&(along / cosine), x), &scale(&(sine / cosine), y));
    let rail = Rail::from(arc.clone());
    let points = [
        rail.point(0.0).map_err(words)?,
        add(arc.centre(), &middle),
        rail.point(1.0).map_err(words)?,
    ];
    Rail::weighted(BasisShape::Bernstein, &points, &[1.0, cosine, 1.0]).map_err(words)
}

/// Returns the first of points, and the normal of the plane in which all of them lie but for rounding.
pub(super) fn plane_of(points: &[Point]) -> (Point, Option<Point>) {
    let Some(origin) = points.first().copied() else {
        return ([0.0; 3], None);
    };
    let far = |p: &Point| norm(&sub(p, &origin));
    let arm = points.iter().max_by(|a, b| far(a).total_cmp(&far(b)));
    let arm = arm.map_or([0.0; 3], |p| sub(p, &origin));
    let beside = |p: &Point| cross(&arm, &sub(p, &origin));
    let widest = points
        .iter()
        .max_by(|a, b| norm(&beside(a)).total_cmp(&norm(&beside(b))));
    let Some(normal) = widest.and_then(|p| unit(&beside(p))) else {
        return (origin, None);
    };
    let height = points
        .iter()
        .map(|p| dot(&sub(p, &origin), &normal).abs())
        .fold(0.0, f64::max);
    (origin, (height <= FLAT * norm(&arm)).then_some(normal))
}
