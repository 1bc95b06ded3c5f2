//! How numbers compare: formulas of rational numbers, pi, roots, logarithms and e.

use std::cmp::Ordering;
use torse_algebra::rational::integer;
use torse_algebra::{Ball, Finest, Fraction, Polynomial, Rational, Scalar as _, Symbol};
use torse_syntax::formula::Relation;

/// Bits of the enclosures that decide signs of constants, tried in turn.
const BITS: [usize; 4] = [256, 1024, 4096, 16_384];

/// The enclosure of a fraction without free symbols: pi, roots, logarithms, arcs and powers of e only.
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
            Symbol::Log(prime) => {
                let prime = Rational::from_integer((*prime).into());
                Ball::from_rational(&prime, bits).ln().map_err(drop)
            }
            Symbol::Arc(above, below) => {
                let tangent = Rational::new((*above).into(), (*below).into());
                Ball::from_rational(&tangent, bits).atan().map_err(drop)
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

/// How a fraction without free symbols compares with zero: zero is decided by the normal form with each exponent in its
/// finest part, the sign of a nonzero number by an enclosure.
#[must_use]
pub fn order(value: &Fraction) -> Option<Ordering> {
    if let Some(number) = value.as_rational() {
        return Some(number.cmp(&Rational::default()));
    }
    let symbols = value.symbols();
    if !symbols.iter().all(Symbol::is_number) {
        return None;
    }
    let value = Finest::new(symbols.iter()).write(value)?;
    if value.is_zero() {
        return Some(Ordering::Equal);
    }
    BITS.into_iter()
        .find_map(|bits| enclosure(&value, bits)?.sign())
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

#[cfg(test)]
mod tests {
    use super::*;
    use torse_algebra::rational::ratio;

    fn power_of_e(n: i64, d: i64) -> Fraction {
        let exponent = Fraction::integer(n).scaled(&ratio(1, d).unwrap());
        exponent.exponential().unwrap()
    }

    #[test]
    fn powers_of_e_in_different_parts_are_told_equal() {
        let sixth = power_of_e(1, 6);
        let difference = power_of_e(1, 3) - sixth.clone() * sixth.clone();
        assert_eq!(order(&difference), Some(Ordering::Equal));
        assert_eq!(order(&(power_of_e(1, 3) - sixth)), Some(Ordering::Greater));
    }

    #[test]
    fn what_varies_has_no_order() {
        assert_eq!(order(&Fraction::named("x")), None);
    }
}
