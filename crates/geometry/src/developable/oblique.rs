//! Boundary curves in oblique planes (hermite-developable Sect. 4).
//!
//! Every ruling of a cone with apex `o` is cut by a plane `n . (X - a) = 0`; the image of the curve `q`
//! is
//!
//! ```text
//! r(u) = o + s(u) (q(u) - o),   s(u) = n . (a - o) / n . (q(u) - o).
//! ```
//!
//! That is a *rational* curve. In Bernstein form with control points `b_i` of `q` its weights are
//! `w_i = n . (b_i - o) / n . (a - o)` and its homogeneous points `o w_i + (b_i - o)`: [`oblique_image`].
//!
//! The paper builds a *polynomial* Hermite curve instead, projecting points and the tips of the
//! tangent vectors (eqs. (4.2) to (4.4)): [`oblique_image_as_printed`]. A projected tangent tip is not
//! the tangent of the image, so that curve leaves the cone, and the ruled surface to it is in general
//! not developable; the doc test shows by how much.

use crate::basis::{Bernstein, hermite};
use crate::coordinate::{Coordinate, check_finite, is_zero};
use crate::curve::RationalCurve;
use crate::developable::HermiteCone;
use crate::error::{GeometryError, Place, Result};
use crate::planes::Plane;
use crate::vector::{add, scale, sub};

use super::patch::height;

/// The exact image of the curve `q` of a cone in a plane.
///
/// # Errors
/// [`GeometryError::Degenerate`] when the plane contains the apex,
/// [`GeometryError::BehindApex`] when a ruling over a control point does not meet the plane
/// on the side of `q` (its weight is not positive), [`GeometryError::NotFinite`].
///
/// ```
/// use torse_algebra::rational::{Rational, integer, ratio};
/// use torse_geometry::{HermiteCone, developable::{oblique_image, oblique_image_as_printed}};
/// // hermite-developable Sect. 4: the quintic of Sect. 3.3 and the plane through q(0) along
/// // (-30, -200, 0) and (0, 0, 200), that is 20 X - 3 Y = -580.
/// let v = |x, y, z| [x, y, z].map(integer);
/// let cone = HermiteCone {
///     summit: v(100, 20, 45),
///     ratio: integer(2),
///     p: vec![],
///     q: vec![v(-20, 60, 45), v(-20, 5, 35), v(-20, -50, 45), v(0, -60, 90), v(0, -50, 70), v(0, -50, -30)],
/// };
/// let plane = [integer(20), integer(-3), integer(0), integer(-580)];
/// let exact = oblique_image(&cone, &plane)?;
/// let jet = exact.derivatives(&integer(0), 1)?;
/// let shown = |q: &Rational| (q.numer().to_string() + "/" + &q.denom().to_string());
/// // The construction as printed gives r'(0) = 42/39 (-120, -20, 90) - (-120, 40, 0); the printed number
/// // (-7.6, -50.6, 63.8) belongs to q'(0) = (0, -50, 60). Neither is the tangent of the image curve.
/// let printed = oblique_image_as_printed(&cone, &plane)?;
/// assert_eq!(shown(&printed[3][0]), "-120/13");
/// assert_eq!(shown(&jet[1][0]), "-60/7");
/// let mut changed = cone.clone();
/// changed.q[3] = v(0, -50, 60);
/// let tenth = |n| ratio(n, 10).unwrap();
/// let near = |a: &Rational, n: i64| *a > tenth(n - 1) && *a < tenth(n + 1);
/// let changed = oblique_image_as_printed(&changed, &plane)?;
/// assert!(near(&changed[3][0], -76) && near(&changed[3][1], -506) && near(&changed[3][2], 638));
/// // r(1/2) and r(1) are points of the image, printed (-28.4, 3.9, 34.3) and (-38, -60.5, 45).
/// assert!(near(&printed[1][0], -284) && near(&printed[1][1], 39) && near(&printed[1][2], 343));
/// assert_eq!(exact.point(&ratio(1, 2).unwrap())?, printed[1]);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn oblique_image<S: Coordinate>(
    cone: &HermiteCone<S>,
    plane: &Plane<S>,
) -> Result<RationalCurve<Bernstein, S, 3>> {
    let depth = depth_of_apex(cone, plane)?;
    let curve = hermite::curve(&cone.q)?;
    let mut points = Vec::with_capacity(cone.q.len());
    let mut weights = Vec::with_capacity(cone.q.len());
    for (index, b) in curve.points().iter().enumerate() {
        let reach = sub(b, &cone.summit);
        let weight = slant(plane, &reach).divided_by(&depth)?;
        if matches!(
            weight.sign(),
            Some(std::cmp::Ordering::Less | std::cmp::Ordering::Equal)
        ) {
            let what = "control point";
            return Err(GeometryError::BehindApex { what, index });
        }
        points.push(add(&scale(&weight, &cone.summit), &reach));
        weights.push(weight);
    }
    RationalCurve::from_homogeneous(Bernstein, points, weights)
}

/// The Hermite data of the curve in a plane as the paper constructs it (eqs. (4.2) to (4.4)): the
/// points and the tips of the tangents of `q` projected from the apex. Not the image curve; see the
/// module.
///
/// # Errors
/// [`GeometryError::Degenerate`] when the plane contains the apex,
/// [`GeometryError::BehindApex`] when a point cannot be projected, naming the datum.
pub fn oblique_image_as_printed<S: Coordinate>(
    cone: &HermiteCone<S>,
    plane: &Plane<S>,
) -> Result<Vec<[S; 3]>> {
    let depth = depth_of_apex(cone, plane)?;
    let project = |index: usize, reach: &[S; 3]| -> Result<[S; 3]> {
        let parallel = |_| GeometryError::BehindApex {
            what: "Hermite datum",
            index,
        };
        let factor = depth.divided_by(&slant(plane, reach)).map_err(parallel)?;
        Ok(scale(&factor, reach))
    };
    // Points come first: the end points, from degree four on also the middle.
    let points = if cone.q.len() > 4 { 3 } else { 2 };
    let tangents_at: &[usize] = if cone.q.len() == 6 {
        &[0, 1, 2]
    } else {
        &[0, points - 1]
    };
    let mut feet = Vec::with_capacity(points);
    for (index, q) in cone.q.iter().take(points).enumerate() {
        let reach = sub(q, &cone.summit);
        feet.push((project(index, &reach)?, reach));
    }
    let mut data: Vec<[S; 3]> = feet
        .iter()
        .map(|(foot, _)| add(&cone.summit, foot))
        .collect();
    for (index, (tangent, &at)) in cone.q.iter().skip(points).zip(tangents_at).enumerate() {
        let Some((foot, reach)) = feet.get(at) else {
            break;
        };
        let tip = project(points + index, &add(reach, tangent))?;
        data.push(sub(&tip, foot));
    }
    Ok(data)
}

/// `n . (a - o)`, the value of the plane's equation at the apex with its sign changed.
fn depth_of_apex<S: Coordinate>(cone: &HermiteCone<S>, plane: &Plane<S>) -> Result<S> {
    check_finite("cutting plane", plane)?;
    let depth = -height(plane, &cone.summit);
    if is_zero(&depth) {
        return Err(GeometryError::Degenerate {
            what: "the plane contains the apex",
            at: Place::Whole,
        });
    }
    Ok(depth)
}

fn slant<S: Coordinate>(plane: &Plane<S>, reach: &[S; 3]) -> S {
    crate::vector::dot(&crate::planes::normal_of(plane), reach)
}
