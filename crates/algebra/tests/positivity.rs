//! Sign proofs: Bernstein coefficients against the definition of the form, provers against polynomials
//! of known sign and against each other, checkers against certificates that were tampered with.
#![allow(clippy::unwrap_used, clippy::panic, reason = "helpers of tests")]

use num_traits::{Signed, Zero};
use proptest::prelude::*;
use torse_algebra::bernstein::{
    self, BernsteinCertificate, BernsteinError, BernsteinForm, Leaf, Term,
};
use torse_algebra::branch;
use torse_algebra::positivity::{BoxError, CertificateError, Decision, Positivity, RationalBox};
use torse_algebra::rational::integer;
use torse_algebra::{Ball, ExactError, Integer, Rational, Scalar};

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

fn in_balls(terms: &[Term]) -> impl Fn(&[Ball]) -> Result<Ball, ExactError> + Copy {
    |x: &[Ball]| {
        Ok(terms.iter().fold(x[0].zero_like(), |sum, (exponents, c)| {
            let factors = exponents.iter().zip(x);
            sum + factors.fold(x[0].constant(c), |product, (&e, x)| product * x.powi(e))
        }))
    }
}

fn product(a: &[Term], b: &[Term]) -> Vec<Term> {
    let add = |x: &[u32], y: &[u32]| x.iter().zip(y).map(|(i, j)| i + j).collect();
    let pairs = a.iter().flat_map(|x| b.iter().map(move |y| (x, y)));
    pairs.map(|((e, c), (f, d))| (add(e, f), c * d)).collect()
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

fn proof_of(decision: Decision<BernsteinCertificate, Rational>) -> BernsteinCertificate {
    match decision {
        Decision::Proved(certificate) => certificate,
        other => panic!("{other:?}"),
    }
}

/// The square of `x - c`.
fn square_around(c: Rational) -> Vec<Term> {
    let linear = [(vec![1], integer(1)), (vec![0], -c)];
    product(&linear, &linear)
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
fn a_zero_at_a_dyadic_point_is_proved_and_one_at_a_third_stays_unknown() {
    let unit = RationalBox::unit(1).unwrap();
    let terms = square_around(q(1, 2));
    let proof = proof_of(bernstein::prove_nonnegative(&terms, &unit, 100).unwrap());
    assert_eq!(bernstein::check_certificate(&terms, &unit, &proof), Ok(()));
    let refuted = bernstein::prove_positive(&terms, &unit, 100).unwrap();
    assert_eq!(
        refuted,
        Decision::Refuted {
            point: vec![q(1, 2)],
            value: integer(0)
        }
    );
    let terms = square_around(q(1, 3));
    let Decision::Unknown(attempt) = bernstein::prove_nonnegative(&terms, &unit, 50).unwrap()
    else {
        panic!("no halving meets the zero");
    };
    assert_eq!(attempt.examined, 50);
    // What is left closes in on the zero.
    let (lower, upper) = &attempt.example.sides()[0];
    let near = |end: &Rational| (end - q(1, 3)).abs() < q(1, 1000);
    assert!(attempt.open <= 3 && near(lower) && near(upper));
}

#[test]
fn the_polynomial_of_motzkin_is_positive_once_it_is_lifted() {
    // x^4 y^2 + x^2 y^4 - 3 x^2 y^2 + 1 is zero at (+-1, +-1) and no sum of squares.
    let term = |e: [u32; 2], c: Rational| (e.to_vec(), c);
    let motzkin = |lift: Rational| {
        [
            term([4, 2], integer(1)),
            term([2, 4], integer(1)),
            term([2, 2], integer(-3)),
            term([0, 0], integer(1) + lift),
        ]
    };
    let square = boxed(&[(-2, 2), (-2, 2)]);
    let lifted = motzkin(q(1, 100));
    let proof = proof_of(bernstein::prove_positive(&lifted, &square, 5000).unwrap());
    assert_eq!(
        bernstein::check_certificate(&lifted, &square, &proof),
        Ok(())
    );
    // The proof does not carry over to the polynomial as it was.
    let carried = bernstein::check_certificate(&motzkin(integer(0)), &square, &proof);
    assert!(matches!(carried, Err(CertificateError::PieceFails { .. })));
    let lowered = bernstein::prove_nonnegative(&motzkin(q(-1, 100)), &square, 5000).unwrap();
    let Decision::Refuted {
        point,
        value: found,
    } = lowered
    else {
        panic!("negative at (1, 1)")
    };
    assert_eq!(found, value(&motzkin(q(-1, 100)), &point));
    assert!(found.is_negative());
}

#[test]
fn tampered_certificates_are_refused() {
    let terms = [
        (vec![2], integer(1)),
        (vec![1], integer(-1)),
        (vec![0], q(3, 10)),
    ];
    let unit = RationalBox::unit(1).unwrap();
    let proof = proof_of(bernstein::prove_positive(&terms, &unit, 100).unwrap());
    assert!(
        proof.leaves.len() > 1,
        "the test needs a proof of several pieces"
    );
    let check = |certificate| bernstein::check_certificate(&terms, &unit, &certificate);
    assert_eq!(check(proof.clone()), Ok(()));

    let mut fewer = proof.clone();
    fewer.leaves.pop();
    assert_eq!(
        check(fewer),
        Err(CertificateError::NotFilled {
            pieces: proof.leaves.len() - 1
        })
    );
    let mut higher = proof.clone();
    higher.leaves[1].least += q(1, 1000);
    assert_eq!(
        check(higher),
        Err(CertificateError::PieceFails { piece: 1 })
    );
    let negative = q(-1, 5); // the true least coefficient on the whole interval
    let coarse = Leaf {
        region: unit.clone(),
        least: negative,
    };
    let coarse = BernsteinCertificate {
        positivity: Positivity::Strict,
        leaves: vec![coarse],
    };
    assert_eq!(
        check(coarse),
        Err(CertificateError::PieceFails { piece: 0 })
    );
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

#[test]
fn balls_prove_what_bernstein_coefficients_cannot_express() {
    // Jordan: sin(pi x/2) >= x on [0, 1] with equality at both ends; with a margin it is strict.
    let f = |margin: Rational| {
        move |x: &[Ball]| {
            x[0].quarter_turn()
                .map(|(s, _)| s - x[0].clone() + x[0].constant(&margin))
        }
    };
    let unit = RationalBox::unit(1).unwrap();
    let margin = f(q(1, 1000));
    let Decision::Proved(proof) = branch::prove_positive(&margin, &unit, 64, 20_000) else {
        panic!()
    };
    assert_eq!(branch::check_certificate(&margin, &unit, &proof), Ok(()));
    assert!(branch::check_certificate(f(q(-1, 1000)), &unit, &proof).is_err());
    let Decision::Refuted { point, value } = branch::prove_positive(f(integer(0)), &unit, 64, 100)
    else {
        panic!("zero at both ends");
    };
    assert_eq!((point, value.upper()), (vec![integer(0)], integer(0)));
    // Without the margin and without strictness no budget suffices: the ends stay open.
    let Decision::Unknown(attempt) = branch::prove_nonnegative(f(integer(0)), &unit, 64, 500)
    else {
        panic!("the ends are never settled");
    };
    assert_eq!((attempt.examined, attempt.obstacle), (500, None));
}

#[test]
fn a_function_without_value_somewhere_is_unknown_and_says_why() {
    let f = |x: &[Ball]| x[0].one_like().divided_by(&x[0].powi(2));
    let Decision::Unknown(attempt) = branch::prove_positive(f, &boxed(&[(-1, 2)]), 64, 60) else {
        panic!("there is no value at zero");
    };
    assert!(matches!(
        attempt.obstacle,
        Some(ExactError::DivisionByZero { .. })
    ));
    assert!(attempt.example.sides()[0].0.is_negative());
    // Where it has values it is settled.
    assert!(matches!(
        branch::prove_positive(f, &boxed(&[(1, 2)]), 64, 60),
        Decision::Proved(_)
    ));
}

#[test]
fn tampered_proofs_by_balls_are_refused() {
    let f = |x: &[Ball]| Ok(x[0].powi(2) - x[0].clone() + x[0].constant(&q(3, 10)));
    let unit = RationalBox::unit(1).unwrap();
    let Decision::Proved(proof) = branch::prove_positive(f, &unit, 64, 1000) else {
        panic!()
    };
    assert_eq!(branch::check_certificate(f, &unit, &proof), Ok(()));
    let mut fewer = proof.clone();
    fewer.leaves.remove(0);
    let missing = branch::check_certificate(f, &unit, &fewer);
    assert_eq!(
        missing,
        Err(CertificateError::NotFilled {
            pieces: proof.leaves.len() - 1
        })
    );
    let mut higher = proof;
    higher.leaves[0].1 += integer(1);
    let claimed = branch::check_certificate(f, &unit, &higher);
    assert_eq!(claimed, Err(CertificateError::PieceFails { piece: 0 }));
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

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn sums_of_squares_are_proved_and_lowered_ones_refuted(
        a in polynomial(2), b in polynomial(2), region in region(2), eighths in prop::collection::vec(0_i64..=8, 2),
    ) {
        let squares = [product(&a, &a), product(&b, &b)].concat();
        let shifted = |c: Rational| [&squares[..], &[(vec![0, 0], c)]].concat();
        let lifted = shifted(integer(1));
        if let Decision::Proved(proof) = bernstein::prove_positive(&lifted, &region, 300).unwrap() {
            prop_assert_eq!(bernstein::check_certificate(&lifted, &region, &proof), Ok(()));
        }
        let refuted = bernstein::prove_positive(&lifted, &region, 300).unwrap();
        prop_assert!(!matches!(refuted, Decision::Refuted { .. }), "{refuted:?}");
        // Lowered below its value at a dyadic point it is negative there, and that is found.
        let x = point_of(&region, &eighths);
        let lowered = shifted(-value(&squares, &x) - integer(1));
        if let Decision::Refuted { point, value: found } = bernstein::prove_nonnegative(&lowered, &region, 2000).unwrap() {
            prop_assert_eq!(&found, &value(&lowered, &point));
            prop_assert!(found.is_negative());
        } else {
            prop_assert!(false, "negative at {x:?}");
        }
    }

    #[test]
    fn both_provers_agree(terms in polynomial(2), region in region(2)) {
        let exact = bernstein::prove_positive(&terms, &region, 200).unwrap();
        let f = in_balls(&terms);
        let enclosed = branch::prove_positive(f, &region, 64, 200);
        match (&exact, &enclosed) {
            (Decision::Proved(_), Decision::Refuted { .. }) | (Decision::Refuted { .. }, Decision::Proved(_)) => {
                prop_assert!(false, "{exact:?}, {enclosed:?}");
            }
            _ => {}
        }
        if let Decision::Proved(proof) = exact {
            prop_assert_eq!(bernstein::check_certificate(&terms, &region, &proof), Ok(()));
        }
        if let Decision::Proved(proof) = enclosed {
            prop_assert_eq!(branch::check_certificate(f, &region, &proof), Ok(()));
        } else if let Decision::Refuted { point, .. } = enclosed {
            prop_assert!(!value(&terms, &point).is_positive());
        }
    }
}
