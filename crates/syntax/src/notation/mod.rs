//! Writes formulas in the derivation language, Rust and SymPy.
//!
//! One traversal of the tree decides by precedence where brackets are needed; a notation only defines how each
//! construct looks. A formula written in the derivation language parses to the same tree, so every formula that is
//! shown can be copied into a file.

pub mod domain;
mod names;
mod rust;
mod sympy;
#[cfg(test)]
mod tests;
mod text;
mod walk;

pub use rust::rust;
pub use sympy::sympy;
pub use text::text;

use crate::formula::Expr;
use serde::Serialize;

/// A formula that is shown: in the notation of the derivation files, which whoever shows it lays out.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct Formula {
    /// Plain text, the notation of the derivation files.
    pub text: String,
}

/// The formula in the notation of the derivation files.
#[must_use]
pub fn formula(expr: &Expr) -> Formula {
    Formula { text: text(expr) }
}
