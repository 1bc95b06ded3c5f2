//! Constants made of rational numbers, pi and square roots: their signs, order and decimals.

use crate::polynomial::Polynomial;
use crate::ratio::Ratio;
use crate::symbol::Symbol;
use std::cmp::Ordering;
use torse_numbers::rational::integer;
use torse_numbers::{Ball, Rational, Scalar as _};
use torse_syntax::formula::Relation;

/// The precisions at which signs are determined, tried one after the other.
const BITS: [usize; 4] = [256, 1024, 4096, 16_384];

/// An enclosure of a polynomial in pi and square roots; `None` if another symbol occurs.
#[must_use]
pub fn enclosed(polynomial: &Polynomial, bits: usize) -> Option<Ball> {
    let mut sum = Ball::from_rational(&integer(0), bits);
    for (monomial, coefficient) in polynomial.terms() {
        let mut term = Ball::from_rational(coefficient, bits);
        for (symbol, exponent) in monomial {
            let value = match symbol {
                Symbol::Pi => Ball::pi(bits),
                Symbol::Root(prime) => {
                    let prime = Rational::from_integer((*prime).into());
                    Ball::from_rational(&prime, bits).sqrt().ok()?
                }
                _ => return None,
            };
            term = &term * &value.powi(*exponent);
        }
        sum = &sum + &term;
    }
    Some(sum)
}

/// The sign of a constant. The normal form decides whether it is zero: pi is transcendental, and the square roots of
/// primes are independent over the rational numbers.
#[must_use]
pub fn order(polynomial: &Polynomial) -> Option<Ordering> {
    if let Some(number) = polynomial.as_constant() {
        return Some(number.cmp(&integer(0)));
    }
    BITS.into_iter()
        .find_map(|bits| enclosed(polynomial, bits)?.sign())
}

/// The sign of a quotient of constants.
#[must_use]
pub fn ratio_order(value: &Ratio<Polynomial>) -> Option<Ordering> {
    match order(&value.below)? {
        Ordering::Equal => None,
        Ordering::Greater => order(&value.above),
        Ordering::Less => order(&value.above).map(Ordering::reverse),
    }
}

/// Whether a number of this sign has the relation to zero.
#[must_use]
pub fn holds(order: Ordering, relation: Relation) -> bool {
    match relation {
        Relation::Equal => order.is_eq(),
        Relation::Different => order.is_ne(),
        Relation::Less => order.is_lt(),
        Relation::AtMost => order.is_le(),
        Relation::Greater => order.is_gt(),
        Relation::AtLeast => order.is_ge(),
    }
}

/// An enclosure of a quotient of constants.
#[must_use]
pub fn enclosed_ratio(value: &Ratio<Polynomial>, bits: usize) -> Option<Ball> {
    enclosed(&value.above, bits)?
        .divided_by(&enclosed(&value.below, bits)?)
        .ok()
}

/// The decimals of a quotient of constants.
#[must_use]
pub fn decimal(value: &Ratio<Polynomial>, digits: usize) -> Option<String> {
    Some(enclosed_ratio(value, 256)?.decimal(digits))
}
