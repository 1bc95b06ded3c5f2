//! Evaluation and substitution.

use super::Polynomial;
use crate::scalar::Scalar;
use crate::symbol::Symbol;
use std::collections::BTreeMap;

impl Polynomial {
    /// The value with each symbol replaced by `value(symbol)`, in the context of `like` (which is
    /// returned scaled by zero for the zero polynomial). The first error of `value` is returned.
    ///
    /// # Errors
    /// Whatever `value` returns for a symbol that has no value.
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
        // Powers of each symbol are made once and shared by all terms.
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

    /// The polynomial with each symbol for which `value` answers replaced by that polynomial.
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

    /// The terms by the powers of some symbols, chosen by their places: the exponents of these, and what stands beside them,
    /// which is never multiplied out again.
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
