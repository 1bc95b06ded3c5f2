//! Errors of f64 evaluators in units in the last place, against certified enclosures.

use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};
use std::cell::Cell;
use torse_algebra::rational::to_f64;
use torse_algebra::{Ball, Rational};
use torse_geometry::{exact, exact_ball};

pub const BITS: usize = 256;

pub fn ball(x: &f64) -> Ball {
    exact_ball(*x, BITS)
}

/// The distance of `value` from the farther end of the enclosure, in units of `ulp(scale)`.
pub fn ulps(value: f64, enclosure: &Ball, scale: f64) -> f64 {
    let reach = |end: &Rational| to_f64(&(exact(value) - end.clone())).abs();
    let farthest = reach(&enclosure.lower()).max(reach(&enclosure.upper()));
    let ulp = f64::EPSILON * libm::pow(2_f64, libm::log2(scale).floor());
    farthest / ulp
}

/// Runs `worst` on random cases and asserts that no error exceeds `bound` ulps; prints the worst seen.
pub fn agrees<T: std::fmt::Debug>(
    name: &str,
    bound: f64,
    cases: u32,
    input: impl Strategy<Value = T>,
    worst: impl Fn(T) -> f64,
) {
    let seen = Cell::new(0.0_f64);
    let config = Config {
        cases,
        failure_persistence: None,
        ..Config::default()
    };
    let mut runner = TestRunner::new_with_rng(
        config,
        proptest::test_runner::TestRng::deterministic_rng(
            proptest::test_runner::RngAlgorithm::ChaCha,
        ),
    );
    let result = runner.run(&input, |case| {
        let error = worst(case);
        seen.set(seen.get().max(error));
        prop_assert!(error <= bound, "{name}: {error} ulps");
        Ok(())
    });
    println!("{name}: worst {:.1} ulp, bound {bound}", seen.get());
    result.unwrap();
    assert!(
        seen.get() > 0.0,
        "{name}: an evaluator without any rounding measures nothing"
    );
}

pub fn shape() -> impl Strategy<Value = f64> {
    prop_oneof![-1.0..=1.0, Just(1.0), Just(-1.0), Just(0.0)]
}

pub fn unit() -> impl Strategy<Value = f64> {
    prop_oneof![0.0..=1.0_f64, Just(0.0), Just(1.0), Just(1e-9)]
}

/// The largest error of a point, in units of `ulp(scale)`.
pub fn farthest<const D: usize>(point: &[f64; D], enclosure: &[Ball; D], scale: f64) -> f64 {
    let pairs = point.iter().zip(enclosure);
    pairs.map(|(v, b)| ulps(*v, b, scale)).fold(0.0, f64::max)
}

pub fn points<const D: usize>(
    count: impl Strategy<Value = usize>,
) -> impl Strategy<Value = Vec<[f64; D]>> {
    count.prop_flat_map(|n| prop::collection::vec(prop::array::uniform(-10.0..10.0_f64), n))
}
