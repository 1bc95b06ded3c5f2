//! How numbers compare: formulas of rational numbers, pi, roots and e.

use std::cmp::Ordering;
use torse_algebra::rational::integer;
use torse_algebra::{Ball, Fraction, Polynomial, Rational, Scalar as _, Symbol};
use torse_language::syntax::Relation;

/// Bits of the enclosures that decide signs of constants, tried in turn.
const BITS: [usize; 4] = [256, 1024, 4096, 16_384];

/// The enclosure of a fraction without free symbols: pi, roots and powers of e only.
#[must_use]
pub fn enclosure(value: &Fraction, bits: usize) -> Option<Ball> {
    let like = Ball::from_rational(&integer(0), bits);
    let part = |p: &Polynomial| {
        p.evaluate(&like, |symbol| match symbol {
            Symbol::Pi => Ok(Ball::pi(bits)),
            Symbol::Root(prime) => {
                Ball::from_rational(&Rational::from_integer((*prime).into()), bits)
                    .sqrt()
                    .map_err(drop)
            }
            Symbol::Exp(exponent) if symbol.is_number() => {
                let part = Rational::new(1.into(), exponent.parts().into());
                Ball::from_rational(&part, bits).exp().map_err(drop)
            }
            _ => Err(()),
        })
        .ok()
    };
    let denominator = part(&value.denominator())?;
    part(value.numerator())?.divided_by(&denominator).ok()
}

/// How a fraction without free symbols compares with zero: zero is decided by the normal form, the sign of a nonzero number
/// by an enclosure.
#[must_use]
pub fn order(value: &Fraction) -> Option<Ordering> {
    if value.is_zero() {
        return Some(Ordering::Equal);
    }
    match value.as_rational() {
        Some(number) => Some(number.cmp(&Rational::default())),
        None => BITS
            .into_iter()
            .find_map(|bits| enclosure(value, bits).and_then(|ball| ball.sign())),
    }
}

/// Whether `value relation 0` holds, for a fraction without free symbols.
#[must_use]
pub fn truth(value: &Fraction, relation: Relation) -> Option<bool> {
    let order = order(value)?;
    Some(match relation {
        Relation::Equal => order == Ordering::Equal,
        Relation::Different => order != Ordering::Equal,
        Relation::Less => order == Ordering::Less,
        Relation::AtMost => order != Ordering::Greater,
        Relation::Greater => order == Ordering::Greater,
        Relation::AtLeast => order != Ordering::Less,
    })
}
