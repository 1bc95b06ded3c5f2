//! Derivatives: partial derivatives by a variable, with the chain rule for its sines, cosines and exponentials.

use super::Polynomial;
use crate::fault_injection::{InjectedFault, injected};
use crate::rational::Rational;
use crate::symbol::{Symbol, Unit};
use std::sync::Arc;

impl Polynomial {
    /// The partial derivative by one symbol while all other symbols are constant.
    #[must_use]
    pub fn partial(&self, symbol: &Symbol) -> Self {
        let Ok(column) = self.body.symbols.binary_search(symbol) else {
            return Self::zero();
        };
        let mut exponents = Vec::with_capacity(self.body.exponents.len());
        let mut coefficients = Vec::with_capacity(self.len());
        for (row, coefficient) in self.rows().zip(&self.body.coefficients) {
            let power = row.get(column).copied().unwrap_or(0);
            if power > 0 {
                exponents.extend(
                    row.iter()
                        .enumerate()
                        .map(|(c, e)| if c == column { e - 1 } else { *e }),
                );
                coefficients.push(coefficient * crate::Integer::from(power));
            }
        }
        Self::normalized(
            Arc::clone(&self.body.symbols),
            exponents,
            coefficients,
            self.body.denominator.clone(),
        )
    }

    /// The derivative by the variable `name`, including the chain rule, as in sin(pi x/2)' = pi/2 cos(pi x/2).
    ///
    /// ```
    /// use torse_algebra::{Polynomial, Scalar};
    /// let x = Polynomial::named("x");
    /// let (sine, cosine) = x.quarter_turn().unwrap();
    /// assert_eq!((&x * &sine).derivative("x").to_string(), "1/2*x*pi*cos(pi/2*x) + sin(pi/2*x)");
    /// assert!((&(&sine * &sine) + &(&cosine * &cosine)).derivative("x").is_zero());
    /// ```
    #[must_use]
    pub fn derivative(&self, name: &str) -> Self {
        let mut total = self.partial(&Symbol::named(name));
        for symbol in self.body.symbols.iter().filter(|s| s.depends_on(name)) {
            let (inner, angle, sign) = match symbol {
                Symbol::Sin(name, angle) => (Symbol::Cos(Arc::clone(name), *angle), *angle, 1),
                Symbol::Cos(name, angle) => {
                    let sign = if injected(InjectedFault::CosineRate) {
                        1
                    } else {
                        -1
                    };
                    (Symbol::Sin(Arc::clone(name), *angle), *angle, sign)
                }
                Symbol::Exp(exponent) => {
                    let rate = exponent.polynomial().partial(&Symbol::named(name));
                    let own = &rate * &Self::symbol(symbol.clone());
                    total = &total + &(&self.partial(symbol) * &own);
                    continue;
                }
                _ => continue,
            };
            let part = |parts: i64| Rational::new(sign.into(), parts.into());
            let rate = match angle.unit {
                Unit::QuarterTurn => {
                    Self::symbol(Symbol::Pi).scaled(&part(2 * i64::from(angle.parts)))
                }
                Unit::Radian => Self::constant(&part(i64::from(angle.parts))),
            };
            total = &total + &(&self.partial(symbol) * &(&rate * &Self::symbol(inner)));
        }
        total
    }
}
