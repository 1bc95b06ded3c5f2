//! Greatest common divisors by primitive remainder sequences, recursively in the main symbol.
//!
//! Used to keep fractions and printed formulas small; no verdict depends on it. The relations are not
//! used: the gcd is that of the normal forms in the free polynomial ring.

use super::Polynomial;
use crate::rational::integer;
use crate::symbol::Symbol;
use num_traits::Zero;

/// Above this many terms the gcd is not attempted: simplification must stay cheap.
const MAX_TERMS: usize = 400;

impl Polynomial {
    /// A greatest common divisor with coprime integer coefficients and positive leading coefficient.
    /// For very large arguments (more than a few hundred terms) the answer is one.
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
        if self.len() > MAX_TERMS || other.len() > MAX_TERMS {
            return Self::integer(1);
        }
        // A main symbol that both contain; without one the gcd is constant.
        let Some(main) = self
            .symbols
            .iter()
            .find(|s| other.symbols.binary_search(s).is_ok())
            .cloned()
        else {
            return Self::integer(1);
        };
        let (content_a, part_a) = self.split_content(&main);
        let (content_b, part_b) = other.split_content(&main);
        let content = content_a.gcd(&content_b);
        let (mut a, mut b) = if part_a.degree_in(&main) >= part_b.degree_in(&main) {
            (part_a, part_b)
        } else {
            (part_b, part_a)
        };
        while !b.is_zero() {
            if b.degree_in(&main) == 0 {
                return content.primitive().1;
            }
            let Some(remainder) = a.pseudo_remainder(&b, &main) else {
                return Self::integer(1);
            };
            a = b;
            b = remainder.split_content(&main).1;
        }
        (&content * &a).primitive().1
    }

    /// The gcd of the coefficients with respect to `main`, and the cofactor.
    fn split_content(&self, main: &Symbol) -> (Self, Self) {
        if self.is_zero() {
            return (Self::zero(), Self::zero());
        }
        let content = self
            .coefficients_in(main)
            .iter()
            .filter(|c| !c.is_zero())
            .fold(Self::zero(), |g, c| {
                if g.as_constant().is_some_and(|v| !v.is_zero()) {
                    g
                } else {
                    g.gcd(c)
                }
            });
        let part = self
            .exact_quotient(&content)
            .unwrap_or_else(|| self.clone())
            .primitive()
            .1;
        (content, part)
    }

    /// The remainder of `lead^n * self` divided by `divisor`; `None` when it grows past the limit.
    fn pseudo_remainder(&self, divisor: &Self, main: &Symbol) -> Option<Self> {
        let divisor_coefficients = divisor.coefficients_in(main);
        let lead = divisor_coefficients.last()?;
        let degree = divisor.degree_in(main);
        let mut rest = self.clone();
        while !rest.is_zero() && rest.degree_in(main) >= degree {
            if rest.len() > 4 * MAX_TERMS {
                return None;
            }
            let step = rest.degree_in(main) - degree;
            let top = rest.coefficients_in(main).pop()?;
            let shift = Self::symbol(main.clone()).power(u32::from(step));
            rest = &(&rest * lead) - &(&(&top * &shift) * divisor);
        }
        Some(rest)
    }

    /// Whether the polynomial is the constant one.
    #[must_use]
    pub fn is_one(&self) -> bool {
        self.as_constant().is_some_and(|value| value == integer(1))
    }
}
