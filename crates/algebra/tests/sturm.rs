//! Root counts and isolation against polynomials made from known roots, and against Descartes' parity.
#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use num_traits::{Signed, Zero};
use proptest::prelude::*;
use std::cmp::Ordering;
use std::collections::BTreeSet;
use std::ops::Bound;
use torse_algebra::rational::integer;
use torse_algebra::sturm::{SignOn, SturmError};
use torse_algebra::{Integer, Rational, SturmSequence};

fn q(n: i64, d: i64) -> Rational {
    Rational::new(n.into(), d.into())
}

fn sturm(coefficients: &[i64]) -> Result<SturmSequence, SturmError> {
    SturmSequence::new(
        &coefficients
            .iter()
            .copied()
            .map(integer)
            .collect::<Vec<_>>(),
    )
}

fn product(a: &[Rational], b: &[Rational]) -> Vec<Rational> {
    let mut c = vec![Rational::zero(); a.len() + b.len() - 1];
    for (i, x) in a.iter().enumerate() {
        for (j, y) in b.iter().enumerate() {
            c[i + j] += x * y;
        }
    }
    c
}

fn value(coefficients: &[Rational], x: &Rational) -> Rational {
    coefficients
        .iter()
        .rev()
        .fold(Rational::zero(), |sum, c| sum * x + c)
}

/// Roots `n / 6` with multiplicities, a complex pair for each square, and a factor of any sign.
fn known_roots() -> impl Strategy<Value = (Vec<(i64, usize)>, Vec<Rational>)> {
    let roots = prop::collection::vec((-12_i64..=12, 1_usize..=3), 0..5);
    let pairs = prop::collection::vec((-5_i64..=5, 1_i64..=9), 0..3);
    let factor = prop_oneof![-7_i64..=-1, 1_i64..=7];
    (roots, pairs, factor).prop_map(|(roots, pairs, factor)| {
        let mut coefficients = vec![q(factor, 5)];
        for &(n, multiplicity) in &roots {
            for _ in 0..multiplicity {
                coefficients = product(&coefficients, &[q(-n, 6), integer(1)]);
            }
        }
        for (re, im) in pairs {
            coefficients = product(
                &coefficients,
                &[integer(re * re + im), integer(2 * re), integer(1)],
            );
        }
        (roots, coefficients)
    })
}

fn bound() -> impl Strategy<Value = Bound<i64>> {
    prop_oneof![
        4 => (-13_i64..=13).prop_map(Bound::Included),
        4 => (-13_i64..=13).prop_map(Bound::Excluded),
        1 => Just(Bound::Unbounded),
    ]
}

fn is_in(n: i64, (start, end): (Bound<i64>, Bound<i64>)) -> bool {
    use std::ops::RangeBounds;
    (start, end).contains(&n)
}

#[test]
fn open_and_closed_ends_are_told_apart_at_multiple_roots() {
    // x^2 (x - 1)^3.
    let p = sturm(&[0, 0, -1, 3, -3, 1]).unwrap();
    assert_eq!(p.count(..), 2);
    assert_eq!(p.count(integer(0)..=integer(1)), 2);
    assert_eq!(p.count(integer(0)..integer(1)), 1);
    assert_eq!(
        p.count((Bound::Excluded(integer(0)), Bound::Included(integer(1)))),
        1
    );
    assert_eq!(
        p.count((Bound::Excluded(integer(0)), Bound::Excluded(integer(1)))),
        0
    );
    assert_eq!(p.count(integer(1)..=integer(1)), 1);
    assert_eq!(p.count(integer(1)..integer(1)), 0);
    assert_eq!(p.count(integer(2)..=integer(0)), 0);
    assert_eq!(p.count(..integer(0)), 0);
    assert_eq!(p.count(integer(1)..), 1);
}

#[test]
fn constants_have_no_roots_and_zero_has_too_many() {
    assert_eq!(sturm(&[-3, 0, 0]).unwrap().count(..), 0);
    assert_eq!(sturm(&[-3]).unwrap().sign_on(..), Ok(SignOn::Negative));
    for zero in [&[][..], &[0, 0]] {
        assert!(matches!(sturm(zero), Err(SturmError::ZeroPolynomial)));
    }
}

#[test]
fn wilkinson_has_its_twenty_roots_and_one_more_bit_changes_that() {
    let mut p = (1..=20).fold(vec![integer(1)], |p, k| {
        product(&p, &[integer(-k), integer(1)])
    });
    let roots = SturmSequence::new(&p).unwrap();
    assert_eq!(roots.count(..), 20);
    let isolated = roots.isolate(..).unwrap();
    for (k, root) in (1..=20).zip(&isolated) {
        assert!(root.contains(&integer(k)));
    }
    // Wilkinson's own perturbation of x^19 by 2^-23 leaves 10 real roots.
    p[19] -= q(1, 1 << 23);
    assert_eq!(SturmSequence::new(&p).unwrap().count(..), 10);
}

#[test]
fn the_square_root_of_two_is_refined_to_a_hundred_digits() {
    let p = sturm(&[-2, 0, 1]).unwrap();
    let width = Rational::new(Integer::ONE, Integer::from(10).pow(100));
    let roots = p.isolate(..).unwrap();
    let root = p.refine(&roots[1], &width).unwrap();
    let (lower, upper) = (root.lower(), root.upper());
    assert!(upper - lower <= width);
    assert!(
        (lower * lower - integer(2)).is_negative() && (upper * upper - integer(2)).is_positive()
    );
    let refused = p.refine(&roots[0], &integer(0));
    assert_eq!(
        refused,
        Err(SturmError::WidthNotPositive { width: integer(0) })
    );
}

#[test]
fn work_is_bounded_on_hostile_input() {
    let long = vec![1; SturmSequence::MAX_DEGREE + 2];
    assert!(matches!(
        sturm(&long),
        Err(SturmError::DegreeTooLarge {
            degree: 129,
            limit: 128
        })
    ));
    let huge = [integer(1), Rational::from_integer(Integer::ONE << 20_000)];
    assert!(matches!(
        SturmSequence::new(&huge),
        Err(SturmError::CoefficientTooLarge {
            bits: 20_001,
            limit: 16_384
        })
    ));
    let p = sturm(&[-2, 0, 1]).unwrap();
    let roots = p.isolate(..).unwrap();
    let tiny = Rational::new(Integer::ONE, Integer::ONE << 30_000);
    assert!(matches!(
        p.refine(&roots[0], &tiny),
        Err(SturmError::BudgetSpent { count: 1, .. })
    ));
}

#[test]
fn signs_on_intervals_name_zeros_and_witnesses() {
    // x (x - 1)^2 (x - 2)
    let p = sturm(&[0, -2, 5, -4, 1]).unwrap();
    let on = |interval: (Bound<Rational>, Bound<Rational>)| p.sign_on(interval).unwrap();
    let (open, closed) = (Bound::Excluded::<Rational>, Bound::Included::<Rational>);
    assert_eq!(on((open(integer(2)), Bound::Unbounded)), SignOn::Positive);
    assert_eq!(on((open(integer(0)), open(integer(1)))), SignOn::Negative);
    let zeros = |sign: SignOn| match sign {
        SignOn::NonNegative(roots) => (Ordering::Greater, roots.len()),
        SignOn::NonPositive(roots) => (Ordering::Less, roots.len()),
        other => panic!("{other:?}"),
    };
    assert_eq!(
        zeros(on((closed(integer(0)), closed(integer(2))))),
        (Ordering::Less, 3)
    );
    assert_eq!(
        zeros(on((closed(q(1, 3)), closed(q(5, 3))))),
        (Ordering::Less, 1)
    );
    assert_eq!(
        zeros(on((closed(integer(2)), closed(integer(3))))),
        (Ordering::Greater, 1)
    );
    assert_eq!(on((closed(integer(1)), closed(integer(1)))), SignOn::Zero);
    let SignOn::Mixed {
        positive_at,
        negative_at,
    } = on((open(integer(0)), open(integer(3))))
    else {
        panic!("both signs occur");
    };
    assert_eq!(p.sign_at(&positive_at), Ordering::Greater);
    assert_eq!(p.sign_at(&negative_at), Ordering::Less);
    assert_eq!(
        p.sign_on(integer(1)..integer(1)),
        Err(SturmError::EmptyInterval)
    );
}

proptest! {
    #[test]
    fn counts_are_those_of_the_known_roots((roots, coefficients) in known_roots(), start in bound(), end in bound()) {
        let distinct: BTreeSet<i64> = roots.iter().map(|&(n, _)| n).collect();
        let expected = match (start, end) {
            // The standard containment test does not know that such an interval is empty.
            (Bound::Excluded(a), Bound::Excluded(b)) if a == b => 0,
            interval => distinct.iter().filter(|&&n| is_in(n, interval)).count(),
        };
        let scaled = |bound: Bound<i64>| bound.map(|n| q(n, 6));
        let sequence = SturmSequence::new(&coefficients).unwrap();
        prop_assert_eq!(sequence.count((scaled(start), scaled(end))), expected);
    }

    #[test]
    fn each_root_is_isolated_once_and_stays_inside_when_refined(
        (roots, coefficients) in known_roots(), start in bound(), end in bound(),
    ) {
        let scaled = |bound: Bound<i64>| bound.map(|n| q(n, 6));
        let expected: BTreeSet<i64> =
            roots.iter().map(|&(n, _)| n).filter(|&n| is_in(n, (start, end))).collect();
        let sequence = SturmSequence::new(&coefficients).unwrap();
        let isolated = sequence.isolate((scaled(start), scaled(end))).unwrap();
        prop_assert_eq!(isolated.len(), expected.len());
        for (root, n) in isolated.iter().zip(expected) {
            prop_assert!(root.contains(&q(n, 6)));
            let fine = sequence.refine(root, &q(1, 1000)).unwrap();
            prop_assert!(fine.contains(&q(n, 6)));
            prop_assert!(fine.upper() - fine.lower() <= q(1, 1000));
        }
        for pair in isolated.windows(2) {
            prop_assert!(pair[0].upper() <= pair[1].lower());
        }
    }

    #[test]
    fn the_sign_on_an_interval_is_that_at_every_point_of_it(
        (_, coefficients) in known_roots(), start in bound(), end in bound(),
    ) {
        let scaled = |bound: Bound<i64>| bound.map(|n| q(n, 6));
        let sequence = SturmSequence::new(&coefficients).unwrap();
        let sign = sequence.sign_on((scaled(start), scaled(end)));
        let mut seen = BTreeSet::new();
        for n in (-200..=200_i64).filter(|&n| {
            let times_four = |bound: Bound<i64>| bound.map(|m| 4 * m);
            is_in(n, (times_four(start), times_four(end)))
        }) {
            seen.insert(value(&coefficients, &q(n, 24)).signum().to_integer());
        }
        let (minus, zero, plus) = (Integer::from(-1), Integer::from(0), Integer::from(1));
        match sign {
            Ok(SignOn::Positive) => prop_assert!(!seen.contains(&minus) && !seen.contains(&zero)),
            Ok(SignOn::Negative) => prop_assert!(!seen.contains(&plus) && !seen.contains(&zero)),
            Ok(SignOn::NonNegative(roots)) => prop_assert!(!seen.contains(&minus) && !roots.is_empty()),
            Ok(SignOn::NonPositive(roots)) => prop_assert!(!seen.contains(&plus) && !roots.is_empty()),
            Ok(SignOn::Zero) => prop_assert_eq!(seen, BTreeSet::from([zero])),
            Ok(SignOn::Mixed { positive_at, negative_at }) => {
                prop_assert!(value(&coefficients, &positive_at).is_positive());
                prop_assert!(value(&coefficients, &negative_at).is_negative());
            }
            Err(error) => prop_assert_eq!(error, SturmError::EmptyInterval),
        }
    }
}
