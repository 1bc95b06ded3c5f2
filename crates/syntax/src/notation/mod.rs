//! Writes formulas in the derivation language, Typst, LaTeX, Rust and SymPy.
//!
//! One traversal of the tree decides by precedence where brackets are needed; a notation only defines how each
//! construct looks. A formula written in the derivation language parses to the same tree, so every formula that is
//! shown can be copied into a file.

pub mod domain;
mod latex;
mod names;
mod rust;
mod sympy;
#[cfg(test)]
mod tests;
mod text;
mod typeset;
mod typst;
mod walk;

pub use latex::latex;
pub use rust::rust;
pub use sympy::sympy;
pub use text::text;
pub use typst::typst;

use crate::formula::Expr;
use serde::Serialize;

/// A formula in the notations of the outputs.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct Formula {
    /// Plain text, the notation of the derivation files.
    pub text: String,
    /// Typst mathematics, without dollar signs.
    pub typst: String,
    /// LaTeX mathematics, without dollar signs.
    pub latex: String,
}

/// The formula in the notations of the outputs.
#[must_use]
pub fn formula(expr: &Expr) -> Formula {
    Formula {
        text: text(expr),
        typst: typst(expr),
        latex: latex(expr),
    }
}
