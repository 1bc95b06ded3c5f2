//! Parts of Bezier curves, weighted ones included: de Casteljau's algorithm.
//!
//! The points that the algorithm passes on its way to `G(x)` are the control points of the two parts: with
//! `R[i,0] = R[i]` and `R[i,j] = (1-x) R[i,j-1] + x R[i+1,j-1]` those of `[0, x]` are `R[0,j]` and those of `[x, 1]`
//! are `R[j,k-j]`. Curves with shape parameters have no such parts: their functions on a part of [0, 1] are others.

use super::{Curve, RationalCurve};
use crate::basis::Bernstein;
use crate::coordinate::{Coordinate, check_finite};
use crate::error::Result;
use crate::vector::lerp;

/// The control points of both parts.
fn halves<S: Coordinate, const D: usize>(points: &[[S; D]], x: &S) -> [Vec<[S; D]>; 2] {
    let mut level = points.to_vec();
    let (mut first, mut second) = (Vec::new(), Vec::new());
    while let (Some(start), Some(end)) = (level.first(), level.last()) {
        first.push(start.clone());
        second.push(end.clone());
        let pairs = level.iter().zip(level.iter().skip(1));
        level = pairs.map(|(a, b)| lerp(a, b, x)).collect();
    }
    second.reverse();
    [first, second]
}

impl<S: Coordinate, const D: usize> Curve<Bernstein, S, D> {
    /// The parts on `[0, x]` and `[x, 1]`, each with a parameter of its own in [0, 1].
    ///
    /// # Errors
    /// [`GeometryError::NotFinite`](crate::GeometryError::NotFinite).
    ///
    /// ```
    /// use torse_algebra::rational::{integer, ratio};
    /// use torse_geometry::{Bernstein, Curve};
    /// let curve = Curve::new(Bernstein, [0, 3, 6, 12].map(|n| [integer(n)]).to_vec())?;
    /// let third = ratio(1, 3).unwrap();
    /// let [first, second] = curve.split(&third)?;
    /// // HalfTurn-way on the second part is at 1/3 + 2/3 1/2.
    /// assert_eq!(second.point(&ratio(1, 2).unwrap())?, curve.point(&ratio(2, 3).unwrap())?);
    /// assert_eq!(first.points()[3], second.points()[0]);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn split(&self, x: &S) -> Result<[Self; 2]> {
        check_finite("parameter of a split", [x])?;
        let [first, second] = halves(self.points(), x);
        Ok([Self::new(Bernstein, first)?, Self::new(Bernstein, second)?])
    }
}

impl<S: Coordinate, const D: usize> RationalCurve<Bernstein, S, D> {
    /// The parts on `[0, x]` and `[x, 1]`, each with a parameter of its own in [0, 1].
    ///
    /// # Errors
    /// [`GeometryError::NotFinite`](crate::GeometryError::NotFinite),
    /// [`GeometryError::BadWeight`](crate::GeometryError::BadWeight) outside of [0, 1], where weights may vanish.
    ///
    /// ```
    /// use torse_geometry::{Bernstein, RationalCurve};
    /// let circle = RationalCurve::new(Bernstein, &[[1.0, 0.0], [1.0, 1.0], [0.0, 1.0]], vec![1.0, 1.0, 2.0])?;
    /// let [_, second] = circle.split(&0.25)?;
    /// let [x, y] = second.point(&0.5)?;
    /// assert!((x * x + y * y - 1.0).abs() < 1e-15);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn split(&self, x: &S) -> Result<[Self; 2]> {
        check_finite("parameter of a split", [x])?;
        let (points, weights): (Vec<[S; D]>, Vec<[S; 1]>) = self
            .homogeneous()
            .map(|(point, weight)| (point.clone(), [weight.clone()]))
            .unzip();
        let [first, second] = halves(&points, x);
        let [first_weights, second_weights] = halves(&weights, x);
        let part = |points, weights: Vec<[S; 1]>| {
            let weights = weights.into_iter().map(|[w]| w).collect();
            Self::from_homogeneous(Bernstein, points, weights)
        };
        Ok([part(first, first_weights)?, part(second, second_weights)?])
    }
}
