//! Products of sparse polynomials with rational coefficients: what every identity costs.

#![allow(missing_docs, reason = "criterion's macros define items without docs")]

#[path = "generated/mod.rs"]
mod generated;

use criterion::{Criterion, criterion_group, criterion_main};
use generated::Case;
use std::hint::black_box;

fn products(c: &mut Criterion) {
    let mut group = c.benchmark_group("product");
    for (name, case) in Case::ALL {
        let [a, b] = case.factors();
        group.bench_function(name, |bench| bench.iter(|| black_box(&a) * black_box(&b)));
    }
    group.finish();
}

criterion_group!(benches, products);
criterion_main!(benches);
