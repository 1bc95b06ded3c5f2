//! Evaluation and substitution.

use super::Polynomial;
use crate::scalar::Scalar;
use crate::symbol::Symbol;
use std::collections::BTreeMap;

impl Polynomial {
    /// Evaluates with `value(symbol)` for each symbol, in the context of `like` (the zero polynomial evaluates to
    /// `like` scaled by zero).
    ///
    /// # Errors
    /// The first error that `value` returns.
    pub fn evaluate<S: Scalar, E>(
        &self,
        like: &S,
        mut value: impl FnMut(&Symbol) -> Result<S, E>,
    ) -> Result<S, E> {
        let values = self
            .body
            .symbols
            .iter()
            .map(&mut value)
            .collect::<Result<Vec<S>, E>>()?;
        // The powers of each symbol are computed once and shared by all terms.
        let mut powers: Vec<Vec<S>> = values.iter().map(|_| vec![like.one_like()]).collect();
        for (column, (list, value)) in powers.iter_mut().zip(&values).enumerate() {
            let highest = self
                .rows()
                .filter_map(|row| row.get(column))
                .max()
                .copied()
                .unwrap_or(0);
            for _ in 0..highest {
                if let Some(last) = list.last() {
                    list.push(last.clone() * value.clone());
                }
            }
        }
        let mut total = like.zero_like();
        for (row, coefficient) in self.rows().zip(&self.body.coefficients) {
            let mut term = like.constant(&crate::Rational::from_integer(coefficient.clone()));
            for (list, exponent) in powers.iter().zip(row) {
                if *exponent > 0
                    && let Some(power) = list.get(usize::from(*exponent))
                {
                    term = term * power.clone();
                }
            }
            total = total + term;
        }
        let scale = crate::Rational::new(crate::Integer::from(1), self.body.denominator.clone());
        Ok(total.scaled(&scale))
    }

    /// Replaces each symbol for which `value` returns a polynomial by that polynomial.
    #[must_use]
    pub fn substituted(&self, value: impl Fn(&Symbol) -> Option<Polynomial>) -> Self {
        let values: Vec<Option<Self>> = self.body.symbols.iter().map(&value).collect();
        if values.iter().all(Option::is_none) {
            return self.clone();
        }
        let mut total = Self::zero();
        for (powers, kept) in self.grouped(|place| values.get(place).is_some_and(Option::is_some)) {
            let mut term = kept;
            for (exponent, value) in powers.iter().zip(&values) {
                if let Some(value) = value {
                    for _ in 0..*exponent {
                        term = &term * value;
                    }
                }
            }
            total = &total + &term;
        }
        total
    }

    /// Groups the terms by the powers of the symbols in chosen columns. Returns the exponents of these symbols and,
    /// for each, the polynomial in the other symbols that they multiply.
    pub(crate) fn grouped(&self, chosen: impl Fn(usize) -> bool) -> Vec<(Vec<u16>, Self)> {
        let mut groups: BTreeMap<Vec<u16>, Vec<(Vec<u16>, crate::Integer)>> = BTreeMap::new();
        for (row, coefficient) in self.rows().zip(&self.body.coefficients) {
            let part = |of_chosen: bool| {
                let each = row.iter().enumerate();
                each.map(|(place, e)| if chosen(place) == of_chosen { *e } else { 0 })
                    .collect::<Vec<u16>>()
            };
            let kept = groups.entry(part(true)).or_default();
            kept.push((part(false), coefficient.clone()));
        }
        let collected = |(powers, kept)| {
            let symbols = std::sync::Arc::clone(&self.body.symbols);
            let kept = Self::collected(symbols, kept, self.body.denominator.clone());
            (powers, kept)
        };
        groups.into_iter().map(collected).collect()
    }
}
