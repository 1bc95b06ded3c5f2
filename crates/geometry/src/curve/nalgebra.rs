//! Affine maps of nalgebra.

use super::affine::AffineMap;
use nalgebra::{Affine3, Isometry3, Matrix3, Matrix4, Vector3};

/// ```
/// use nalgebra::{Isometry3, Matrix4, Point3, Vector3};
/// use torse_geometry::{AffineMap, Bernstein, Curve};
/// let motion = Isometry3::new(Vector3::new(1.0, 2.0, 3.0), Vector3::new(0.3, -0.4, 0.5));
/// let map = AffineMap::from(motion);
/// let curve = Curve::new(Bernstein, vec![[0.0, 0.0, 1.0], [1.0, 3.0, 0.0], [4.0, 1.0, 2.0]])?;
/// let expected = motion * Point3::from(curve.point(&0.3)?);
/// let moved = Point3::from(curve.mapped(|p| map.apply(p)).point(&0.3)?);
/// assert!((moved - expected).norm() < 1e-14);
/// assert_eq!(Matrix4::from(map), motion.to_homogeneous());
///
/// // Other maps come as `Affine3`; back to it, nalgebra checks that the map can be inverted.
/// let shear = Matrix4::new(1., 2., 0., 5., 0., 1., 0., 6., 0., 0., 3., 7., 0., 0., 0., 1.);
/// let affine: nalgebra::Affine3<f64> = nalgebra::try_convert(shear).expect("an invertible map");
/// let map = AffineMap::from(affine);
/// assert_eq!(map.apply(&[1.0, 1.0, 1.0]), [8.0, 7.0, 10.0]);
/// assert_eq!(nalgebra::try_convert(Matrix4::from(map)), Some(affine));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
impl From<Affine3<f64>> for AffineMap<f64> {
    fn from(map: Affine3<f64>) -> Self {
        let matrix = map.matrix();
        Self {
            linear: std::array::from_fn(|i| std::array::from_fn(|j| matrix[(i, j)])),
            shift: std::array::from_fn(|i| matrix[(i, 3)]),
        }
    }
}

impl From<Isometry3<f64>> for AffineMap<f64> {
    fn from(motion: Isometry3<f64>) -> Self {
        Self::from(nalgebra::convert::<_, Affine3<f64>>(motion))
    }
}

/// The homogeneous matrix.
impl From<AffineMap<f64>> for Matrix4<f64> {
    fn from(map: AffineMap<f64>) -> Self {
        let linear = Matrix3::from(map.linear).transpose();
        linear
            .to_homogeneous()
            .append_translation(&Vector3::from(map.shift))
    }
}
