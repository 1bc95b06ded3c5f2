//! Logarithms that stay symbols, see [`crate::logarithms`].

use torse_algebra::{Fraction, Symbol};

/// A logarithm whose value was not found in other symbols.
#[derive(Debug, Clone)]
pub struct Logarithm {
    /// The symbol.
    pub symbol: Symbol,
    /// What it is the logarithm of.
    pub argument: Fraction,
}
