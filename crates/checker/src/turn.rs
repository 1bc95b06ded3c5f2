//! Sine and cosine of sums of angles, by the addition theorems and a table for multiples of pi/12. Independent of
//! `semantics` on purpose: do not share.

use super::gap::{Unsupported, Work};
use torse_certificate::polynomial::{Polynomial, multiple};
use torse_certificate::symbol::{Angle, Symbol, Unit};
use torse_numbers::rational::integer;
use torse_numbers::{Integer, Rational};

/// A sine and a cosine.
pub type Pair = (Polynomial, Polynomial);

/// The variable of angles that are numbers; no name of a claim is written so.
const ONE: &str = "1";

/// The largest multiple of a fraction of an angle.
const MAX_MULTIPLE: i64 = 24;

/// `(sin, cos)` of an angle in radians that is a sum of rational multiples of variables, of pi times variables, and
/// of pi. Sine and cosine of a multiple of pi that is no multiple of pi/12 are symbols: what vanishes with them in it is zero, but
/// [`is_number`] symbols they are not, so nothing is concluded to be positive or other than zero, and nothing is divided by
/// them ([`holds_unknown_turn`]).
///
/// [`is_number`]: Symbol::is_number
pub fn sine_cosine(angle: &Polynomial, work: &Work) -> Result<Pair, Unsupported> {
    let mut total: Pair = (Polynomial::zero(), Polynomial::one());
    for (monomial, coefficient) in angle.terms() {
        let part = match monomial.as_slice() {
            [(Symbol::Pi, 1)] => twelfths(coefficient).or_else(|| {
                work.meet_unknown_turn();
                multiples(&ONE.into(), Unit::QuarterTurn, &(coefficient * integer(2)))
            }),
            [(Symbol::Named(name), 1)] => multiples(name, Unit::Radian, coefficient),
            [(Symbol::Named(name), 1), (Symbol::Pi, 1)] => {
                multiples(name, Unit::QuarterTurn, &(coefficient * integer(2)))
            }
            _ => None,
        };
        let (sine, cosine) = part.ok_or(Unsupported::ANGLE)?;
        total = (
            work.times(&total.0, &cosine)?
                .plus(&work.times(&total.1, &sine)?),
            work.times(&total.1, &cosine)?
                .minus(&work.times(&total.0, &sine)?),
        );
    }
    Ok(total)
}

/// Whether the sine or cosine of a number is in it of which no more is known than that their squares make one.
pub fn holds_unknown_turn(polynomial: &Polynomial) -> bool {
    let mut symbols = polynomial.symbols();
    symbols.any(|symbol| symbol.variable() == Some(ONE))
}

/// Sine and cosine of `n/d` times a variable: n times the d-th fraction of its angle.
fn multiples(name: &std::sync::Arc<str>, unit: Unit, times: &Rational) -> Option<Pair> {
    let parts = u16::try_from(times.denom()).ok()?;
    let count = i64::try_from(times.numer()).ok()?;
    let size = u16::try_from(count.abs()).ok()?;
    if count.abs() > MAX_MULTIPLE {
        return None;
    }
    let angle = Angle { unit, parts };
    let one = (
        Polynomial::symbol(Symbol::Sine(name.clone(), angle)),
        Polynomial::symbol(Symbol::Cosine(name.clone(), angle)),
    );
    let (sine, cosine) = multiple(&one, size);
    Some(if count < 0 {
        (sine.negated(), cosine)
    } else {
        (sine, cosine)
    })
}

/// Sine and cosine of a multiple of pi, if it is a multiple of pi/12.
fn twelfths(times: &Rational) -> Option<Pair> {
    let twelfths = times * integer(12);
    if !twelfths.is_integer() {
        return None;
    }
    let turn = torse_numbers::rational::remainder(&twelfths.to_integer(), &Integer::from(24));
    let n = i64::try_from(&turn).ok()?;
    Some((sine(n), sine(n + 6)))
}

/// `sin(n pi/12)`.
fn sine(n: i64) -> Polynomial {
    let n = n.rem_euclid(24);
    if n > 12 {
        return sine(n - 12).negated();
    }
    let root = |p| Polynomial::symbol(Symbol::Root(p));
    let over = |p: Polynomial, d: i64| p.scaled(&Rational::new(1.into(), d.into()));
    let root_of_six = || root(2).times(&root(3));
    match n.min(12 - n) {
        0 => Polynomial::zero(),
        1 => over(root_of_six().minus(&root(2)), 4),
        2 => over(Polynomial::one(), 2),
        3 => over(root(2), 2),
        4 => over(root(3), 2),
        5 => over(root_of_six().plus(&root(2)), 4),
        _ => Polynomial::one(),
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used)]

    use super::{holds_unknown_turn, sine_cosine};
    use crate::gap::{Unsupported, Work};
    use crate::quotient::Quotient;
    use torse_certificate::polynomial::Polynomial;
    use torse_certificate::symbol::Symbol;
    use torse_numbers::rational::ratio;

    fn cosine(numerator: i64, denominator: i64) -> Polynomial {
        let times = ratio(numerator, denominator).unwrap();
        let angle = Polynomial::symbol(Symbol::Pi).scaled(&times);
        sine_cosine(&angle, &Work::new(1000)).unwrap().1
    }

    #[test]
    fn the_cosine_of_an_eighth_of_pi_is_itself_and_nothing_is_divided_by_it() {
        let eighth = cosine(1, 8);
        assert!(holds_unknown_turn(&eighth) && !eighth.is_number());
        assert!(eighth.minus(&cosine(1, 8)).is_zero());
        assert_eq!(
            Quotient::from(eighth).inverse(&Work::new(1000)),
            Err(Unsupported::ANGLE)
        );
        assert!(!holds_unknown_turn(&cosine(1, 4)));
    }
}
