//! PLY (Stanford polygon format), binary.

use super::check_not_empty;
use crate::error::Result;
use crate::mesh::Mesh;

/// The mesh as binary little-endian PLY: vertices and normals in double precision, triangles. The one mesh
/// format here that loses no bit. It has no unit; the numbers are millimetres.
///
/// # Errors
/// [`ExchangeError::Empty`](crate::ExchangeError::Empty).
///
/// ```
/// use torse_exchange::{Mesh, ply};
/// let file = ply(&Mesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], vec![[0, 1, 2]])?)?;
/// assert!(file.starts_with(b"ply\nformat binary_little_endian 1.0\n"));
/// assert!(file.ends_with(&[3, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0]));
/// # Ok::<(), torse_exchange::ExchangeError>(())
/// ```
pub fn ply(mesh: &Mesh) -> Result<Vec<u8>> {
    check_not_empty(mesh)?;
    let mut header = format!(
        "ply\nformat binary_little_endian 1.0\ncomment torse, millimetres\nelement vertex {}\n",
        mesh.vertices().len()
    );
    for name in ["x", "y", "z", "nx", "ny", "nz"] {
        header.push_str(&format!("property double {name}\n"));
    }
    header.push_str(&format!(
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.triangles().len()
    ));
    let mut file = header.into_bytes();
    for (point, normal) in mesh.vertices().iter().zip(mesh.normals()) {
        let numbers = point.iter().chain(normal);
        file.extend(numbers.flat_map(|x| (x + 0.0).to_le_bytes()));
    }
    for triangle in mesh.triangles() {
        file.push(3);
        file.extend(triangle.iter().flat_map(|i| i.to_le_bytes()));
    }
    Ok(file)
}
