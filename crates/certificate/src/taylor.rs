//! Signs of polynomials in a variable and its sine and cosine, by partial sums of their series.
//!
//! **Theorem.** For u > 0 the sine of u is less than `u - u^3/3! + ... + u^n/n!` and more than
//! `u - u^3/3! + ... - u^n/n!`, whichever of both a partial sum is; for u other than 0 the cosine is more than
//! `1 - u^2/2! + ... - u^n/n!`, and less than `1 - u^2/2! + ... + u^n/n!` for n > 0, and at most 1. At u = 0 they are
//! equal.
//!
//! *Proof.* The cosine is at most 1, and less but at single points. Integrated from 0 to u this says that the sine is
//! less than u; integrated again, that `1 - cos(u)` is less than `u^2/2`; and so on. The cosine is even.
//!
//! So the sine is such a sum and a *gap* that is not negative, added or subtracted. If the coefficients of a polynomial
//! in the gaps are not negative, it is not negative itself.

use crate::polynomial::Polynomial;
use crate::symbol::{Angle, Symbol, Unit};
use serde::Serialize;
use torse_numbers::Rational;
use torse_numbers::rational::integer;

/// The highest degree of a partial sum.
pub const MAX_DEGREE: u32 = 40;

/// A sine or cosine against a partial sum of its series.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct PartialSum {
    /// The sine or cosine.
    pub symbol: Symbol,
    /// The degree of the sum.
    pub degree: u32,
}

impl PartialSum {
    /// The variable whose sine or cosine it is, and whether this has to be zero or more.
    #[must_use]
    pub fn variable(&self) -> Option<(Symbol, bool)> {
        match &self.symbol {
            Symbol::Sine(name, _) => Some((Symbol::named(name), true)),
            Symbol::Cosine(name, _) => Some((Symbol::named(name), false)),
            _ => None,
        }
    }

    /// Whether the sum is below the function; `None` for a degree that the series has not.
    #[must_use]
    pub fn is_lower(&self) -> Option<bool> {
        match (&self.symbol, self.degree % 4) {
            _ if self.degree > MAX_DEGREE => None,
            (Symbol::Sine(..), 3) | (Symbol::Cosine(..), 2) => Some(true),
            (Symbol::Sine(..), 1) | (Symbol::Cosine(..), 0) => Some(false),
            _ => None,
        }
    }

    /// Whether the sum differs from the function wherever the variable is positive: 1 does not from the cosine.
    #[must_use]
    pub fn is_strict(&self) -> bool {
        self.degree > 0
    }

    /// The terms of the sum: coefficients of powers of the variable, with so many factors `pi/2`.
    pub fn terms(&self) -> impl Iterator<Item = (u32, Rational)> {
        let angle = match &self.symbol {
            Symbol::Sine(_, angle) | Symbol::Cosine(_, angle) => Some(*angle),
            _ => None,
        };
        let parts = angle.map_or(1, |angle| i64::from(angle.parts));
        let start = self.degree % 2;
        let mut coefficient = integer(1);
        let mut exponent = 0;
        let all = std::iter::from_fn(move || {
            if exponent > 0 {
                coefficient /= integer(i64::from(exponent)) * integer(parts);
            }
            exponent += 1;
            Some((exponent - 1, coefficient.clone()))
        });
        let own = all.take(usize::try_from(self.degree).map_or(0, |n| n + 1));
        let own = own.filter(move |(exponent, _)| exponent % 2 == start);
        own.map(|(exponent, coefficient)| match exponent % 4 {
            2 | 3 => (exponent, -coefficient),
            _ => (exponent, coefficient),
        })
    }

    /// Whether the angle is measured in quarter turns.
    #[must_use]
    pub fn in_quarter_turns(&self) -> bool {
        let unit = |angle: &Angle| angle.unit == Unit::QuarterTurn;
        matches!(&self.symbol, Symbol::Sine(_, angle) | Symbol::Cosine(_, angle) if unit(angle))
    }

    /// The gap, which is not negative: the function less a sum that is below it, or a sum less the function.
    #[must_use]
    pub fn gap(&self) -> Option<Polynomial> {
        let (variable, _) = self.variable()?;
        let is_lower = self.is_lower()?;
        let mut argument = Polynomial::symbol(variable);
        if self.in_quarter_turns() {
            let quarter = Polynomial::symbol(Symbol::Pi).scaled(&(integer(1) / integer(2)));
            argument = argument.times(&quarter);
        }
        let mut sum = Polynomial::zero();
        for (exponent, coefficient) in self.terms() {
            sum.add(&argument.power(exponent).scaled(&coefficient));
        }
        let function = Polynomial::symbol(self.symbol.clone());
        Some(match is_lower {
            true => function.minus(&sum),
            false => sum.minus(&function),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sums_are_those_of_the_series_on_their_sides() {
        let angle = Angle {
            unit: Unit::Radian,
            parts: 2,
        };
        let sum = |symbol: Symbol, degree| PartialSum { symbol, degree };
        let sine = Symbol::Sine("x".into(), angle);
        let gap = sum(sine.clone(), 3).gap().unwrap();
        let half = Polynomial::symbol(Symbol::named("x")).scaled(&(integer(1) / integer(2)));
        let cube = half.power(3).scaled(&(integer(1) / integer(6)));
        let own = Polynomial::symbol(sine.clone());
        assert_eq!(gap, own.minus(&half).plus(&cube));
        assert_eq!(sum(sine.clone(), 1).gap().unwrap(), half.minus(&own));
        assert_eq!(sum(sine.clone(), 2).gap(), None);
        let cosine = Symbol::Cosine("x".into(), angle);
        assert_eq!(sum(cosine.clone(), 0).is_lower(), Some(false));
        assert_eq!(sum(cosine.clone(), 2).is_lower(), Some(true));
        assert_eq!(sum(cosine.clone(), 1).gap(), None);
        // Refused before anything is added up.
        assert_eq!(sum(cosine, u32::MAX - 1).gap(), None);
    }
}
