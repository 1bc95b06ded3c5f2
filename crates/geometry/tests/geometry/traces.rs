//! Curves on sheets: where rulings pierce them, where a rail lies on them.

use std::f64::consts::PI;
use torse_geometry::curve::EllipticHelix;
use torse_geometry::prelude::*;

fn arc(centre: Point, from: Point, axis: Point, angle: f64) -> Rail {
    Rail::from(EllipticHelix::about(centre, axis, from, angle, 0.0).unwrap())
}

/// A pipe of radius 5 along x in two halves that meet at its sides.
fn pipe() -> [Sheet; 2] {
    let edges = [SweptEdge::Share(-20.0), SweptEdge::Share(20.0)];
    [[0.0, 5.0, 0.0], [0.0, -5.0, 0.0]].map(|from| {
        let rim = arc([0.0; 3], from, [1.0, 0.0, 0.0], 180.0);
        Sheet::cylinder(&rim, [1.0, 0.0, 0.0], edges).unwrap()
    })
}

fn branch(centre: Point, radius: f64, way: Point) -> Sheet {
    // Across the way.
    let side = if way[2] == 0.0 {
        [0.0, 0.0, radius]
    } else {
        [radius, 0.0, 0.0]
    };
    let from = [0, 1, 2].map(|i| centre[i] + side[i]);
    let edges = [SweptEdge::Share(0.0), SweptEdge::Share(1.0)];
    Sheet::cylinder(&arc(centre, from, way, 360.0), way, edges).unwrap()
}

#[test]
fn a_saddle_is_followed_around_within_its_bound() {
    let halves = pipe();
    let tracer = SheetTracer::new(&[&halves[0], &halves[1]]).unwrap();
    let through = branch([1.0, 0.5, 9.0], 2.0, [0.0, 0.0, -9.0]);
    let found = tracer
        .pierced(&[&through], PiercingReach::Ruling, 1e-6)
        .unwrap();
    let [saddle] = found.as_slice() else {
        panic!("{} curves", found.len())
    };
    let mut seen = 0;
    for piece in saddle {
        // A quarter of the rim at a time: a polynomial of degree 16 misses it by 1e-9, which is proved.
        assert!(piece.off() < 2e-9, "{:e}", piece.off());
        let chords = piece.chords(1e-3).unwrap();
        assert!(piece.chord_distance(chords) <= 1e-3 && chords < 200);
        for k in 0..=20 {
            let [u, v] = piece.place(f64::from(k) / 20.0);
            let [x, y, z] = halves[piece.sheet()].point(u, v).unwrap();
            let off = (libm::hypot(x - 1.0, y - 0.5) - 2.0).abs() + (libm::hypot(y, z) - 5.0).abs();
            assert!(off <= piece.off() + 1e-12 && z > 0.0, "{off:e}");
            seen += 1;
        }
    }
    assert!(seen > 80);
}

#[test]
fn a_curve_over_a_joint_goes_from_sheet_to_sheet_and_back() {
    let halves = pipe();
    let tracer = SheetTracer::new(&[&halves[0], &halves[1]]).unwrap();
    // From the side at which both halves meet.
    let through = branch([0.0, 9.0, 0.0], 2.0, [0.0, -9.0, 0.0]);
    let found = tracer
        .pierced(&[&through], PiercingReach::Ruling, 1e-6)
        .unwrap();
    let sheets: Vec<usize> = found[0].iter().map(SheetArc::sheet).collect();
    assert!(sheets.contains(&0) && sheets.contains(&1), "{sheets:?}");
    let length: f64 = found[0]
        .iter()
        .map(|piece| {
            let points: Vec<Point> = (0..=64)
                .map(|k| {
                    let [u, v] = piece.place(f64::from(k) / 64.0);
                    halves[piece.sheet()].point(u, v).unwrap()
                })
                .collect();
            let sides = points.windows(2).map(|p| {
                let d = [0, 1, 2].map(|i| p[1][i] - p[0][i]);
                d.iter().map(|c| c * c).sum::<f64>().sqrt()
            });
            sides.sum::<f64>()
        })
        .sum();
    // By its parameter: x = 2 cos t, z = 2 sin t, y = sqrt(25 - z^2).
    let speed = |t: f64| {
        let (s, c) = libm::sincos(t);
        (4.0 + (4.0 * s * c).powi(2) / (25.0 - 4.0 * s * s)).sqrt()
    };
    let exact: f64 = (0..512)
        .map(|k| speed(2.0 * PI * f64::from(k) / 512.0))
        .sum::<f64>()
        * 2.0
        * PI
        / 512.0;
    assert!((length - exact).abs() < 1e-3, "{length} {exact}");
}

#[test]
fn both_walls_are_pierced_and_the_first_alone_where_that_is_asked() {
    let halves = pipe();
    let tracer = SheetTracer::new(&[&halves[0], &halves[1]]).unwrap();
    let through = branch([0.0, 0.0, 9.0], 2.0, [0.0, 0.0, -18.0]);
    let both = tracer
        .pierced(&[&through], PiercingReach::Ruling, 1e-6)
        .unwrap();
    assert_eq!(both.len(), 2);
    let first = tracer
        .pierced(&[&through], PiercingReach::First, 1e-6)
        .unwrap();
    assert_eq!(first.len(), 1);
    let [u, v] = first[0][0].place(0.0);
    assert!(halves[first[0][0].sheet()].point(u, v).unwrap()[2] > 0.0);
}

#[test]
fn what_is_not_pierced_all_around_is_refused() {
    let halves = pipe();
    let tracer = SheetTracer::new(&[&halves[0], &halves[1]]).unwrap();
    let refused = |centre, radius, way| {
        let through = branch(centre, radius, way);
        tracer
            .pierced(&[&through], PiercingReach::Ruling, 1e-6)
            .unwrap_err()
    };
    let down = [0.0, 0.0, -9.0];
    assert!(matches!(
        refused([0.0, 40.0, 9.0], 2.0, down),
        TraceError::Misses { .. }
    ));
    assert!(matches!(
        refused([0.0, 0.0, 9.0], 2.0, [0.0, 0.0, -2.0]),
        TraceError::TooShort { .. }
    ));
    assert!(matches!(
        refused([20.0, 0.0, 9.0], 2.0, down),
        TraceError::Leaves { .. } | TraceError::Uneven { .. }
    ));
    // As wide as the pipe: it touches its sides.
    let touching = refused([0.0, 0.0, 9.0], 5.0, down);
    assert!(!matches!(touching, TraceError::Geometry(_)), "{touching}");
    // Partly beside the pipe.
    assert!(!matches!(
        refused([0.0, 4.0, 9.0], 2.0, down),
        TraceError::Geometry(_)
    ));
}

#[test]
fn a_rail_lies_on_a_sheet_or_is_refused_with_its_point() {
    let halves = pipe();
    let tracer = SheetTracer::new(&[&halves[0], &halves[1]]).unwrap();
    // The ellipse in which the plane z = x + 3.. cuts the pipe leaves it nowhere; lifted a little it does not lie on it.
    let ellipse = |lift: f64| {
        let arc = EllipticHelix::new(
            [0.0, 0.0, lift],
            [5.0, 0.0, 5.0],
            [0.0, 5.0, 0.0],
            [0.0; 3],
            [0.0, 4.0],
        )
        .unwrap();
        PiecewiseRail::from(Rail::from(arc))
    };
    let arcs = tracer.lying(&ellipse(0.0), 1e-6).unwrap();
    assert!(arcs.iter().all(|arc| arc.off() < 1e-6));
    let error = tracer.lying(&ellipse(0.5), 1e-3).unwrap_err();
    assert!(
        matches!(error, TraceError::NotOnSheet { distance, .. } if distance > 0.1 && distance < 0.6),
        "{error}"
    );
}

#[test]
fn lines_that_are_straight_in_the_parameters_have_the_bound_of_their_bend() {
    let halves = pipe();
    let tracer = SheetTracer::new(&[&halves[0], &halves[1]]).unwrap();
    let arcs = tracer.straight(0, [0.25, 0.0], [0.75, 1.0]).unwrap();
    // A helix: radius 5 by a quarter turn in all.
    let bend: f64 = 5.0 * (PI / 2.0).powi(2);
    let exact = bend / 8.0;
    let total: f64 = arcs
        .iter()
        .map(|arc| arc.chord_distance(1).sqrt())
        .sum::<f64>()
        .powi(2);
    assert!(
        total >= exact * (1.0 - 1e-9) && total < 1.1 * exact,
        "{total} {exact}"
    );
    let along = tracer.straight(1, [0.5, 0.2], [0.5, 0.9]).unwrap();
    assert!(along.iter().all(|arc| arc.chords(1e-9) == Some(1)));
}

#[test]
fn polygons_on_rails_are_as_near_as_they_say() {
    let rails = [
        Rail::bezier(&[
            [0.0, 0.0, 0.0],
            [2.0, 9.0, 1.0],
            [-3.0, 4.0, 2.0],
            [6.0, 0.0, 0.0],
        ])
        .unwrap(),
        Rail::gbt(
            0.5,
            -0.3,
            &[[0.0, 0.0, 0.0], [1.0, 5.0, 0.0], [3.0, 2.0, 4.0]],
        )
        .unwrap(),
        arc([0.0; 3], [3.0, 0.0, 0.0], [0.0, 0.0, 1.0], 300.0),
        Rail::weighted(
            BasisShape::Bernstein,
            &[[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
            &[1.0, 0.7, 1.0],
        )
        .unwrap(),
    ];
    for rail in &rails {
        for within in [1e-1, 1e-3] {
            let corners = rail.polygon(within).unwrap();
            for k in 0..=400 {
                let point = rail.point(f64::from(k) / 400.0).unwrap();
                let near = corners.windows(2).map(|side| {
                    let way = [0, 1, 2].map(|i| side[1][i] - side[0][i]);
                    let arm = [0, 1, 2].map(|i| point[i] - side[0][i]);
                    let square: f64 = way.iter().map(|c| c * c).sum();
                    let share = way.iter().zip(&arm).map(|(a, b)| a * b).sum::<f64>() / square;
                    let share = share.clamp(0.0, 1.0);
                    (0..3)
                        .map(|i| (arm[i] - share * way[i]).powi(2))
                        .sum::<f64>()
                        .sqrt()
                });
                let near = near.fold(f64::INFINITY, f64::min);
                assert!(near <= within, "{near} {within}");
            }
        }
    }
    assert!(rails[0].polygon(0.0).is_err() && rails[0].polygon(f64::NAN).is_err());
    assert!(rails[0].polygon(1e-15).is_err());
}

#[test]
fn a_wall_in_front_of_a_part_of_the_curve_is_told() {
    let square = |z: f64, from: f64, to: f64| {
        let side = |y: f64| Rail::bezier(&[[from, y, z], [to, y, z]]).unwrap();
        Sheet::ruled(side(-9.0), side(9.0))
    };
    let (floor, shelf) = (square(0.0, -9.0, 9.0), square(4.0, -1.3, -0.4));
    let through = branch([0.0, 0.0, 9.0], 2.0, [0.0, 0.0, -9.0]);
    let alone = SheetTracer::new(&[&floor]).unwrap();
    let found = alone.pierced(&[&through], PiercingReach::First, 1e-6);
    assert_eq!(found.unwrap().len(), 1);
    // The rulings at each quarter of the way around pass by the shelf.
    let both = SheetTracer::new(&[&floor, &shelf]).unwrap();
    let refused = |reach| both.pierced(&[&through], reach, 1e-6).unwrap_err();
    let front = refused(PiercingReach::First);
    assert!(
        matches!(front, TraceError::Hidden { at: [x, _, z] } if z == 4.0 && -1.3 < x && x < -0.4),
        "{front}"
    );
    let uneven = refused(PiercingReach::Ruling);
    assert!(
        matches!(uneven, TraceError::Uneven { counts: [1, 2], .. }),
        "{uneven}"
    );
}
