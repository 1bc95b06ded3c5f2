//! Formulas written out: the derivation language, Typst, LaTeX, Rust and SymPy.
//!
//! One walk over the tree decides brackets by precedence, a notation only says how each construct
//! looks. What is written in the derivation language is read back as the same tree, so that every
//! formula the engine shows can be put into a file.

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
