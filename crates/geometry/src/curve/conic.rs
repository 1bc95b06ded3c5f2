//! Arcs of conics that the families hold exactly.
//!
//! With `mu = nu = 0` the quadratic seeds are `1-s, s+c-1, 1-c`, so
//! `G = (R0 + R2 - R1) .. = R1 + s (R1 - R0) + c (R1 - R2) + (R0 - R1 + R2 - R1)`: an affine image of the
//! quarter circle `(s, c)`, an arc of an ellipse with conjugate half axes `R1 - R0` and `R1 - R2` about
//! `R0 + R2 - R1`. The Bernstein quadratic is an arc of a parabola.

use super::Curve;
use crate::basis::{Bernstein, Gbt};
use crate::coordinate::Coordinate;
use crate::error::Result;
use crate::vector::{add, sub};

/// A quarter of the ellipse about `center` with conjugate half axes `from - center` and `to - center`:
/// `center + cos(pi x/2) (from - center) + sin(pi x/2) (to - center)`, exactly.
///
/// # Errors
/// [`GeometryError::NotFinite`](crate::GeometryError::NotFinite).
///
/// ```
/// use torse_geometry::curve::ellipse_arc;
/// let arc = ellipse_arc(&[1.0, 1.0], &[4.0, 1.0], &[1.0, 3.0])?;
/// let [x, y] = arc.point(&0.37)?;
/// assert!((((x - 1.0) / 3.0).powi(2) + ((y - 1.0) / 2.0).powi(2) - 1.0).abs() < 1e-15);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn ellipse_arc<S: Coordinate, const D: usize>(
    center: &[S; D],
    from: &[S; D],
    to: &[S; D],
) -> Result<Curve<Gbt<S>, S, D>> {
    let middle = sub(&add(from, to), center);
    let zero = || center.first().or(from.first()).map(Coordinate::zero);
    let (Some(mu), Some(nu)) = (zero(), zero()) else {
        return Err(crate::GeometryError::TooFew {
            what: "coordinates",
            needed: 1,
            given: 0,
        });
    };
    Curve::new(Gbt::new(mu, nu)?, vec![from.clone(), middle, to.clone()])
}

/// The arc of the parabola from `from` to `to` whose end tangents meet in `apex`.
///
/// # Errors
/// [`GeometryError::NotFinite`](crate::GeometryError::NotFinite).
///
/// ```
/// use torse_geometry::curve::parabola_arc;
/// let arc = parabola_arc(&[-1.0, 1.0], &[0.0, -1.0], &[1.0, 1.0])?;
/// let [x, y] = arc.point(&0.3)?;
/// assert!((y - x * x).abs() < 1e-15);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn parabola_arc<S: Coordinate, const D: usize>(
    from: &[S; D],
    apex: &[S; D],
    to: &[S; D],
) -> Result<Curve<Bernstein, S, D>> {
    Curve::new(Bernstein, vec![from.clone(), apex.clone(), to.clone()])
}
