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

/// Walls along the sides of a polygon, 30 wide.
fn walls(corners: &[Point]) -> Vec<Sheet> {
    corners.windows(2).map(band).collect()
}

fn together(sheets: &[Sheet]) -> PieceIntersection {
    let sheets: Vec<&Sheet> = sheets.iter().collect();
    Sheet::piece_intersection(&sheets, 1e-3).unwrap()
}

#[test]
fn walls_in_a_row_are_free_up_to_the_one_that_crosses_another() {
    let corners = [
        [0.0, 0.0, 0.0],
        [100.0, 0.0, 0.0],
        [100.0, 0.0, 50.0],
        [50.0, 0.0, 50.0],
        [50.0, 0.0, -50.0],
    ];
    assert_eq!(together(&walls(&corners[..4])), PieceIntersection::Free);
    let PieceIntersection::Found {
        patches,
        places,
        proved,
        ..
    } = together(&walls(&corners))
    else {
        unreachable!()
    };
    assert_eq!((patches, proved), ([0, 3], true));
    assert!((places[0][0] - 0.5).abs() < 1e-9 && (places[1][0] - 0.5).abs() < 1e-9);
    // The last wall ends a hair before the first, and on it.
    let short = |z: f64| {
        let mut corners = corners;
        corners[4] = [50.0, 0.0, z];
        together(&walls(&corners))
    };
    assert_eq!(short(0.01), PieceIntersection::Free);
    assert_ne!(short(0.0), PieceIntersection::Free);
}

#[test]
fn closed_rings_folds_and_patches_with_a_common_apex_are_free() {
    // A ring of three walls: each two share one ruling.
    let ring = [
        [0.0, 0.0, 0.0],
        [80.0, 0.0, 0.0],
        [40.0, 0.0, 60.0],
        [0.0, 0.0, 0.0],
    ];
    assert_eq!(together(&walls(&ring)), PieceIntersection::Free);
    // Two half tubes share two.
    let half = |points: [Point; 4]| band(&points);
    let tube = [
        half([
            [0.0, 0.0, 0.0],
            [0.0, 0.0, 60.0],
            [80.0, 0.0, 60.0],
            [80.0, 0.0, 0.0],
        ]),
        half([
            [80.0, 0.0, 0.0],
            [80.0, 0.0, -60.0],
            [0.0, 0.0, -60.0],
            [0.0, 0.0, 0.0],
        ]),
    ];
    assert_eq!(together(&tube), PieceIntersection::Free);
    // A fold of some 174 degrees.
    let fold = [[0.0, 0.0, 0.0], [100.0, 0.0, 0.0], [0.0, 0.0, 10.0]];
    assert_eq!(together(&walls(&fold)), PieceIntersection::Free);
    // A pyramid: all its faces share the apex, neighbours a ruling.
    let base = [
        [0.0, 0.0, 0.0],
        [80.0, 0.0, 0.0],
        [80.0, 60.0, 0.0],
        [0.0, 60.0, 0.0],
        [0.0, 0.0, 0.0],
    ];
    let edges = [SweptEdge::Share(1.0), SweptEdge::Share(0.0)];
    let faces: Vec<Sheet> = base
        .windows(2)
        .map(|side| Sheet::cone(&Rail::bezier(side).unwrap(), [40.0, 30.0, 50.0], edges).unwrap())
        .collect();
    assert_eq!(together(&faces), PieceIntersection::Free);
}

#[test]
fn a_cone_between_two_triangles_that_share_its_apex_is_free() {
    let edges = [SweptEdge::Share(1.0), SweptEdge::Share(0.0)];
    let triangle = |side: [Point; 2], apex: Point| {
        Sheet::cone(&Rail::bezier(&side).unwrap(), apex, edges).unwrap()
    };
    // The corner of a transition from a square to a round: both triangles end in the apex of the cone.
    let (corner, before, after) = ([50.0, 50.0, 0.0], [50.0, -50.0, 0.0], [-50.0, 50.0, 0.0]);
    let (first, last) = ([30.0, 0.0, 80.0], [0.0, 30.0, 80.0]);
    let round = Rail::ellipse_arc([0.0, 0.0, 80.0], first, last).unwrap();
    let row = [
        triangle([before, corner], first),
        Sheet::cone(&round, corner, edges).unwrap(),
        triangle([corner, after], last),
    ];
    assert_eq!(together(&row), PieceIntersection::Free);
}

#[test]
fn sheets_pierce_each_other_inside_and_do_not_where_they_touch_along_edges() {
    let plate = |a: Point, b: Point, c: Point, d: Point| {
        Sheet::ruled(
            Rail::bezier(&[a, b]).unwrap(),
            Rail::bezier(&[c, d]).unwrap(),
        )
    };
    let floor = plate(
        [0.0; 3],
        [100.0, 0.0, 0.0],
        [0.0, 50.0, 0.0],
        [100.0, 50.0, 0.0],
    );
    let wall = |low: f64| {
        plate(
            [50.0, 10.0, low],
            [50.0, 10.0, 30.0],
            [50.0, 40.0, low],
            [50.0, 40.0, 30.0],
        )
    };
    let piercings =
        |other: &Sheet| Sheet::piercings(&[vec![&floor], vec![other]], |_| true).unwrap();
    let found = piercings(&wall(-30.0));
    let [SheetPiercing { places, point, .. }] = found.as_slice() else {
        panic!("the wall stands through the floor");
    };
    assert!(
        (places[0][0] - 0.5).abs() < 1e-9
            && (places[1][0] - 0.5).abs() < 1e-9
            && point[2].abs() < 1e-9
    );
    assert_eq!(piercings(&wall(0.0)), []);
    assert_eq!(piercings(&wall(1.0)), []);
    let beside = plate(
        [100.0, 0.0, 0.0],
        [100.0, 50.0, 0.0],
        [100.0, 0.0, 30.0],
        [100.0, 50.0, 30.0],
    );
    assert_eq!(piercings(&beside), []);
}
