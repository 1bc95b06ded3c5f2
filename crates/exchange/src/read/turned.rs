//! Curves turned about an axis: a straight line makes a cylinder, a cone or a plane.

use super::{CurveShape, SurfaceFrame, SurfaceShape};
use torse_algebra::Rational;
use torse_geometry::Coordinate;
use torse_geometry::vector::{add, cross, dot, norm, scale, sub, unit};

/// The surface of a curve that turns about a line, by its kind: decided on the exact numbers.
pub(super) fn turned(
    curve: CurveShape,
    origin: &[Rational; 3],
    direction: &[Rational; 3],
    frame: SurfaceFrame,
) -> SurfaceShape {
    let line = curve
        .segment()
        .and_then(|[from, to]| of_line(from, &sub(to, from), origin, direction, frame));
    line.unwrap_or_else(|| SurfaceShape::Revolved(Box::new(curve), frame))
}

/// What a straight line makes; `None` for a hyperboloid, and for a line in the axis.
fn of_line(
    from: &[Rational; 3],
    way: &[Rational; 3],
    origin: &[Rational; 3],
    direction: &[Rational; 3],
    frame: SurfaceFrame,
) -> Option<SurfaceShape> {
    let near = |v: &[Rational; 3]| v.each_ref().map(Coordinate::approximate);
    let zero = Rational::default();
    let arm = sub(from, origin);
    let square = dot(direction, direction);
    let along = dot(way, direction);
    let (lean, away) = (cross(way, direction), cross(&arm, direction));
    let lean_square = dot(&lean, &lean);
    if square == zero {
        return None;
    }
    let length = norm(&near(direction));
    if lean_square == zero {
        let radius = norm(&near(&away)) / length;
        return (radius > 0.0).then_some(SurfaceShape::Cylinder(frame, radius));
    }
    if dot(way, &away) != zero {
        return None;
    }
    // The foot of the first point, or of another one where that lies on the axis.
    let off_axis = away.iter().any(|c| *c != zero);
    let point = if off_axis {
        from.clone()
    } else {
        add(from, way)
    };
    let arm = sub(&point, origin);
    let foot = add(origin, &scale(&(dot(&arm, direction) / square), direction));
    let frame = SurfaceFrame {
        origin: near(&foot),
        ..frame
    };
    if along == zero {
        return Some(SurfaceShape::Plane(frame));
    }
    // Where the line meets the axis.
    let share = -dot(&cross(&arm, direction), &lean) / lean_square;
    let apex = add(&point, &scale(&share, way));
    let axis = unit(&near(&sub(&foot, &apex)))?;
    let (radius, height) = (
        norm(&near(&sub(&point, &foot))),
        norm(&near(&sub(&foot, &apex))),
    );
    let angle = libm::atan2(radius, height);
    Some(SurfaceShape::Cone(
        SurfaceFrame { axis, ..frame },
        radius,
        angle,
    ))
}
