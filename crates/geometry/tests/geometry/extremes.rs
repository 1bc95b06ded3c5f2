//! Boxes around rails, nearest points, parts: against closed forms and dense samples.

use proptest::prelude::*;
use torse_geometry::prelude::*;
use torse_geometry::vector::{norm, sub};

const STEPS: usize = 4000;

fn samples(rail: &Rail) -> impl Iterator<Item = Point> {
    let at = |k: usize| rail.point(k as f64 / STEPS as f64).unwrap();
    (0..=STEPS).map(at)
}

/// The extremes of a cubic Bezier coordinate, by the roots of its derivative.
fn extremes(c: [f64; 4]) -> [f64; 2] {
    let [d0, d1, d2] = [c[1] - c[0], c[2] - c[1], c[3] - c[2]];
    // d0 (1-t)^2 + 2 d1 t (1-t) + d2 t^2
    let (a, b, c0) = (d0 - 2.0 * d1 + d2, 2.0 * (d1 - d0), d0);
    let mut places = vec![0.0, 1.0];
    let root = (b * b - 4.0 * a * c0).sqrt();
    let q = -0.5 * (b + root.copysign(b));
    places.extend([q / a, c0 / q]);
    let at = |t: f64| {
        let s = 1.0 - t;
        c[0] * s * s * s + 3.0 * c[1] * s * s * t + 3.0 * c[2] * s * t * t + c[3] * t * t * t
    };
    let inside = places.into_iter().filter(|t| (0.0..=1.0).contains(t));
    inside
        .map(at)
        .fold([f64::INFINITY, f64::NEG_INFINITY], |m, v| {
            [m[0].min(v), m[1].max(v)]
        })
}

fn points(count: usize) -> impl Strategy<Value = Vec<Point>> {
    let coordinate = || -10.0..10.0_f64;
    let point = (coordinate(), coordinate(), coordinate()).prop_map(|(x, y, z)| [x, y, z]);
    prop::collection::vec(point, count)
}

/// Any kind of rail with four control points.
fn rails() -> impl Strategy<Value = Rail> {
    let shapes = (any::<bool>(), -1.0..=1.0, -1.0..=1.0_f64);
    let weights = prop::option::of(prop::array::uniform4(0.2..5.0_f64));
    (points(4), shapes, weights).prop_map(|(points, (gbt, mu, nu), weights)| {
        let shape = if gbt {
            BasisShape::gbt(mu, nu).unwrap()
        } else {
            BasisShape::Bernstein
        };
        match weights {
            Some(weights) => Rail::weighted(shape, &points, &weights).unwrap(),
            None => Rail::new(shape, &points).unwrap(),
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_box_of_a_cubic_ends_at_the_roots_of_its_derivatives(points in points(4)) {
        let [low, high] = Rail::bezier(&points).unwrap().bounding_box(1e-9).unwrap();
        for axis in 0..3 {
            let [least, most] = extremes([0, 1, 2, 3].map(|k: usize| points[k][axis]));
            prop_assert!(low[axis] <= least + 1e-13 && least - low[axis] <= 1e-9 + 1e-13);
            prop_assert!(high[axis] >= most - 1e-13 && high[axis] - most <= 1e-9 + 1e-13);
        }
    }

    #[test]
    fn a_box_holds_its_rail_and_touches_it_on_all_sides(rail in rails()) {
        let [low, high] = rail.bounding_box(1e-6).unwrap();
        let mut room = [f64::INFINITY; 6];
        for p in samples(&rail) {
            for axis in 0..3 {
                prop_assert!(p[axis] >= low[axis] - 1e-12 && p[axis] <= high[axis] + 1e-12);
                room[axis] = room[axis].min(p[axis] - low[axis]);
                room[axis + 3] = room[axis + 3].min(high[axis] - p[axis]);
            }
        }
        // Between two samples a coordinate rises by h^2/8 of its second derivative at most.
        prop_assert!(room.iter().all(|r| *r < 1e-6 + 2e-4), "{room:?}");
    }

    #[test]
    fn no_sample_is_nearer_than_the_nearest_point(rail in rails(), point in points(1)) {
        let nearest = rail.nearest(point[0], 1e-9).unwrap();
        let there = norm(&sub(&nearest.point, &point[0]));
        prop_assert!((there - nearest.distance).abs() <= 1e-12);
        prop_assert_eq!(nearest.point, rail.point(nearest.x).unwrap());
        let sampled = samples(&rail).map(|p| norm(&sub(&p, &point[0])));
        let least = sampled.fold(f64::INFINITY, f64::min);
        prop_assert!(nearest.distance <= least + 1e-9, "{} {}", nearest.distance, least);
        prop_assert!(nearest.distance >= least - 0.1);
    }

    #[test]
    fn parts_are_the_rail_at_other_parameters(
        points in points(5),
        weights in prop::option::of(prop::array::uniform5(0.2..5.0_f64)),
        x in 0.01..0.99_f64,
        t in 0.0..=1.0_f64,
    ) {
        let rail = match weights {
            Some(weights) => Rail::weighted(BasisShape::Bernstein, &points, &weights).unwrap(),
            None => Rail::bezier(&points).unwrap(),
        };
        let [first, second] = rail.split(x).unwrap();
        for (part, place) in [(first, x * t), (second, x + (1.0 - x) * t)] {
            let off = sub(&part.point(t).unwrap(), &rail.point(place).unwrap());
            prop_assert!(norm(&off) < 1e-12, "{off:?}");
        }
    }
}

#[test]
fn a_point_on_a_rail_is_its_own_nearest_also_at_the_ends() {
    let rail = Rail::gbt(
        0.5,
        -0.25,
        &[[0.0; 3], [1.0, 2.0, 0.0], [3.0, 2.0, 1.0], [4.0, 0.0, 1.0]],
    );
    let rail = rail.unwrap();
    for x in [0.0, 0.1, 0.37, 0.5, 1.0] {
        let nearest = rail.nearest(rail.point(x).unwrap(), 1e-12).unwrap();
        assert!(
            nearest.distance <= 2e-12 && (nearest.x - x).abs() < 1e-11,
            "{nearest:?}"
        );
    }
}

#[test]
fn all_points_of_a_circle_are_as_near_to_its_centre() {
    let arc = Rail::ellipse_arc([1.0, 2.0, 3.0], [3.0, 2.0, 3.0], [1.0, 4.0, 3.0]).unwrap();
    let nearest = arc.nearest([1.0, 2.0, 3.0], 1e-12).unwrap();
    assert!((nearest.distance - 2.0).abs() < 1e-12);
}

#[test]
fn a_nearest_point_is_found_at_a_cusp() {
    let cusp = Rail::bezier(&[
        [1., -1., 0.],
        [-1. / 3., 1., 0.],
        [-1. / 3., -1., 0.],
        [1., 1., 0.],
    ]);
    let nearest = cusp.unwrap().nearest([-1.0, 0.0, 0.0], 1e-10).unwrap();
    // The cusp is at the origin, half-way.
    assert!(
        (nearest.distance - 1.0).abs() < 1e-9 && (nearest.x - 0.5).abs() < 1e-4,
        "{nearest:?}"
    );
}

#[test]
fn the_size_of_a_rail_does_not_matter() {
    let shape = [[0.0, 0.0, 1.0], [1.0, 2.0, 1.0], [2.0, 0.0, 1.0]];
    for power in [-990, -300, 0, 300, 990] {
        let size = 2.0_f64.powi(power);
        let rail = Rail::bezier(&shape.map(|p| p.map(|c| size * c))).unwrap();
        let [low, high] = rail.bounding_box(1e-9 * size).unwrap();
        assert!(
            (high[1] / size - 1.0).abs() <= 1.01e-9 && low[1].abs() <= 1.01e-9 * size,
            "{power}"
        );
        let nearest = rail.nearest([size, 3.0 * size, size], 1e-9 * size).unwrap();
        assert!(
            (nearest.distance / size - 2.0).abs() <= 1.01e-9,
            "{power} {nearest:?}"
        );
    }
}

#[test]
fn a_rail_that_is_a_point_has_a_box_without_size() {
    let rail = Rail::bezier(&[[1.0, 2.0, 3.0]; 3]).unwrap();
    let [low, high] = rail.bounding_box(1e-9).unwrap();
    for (axis, value) in [1.0, 2.0, 3.0].into_iter().enumerate() {
        assert!(low[axis] <= value && value <= high[axis] && high[axis] - low[axis] <= 2e-9);
    }
    assert_eq!(rail.nearest([1.0, 2.0, 3.0], 1e-9).unwrap().distance, 0.0);
    let origin = Rail::bezier(&[[0.0; 3]; 3]).unwrap();
    assert_eq!(origin.bounding_box(1e-9).unwrap(), [[0.0; 3]; 2]);
}

#[test]
fn questions_that_make_no_sense_are_refused() {
    let rail = Rail::bezier(&[[0.0; 3], [1.0, 2.0, 0.0]]).unwrap();
    for accuracy in [0.0, -1.0, f64::NAN] {
        assert!(matches!(
            rail.bounding_box(accuracy),
            Err(GeometryError::OutOfRange { .. })
        ));
        assert!(matches!(
            rail.nearest([0.0; 3], accuracy),
            Err(GeometryError::OutOfRange { .. })
        ));
    }
    let away = rail.nearest([f64::NAN, 0.0, 0.0], 1e-9);
    assert!(matches!(away, Err(GeometryError::NotFinite { .. })));
    for x in [0.0, 1.0, -0.5, f64::NAN] {
        assert!(matches!(
            rail.split(x),
            Err(GeometryError::OutOfRange { .. })
        ));
    }
    let curved = Rail::gbt(0.5, 0.5, &[[0.0; 3], [1.0, 2.0, 0.0], [3.0, 0.0, 0.0]]).unwrap();
    assert!(matches!(
        curved.split(0.5),
        Err(GeometryError::Degenerate { .. })
    ));
}
