//! Roots that stay symbols, see [`crate::roots`].

use torse_algebra::{Fraction, Symbol};

/// A root that is no value of other symbols.
#[derive(Debug, Clone)]
pub struct Root {
    /// The symbol.
    pub symbol: Symbol,
    /// What it is the root of.
    pub radicand: Fraction,
}
