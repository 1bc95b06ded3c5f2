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
        self.replaced(&Self::zero(), value)
    }

    /// The polynomial with each symbol for which `value` answers replaced, in the ring of `like` (a ring
    /// that contains polynomials). Terms are grouped by the powers of the replaced symbols, so what is
    /// kept is never multiplied out again.
    pub(crate) fn replaced<S: Scalar + From<Polynomial>>(
        &self,
        like: &S,
        value: impl Fn(&Symbol) -> Option<S>,
    ) -> S {
        let values: Vec<Option<S>> = self.body.symbols.iter().map(&value).collect();
        if values.iter().all(Option::is_none) {
            return self.clone().into();
        }
        let mut groups: BTreeMap<Vec<u16>, Vec<(Vec<u16>, crate::Integer)>> = BTreeMap::new();
        for (row, coefficient) in self.rows().zip(&self.body.coefficients) {
            let part = |replaced: bool| {
                row.iter()
                    .zip(&values)
                    .map(|(e, v)| if v.is_some() == replaced { *e } else { 0 })
                    .collect::<Vec<u16>>()
            };
            groups
                .entry(part(true))
                .or_default()
                .push((part(false), coefficient.clone()));
        }
        let mut total = like.zero_like();
        for (powers, kept) in groups {
            let kept = Self::collected(
                std::sync::Arc::clone(&self.body.symbols),
                kept,
                self.body.denominator.clone(),
            );
            let mut term = S::from(kept);
            for (exponent, value) in powers.iter().zip(&values) {
                if let Some(value) = value {
                    for _ in 0..*exponent {
                        term = term * value.clone();
                    }
                }
            }
            total = total + term;
        }
        total
    }
}
