//! Symbols as binders of a statement.

use std::sync::Arc;

/// A bound symbol.
#[derive(Debug, Clone)]
pub struct Binder {
    /// The declared name.
    pub symbol: Arc<str>,
    /// The names that are bound; a vector is bound coordinate by coordinate.
    pub names: Vec<String>,
    /// The type of each.
    pub rocq_type: String,
    /// For a vector, the `let` that assembles its coordinates.
    pub together: Option<String>,
}
