//! Whether a sheet is an arc of a circular cylinder, decided from its control data: a bound, not a sample.

use super::{Construction, Point, Rail, RailCurve, Sheet};
use crate::basis::BasisShape;
use crate::curve::EllipticHelix;
use crate::vector::{add, cross, dot, norm, scale, sub, unit};

/// A circular cylinder, and a bound for how far a sheet is from it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CircularCylinder {
    /// A point of its axis.
    pub centre: Point,
    /// The direction of its axis, of length one.
    pub axis: Point,
    /// Its radius.
    pub radius: f64,
    /// No point of the sheet is farther from it.
    pub off: f64,
}

/// Rulings that differ from one direction by no more, as a share, are parallel.
const PARALLEL: f64 = 1e-9;

impl Sheet {
    /// Returns the circular cylinder through three points of the first edge whose axis is parallel to the rulings, and how
    /// far the sheet is from it at most: by the Bernstein coefficients of the square of the distance from the axis, or by the
    /// axes of an arc of an ellipse. `None` of a sheet whose rulings are not parallel, that is plane, or whose edges are
    /// neither Bezier curves nor arcs.
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// let edges = [SweptEdge::Share(0.0), SweptEdge::Share(1.0)];
    /// let round = Rail::ellipse_arc([0.0; 3], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0])?;
    /// let found = Sheet::cylinder(&round, [0.0, 0.0, 9.0], edges)?.circular_cylinder().ok_or("no cylinder")?;
    /// assert!((found.radius - 2.0).abs() < 1e-12 && found.off < 1e-12);
    /// // The curvature of this one is the same at its ends and in its middle, and not between them.
    /// let x = 12.59921049894873;
    /// let cubic = Rail::bezier(&[[0.0; 3], [x, 0.0, 0.0], [x, 0.0, 20.0], [0.0, 0.0, 20.0]])?;
    /// let found = Sheet::cylinder(&cubic, [0.0, 9.0, 0.0], edges)?.circular_cylinder().ok_or("no cylinder")?;
    /// assert!(found.off > 0.1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn circular_cylinder(&self) -> Option<CircularCylinder> {
        match self.construction() {
            Construction::Cylinder(patch) => round(patch.curve(), patch.direction()),
            Construction::Ruled(patch) => {
                let (first, second) = (patch.first(), patch.second());
                let direction = sub(&second.point(0.0).ok()?, &first.point(0.0).ok()?);
                are_translated(first, second, &direction).then(|| round(first, direction))?
            }
            // Its rulings are some of those of the whole.
            Construction::Part(part) => part.whole().circular_cylinder(),
            Construction::Cone(_)
            | Construction::Envelope(_)
            | Construction::Tangent(_)
            | Construction::Connecting(_) => None,
        }
    }
}

/// Returns the cylinder on which a curve lies, seen along a direction.
fn round(curve: &Rail, direction: Point) -> Option<CircularCylinder> {
    let axis = unit(&direction)?;
    let along = |p: &Point| scale(&dot(p, &axis), &axis);
    let flat = |p: &Point| sub(p, &along(p));
    let places = [0.0, 1.0 / 3.0, 2.0 / 3.0].map(|x| curve.point(x).map(|p| flat(&p)));
    let [Ok(a), Ok(b), Ok(c)] = places else {
        return None;
    };
    let cylinder = |centre: Point, radius: f64, off: f64| {
        let is_one = radius.is_finite() && radius > 0.0 && off.is_finite();
        is_one.then_some(CircularCylinder {
            centre,
            axis,
            radius,
            off,
        })
    };
    if let Some(arc) = elliptic(curve) {
        let [p, q] = arc.axes().map(flat);
        let radius = norm(&p);
        let most = arc.range().iter().fold(0.0_f64, |m, q| m.max(q.abs()));
        // The square of the distance is that of the radius but for these.
        let square = (dot(&q, &q) - radius * radius).abs() + dot(&p, &q).abs();
        let off = square / radius + most * norm(&flat(arc.rise()));
        return cylinder(flat(arc.centre()), radius, off);
    }
    // The centre of the circle through three points.
    let (u, v) = (sub(&b, &a), sub(&c, &a));
    let normal = cross(&u, &v);
    let square = dot(&normal, &normal);
    let towards = |w: &Point, by: f64| scale(&(by / (2.0 * square)), w);
    let arm = [
        towards(&cross(&v, &normal), dot(&u, &u)),
        towards(&cross(&normal, &u), dot(&v, &v)),
    ];
    let arm: Point = std::array::from_fn(|i| arm[0][i] + arm[1][i]);
    let (centre, radius) = (std::array::from_fn(|i| a[i] + arm[i]), norm(&arm));
    let control = control(curve)?;
    let moved = control
        .iter()
        .map(|(p, w)| (sub(&flat(p), &scale(w, &centre)), *w));
    let moved: Vec<(Point, f64)> = moved.collect();
    let least = moved.iter().map(|(_, w)| *w).fold(f64::INFINITY, f64::min);
    // |M|^2 - r^2 W^2 in Bernstein form.
    let degree = moved.len() - 1;
    let mut largest = 0.0_f64;
    for k in 0..=2 * degree {
        let pairs =
            (0..=degree).filter_map(|i| Some((i, k.checked_sub(i).filter(|j| *j <= degree)?)));
        let sum: f64 = pairs
            .filter_map(|(i, j)| {
                let ((p, w), (q, z)) = (moved.get(i)?, moved.get(j)?);
                let share = binomial(degree, i) * binomial(degree, j) / binomial(2 * degree, k);
                Some(share * (dot(p, q) - radius * radius * w * z))
            })
            .sum();
        largest = largest.max(sum.abs());
    }
    (least > 0.0).then(|| cylinder(centre, radius, largest / (least * least * radius)))?
}

/// Returns the arc of an ellipse that a curve is.
fn elliptic(curve: &Rail) -> Option<EllipticHelix> {
    match curve.curve() {
        RailCurve::Elliptic(arc) => Some(arc.clone()),
        // Without blending, with three control points: (1 - sin) p + (sin + cos - 1) m + (1 - cos) q.
        RailCurve::Plain(curve) => match (curve.basis(), curve.points()) {
            (BasisShape::Gbt(basis), [p, m, q]) if *basis.mu() == 0.0 && *basis.nu() == 0.0 => {
                let centre = sub(&add(p, q), m);
                let (cosine, sine) = (sub(m, q), sub(m, p));
                EllipticHelix::new(centre, cosine, sine, [0.0; 3], [0.0, 1.0]).ok()
            }
            _ => None,
        },
        RailCurve::Weighted(_) => None,
    }
}

/// Returns the control points of a Bezier curve, times their weights, and the weights.
fn control(curve: &Rail) -> Option<Vec<(Point, f64)>> {
    match curve.curve() {
        RailCurve::Plain(curve) if *curve.basis() == BasisShape::Bernstein => {
            Some(curve.points().iter().map(|p| (*p, 1.0)).collect())
        }
        RailCurve::Weighted(curve) if *curve.basis() == BasisShape::Bernstein => {
            Some(curve.homogeneous().map(|(p, w)| (*p, *w)).collect())
        }
        _ => None,
    }
}

/// Returns whether points of equal parameter of two curves differ by multiples of a direction.
fn are_translated(first: &Rail, second: &Rail, direction: &Point) -> bool {
    let small = PARALLEL * norm(direction);
    let is_along = |p: &Point, q: &Point, room: f64| {
        norm(&cross(&sub(q, p), direction)) <= small * (norm(direction) + room)
    };
    if let (Some(p), Some(q)) = (elliptic(first), elliptic(second)) {
        let size = norm(p.axes()[0]);
        let moving = p
            .axes()
            .into_iter()
            .zip(q.axes())
            .chain([(p.rise(), q.rise()), (p.centre(), q.centre())]);
        return p.range() == q.range() && moving.into_iter().all(|(p, q)| is_along(p, q, size));
    }
    let (Some(p), Some(q)) = (control(first), control(second)) else {
        return false;
    };
    let pairs = || p.iter().zip(&q);
    p.len() == q.len() && pairs().all(|((p, w), (q, z))| w == z && is_along(p, q, norm(p)))
}

fn binomial(n: usize, k: usize) -> f64 {
    let counts = (1..=n).map(|i| f64::from(u32::try_from(i).unwrap_or(u32::MAX)));
    let above = counts.clone().rev();
    above
        .zip(counts)
        .take(k.min(n - k))
        .fold(1.0, |value, (a, b)| value * a / b)
}
