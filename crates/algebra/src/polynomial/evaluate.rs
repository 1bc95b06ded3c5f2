//! Evaluation and substitution.

use super::Polynomial;
use crate::scalar::Scalar;
use crate::symbol::Symbol;

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
        for (row, coefficient) in self.rows().zip(&self.coefficients) {
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
        let scale = crate::Rational::new(crate::Integer::from(1), self.denominator.clone());
        Ok(total.scaled(&scale))
    }

    /// The polynomial with each symbol for which `value` answers replaced by that polynomial.
    #[must_use]
    pub fn substituted(&self, value: impl Fn(&Symbol) -> Option<Polynomial>) -> Self {
        if !self.symbols.iter().any(|s| value(s).is_some()) {
            return self.clone();
        }
        let replaced = self.evaluate(&Self::integer(1), |symbol| {
            Ok::<_, std::convert::Infallible>(
                value(symbol).unwrap_or_else(|| Self::symbol(symbol.clone())),
            )
        });
        match replaced {
            Ok(result) => result,
            Err(never) => match never {},
        }
    }
}
