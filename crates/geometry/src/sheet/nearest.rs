//! The box around a rail, and its point nearest to another: enclosed, not sampled.

use super::{Point, Rail, RailCurve};
use crate::basis::BasisShape;
use crate::coordinate::Coordinate;
use crate::curve::{Curve, EllipticHelix, RationalCurve, least};
use crate::error::{GeometryError, Place, Result};
use crate::over::Over;
use crate::scalars::{exact, exact_ball};
use torse_algebra::{Ball, Jet};

/// The point of a rail nearest to another point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// Its parameter.
    pub x: f64,
    /// The point.
    pub point: Point,
    /// The least distance, within the accuracy asked for.
    pub distance: f64,
}

/// Bits of the balls, of a rail of size one: squares of distances are known to 1e-37.
const BITS: usize = 128;
/// The finest accuracy as a share of the size: bounds are rounded to f64.
const ROUNDING: f64 = 4e-15;

impl Rail {
    /// Returns the least and the greatest corner of a box with sides along the axes: the rail does not leave it, and no
    /// side can be moved inwards by more than `accuracy` (a length; not below 4e-15 of the size of the rail).
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] unless the accuracy is positive, [`GeometryError::NotConverged`] where enclosures
    /// do not come so close.
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// let arch = Rail::bezier(&[[0.0, 0.0, 1.0], [1.0, 2.0, 1.0], [2.0, 0.0, 1.0]])?;
    /// let [low, high] = arch.bounding_box(1e-9)?;
    /// // Lower than its control points.
    /// assert!((high[1] - 1.0).abs() < 1e-9 && low[1].abs() < 1e-9 && (high[0] - 2.0).abs() < 1e-9);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn bounding_box(&self, accuracy: f64) -> Result<[Point; 2]> {
        check_accuracy(accuracy)?;
        let Some((units, scaled)) = self.about([0.0; 3])? else {
            return Ok([[0.0; 3]; 2]);
        };
        let within = accuracy.times_two_to(-units).max(ROUNDING);
        let side = |axis: usize, sign: f64| -> Result<f64> {
            let coordinate = |jets: &[Jet<Ball>; 3]| {
                let jet = jets[axis].clone();
                if sign < 0.0 { -jet } else { jet }
            };
            let least = least(&scaled, BITS, coordinate, |value| value, within)
                .map_err(|error| in_units(error, units))?;
            // Plus zero: no negative zero.
            back(sign * least.low, units).map(|value| value + 0.0)
        };
        let corner =
            |sign: f64| -> Result<Point> { Ok([side(0, sign)?, side(1, sign)?, side(2, sign)?]) };
        Ok([corner(1.0)?, corner(-1.0)?])
    }

    /// Returns the point of the rail nearest to `point`, one of them where there are several: no other is nearer by
    /// more than `accuracy` (a length; not below 4e-15 of the greatest distance).
    ///
    /// # Errors
    /// [`GeometryError::NotFinite`], and as [`Rail::bounding_box`].
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// let arc = Rail::ellipse_arc([0.0; 3], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0])?;
    /// let nearest = arc.nearest([3.0, 3.0, 1.0], 1e-9)?;
    /// assert!((nearest.x - 0.5).abs() < 1e-4);
    /// assert!((nearest.distance - (18.0_f64.sqrt() - 2.0).hypot(1.0)).abs() < 1e-9);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn nearest(&self, point: Point, accuracy: f64) -> Result<Nearest> {
        check_accuracy(accuracy)?;
        crate::coordinate::check_finite("point", &point)?;
        let at = |x: f64, distance: f64| {
            let point = self.point(x)?;
            Ok(Nearest { x, point, distance })
        };
        let Some((units, scaled)) = self.about(point)? else {
            return at(0.0, 0.0);
        };
        let within = accuracy.times_two_to(-units).max(ROUNDING);
        let square = |jets: &[Jet<Ball>; 3]| {
            let [x, y, z] = jets.each_ref().map(|jet| jet.clone() * jet.clone());
            x + y + z
        };
        let length = |square: f64| square.max(0.0).sqrt();
        let found =
            least(&scaled, BITS, square, length, within).map_err(|error| in_units(error, units))?;
        at(found.x, back(found.high.max(0.0).sqrt(), units)?)
    }

    /// Returns the rail seen from a point, in units of a power of two in which it is about as large as one, and that
    /// power; exact, on balls. `None` of a rail that never leaves the point.
    fn about(&self, origin: Point) -> Result<Option<(i32, Rail<Ball>)>> {
        let origin = origin.map(exact);
        let ball = |x: &f64| exact_ball(*x, BITS);
        let over = |shape: &BasisShape<f64>| shape.over(&ball);
        let control: Vec<_> = match self.curve() {
            RailCurve::Plain(curve) => curve.points().iter().map(|p| (p, 1.0)).collect(),
            RailCurve::Weighted(curve) => curve.homogeneous().map(|(p, w)| (p, *w)).collect(),
            RailCurve::Elliptic(curve) => return arc_about(curve, &origin),
        };
        // Of a weighted curve the homogeneous points, and weights that are near one as well.
        let heaviest = control.iter().fold(0.0_f64, |m, (_, w)| m.max(*w));
        let weights = heaviest.exponent().unwrap_or(0);
        let seen: Vec<_> = control
            .iter()
            .map(|(p, w)| {
                let w = exact(*w).times_two_to(-weights);
                let from = |axis: usize| {
                    exact(p[axis]).times_two_to(-weights) - w.clone() * origin[axis].clone()
                };
                ([from(0), from(1), from(2)], w)
            })
            .collect();
        let size = seen.iter().flat_map(|(p, _)| p);
        let size = size.fold(0.0_f64, |m, c| m.max(c.approximate().abs()));
        let Some(units) = size.min(f64::MAX).exponent() else {
            return Ok(None);
        };
        let points = seen.iter().map(|(p, _)| {
            p.each_ref()
                .map(|c| Ball::from_rational(&c.times_two_to(-units), BITS))
        });
        let curve = match self.curve() {
            RailCurve::Plain(curve) => {
                RailCurve::Plain(Curve::new(over(curve.basis())?, points.collect())?)
            }
            RailCurve::Weighted(curve) => {
                let weights = seen.iter().map(|(_, w)| Ball::from_rational(w, BITS));
                RailCurve::Weighted(RationalCurve::from_homogeneous(
                    over(curve.basis())?,
                    points.collect(),
                    weights.collect(),
                )?)
            }
            RailCurve::Elliptic(_) => return Ok(None),
        };
        Ok(Some((units, Rail { curve, given: None })))
    }
}

/// As [`Rail::about`], of an arc of an ellipse.
fn arc_about(
    curve: &EllipticHelix,
    origin: &[torse_algebra::Rational; 3],
) -> Result<Option<(i32, Rail<Ball>)>> {
    let [cosine, sine] = curve.axes();
    let [from, to] = *curve.range();
    let centre: [_; 3] = std::array::from_fn(|k| exact(curve.centre()[k]) - origin[k].clone());
    let axes = cosine.iter().chain(sine).map(|c| c.abs());
    let climb = curve
        .rise()
        .iter()
        .map(|c| c.abs() * from.abs().max(to.abs()));
    let away = centre.iter().map(|c| c.approximate().abs());
    let size = axes.chain(climb).chain(away).fold(0.0_f64, f64::max);
    let Some(units) = size.min(f64::MAX).exponent() else {
        return Ok(None);
    };
    let scaled =
        |v: &[f64; 3]| v.map(|c| Ball::from_rational(&exact(c).times_two_to(-units), BITS));
    let centre = centre.map(|c| Ball::from_rational(&c.times_two_to(-units), BITS));
    let range = [from, to].map(|x| exact_ball(x, BITS));
    let arc = EllipticHelix::new(
        centre,
        scaled(cosine),
        scaled(sine),
        scaled(curve.rise()),
        range,
    )?;
    Ok(Some((units, arc.into())))
}

fn check_accuracy(accuracy: f64) -> Result<()> {
    if accuracy > 0.0 {
        return Ok(());
    }
    Err(GeometryError::OutOfRange {
        name: "accuracy",
        value: accuracy,
        range: "(0, infinity)",
    })
}

/// Returns a length in the units of the rail.
fn back(length: f64, units: i32) -> Result<f64> {
    let value = length.times_two_to(units);
    if value.is_finite() {
        return Ok(value);
    }
    Err(GeometryError::NoValue {
        what: "length",
        at: Place::Whole,
    })
}

/// Returns a failure whose lengths are in the units of the rail.
fn in_units(error: GeometryError, units: i32) -> GeometryError {
    match error {
        GeometryError::NotConverged {
            what,
            reached,
            demanded,
        } => GeometryError::NotConverged {
            what,
            reached: reached.times_two_to(units),
            demanded: demanded.times_two_to(units),
        },
        other => other,
    }
}
