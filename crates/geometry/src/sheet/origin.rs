//! A sheet that lies far from the origin, moved to it.

use super::surface::{Construction, Sheet};
use super::{Point, Rail, RailCurve};
use crate::surface::RuledSurface;
use crate::vector::sub;

impl Sheet {
    /// Returns the same sheet moved to the origin, and the point that came to lie there: `None` where it lies near the
    /// origin, as its size goes, and where it cannot be moved without rounding. Nothing that is asked of a sheet
    /// depends on where it lies, but far from the origin f64 has few digits left for it.
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// let arc = |z: f64| Rail::bezier(&[[3e9, 5e9, z], [3e9 + 2.0, 5e9, z], [3e9 + 2.0, 5e9 + 2.0, z]]);
    /// let (near, origin) = Sheet::ruled(arc(0.0)?, arc(4.0)?).near_origin().ok_or("it is far away")?;
    /// assert_eq!((origin, near.ruling(0.0)?[0]), ([3e9, 5e9, 0.0], [0.0; 3]));
    /// assert!(near.near_origin().is_none());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn near_origin(&self) -> Option<(Self, Point)> {
        let rails: Vec<&Rail> = match &self.construction {
            Construction::Ruled(patch) => vec![patch.first(), patch.second()],
            Construction::Cylinder(patch) => vec![patch.curve()],
            Construction::Cone(patch) => vec![patch.curve()],
            Construction::Connecting(patch) => {
                let (first, second) = patch.curves();
                vec![first, second]
            }
            Construction::Part(part) => {
                let (near, origin) = part.whole().near_origin()?;
                let [from, to] = *part.range();
                return Some((near.part(from, to).ok()?, origin));
            }
            Construction::Envelope(_) | Construction::Tangent(_) => return None,
        };
        let apex = match &self.construction {
            Construction::Cone(patch) => Some(patch.apex()),
            _ => None,
        };
        let origin = origin_of(&rails, apex)?;
        let moved = |rail: &Rail| rail.moved_to(origin);
        let construction = match &self.construction {
            Construction::Ruled(patch) => {
                let patch = RuledSurface::new(moved(patch.first())?, moved(patch.second())?);
                Construction::Ruled(Box::new(patch))
            }
            Construction::Cylinder(patch) => {
                Construction::Cylinder(Box::new(patch.moved(moved(patch.curve())?)))
            }
            Construction::Cone(patch) => {
                let apex = sub(&patch.apex(), &origin);
                Construction::Cone(Box::new(patch.moved(moved(patch.curve())?, apex)))
            }
            Construction::Connecting(patch) => {
                let (first, second) = patch.curves();
                let patch = patch.over_curves(moved(first)?, moved(second)?);
                Construction::Connecting(Box::new(patch))
            }
            _ => return None,
        };
        let exact = self.exact;
        Some((
            Self {
                construction,
                exact,
            },
            origin,
        ))
    }
}

/// Returns a point from which all control points and the apex differ by numbers that f64 holds; `None` where zero does
/// as well.
fn origin_of(rails: &[&Rail], apex: Option<Point>) -> Option<Point> {
    let mut points: Vec<Point> = apex.into_iter().collect();
    for rail in rails {
        let RailCurve::Plain(curve) = rail.curve() else {
            return None;
        };
        points.extend(curve.points());
    }
    let first = points.first().copied()?;
    let origin: Point = std::array::from_fn(|axis| {
        let at = first[axis];
        // The difference of numbers of one sign within a factor of two is exact (Sterbenz).
        let near = |c: f64| c == at || (0.5 <= c / at && c / at <= 2.0);
        let spread = points
            .iter()
            .map(|p| (p[axis] - at).abs())
            .fold(0.0, f64::max);
        let far = at.abs() > 8.0 * spread;
        if far && points.iter().all(|p| near(p[axis])) {
            at
        } else {
            0.0
        }
    });
    let spread = points.iter().flat_map(|p| sub(p, &first));
    let spread = spread.fold(0.0_f64, |m, c| m.max(c.abs()));
    // Where the place is not larger than the patch nothing is gained.
    let far = origin.iter().any(|c| c.abs() > 8.0 * spread);
    far.then_some(origin)
}
