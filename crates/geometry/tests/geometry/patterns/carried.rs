//! Points, curves and bends go to the sheet and back into space.

use crate::support::{cone, cubic, helix, unroll};
use torse_geometry::pattern::{
    FlatPattern, PatternError, PatternPlace, Placement, Segment, deviation, fold,
};
use torse_geometry::surface::Rails;
use torse_geometry::vector::{norm, sub};

/// The strain-free patches of these tests with a name.
fn patches() -> Vec<(&'static str, FlatPattern)> {
    vec![
        (
            "cone",
            unroll(&cone([1.0, 3.0], 4.0, 4.0), 33, 1e-6).unwrap(),
        ),
        (
            "inverted cone",
            unroll(&cone([3.0, 1.0], 1.0, 3.0), 33, 1e-6).unwrap(),
        ),
        (
            "helix",
            unroll(&helix(1.0, 0.5, 0.8, [0.5, 2.0]), 33, 1e-6).unwrap(),
        ),
        ("cubic", unroll(&cubic(), 33, 1e-6).unwrap()),
    ]
}

#[test]
fn points_go_to_the_sheet_and_back_and_distances_along_rulings_stay() {
    for (name, flat) in patches() {
        let placement = Placement::mirrored()
            .then(&Placement::turned(0.7))
            .then(&Placement::shifted([3.0, -8.0]));
        for flat in [flat.clone(), flat.placed(&placement)] {
            for (i, j) in [
                (0, 0),
                (0, 4),
                (3, 1),
                (5, 4),
                (8, 0),
                (8, 4),
                (2, 2),
                (7, 3),
            ] {
                let place = PatternPlace {
                    piece: 0,
                    x: f64::from(i) / 8.0,
                    v: f64::from(j) / 4.0,
                };
                let (sheet, space) = (flat.flatten(place).unwrap(), flat.space(place).unwrap());
                let lifted = flat.lift(sheet).unwrap();
                assert!(norm(&sub(&lifted, &space)) < 1e-9, "{name} {place:?}");
                let found = flat.locate_in_space(space, 1e-6).unwrap();
                assert!(
                    (found.x - place.x).abs() < 1e-7 && (found.v - place.v).abs() < 1e-7,
                    "{name} {found:?}"
                );
                let start = PatternPlace { v: 0.0, ..place };
                let (a, b) = (flat.flatten(start).unwrap(), flat.space(start).unwrap());
                let change = norm(&sub(&sheet, &a)) - norm(&sub(&space, &b));
                assert!(change.abs() < 1e-9, "{name}");
            }
            assert_eq!(flat.lift([100.0, 100.0]), None);
            assert_eq!(flat.locate_in_space([100.0; 3], 1.0), None);
            assert_eq!(
                flat.flatten(PatternPlace {
                    piece: 1,
                    x: 0.5,
                    v: 0.5
                }),
                None
            );
            assert_eq!(
                flat.space(PatternPlace {
                    piece: 0,
                    x: f64::NAN,
                    v: 0.5
                }),
                None
            );
        }
    }
}

#[test]
fn lengths_of_curves_on_the_patch_stay_on_the_sheet() {
    for (name, flat) in patches() {
        let curve = |t: f64| [0.1 + 0.8 * t, 0.5 + 0.4 * libm::sin(5.0 * t)];
        let n = 20_000;
        let (mut sheet, mut space) = (0.0, 0.0);
        let at = |i: i32| {
            let [x, v] = curve(f64::from(i) / f64::from(n));
            let place = PatternPlace { piece: 0, x, v };
            (flat.flatten(place).unwrap(), flat.space(place).unwrap())
        };
        for i in 0..n {
            let (a, b) = (at(i), at(i + 1));
            sheet += norm(&sub(&b.0, &a.0));
            space += norm(&sub(&b.1, &a.1));
        }
        assert!(
            (sheet - space).abs() < 1e-7 * space,
            "{name}: {sheet} {space}"
        );
        let carried = flat.carry(0, curve, 1e-3).unwrap();
        for i in (0..n).step_by(97) {
            let (point, _) = at(i);
            let near = carried
                .windows(2)
                .map(|w| Segment::line(w[0], w[1]).distance(point))
                .fold(f64::INFINITY, f64::min);
            assert!(near < 2e-3, "{name}: {near:e}");
        }
        assert!(flat.carry(0, |t| [2.0 * t, 0.5], 1e-3).is_err());
    }
}

#[test]
fn folding_the_drawing_alone_rebuilds_the_patch_with_an_error_that_falls_by_four() {
    let deviations = |patch: &dyn Rails<f64>| {
        [17, 33, 65, 129].map(|n| unroll(patch, n, 1e-7).unwrap().fold_deviation().unwrap())
    };
    for (name, list) in [
        ("cone", deviations(&cone([1.0, 3.0], 4.0, 4.0))),
        ("helix", deviations(&helix(1.0, 0.5, 0.8, [0.5, 2.0]))),
        ("cubic", deviations(&cubic())),
    ] {
        for pair in list.windows(2) {
            let ratio = pair[0] / pair[1];
            assert!((3.5..4.5).contains(&ratio), "{name}: {list:?}");
        }
        assert!(list[3] < 2e-3, "{name}: {list:?}");
    }
}

#[test]
fn a_pattern_turned_over_folds_to_the_same_body() {
    for (name, flat) in patches() {
        let over = flat.placed(&Placement::mirrored().then(&Placement::turned(1.0)));
        let (a, b) = (
            flat.fold_deviation().unwrap(),
            over.fold_deviation().unwrap(),
        );
        assert!((a - b).abs() < 1e-9, "{name}: {a} {b}");
        // With bends the wrong way it does not.
        let ends: Vec<_> = flat.rulings().iter().map(|r| r.ends).collect();
        let wrong: Vec<_> = flat.rulings().iter().map(|r| -r.bend).collect();
        let folded: Vec<_> = fold(&ends, &wrong).unwrap().into_iter().flatten().collect();
        let design: Vec<_> = flat.rulings_in_space().into_iter().flatten().collect();
        assert!(deviation(&folded, &design).unwrap() > 0.05, "{name}");
    }
}

#[test]
fn marks_that_touch_the_edge_of_regression_are_carried_to_its_flat_image() {
    // The helix itself is the first rail: on the sheet an arc whose radius is that of its curvature a/(a^2 + b^2).
    let (a, b, turns) = (1.0, 0.5, 0.5);
    let flat = unroll(&helix(a, b, turns, [0.0, 2.0]), 33, 1e-6).unwrap();
    let (radius, angle) = ((a * a + b * b) / a, 2.0 * std::f64::consts::PI * turns);
    let length = angle * libm::hypot(a, b);
    let edge = flat.carry(0, |t| [t, 0.0], 1e-6).unwrap();
    // It begins at the origin along the first axis and turns to the left.
    for [x, y] in &edge {
        let off = libm::hypot(*x, y - radius) - radius;
        assert!(off.abs() < 1e-6, "{off:e}");
    }
    let along: f64 = edge.windows(2).map(|w| norm(&sub(&w[1], &w[0]))).sum();
    assert!((along - length).abs() < 1e-4 * length, "{along} {length}");

    // A mark that comes in, touches the edge at x = 1/2 and goes back keeps its length, on either side.
    let curve = |t: f64| [t, (2.0 * t - 1.0).powi(2)];
    let carried = flat.carry(0, curve, 1e-6).unwrap();
    let sheet: f64 = carried.windows(2).map(|w| norm(&sub(&w[1], &w[0]))).sum();
    let at = |i: i32| {
        let [x, v] = curve(f64::from(i) / 20_000.0);
        flat.space(PatternPlace { piece: 0, x, v }).unwrap()
    };
    let space: f64 = (0..20_000).map(|i| norm(&sub(&at(i + 1), &at(i)))).sum();
    assert!((sheet - space).abs() < 1e-4 * space, "{sheet} {space}");
    let nearest = carried
        .iter()
        .map(|[x, y]| libm::hypot(*x, y - radius) - radius);
    assert!(nearest.fold(f64::INFINITY, f64::min).abs() < 1e-6);

    // The way back: next to the edge the distance falls with the square, the ruling is known to half the digits,
    // the point to all of them.
    for x in [0.0, 0.3, 0.5, 1.0] {
        let place = PatternPlace {
            piece: 0,
            x,
            v: 0.0,
        };
        let lifted = flat.lift(flat.flatten(place).unwrap()).unwrap();
        let off = norm(&sub(&lifted, &flat.space(place).unwrap()));
        assert!(off < 1e-9, "{x}: {off:e}");
    }
    // Beyond the edge there is no sheet.
    let inner = [0.0, 0.5 * radius];
    assert_eq!(flat.lift(inner), None);
    // A patch with the edge inside has no pattern to carry a mark to.
    assert!(matches!(
        unroll(&helix(a, b, turns, [-0.5, 2.0]), 33, 1e-6),
        Err(PatternError::Regression { .. })
    ));
}
