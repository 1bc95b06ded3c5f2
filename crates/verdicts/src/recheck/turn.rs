//! Sine and cosine of sums of angles, by the addition theorems and a table of twelfths of pi.

use super::Obstacle;
use super::number::{Quotient, Sum, Work};
use torse_algebra::{Angle, Rational, Symbol, rational};

/// The largest multiple of a variable angle.
const MAX_MULTIPLE: i64 = 24;

type Pair = (Quotient, Quotient);

/// `(sin, cos)` of an angle in radians: integer multiples of variables and of their quarter turns, and
/// multiples of pi/12.
pub fn sine_cosine(angle: &Quotient, work: &Work) -> Result<Pair, Obstacle> {
    let unknown = || Obstacle::NotCovered {
        what: "sine or cosine of this angle".to_owned(),
    };
    if angle.below.as_constant().is_none() {
        return Err(unknown());
    }
    let mut total: Pair = (Quotient::integer(0), Quotient::integer(1));
    for (monomial, coefficient) in angle.above.terms() {
        let parts: Vec<(&Symbol, u32)> = monomial.iter().map(|(s, e)| (s, *e)).collect();
        let part = match parts.as_slice() {
            [(Symbol::Pi, 1)] => constant(coefficient).ok_or_else(unknown)?,
            [(Symbol::Named(x), 1)] => {
                multiple(x, Angle::Radian, coefficient, work)?.ok_or_else(unknown)?
            }
            [(Symbol::Named(x), 1), (Symbol::Pi, 1)] => {
                let quarters = coefficient * rational::integer(2);
                multiple(x, Angle::QuarterTurn, &quarters, work)?.ok_or_else(unknown)?
            }
            _ => return Err(unknown()),
        };
        total = added(&total, &part, work)?;
    }
    Ok(total)
}

/// `sin(a + b) = sin a cos b + cos a sin b`, `cos(a + b) = cos a cos b - sin a sin b`.
fn added(a: &Pair, b: &Pair, work: &Work) -> Result<Pair, Obstacle> {
    let sine = a.0.times(&b.1, work)?.plus(&a.1.times(&b.0, work)?, work)?;
    let cosine =
        a.1.times(&b.1, work)?
            .plus(&a.0.times(&b.0, work)?.negated(), work)?;
    Ok((sine, cosine))
}

/// An integer multiple of the angle of a variable.
fn multiple(
    x: &str,
    angle: Angle,
    times: &Rational,
    work: &Work,
) -> Result<Option<Pair>, Obstacle> {
    let whole = times
        .is_integer()
        .then(|| i64::try_from(times.to_integer()).ok())
        .flatten();
    let Some(count) = whole.filter(|n| n.abs() <= MAX_MULTIPLE) else {
        return Ok(None);
    };
    let sine: Quotient = Sum::symbol(Symbol::Sin(x.into(), angle)).into();
    let cosine: Quotient = Sum::symbol(Symbol::Cos(x.into(), angle)).into();
    let one = if count < 0 {
        (sine.negated(), cosine)
    } else {
        (sine, cosine)
    };
    let zero = (Quotient::integer(0), Quotient::integer(1));
    (0..count.abs())
        .try_fold(zero, |sum, _| added(&sum, &one, work))
        .map(Some)
}

/// `(sin, cos)` of this multiple of pi.
fn constant(multiple: &Rational) -> Option<Pair> {
    let twelfths = multiple * rational::integer(12);
    let n = twelfths
        .is_integer()
        .then(|| i64::try_from(twelfths.to_integer()).ok())??;
    Some((sine_of_twelfths(n), sine_of_twelfths(n + 6)))
}

/// `sin(n pi/12)`.
fn sine_of_twelfths(n: i64) -> Quotient {
    let n = n.rem_euclid(24);
    if n > 12 {
        return sine_of_twelfths(n - 12).negated();
    }
    let root = |p| Sum::symbol(Symbol::Root(p));
    let part = |sum: Sum, d: i64| sum.scaled(&Rational::new(1.into(), d.into()));
    let root_of_six = || {
        root(2)
            .times(&root(3), &Work::default())
            .unwrap_or_default()
    };
    match n.min(12 - n) {
        0 => Sum::default(),
        1 => part(
            root_of_six().plus(&root(2).scaled(&rational::integer(-1))),
            4,
        ),
        2 => part(Sum::constant(rational::integer(1)), 2),
        3 => part(root(2), 2),
        4 => part(root(3), 2),
        5 => part(root_of_six().plus(&root(2)), 4),
        _ => Sum::constant(rational::integer(1)),
    }
    .into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_of_twelfths_satisfies_pythagoras_and_the_doubled_angle() {
        let work = Work::default();
        for n in -30..30 {
            let (s, c) = (sine_of_twelfths(n), sine_of_twelfths(n + 6));
            let square = s
                .times(&s, &work)
                .unwrap()
                .plus(&c.times(&c, &work).unwrap(), &work)
                .unwrap();
            assert_eq!(square.as_constant(), Some(rational::integer(1)), "{n}");
            let doubled = added(&(s.clone(), c.clone()), &(s, c), &work).unwrap().0;
            let gap = doubled
                .plus(&sine_of_twelfths(2 * n).negated(), &work)
                .unwrap();
            assert!(gap.is_zero(), "{n}");
        }
    }
}
