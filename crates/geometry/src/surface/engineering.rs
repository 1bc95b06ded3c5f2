//! The engineering surfaces of gbt-surfaces Sect. 3 that are tensor products.

use super::TensorSurface;
use crate::basis::{Basis, Bernstein, Gbt};
use crate::coordinate::{Coordinate, check_finite, check_positive, is_zero};
use crate::curve::Curve;
use crate::error::{GeometryError, Place, Result};
use crate::vector::{add, scale};

impl<S: Coordinate, B: Basis<S>> TensorSurface<B, Bernstein, S> {
    /// The cylinder over `directrix` along `direction` by `distance` (gbt-surfaces Theorem 3 and
    /// Algorithm 1): `T(u, v) = F(u) + v distance direction`. The paper asks for a unit direction;
    /// any nonzero one will do.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] unless `distance > 0`, [`GeometryError::Degenerate`] for a zero
    /// direction, [`GeometryError::NotFinite`].
    ///
    /// ```
    /// use torse_geometry::{Curve, Gbt, Surface, TensorSurface};
    /// // gbt-surfaces Example 3.1.
    /// let points = [[5, 2], [0, 12], [10, 20], [20, 12], [15, 2]];
    /// let points = points.map(|[x, y]| [f64::from(x), f64::from(y), 0.0]).to_vec();
    /// let directrix = Curve::new(Gbt::new(0.9, 0.25)?, points)?;
    /// let cylinder = TensorSurface::cylinder(&directrix, &[0.0, 0.0, 1.0], &20.0)?;
    /// let (bottom, top) = (cylinder.point(&0.4, &0.0)?, cylinder.point(&0.4, &1.0)?);
    /// assert_eq!(bottom, directrix.point(&0.4)?);
    /// assert!((top[2] - 20.0).abs() < 1e-13);
    /// assert!(cylinder.gaussian_curvature(&0.4, &0.3)?.abs() < 1e-18);
    /// let error = TensorSurface::cylinder(&directrix, &[0.0, 0.0, 1.0], &-1.0).unwrap_err();
    /// assert_eq!(error.to_string(), "distance = -1 is outside (0, infinity)");
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn cylinder(directrix: &Curve<B, S, 3>, direction: &[S; 3], distance: &S) -> Result<Self> {
        check_positive("distance", distance)?;
        check_finite("direction", direction)?;
        if direction.iter().all(is_zero) {
            return Err(GeometryError::Degenerate {
                what: "direction of a cylinder",
                at: Place::Whole,
            });
        }
        let shift = scale(distance, direction);
        let net = directrix
            .points()
            .iter()
            .map(|q| vec![q.clone(), add(q, &shift)])
            .collect();
        Self::new(directrix.basis().clone(), Bernstein, net)
    }
}

impl<S: Coordinate, B: Basis<S>> TensorSurface<B, Gbt<S>, S> {
    /// The whole surface of revolution of a profile `(X, Z)` about the Z axis as four tensor products, one
    /// for each quarter turn.
    ///
    /// The quadratic family with `mu = nu = 0` holds the quarter circle, at the speed of its angle, so the
    /// net of a quarter is the profile times `(1, 0), (1, 1), (0, 1)`: unlike the parametrization of
    /// [`RotationSurface`](super::RotationSurface) no quotients, but quarters only. With the second half as
    /// the paper has it (gbt-surfaces Theorem 6), the two cover the same surface.
    ///
    /// # Errors
    /// None beyond those of the profile.
    ///
    /// ```
    /// use torse_geometry::{Curve, Gbt, RotationSurface, Surface, TensorSurface};
    /// // gbt-surfaces Example 3.6.
    /// let points = vec![[4.0, 15.0], [0.0, 13.0], [0.0, 10.0], [10.0, 5.0], [4.0, 0.0]];
    /// let profile = Curve::new(Gbt::new(0.9, 0.25)?, points)?;
    /// let quarters = TensorSurface::quarter_turns(&profile)?;
    /// // A third of the second quarter is 120 degrees.
    /// let here = quarters[1].point(&0.3, &(1.0 / 3.0))?;
    /// let turned = RotationSurface::turned(&profile, 120_f64.to_radians())?;
    /// let there = turned[0].point(&0.3, &1.0)?;
    /// assert!((0..3).all(|k| (here[k] - there[k]).abs() < 1e-14));
    /// // Neighbours share their seam to the last bit.
    /// assert_eq!(quarters[3].point(&0.7, &1.0)?, quarters[0].point(&0.7, &0.0)?);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn quarter_turns(profile: &Curve<B, S, 2>) -> Result<[Self; 4]> {
        let Some(like) = profile.points().iter().flatten().next() else {
            return Err(GeometryError::TooFew {
                what: "control points",
                needed: 2,
                given: 0,
            });
        };
        let (zero, one) = (like.zero(), like.one());
        let quarter = |[from, to]: [[S; 2]; 2]| {
            let corner = add(&from, &to);
            let arc = Curve::new(
                Gbt::new(zero.clone(), zero.clone())?,
                vec![from, corner, to],
            )?;
            Self::product(profile, &arc, |[radius, height], [x, y]| {
                let scaled = |c: &S| radius.clone() * c.clone();
                [scaled(x), scaled(y), height.clone()]
            })
        };
        let east = [one.clone(), zero.clone()];
        let north = [zero.clone(), one.clone()];
        let west = [-one.clone(), zero.clone()];
        let south = [zero.clone(), -one.clone()];
        Ok([
            quarter([east.clone(), north.clone()])?,
            quarter([north, west.clone()])?,
            quarter([west, south.clone()])?,
            quarter([south, east])?,
        ])
    }
}

impl<S: Coordinate, U: Basis<S>, V: Basis<S>> TensorSurface<U, V, S> {
    /// The swung surface of a profile `(X, Z)` in the plane XOZ and a trajectory `(X, Y)` in XOY
    /// (gbt-surfaces Theorem 4 and Algorithm 4):
    /// `T(u, v) = (factor X_p(u) X_t(v), factor X_p(u) Y_t(v), Z_p(u))`.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] unless `factor > 0`.
    ///
    /// ```
    /// use torse_geometry::{Curve, Gbt, Surface, TensorSurface};
    /// // gbt-surfaces Example 3.4 with scale factor 0.15.
    /// let profile = vec![[3.0, 5.0], [1.0, 3.0], [1.0, 2.0], [4.0, 1.0]];
    /// let trajectory = vec![[4.0, 1.0], [1.0, 2.0], [1.0, 4.0], [5.0, 5.0]];
    /// let profile = Curve::new(Gbt::new(0.9, 0.9)?, profile)?;
    /// let trajectory = Curve::new(Gbt::new(0.25, 0.25)?, trajectory)?;
    /// let surface = TensorSurface::swung(&profile, &trajectory, &0.15)?;
    /// let (p, t) = (profile.point(&0.3)?, trajectory.point(&0.8)?);
    /// let expected = [0.15 * p[0] * t[0], 0.15 * p[0] * t[1], p[1]];
    /// for (a, b) in surface.point(&0.3, &0.8)?.iter().zip(expected) {
    ///     assert!((a - b).abs() < 1e-14);
    /// }
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn swung(
        profile: &Curve<U, S, 2>,
        trajectory: &Curve<V, S, 2>,
        factor: &S,
    ) -> Result<Self> {
        check_positive("scale factor", factor)?;
        let point = |[px, pz]: &[S; 2], [tx, ty]: &[S; 2]| {
            let radius = factor.clone() * px.clone();
            [radius.clone() * tx.clone(), radius * ty.clone(), pz.clone()]
        };
        Self::product(profile, trajectory, point)
    }

    /// The swept (translational) surface `T(u, v) = section(u) + trajectory(v)` (gbt-surfaces Theorem 5
    /// and Algorithm 5).
    ///
    /// # Errors
    /// None beyond those of the curves.
    ///
    /// ```
    /// use torse_geometry::{Continuity, Curve, Gbt, Surface, TensorSurface, join};
    /// // gbt-surfaces Example 3.5, first segments.
    /// let section = vec![[2.0, 0.0, 2.0], [1.0, 0.0, 3.0], [5.0, 0.0, 4.0], [6.0, 0.0, 3.0]];
    /// let trajectory = vec![[4.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 2.0, 0.0], [4.0, 3.0, 0.0]];
    /// let section = Curve::new(Gbt::new(0.5, 0.5)?, section)?;
    /// let trajectory = Curve::new(Gbt::new(0.5, 0.5)?, trajectory)?;
    /// let surface = TensorSurface::swept(&section, &trajectory)?;
    /// assert_eq!(surface.point(&1.0, &0.0)?, [10.0, 0.0, 3.0]);
    ///
    /// // With equal shape parameters the printed second section joins the first with C1 and even G2
    /// // (its second derivative differs along the tangent only), but not with C2:
    /// let second = [[6.0, 0.0, 3.0], [7.0, 0.0, 2.0], [3.0, 0.0, 1.0], [2.0, 0.0, 2.0]];
    /// let printed = Curve::new(Gbt::new(0.5, 0.5)?, second.to_vec())?;
    /// let joint = join::measure_curves(&section, &printed, 2)?;
    /// assert_eq!(joint.order_within(1e-12), Some(2));
    /// assert!((joint.betas[0] - 1.0).abs() < 1e-12 && joint.betas[1].abs() > 1.0);
    /// // A C2 continuation keeps the second point and moves the third:
    /// let c2 = Continuity::parametric(2, &0.0);
    /// let next = join::next_curve(&section, Gbt::new(0.5, 0.5)?, &c2, &second[3..])?;
    /// assert!((next.points()[1][0] - 7.0).abs() < 1e-12 && (next.points()[2][0] - 3.0).abs() > 0.1);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn swept(section: &Curve<U, S, 3>, trajectory: &Curve<V, S, 3>) -> Result<Self> {
        Self::product(section, trajectory, add)
    }

    /// The swept surface of gbt-surfaces eq. (28), `T(u, v) = trajectory(v) + S(v) section(u)`, where the matrix `S(v)`
    /// scales and turns the section. With a matrix for each control point of the trajectory,
    /// `S(v) = sum_l g[l](v) S[l]` in its basis, that is a tensor product: its net is `Q[l] + S[l] P[k]`. One matrix is
    /// the same everywhere, the identity gives [`TensorSurface::swept`].
    ///
    /// # Errors
    /// [`GeometryError::LengthMismatch`] unless there is one matrix or one for each control point of the trajectory,
    /// [`GeometryError::NotFinite`].
    ///
    /// ```
    /// use torse_geometry::{Curve, Gbt, Surface, TensorSurface};
    /// // The curves of gbt-surfaces Example 3.5; the section shrinks to a half and turns over.
    /// let section = vec![[2.0, 0.0, 2.0], [1.0, 0.0, 3.0], [5.0, 0.0, 4.0], [6.0, 0.0, 3.0]];
    /// let trajectory = vec![[4.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 2.0, 0.0], [4.0, 3.0, 0.0]];
    /// let section = Curve::new(Gbt::new(0.5, 0.5)?, section)?;
    /// let trajectory = Curve::new(Gbt::new(0.5, 0.5)?, trajectory)?;
    /// let scaled = |s: f64| [[s, 0.0, 0.0], [0.0, s, 0.0], [0.0, 0.0, s]];
    /// let matrices = [1.0, 0.5, 0.0, -0.5].map(scaled);
    /// let surface = TensorSurface::swept_by(&section, &trajectory, &matrices)?;
    /// // (4, 3, 0) - (6, 0, 3)/2.
    /// assert_eq!(surface.point(&1.0, &1.0)?, [1.0, 3.0, -1.5]);
    /// // One matrix is a constant one; the printed case (29) is that of the identity.
    /// let plain = TensorSurface::swept_by(&section, &trajectory, &[scaled(1.0)])?;
    /// assert_eq!(plain, TensorSurface::swept(&section, &trajectory)?);
    /// assert!(TensorSurface::swept_by(&section, &trajectory, &matrices[..2]).is_err());
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn swept_by(
        section: &Curve<U, S, 3>,
        trajectory: &Curve<V, S, 3>,
        matrices: &[[[S; 3]; 3]],
    ) -> Result<Self> {
        let count = trajectory.points().len();
        if matrices.len() != 1 && matrices.len() != count {
            return Err(GeometryError::LengthMismatch {
                what: "matrices of a swept surface",
                index: 1,
                expected: count,
                given: matrices.len(),
            });
        }
        check_finite(
            "matrix of a swept surface",
            matrices.iter().flatten().flatten(),
        )?;
        let row = |p: &[S; 3]| -> Vec<[S; 3]> {
            let turned = matrices
                .iter()
                .cycle()
                .map(|matrix| matrix.each_ref().map(|row| crate::vector::dot(row, p)));
            let points = trajectory.points().iter();
            points.zip(turned).map(|(q, s)| add(q, &s)).collect()
        };
        let net = section.points().iter().map(row).collect();
        Self::new(section.basis().clone(), trajectory.basis().clone(), net)
    }

    fn product<const D: usize>(
        first: &Curve<U, S, D>,
        second: &Curve<V, S, D>,
        point: impl Fn(&[S; D], &[S; D]) -> [S; 3],
    ) -> Result<Self> {
        let row = |p: &[S; D]| second.points().iter().map(|t| point(p, t)).collect();
        let net = first.points().iter().map(row).collect();
        Self::new(first.basis().clone(), second.basis().clone(), net)
    }
}
