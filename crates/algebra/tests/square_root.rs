//! Square roots of rational numbers: exact, or refused in bounded time.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use proptest::prelude::*;
use torse_algebra::rational::{integer, ratio};
use torse_algebra::{ExactError, Integer, Polynomial, Rational};

proptest! {
    #[test]
    fn the_square_of_the_root_is_the_number(n in 0_i64..5000, d in 1_i64..5000) {
        let q = ratio(n, d).unwrap();
        let root = Polynomial::square_root(&q).unwrap();
        prop_assert_eq!(&root * &root, Polynomial::constant(&q));
    }
}

#[test]
fn long_radicands_are_taken_apart_or_refused() {
    // 2 * 3^2001 * 5^1000, of 5,496 bits.
    let smooth: Integer = Integer::from(3).pow(2001) * Integer::from(5).pow(1000) * 2;
    let root = Polynomial::square_root(&Rational::from_integer(smooth.clone())).unwrap();
    assert_eq!(&root * &root, Polynomial::constant(&smooth.into()));
    // 3,000 digits without small factors.
    let rough: Integer = Integer::from(10).pow(3000) + 1;
    let refused = Polynomial::square_root(&Rational::from_integer(rough));
    assert!(matches!(refused, Err(ExactError::NoSquareRoot { .. })));
    let long = integer(2).pow(1 << 15);
    let refused = Polynomial::square_root(&long);
    assert!(matches!(refused, Err(ExactError::TooLarge { .. })));
}
