//! Enclosed certificates: they hold the known values, and everything that samples find.

use crate::support::{osculating_planes, rail, saddle};
use proptest::prelude::*;
use torse_algebra::{Ball, rational::ratio};
use torse_geometry::developable::{Enclosed, certify, enclose};
use torse_geometry::{
    Basis, Bernstein, Curve, EnvelopingPatch, Gbt, Over, PatchBounds, PlaneFamily, Rails,
    RuledSurface, Surface, TangentPatch, exact_ball,
};

const BITS: usize = 128;

fn ball(x: &f64) -> Ball {
    exact_ball(*x, BITS)
}

/// A minimum as the maximum of the opposite.
fn negated(Enclosed { low, high, x }: Enclosed) -> Enclosed {
    Enclosed {
        low: -high,
        high: -low,
        x,
    }
}

fn holds(enclosed: Enclosed, value: f64, accuracy: f64) -> bool {
    let slack = 1e-12 * value.abs();
    enclosed.low <= value + slack
        && value - slack <= enclosed.high
        && enclosed.high - enclosed.low <= accuracy * value.abs()
}

#[test]
fn a_saddle_has_the_known_twist_determinant_and_curvature() {
    // z = x y: at x = 0 the tangent plane turns by 45 degrees, det = 1/sqrt 2, and K = -1 in the corner.
    let saddle = saddle();
    let proved = enclose(&saddle.over(&ball).unwrap(), BITS, 1e-2, 64);
    assert!(
        holds(proved.twist, std::f64::consts::FRAC_PI_4, 1e-2),
        "{proved:?}"
    );
    assert!(
        holds(proved.determinant, 0.5_f64.sqrt(), 1e-2),
        "{proved:?}"
    );
    assert!(holds(proved.gaussian, 1.0, 2e-2), "{proved:?}");
    for worst in [proved.twist, proved.determinant, proved.gaussian] {
        assert!(worst.x < 0.1, "{proved:?}");
    }
}

#[test]
fn the_clearance_of_a_tangent_surface_is_its_distance_from_the_spine_curve() {
    // Half a tangent from the edge, and |S'| is least at x = 0, where it is one.
    let beside = TangentPatch::new(osculating_planes(), [0.5, 1.0]).unwrap();
    let proved = enclose(&beside.over(&ball).unwrap(), BITS, 1e-2, 64);
    assert!(holds(proved.clearance, 0.5, 1e-2), "{proved:?}");
    assert_eq!(proved.is_regular(), Some(true));
    assert_eq!(
        (
            proved.twist.high,
            proved.determinant.high,
            proved.gaussian.high
        ),
        (0.0, 0.0, 0.0)
    );
    let across = TangentPatch::new(osculating_planes(), [-1.0, 3.0]).unwrap();
    let proved = enclose(&across.over(&ball).unwrap(), BITS, 1e-2, 16);
    assert_eq!(proved.is_regular(), Some(false));
}

#[test]
fn a_cylinder_clears_every_bound_and_a_cone_across_its_apex_none() {
    let lifted = |z: f64| {
        let points = vec![[0.0, 0.0, z], [1.0, 2.0, z], [3.0, 2.0, z], [4.0, 0.0, z]];
        Curve::new(Gbt::new(0.5, -0.25).unwrap(), points).unwrap()
    };
    let cylinder = RuledSurface::new(lifted(0.0), lifted(2.0));
    let proved = enclose(&cylinder.over(&ball).unwrap(), BITS, 1e-2, 24);
    // Parallel up to the enclosure: not known to be exactly so, hence no clearance, but next to no twist.
    assert!(
        proved.twist.high < 1e-6 && proved.gaussian.high < 1e-12,
        "{proved:?}"
    );
    let planes = vec![
        [0., -20., 10., 400.],
        [0., -10., 20., 400.],
        [0., 10., 20., 400.],
        [0., 20., 10., 400.],
    ];
    let family = PlaneFamily::new(Gbt::new(0.3, 0.3).unwrap(), planes).unwrap();
    let sheet = EnvelopingPatch::new(family, PatchBounds::Range([-1.0, 1.0])).unwrap();
    // The direction a x a' grows along x, so the ends of the rulings run apart, but the rulings never meet.
    let proved = enclose(&sheet.over(&ball).unwrap(), BITS, 1e-2, 24);
    assert_eq!(proved.is_regular(), Some(true), "{proved:?}");
    let cone = RuledSurface::new(
        rail(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
        rail(&[[-1.0, 0.0, 2.0], [0.0, -1.0, 2.0]]),
    );
    let proved = enclose(&cone.over(&ball).unwrap(), BITS, 1e-2, 16);
    assert_eq!(proved.is_regular(), Some(false));
}

#[test]
fn the_bounds_close_as_the_budget_grows() {
    let rail = |z: f64, lift: f64| {
        let points = vec![
            [0.0, 0.0, z],
            [1.0, 2.0, z + lift],
            [3.0, 2.0, z],
            [4.0, 0.0, z],
        ];
        Curve::new(Gbt::new(0.5, lift).unwrap(), points).unwrap()
    };
    let patch = RuledSurface::new(rail(0.0, 0.25), rail(3.0, -0.5))
        .over(&ball)
        .unwrap();
    let gap = |cells: usize| {
        let twist = enclose(&patch, BITS, 0.0, cells).twist;
        twist.high - twist.low
    };
    let (coarse, fine) = (gap(8), gap(64));
    assert!(fine < 0.1 * coarse, "{coarse} {fine}");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 12, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_sample_lies_outside_the_enclosure(
        first in prop::collection::vec(prop::array::uniform3(-2.0..2.0_f64), 4),
        second in prop::collection::vec(prop::array::uniform3(-2.0..2.0_f64), 3),
        mu in -1.0..1.0_f64,
        nu in -1.0..1.0_f64,
    ) {
        let lifted = second.into_iter().map(|[x, y, z]| [x, y, z + 5.0]).collect();
        let patch = RuledSurface::new(
            Curve::new(Gbt::new(mu, nu).unwrap(), first).unwrap(),
            Curve::new(Bernstein, lifted).unwrap(),
        );
        let proved = enclose(&patch.over(&ball).unwrap(), BITS, 1e-2, 24);
        let sampled = certify(&patch, 32).unwrap();
        for (enclosed, value) in [
            (proved.determinant, sampled.determinant.value),
            (proved.twist, sampled.twist.value),
            (proved.gaussian, sampled.gaussian.map_or(f64::INFINITY, |worst| worst.value)),
            (negated(proved.normal), -sampled.normal.value),
        ] {
            prop_assert!(enclosed.low <= enclosed.high);
            prop_assert!(value <= enclosed.high * (1.0 + 1e-9), "{value} {enclosed:?}");
        }
        let clearance = sampled.clearance.map_or(f64::INFINITY, |worst| worst.value);
        prop_assert!(clearance >= proved.clearance.low - 1e-9, "{sampled:?} {proved:?}");
        if let Some(regular) = proved.is_regular() {
            prop_assert_eq!(regular, sampled.is_regular(), "{:?} {:?}", sampled, proved);
        }
        // The curvature anywhere on the patch, by the fundamental forms.
        for v in [0.0, 0.3, 0.8, 1.0] {
            let value = patch.gaussian_curvature(&0.37, &v).unwrap().abs();
            prop_assert!(value <= proved.gaussian.high * (1.0 + 1e-9));
            prop_assert!(sampled.gaussian.is_none_or(|worst| value <= worst.value * (1.0 + 1e-6)));
        }
        prop_assert!(!patch.is_developable_by_construction());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn series_over_an_interval_hold_the_series_at_its_points(
        points in prop::collection::vec(prop::array::uniform2(-2.0..2.0_f64), 3..9),
        mu in -1.0..1.0_f64,
        nu in -1.0..1.0_f64,
        from in 0..8_i64,
        inside in 0..=16_i64,
    ) {
        let curve = Curve::new(Gbt::new(mu, nu).unwrap(), points).unwrap().over(&ball).unwrap();
        let part = |n: i64| ratio(n, 128).unwrap();
        let over = curve.jet(&Ball::from_bounds(&part(16 * from), &part(16 * from + 16), BITS), 4).unwrap();
        let x = Ball::from_rational(&part(16 * from + inside), BITS);
        let direct = curve.basis().series_rows(curve.degree(), &x, 4).unwrap();
        for (axis, series) in over.iter().enumerate() {
            for (coefficient, row) in series.coefficients().iter().zip(&direct) {
                let terms = row.iter().zip(curve.points()).map(|(w, p)| w.clone() * p[axis].clone());
                let value = terms.reduce(|a, b| a + b).unwrap();
                // The exact value lies in both.
                prop_assert!(coefficient.overlaps(&value));
            }
        }
    }
}

#[test]
fn the_second_coefficient_of_the_fifth_power_is_enclosed_up_to_its_end() {
    let points = [0.0, 0.0, 0.0, 0.0, 0.0, 1.0].map(|x| [ball(&x)]).to_vec();
    let power = Curve::new(Bernstein, points).unwrap();
    let interval = Ball::from_bounds(&ratio(0, 1).unwrap(), &ratio(1, 8).unwrap(), BITS);
    let [series] = power.jet(&interval, 2).unwrap();
    // 10 x^3 at x = 1/8.
    assert!(series.coefficients()[2].contains(&ratio(10, 512).unwrap()));
}
