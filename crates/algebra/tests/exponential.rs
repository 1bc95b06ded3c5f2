//! Exponentials as symbols: the laws of powers, rates, values put in, one unit for all parts, and what is refused.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use proptest::prelude::*;
use torse_algebra::rational::ratio;
use torse_algebra::{ExactError, Finest, Fraction, Scalar as _, Symbol};

/// `a x + b x y + c` with small coefficients.
fn exponent([a, b, c]: [(i64, i64); 3]) -> Fraction {
    let (x, y) = (Fraction::named("x"), Fraction::named("y"));
    let part = |(n, d)| ratio(n, d).unwrap();
    x.scaled(&part(a)) + (x * y).scaled(&part(b)) + Fraction::integer(1).scaled(&part(c))
}

fn finest(value: &Fraction) -> Fraction {
    Finest::new(value.symbols().iter()).write(value).unwrap()
}

fn coefficients() -> impl Strategy<Value = [(i64, i64); 3]> {
    prop::array::uniform3((-4_i64..5, prop::sample::select(vec![1_i64, 2, 4])))
}

proptest! {
    #[test]
    fn the_exponential_of_a_sum_is_the_product(p in coefficients(), q in coefficients()) {
        let (p, q) = (exponent(p), exponent(q));
        let product = p.exponential().unwrap() * q.exponential().unwrap();
        let difference = (p + q).exponential().unwrap() - product;
        prop_assert!(finest(&difference).is_zero());
        prop_assert!(difference.conditions().is_empty());
    }

    #[test]
    fn the_rate_is_the_exponential_times_the_rate_of_the_exponent(p in coefficients()) {
        let p = exponent(p);
        let power = p.exponential().unwrap();
        for name in ["x", "y"] {
            let difference = power.derivative(name) - p.derivative(name) * power.clone();
            prop_assert!(finest(&difference).is_zero());
        }
    }

    #[test]
    fn values_are_put_into_the_exponent(p in coefficients(), q in coefficients()) {
        let (p, q) = (exponent(p), exponent(q));
        let there = p.exponential().unwrap().at("y", &Fraction::named("y").scaled(&ratio(1, 2).unwrap()));
        let moved = p.at("y", &Fraction::named("y").scaled(&ratio(1, 2).unwrap())).unwrap();
        prop_assert!(finest(&(there.unwrap() - moved.exponential().unwrap())).is_zero());
        let swapped = q.exponential().unwrap().at("x", &Fraction::zero()).unwrap();
        prop_assert!(swapped.symbols().iter().all(Symbol::is_number));
    }
}

#[test]
fn different_exponents_and_the_number_e_are_independent_symbols() {
    let power = |p: Fraction| p.exponential().unwrap();
    let (x, y) = (Fraction::named("x"), Fraction::named("y"));
    let sum =
        power(x.clone()) + power(y.clone()) + power(x.clone() * y) + power(Fraction::integer(1));
    assert_eq!(sum.numerator().len(), 4);
    assert_eq!(power(Fraction::zero()), Fraction::integer(1));
    // A divisor that is not an exponential stays a condition.
    let below = power(x.clone()) - Fraction::integer(1);
    let quotient = power(-x).over(&below).unwrap();
    assert_eq!(quotient.conditions(), [below.numerator().clone()]);
}

#[test]
fn exponents_that_are_no_polynomials_with_rational_coefficients_are_refused() {
    let (x, pi) = (Fraction::named("x"), Fraction::symbol(Symbol::Pi));
    let inverse = Fraction::integer(1).over(&x).unwrap();
    let root = Fraction::symbol(Symbol::Root(2));
    let (sine, _) = x.sine_cosine().unwrap();
    let nested = x.exponential().unwrap();
    let large = x.scaled(&ratio(65, 1).unwrap());
    let fine = x.scaled(&ratio(1, 65).unwrap());
    for exponent in [inverse, x * pi, root, sine, nested, large, fine] {
        let refused = exponent.exponential();
        assert!(
            matches!(refused, Err(ExactError::NoExponential { .. })),
            "{exponent}"
        );
    }
}
