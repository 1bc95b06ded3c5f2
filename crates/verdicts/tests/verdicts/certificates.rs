//! Certificates of sign: what the prover finds passes the checker, what is tampered with does not.

#![allow(
    clippy::unwrap_used,
    clippy::indexing_slicing,
    reason = "helpers of tests"
)]

use proptest::prelude::*;
use torse_algebra::rational::{integer, ratio};
use torse_algebra::{Polynomial, Rational, Symbol};
use torse_prove::decide::domain::{Constraint, Domain};
use torse_prove::decide::sign::certificate::{
    Certificate, CertificateError, Factor, Reason, check,
};
use torse_prove::decide::sign::prove;
use torse_syntax::derivation::declarations::{Bound, Declarations, Interval, SymbolKind};
use torse_syntax::formula::Relation;

fn interval(lower: i64, upper: i64) -> SymbolKind {
    let bound = |value| {
        let value = integer(value).into();
        Some(Bound {
            value,
            closed: true,
        })
    };
    SymbolKind::Real(Box::new(Interval {
        lower: bound(lower),
        upper: bound(upper),
        ..Interval::default()
    }))
}

/// x in [0, 1], y in [-1, 2].
fn declarations() -> Declarations {
    Declarations::default()
        .with_symbol("x", interval(0, 1))
        .with_symbol("y", interval(-1, 2))
}

fn x() -> Polynomial {
    Polynomial::named("x")
}

fn y() -> Polynomial {
    Polynomial::named("y")
}

fn number(n: i64) -> Polynomial {
    Polynomial::integer(n)
}

/// `x (x^3 + y^3 + 1/2)`, zero at x = 0, with more than one piece; on the domain with x + y >= 0, without
/// which it is false.
fn proved(declarations: &Declarations) -> (Polynomial, Domain<'_>, Certificate) {
    let cubes = &x().power(3) + &y().power(3);
    let form = &cubes + &Polynomial::constant(&ratio(1, 2).unwrap());
    let polynomial = &x() * &form;
    let mut domain = Domain::new(declarations);
    domain.constraints.push(Constraint {
        value: (&x() + &y()).into(),
        relation: Relation::AtLeast,
    });
    let certificate = prove(&polynomial, &domain).unwrap();
    (polynomial, domain, certificate)
}

#[test]
fn a_proof_passes_and_uses_pieces_and_assumptions() {
    let declarations = declarations();
    let (polynomial, domain, certificate) = proved(&declarations);
    assert_eq!(check(&polynomial, &domain, &certificate), Ok(()));
    assert!(!certificate.strict);
    assert_eq!(certificate.factors, [Factor::Symbol(Symbol::named("x"))]);
    assert!(certificate.pieces.len() > 2);
    let outside =
        |p: &&torse_prove::decide::sign::certificate::Piece| p.reason == Reason::Outside(0);
    assert!(certificate.pieces.iter().any(|p| outside(&p)));
}

#[test]
fn a_certificate_that_was_tampered_with_is_rejected() {
    let declarations = declarations();
    let (polynomial, domain, good) = proved(&declarations);
    let rejected = |change: &dyn Fn(&mut Certificate)| {
        let mut bad = good.clone();
        change(&mut bad);
        check(&polynomial, &domain, &bad).unwrap_err()
    };
    assert_eq!(rejected(&|c| c.strict = true), CertificateError::Zero);
    assert_eq!(
        rejected(&|c| c.rest = &c.rest + &number(1)),
        CertificateError::Equation
    );
    assert_eq!(rejected(&|c| c.factors.clear()), CertificateError::Equation);
    let pieces = good.pieces.len() - 1;
    assert_eq!(
        rejected(&|c| drop(c.pieces.pop())),
        CertificateError::NotFilled { pieces }
    );
    assert_eq!(
        rejected(&|c| c.pieces[0].region[0].0 = ratio(1, 3).unwrap()),
        CertificateError::NotFilled { pieces: pieces + 1 }
    );
    // Each piece rests on its own reason.
    for (piece, own) in good.pieces.iter().enumerate() {
        let other = match own.reason {
            Reason::Coefficients => Reason::Outside(0),
            Reason::Outside(_) => continue,
        };
        assert_eq!(
            rejected(&|c| c.pieces[piece].reason = other),
            CertificateError::Coefficient { piece }
        );
    }
    // One piece for all is not enough.
    let whole = |c: &mut Certificate| {
        c.pieces.truncate(1);
        c.pieces[0].region = vec![(integer(0), integer(1)); 2];
        c.pieces[0].reason = Reason::Coefficients;
    };
    assert_eq!(rejected(&whole), CertificateError::Coefficient { piece: 0 });
}

#[test]
fn multipliers_and_factors_that_may_be_negative_are_rejected() {
    let declarations = declarations();
    let mut domain = Domain::new(&declarations);
    let assumed = &x() + &y();
    domain.constraints.push(Constraint {
        value: assumed.clone().into(),
        relation: Relation::Greater,
    });
    // 2x + y > 0 where x + y > 0.
    let sum = &x() + &assumed;
    let good = prove(&sum, &domain).unwrap();
    assert_eq!(check(&sum, &domain, &good), Ok(()));
    assert!(good.strict && !good.multipliers.is_empty());
    let mut none = domain.clone();
    none.constraints.clear();
    assert!(check(&sum, &none, &good).is_err());
    // -c = (-1) c, -c/2 = (-1/2) c: the multipliers are negative.
    for multiplier in [integer(-1), ratio(-1, 2).unwrap()] {
        let mut bad = prove(&number(0), &domain).unwrap();
        bad.multipliers = vec![(0, multiplier.clone())];
        bad.rest = number(0);
        for strict in [false, true] {
            bad.strict = strict;
            assert_eq!(
                check(&assumed.scaled(&multiplier), &domain, &bad),
                Err(CertificateError::Part { part: 0 })
            );
        }
    }
    // y = 1 y: y is no factor that is known to be nonnegative.
    let mut bad = prove(&number(1), &none).unwrap();
    bad.factors = vec![Factor::Symbol(Symbol::named("y"))];
    assert_eq!(
        check(&y(), &none, &bad),
        Err(CertificateError::Part { part: 0 })
    );
}

fn polynomial(coefficients: &[i64]) -> Polynomial {
    let mut total = number(0);
    for (place, c) in coefficients.iter().enumerate() {
        let (i, j) = (
            u32::try_from(place / 3).unwrap(),
            u32::try_from(place % 3).unwrap(),
        );
        total = &total + &(&(&x().power(i) * &y().power(j)) * &number(*c));
    }
    total
}

fn value(p: &Polynomial, at: &[Rational; 2]) -> Rational {
    let place = |s: &Symbol| {
        let own = if *s == Symbol::named("x") {
            &at[0]
        } else {
            &at[1]
        };
        Some(Polynomial::constant(own))
    };
    p.substituted(place).as_constant().unwrap()
}

proptest! {
    #[test]
    fn what_is_proved_passes_the_checker_and_holds_at_points(
        coefficients in proptest::collection::vec(-3_i64..6, 9),
        offset in 0_i64..12,
    ) {
        let declarations = declarations();
        let domain = Domain::new(&declarations);
        let p = &polynomial(&coefficients) + &number(offset);
        if let Some(certificate) = prove(&p, &domain) {
            prop_assert_eq!(check(&p, &domain, &certificate), Ok(()));
            let zero = integer(0);
            for i in 0..=4 {
                for j in 0..=6 {
                    let at = [ratio(i, 4).unwrap(), ratio(j - 2, 2).unwrap()];
                    let v = value(&p, &at);
                    let fits = v > zero || (!certificate.strict && v == zero);
                    prop_assert!(fits);
                }
            }
            // The same certificate says nothing about less.
            let less = &p - &number(1);
            prop_assert!(check(&less, &domain, &certificate).is_err());
        }
    }
}

#[test]
fn sums_of_squares_pass_the_checker_and_tampered_ones_are_rejected() {
    let declarations = Declarations::default();
    let domain = Domain::new(&declarations);
    let (u, v) = (Polynomial::named("u"), Polynomial::named("v"));
    let one = Polynomial::integer(1);
    let value = &(&(&u.power(2) + &(&u * &v)) + &v.power(2)) + &one;
    let certificate = prove(&value, &domain).unwrap();
    assert!(certificate.strict && certificate.squares.len() == 2);
    assert_eq!(check(&value, &domain, &certificate), Ok(()));
    let mut negative = certificate.clone();
    negative.squares[0].0 = -negative.squares[0].0.clone();
    let negative = check(&value, &domain, &negative);
    assert_eq!(negative, Err(CertificateError::Part { part: 0 }));
    let mut other = certificate.clone();
    other.squares[1].1 = &other.squares[1].1 + &one;
    assert_eq!(
        check(&value, &domain, &other),
        Err(CertificateError::Equation)
    );
    // Zero at the origin: nothing is left that is more than zero.
    let value = &value - &one;
    let mut strict = prove(&value, &domain).unwrap();
    assert!(!strict.strict);
    strict.strict = true;
    assert_eq!(check(&value, &domain, &strict), Err(CertificateError::Zero));
    // Indefinite.
    assert_eq!(prove(&(&u.power(2) - &v.power(2)), &domain), None);
}
