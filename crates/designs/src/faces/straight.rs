//! What is straight of a face whatever its degree: the lines of its surface, and its edges.

use super::SAME;
use crate::numbers::at_most;
use torse_exchange::{CurveShape, Imported, SplineSurface, SurfaceShape};
use torse_geometry::curve::Spline;
use torse_geometry::prelude::GeometryError;
use torse_geometry::vector::{norm, sub};
use torse_geometry::{Coordinate, Rational};

/// Returns the curves between which a B-spline surface is ruled: by its degree, or by what it is whatever its degree, but
/// for the rounding of its numbers.
pub(super) fn spline_rails(surface: &SplineSurface) -> Result<Option<[Spline; 2]>, GeometryError> {
    if let Some(rails) = surface.rails()? {
        return Ok(Some(rails));
    }
    match surface.straightened()? {
        Some(straight) => straight.surface.rails(),
        None => Ok(None),
    }
}

/// Returns how far a B-spline surface is at most from the ruled one that is taken for it, where they are not one.
pub(super) fn rounding_note(surface: &SurfaceShape) -> Result<Option<String>, GeometryError> {
    let SurfaceShape::Spline(surface) = surface else {
        return Ok(None);
    };
    if surface.rails()?.is_some() {
        return Ok(None);
    }
    let straight = surface.straightened()?.filter(|found| found.distance > 0.0);
    Ok(straight.map(|found| {
        format!(
            "ruled between two of its edges: the surface of the file is within {} mm, proved",
            at_most(found.distance)
        )
    }))
}

/// Returns whether an edge is a straight line, whatever its degree, as far as points of the file are known.
pub(super) fn is_straight(edge: &CurveShape, imported: &Imported) -> bool {
    if edge.segment().is_some() {
        return true;
    }
    let CurveShape::Spline(spline) = edge else {
        return false;
    };
    let near = |p: &[Rational; 3]| p.each_ref().map(Coordinate::approximate);
    let (Some(from), Some(to)) = (spline.points().first(), spline.points().last()) else {
        return false;
    };
    let length = norm(&sub(&near(to), &near(from)));
    edge.is_straight_within((SAME * length).max(imported.uncertainty.unwrap_or(0.0)))
}
