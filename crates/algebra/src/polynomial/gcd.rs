//! Greatest common divisors.
//!
//! They keep fractions and printed formulas small; no verdict depends on them. The relations are not used: the result
//! is the gcd of the normal forms in the free polynomial ring.
//!
//! The first step computes images modulo a prime, with all symbols but one replaced by numbers: **if the leading
//! coefficient does not vanish in the image, the degree of the gcd of the images bounds the degree of the gcd in that
//! symbol from above.** Most pairs are coprime, or one divides the other, and the bounds show it. Other pairs go
//! through a primitive remainder sequence in the symbol of the smallest bound, within a budget.

use super::modular;
use super::{Polynomial, cost};
use crate::rational::integer;
use crate::symbol::Symbol;
use num_traits::Zero;

/// With more terms no remainder sequence is tried: simplification must stay cheap.
const MAX_TERMS: usize = 300;
/// The largest number of bits of a coefficient in a remainder sequence.
const MAX_BITS: usize = 2_000;

impl Polynomial {
    /// Returns a common divisor with coprime integer coefficients and positive leading coefficient. It is the
    /// greatest common divisor unless the remainder sequence would be too long; then it is one.
    ///
    /// ```
    /// use torse_algebra::Polynomial;
    /// let (x, y) = (Polynomial::named("x"), Polynomial::named("y"));
    /// let (a, b) = (&x + &y, &x - &y);
    /// assert_eq!((&a * &b).gcd(&(&a * &a)), a);
    /// ```
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        if self.is_zero() {
            return other.primitive().1;
        }
        if other.is_zero() {
            return self.primitive().1;
        }
        if cost::gcd(self, other).is_err() {
            return Self::integer(1);
        }
        let shared: Vec<&Symbol> = self
            .body
            .symbols
            .iter()
            .filter(|s| other.body.symbols.binary_search(s).is_ok())
            .collect();
        let bounds = modular::gcd_degree_bounds(self, other, &shared);
        let bounds: Vec<(u16, &Symbol)> = bounds
            .into_iter()
            .zip(shared)
            .filter(|(bound, _)| *bound > 0)
            .collect();
        let Some((_, main)) = bounds.iter().min() else {
            return Self::integer(1);
        };
        // If the bounds admit one argument as the gcd, try it.
        for (candidate, target) in [(self, other), (other, self)] {
            let allowed = candidate.body.symbols.iter().all(|s| {
                bounds
                    .iter()
                    .any(|(bound, symbol)| *symbol == s && *bound >= candidate.degree_in(s))
            });
            if allowed && target.exact_quotient(candidate).is_some() {
                return candidate.primitive().1;
            }
        }
        if self.len() > MAX_TERMS || other.len() > MAX_TERMS {
            return Self::integer(1);
        }
        self.remainder_sequence(other, main)
    }

    fn remainder_sequence(&self, other: &Self, main: &Symbol) -> Self {
        let (short, long) = if self.len() <= other.len() {
            (self, other)
        } else {
            (other, self)
        };
        let (content, part) = short.split_content(main);
        // The content of the longer one is not needed; its common divisor with the content of the shorter one
        // suffices.
        let content = long.content_with(content, main);
        let (mut a, mut b) = if long.degree_in(main) >= part.degree_in(main) {
            (long.clone(), part)
        } else {
            (part, long.clone())
        };
        while !b.is_zero() {
            if b.degree_in(main) == 0 {
                return content.primitive().1;
            }
            let Some(remainder) = a.pseudo_remainder(&b, main) else {
                return Self::integer(1);
            };
            a = b;
            b = remainder.split_content(main).1;
        }
        let (_, common) = a.split_content(main);
        (&content * &common).primitive().1
    }

    /// The gcd of the coefficients with respect to `main`, and the cofactor.
    fn split_content(&self, main: &Symbol) -> (Self, Self) {
        if self.is_zero() {
            return (Self::zero(), Self::zero());
        }
        let content = self.content_with(Self::zero(), main);
        let part = self
            .exact_quotient(&content)
            .unwrap_or_else(|| self.clone())
            .primitive()
            .1;
        (content, part)
    }

    /// The gcd of a polynomial and the coefficients with respect to `main`.
    fn content_with(&self, first: Self, main: &Symbol) -> Self {
        let coefficients = self.coefficients_in(main);
        let mut coefficients: Vec<&Self> = coefficients.iter().filter(|c| !c.is_zero()).collect();
        // Short coefficients first: their common divisor is found soonest, and is mostly one.
        coefficients.sort_by_key(|c| c.len());
        coefficients.into_iter().fold(first, |g, c| {
            if g.as_constant().is_some_and(|v| !v.is_zero()) {
                g
            } else {
                g.gcd(c)
            }
        })
    }

    /// The remainder of `lead^n * self` divided by `divisor`; `None` if it exceeds the limits.
    fn pseudo_remainder(&self, divisor: &Self, main: &Symbol) -> Option<Self> {
        let divisor_coefficients = divisor.coefficients_in(main);
        let lead = divisor_coefficients.last()?;
        let degree = divisor.degree_in(main);
        let mut remainder = self.clone();
        while !remainder.is_zero() && remainder.degree_in(main) >= degree {
            if remainder.len() > 4 * MAX_TERMS || remainder.largest_bits() > MAX_BITS {
                return None;
            }
            let step = remainder.degree_in(main) - degree;
            let top = remainder.coefficients_in(main).pop()?;
            let shift = Self::symbol(main.clone()).power(u32::from(step));
            remainder = &(&remainder * lead) - &(&(&top * &shift) * divisor);
        }
        Some(remainder)
    }

    /// Whether some symbol occurs in exactly one term, and there with exponent one alone (the term is a constant
    /// multiple of the symbol). Then the polynomial is irreducible up to a constant: one factor would be free of the
    /// symbol and divide its coefficient.
    #[must_use]
    pub(crate) fn is_linear_somewhere(&self) -> bool {
        let alone = |row: &[u16]| {
            let mut columns = row
                .iter()
                .enumerate()
                .filter(|(_, exponent)| **exponent > 0);
            match (columns.next(), columns.next()) {
                (Some((column, 1)), None) => Some(column),
                _ => None,
            }
        };
        let occurs = |column: usize| {
            let rows = self
                .rows()
                .filter(|row| row.get(column).is_some_and(|e| *e > 0));
            rows.count()
        };
        self.rows()
            .filter_map(alone)
            .any(|column| occurs(column) == 1)
    }

    /// Whether the polynomial is the constant one.
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.as_constant().is_some_and(|value| value == integer(1))
    }

    /// The bits of the largest coefficient.
    fn largest_bits(&self) -> usize {
        self.body
            .coefficients
            .iter()
            .map(dashu_int::ops::BitTest::bit_len)
            .max()
            .unwrap_or(0)
    }
}
