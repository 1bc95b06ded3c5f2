//! Coordinates in single precision.

use crate::error::{ExchangeError, Result};
use crate::mesh::Mesh;

/// A mesh in single precision.
pub(super) struct Rounded {
    pub(super) vertices: Vec<[f32; 3]>,
    pub(super) triangles: Vec<[u32; 3]>,
}

/// The vertices in single precision, and the triangles whose corners still differ there. Rounding may bring
/// two corners together; leaving such a triangle out keeps a closed mesh closed, since its other two edges
/// become one.
pub(super) fn rounded(mesh: &Mesh) -> Result<Rounded> {
    let mut vertices = Vec::with_capacity(mesh.vertices().len());
    for (index, point) in mesh.vertices().iter().enumerate() {
        let single = point.map(narrow);
        if let Some(axis) = single.iter().position(|x| !x.is_finite()) {
            let value = point.get(axis).copied().unwrap_or(f64::NAN);
            return Err(ExchangeError::SinglePrecision { index, value });
        }
        vertices.push(single);
    }
    let at = |i: u32| usize::try_from(i).ok().and_then(|i| vertices.get(i));
    let distinct = |&[a, b, c]: &[u32; 3]| at(a) != at(b) && at(b) != at(c) && at(c) != at(a);
    let triangles: Vec<[u32; 3]> = mesh.triangles().iter().copied().filter(distinct).collect();
    if triangles.is_empty() {
        return Err(ExchangeError::Empty {
            what: "triangles larger than single precision resolves",
        });
    }
    Ok(Rounded {
        vertices,
        triangles,
    })
}

/// The nearest single, without a negative zero.
#[allow(clippy::cast_possible_truncation)]
pub(super) fn narrow(value: f64) -> f32 {
    value as f32 + 0.0
}
