//! Arcs of hyperbolas and parabolas: Bezier curves of degree two, that of a hyperbola with weights.
//!
//! With the directions `x`, `y` of the axes, the parameters are those of ISO 10303-42: `C + a cosh(u) x + b sinh(u) y`, and
//! `C + f (u^2 x + 2 u y)`. The middle control point is where the tangents at the ends meet. Of a hyperbola from `m - h` to
//! `m + h` this is `C + (a cosh(m) x + b sinh(m) y)/cosh(h)`, with the weight `cosh(h)`; of a parabola from `s` to `t`,
//! `C + f (s t x + (s + t) y)`.

use super::CurveShape;
use torse_algebra::Rational;
use torse_geometry::curve::Spline;
use torse_geometry::vector::{add, dot, scale, sub};
use torse_geometry::{GeometryError, Place, exact};

/// A conic that goes to infinity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum OpenConic {
    /// The branch of a hyperbola on the side of its first axis, with both half axes.
    Hyperbola([f64; 2]),
    /// A parabola with the distance of its focus.
    Parabola(f64),
}

/// A point in the axes of a conic.
type Flat = [f64; 2];

impl OpenConic {
    /// The parameter of a point of the conic.
    pub(super) fn parameter(
        self,
        [centre, x, y]: &[[f64; 3]; 3],
        point: &[f64; 3],
    ) -> Result<f64, GeometryError> {
        let away = sub(point, centre);
        match self {
            Self::Hyperbola([_, b]) => {
                let along = dot(&away, x);
                if along <= 0.0 {
                    return Err(GeometryError::OutOfRange {
                        name: "way of an end of a hyperbola along its first axis",
                        value: along,
                        range: "what its branch has: more than 0",
                    });
                }
                Ok(libm::asinh(dot(&away, y) / b))
            }
            Self::Parabola(f) => Ok(dot(&away, y) / (2.0 * f)),
        }
    }

    /// The arc from one parameter to another.
    pub(super) fn arc(
        self,
        [centre, x, y]: &[[f64; 3]; 3],
        ends: [f64; 2],
    ) -> Result<CurveShape, GeometryError> {
        let (points, weight) = self.control(ends);
        let in_space = |[p, q]: Flat| add(centre, &add(&scale(&p, x), &scale(&q, y)));
        let points = points.map(in_space);
        if points.iter().flatten().any(|c| !c.is_finite()) || !weight.is_finite() {
            return Err(GeometryError::NoValue {
                what: "an arc of a hyperbola or a parabola",
                at: Place::Whole,
            });
        }
        if points[0] == points[2] {
            return Err(GeometryError::Degenerate {
                what: "an arc of a hyperbola or a parabola from a point to itself",
                at: Place::Whole,
            });
        }
        let (zero, one) = (Rational::default(), Rational::from(1));
        let knots = [zero, one.clone()].into_iter().flat_map(|k| vec![k; 3]);
        let weights = match self {
            Self::Hyperbola(_) => Some(vec![one.clone(), exact(weight), one]),
            Self::Parabola(_) => None,
        };
        let points = points.map(|point| point.map(exact)).to_vec();
        Spline::new(2, knots.collect(), points, weights).map(CurveShape::Spline)
    }

    /// The control points of an arc, and the weight of the middle one.
    fn control(self, [from, to]: [f64; 2]) -> ([Flat; 3], f64) {
        match self {
            Self::Hyperbola([a, b]) => {
                let at = |u: f64| [a * libm::cosh(u), b * libm::sinh(u)];
                let weight = libm::cosh(0.5 * (to - from));
                let middle = at(0.5 * (from + to)).map(|c| c / weight);
                ([at(from), middle, at(to)], weight)
            }
            Self::Parabola(f) => {
                let at = |u: f64| [f * u * u, 2.0 * f * u];
                let middle = [f * from * to, f * (from + to)];
                ([at(from), middle, at(to)], 1.0)
            }
        }
    }
}
