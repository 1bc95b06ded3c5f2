//! Boxes and Bernstein forms: coefficients against the definition of the form.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use num_traits::Zero;
use proptest::prelude::*;
use torse_algebra::bernstein::{BernsteinError, BernsteinForm, Term};
use torse_algebra::rational::integer;
use torse_algebra::rational_box::{BoxError, RationalBox};
use torse_algebra::{Integer, Rational};

fn q(n: i64, d: i64) -> Rational {
    Rational::new(n.into(), d.into())
}

fn power(x: &Rational, exponent: u32) -> Rational {
    num_traits::pow(x.clone(), exponent as usize)
}

fn value(terms: &[Term], x: &[Rational]) -> Rational {
    terms.iter().fold(Rational::zero(), |sum, (exponents, c)| {
        sum + exponents
            .iter()
            .zip(x)
            .fold(c.clone(), |product, (&e, x)| product * power(x, e))
    })
}

fn boxed(sides: &[(i64, i64)]) -> RationalBox {
    RationalBox::new(
        sides
            .iter()
            .map(|&(a, b)| (integer(a), integer(b)))
            .collect(),
    )
    .unwrap()
}

fn polynomial(variables: usize) -> impl Strategy<Value = Vec<Term>> {
    let exponents = prop::collection::vec(0_u32..4, variables);
    let coefficient = (-9_i64..=9, 1_i64..5).prop_map(|(n, d)| q(n, d));
    prop::collection::vec((exponents, coefficient), 1..7)
}

fn region(dimension: usize) -> impl Strategy<Value = RationalBox> {
    prop::collection::vec((-6_i64..6, 0_i64..8, 1_i64..4), dimension).prop_map(|sides| {
        let side = |(a, w, d): (i64, i64, i64)| (q(a, d), q(a + w, d));
        RationalBox::new(sides.into_iter().map(side).collect()).unwrap()
    })
}

/// The point of the box with these parts of eight along the sides.
fn point_of(region: &RationalBox, eighths: &[i64]) -> Vec<Rational> {
    let along = region.sides().iter().zip(eighths);
    along.map(|((a, b), &t)| a + (b - a) * q(t, 8)).collect()
}

fn binomial(n: usize, k: usize) -> Integer {
    (1..=k).fold(Integer::ONE, |c, i| c * (n + 1 - i) / i)
}

/// `sum_j b_j B_j(t)` by the definition of the Bernstein polynomials.
fn from_coefficients(form: &BernsteinForm, t: &[Rational]) -> Rational {
    form.coefficients()
        .enumerate()
        .fold(Rational::zero(), |sum, (place, b)| {
            let mut rest = place;
            let degrees = form.degrees().iter().zip(t).rev();
            sum + degrees.fold(b, |product, (&d, t)| {
                let j = rest % (d + 1);
                rest /= d + 1;
                let complement = integer(1) - t;
                product * binomial(d, j) * power(t, j as u32) * power(&complement, (d - j) as u32)
            })
        })
}

#[test]
fn boxes_without_sides_or_with_reversed_sides_are_refused() {
    assert_eq!(RationalBox::new(vec![]), Err(BoxError::NoSides));
    let reversed = RationalBox::new(vec![(integer(0), integer(1)), (integer(-1), integer(-2))]);
    let (lower, upper) = (integer(-1), integer(-2));
    assert_eq!(
        reversed,
        Err(BoxError::Reversed {
            axis: 1,
            lower,
            upper
        })
    );
}

#[test]
fn only_pieces_without_gap_or_overlap_fill_a_box() {
    let whole = boxed(&[(0, 2), (0, 2)]);
    let (left, right) = whole.halves(0).unwrap();
    let (low, high) = right.halves(1).unwrap();
    assert!(whole.is_filled_by(&[&whole]));
    assert!(whole.is_filled_by(&[&low, &left, &high]));
    assert!(!whole.is_filled_by(&[]));
    assert!(!whole.is_filled_by(&[&left, &low]));
    assert!(!whole.is_filled_by(&[&left, &right, &low]));
    assert!(!whole.is_filled_by(&[&whole, &whole]));
    assert!(!whole.is_filled_by(&[&left, &boxed(&[(1, 3), (0, 2)])]));
    assert!(!whole.is_filled_by(&[&boxed(&[(0, 0), (0, 0)])]));
    assert!(!whole.is_filled_by(&[&boxed(&[(0, 2)])]));
    // A box that is flat along one side is filled by halves along the other.
    let flat = boxed(&[(1, 1), (0, 2)]);
    let (low, high) = flat.halves(1).unwrap();
    assert!(flat.is_filled_by(&[&low, &high]) && flat.halves(0).is_none());
}

#[test]
fn polynomials_that_do_not_fit_the_box_are_refused() {
    let unit = RationalBox::unit(2).unwrap();
    let wrong = BernsteinForm::new(&[(vec![1], integer(1))], &unit);
    let expected = BernsteinError::WrongDimension {
        term: 0,
        found: 1,
        expected: 2,
    };
    assert_eq!(wrong.map(|_| ()), Err(expected));
    for exponents in [vec![300, 300], vec![u32::MAX, u32::MAX]] {
        let large = BernsteinForm::new(&[(exponents, integer(1))], &unit);
        assert_eq!(
            large.map(|_| ()),
            Err(BernsteinError::TooLarge { limit: 65_536 })
        );
    }
}

proptest! {
    #[test]
    fn coefficients_give_the_polynomial_back(
        terms in polynomial(2), region in region(2), eighths in prop::collection::vec(0_i64..=8, 2),
    ) {
        let form = BernsteinForm::new(&terms, &region).unwrap();
        let t: Vec<Rational> = eighths.iter().map(|&t| q(t, 8)).collect();
        let x = point_of(&region, &eighths);
        prop_assert_eq!(from_coefficients(&form, &t), value(&terms, &x));
        let (least, greatest) = form.bounds();
        prop_assert!(least <= value(&terms, &x));
        prop_assert!(value(&terms, &x) <= greatest);
        for (corner, at_corner) in form.corners() {
            prop_assert_eq!(at_corner, value(&terms, &corner));
        }
    }

    #[test]
    fn halves_are_the_forms_on_the_halves(terms in polynomial(3), region in region(3), axis in 0_usize..3) {
        let form = BernsteinForm::new(&terms, &region).unwrap();
        match (form.halves(axis), region.halves(axis)) {
            (Some(forms), Some(regions)) => {
                for (half, region) in [(forms.0, regions.0), (forms.1, regions.1)] {
                    let direct = BernsteinForm::new(&terms, &region).unwrap();
                    prop_assert_eq!(half.region(), &region);
                    prop_assert!(half.coefficients().eq(direct.coefficients()));
                }
            }
            (None, None) => {}
            other => prop_assert!(false, "{other:?}"),
        }
    }

}
