//! Surfaces against finite differences, classical curvatures and each other.

use proptest::prelude::*;
use torse_algebra::rational::{integer, ratio};
use torse_geometry::batch::GridEvaluator;
use torse_geometry::curve::{arc_length, curvature, ellipse_arc, torsion};
use torse_geometry::{
    Bernstein, Curve, Gbt, HalfTurn, Over, RationalCurve, RotationSurface, RuledSurface, Surface,
    TensorSurface, exact_ball,
};

fn wavy() -> TensorSurface<Gbt<f64>, Gbt<f64>, f64> {
    let net = (0..5)
        .map(|i| {
            (0..4)
                .map(|j| {
                    [
                        f64::from(i),
                        f64::from(j),
                        f64::from((i * 7 + j * 13) % 5) * 0.3,
                    ]
                })
                .collect()
        })
        .collect();
    TensorSurface::new(
        Gbt::new(0.4, -0.7).unwrap(),
        Gbt::new(-0.2, 1.0).unwrap(),
        net,
    )
    .unwrap()
}

fn check_partials(surface: &impl Surface<f64>, u: f64, v: f64) {
    let h = 1e-5;
    let at = |u: f64, v: f64| surface.partials(&u, &v, 2).unwrap();
    let here = at(u, v);
    let entry = |p: &torse_geometry::Partials<f64>, i, j, k: usize| p.get(i, j).unwrap()[k];
    for k in 0..3 {
        for (i, j) in [(0, 0), (1, 0), (0, 1)] {
            let by_u = (entry(&at(u + h, v), i, j, k) - entry(&at(u - h, v), i, j, k)) / (2.0 * h);
            let by_v = (entry(&at(u, v + h), i, j, k) - entry(&at(u, v - h), i, j, k)) / (2.0 * h);
            for (difference, i, j) in [(by_u, i + 1, j), (by_v, i, j + 1)] {
                let exact = entry(&here, i, j, k);
                assert!(
                    (difference - exact).abs() < 1e-5 * (1.0 + exact.abs()),
                    "d{i}{j}[{k}]: {difference} {exact}"
                );
            }
        }
    }
}

#[test]
fn partial_derivatives_agree_with_central_differences() {
    check_partials(&wavy(), 0.37, 0.61);
    let profile = Curve::new(
        Gbt::new(0.9, 0.25).unwrap(),
        vec![[4.0, 15.0], [1.0, 10.0], [3.0, 5.0], [4.0, 0.0]],
    );
    let sector = RotationSurface::sector(profile.unwrap(), HalfTurn::Lower, [0.2, 0.9]).unwrap();
    check_partials(&sector, 0.41, 0.77);
    let first = Curve::new(
        Bernstein,
        vec![[0.0, 0.0, 0.0], [1.0, 2.0, 0.5], [3.0, 0.0, 1.0]],
    )
    .unwrap();
    let weights = vec![1.0, 2.0, 0.5];
    let second = RationalCurve::new(
        Bernstein,
        &[[0.0, 1.0, 2.0], [1.0, 3.0, 2.5], [3.0, 1.0, 3.0]],
        weights,
    );
    check_partials(&RuledSurface::new(first, second.unwrap()), 0.3, 0.8);
}

#[test]
fn a_sphere_of_radius_two_has_curvatures_one_quarter_and_one_half_everywhere() {
    let profile = ellipse_arc(&[0.0, 0.0], &[2.0, 0.0], &[0.0, 2.0]).unwrap();
    let sphere = RotationSurface::half_turn(profile, HalfTurn::Upper);
    for (u, v) in [(0.2, 0.3), (0.7, 0.9), (0.5, 0.0)] {
        let forms = sphere.forms(&u, &v).unwrap();
        assert!((forms.gaussian().unwrap() - 0.25).abs() < 1e-13);
        assert!((forms.mean().unwrap().abs() - 0.5).abs() < 1e-13);
        // Every point is an umbilic, and none loses digits for it.
        for principal in forms.principal().unwrap() {
            assert!((principal.curvature.abs() - 0.5).abs() < 1e-13);
        }
    }
}

#[test]
fn principal_curvatures_are_those_of_mean_and_gaussian_and_their_directions_conjugate() {
    let surface = wavy();
    for (u, v) in [(0.1, 0.2), (0.6, 0.3), (0.9, 0.95)] {
        let forms = surface.forms(&u, &v).unwrap();
        let [p, q] = forms.principal().unwrap();
        assert!(p.curvature >= q.curvature);
        let close = |a: f64, b: f64| (a - b).abs() < 1e-12 * (1.0 + b.abs());
        assert!(close(
            0.5 * (p.curvature + q.curvature),
            forms.mean().unwrap()
        ));
        assert!(close(p.curvature * q.curvature, forms.gaussian().unwrap()));
        let form = |[a, b, c]: [f64; 3], x: [f64; 2], y: [f64; 2]| {
            a * x[0] * y[0] + b * (x[0] * y[1] + x[1] * y[0]) + c * x[1] * y[1]
        };
        let area = forms.area_squared.sqrt();
        let (first, second) = (forms.first, forms.second.map(|x| x / area));
        // Unit vectors, perpendicular, conjugate, with their own normal curvature each.
        for r in [p, q] {
            assert!(close(form(first, r.direction, r.direction), 1.0));
            assert!(close(form(second, r.direction, r.direction), r.curvature));
        }
        assert!(close(form(first, p.direction, q.direction), 0.0));
        assert!(close(form(second, p.direction, q.direction), 0.0));
    }
}

#[test]
fn the_gaussian_curvature_of_a_hyperbolic_paraboloid_is_exact_on_rationals() {
    // z = x y: K = -1/(1 + x^2 + y^2)^2.
    let q = |x: i64, y: i64| [integer(x), integer(y), integer(x * y)];
    let net = vec![vec![q(0, 0), q(0, 1)], vec![q(1, 0), q(1, 1)]];
    let surface = TensorSurface::new(Bernstein, Bernstein, net).unwrap();
    let (x, y) = (ratio(1, 3).unwrap(), ratio(3, 4).unwrap());
    let root = integer(1) + &x * &x + &y * &y;
    assert_eq!(
        surface.gaussian_curvature(&x, &y).unwrap(),
        -integer(1) / (&root * &root)
    );
}

#[test]
fn the_two_halves_of_a_rotation_surface_meet_along_both_seams() {
    let profile = Curve::new(
        Gbt::new(0.1, 0.2).unwrap(),
        vec![[4.0, 9.0], [1.0, 6.0], [2.0, 0.0]],
    )
    .unwrap();
    let upper = RotationSurface::half_turn(profile.clone(), HalfTurn::Upper);
    let lower = RotationSurface::half_turn(profile, HalfTurn::Lower);
    for v in [0.0, 1.0] {
        let (a, b) = (
            upper.point(&0.4, &v).unwrap(),
            lower.point(&0.4, &v).unwrap(),
        );
        assert!(a[0] == b[0] && (a[1] - b[1]).abs() < 1e-15 && a[2] == b[2]);
    }
}

#[test]
fn sectors_over_balls_contain_their_points() {
    let points = vec![[4.0, 9.0], [1.0, 6.0], [2.0, 0.0]];
    let profile = Curve::new(Gbt::new(0.1, 0.2).unwrap(), points).unwrap();
    let ball = |x: &f64| exact_ball(*x, 100);
    let mut sectors = RotationSurface::turned(&profile, 4.0).unwrap();
    sectors.push(RotationSurface::half_turn(profile, HalfTurn::Lower));
    for sector in sectors {
        let point = sector.point(&0.3, &0.8).unwrap();
        let over = sector.over(&ball).unwrap();
        let enclosed = over.point(&ball(&0.3), &ball(&0.8)).unwrap();
        for (value, enclosure) in point.iter().zip(enclosed) {
            let (low, high) = enclosure.to_f64_bounds();
            assert!(high - low < 1e-14 && (value - low).abs() < 1e-14);
        }
    }
}

#[test]
fn any_angle_of_rotation_ends_at_that_angle() {
    let profile = Curve::new(
        Gbt::new(0.0, 0.0).unwrap(),
        vec![[3.0, 0.0], [3.0, 1.0], [3.0, 2.0]],
    )
    .unwrap();
    for degrees in [
        1.0_f64, 30.0, 60.0, 90.0, 179.0, 180.0, 181.0, 240.0, 300.0, 359.0, 360.0,
    ] {
        let angle = degrees.to_radians();
        let sectors = RotationSurface::turned(&profile, angle).unwrap();
        let start = sectors[0].point(&0.5, &0.0).unwrap();
        let end = sectors.last().unwrap().point(&0.5, &1.0).unwrap();
        assert!((start[0] - 3.0).abs() < 1e-15);
        assert!((end[0] - 3.0 * libm::cos(angle)).abs() < 1e-14, "{degrees}");
        assert!((end[1] - 3.0 * libm::sin(angle)).abs() < 1e-14, "{degrees}");
        if let [first, second] = sectors.as_slice() {
            let (a, b) = (
                first.point(&0.5, &1.0).unwrap(),
                second.point(&0.5, &0.0).unwrap(),
            );
            assert!((0..3).all(|k| (a[k] - b[k]).abs() < 1e-14));
        }
    }
}

#[test]
fn arc_length_curvature_and_torsion_agree_with_reparametrized_pieces() {
    // Degree-independent quantities of the same cubic, as GBT curve reversed.
    let points = vec![
        [0.0, 0.0, 0.0],
        [1.0, 2.0, 0.5],
        [3.0, 2.0, 2.0],
        [4.0, 0.0, 1.0],
    ];
    let curve = Curve::new(Gbt::new(0.6, -0.4).unwrap(), points).unwrap();
    let back = curve.reversed();
    for x in [0.0, 0.25, 0.8] {
        let (a, b) = (
            curvature(&curve, x).unwrap(),
            curvature(&back, 1.0 - x).unwrap(),
        );
        assert!((a - b).abs() < 1e-12 * a);
        let (a, b) = (
            torsion(&curve, x).unwrap(),
            torsion(&back, 1.0 - x).unwrap(),
        );
        assert!((a - b).abs() < 1e-11 * a.abs());
    }
    let whole = arc_length(&curve, [0.0, 1.0], 1e-11).unwrap();
    let parts = arc_length(&back, [0.0, 0.3], 1e-11).unwrap()
        + arc_length(&back, [0.3, 1.0], 1e-11).unwrap();
    assert!((whole - parts).abs() < 1e-10);
    // A fine polygon is shorter, by a little.
    let n = 2000;
    let point = |i: i32| curve.point(&(f64::from(i) / f64::from(n))).unwrap();
    let chord = |i: i32| {
        torse_geometry::vector::norm(&torse_geometry::vector::sub(&point(i + 1), &point(i)))
    };
    let polygon: f64 = (0..n).map(chord).sum();
    assert!(polygon < whole && whole - polygon < 1e-5);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn grids_equal_single_points_for_all_degrees(m in 2..12_usize, n in 2..12_usize, seed in 0..1000_u32) {
        let value = |i: usize, j: usize, k: usize| {
            f64::from((seed + u32::try_from(i * 31 + j * 17 + k * 7).unwrap()) % 23) - 11.0
        };
        let net = (0..m).map(|i| (0..n).map(|j| [0, 1, 2].map(|k| value(i, j, k))).collect()).collect();
        let surface = TensorSurface::new(Gbt::new(0.3, -0.3).unwrap(), Bernstein, net).unwrap();
        let us = [0.0, 0.2, 0.9, 1.0];
        let vs = [0.0, 0.5, 1.0];
        let grid = GridEvaluator::new(&surface, &us, &vs).unwrap();
        let mut out = vec![[0.0; 3]; grid.len()];
        grid.fill(&mut out).unwrap();
        for (i, u) in us.iter().enumerate() {
            for (j, v) in vs.iter().enumerate() {
                let one = surface.point(u, v).unwrap();
                for k in 0..3 {
                    prop_assert!((one[k] - out[i * vs.len() + j][k]).abs() < 1e-13);
                }
            }
        }
    }
}

#[test]
fn threads_change_no_bit_of_a_grid() {
    let surface = wavy();
    let xs: Vec<f64> = (0..300).map(|i| f64::from(i) / 299.0).collect();
    let grid = GridEvaluator::new(&surface, &xs, &xs).unwrap();
    let (mut one, mut many) = (vec![[0.0; 3]; grid.len()], vec![[1.0; 3]; grid.len()]);
    grid.fill(&mut one).unwrap();
    grid.par_fill(&mut many).unwrap();
    assert_eq!(one, many);
    let mut rows = Vec::new();
    grid.rows(|_, row| rows.extend_from_slice(row));
    assert_eq!(one, rows);
}
