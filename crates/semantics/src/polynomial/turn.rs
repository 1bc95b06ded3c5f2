//! Sine and cosine of sums of angles, by the addition theorems and a table for multiples of pi/12. Independent of the
//! checker and of `algebra` on purpose: do not share.

use super::Quotient;
use super::sum::{Angle, Sum, Variable};
use crate::no_value::{NoValue, Unknown, Work};
use num_traits::One;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// The largest multiple of the angle of a variable.
const MAX_MULTIPLE: i64 = 24;

type Pair = (Quotient, Quotient);

/// `(sin, cos)` of an angle in radians that is a sum of integer multiples of variables and of their quarter turns,
/// and a multiple of pi/12.
pub(super) fn sine_cosine(angle: &Quotient, work: &Work) -> Result<Pair, NoValue> {
    let unknown = || {
        NoValue::from(Unknown::NotCovered {
            what: "sine or cosine of this angle",
        })
    };
    if angle.below.as_constant().is_none() {
        return Err(unknown());
    }
    let mut total: Pair = (Quotient::number(integer(0)), Quotient::number(integer(1)));
    for (monomial, coefficient) in angle.above.terms() {
        let parts: Vec<(&Variable, u32)> = monomial.iter().map(|(s, e)| (s, *e)).collect();
        let part = match parts.as_slice() {
            [(Variable::Pi, 1)] => constant(coefficient, work)?,
            [(Variable::Named(x), 1)] => {
                let variable = |make: fn(_, _) -> Variable| make(x.clone(), Angle::Radian);
                multiple(&variable, coefficient, work)?
            }
            [(Variable::Named(x), 1), (Variable::Pi, 1)] => {
                let variable = |make: fn(_, _) -> Variable| make(x.clone(), Angle::QuarterTurn);
                multiple(&variable, &(coefficient * integer(2)), work)?
            }
            _ => None,
        };
        total = added(&total, &part.ok_or_else(unknown)?, work)?;
    }
    Ok(total)
}

/// `sin(a + b) = sin a cos b + cos a sin b`, `cos(a + b) = cos a cos b - sin a sin b`.
fn added(a: &Pair, b: &Pair, work: &Work) -> Result<Pair, NoValue> {
    let sine = a.0.times(&b.1, work)?.plus(&a.1.times(&b.0, work)?, work)?;
    let product = a.0.times(&b.0, work)?;
    let cosine = a.1.times(&b.1, work)?.plus(&product.negated(), work)?;
    Ok((sine, cosine))
}

/// `(sin, cos)` of an integer multiple of the angle of a variable.
fn multiple(
    variable: &dyn Fn(fn(crate::name::Name, Angle) -> Variable) -> Variable,
    times: &Rational,
    work: &Work,
) -> Result<Option<Pair>, NoValue> {
    let integer_multiple = times
        .is_integer()
        .then(|| i64::try_from(&times.to_integer()).ok())
        .flatten();
    let Some(count) = integer_multiple.filter(|n| n.abs() <= MAX_MULTIPLE) else {
        return Ok(None);
    };
    let sine: Quotient = Sum::variable(variable(Variable::Sine)).into();
    let cosine: Quotient = Sum::variable(variable(Variable::Cosine)).into();
    let one = if count < 0 {
        (sine.negated(), cosine)
    } else {
        (sine, cosine)
    };
    let zero = (Quotient::number(integer(0)), Quotient::number(integer(1)));
    let mut turns = 0..count.abs();
    turns
        .try_fold(zero, |sum, _| added(&sum, &one, work))
        .map(Some)
}

/// `(sin, cos)` of a multiple of pi, if it is a multiple of pi/12.
fn constant(multiple: &Rational, work: &Work) -> Result<Option<Pair>, NoValue> {
    let twelfths = multiple * integer(12);
    if !twelfths.is_integer() {
        return Ok(None);
    }
    let Ok(n) = i64::try_from(&twelfths.to_integer()) else {
        return Ok(None);
    };
    let n = n.rem_euclid(24);
    Ok(Some((
        sine_of_twelfths(n, work)?,
        sine_of_twelfths(n + 6, work)?,
    )))
}

/// `sin(n pi/12)`.
fn sine_of_twelfths(n: i64, work: &Work) -> Result<Quotient, NoValue> {
    let n = n.rem_euclid(24);
    if n > 12 {
        return Ok(sine_of_twelfths(n - 12, work)?.negated());
    }
    let root = |p| Sum::variable(Variable::Root(p));
    let part = |sum: Sum, d: i64| sum.scaled(&Rational::new(1.into(), d.into()));
    let root_of_six = root(2).times(&root(3), work)?;
    Ok(match n.min(12 - n) {
        0 => Sum::default(),
        1 => part(root_of_six.plus(&root(2).scaled(&integer(-1))), 4),
        2 => part(Sum::constant(Rational::one()), 2),
        3 => part(root(2), 2),
        4 => part(root(3), 2),
        5 => part(root_of_six.plus(&root(2)), 4),
        _ => Sum::constant(Rational::one()),
    }
    .into())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_of_twelfths_satisfies_pythagoras_and_the_doubled_angle() {
        let work = Work::new(100_000);
        for n in -30..30 {
            let pair = |n| {
                (
                    sine_of_twelfths(n, &work).unwrap(),
                    sine_of_twelfths(n + 6, &work).unwrap(),
                )
            };
            let (s, c) = pair(n);
            let square = s.times(&s, &work).unwrap();
            let square = square.plus(&c.times(&c, &work).unwrap(), &work).unwrap();
            assert_eq!(square.as_constant(), Some(integer(1)), "{n}");
            let doubled = added(&(s.clone(), c.clone()), &(s, c), &work).unwrap();
            assert_eq!(doubled, pair(2 * n), "{n}");
        }
    }
}
