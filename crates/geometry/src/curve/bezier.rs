//! Bezier curves over the rationals: what splines consist of.

use crate::basis::Bernstein;
use crate::curve::{Curve, RationalCurve};
use crate::error::Result;
use torse_algebra::Rational;

/// A Bezier curve in space with exact control points, weighted or not, over [0, 1].
///
/// Invariant: weights are positive; without weights all of them are one.
#[derive(Debug, Clone, PartialEq)]
pub struct Bezier {
    curve: BezierShape,
}

#[derive(Debug, Clone, PartialEq)]
enum BezierShape {
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
            BezierShape::Weighted(RationalCurve::from_homogeneous(Bernstein, points, weights)?)
        } else {
            BezierShape::Plain(Curve::new(Bernstein, points)?)
        };
        Ok(Self { curve })
    }

    /// Whether the curve has weights.
    #[must_use]
    pub fn is_weighted(&self) -> bool {
        matches!(self.curve, BezierShape::Weighted(_))
    }

    /// The homogeneous control points `(w x, w y, w z, w)`.
    #[must_use]
    pub fn homogeneous(&self) -> Vec<[Rational; 4]> {
        let joined =
            |[x, y, z]: &[Rational; 3], w: &Rational| [x.clone(), y.clone(), z.clone(), w.clone()];
        let one = Rational::from_integer(1.into());
        match &self.curve {
            BezierShape::Plain(curve) => curve.points().iter().map(|p| joined(p, &one)).collect(),
            BezierShape::Weighted(curve) => {
                curve.homogeneous().map(|(p, w)| joined(p, w)).collect()
            }
        }
    }

    /// The degree.
    #[must_use]
    pub fn degree(&self) -> usize {
        match &self.curve {
            BezierShape::Plain(curve) => curve.degree(),
            BezierShape::Weighted(curve) => curve.degree(),
        }
    }

    /// The point at `x`, exactly.
    ///
    /// # Errors
    /// Where the weights cancel, outside of [0, 1].
    pub fn point(&self, x: &Rational) -> Result<[Rational; 3]> {
        match &self.curve {
            BezierShape::Plain(curve) => curve.point(x),
            BezierShape::Weighted(curve) => curve.point(x),
        }
    }

    /// The parts on `[0, x]` and `[x, 1]`, exactly.
    ///
    /// # Errors
    /// As [`RationalCurve::split`].
    pub fn split(&self, x: &Rational) -> Result<[Self; 2]> {
        Ok(match &self.curve {
            BezierShape::Plain(curve) => curve.split(x)?.map(|part| Self {
                curve: BezierShape::Plain(part),
            }),
            BezierShape::Weighted(curve) => curve.split(x)?.map(|part| Self {
                curve: BezierShape::Weighted(part),
            }),
        })
    }
}
