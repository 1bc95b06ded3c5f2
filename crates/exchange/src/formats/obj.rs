//! Wavefront OBJ.

use super::check_not_empty;
use crate::error::Result;
use crate::mesh::Mesh;
use std::fmt::Write;

/// The mesh as OBJ with normals; numbers in the shortest form that reads back to the same f64. The format has
/// no unit; the numbers are millimetres.
///
/// # Errors
/// [`ExchangeError::Empty`](crate::ExchangeError::Empty).
///
/// ```
/// use torse_exchange::{Mesh, obj};
/// let square = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
/// let text = obj(&Mesh::new(square, vec![[0, 1, 2], [0, 2, 3]])?)?;
/// assert!(text.contains("v 1 1 0\n") && text.ends_with("f 1//1 3//3 4//4\n"));
/// # Ok::<(), torse_exchange::ExchangeError>(())
/// ```
pub fn obj(mesh: &Mesh) -> Result<String> {
    check_not_empty(mesh)?;
    let mut text = String::from("# torse, millimetres\n");
    for (tag, list) in [("v", mesh.vertices()), ("vn", mesh.normals())] {
        for point in list {
            let [x, y, z] = point.map(|x| x + 0.0);
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{tag} {x} {y} {z}");
        }
    }
    for triangle in mesh.triangles() {
        let [a, b, c] = triangle.map(|i| u64::from(i) + 1);
        let _ = writeln!(text, "f {a}//{a} {b}//{b} {c}//{c}");
    }
    Ok(text)
}
