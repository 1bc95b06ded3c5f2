//! Sheets that pass through themselves in space.

use torse_geometry::prelude::*;

fn band(points: &[Point]) -> Sheet {
    let edges = [SweptEdge::Share(0.0), SweptEdge::Share(1.0)];
    Sheet::cylinder(&Rail::bezier(points).unwrap(), [0.0, 30.0, 0.0], edges).unwrap()
}

#[test]
fn a_band_over_a_loop_is_found_and_one_over_an_arch_is_free() {
    let crossing = band(&[
        [0.0, 0.0, 0.0],
        [140.0, 0.0, 90.0],
        [-40.0, 0.0, 90.0],
        [100.0, 0.0, 0.0],
    ]);
    let SelfIntersection::Found {
        places,
        point,
        proved,
    } = crossing.self_intersection().unwrap()
    else {
        unreachable!("{:?}", crossing.self_intersection().unwrap())
    };
    let mut at = [places[0][0], places[1][0]];
    at.sort_by(f64::total_cmp);
    assert!((at[0] - 0.193_813_8).abs() < 1e-6 && (at[1] - 0.806_186_2).abs() < 1e-6);
    assert!((point[0] - 50.0).abs() < 1e-6 && (point[2] - 42.1875).abs() < 1e-6);
    assert!(proved);
    let arch = band(&[
        [0.0, 0.0, 0.0],
        [20.0, 0.0, 90.0],
        [80.0, 0.0, 90.0],
        [100.0, 0.0, 0.0],
    ]);
    assert_eq!(arch.self_intersection().unwrap(), SelfIntersection::Free);
    // The ends come as near as a hundredth.
    let near = band(&[
        [0.0, 0.0, 0.0],
        [200.0, 0.0, 90.0],
        [-200.0, 0.0, 90.0],
        [0.01, 0.0, 0.0],
    ]);
    assert!(matches!(
        near.self_intersection().unwrap(),
        SelfIntersection::Found { .. }
    ));
}

#[test]
fn tubes_and_cones_are_free_though_all_rulings_of_a_cone_meet() {
    let edges = [SweptEdge::Share(0.0), SweptEdge::Share(1.0)];
    let rim = Rail::ellipse_arc([0.0; 3], [30.0, 0.0, 0.0], [0.0, 30.0, 0.0]).unwrap();
    let cone = Sheet::cone(&rim, [0.0, 0.0, 50.0], edges).unwrap();
    assert_eq!(cone.self_intersection().unwrap(), SelfIntersection::Free);
    let crossing = Rail::bezier(&[
        [0.0, 0.0, 0.0],
        [140.0, 0.0, 90.0],
        [-40.0, 0.0, 90.0],
        [100.0, 0.0, 0.0],
    ])
    .unwrap();
    let cone = Sheet::cone(&crossing, [50.0, 80.0, 40.0], edges).unwrap();
    assert!(
        !matches!(cone.self_intersection().unwrap(), SelfIntersection::Free),
        "{:?}",
        cone.self_intersection().unwrap()
    );
}

#[test]
fn a_tube_over_a_closed_curve_is_free_though_it_closes() {
    let edges = [SweptEdge::Share(0.0), SweptEdge::Share(1.0)];
    let ring = Rail::bezier(&[
        [0.0, 0.0, 0.0],
        [120.0, -30.0, 0.0],
        [120.0, 150.0, 0.0],
        [-120.0, 150.0, 0.0],
        [-120.0, -30.0, 0.0],
        [0.0, 0.0, 0.0],
    ])
    .unwrap();
    let tube = Sheet::cylinder(&ring, [0.0, 0.0, 30.0], edges).unwrap();
    assert_eq!(tube.self_intersection().unwrap(), SelfIntersection::Free);
    // A helical strip of more than a turn that climbs by its own width and more is free, one that climbs less is not.
    let coil = |rise: f64| {
        let rail = |z: f64| {
            torse_geometry::curve::EllipticHelix::new(
                [0.0, 0.0, z],
                [50.0, 0.0, 0.0],
                [0.0, 50.0, 0.0],
                [0.0, 0.0, rise],
                [0.0, 8.0],
            )
            .map(Rail::from)
            .unwrap()
        };
        Sheet::ruled(rail(0.0), rail(20.0))
            .self_intersection()
            .unwrap()
    };
    assert_eq!(coil(40.0), SelfIntersection::Free);
    assert!(coil(4.0) != SelfIntersection::Free);
}
