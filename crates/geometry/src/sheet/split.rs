//! Parts of a rail with control points of their own.

use super::{Rail, RailCurve};
use crate::basis::{BasisShape, Bernstein};
use crate::curve::{Bezier, Curve, EllipticHelix};
use crate::error::{GeometryError, Place, Result};
use crate::vector::sub;

impl Rail {
    /// Returns the parts on `[0, x]` and `[x, 1]` of a Bezier curve, weighted or not, or of an arc of an ellipse, each
    /// with a parameter of its own in [0, 1].
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] unless `0 < x < 1`; [`GeometryError::Degenerate`] for a curve with shape
    /// parameters that is no arc of an ellipse: its parts have no control points (a patch over it is trimmed by
    /// [`Sheet::part`](super::Sheet::part)).
    ///
    /// ```
    /// use torse_geometry::prelude::*;
    /// let rail = Rail::bezier(&[[0.0; 3], [1.0, 2.0, 0.0], [3.0, 2.0, 1.0], [4.0, 0.0, 1.0]])?;
    /// let [first, second] = rail.split(0.25)?;
    /// assert_eq!(first.point(1.0)?, second.point(0.0)?);
    /// let length = first.length(1e-9)? + second.length(1e-9)?;
    /// assert!((length - rail.length(1e-9)?).abs() < 1e-8);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn split(&self, x: f64) -> Result<[Self; 2]> {
        if !(x > 0.0 && x < 1.0) {
            return Err(GeometryError::OutOfRange {
                name: "parameter of a split",
                value: x,
                range: "(0, 1)",
            });
        }
        if let (Some(given), true) = (&self.given, self.is_bezier()) {
            let weighted = matches!(self.curve(), RailCurve::Weighted(_));
            let whole = Bezier::new(given.as_ref().clone(), weighted)?;
            let [first, second] = whole.split(&crate::exact(x))?;
            return Ok([Self::try_from(&first)?, Self::try_from(&second)?]);
        }
        match self.curve() {
            RailCurve::Plain(curve) if *curve.basis() == BasisShape::Bernstein => {
                let curve = curve.clone().with_basis(|_| Bernstein);
                Ok(curve.split(&x)?.map(Self::from))
            }
            RailCurve::Weighted(curve) if *curve.basis() == BasisShape::Bernstein => {
                let curve = curve.clone().with_basis(|_| Bernstein);
                Ok(curve.split(&x)?.map(Self::from))
            }
            RailCurve::Elliptic(curve) => Ok(split_arc(curve, x)),
            RailCurve::Plain(curve) => match quarter_of_ellipse(curve)? {
                Some(arc) => Ok(split_arc(&arc, x)),
                None => Err(no_control_points(x)),
            },
            RailCurve::Weighted(_) => Err(no_control_points(x)),
        }
    }
}

impl Rail {
    /// Returns whether it is a Bezier curve, weighted or not.
    fn is_bezier(&self) -> bool {
        let basis = match self.curve() {
            RailCurve::Plain(curve) => curve.basis(),
            RailCurve::Weighted(curve) => curve.basis(),
            RailCurve::Elliptic(_) => return false,
        };
        *basis == BasisShape::Bernstein
    }
}

fn no_control_points(x: f64) -> GeometryError {
    GeometryError::Degenerate {
        what: "a part of a curve with shape parameters has no control points",
        at: Place::Parameter(x),
    }
}

fn split_arc(arc: &EllipticHelix, x: f64) -> [Rail; 2] {
    [[0.0, x], [x, 1.0]].map(|[from, to]| arc.part(&from, &to).into())
}

/// Returns the quadratic curve with shape parameters 0 as what it is, with the same parameter: a quarter of the ellipse
/// about `R0 + R2 - R1` (see [`ellipse_arc`](crate::curve::ellipse_arc)).
fn quarter_of_ellipse(curve: &Curve<BasisShape<f64>, f64, 3>) -> Result<Option<EllipticHelix>> {
    let (BasisShape::Gbt(basis), [from, middle, to]) = (curve.basis(), curve.points()) else {
        return Ok(None);
    };
    if *basis.mu() != 0.0 || *basis.nu() != 0.0 {
        return Ok(None);
    }
    let (cosine, sine) = (sub(middle, to), sub(middle, from));
    let centre = sub(from, &cosine);
    EllipticHelix::new(centre, cosine, sine, [0.0; 3], [0.0, 1.0]).map(Some)
}
