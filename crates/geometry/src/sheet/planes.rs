//! Families of planes and joints.

use super::Point;
use crate::basis::BasisShape;
use crate::error::Result;
use crate::join::{Continuity, JointMeasure, measure_families, next_family};
use crate::planes::{Plane, PlaneFamily};

/// A family of planes `p X + q Y + r Z = s` over [0, 1], which envelops a developable.
///
/// ```
/// use torse_geometry::prelude::*;
/// let planes = Planes::bernstein(&[[0., 0., 1., 0.], [0., -1., 1., 0.], [1., -2., 1., 0.], [3., -3., 1., 1.]])?;
/// // The osculating planes of the twisted cubic.
/// let [x, y, z] = planes.regression(0.6)?;
/// assert!((x - 0.6).abs() < 1e-14 && (y - 0.36).abs() < 1e-14 && (z - 0.216).abs() < 1e-14);
/// assert_eq!(planes.opposing_normals(), None);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Planes {
    family: PlaneFamily<BasisShape<f64>, f64>,
}

impl Planes {
    /// Returns the family with these control planes and any basis.
    ///
    /// # Errors
    /// As [`PlaneFamily::new`].
    pub fn new(shape: BasisShape<f64>, planes: &[Plane<f64>]) -> Result<Self> {
        PlaneFamily::new(shape, planes.to_vec()).map(|family| Self { family })
    }

    /// Returns the family with Bernstein polynomials.
    ///
    /// # Errors
    /// As [`PlaneFamily::new`].
    pub fn bernstein(planes: &[Plane<f64>]) -> Result<Self> {
        Self::new(BasisShape::Bernstein, planes)
    }

    /// Returns the family with GBT functions of these shape parameters.
    ///
    /// # Errors
    /// As [`PlaneFamily::new`] and [`Gbt::new`](crate::Gbt::new).
    pub fn gbt(mu: f64, nu: f64, planes: &[Plane<f64>]) -> Result<Self> {
        Self::new(BasisShape::gbt(mu, nu)?, planes)
    }

    /// Returns the family of the generic layer.
    #[must_use]
    pub fn family(&self) -> &PlaneFamily<BasisShape<f64>, f64> {
        &self.family
    }

    /// Returns the plane at `x`.
    ///
    /// # Errors
    /// As [`PlaneFamily::plane`].
    pub fn plane(&self, x: f64) -> Result<Plane<f64>> {
        self.family.plane(&x)
    }

    /// Returns the point of the edge of regression at `x`.
    ///
    /// # Errors
    /// As [`PlaneFamily::characteristic_point`].
    pub fn regression(&self, x: f64) -> Result<Point> {
        self.family.characteristic_point(&x)
    }

    /// Returns the first control plane whose normal makes an obtuse angle with that of the next; see
    /// [`PlaneFamily::opposing_normals`].
    #[must_use]
    pub fn opposing_normals(&self) -> Option<usize> {
        self.family.opposing_normals()
    }

    /// Returns the family that continues this one: its first control planes from the joint, then the free ones.
    ///
    /// # Errors
    /// As [`next_family`].
    pub fn next(&self, shape: BasisShape<f64>, joint: &Joint, free: &[Plane<f64>]) -> Result<Self> {
        let family = next_family(&self.family, shape, joint.condition(), free)?;
        Ok(Self { family })
    }

    /// Measures the joint of the end of this family with the start of the next, up to `order`.
    ///
    /// # Errors
    /// As [`measure_families`].
    pub fn joint_with(&self, next: &Self, order: usize) -> Result<JointMeasure<f64, 4>> {
        measure_families(&self.family, &next.family, order)
    }
}

/// What a joint demands: equal derivatives (C1, C2, C3; for planes Farin-Boehm G1, G2), or beta constraints.
#[derive(Debug, Clone, PartialEq)]
pub struct Joint {
    condition: Continuity<f64>,
}

impl Joint {
    /// Equal derivatives up to `order`.
    #[must_use]
    pub fn parametric(order: usize) -> Self {
        Self {
            condition: Continuity::parametric(order, &0.0),
        }
    }

    /// Returns the beta constraints with these values: `[gamma]` for G1, `[gamma, lambda]` for G2-beta.
    ///
    /// # Errors
    /// As [`Continuity::beta`].
    pub fn beta(betas: &[f64]) -> Result<Self> {
        Continuity::beta(betas.to_vec()).map(|condition| Self { condition })
    }

    /// Returns the same up to a factor of the planes; see [`Continuity::scaled`].
    ///
    /// # Errors
    /// As [`Continuity::scaled`].
    pub fn scaled(self, scale: &[f64]) -> Result<Self> {
        let condition = self.condition.scaled(scale.to_vec())?;
        Ok(Self { condition })
    }

    /// Returns the condition of the generic layer.
    #[must_use]
    pub fn condition(&self) -> &Continuity<f64> {
        &self.condition
    }
}
