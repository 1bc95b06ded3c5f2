//! Binary STL.

use super::check_not_empty;
use super::single::{Rounded, narrow, rounded};
use crate::error::Result;
use crate::mesh::Mesh;
use torse_geometry::vector::{cross, sub, unit};

/// The mesh as binary STL (80 bytes header, triangle count, 50 bytes a triangle). The format has no unit; the
/// numbers are millimetres.
///
/// # Errors
/// [`ExchangeError::Empty`](crate::ExchangeError::Empty),
/// [`ExchangeError::SinglePrecision`](crate::ExchangeError::SinglePrecision).
///
/// ```
/// use torse_exchange::{Mesh, stl};
/// let square = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
/// let file = stl(&Mesh::new(square, vec![[0, 1, 2], [0, 2, 3]])?)?;
/// assert_eq!(file.len(), 84 + 50 * 2);
/// assert_eq!(file[80..84], 2_u32.to_le_bytes());
/// # Ok::<(), torse_exchange::ExchangeError>(())
/// ```
pub fn stl(mesh: &Mesh) -> Result<Vec<u8>> {
    check_not_empty(mesh)?;
    let Rounded {
        vertices,
        triangles,
    } = rounded(mesh)?;
    let mut file = b"torse, millimetres".to_vec();
    file.resize(80, b' ');
    let count = u32::try_from(triangles.len()).unwrap_or(u32::MAX);
    file.extend(count.to_le_bytes());
    for triangle in &triangles {
        let exact = triangle.map(|i| at(mesh.vertices(), i));
        let [a, b, c] = &exact;
        let normal = unit(&cross(&sub(b, a), &sub(c, a))).unwrap_or_default();
        let corners = triangle.map(|i| at(&vertices, i));
        let numbers = normal
            .map(narrow)
            .into_iter()
            .chain(corners.into_iter().flatten());
        file.extend(numbers.flat_map(f32::to_le_bytes));
        file.extend([0, 0]);
    }
    Ok(file)
}

fn at<T: Copy + Default>(list: &[T], index: u32) -> T {
    usize::try_from(index)
        .ok()
        .and_then(|i| list.get(i))
        .copied()
        .unwrap_or_default()
}
