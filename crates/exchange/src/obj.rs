//! Wavefront OBJ.

use crate::mesh::Mesh;
use std::fmt::Write;

/// The mesh as OBJ with normals and quadrilateral faces; numbers in the shortest form that reads back
/// to the same f64.
///
/// ```
/// use torse_exchange::{Mesh, obj};
/// let mesh = Mesh {
///     vertices: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.5], [0.0, 1.0, 0.0]],
///     normals: vec![[0.0, 0.0, 1.0]; 4],
///     quads: vec![[0, 1, 2, 3]],
/// };
/// let text = obj(&mesh);
/// assert!(text.contains("v 1 1 0.5\n") && text.ends_with("f 1//1 2//2 3//3 4//4\n"));
/// ```
#[must_use]
pub fn obj(mesh: &Mesh) -> String {
    let mut text = String::from("# torse\n");
    for (tag, list) in [("v", &mesh.vertices), ("vn", &mesh.normals)] {
        for [x, y, z] in list {
            // Writing to a String cannot fail.
            let _ = writeln!(text, "{tag} {x} {y} {z}");
        }
    }
    for quad in &mesh.quads {
        let corners = quad.map(|i| format!("{0}//{0}", u64::from(i) + 1));
        let _ = writeln!(text, "f {}", corners.join(" "));
    }
    text
}
