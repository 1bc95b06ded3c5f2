//! Rust: types, conversions, attributes, and what a file adds to the standard library.

use super::are;
use torse_code::CodeVerdict::Equal;

#[test]
fn the_types_of_integers_of_rust_are_not_lost() {
    are(
        "f.rs",
        &[
            (
                "fn f(n: i64, m: i64) -> i64 { n.max(m) / 2 }\n",
                "max(n, m)/2",
                None,
            ),
            ("fn f(n: i64) -> i64 { n.abs() / 2 }\n", "abs(n)/2", None),
            ("fn f(n: i64) -> i64 { n.pow(2) / 2 }\n", "n^2/2", None),
            (
                "type Int = Whole;\ntype Whole = i64;\nfn f(a: Int, b: Int) -> Int { a / b }\n",
                "a/b",
                None,
            ),
            (
                "fn f(W: [i64; 2]) -> i64 { W[0] / W[1] }\n",
                "W[0]/W[1]",
                None,
            ),
            (
                "fn f(W: &[usize]) -> usize { W[0] / W[1] }\n",
                "W[0]/W[1]",
                None,
            ),
            (
                "fn f(n: usize) -> usize { (0..n).map(|i| i).sum::<usize>() / 2 }\n",
                "n*(n - 1)/4",
                None,
            ),
            ("fn f<T>(a: T, b: T) -> T { a / b }\n", "a/b", None),
            (
                "fn f(n: i32) -> f64 { (g(n) / 2) as f64 }\nfn g(n: i32) -> i32 { n.max(n) }\n",
                "n/2",
                None,
            ),
            (
                "fn f(n: i32) -> f64 { let n: i64 = n.into(); (n / 2) as f64 }\n",
                "n/2",
                None,
            ),
            (
                "fn f(n: i64, m: i64) -> f64 { n.max(m) as f64 / 2.0 }\n",
                "max(n, m)/2",
                Some(Equal),
            ),
            (
                "type Real = f64;\nfn f(a: Real, W: &[Real; 4]) -> Real { (a + W[0]) / 2.0 * (4 / 2) as f64 }\n",
                "a + W[0]",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn what_an_attribute_of_rust_may_leave_out_is_not_read() {
    are(
        "f.rs",
        &[
            (
                "fn f(x: f64) -> f64 { let y = x; #[cfg(any())] let y = 3.0; y + 0.0 }\n",
                "x",
                None,
            ),
            (
                "#[cfg(not(any()))]\nfn f(x: f64) -> f64 { x }\n#[cfg(any())]\nfn f(x: f64) -> f64 { 2.0 * x }\n",
                "x",
                None,
            ),
            (
                "fn f(x: f64) -> f64 { x }\nfn f(x: f64) -> f64 { 2.0 * x }\n",
                "2*x",
                None,
            ),
            (
                "#[cfg(any())]\nconst C: f64 = 2.0;\nfn f(x: f64) -> f64 { C * x }\n",
                "2*x",
                None,
            ),
            (
                "#[inline]\n#[must_use]\nfn f(x: f64) -> f64 { #[allow(unused)] let y = 3.0; x }\n",
                "x",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn a_number_is_converted_only_where_nothing_is_cut_off() {
    are(
        "f.rs",
        &[
            (
                "fn f(x: f64) -> f64 { (-1.0_f64) as usize as f64 + x }\n",
                "x - 1",
                None,
            ),
            (
                "fn f(x: f64) -> f64 { 300 as u8 as f64 + x }\n",
                "x + 300",
                None,
            ),
            (
                "fn f(x: f64) -> f64 { (2.5_f64 as i32) as f64 + x }\n",
                "x + 5/2",
                None,
            ),
            ("fn f(x: f64) -> f64 { x as i64 as f64 }\n", "x", None),
            (
                "type Byte = u8;\nfn f(x: f64) -> f64 { 300 as Byte as f64 + x }\n",
                "x + 300",
                None,
            ),
            (
                "fn f(x: f64, n: i64, i: i32) -> f64 { 255 as u8 as f64 + x + (n as usize) as f64 + (i as u8) as f64 }\n",
                "x + n + i + 255",
                Some(Equal),
            ),
            ("fn f(n: i32) -> f64 { (n as u8) as f64 }\n", "n", None),
            ("fn f(n: usize) -> f64 { (n - 1) as f64 }\n", "n - 1", None),
            (
                "fn f(n: usize, m: usize) -> f64 { (n as i64 - 1) as f64 + (m - 1) as f64 }\n",
                "n + m - 2",
                Some(Equal),
            ),
            ("fn f(k: i32) -> f64 { (k as u32) as f64 }\n", "k", None),
            (
                "fn f(k: i32, x: f64) -> f64 { (k as usize) as f64 * x }\n",
                "k*x",
                None,
            ),
            (
                "fn f(n: i64) -> f64 { (n * n) as i32 as f64 }\n",
                "n^2",
                None,
            ),
            (
                "fn f(n: usize, x: f64) -> f64 { (0..=n).map(|i| i as i64 as f64 * x).sum::<f64>() }\n",
                "x*n*(n + 1)/2",
                Some(Equal),
            ),
        ],
    );
}
