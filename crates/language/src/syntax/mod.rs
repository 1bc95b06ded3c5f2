//! The formula language: text to syntax tree.
//!
//! The grammar, loosest binding first: `implies`, `or`, `and`, `not`, comparisons (chains allowed),
//! `+ -`, `* /`, unary minus, `^` (to the right), calls `f(x)` and indices `R[i]`. Vectors are lists
//! `[a, b, c]`, matrices lists of rows. `H''` is the second derivative of `H` unless a symbol of that
//! very name is declared. There is no implicit multiplication.

pub mod ast;
mod parser;
mod token;

pub use ast::{Connective, Expr, Node, Operator, Place, Relation};
pub use parser::parse;

/// Why a text is not a formula.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SyntaxError {
    /// A character that starts no token.
    #[error("`{found}` does not belong in a formula")]
    UnknownCharacter {
        /// The character.
        found: char,
        /// Where.
        place: Place,
    },
    /// Something else was expected here.
    #[error("expected {expected}, found {found}")]
    Unexpected {
        /// What would be right.
        expected: &'static str,
        /// What stands there.
        found: String,
        /// Where.
        place: Place,
    },
    /// A bracket that is never closed.
    #[error("this `{bracket}` is never closed")]
    Unclosed {
        /// The bracket.
        bracket: &'static str,
        /// Where it opens.
        place: Place,
    },
    /// Brackets nested too deeply, or a formula that is too long.
    #[error("the formula is nested deeper than {limit} levels")]
    TooDeep {
        /// The limit.
        limit: usize,
        /// Where it was passed.
        place: Place,
    },
}

impl SyntaxError {
    /// Where the text is wrong.
    #[must_use]
    pub fn place(&self) -> Place {
        match self {
            Self::UnknownCharacter { place, .. }
            | Self::Unexpected { place, .. }
            | Self::Unclosed { place, .. }
            | Self::TooDeep { place, .. } => *place,
        }
    }
}
