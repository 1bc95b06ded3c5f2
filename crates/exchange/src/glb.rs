//! Binary glTF 2.0.

use crate::mesh::Mesh;
use crate::single;

/// The mesh as GLB: one node, positions, normals and triangle indices. Empty meshes give an empty scene.
///
/// ```
/// use torse_exchange::{Mesh, glb};
/// let mesh = Mesh {
///     vertices: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.5], [0.0, 1.0, 0.0]],
///     normals: vec![[0.0, 0.0, 1.0]; 4],
///     quads: vec![[0, 1, 2, 3]],
/// };
/// let file = glb(&mesh);
/// assert_eq!(&file[..4], b"glTF");
/// assert_eq!(u32::from_le_bytes([file[8], file[9], file[10], file[11]]) as usize, file.len());
/// ```
#[must_use]
pub fn glb(mesh: &Mesh) -> Vec<u8> {
    let mut binary = Vec::new();
    for list in [&mesh.vertices, &mesh.normals] {
        for point in list {
            binary.extend(point.iter().flat_map(|x| single(*x).to_le_bytes()));
        }
    }
    binary.extend(mesh.triangles().flatten().flat_map(u32::to_le_bytes));
    let mut json = description(mesh, binary.len()).into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    binary.resize(binary.len().next_multiple_of(4), 0);

    let size = |n: usize| u32::try_from(n).unwrap_or(u32::MAX).to_le_bytes();
    let mut file = b"glTF".to_vec();
    file.extend(2_u32.to_le_bytes());
    let chunks: &[(&[u8], &[u8; 4])] = &[(&json, b"JSON"), (&binary, b"BIN\0")];
    let used = if mesh.vertices.is_empty() {
        &chunks[..1]
    } else {
        chunks
    };
    file.extend(size(
        12 + used.iter().map(|(data, _)| 8 + data.len()).sum::<usize>(),
    ));
    for (data, kind) in used {
        file.extend(size(data.len()));
        file.extend(*kind);
        file.extend(*data);
    }
    file
}

fn description(mesh: &Mesh, length: usize) -> String {
    let head = r#"{"asset":{"version":"2.0","generator":"torse"},"scene":0"#;
    if mesh.vertices.is_empty() {
        return format!(r#"{head},"scenes":[{{}}]}}"#);
    }
    let vertices = mesh.vertices.len();
    let indices = mesh.triangles().count() * 3;
    let (positions, normals) = (12 * vertices, 12 * mesh.normals.len());
    let bound = |start: f32, pick: fn(f32, f32) -> f32| {
        let axis = |k: usize| mesh.vertices.iter().map(|p| single(p[k])).fold(start, pick);
        format!("[{},{},{}]", axis(0), axis(1), axis(2))
    };
    let (low, high) = (
        bound(f32::INFINITY, f32::min),
        bound(f32::NEG_INFINITY, f32::max),
    );
    format!(
        concat!(
            r#"{head},"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],"#,
            r#""meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"NORMAL":1}},"indices":2}}]}}],"#,
            r#""buffers":[{{"byteLength":{length}}}],"bufferViews":["#,
            r#"{{"buffer":0,"byteOffset":0,"byteLength":{positions},"target":34962}},"#,
            r#"{{"buffer":0,"byteOffset":{positions},"byteLength":{normals},"target":34962}},"#,
            r#"{{"buffer":0,"byteOffset":{offset},"byteLength":{tail},"target":34963}}],"#,
            r#""accessors":["#,
            r#"{{"bufferView":0,"componentType":5126,"count":{vertices},"type":"VEC3","min":{low},"max":{high}}},"#,
            r#"{{"bufferView":1,"componentType":5126,"count":{normal_count},"type":"VEC3"}},"#,
            r#"{{"bufferView":2,"componentType":5125,"count":{indices},"type":"SCALAR"}}]}}"#,
        ),
        head = head,
        length = length,
        positions = positions,
        normals = normals,
        offset = positions + normals,
        tail = 4 * indices,
        vertices = vertices,
        low = low,
        high = high,
        normal_count = mesh.normals.len(),
        indices = indices,
    )
}
