//! The relations: sin^2 = 1 - cos^2 and sqrt(p)^2 = p, used as rewriting rules from left to right.
//!
//! Each rule lowers the degree of its symbol, and no two rules share a symbol on the left. So rewriting terminates,
//! and its result does not depend on the order (the left sides are coprime powers, hence a Groebner basis).

use super::{Polynomial, cost};
use crate::rational::Integer;
use crate::symbol::Symbol;
use num_traits::One;
use std::sync::Arc;

impl Polynomial {
    /// Applies the relations until every sine and every root has degree at most one.
    pub(super) fn reduced(self) -> Self {
        let over = |column: usize| {
            let width = self.body.symbols.len();
            self.body
                .exponents
                .iter()
                .skip(column)
                .step_by(width.max(1))
                .any(|e| *e > 1)
        };
        let rules: Vec<usize> = self
            .body
            .symbols
            .iter()
            .enumerate()
            .filter(|(column, s)| matches!(s, Symbol::Sin(..) | Symbol::Root(_)) && over(*column))
            .map(|(column, _)| column)
            .collect();
        let rewritten: Vec<Symbol> = rules
            .into_iter()
            .filter_map(|column| self.body.symbols.get(column).cloned())
            .collect();
        rewritten
            .iter()
            .fold(self, |polynomial, symbol| polynomial.reduced_in(symbol))
    }

    fn reduced_in(self, symbol: &Symbol) -> Self {
        let mut symbols: Vec<Symbol> = self.body.symbols.to_vec();
        symbols.extend(symbol.partner());
        symbols.sort();
        symbols.dedup();
        let symbols: Arc<[Symbol]> = Arc::from(symbols);
        let rows = super::add::widened(&self, &symbols);
        let column = symbols.binary_search(symbol).unwrap_or(0);
        let cosine = symbol
            .partner()
            .and_then(|c| symbols.binary_search(&c).ok());
        let exponents = rows.chunks(symbols.len()).filter_map(|row| row.get(column));
        let highest = exponents.clone().copied().max().unwrap_or(0);
        let made = exponents.map(|e| usize::from(*e) / 2 + 1).sum();
        if cost::rewriting(made, highest, symbols.len()).is_err() {
            return Self::zero();
        }
        let mut terms = Vec::with_capacity(self.len());
        for (row, coefficient) in rows.chunks(symbols.len()).zip(&self.body.coefficients) {
            let mut row = row.to_vec();
            let exponent = row.get(column).copied().unwrap_or(0);
            if let Some(slot) = row.get_mut(column) {
                *slot = exponent % 2;
            }
            let squares = exponent / 2;
            match (symbol, cosine) {
                (Symbol::Root(prime), _) => {
                    terms.push((
                        row,
                        coefficient * Integer::from(*prime).pow(usize::from(squares)),
                    ));
                }
                (_, Some(cosine)) => {
                    // (1 - cos^2)^squares by the binomial theorem.
                    let mut binomial = Integer::one();
                    for j in 0..=squares {
                        let mut term = row.clone();
                        if let Some(slot) = term.get_mut(cosine) {
                            let total = slot.checked_add(2 * j);
                            if total.is_none() {
                                cost::exponent_overflow();
                            }
                            *slot = total.unwrap_or(u16::MAX);
                        }
                        let signed = if j % 2 == 0 {
                            binomial.clone()
                        } else {
                            -binomial.clone()
                        };
                        terms.push((term, coefficient * signed));
                        binomial = binomial * Integer::from(squares - j) / Integer::from(j + 1);
                    }
                }
                _ => terms.push((row, coefficient.clone())),
            }
        }
        Self::collected(symbols, terms, self.body.denominator.clone())
    }
}
