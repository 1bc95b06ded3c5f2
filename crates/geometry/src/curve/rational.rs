//! Weighted (rational) curves.

use super::{AffineMap, Curve, derivatives_of};
use crate::basis::Basis;
use crate::coordinate::{Coordinate, check_finite};
use crate::error::{GeometryError, Result};
use crate::vector::{add, dot, scale};
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
    /// assert_eq!(error.to_string(), "weight 1 is 0, a positive number is needed");
    /// let error = RationalCurve::new(Bernstein, &[[0.0], [1.0]], vec![1.0, f64::NAN]).unwrap_err();
    /// assert_eq!(error.to_string(), "weight, entry 1: NaN is not a finite number");
    /// let error = RationalCurve::new(Bernstein, &[[0.0], [1.0]], vec![1.0]).unwrap_err();
    /// assert_eq!(error.to_string(), "weights: entry 0 has 1 elements, expected 2");
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
        // Before they are multiplied: a product would not tell which of the two is not finite.
        check_finite("weight", &weights)?;
        check_finite("control point", points.iter().flatten())?;
        let scaled = points
            .iter()
            .zip(&weights)
            .map(|(p, w)| scale(w, p))
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
        check_finite("weight", &weights)?;
        let bad = |w: &S| matches!(w.sign(), Some(Ordering::Less | Ordering::Equal));
        if let Some((index, value)) = weights.iter().enumerate().find(|(_, w)| bad(w)) {
            return Err(GeometryError::BadWeight {
                index,
                value: value.approximate(),
            });
        }
        Ok(Self {
            numerator: Curve::new(basis.clone(), points)?,
            weights: Curve::new(basis, weights.into_iter().map(|w| [w]).collect())?,
        })
    }

    /// The same control points and weights under another name of the basis.
    pub(crate) fn with_basis<C>(self, rename: impl Fn(B) -> C) -> RationalCurve<C, S, D> {
        RationalCurve {
            numerator: self.numerator.with_basis(&rename),
            weights: self.weights.with_basis(&rename),
        }
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
        derivatives_of(&self.jet(x, order)?, order)
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

    /// The derivatives `[R(0), R'(0), ..]` at the start.
    ///
    /// # Errors
    /// As [`RationalCurve::point`].
    pub fn start_jet(&self, order: usize) -> Result<Vec<[S; D]>> {
        match self.weights.points().iter().flatten().next() {
            Some(like) => self.derivatives(&like.zero(), order),
            None => Ok(Vec::new()),
        }
    }

    /// The derivatives `[R(1), R'(1), ..]` at the end.
    ///
    /// # Errors
    /// As [`RationalCurve::point`].
    pub fn end_jet(&self, order: usize) -> Result<Vec<[S; D]>> {
        match self.weights.points().iter().flatten().next() {
            Some(like) => self.derivatives(&like.one(), order),
            None => Ok(Vec::new()),
        }
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

impl<S: Coordinate, B: Basis<S>> RationalCurve<B, S, 3> {
    /// The image under an affine map, which acts on the homogeneous points `(w R, w)`.
    ///
    /// ```
    /// use torse_geometry::{AffineMap, Bernstein, RationalCurve};
    /// let points = [[0.0, 0.0, 1.0], [1.0, 3.0, 0.0], [4.0, 1.0, 2.0]];
    /// let curve = RationalCurve::new(Bernstein, &points, vec![1.0, 2.0, 0.5])?;
    /// let map = AffineMap { linear: [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 2.0]], shift: [1.0, 2.0, 3.0] };
    /// let (of_curve, of_point) = (curve.mapped(&map).point(&0.3)?, map.apply(&curve.point(&0.3)?));
    /// assert!(of_curve.iter().zip(of_point).all(|(a, b)| (a - b).abs() < 1e-14));
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    #[must_use]
    pub fn mapped(&self, map: &AffineMap<S>) -> Self {
        let image = |(point, weight): (&[S; 3], &S)| {
            let turned = map.linear.each_ref().map(|row| dot(row, point));
            add(&turned, &scale(weight, &map.shift))
        };
        Self {
            numerator: Curve {
                basis: self.basis().clone(),
                points: self.homogeneous().map(image).collect(),
            },
            weights: self.weights.clone(),
        }
    }
}
