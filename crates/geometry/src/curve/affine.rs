//! Affine maps of space.

use crate::vector::{add, dot};
use torse_algebra::Scalar;

/// The map `p -> linear p + shift`; rows of the linear part first.
///
/// ```
/// use torse_geometry::{AffineMap, Curve, Gbt};
/// let map = AffineMap { linear: [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 2.0]], shift: [1.0, 2.0, 3.0] };
/// let curve = Curve::new(Gbt::new(0.2, 0.7)?, vec![[0.0, 0.0, 1.0], [1.0, 3.0, 0.0], [4.0, 1.0, 2.0]])?;
/// let (of_curve, of_points) = (map.apply(&curve.point(&0.3)?), curve.mapped(|p| map.apply(p)).point(&0.3)?);
/// assert!(of_curve.iter().zip(of_points).all(|(a, b)| (a - b).abs() < 1e-14));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
///
/// With the feature `nalgebra` it converts from and to the maps of nalgebra; points and vectors are arrays, which
/// nalgebra converts itself.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AffineMap<S> {
    /// The rows of the linear part.
    pub linear: [[S; 3]; 3],
    /// The image of the origin.
    pub shift: [S; 3],
}

impl<S: Scalar> AffineMap<S> {
    /// The image of a point.
    #[must_use]
    pub fn apply(&self, p: &[S; 3]) -> [S; 3] {
        let [x, y, z] = &self.linear;
        add(&[dot(x, p), dot(y, p), dot(z, p)], &self.shift)
    }
}
