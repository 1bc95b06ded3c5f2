//! Signs of polynomials in a variable and its sine, cosine and exponential, by partial sums of their series.
//!
//! **Theorem.** For u > 0 the sine of u is less than `u - u^3/3! + ... + u^n/n!` and more than
//! `u - u^3/3! + ... - u^n/n!`, whichever of both a partial sum is; for u other than 0 the cosine is more than
//! `1 - u^2/2! + ... - u^n/n!`, and less than `1 - u^2/2! + ... + u^n/n!` for n > 0, and at most 1. At u = 0 they are
//! equal. For u > 0 the exponential of u is more than each partial sum `1 + u + ... + u^n/n!`, and for odd n also for u < 0; at
//! u = 0 they are equal.
//!
//! *Proof.* The cosine is at most 1, and less but at single points. Integrated from 0 to u this says that the sine is
//! less than u; integrated again, that `1 - cos(u)` is less than `u^2/2`; and so on. The cosine is even. The remainder of the
//! exponential is, by Lagrange, `exp(z)*u^(n + 1)/(n + 1)!` with some z between 0 and u.
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

/// A sine, a cosine or an exponential against a partial sum of its series.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct PartialSum {
    /// The sine, cosine or exponential.
    pub symbol: Symbol,
    /// What an exponential is the power of.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub exponent: Option<Exponent>,
    /// The degree of the sum.
    pub degree: u32,
}

/// A variable over a positive integer.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Exponent {
    /// The name of the variable.
    pub variable: Box<str>,
    /// What it is divided by.
    pub parts: u16,
}

impl PartialSum {
    /// The variable whose function it is, and whether this has to be zero or more.
    #[must_use]
    pub fn variable(&self) -> Option<(Symbol, bool)> {
        match (&self.symbol, &self.exponent) {
            (Symbol::Sine(name, _), _) => Some((Symbol::named(name), true)),
            (Symbol::Cosine(name, _), _) => Some((Symbol::named(name), false)),
            (Symbol::Exponential(_), Some(exponent)) => {
                let from_zero = self.degree.is_multiple_of(2);
                Some((Symbol::named(&exponent.variable), from_zero))
            }
            _ => None,
        }
    }

    /// Whether the sum is below the function; `None` for a degree that the series has not.
    #[must_use]
    pub fn is_lower(&self) -> Option<bool> {
        match (&self.symbol, self.degree % 4) {
            _ if self.degree > MAX_DEGREE => None,
            (Symbol::Exponential(_), _) => Some(true),
            (Symbol::Sine(..), 3) | (Symbol::Cosine(..), 2) => Some(true),
            (Symbol::Sine(..), 1) | (Symbol::Cosine(..), 0) => Some(false),
            _ => None,
        }
    }

    /// Whether the sum differs from the function wherever the variable is positive: 1 does not from the cosine.
    #[must_use]
    pub fn is_strict(&self) -> bool {
        self.degree > 0 || self.exponent.is_some()
    }

    /// The terms of the sum: coefficients of powers of the variable, with so many factors `pi/2`.
    pub fn terms(&self) -> impl Iterator<Item = (u32, Rational)> {
        let parts = match (&self.symbol, &self.exponent) {
            (Symbol::Sine(_, angle) | Symbol::Cosine(_, angle), _) => angle.parts,
            (_, Some(exponent)) => exponent.parts,
            _ => 1,
        };
        let parts = i64::from(parts);
        let (start, is_exponential) = (self.degree % 2, self.exponent.is_some());
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
        let own = own.filter(move |(exponent, _)| is_exponential || exponent % 2 == start);
        own.map(move |(exponent, coefficient)| match exponent % 4 {
            2 | 3 if !is_exponential => (exponent, -coefficient),
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
        let sum = |symbol: Symbol, degree| PartialSum {
            symbol,
            exponent: None,
            degree,
        };
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

    #[test]
    fn all_sums_of_an_exponential_are_below_it_those_of_even_degree_where_the_exponent_is_positive()
    {
        let sum = |degree| PartialSum {
            symbol: Symbol::Exponential("exp(1/2*x)".into()),
            exponent: Some(Exponent {
                variable: "x".into(),
                parts: 2,
            }),
            degree,
        };
        let rational = |p: i64, q: i64| integer(p) / integer(q);
        let x = Symbol::named("x");
        let coefficients = [
            (0, rational(1, 1)),
            (1, rational(1, 2)),
            (2, rational(1, 8)),
        ];
        assert_eq!(sum(2).terms().collect::<Vec<_>>(), coefficients);
        assert_eq!(sum(2).variable(), Some((x.clone(), true)));
        assert_eq!(sum(3).variable(), Some((x, false)));
        assert_eq!(sum(3).is_lower(), Some(true));
        assert!(sum(0).is_strict());
    }
}
