//! Unknowns as functions of a symbol, see [`crate::along`].

use std::sync::Arc;

/// The type of such a function.
pub const FUNCTION: &str = "R -> R";

/// The unknowns as functions of one symbol.
#[derive(Debug, Clone)]
pub struct Along {
    /// The symbol.
    pub symbol: Arc<str>,
    /// Its name.
    pub name: String,
    /// The unknowns with the names of their functions.
    pub functions: Vec<(Arc<str>, String)>,
}

impl Along {
    /// The values that stand for the unknowns where the symbol is a variable.
    #[must_use]
    pub fn values(&self) -> Vec<(Arc<str>, String)> {
        let value = |(unknown, function): &(Arc<str>, String)| {
            (Arc::clone(unknown), format!("({function} {})", self.name))
        };
        self.functions.iter().map(value).collect()
    }
}
