//! Binary STL.

use crate::mesh::Mesh;
use crate::single;
use torse_geometry::vector::{cross, sub, unit};

/// The mesh as binary STL (80 bytes header, triangle count, 50 bytes a triangle).
///
/// ```
/// use torse_exchange::{Mesh, stl};
/// use torse_geometry::{Bernstein, Curve, RuledSurface};
/// let rail = |z: f64| Curve::new(Bernstein, vec![[0.0, 0.0, z], [1.0, 0.0, z]]);
/// let mesh = Mesh::of(&RuledSurface::new(rail(0.0)?, rail(1.0)?), 3, 1)?;
/// let file = stl(&mesh);
/// assert_eq!(file.len(), 84 + 50 * 6);
/// assert_eq!(file[80..84], 6_u32.to_le_bytes());
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[must_use]
pub fn stl(mesh: &Mesh) -> Vec<u8> {
    let mut header = b"torse".to_vec();
    header.resize(80, b' ');
    let mut body = Vec::new();
    let mut count: u32 = 0;
    for corners in mesh.corners() {
        let [a, b, c] = corners;
        let normal = unit(&cross(&sub(&b, &a), &sub(&c, &a))).unwrap_or_default();
        for point in [normal, a, b, c] {
            body.extend(point.iter().flat_map(|x| single(*x).to_le_bytes()));
        }
        body.extend([0, 0]);
        count = count.saturating_add(1);
    }
    header.extend(count.to_le_bytes());
    header.extend(body);
    header
}
