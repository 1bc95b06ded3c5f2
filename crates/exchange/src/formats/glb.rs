//! Binary glTF 2.0.

use super::check_not_empty;
use super::single::{Rounded, narrow, rounded};
use crate::error::{ExchangeError, Result};
use crate::mesh::Mesh;

/// The mesh as GLB: positions, normals and triangle indices in millimetres with z up, under a root node that
/// turns z to y and scales to metres, as glTF wants them.
///
/// # Errors
/// [`ExchangeError::Empty`], [`ExchangeError::SinglePrecision`], [`ExchangeError::TooMany`] for a file of 4 GiB.
///
/// ```
/// use torse_exchange::{Mesh, glb};
/// let file = glb(&Mesh::new(vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.5]], vec![[0, 1, 2]])?)?;
/// assert_eq!(&file[..4], b"glTF");
/// assert_eq!(u32::from_le_bytes([file[8], file[9], file[10], file[11]]) as usize, file.len());
/// # Ok::<(), torse_exchange::ExchangeError>(())
/// ```
pub fn glb(mesh: &Mesh) -> Result<Vec<u8>> {
    check_not_empty(mesh)?;
    let Rounded {
        vertices,
        triangles,
    } = rounded(mesh)?;
    let mut binary = Vec::with_capacity(24 * vertices.len() + 12 * triangles.len());
    binary.extend(vertices.iter().flatten().flat_map(|x| x.to_le_bytes()));
    let normals = mesh.normals().iter().flatten();
    binary.extend(normals.flat_map(|x| narrow(*x).to_le_bytes()));
    binary.extend(triangles.iter().flatten().flat_map(|i| i.to_le_bytes()));
    let mut json = description(&vertices, triangles.len()).into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');

    let size = |n: usize| -> Result<[u8; 4]> {
        let too_many = |_| ExchangeError::TooMany {
            what: "bytes of a GLB",
            given: n,
            most: 0xffff_ffff,
        };
        Ok(u32::try_from(n).map_err(too_many)?.to_le_bytes())
    };
    let mut file = b"glTF".to_vec();
    file.extend(2_u32.to_le_bytes());
    file.extend(size(28 + json.len() + binary.len())?);
    for (data, kind) in [(json, b"JSON"), (binary, b"BIN\0")] {
        file.extend(size(data.len())?);
        file.extend(kind);
        file.extend(data);
    }
    Ok(file)
}

fn description(vertices: &[[f32; 3]], triangles: usize) -> String {
    let count = vertices.len();
    let (block, tail) = (12 * count, 12 * triangles);
    let bound = |start: f32, pick: fn(f32, f32) -> f32| {
        // As doubles, whose text is exact: the bounds must be the stored singles, not near them.
        let axis = |k: usize| f64::from(vertices.iter().map(|p| p[k]).fold(start, pick));
        format!("[{},{},{}]", axis(0), axis(1), axis(2))
    };
    let low = bound(f32::INFINITY, f32::min);
    let high = bound(f32::NEG_INFINITY, f32::max);
    let half = std::f64::consts::FRAC_1_SQRT_2;
    format!(
        concat!(
            r#"{{"asset":{{"version":"2.0","generator":"torse"}},"scene":0,"scenes":[{{"nodes":[0]}}],"#,
            r#""nodes":[{{"mesh":0,"rotation":[-{half},0,0,{half}],"scale":[0.001,0.001,0.001]}}],"#,
            r#""materials":[{{"doubleSided":true,"pbrMetallicRoughness":{{"metallicFactor":0}}}}],"#,
            r#""meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"NORMAL":1}},"indices":2,"material":0}}]}}],"#,
            r#""buffers":[{{"byteLength":{length}}}],"bufferViews":["#,
            r#"{{"buffer":0,"byteOffset":0,"byteLength":{block},"target":34962}},"#,
            r#"{{"buffer":0,"byteOffset":{block},"byteLength":{block},"target":34962}},"#,
            r#"{{"buffer":0,"byteOffset":{offset},"byteLength":{tail},"target":34963}}],"#,
            r#""accessors":["#,
            r#"{{"bufferView":0,"componentType":5126,"count":{count},"type":"VEC3","min":{low},"max":{high}}},"#,
            r#"{{"bufferView":1,"componentType":5126,"count":{count},"type":"VEC3"}},"#,
            r#"{{"bufferView":2,"componentType":5125,"count":{indices},"type":"SCALAR"}}]}}"#,
        ),
        half = half,
        length = 2 * block + tail,
        block = block,
        offset = 2 * block,
        tail = tail,
        count = count,
        low = low,
        high = high,
        indices = 3 * triangles,
    )
}
