//! Evaluation speed: surfaces on grids, curves at many parameters, rulings, developable grids.
//!
//! `limit/stores` is the time that plain stores of 24 bytes a point take: the floor of every grid.

#![allow(clippy::expect_used, reason = "a benchmark on known good data")]
#![allow(missing_docs, reason = "criterion's macros define items without docs")]

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use std::hint::black_box;
use torse_geometry::batch::{GridEvaluator, ruled_grid_into};
use torse_geometry::{
    Basis, Bernstein, Curve, EnvelopingPatch, Gbt, PatchBounds, PlaneFamily, Ruling, TensorSurface,
};

const SIDE: usize = 1000;

fn parameters(count: usize) -> Vec<f64> {
    (0..count).map(|i| i as f64 / (count - 1) as f64).collect()
}

fn surface<B: Basis<f64>>(basis: &B, degree: usize) -> TensorSurface<B, B, f64> {
    let height = |i: usize, j: usize| ((i * 7 + j * 13) % 5) as f64 * 0.3;
    let net = (0..=degree)
        .map(|i| {
            (0..=degree)
                .map(|j| [i as f64, j as f64, height(i, j)])
                .collect()
        })
        .collect();
    TensorSurface::new(basis.clone(), basis.clone(), net).expect("a square net")
}

fn grids(c: &mut Criterion) {
    let mut group = c.benchmark_group("grid 1000 x 1000");
    group
        .throughput(Throughput::Elements((SIDE * SIDE) as u64))
        .sample_size(30);
    let xs = parameters(SIDE);
    let mut out = vec![[0.0; 3]; SIDE * SIDE];
    group.bench_function("limit/stores", |b| {
        b.iter(|| out.fill(black_box([1.5, 2.5, 3.5])));
    });
    let gbt = Gbt::new(0.5, -0.25).expect("shape parameters in range");
    for degree in [3, 4, 5] {
        let trigonometric = surface(&gbt, degree);
        group.bench_function(BenchmarkId::new("gbt", degree), |b| {
            b.iter(|| {
                let grid =
                    GridEvaluator::new(black_box(&trigonometric), &xs, &xs).expect("bases of f64");
                grid.fill(&mut out).expect("a buffer of the right size");
            });
        });
        let polynomial = surface(&Bernstein, degree);
        group.bench_function(BenchmarkId::new("bernstein", degree), |b| {
            b.iter(|| {
                let grid =
                    GridEvaluator::new(black_box(&polynomial), &xs, &xs).expect("bases of f64");
                grid.fill(&mut out).expect("a buffer of the right size");
            });
        });
    }
    let bicubic = GridEvaluator::new(&surface(&gbt, 3), &xs, &xs).expect("bases of f64");
    group.bench_function("gbt, all threads/3", |b| {
        b.iter(|| {
            bicubic
                .par_fill(&mut out)
                .expect("a buffer of the right size")
        });
    });
    let mut highest = 0.0_f64;
    group.bench_function("gbt, rows in cache/3", |b| {
        b.iter(|| bicubic.rows(|_, row| highest = highest.max(row[0][2])));
    });
    let patch = EnvelopingPatch::new(family(), PatchBounds::Range([-1.0, 1.0])).expect("a range");
    group.bench_function("developable/3", |b| {
        b.iter(|| ruled_grid_into(black_box(&patch), &xs, &xs, &mut out).expect("rulings"));
    });
    group.finish();
}

fn family() -> PlaneFamily<Gbt<f64>, f64> {
    let planes = vec![
        [1., 0., 0.2, 3.],
        [0.5, 1., 0.1, 2.],
        [0., 1., 0.5, 4.],
        [-1., 0.3, 0.1, 5.],
    ];
    let basis = Gbt::new(0.5, 0.5).expect("shape parameters in range");
    PlaneFamily::new(basis, planes).expect("planes in general position")
}

fn curves(c: &mut Criterion) {
    const COUNT: usize = 1_000_000;
    let mut group = c.benchmark_group("10^6 parameters");
    group
        .throughput(Throughput::Elements(COUNT as u64))
        .sample_size(20);
    let xs = parameters(COUNT);
    let mut out = vec![[0.0; 3]; COUNT];
    let points = |n: usize| {
        (0..n)
            .map(|i| [i as f64, ((i * 7) % 5) as f64, ((i * 3) % 4) as f64])
            .collect()
    };
    for degree in [3, 4, 8, 16] {
        let gbt = Gbt::new(0.5, -0.25).expect("shape parameters in range");
        let curve = Curve::new(gbt, points(degree + 1)).expect("control points");
        group.bench_function(BenchmarkId::new("gbt curve", degree), |b| {
            b.iter(|| {
                black_box(&curve)
                    .points_into(&xs, &mut out)
                    .expect("a buffer of the right size")
            });
        });
        let curve = Curve::new(Bernstein, points(degree + 1)).expect("control points");
        group.bench_function(BenchmarkId::new("bernstein curve", degree), |b| {
            b.iter(|| {
                black_box(&curve)
                    .points_into(&xs, &mut out)
                    .expect("a buffer of the right size")
            });
        });
    }
    let mut planes = vec![[0.0; 4]; COUNT];
    let family = family();
    group.bench_function("planes/3", |b| {
        b.iter(|| {
            black_box(&family)
                .curve()
                .points_into(&xs, &mut planes)
                .expect("a buffer of the right size")
        });
    });
    let empty = Ruling {
        direction: [0.0; 3],
        moment: [0.0; 3],
        foot: [0.0; 3],
    };
    let mut rulings = vec![empty; COUNT];
    group.bench_function("rulings/3", |b| {
        b.iter(|| {
            black_box(&family)
                .rulings_into(&xs, &mut rulings)
                .expect("rulings")
        });
    });
    group.finish();
}

criterion_group!(benches, grids, curves);
criterion_main!(benches);
