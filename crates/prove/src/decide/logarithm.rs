//! Logarithms that stay symbols, see [`crate::logarithms`].

use torse_algebra::{Fraction, Symbol};

/// A logarithm that is no value of other symbols.
#[derive(Debug, Clone)]
pub struct Logarithm {
    /// The symbol.
    pub symbol: Symbol,
    /// What it is the logarithm of.
    pub argument: Fraction,
}
