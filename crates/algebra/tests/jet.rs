//! Jets against closed formulas, against each other in two orders of differentiation, and against
//! laws of the derivative.

use num_traits::Zero;
use proptest::prelude::*;
use torse_algebra::rational::integer;
use torse_algebra::{Ball, ExactError, Integer, Jet, Rational, Scalar, ZeroTest};

fn q(n: i64, d: i64) -> Rational {
    Rational::new(n.into(), d.into())
}

fn rational() -> impl Strategy<Value = Rational> {
    (-30_i64..30, 1_i64..12).prop_map(|(n, d)| q(n, d))
}

fn jet(order: usize) -> impl Strategy<Value = Jet<Rational>> {
    (rational(), prop::collection::vec(rational(), order))
        .prop_map(|(value, rest)| Jet::from_coefficients(value, rest))
}

/// The polynomial with these coefficients, ascending, by Horner's rule.
fn horner(coefficients: &[Rational], x: &Jet<Rational>) -> Jet<Rational> {
    coefficients
        .iter()
        .rev()
        .fold(x.zero_like(), |sum, c| sum * x.clone() + x.constant(c))
}

/// The coefficients of the n-th derivative, term by term.
fn term_by_term(coefficients: &[Rational], n: usize) -> Vec<Rational> {
    (0..n).fold(coefficients.to_vec(), |p, _| {
        (1_i64..)
            .zip(p.iter().skip(1))
            .map(|(k, c)| c * integer(k))
            .collect()
    })
}

#[test]
fn the_nth_derivative_of_a_quarter_turn_is_a_power_of_half_pi() {
    // At x = 1/3: d^n sin(pi x/2) = (pi/2)^n sin(pi x/2 + n pi/2), and so on around the circle.
    let at = Ball::from_rational(&q(1, 3), 200);
    let (sine, cosine) = at.quarter_turn().unwrap();
    let (s, c) = Jet::variable(at, 9).quarter_turn().unwrap();
    let half_pi = Ball::pi(200).scaled(&q(1, 2));
    let circle = [sine.clone(), cosine.clone(), -sine, -cosine];
    let precise = q(1, 1_000_000).pow(8);
    for n in 0..=9 {
        let power = half_pi.powi(n as u32);
        for (jet, ahead) in [(&s, 0), (&c, 1)] {
            let derivative = jet.derivative(n).unwrap();
            let difference = &derivative - &(&power * &circle[(n + ahead) % 4]);
            assert!(difference.contains_zero());
            assert!((&precise - difference.width()).numer() > &Integer::ZERO);
        }
    }
}

#[test]
fn a_quarter_turn_of_a_parabola_follows_the_chain_rule() {
    // u = x^2 at 1/2: (sin(pi u/2))'' = pi cos(pi u/2) - (pi x)^2 sin(pi u/2).
    let ball = |value: &Rational| Ball::from_rational(value, 160);
    let x = Jet::variable(ball(&q(1, 2)), 2);
    let (s, _) = x.powi(2).quarter_turn().unwrap();
    let (sine, cosine) = ball(&q(1, 4)).quarter_turn().unwrap();
    let pi = Ball::pi(160);
    let expected = &(&pi * &cosine) - &(&pi.scaled(&q(1, 2)).powi(2) * &sine);
    assert!((s.derivative(2).unwrap() - expected).contains_zero());
    // A wrong formula is told apart.
    assert!(!(s.derivative(2).unwrap() - &pi * &cosine).contains_zero());
}

#[test]
fn quarter_turns_without_pi_are_refused_unless_the_order_is_zero() {
    assert_eq!(
        Jet::variable(integer(1), 1).quarter_turn(),
        Err(ExactError::NoPi)
    );
    let (s, c) = Jet::variable(integer(1), 0).quarter_turn().unwrap();
    assert_eq!((s.value(), c.value()), (&integer(1), &integer(0)));
}

#[test]
fn division_by_a_jet_with_value_zero_is_refused() {
    let t = Jet::variable(integer(0), 3);
    assert!(matches!(
        t.one_like().divided_by(&t),
        Err(ExactError::DivisionByZero { .. })
    ));
    assert!(!t.is_known_zero() && !t.is_known_nonzero());
}

#[test]
fn jets_of_different_order_combine_at_the_smaller_one() {
    let (short, long) = (Jet::variable(integer(2), 1), Jet::variable(integer(3), 4));
    for combined in [
        short.clone() + long.clone(),
        long.clone() - short.clone(),
        short.clone() * long.clone(),
        short.divided_by(&long).unwrap(),
        long.divided_by(&short).unwrap(),
    ] {
        assert_eq!(combined.order(), 1);
    }
    assert_eq!(
        Jet::variable(integer(2), usize::MAX).order(),
        Jet::<Rational>::MAX_ORDER
    );
}

#[test]
fn mixed_derivatives_of_nested_jets_do_not_depend_on_the_order() {
    // f(x, y) = sin(pi x y / 2) / (1 + x y^2) at (1/3, 3/5), once with x inside, once with y inside.
    let at = [q(1, 3), q(3, 5)].map(|value| Ball::from_rational(&value, 256));
    let f = |x: Jet<Jet<Ball>>, y: Jet<Jet<Ball>>| {
        let denominator = x.one_like() + x.clone() * y.powi(2);
        (x * y)
            .quarter_turn()
            .and_then(|(s, _)| s.divided_by(&denominator))
            .unwrap()
    };
    let nested = |inner: &Ball, outer: &Ball| {
        let inner = Jet::variable(inner.clone(), 3);
        let outer = Jet::variable(inner.constant_like(outer.clone()), 3);
        (outer.constant_like(inner), outer)
    };
    let (x, y) = nested(&at[0], &at[1]);
    let x_inside = f(x, y);
    let (y, x) = nested(&at[1], &at[0]);
    let y_inside = f(x, y);
    for i in 0..=3 {
        for j in 0..=3 {
            let one = x_inside.derivative(j).unwrap().derivative(i).unwrap();
            let other = y_inside.derivative(i).unwrap().derivative(j).unwrap();
            assert!(
                one.overlaps(&other),
                "derivative {i} in x, {j} in y: {one} and {other}"
            );
            assert!(
                !one.contains_zero(),
                "the test can tell the derivatives from zero"
            );
        }
    }
}

proptest! {
    #[test]
    fn derivatives_of_polynomials_are_those_term_by_term(
        coefficients in prop::collection::vec(rational(), 0..7), at in rational(),
    ) {
        let f = horner(&coefficients, &Jet::variable(at.clone(), 7));
        for n in 0..=7 {
            let expected = horner(&term_by_term(&coefficients, n), &Jet::of_constant(at.clone(), 0));
            prop_assert_eq!(f.derivative(n), Some(expected.value().clone()));
        }
    }

    #[test]
    fn jets_form_a_commutative_ring(a in jet(4), b in jet(4), c in jet(4)) {
        prop_assert_eq!(a.clone() * b.clone(), b.clone() * a.clone());
        prop_assert_eq!(a.clone() * (b.clone() * c.clone()), a.clone() * b.clone() * c.clone());
        prop_assert_eq!(a.clone() * (b.clone() + c.clone()), a.clone() * b.clone() + a.clone() * c.clone());
        prop_assert_eq!(a.clone() - b.clone() + b.clone(), a.clone());
        prop_assert_eq!(a.clone() * a.one_like(), a.clone());
        prop_assert!((a.clone() + -a.clone()).is_known_zero());
        prop_assert_eq!(a.powi(5), a.clone() * a.clone() * a.clone() * a.clone() * a.clone());
        prop_assert_eq!(a.powi(0), a.one_like());
    }

    #[test]
    fn division_undoes_multiplication(a in jet(5), b in jet(5)) {
        prop_assume!(!b.value().is_zero());
        prop_assert_eq!((a.clone() * b.clone()).divided_by(&b), Ok(a));
    }

    #[test]
    fn the_derivative_of_a_product_obeys_the_rule_of_leibniz(a in jet(5), b in jet(5)) {
        let product = (a.clone() * b.clone()).differentiated().unwrap();
        let expected = a.differentiated().unwrap() * b.clone() + a * b.differentiated().unwrap();
        prop_assert_eq!(product, expected);
    }

    #[test]
    fn the_circle_stays_a_circle_under_any_argument(
        value in rational(), rest in prop::collection::vec(rational(), 5),
    ) {
        let ball = |value: Rational| Ball::from_rational(&value, 200);
        let u = Jet::from_coefficients(ball(value), rest.into_iter().map(ball));
        let (s, c) = u.quarter_turn().unwrap();
        let residue = s.powi(2) + c.powi(2) - u.one_like();
        prop_assert!(residue.coefficients().iter().all(Ball::contains_zero));
        // And s' = (pi/2) u' c.
        let slope = u.differentiated().unwrap() * c;
        let half_pi = slope.pi_like().unwrap().scaled(&q(1, 2));
        let residue = s.differentiated().unwrap() - half_pi * slope;
        prop_assert!(residue.coefficients().iter().all(Ball::contains_zero));
    }
}
