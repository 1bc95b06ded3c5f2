//! Bezier curves over the rationals: what splines consist of.

use crate::basis::Bernstein;
use crate::coordinate::Coordinate;
use crate::curve::{Curve, RationalCurve};
use crate::error::Result;
use crate::sheet::Rail;
use torse_algebra::Rational;

/// A Bezier curve in space with exact control points, weighted or not, over [0, 1].
///
/// Invariant: weights are positive; without weights all of them are one.
#[derive(Debug, Clone, PartialEq)]
pub struct Bezier {
    curve: Shape,
}

#[derive(Debug, Clone, PartialEq)]
enum Shape {
    Plain(Curve<Bernstein, Rational, 3>),
    Weighted(RationalCurve<Bernstein, Rational, 3>),
}

impl Bezier {
    /// The curve with homogeneous control points `(w x, w y, w z, w)`; without weights `w` is one.
    pub(crate) fn new(control: Vec<[Rational; 4]>, weighted: bool) -> Result<Self> {
        let (points, weights): (Vec<[Rational; 3]>, Vec<Rational>) = control
            .into_iter()
            .map(|[x, y, z, w]| ([x, y, z], w))
            .unzip();
        let curve = if weighted {
            Shape::Weighted(RationalCurve::from_homogeneous(Bernstein, points, weights)?)
        } else {
            Shape::Plain(Curve::new(Bernstein, points)?)
        };
        Ok(Self { curve })
    }

    /// The homogeneous control points.
    pub(crate) fn homogeneous(&self) -> Vec<[Rational; 4]> {
        let joined =
            |[x, y, z]: &[Rational; 3], w: &Rational| [x.clone(), y.clone(), z.clone(), w.clone()];
        let one = Rational::from_integer(1.into());
        match &self.curve {
            Shape::Plain(curve) => curve.points().iter().map(|p| joined(p, &one)).collect(),
            Shape::Weighted(curve) => curve.homogeneous().map(|(p, w)| joined(p, w)).collect(),
        }
    }

    /// The degree.
    #[must_use]
    pub fn degree(&self) -> usize {
        match &self.curve {
            Shape::Plain(curve) => curve.degree(),
            Shape::Weighted(curve) => curve.degree(),
        }
    }

    /// The point at `x`, exactly.
    ///
    /// # Errors
    /// Where the weights cancel, outside of [0, 1].
    pub fn point(&self, x: &Rational) -> Result<[Rational; 3]> {
        match &self.curve {
            Shape::Plain(curve) => curve.point(x),
            Shape::Weighted(curve) => curve.point(x),
        }
    }

    /// The parts on `[0, x]` and `[x, 1]`, exactly.
    ///
    /// # Errors
    /// As [`RationalCurve::split`].
    pub fn split(&self, x: &Rational) -> Result<[Self; 2]> {
        Ok(match &self.curve {
            Shape::Plain(curve) => curve.split(x)?.map(|part| Self {
                curve: Shape::Plain(part),
            }),
            Shape::Weighted(curve) => curve.split(x)?.map(|part| Self {
                curve: Shape::Weighted(part),
            }),
        })
    }

    /// The curve on f64: each control point and weight is rounded once.
    ///
    /// # Errors
    /// [`GeometryError::NotFinite`](crate::GeometryError::NotFinite) for what has no f64,
    /// [`GeometryError::BadWeight`](crate::GeometryError::BadWeight) for a weight that becomes zero.
    pub fn rail(&self) -> Result<Rail> {
        match &self.curve {
            Shape::Plain(curve) => {
                let points = curve.points().iter();
                let points: Vec<[f64; 3]> = points
                    .map(|p| p.each_ref().map(Coordinate::approximate))
                    .collect();
                Rail::bezier(&points)
            }
            Shape::Weighted(curve) => {
                let (points, weights): (Vec<[f64; 3]>, Vec<f64>) = curve
                    .homogeneous()
                    .map(|(p, w)| (p.each_ref().map(Coordinate::approximate), w.approximate()))
                    .unzip();
                RationalCurve::from_homogeneous(Bernstein, points, weights).map(Rail::from)
            }
        }
    }
}
