//! Symbols whose values are real numbers: no integers, and no functions of integers.

use super::domain::Domain;
use torse_algebra::Symbol;

/// A symbol that takes every real number in its range as its value. Between two integers there are numbers at which nothing is stated: what
/// was found on the line for an integer, such as a number between two roots, may lie at none of its values. So a search along the
/// line takes such a symbol alone.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RealSymbol(Symbol);

impl RealSymbol {
    /// The symbol in this domain; `None` for an integer or a function of one.
    #[must_use]
    pub fn new(symbol: &Symbol, domain: &Domain<'_>) -> Option<Self> {
        let mut names = symbol.names().cloned().map(Symbol::Named);
        let is_real = !names.any(|name| domain.is_integer(&name));
        is_real.then(|| Self(symbol.clone()))
    }

    /// The symbol.
    #[must_use]
    pub fn symbol(&self) -> &Symbol {
        &self.0
    }
}
