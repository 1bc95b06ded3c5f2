//! What holds of any pattern.

use super::closed_forms::{flat_cone, true_error};
use crate::support::{Formula, cone, helix, unroll};
use proptest::prelude::*;
use torse_algebra::{Jet, Scalar};
use torse_geometry::pattern::Unrolling;
use torse_geometry::vector::{norm, sub};
use torse_geometry::{Bernstein, Curve, RuledSurface};

#[test]
fn scaling_and_moving_a_design_scales_the_pattern() {
    let plain = unroll(&helix(1.0, 0.5, 0.8, [0.5, 2.0]), 9, 1e-6).unwrap();
    for scale in [1e-150, 1e-12, 1e12, 1e150] {
        let large = unroll(
            &helix(scale, 0.5 * scale, 0.8, [0.5 * scale, 2.0 * scale]),
            9,
            1e-6 * scale,
        )
        .unwrap();
        for (a, b) in plain.rulings().iter().zip(large.rulings()) {
            for (p, q) in a.ends.iter().zip(&b.ends) {
                assert!(norm(&sub(p, &q.map(|c| c / scale))) < 1e-12, "{scale:e}");
            }
        }
    }
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        -10.0..10.0_f64,
        Just(0.0),
        Just(f64::NAN),
        Just(1e300),
        Just(-1e-300),
        prop::num::f64::ANY
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_patch_is_refused_or_has_a_finite_pattern(
        p in prop::collection::vec(prop::array::uniform3(coordinate()), 2..5),
        q in prop::collection::vec(prop::array::uniform3(coordinate()), 2..5),
    ) {
        let (Ok(p), Ok(q)) = (Curve::new(Bernstein, p), Curve::new(Bernstein, q)) else { return Ok(()) };
        let patch = RuledSurface::new(p, q);
        for demand in [Unrolling::within(1e-3), Unrolling::within(1e-3).allow_strain(0.999)] {
            if let Ok(flat) = demand.rulings(5).unroll(&patch) {
                let e = flat.errors();
                let numbers = [e.outline, e.point, e.angle, e.length, e.area, flat.strain(), flat.area()];
                prop_assert!(numbers.iter().all(|v| v.is_finite() && *v >= 0.0), "{numbers:?}");
                let vertices: Vec<_> = flat.outline().vertices().collect();
                prop_assert!(vertices.iter().all(|(p, b)| p.iter().all(|c| c.is_finite()) && b.is_finite()));
                prop_assert!(flat.outline().area() > 0.0);
                prop_assert!(e.outline <= 1e-3);
            }
        }
    }

    #[test]
    fn cones_of_any_shape_unroll_within_their_errors(
        small in 0.1..2.0_f64, more in 0.1..3.0_f64, height in -3.0..3.0_f64, angle in 0.2..3.0_f64, digits in 2..9_i32,
    ) {
        let (radii, tolerance) = ([small, small + more], 10.0_f64.powi(-digits));
        let flat = unroll(&cone(radii, height, angle), 9, tolerance).unwrap();
        let worst = true_error(&flat, &flat_cone(radii, height, angle));
        prop_assert!(worst <= flat.errors().outline, "{worst:e} {:?}", flat.errors());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_narrow_ridge_is_seen_and_its_length_is_right(
        centre in 0.0..1.0_f64, digits in 1.0..2.5_f64, height in 0.05..0.5_f64,
    ) {
        // A cylinder over the graph of height/(1 + ((x - centre)/width)^2).
        let width = libm::pow(10.0_f64, -digits);
        let ridge = Formula(|x: Jet<f64>| {
            let number = |v: f64| x.constant_like(v);
            let t = (x.clone() - number(centre)) * number(1.0 / width);
            let z = number(height).divided_by(&(number(1.0) + t.clone() * t)).unwrap();
            [[x.clone(), number(0.0), z.clone()], [x.clone(), number(1.0), z]]
        });
        let flat = unroll(&ridge, 5, 1e-5).unwrap();
        let n = 400_000;
        let z = |i: i32| height / (1.0 + ((f64::from(i) / f64::from(n) - centre) / width).powi(2));
        let length: f64 = (0..n).map(|i| libm::hypot(1.0 / f64::from(n), z(i + 1) - z(i))).sum();
        let [first, second] = flat.rail_lengths(0).unwrap();
        prop_assert!((first - length).abs() < 1e-6 && (second - length).abs() < 1e-6, "{first} {length}");
        let errors = flat.errors();
        prop_assert!((flat.outline().length() - 2.0 * (1.0 + length)).abs() < errors.length + 1e-6);
    }
}
