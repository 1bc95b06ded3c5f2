//! The polynomials of the benchmarks, from fixed streams of random numbers, so that another library can be
//! timed on the same ones.

#![allow(clippy::expect_used, reason = "known good data")]
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "the streams are defined by these casts"
)]

use std::collections::BTreeMap;
use torse_algebra::rational::{integer, ratio};
use torse_algebra::{Polynomial, Rational};

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

/// The seeds of the two factors of each product.
const SEEDS: [u64; 2] = [12_345, 987_654_321];

/// A product of two polynomials of fixed terms.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Case {
    /// Six variables, exponents 0 to 3, coefficients `n / d` with `|n| < 2^20` and d a product of powers of
    /// 2 and 3; so many terms a factor (fewer where exponents repeat).
    SixVariables(usize),
    /// 500 terms in four variables, exponents 0 to 8, odd numerators of 63 bits, denominators
    /// `2^k 3^j 5^l` with `k <= 10`, `j <= 4`, `l <= 1`, as in Bernstein work.
    Smooth,
    /// The same with random odd denominators of 31 bits: the common one has thousands of digits.
    Rough,
    /// The same terms with exponents of 14 bits in four variables: no two products share a row.
    Scattered,
    /// The same in eight variables, so that a row needs more than 64 bits.
    ScatteredWide,
}

impl Case {
    /// All cases by name.
    pub const ALL: [(&str, Case); 10] = [
        ("six_1", Case::SixVariables(1)),
        ("six_3", Case::SixVariables(3)),
        ("six_10", Case::SixVariables(10)),
        ("six_30", Case::SixVariables(30)),
        ("six_264", Case::SixVariables(264)),
        ("six_1000", Case::SixVariables(1000)),
        ("poly_s", Case::Smooth),
        ("poly_r", Case::Rough),
        ("scattered", Case::Scattered),
        ("scattered_wide", Case::ScatteredWide),
    ];

    /// The two factors.
    pub fn factors(self) -> [Polynomial; 2] {
        SEEDS.map(|seed| match self {
            Case::SixVariables(count) => six_variables(seed, count),
            Case::Smooth => four_variables(seed, false),
            Case::Rough => four_variables(seed, true),
            Case::Scattered => scattered(seed, 4),
            Case::ScatteredWide => scattered(seed, 8),
        })
    }
}

fn monomial(exponents: &[u32], names: &[&str], coefficient: &Rational) -> Polynomial {
    let powers = names.iter().zip(exponents);
    powers.fold(Polynomial::constant(coefficient), |term, (name, e)| {
        &term * &Polynomial::named(name).power(*e)
    })
}

fn six_variables(seed: u64, count: usize) -> Polynomial {
    let mut stream = Stream(seed);
    let terms = (0..count).map(|_| {
        let exponents = [(); 6].map(|()| (stream.next() >> 20) as u32 % 4);
        let numerator = (stream.next() >> 43) as i64 - (1 << 20);
        let two = (stream.next() >> 9) % 6;
        let three = (stream.next() >> 9) % 4;
        let denominator = 2_i64.pow(two as u32) * 3_i64.pow(three as u32);
        let coefficient = ratio(numerator | 1, denominator).expect("a positive denominator");
        monomial(&exponents, &["a", "b", "c", "d", "e", "f"], &coefficient)
    });
    sum(terms.collect())
}

/// A term in four variables: exponents, numerator, denominator.
type Row = ([u32; 4], i64, i64);

/// The digests of the rows by seed and denominators, which `tests/peers/products.py` asserts too.
const DIGESTS: [(u64, bool, u64); 4] = [
    (SEEDS[0], false, 0xe9f7_a4e9_a441_a924),
    (SEEDS[1], false, 0x366c_923b_af87_d623),
    (SEEDS[0], true, 0xe464_f2bc_572b_f341),
    (SEEDS[1], true, 0x36fe_4c0b_f080_28ad),
];

/// The 500 terms of a smooth or rough factor, ascending by exponents.
fn rows(seed: u64, rough: bool) -> Vec<Row> {
    let mut stream = Stream(seed);
    let mut rows = BTreeMap::new();
    while rows.len() < 500 {
        let exponents = [(); 4].map(|()| ((stream.next() >> 20) % 9) as u32);
        let numerator = (stream.next() >> 1) as i64 - (1 << 62);
        let denominator = if rough {
            (stream.next() >> 33) as i64 | 1
        } else {
            let two = (stream.next() >> 9) % 11;
            let three = (stream.next() >> 9) % 5;
            let five = (stream.next() >> 9) % 2;
            2_i64.pow(two as u32) * 3_i64.pow(three as u32) * 5_i64.pow(five as u32)
        };
        rows.insert(exponents, (numerator | 1, denominator));
    }
    let terms = rows.into_iter();
    terms.map(|(e, (n, d))| (e, n, d)).collect()
}

/// The 64-bit FNV-1a digest of the rows, each written as a line of six numbers.
fn digest(rows: &[Row]) -> u64 {
    let lines = rows.iter().map(|(e, n, d)| {
        let [x, y, z, w] = e;
        format!("{x} {y} {z} {w} {n} {d}\n")
    });
    lines
        .flat_map(String::into_bytes)
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        })
}

fn four_variables(seed: u64, rough: bool) -> Polynomial {
    let rows = rows(seed, rough);
    assert!(
        DIGESTS.contains(&(seed, rough, digest(&rows))),
        "not the rows that others are timed on"
    );
    let terms = rows.iter().map(|(exponents, n, d)| {
        let coefficient = ratio(*n, *d).expect("a positive denominator");
        monomial(exponents, &["x", "y", "z", "w"], &coefficient)
    });
    sum(terms.collect())
}

fn scattered(seed: u64, variables: usize) -> Polynomial {
    let names = ["p", "q", "r", "s", "t", "u", "v", "w"];
    let mut stream = Stream(seed);
    let terms = (0..500).map(|_| {
        let exponents: Vec<u32> = (0..variables)
            .map(|_| (stream.next() >> 20) as u32 % (1 << 14))
            .collect();
        let numerator = (stream.next() >> 43) as i64 - (1 << 20);
        monomial(&exponents, &names, &integer(numerator | 1))
    });
    sum(terms.collect())
}
