//! Names of Rust: one has a meaning only if one item of the file gives it one.

use super::are;
use torse_code::CodeVerdict::{Different, Equal};

#[test]
fn a_constant_of_the_file_is_none_of_the_standard_library() {
    are(
        "f.rs",
        &[
            (
                "mod consts { pub const E: f64 = 2.0; }\npub fn f(x: f64) -> f64 { consts::E * x }\n",
                "exp(1)*x",
                None,
            ),
            (
                "mod material { pub mod consts { pub const TAU: f64 = 0.5; } }\npub fn f(x: f64) -> f64 { crate::material::consts::TAU * x }\n",
                "2*pi*x",
                None,
            ),
            (
                "mod my { pub mod f64 { pub mod consts { pub const PI: f64 = 3.0; } } }\nuse my::f64::consts::PI;\npub fn f(x: f64) -> f64 { PI * x }\n",
                "pi*x",
                None,
            ),
            (
                "use mine::f64;\npub fn f(x: f64) -> f64 { f64::consts::PI * x }\n",
                "pi*x",
                None,
            ),
            (
                "mod std { pub mod f64 { pub mod consts { pub const PI: f64 = 3.0; } } }\npub fn f(x: f64) -> f64 { std::f64::consts::PI * x }\n",
                "pi*x",
                None,
            ),
            (
                "#[cfg(feature = \"exact\")]\nuse std::f64::consts::PI;\n#[cfg(not(feature = \"exact\"))]\nconst PI: f64 = 3.0;\npub fn f(x: f64) -> f64 { PI * x }\n",
                "pi*x",
                None,
            ),
            (
                "use std::f64::consts::E;\nfn exp(x: f64) -> f64 { 1.0 + x }\npub fn f(x: f64) -> f64 { E * exp(x) }\n",
                "2*(1 + x)",
                Some(Different),
            ),
            (
                "use std::f64::consts::SQRT_2;\nfn sqrt(x: f64) -> f64 { x * x }\npub fn f(x: f64) -> f64 { SQRT_2 * sqrt(x) }\n",
                "4*x^2",
                Some(Different),
            ),
            (
                "use std::f64::consts::{self, E, PI};\nfn exp(x: f64) -> f64 { 1.0 + x }\npub fn f(x: f64) -> f64 { PI * x + consts::FRAC_PI_2 + E * exp(x) }\n",
                "pi*x + pi/2 + exp(1)*(1 + x)",
                Some(Equal),
            ),
            (
                "use core::f64;\npub fn f(x: f64) -> f64 { f64::consts::PI * x + std::f64::consts::TAU }\n",
                "pi*x + 2*pi",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn parameters_that_are_constants_are_not_read() {
    are(
        "f.rs",
        &[
            (
                "const N: i32 = 5;\nfn g<const N: i32>(x: f64) -> f64 { x * N as f64 }\npub fn f(x: f64) -> f64 { g::<2>(x) + N as f64 }\n",
                "5*x + 5",
                None,
            ),
            (
                "const N: usize = 2;\nfn total<const N: usize>(p: [f64; N]) -> f64 { let mut s = 0.0; for i in 0..N { s += p[i]; } s }\npub fn f(x: f64) -> f64 { total([x, x, x]) + N as f64 }\n",
                "2*x + 2",
                None,
            ),
            (
                "const N: usize = 2;\nfn total(p: [f64; N]) -> f64 { let mut s = 0.0; for i in 0..N { s += p[i]; } s }\npub fn f(x: f64) -> f64 { total([x, x]) + N as f64 }\n",
                "2*x + 2",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn what_a_file_adds_to_the_language_is_not_read() {
    are(
        "f.rs",
        &[
            (
                "type f64 = i32;\npub fn f(n: i32) -> f64 { (f64::from(n) + 1) / 2 }\n",
                "(n + 1)/2",
                None,
            ),
            (
                "trait Pow { fn pow(self, k: f64) -> f64; }\nimpl Pow for f64 { fn pow(self, k: f64) -> f64 { self + k } }\npub fn f(x: f64) -> f64 { x.pow(2.0) }\n",
                "x^2",
                None,
            ),
            (
                "use mine::Pow;\npub fn f(x: f64) -> f64 { x.pow(2.0) }\n",
                "x^2",
                None,
            ),
            (
                "trait Total { fn sum(&self) -> f64; }\nimpl Total for [f64; 2] { fn sum(&self) -> f64 { self[0] - self[1] } }\npub fn f(x: f64) -> f64 { [x, 1.0].sum() }\n",
                "x + 1",
                None,
            ),
            (
                "use mine::Total;\npub fn f(x: f64) -> f64 { [x, 1.0].sum() }\n",
                "x + 1",
                None,
            ),
            (
                "macro_rules! assert { ($($t:tt)*) => {} }\npub fn f(x: f64) -> f64 { assert!(x > 0.0); x }\n",
                "abs(x)",
                None,
            ),
            ("use mine::*;\npub fn f(x: f64) -> f64 { x }\n", "x", None),
            (
                "struct Curve { c: f64 }\nimpl Curve { fn sum(&self) -> f64 { self.c } }\n#[cfg(test)]\nmod tests { use super::*; }\npub fn f(n: i32, x: f64) -> f64 { n.pow(2) as f64 + [x, 1.0].iter().sum::<f64>() }\n",
                "n^2 + x + 1",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn an_identifier_of_rust_is_written_in_one_way() {
    are(
        "f.rs",
        &[
            ("pub fn f(x: f64) -> f64 { let r#x = 3.0; x }\n", "x", None),
            (
                "pub fn f(x: f64) -> f64 { let Ω = 2.0; let \u{2126} = 3.0; Ω * x }\n",
                "2*x",
                None,
            ),
        ],
    );
}

#[test]
fn the_ends_of_a_range_are_those_of_its_own_sign() {
    are(
        "f.rs",
        &[
            (
                "pub fn f(x: f64) -> f64 { let mut s = 0.0; for _ in 0..(1..=2).map(|k| k).sum::<usize>() { s += x; } s }\n",
                "4*x",
                Some(Different),
            ),
            (
                "pub fn f(x: f64) -> f64 { let mut s = 0.0; for _ in 0..(1..=2).map(|k| k).sum::<usize>() { s += x; } s }\n",
                "3*x",
                Some(Equal),
            ),
            (
                "pub fn f(x: f64) -> f64 { let mut s = 0.0; for _ in 0 .. /* not ..= */ 3 { s += x; } s }\n",
                "3*x",
                Some(Equal),
            ),
        ],
    );
}

#[test]
fn what_a_pattern_of_rust_leaves_out_is_left_out() {
    are(
        "f.rs",
        &[
            (
                "pub fn f(x: f64) -> f64 { let (u, _, v) = (x, 2.0, 3.0); u + v }\n",
                "x + 5",
                Some(Different),
            ),
            (
                "pub fn f(x: f64) -> f64 { let (u, _, v) = (x, 2.0, 3.0); u + v }\n",
                "x + 3",
                Some(Equal),
            ),
            (
                "pub fn f(x: f64) -> f64 { let v = [x, 2.0]; let [u, _] = v; let mut s = u; for (_, w) in v.iter().enumerate() { s += w; } s }\n",
                "2*x + 2",
                Some(Equal),
            ),
            (
                "pub fn f(x: f64) -> f64 { [x, 2.0].iter().enumerate().map(|(_, w)| w * 2.0).sum::<f64>() }\n",
                "2*x + 4",
                Some(Equal),
            ),
        ],
    );
}
