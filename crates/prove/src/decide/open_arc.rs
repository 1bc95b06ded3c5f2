//! Arcs that stay symbols, see [`crate::arcs`].

use torse_algebra::{Fraction, Symbol};
use torse_core::ArcFunction;

/// An arc tangent or an arc sine whose value was not found in other symbols.
#[derive(Debug, Clone)]
pub struct OpenArc {
    /// What it is the inverse of.
    pub function: ArcFunction,
    /// The symbol that stands for it.
    pub symbol: Symbol,
    /// Its argument.
    pub argument: Fraction,
}
