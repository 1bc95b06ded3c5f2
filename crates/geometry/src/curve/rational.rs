//! Weighted (rational) curves.

use super::{Curve, derivatives_of};
use crate::basis::Basis;
use crate::coordinate::{Coordinate, text};
use crate::error::{GeometryError, Result};
use std::cmp::Ordering;
use torse_algebra::{Jet, Scalar};

/// The weighted curve `sum_i w[i] g[i,k](x) R[i] / sum_i w[i] g[i,k](x)`, the projection of the curve
/// with points `(w[i] R[i], w[i])` in homogeneous space (gbt-developable eq. (5.1)).
///
/// ```
/// use torse_algebra::rational::{integer, ratio};
/// use torse_geometry::{Bernstein, RationalCurve};
/// // The quarter circle as a rational quadratic, weights 1, 1, 2: exact at every rational parameter.
/// let q = |x: i64, y: i64| [integer(x), integer(y)];
/// let circle = RationalCurve::new(Bernstein, &[q(1, 0), q(1, 1), q(0, 1)], vec![integer(1), integer(1), integer(2)])?;
/// let [x, y] = circle.point(&ratio(2, 7).unwrap())?;
/// assert_eq!(&x * &x + &y * &y, integer(1));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct RationalCurve<B, S, const D: usize> {
    numerator: Curve<B, S, D>,
    weights: Curve<B, S, 1>,
}

impl<S: Coordinate, B: Basis<S>, const D: usize> RationalCurve<B, S, D> {
    /// The curve with these control points and positive weights.
    ///
    /// # Errors
    /// [`GeometryError::LengthMismatch`], [`GeometryError::BadWeight`] for a weight known to be zero or
    /// negative, [`GeometryError::TooFew`], [`GeometryError::NotFinite`].
    ///
    /// ```
    /// use torse_geometry::{Bernstein, RationalCurve};
    /// let error = RationalCurve::new(Bernstein, &[[0.0], [1.0], [2.0]], vec![1.0, 0.0, 1.0]).unwrap_err();
    /// assert_eq!(error.to_string(), "weight 1 is 0.0, a positive number is needed");
    /// ```
    pub fn new(basis: B, points: &[[S; D]], weights: Vec<S>) -> Result<Self> {
        if points.len() != weights.len() {
            let (expected, given) = (points.len(), weights.len());
            return Err(GeometryError::LengthMismatch {
                what: "weights",
                index: 0,
                expected,
                given,
            });
        }
        let scaled = points
            .iter()
            .zip(&weights)
            .map(|(p, w)| crate::vector::scale(w, p))
            .collect();
        Self::from_homogeneous(basis, scaled, weights)
    }

    /// The curve with the homogeneous control points `(points[i], weights[i])`, that is with
    /// `points[i] = w[i] R[i]` given already multiplied.
    ///
    /// # Errors
    /// As [`RationalCurve::new`].
    pub fn from_homogeneous(basis: B, points: Vec<[S; D]>, weights: Vec<S>) -> Result<Self> {
        if points.len() != weights.len() {
            let (expected, given) = (points.len(), weights.len());
            return Err(GeometryError::LengthMismatch {
                what: "weights",
                index: 0,
                expected,
                given,
            });
        }
        let bad = |w: &S| matches!(w.sign(), Some(Ordering::Less | Ordering::Equal));
        if let Some((index, value)) = weights.iter().enumerate().find(|(_, w)| bad(w)) {
            return Err(GeometryError::BadWeight {
                index,
                value: text(value),
            });
        }
        Ok(Self {
            numerator: Curve::new(basis.clone(), points)?,
            weights: Curve::new(basis, weights.into_iter().map(|w| [w]).collect())?,
        })
    }

    /// The degree.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.numerator.degree()
    }

    /// The basis family.
    #[must_use]
    pub fn basis(&self) -> &B {
        self.numerator.basis()
    }

    /// The homogeneous control points `w[i] R[i]` and the weights.
    pub fn homogeneous(&self) -> impl Iterator<Item = (&[S; D], &S)> {
        let weights = self.weights.points().iter().map(|[w]| w);
        self.numerator.points().iter().zip(weights)
    }

    /// The point at `x`.
    ///
    /// # Errors
    /// [`GeometryError::Exact`] where the basis is not a number of this kind or the weight function
    /// vanishes.
    pub fn point(&self, x: &S) -> Result<[S; D]> {
        let [weight] = self.weights.point(x)?;
        let mut point = self.numerator.point(x)?;
        for value in &mut point {
            *value = value.divided_by(&weight)?;
        }
        Ok(point)
    }

    /// The derivatives `[R(x), R'(x), ..]`.
    ///
    /// # Errors
    /// As [`RationalCurve::point`].
    pub fn derivatives(&self, x: &S, order: usize) -> Result<Vec<[S; D]>> {
        Ok(derivatives_of(&self.jet(x, order)?, order))
    }

    /// The Taylor series of each coordinate at `x`.
    ///
    /// # Errors
    /// As [`RationalCurve::point`].
    pub fn jet(&self, x: &S, order: usize) -> Result<[Jet<S>; D]> {
        let mut axes = self.numerator.jet(x, order)?;
        let [weight] = self.weights.jet(x, order)?;
        for axis in &mut axes {
            *axis = axis.divided_by(&weight)?;
        }
        Ok(axes)
    }

    /// The same curve traversed backwards.
    #[must_use]
    pub fn reversed(&self) -> Self {
        Self {
            numerator: self.numerator.reversed(),
            weights: self.weights.reversed(),
        }
    }
}
