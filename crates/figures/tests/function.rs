//! Compiled formulas against certified enclosures of the exact ones.

#![allow(clippy::unwrap_used, reason = "tests")]

use proptest::prelude::*;
use torse_algebra::rational::ratio;
use torse_algebra::{Angle, Ball, Fraction, Rational, Scalar as _, Symbol, Unit};
use torse_figures::{Function, PlateError};

/// Bits of the enclosures.
const BITS: usize = 120;

/// Symbols that may occur: two variables, their sines, cosines and exponentials, pi, a root and e.
fn symbols() -> Vec<Symbol> {
    let mut all = vec![Symbol::Pi, Symbol::Root(2)];
    for name in ["u", "v"] {
        all.push(Symbol::named(name));
        for angle in [
            Angle::QUARTER_TURN,
            Angle::RADIAN,
            Angle::RADIAN.over(2),
            Angle::QUARTER_TURN.over(3),
        ] {
            all.push(Symbol::Sin(name.into(), angle));
            all.push(Symbol::Cos(name.into(), angle));
        }
        let half = Fraction::named(name).scaled(&ratio(1, 2).unwrap());
        all.extend(half.exponential().unwrap().symbols());
    }
    all.extend(Fraction::integer(1).exponential().unwrap().symbols());
    all
}

/// A polynomial as terms of a coefficient and symbols.
fn polynomial() -> impl Strategy<Value = Fraction> {
    let factor = prop::sample::select(symbols());
    let term = (-9_i64..10, 1_i64..6, prop::collection::vec(factor, 0..4));
    prop::collection::vec(term, 1..7).prop_map(|terms| {
        terms
            .into_iter()
            .fold(Fraction::zero(), |sum, (n, d, factors)| {
                let coefficient = Fraction::from(ratio(n, d).unwrap());
                sum + factors.into_iter().fold(coefficient, |product, symbol| {
                    product * Fraction::symbol(symbol)
                })
            })
    })
}

/// The exact value of a symbol at rational u, v.
fn enclosed(symbol: &Symbol, u: &Rational, v: &Rational) -> Ball {
    let at = |name: &str| Ball::from_rational(if name == "u" { u } else { v }, BITS);
    let half = Ball::from_rational(&ratio(1, 2).unwrap(), BITS);
    let angle = |name: &str, angle: &Angle| {
        let part = Ball::from_rational(&ratio(1, i64::from(angle.parts)).unwrap(), BITS);
        part * match angle.unit {
            Unit::QuarterTurn => at(name) * Ball::pi(BITS) * half.clone(),
            Unit::Radian => at(name),
        }
    };
    match symbol {
        Symbol::Named(name) => at(name),
        Symbol::Pi => Ball::pi(BITS),
        Symbol::Root(n) => Ball::from_rational(&ratio(i64::from(*n), 1).unwrap(), BITS)
            .sqrt()
            .unwrap(),
        Symbol::Log(n) => Ball::from_rational(&ratio(i64::from(*n), 1).unwrap(), BITS)
            .ln()
            .unwrap(),
        Symbol::Arc(n, d) => {
            Ball::from_rational(&ratio(i64::from(*n), i64::from(*d)).unwrap(), BITS)
                .atan()
                .unwrap()
        }
        Symbol::Sin(name, a) => angle(name, a).sin_cos().0,
        Symbol::Cos(name, a) => angle(name, a).sin_cos().1,
        Symbol::Exp(exponent) => {
            let value = exponent.polynomial().evaluate(&half, |s| match s {
                Symbol::Named(name) => Ok(at(name)),
                _ => Err(()),
            });
            value.unwrap().exp().unwrap()
        }
        Symbol::Indexed(..) => unreachable!("no family occurs"),
    }
}

proptest! {
    #[test]
    fn compiled_formulas_agree_with_certified_enclosures(
        top in polynomial(), bottom in polynomial(), a in 0_i64..13, b in 0_i64..13,
    ) {
        let (u, v) = (ratio(a, 12).unwrap(), ratio(b, 12).unwrap());
        let ball = |p: &Fraction| {
            let like = Ball::from_rational(&ratio(0, 1).unwrap(), BITS);
            p.numerator().evaluate(&like, |s| Ok::<_, ()>(enclosed(s, &u, &v))).unwrap()
        };
        let below = ball(&bottom);
        // A divisor that is zero or nearly so has no quotient to compare.
        prop_assume!(below.to_f64_bounds().0.abs() > 0.05);
        let quotient = top.over(&bottom).unwrap();
        let (x, y) = (f64::from(a as i32) / 12.0, f64::from(b as i32) / 12.0);
        let got = Function::new(&quotient, &["u", "v"]).unwrap().grid(&[x], &[y])[0];
        let (low, high) = ball(&top).to_f64_bounds();
        let expected = 0.5 * (low + high) / below.to_f64_bounds().0;
        prop_assert!((got - expected).abs() <= 1e-8 * (1.0 + expected.abs()), "{got} {expected}");
    }
}

#[test]
fn a_symbol_that_does_not_run_is_named() {
    let stray = Function::new(&Fraction::named("mu"), &["u"]).unwrap_err();
    assert_eq!(
        stray,
        PlateError::Symbol {
            symbol: "mu".into()
        }
    );
}

#[test]
fn a_division_by_zero_is_no_number() {
    let formula = Fraction::integer(1).over(&Fraction::named("u")).unwrap();
    assert!(Function::new(&formula, &["u"]).unwrap().line(&[0.0])[0].is_infinite());
}
