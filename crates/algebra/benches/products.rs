//! Products of sparse polynomials with rational coefficients: what every identity costs.
//!
//! Six variables, exponents 0 to 3, coefficients `n / d` with `|n| < 2^20` and d a product of powers of 2
//! and 3, from a fixed xorshift stream, so that another library can be timed on the same polynomials.

#![allow(missing_docs, reason = "criterion's macros define items without docs")]
#![allow(clippy::expect_used, reason = "a benchmark on known good data")]

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use std::hint::black_box;
use torse_algebra::{Polynomial, rational::ratio};

/// The xorshift generator of Marsaglia with shifts 13, 7, 17.
struct Stream(u64);

impl Stream {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }
}

/// A polynomial of `count` random terms (fewer where exponents repeat).
fn polynomial(seed: u64, count: usize) -> Polynomial {
    let variables = ["a", "b", "c", "d", "e", "f"].map(Polynomial::named);
    let mut stream = Stream(seed);
    let terms: Vec<Polynomial> = (0..count)
        .map(|_| {
            let mut term = Polynomial::integer(1);
            for variable in &variables {
                for _ in 0..(stream.next() >> 20) % 4 {
                    term = &term * variable;
                }
            }
            let numerator = (stream.next() >> 43) as i64 - (1 << 20);
            let two = (stream.next() >> 9) % 6;
            let three = (stream.next() >> 9) % 4;
            let denominator = 2_i64.pow(two as u32) * 3_i64.pow(three as u32);
            let coefficient = ratio(numerator | 1, denominator).expect("a positive denominator");
            &term * &Polynomial::constant(&coefficient)
        })
        .collect();
    sum(terms)
}

/// The sum by halves, so that building costs no more than sorting.
fn sum(mut terms: Vec<Polynomial>) -> Polynomial {
    while terms.len() > 1 {
        terms = terms
            .chunks(2)
            .map(|pair| {
                pair.iter()
                    .fold(Polynomial::zero(), |sum, term| &sum + term)
            })
            .collect();
    }
    terms.pop().unwrap_or_else(Polynomial::zero)
}

fn products(c: &mut Criterion) {
    let mut group = c.benchmark_group("product in six variables");
    for count in [264, 1000] {
        let (a, b) = (polynomial(12_345, count), polynomial(987_654_321, count));
        group.bench_function(BenchmarkId::new("terms", count), |bench| {
            bench.iter(|| black_box(&a) * black_box(&b));
        });
    }
    group.finish();
}

criterion_group!(benches, products);
criterion_main!(benches);
