//! The plain polynomials: their relations, division, and what is independent.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use proptest::prelude::*;
use std::cmp::Ordering;
use std::sync::Arc;
use torse_certificate::number::{decimal, order};
use torse_certificate::symbol::{Angle, Symbol, Unit};
use torse_certificate::{Polynomial, Ratio};
use torse_numbers::rational::{integer, ratio};

fn named(name: &str) -> Polynomial {
    Polynomial::symbol(Symbol::named(name))
}

fn number(n: i64) -> Polynomial {
    Polynomial::constant(integer(n))
}

fn turn(parts: u16) -> (Polynomial, Polynomial) {
    let angle = Angle {
        unit: Unit::QuarterTurn,
        parts,
    };
    let x: Arc<str> = Arc::from("x");
    (
        Polynomial::symbol(Symbol::Sine(x.clone(), angle)),
        Polynomial::symbol(Symbol::Cosine(x, angle)),
    )
}

#[test]
fn sines_and_roots_have_degree_one_at_most() {
    let (sine, cosine) = turn(1);
    assert_eq!(sine.power(2).plus(&cosine.power(2)), Polynomial::one());
    let fourth = number(1).minus(&cosine.power(2)).power(2);
    assert_eq!(sine.power(4), fourth);
    let root = Polynomial::symbol(Symbol::Root(2));
    assert_eq!(root.power(5), root.scaled(&integer(4)));
}

#[test]
fn parts_of_one_angle_are_refined_to_the_finest() {
    let ((sine, cosine), (half_sine, half_cosine)) = (turn(1), turn(2));
    let doubled = half_sine.times(&half_cosine).scaled(&integer(2));
    let difference = sine.minus(&doubled);
    assert!(!difference.is_zero());
    assert!(difference.refined().unwrap().is_zero());
    let wrong = cosine.minus(&half_cosine.power(2));
    assert!(!wrong.refined().unwrap().is_zero());
}

#[test]
fn division_leaves_no_rest_or_has_no_quotient() {
    let (a, b) = (named("a"), named("b"));
    let product = a.minus(&b).times(&a.plus(&b).plus(&number(3)));
    assert_eq!(
        product.quotient(&a.minus(&b)),
        Some(a.plus(&b).plus(&number(3)))
    );
    assert_eq!(product.quotient(&a), None);
    assert_eq!(product.quotient(&Polynomial::zero()), None);
    assert_eq!(Polynomial::zero().quotient(&a), Some(Polynomial::zero()));
}

#[test]
fn a_factor_is_found_where_sines_and_roots_lead() {
    let (sine, cosine) = turn(1);
    let root = Polynomial::symbol(Symbol::Root(2));
    let factor = number(1).minus(&sine).minus(&cosine);
    let rest = named("a").times(&sine).plus(&root.times(&cosine));
    for (one, other) in [
        (&factor, &rest),
        (&rest, &factor),
        (&factor, &factor.power(2)),
    ] {
        let product = one.times(other);
        assert_eq!(product.quotient(one).as_ref(), Some(other));
        assert_eq!(product.plus(&number(1)).quotient(one), None);
    }
}

#[test]
fn numbers_are_ordered_and_shown_by_enclosures() {
    let pi = Polynomial::symbol(Symbol::Pi);
    let root = Polynomial::symbol(Symbol::Root(10));
    // pi < sqrt(10)
    assert_eq!(order(&pi.minus(&root)), Some(Ordering::Less));
    assert_eq!(
        order(&root.times(&root).minus(&number(10))),
        Some(Ordering::Equal)
    );
    let third = Ratio {
        above: pi,
        below: number(3),
    };
    assert!(decimal(&third, 6).unwrap().starts_with("1.047197"));
}

#[test]
fn they_are_written_as_the_language_reads_them() {
    let (sine, _) = turn(1);
    let half = ratio(-3, 2).unwrap();
    let p = named("x")
        .power(2)
        .scaled(&half)
        .plus(&sine)
        .minus(&number(1));
    assert_eq!(p.to_string(), "-3/2*x^2 + sin(pi/2*x) - 1");
}

fn polynomial() -> impl Strategy<Value = Polynomial> {
    let term = (-4_i64..5, 0_u32..3, 0_u32..3, 0_u32..2);
    proptest::collection::vec(term, 0..5).prop_map(|terms| {
        let one = |(c, i, j, k): (i64, u32, u32, u32)| {
            let root = Polynomial::symbol(Symbol::Root(2)).power(k);
            named("a")
                .power(i)
                .times(&named("b").power(j))
                .times(&root)
                .scaled(&integer(c))
        };
        terms
            .into_iter()
            .map(one)
            .fold(Polynomial::zero(), |sum, t| sum.plus(&t))
    })
}

proptest! {
    #[test]
    fn the_laws_of_rings_hold(p in polynomial(), q in polynomial(), r in polynomial()) {
        prop_assert_eq!(p.times(&q), q.times(&p));
        prop_assert_eq!(p.times(&q.plus(&r)), p.times(&q).plus(&p.times(&r)));
        prop_assert_eq!(p.minus(&p), Polynomial::zero());
    }
}
