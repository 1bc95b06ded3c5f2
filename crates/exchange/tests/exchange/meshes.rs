//! Meshes: size, area, closedness, and hostile data.

use proptest::prelude::*;
use torse_exchange::{ExchangeError, Mesh};
use torse_geometry::curve::ellipse_arc;
use torse_geometry::{
    Bernstein, Curve, EnvelopingPatch, Gbt, PatchBounds, PlaneFamily, RuledSurface, TensorSurface,
};

#[test]
fn meshes_too_large_to_index_are_refused_before_memory_is_asked_for() {
    let flat = TensorSurface::new(Bernstein, Bernstein, vec![vec![[0.0; 3]; 2]; 2]).unwrap();
    let refused = |m, n| Mesh::sample(&flat, m, n).unwrap_err();
    assert!(matches!(refused(0, 3), ExchangeError::OutOfRange { .. }));
    for (m, n) in [(usize::MAX, 1), (1 << 20, 1 << 20)] {
        assert!(matches!(refused(m, n), ExchangeError::TooMany { .. }));
    }
}

#[test]
fn the_area_of_a_mesh_converges_to_the_area_of_the_cylinder() {
    let quarter = ellipse_arc(&[0.0; 3], &[2.0, 0.0, 0.0], &[0.0, 2.0, 0.0]).unwrap();
    let cylinder = TensorSurface::cylinder(&quarter, &[0.0, 0.0, 1.0], &3.0).unwrap();
    let exact = 3.0 * std::f64::consts::PI;
    let area = Mesh::sample(&cylinder, 200, 4).unwrap().area();
    assert!(area < exact && exact - area < 1e-4 * exact);
}

#[test]
fn a_twisted_patch_needs_more_rulings_than_its_straight_rails() {
    let rail = |a: [f64; 3], b: [f64; 3]| Curve::new(Bernstein, vec![a, b]).unwrap();
    let first = rail([0.0, 0.0, 0.0], [1.0, 0.0, 0.0]);
    let twisted = RuledSurface::new(first.clone(), rail([0.0, 1.0, 0.0], [1.0, 1.0, 1.0]));
    let plane = RuledSurface::new(first, rail([0.0, 1.0, 0.0], [1.0, 1.0, 0.0]));
    let count = |patch| Mesh::ruled(patch, 1e-2).unwrap().triangles().len();
    assert_eq!(count(&plane), 4);
    assert!(count(&twisted) > 16);
}

#[test]
fn four_quarters_of_a_tube_weld_to_a_closed_solid() {
    let (radius, height, wall) = (5.0, 4.0, 0.2);
    let quarter = |turn: usize, z: f64| {
        let way = |n: usize| match n % 4 {
            0 => [radius, 0.0, z],
            1 => [0.0, radius, z],
            2 => [-radius, 0.0, z],
            _ => [0.0, -radius, z],
        };
        ellipse_arc(&[0.0, 0.0, z], &way(turn), &way(turn + 1)).unwrap()
    };
    let mut tube = Mesh::default();
    for turn in 0..4 {
        let patch = RuledSurface::new(quarter(turn, 0.0), quarter(turn, height));
        tube.append(&Mesh::ruled(&patch, 1e-3).unwrap()).unwrap();
    }
    let solid = tube.welded(1e-9).unwrap().thickened(wall).unwrap();
    assert!(solid.is_watertight() && !tube.is_watertight());
    let exact = 2.0 * std::f64::consts::PI * radius * wall * height;
    assert!(
        (solid.volume() - exact).abs() < 1e-3 * exact,
        "{}",
        solid.volume()
    );
    // Without welding each quarter has walls of its own at the seams.
    assert!(tube.thickened(wall).unwrap().area() > solid.area() + 6.0 * wall * height);
}

#[test]
fn a_mesh_refuses_what_no_file_can_hold() {
    let square = vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, f64::NAN, 0.0]];
    let error = Mesh::new(square, vec![[0, 1, 2]]).unwrap_err();
    assert_eq!(error.to_string(), "vertex 2: NaN is not a finite number");
    let error = Mesh::new(vec![[0.0; 3]; 3], vec![[0, 1, 3]]).unwrap_err();
    assert_eq!(error.to_string(), "triangle 0: there is no vertex 3");
}

fn any() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        Just(f64::NAN),
        Just(f64::INFINITY),
        Just(1e300),
        Just(-1e-300),
        -10.0..10.0_f64,
        proptest::num::f64::ANY,
    ]
}

proptest! {
    #[test]
    fn a_mesh_is_refused_or_finite_with_unit_normals(
        planes in prop::collection::vec(prop::array::uniform4(any()), 3..6), mu in any(), a in any(), b in any(),
    ) {
        let patch = Gbt::new(mu, mu).and_then(|basis| PlaneFamily::new(basis, planes))
            .and_then(|family| EnvelopingPatch::new(family, PatchBounds::Range([a, b])));
        let Ok(patch) = patch else { return Ok(()) };
        for mesh in [Mesh::sample(&patch, 2, 2), Mesh::ruled(&patch, 1.0)].into_iter().flatten() {
            prop_assert!(mesh.vertices().iter().flatten().all(|x| x.is_finite()));
            for n in mesh.normals() {
                prop_assert!((n.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-12);
            }
        }
    }
}
