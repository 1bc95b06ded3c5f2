//! Mesh files read back what was written.

use torse_exchange::{ExchangeError, Mesh, glb, obj, ply, stl, three_mf};
use torse_geometry::{Curve, Gbt, RuledSurface};

fn mesh() -> Mesh {
    let rail = |z: f64| {
        let points = vec![[0.0, z, 0.0], [1.0, 1.0, z], [5.0, z, z]];
        Curve::new(Gbt::new(0.2, 0.3).unwrap(), points).unwrap()
    };
    Mesh::sample(&RuledSurface::new(rail(1.0), rail(2.0)), 5, 3).unwrap()
}

#[test]
fn stl_triangles_have_the_corners_and_normals_of_the_mesh() {
    let mesh = mesh();
    let file = stl(&mesh).unwrap();
    let float = |at: usize| f32::from_le_bytes(file[at..at + 4].try_into().unwrap());
    assert_eq!(file.len(), 84 + 50 * mesh.triangles().len());
    for (n, triangle) in mesh.triangles().iter().enumerate() {
        let base = 84 + 50 * n;
        for (corner, &index) in triangle.iter().enumerate() {
            for axis in 0..3 {
                let stored = f64::from(float(base + 12 + 12 * corner + 4 * axis));
                assert!((stored - mesh.vertices()[index as usize][axis]).abs() < 1e-6);
            }
        }
        let length: f32 = (0..3).map(|axis| float(base + 4 * axis).powi(2)).sum();
        assert!((length - 1.0).abs() < 1e-5);
    }
}

#[test]
fn glb_chunks_are_aligned_and_the_bounds_are_the_stored_singles() {
    let mesh = mesh();
    let file = glb(&mesh).unwrap();
    let word = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!((word(4), word(8)), (2, file.len()));
    let json = word(12);
    let binary = word(20 + json);
    assert_eq!(
        (json % 4, binary % 4, file.len()),
        (0, 0, 28 + json + binary)
    );
    let triangles = mesh.triangles().len();
    assert_eq!(binary, 24 * mesh.vertices().len() + 12 * triangles);
    let text = std::str::from_utf8(&file[20..20 + json]).unwrap();
    assert_eq!(text.matches('{').count(), text.matches('}').count());
    let (_, high) = text.split_once("\"max\":[").unwrap();
    let high: Vec<f64> = high[..high.find(']').unwrap()]
        .split(',')
        .map(|x| x.parse().unwrap())
        .collect();
    let start = 28 + json;
    let stored =
        |n: usize| f32::from_le_bytes(file[start + 4 * n..start + 4 * n + 4].try_into().unwrap());
    for (axis, bound) in high.iter().enumerate() {
        let largest = (0..mesh.vertices().len()).map(|n| f64::from(stored(3 * n + axis)));
        assert_eq!(largest.fold(f64::MIN, f64::max), *bound);
    }
}

#[test]
fn obj_and_ply_vertices_read_back_exactly() {
    let mesh = mesh();
    let text = obj(&mesh).unwrap();
    let read: Vec<[f64; 3]> = text
        .lines()
        .filter_map(|line| line.strip_prefix("v "))
        .map(|line| {
            let numbers: Vec<f64> = line.split(' ').map(|n| n.parse().unwrap()).collect();
            numbers.try_into().unwrap()
        })
        .collect();
    assert_eq!(read, mesh.vertices());
    let file = ply(&mesh).unwrap();
    let tail = 48 * mesh.vertices().len() + 13 * mesh.triangles().len();
    let start = file.len() - tail;
    assert!(file[..start].ends_with(b"end_header\n"));
    for (n, vertex) in mesh.vertices().iter().enumerate() {
        for (axis, x) in vertex.iter().enumerate() {
            let at = start + 48 * n + 8 * axis;
            assert_eq!(f64::from_le_bytes(file[at..at + 8].try_into().unwrap()), *x);
        }
    }
}

#[test]
fn three_mf_calls_a_closed_mesh_a_model_and_an_open_one_a_surface() {
    // The parts of an archive, one after the other, unpacked.
    let text = |mesh: &Mesh| {
        let file = three_mf(mesh).unwrap();
        let word = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
        let half = |at: usize| u16::from_le_bytes(file[at..at + 2].try_into().unwrap()) as usize;
        let (mut at, mut text) = (0, String::new());
        while file[at..].starts_with(b"PK\x03\x04") {
            assert_eq!(half(at + 8), 8, "deflated");
            let begin = at + 30 + half(at + 26) + half(at + 28);
            let end = begin + word(at + 18);
            let part = miniz_oxide::inflate::decompress_to_vec(&file[begin..end]).unwrap();
            assert_eq!(part.len(), word(at + 22));
            text += &String::from_utf8(part).unwrap();
            at = end;
        }
        text
    };
    assert!(text(&mesh()).contains("type=\"surface\""));
    let solid = text(&mesh().thickened(0.1).unwrap());
    assert!(solid.contains("type=\"model\"") && solid.contains("unit=\"millimeter\""));
}

#[test]
fn what_single_precision_cannot_hold_is_refused() {
    let triangle = |size: f64, shift: f64| {
        let points = [[0.0; 3], [size, 0.0, 0.0], [0.0, size, 0.0]];
        let points = points.map(|[x, y, z]| [x + shift, y, z]).to_vec();
        Mesh::new(points, vec![[0, 1, 2]]).unwrap()
    };
    let huge = triangle(1e39, 0.0);
    for error in [stl(&huge).unwrap_err(), glb(&huge).unwrap_err()] {
        assert!(
            matches!(error, ExchangeError::SinglePrecision { index: 1, value } if value == 1e39)
        );
    }
    let tiny = triangle(1e-60, 0.0);
    let far = triangle(1e-4, 1e6);
    for mesh in [&tiny, &far] {
        assert!(matches!(stl(mesh), Err(ExchangeError::Empty { .. })));
        assert!(matches!(glb(mesh), Err(ExchangeError::Empty { .. })));
        assert!(obj(mesh).is_ok() && ply(mesh).is_ok() && three_mf(mesh).is_ok());
    }
    let none = Mesh::default();
    assert!(matches!(
        obj(&none),
        Err(ExchangeError::Empty { what: "triangles" })
    ));
}
