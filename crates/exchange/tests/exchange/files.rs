//! The file formats read back what was written.

use torse_exchange::{self as export, BezierPatch, Mesh};
use torse_geometry::{Bernstein, Curve, Gbt, RationalCurve, RuledSurface, TensorSurface};

fn mesh() -> Mesh {
    let rail = |z: f64| {
        Curve::new(
            Gbt::new(0.2, 0.3).unwrap(),
            vec![[0.0, z, 0.0], [1.0, 1.0, z], [5.0, z, z]],
        )
    };
    Mesh::of(
        &RuledSurface::new(rail(1.0).unwrap(), rail(2.0).unwrap()),
        5,
        3,
    )
    .unwrap()
}

#[test]
fn stl_triangles_have_the_corners_and_normals_of_the_mesh() {
    let mesh = mesh();
    let file = export::stl(&mesh);
    let float = |at: usize| f32::from_le_bytes(file[at..at + 4].try_into().unwrap());
    let triangles: Vec<[u32; 3]> = mesh.triangles().collect();
    assert_eq!(file.len(), 84 + 50 * triangles.len());
    for (n, triangle) in triangles.iter().enumerate() {
        let base = 84 + 50 * n;
        for (corner, &index) in triangle.iter().enumerate() {
            for axis in 0..3 {
                let stored = f64::from(float(base + 12 + 12 * corner + 4 * axis));
                assert!((stored - mesh.vertices[index as usize][axis]).abs() < 1e-6);
            }
        }
        let length: f32 = (0..3).map(|axis| float(base + 4 * axis).powi(2)).sum();
        assert!((length - 1.0).abs() < 1e-5);
    }
}

#[test]
fn glb_chunks_are_aligned_and_hold_all_buffers() {
    let mesh = mesh();
    let file = export::glb(&mesh);
    let word = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!((word(4), word(8)), (2, file.len()));
    let json = word(12);
    let binary = word(20 + json);
    assert_eq!(
        (json % 4, binary % 4, file.len()),
        (0, 0, 28 + json + binary)
    );
    let indices = mesh.triangles().count() * 12;
    assert_eq!(binary, 24 * mesh.vertices.len() + indices);
    let text = std::str::from_utf8(&file[20..20 + json]).unwrap();
    assert_eq!(text.matches('{').count(), text.matches('}').count());
    assert!(text.contains(&format!("\"count\":{},\"type\":\"SCALAR\"", indices / 4)));
    assert_eq!(&export::glb(&Mesh::default())[..4], b"glTF");
}

#[test]
fn obj_vertices_read_back_exactly() {
    let mesh = mesh();
    let text = export::obj(&mesh);
    let read: Vec<[f64; 3]> = text
        .lines()
        .filter_map(|line| line.strip_prefix("v "))
        .map(|line| {
            let numbers: Vec<f64> = line.split(' ').map(|n| n.parse().unwrap()).collect();
            numbers.try_into().unwrap()
        })
        .collect();
    assert_eq!(read, mesh.vertices);
}

#[test]
fn every_step_reference_is_defined_before_it_is_used() {
    let points = |z: f64| vec![[0.0, z, 1e30], [1.0, 1.0, z], [5.0, z, z]];
    let polynomial = Curve::new(Bernstein, points(0.0)).unwrap();
    let rational = RationalCurve::new(Bernstein, &points(2.0), vec![1.0, 0.5, 1.0]).unwrap();
    let mixed = BezierPatch::between(&polynomial, &rational).unwrap();
    let net = vec![points(0.0), points(1.0)];
    let plain = BezierPatch::from(&TensorSurface::new(Bernstein, Bernstein, net).unwrap());
    let text = export::step(&[mixed, plain]);
    assert!(
        text.contains("1.E30")
            && text.contains("RATIONAL_B_SPLINE_SURFACE(((1.0,1.0),(1.0,0.5),(1.0,1.0)))")
    );
    let mut known = 0;
    for line in text.lines().filter(|line| line.starts_with('#')) {
        let (id, body) = line[1..].split_once('=').unwrap();
        let id: usize = id.parse().unwrap();
        assert_eq!(id, known + 1);
        for reference in body.split('#').skip(1) {
            let digits: String = reference.chars().take_while(char::is_ascii_digit).collect();
            assert!(digits.parse::<usize>().unwrap() <= known, "{line}");
        }
        known = id;
    }
}
