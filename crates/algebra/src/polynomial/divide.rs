//! Exact division: long division by leading terms that stops as soon as a term does not divide.
//!
//! The quotient is found in the free polynomial ring. A quotient there is a quotient modulo the
//! relations too, so a result is always right; `None` means only that no quotient without use of the
//! relations exists.

use super::{Polynomial, cost};
use crate::rational::Rational;
use crate::symbol::Symbol;
use num_traits::Zero;
use std::collections::BTreeMap;

/// The most steps one division may take; it ends long before in every use the engine makes of it.
const MAX_STEPS: usize = 200_000;

impl Polynomial {
    /// `self / divisor` if the division leaves no remainder, without use of the relations.
    ///
    /// ```
    /// use torse_algebra::Polynomial;
    /// let (x, y) = (Polynomial::named("x"), Polynomial::named("y"));
    /// let product = &(&x + &y) * &(&x - &y);
    /// assert_eq!(product.exact_quotient(&(&x - &y)), Some(&x + &y));
    /// assert_eq!(x.exact_quotient(&y), None);
    /// ```
    #[must_use]
    pub fn exact_quotient(&self, divisor: &Self) -> Option<Self> {
        if let Some(value) = divisor.as_constant() {
            return (!value.is_zero()).then(|| self.scaled(&value.recip()));
        }
        if self.is_zero() {
            return Some(Self::zero());
        }
        // A symbol of the divisor that does not occur in the dividend rules division out at once.
        if divisor
            .symbols
            .iter()
            .any(|s| divisor.degree_in(s) > self.degree_in(s))
        {
            return None;
        }
        let symbols = &self.symbols;
        let rows = |p: &Self| -> Vec<(Vec<u16>, Rational)> {
            let wide = super::add::widened(p, symbols);
            wide.chunks(symbols.len())
                .zip(&p.coefficients)
                .map(|(row, c)| {
                    (
                        row.to_vec(),
                        Rational::new(c.clone(), p.denominator.clone()),
                    )
                })
                .collect()
        };
        let divisor_rows = rows(divisor);
        let (lead, lead_coefficient) = divisor_rows.first()?;
        let mut rest: BTreeMap<Vec<u16>, Rational> = rows(self).into_iter().collect();
        let mut quotient: Vec<(Vec<u16>, Rational)> = vec![];
        for _ in 0..MAX_STEPS {
            let Some((row, coefficient)) = rest.pop_last() else {
                return Some(Self::from_rational_terms(symbols, quotient));
            };
            let step: Vec<u16> = row
                .iter()
                .zip(lead)
                .map(|(a, b)| a.checked_sub(*b))
                .collect::<Option<_>>()?;
            cost::division_step(divisor);
            let factor = &coefficient / lead_coefficient;
            for (other, c) in divisor_rows.iter().skip(1) {
                let target: Vec<u16> = step
                    .iter()
                    .zip(other)
                    .map(|(a, b)| a.saturating_add(*b))
                    .collect();
                let slot = rest.entry(target);
                match slot {
                    std::collections::btree_map::Entry::Vacant(slot) => {
                        slot.insert(-(&factor * c));
                    }
                    std::collections::btree_map::Entry::Occupied(mut slot) => {
                        let value = slot.get() - &factor * c;
                        if value.is_zero() {
                            slot.remove();
                        } else {
                            *slot.get_mut() = value;
                        }
                    }
                }
            }
            quotient.push((step, factor));
        }
        None
    }

    /// Collects terms with rational coefficients.
    fn from_rational_terms(
        symbols: &std::sync::Arc<[Symbol]>,
        terms: Vec<(Vec<u16>, Rational)>,
    ) -> Self {
        use num_integer::Integer as _;
        let denominator = terms
            .iter()
            .fold(<crate::Integer as num_traits::One>::one(), |d, (_, c)| {
                d.lcm(c.denom())
            });
        let terms = terms
            .into_iter()
            .map(|(row, c)| (row, c.numer() * (&denominator / c.denom())))
            .collect();
        Self::collected(std::sync::Arc::clone(symbols), terms, denominator)
    }
}
