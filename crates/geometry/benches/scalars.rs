//! The same work exactly, on balls and in doubles: what certainty costs.
//!
//! Each group is one task; its three functions do it with exact numbers, with enclosures of 128 bits and with doubles, by the same
//! generic code and from the same data. `cargo test --workspace --bench scalars` runs each once.

#![allow(clippy::expect_used, reason = "a benchmark on known good data")]
#![allow(missing_docs, reason = "criterion's macros define items without docs")]

use criterion::{Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use torse_geometry::developable::{QuarticData, QuinticData};
use torse_geometry::{
    Bernstein, Continuity, Coordinate, Curve, Fraction, Gbt, HermiteCone, Rational, exact,
    exact_ball, join,
};

const BITS: usize = 128;

/// One task on the three kinds of numbers, each made from doubles.
macro_rules! on_all_scalars {
    ($criterion:expr, $name:literal, $exact:ty, $data:ident, $work:ident) => {{
        let mut group = $criterion.benchmark_group($name);
        let data = $data(|x: f64| <$exact>::from(exact(x)));
        group.bench_function("exact", |b| b.iter(|| $work(black_box(&data))));
        let data = $data(|x: f64| exact_ball(x, BITS));
        group.bench_function("ball", |b| b.iter(|| $work(black_box(&data))));
        let data = $data(|x: f64| x);
        group.bench_function("f64", |b| b.iter(|| $work(black_box(&data))));
        group.finish();
    }};
}

/// A point of a polynomial curve of degree five.
fn polynomial<S: Coordinate>(of: impl Fn(f64) -> S) -> (Curve<Bernstein, S, 3>, S) {
    let points = (0..6).map(|i| [f64::from(i), f64::from(i % 3), f64::from(i * i % 5)]);
    let points = points.map(|point| point.map(&of)).collect();
    let curve = Curve::new(Bernstein, points).expect("six points");
    (curve, of(0.375))
}

fn point<S: Coordinate>((curve, x): &(Curve<Bernstein, S, 3>, S)) -> [S; 3] {
    curve.point(x).expect("a parameter in range")
}

/// A trigonometric curve of degree five, and the shape parameters of its continuation.
type Joint<S> = (Curve<Gbt<S>, S, 1>, Gbt<S>);

fn trigonometric<S: Coordinate>(of: impl Fn(f64) -> S) -> Joint<S> {
    let gbt = |mu, nu| Gbt::new(of(mu), of(nu)).expect("shape parameters in range");
    let points = [0.0, 1.0, 3.0, 2.0, 4.0, 5.0].map(|y| [of(y)]);
    let curve = Curve::new(gbt(0.5, -0.25), points.to_vec()).expect("six points");
    (curve, gbt(0.75, 0.125))
}

/// Its derivatives of orders 0 to 3 at both ends.
fn ends<S: Coordinate>((curve, _): &Joint<S>) -> [Vec<[S; 1]>; 2] {
    [curve.start_jet(3), curve.end_jet(3)].map(|jet| jet.expect("an order that is known"))
}

/// The cubic that continues it with three derivatives.
fn continued<S: Coordinate>((curve, basis): &Joint<S>) -> Curve<Gbt<S>, S, 1> {
    let like = &curve.points()[0][0];
    let c3 = Continuity::parametric(3, like);
    join::next_curve(curve, basis.clone(), &c3, &[]).expect("a joint that is determined")
}

/// The data of the quintic patch of hermite-developable Sect. 3.3.
fn quintic<S: Coordinate>(of: impl Fn(f64) -> S) -> (S, QuinticData<S>) {
    let vector = |v: [f64; 3]| v.map(&of);
    let quartic = QuarticData {
        p_start: vector([40.0, 40.0, 45.0]),
        p_middle: vector([40.0, 12.5, 40.0]),
        q_ends: [vector([-20.0, 60.0, 45.0]), vector([-20.0, -50.0, 45.0])],
        q_tangents: [vector([0.0, -60.0, 90.0]), vector([0.0, -50.0, -30.0])],
    };
    let p_middle_tangent = vector([0.0, -25.0, 35.0]);
    let data = QuinticData {
        quartic,
        p_middle_tangent,
    };
    (of(2.0), data)
}

fn cone<S: Coordinate>((k, data): &(S, QuinticData<S>)) -> HermiteCone<S> {
    HermiteCone::quintic(k.clone(), data.clone()).expect("a system that is regular")
}

fn scalars(c: &mut Criterion) {
    on_all_scalars!(c, "a point of degree five", Rational, polynomial, point);
    on_all_scalars!(
        c,
        "end derivatives of orders 0 to 3",
        Fraction,
        trigonometric,
        ends
    );
    on_all_scalars!(c, "a C3 joint", Fraction, trigonometric, continued);
    on_all_scalars!(c, "a quintic Hermite cone", Rational, quintic, cone);
}

criterion_group!(benches, scalars);
criterion_main!(benches);
