//! Symbols as a statement binds them.

use std::sync::Arc;

/// A symbol that is bound.
#[derive(Debug, Clone)]
pub struct Binder {
    /// The declared name.
    pub symbol: Arc<str>,
    /// The names that are bound, with their type; a vector is bound coordinate by coordinate.
    pub names: Vec<String>,
    /// The type of each.
    pub rocq_type: String,
    /// For a vector, the `let` that puts its coordinates together.
    pub together: Option<String>,
}
