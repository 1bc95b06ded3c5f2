//! Cones and cylinders over any curve.
//!
//! Translations and dilations are affine, so they act on control points. A plane cuts the cone with apex `o` over a
//! curve `c` in the image `o + s (c - o)`, `s = n . (a - o) / n . (c - o)`: since the functions of a basis sum to one,
//! that is the curve with the projected control points and the weights `n . (b - o) / n . (a - o)`, in every basis.

use torse_geometry::Affine;
use torse_geometry::prelude::{GeometryError, Place, Point, Rail};
use torse_geometry::sheet::RailCurve;
use torse_geometry::vector::{add, dot, scale, sub};

type Result<T> = std::result::Result<T, GeometryError>;

/// The control points and weights of a curve; an arc of any angle has none.
fn control(rail: &Rail) -> Vec<(Point, f64)> {
    match rail.curve() {
        RailCurve::Elliptic(_) => Vec::new(),
        RailCurve::Plain(curve) => curve.points().iter().map(|p| (*p, 1.0)).collect(),
        RailCurve::Weighted(curve) => {
            let parts = curve.homogeneous();
            parts.map(|(p, w)| (p.map(|c| c / w), *w)).collect()
        }
    }
}

/// The curve with the control points and factors of the weights that `map` makes.
fn mapped(rail: &Rail, map: impl Fn(&Point) -> (Point, f64)) -> Result<Rail> {
    let shape = match rail.curve() {
        RailCurve::Plain(curve) => *curve.basis(),
        RailCurve::Weighted(curve) => *curve.basis(),
        RailCurve::Elliptic(_) => {
            return Err(GeometryError::Degenerate {
                what: "a plane that cuts a cone over an arc of any angle: quarters of an ellipse (`arc` with `to`) are cut",
                at: Place::Whole,
            });
        }
    };
    let images: Vec<(Point, f64)> = control(rail)
        .iter()
        .map(|(p, w)| {
            let (image, factor) = map(p);
            (image, w * factor)
        })
        .collect();
    let points: Vec<Point> = images.iter().map(|(p, _)| *p).collect();
    let weights: Vec<f64> = images.iter().map(|(_, w)| *w).collect();
    // Equal weights are none.
    match weights.first() {
        Some(first) if weights.iter().any(|w| w != first) => {
            Rail::weighted(shape, &points, &weights)
        }
        _ => Rail::new(shape, &points),
    }
}

const IDENTITY: [Point; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The image of a curve that is known by its formula.
fn affine(rail: &Rail, linear: [Point; 3], shift: Point) -> Result<Rail> {
    let image = rail.mapped(&Affine { linear, shift });
    // What left the range of f64 is refused.
    image.point(0.5)?;
    Ok(image)
}

/// The curve moved by a vector.
pub fn moved(rail: &Rail, by: &Point) -> Result<Rail> {
    if matches!(rail.curve(), RailCurve::Elliptic(_)) {
        return affine(rail, IDENTITY, *by);
    }
    mapped(rail, |p| (add(p, by), 1.0))
}

/// The image of a curve in the dilation about a point.
pub fn dilated(rail: &Rail, apex: &Point, ratio: f64) -> Result<Rail> {
    if matches!(rail.curve(), RailCurve::Elliptic(_)) {
        let linear = IDENTITY.map(|row| scale(&ratio, &row));
        return affine(rail, linear, scale(&(1.0 - ratio), apex));
    }
    mapped(rail, |p| (add(apex, &scale(&ratio, &sub(p, apex))), 1.0))
}

/// Where the lines through a curve in one direction meet a plane.
pub fn projected(rail: &Rail, direction: &Point, plane: &[f64; 4]) -> Result<Rail> {
    let [p, q, r, s] = *plane;
    let normal = [p, q, r];
    let slope = dot(&normal, direction);
    if slope == 0.0 {
        return Err(GeometryError::Degenerate {
            what: "a cylinder cut by a plane along its rulings",
            at: Place::Whole,
        });
    }
    if matches!(rail.curve(), RailCurve::Elliptic(_)) {
        // The projection along a direction is affine.
        let row = |i: usize| sub(&IDENTITY[i], &scale(&(direction[i] / slope), &normal));
        return affine(
            rail,
            [row(0), row(1), row(2)],
            scale(&(s / slope), direction),
        );
    }
    mapped(rail, |b| {
        let t = (s - dot(&normal, b)) / slope;
        (add(b, &scale(&t, direction)), 1.0)
    })
}

/// Where the rulings of the cone over a curve meet a plane, on the side of the curve.
pub fn cut(rail: &Rail, apex: &Point, plane: &[f64; 4]) -> Result<Rail> {
    let [p, q, r, s] = *plane;
    let normal = [p, q, r];
    let reach = s - dot(&normal, apex);
    if reach == 0.0 {
        return Err(GeometryError::Degenerate {
            what: "a cone cut by a plane through its apex",
            at: Place::Whole,
        });
    }
    let weight = |b: &Point| dot(&normal, &sub(b, apex)) / reach;
    for (index, (b, _)) in control(rail).iter().enumerate() {
        let weight = weight(b);
        if weight.is_nan() || weight <= 0.0 {
            let what = "control point";
            return Err(GeometryError::BehindApex { what, index });
        }
    }
    mapped(rail, |b| {
        let weight = weight(b);
        (add(apex, &scale(&(1.0 / weight), &sub(b, apex))), weight)
    })
}

/// Whether all control points are one: the curve stands still, at an apex.
pub fn is_point(rail: &Rail) -> bool {
    if let RailCurve::Elliptic(arc) = rail.curve() {
        let moving = arc.axes().into_iter().chain([arc.rise()]);
        return moving.flatten().all(|c| *c == 0.0);
    }
    let control = control(rail);
    let first = control.first();
    first.is_some_and(|(first, _)| control.iter().all(|(p, _)| p == first))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arc() -> Rail {
        Rail::ellipse_arc([0.0; 3], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]).unwrap()
    }

    #[test]
    fn an_oblique_plane_cuts_a_cone_on_its_rulings() {
        let (apex, plane) = ([0.0, 0.0, 10.0], [0.2, 0.1, 1.0, 4.0]);
        let image = cut(&arc(), &apex, &plane).unwrap();
        for k in 0..=8 {
            let x = f64::from(k) / 8.0;
            let (here, there) = (arc().point(x).unwrap(), image.point(x).unwrap());
            let height = plane[0] * there[0] + plane[1] * there[1] + plane[2] * there[2];
            assert!((height - plane[3]).abs() < 1e-13);
            let (a, b) = (sub(&here, &apex), sub(&there, &apex));
            let off = torse_geometry::vector::cross(&a, &b);
            assert!(off.iter().all(|c| c.abs() < 1e-12), "{off:?}");
        }
    }

    #[test]
    fn an_oblique_plane_cuts_a_cylinder_on_its_rulings() {
        let (direction, plane) = ([0.0, 1.0, 2.0], [0.3, 0.0, 1.0, 4.0]);
        let image = projected(&arc(), &direction, &plane).unwrap();
        for k in 0..=8 {
            let x = f64::from(k) / 8.0;
            let (here, there) = (arc().point(x).unwrap(), image.point(x).unwrap());
            let height = plane[0] * there[0] + plane[2] * there[2];
            assert!((height - plane[3]).abs() < 1e-13);
            let off = torse_geometry::vector::cross(&sub(&there, &here), &direction);
            assert!(off.iter().all(|c| c.abs() < 1e-12), "{off:?}");
        }
    }

    #[test]
    fn cuts_that_are_none_are_refused() {
        assert!(cut(&arc(), &[0.0, 0.0, 10.0], &[0.0, 0.0, 1.0, 12.0]).is_err());
        assert!(cut(&arc(), &[0.0, 0.0, 10.0], &[0.0, 0.0, 1.0, 10.0]).is_err());
        assert!(projected(&arc(), &[1.0, 0.0, 0.0], &[0.0, 0.0, 1.0, 1.0]).is_err());
    }
}
