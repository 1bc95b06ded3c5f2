//! Pieces of edges as rails: the planes they lie in, and their control points.

use super::plane::PlaneOfPoints;
use super::words;
use std::f64::consts::FRAC_PI_2;
use torse_geometry::basis::BasisShape;
use torse_geometry::curve::EllipticHelix;
use torse_geometry::prelude::{Point, Rail, RailCurve};
use torse_geometry::vector::{add, cross, scale, unit};

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
            let weights = curve.homogeneous().map(|(_, w)| *w).collect::<Vec<f64>>();
            (controls(curve.homogeneous()), Some(weights))
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

/// Returns a point and the normal of the plane in which a piece lies but for rounding, if it lies in one.
pub(super) fn plane_of(rail: &Rail) -> Option<(Point, Point)> {
    let points = match rail.curve() {
        RailCurve::Elliptic(arc) => {
            let [cosine, sine] = arc.axes();
            let normal = unit(&cross(cosine, sine)).filter(|_| *arc.rise() == [0.0; 3])?;
            return Some((*arc.centre(), normal));
        }
        RailCurve::Plain(curve) => curve.points().to_vec(),
        RailCurve::Weighted(curve) => controls(curve.homogeneous()),
    };
    let plane = PlaneOfPoints::new(&points)?;
    (plane.height <= FLAT * plane.reach).then_some((plane.frame.origin, plane.frame.axis))
}

/// Returns the control points of a curve from homogeneous ones.
fn controls<'a>(homogeneous: impl Iterator<Item = (&'a Point, &'a f64)>) -> Vec<Point> {
    let point = |(point, w): (&Point, &f64)| point.map(|c| c / w);
    homogeneous.map(point).collect()
}
