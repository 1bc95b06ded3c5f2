//! The formula language: text to syntax tree.
//!
//! The grammar, loosest binding first: `implies`, `or`, `and`, `not`, comparisons (chains allowed),
//! `+ -`, `* /`, unary minus, `^` (to the right), calls `f(x)` and indices `R[i]`. Vectors are lists
//! `[a, b, c]`, matrices lists of rows. `H''` is the second derivative of `H` unless a symbol of that
//! very name is declared. There is no implicit multiplication.

pub mod ast;
pub mod character;
pub mod functions;
pub mod hints;
mod parser;
mod token;

pub use ast::{Connective, Expr, Node, Operator, Place, Relation};
pub use parser::parse;
pub use token::is_name;

/// The words of the language that cannot be names.
pub const WORDS: [&str; 4] = ["and", "or", "not", "implies"];

/// Why a text is not a formula.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum SyntaxError {
    /// A character that begins no token.
    #[error("`{found}` does not belong in a formula")]
    UnknownCharacter {
        /// The character.
        found: char,
        /// A hint, if there is one.
        help: Option<&'static str>,
        /// Its place.
        place: Place,
    },
    /// Something other than the expected token.
    #[error("expected {expected}, found {found}")]
    Unexpected {
        /// What would be right.
        expected: &'static str,
        /// What stands there.
        found: String,
        /// A hint, if there is one.
        help: Option<String>,
        /// Its place.
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
    /// Brackets nested too deeply.
    #[error("the formula is nested deeper than {limit} levels")]
    TooDeep {
        /// The limit.
        limit: usize,
        /// The place at which the limit is exceeded.
        place: Place,
    },
    /// The tree is too high: operations are nested too deeply, even without brackets.
    #[error("the operations of the formula are nested deeper than {limit} levels")]
    TooHigh {
        /// The limit.
        limit: usize,
        /// The place of the operations that exceed the limit.
        place: Place,
    },
    /// A formula that is too long.
    #[error("the formula has {found} numbers, names and signs; at most {limit} are read")]
    TooLong {
        /// The limit.
        limit: usize,
        /// The number of tokens found.
        found: usize,
        /// The place at which the limit is exceeded.
        place: Place,
    },
    /// A number that is too long.
    #[error("a number of {found} digits; at most {limit} are read")]
    TooManyDigits {
        /// The limit.
        limit: usize,
        /// The number of digits found.
        found: usize,
        /// Its place.
        place: Place,
    },
    /// Something other than a function is followed by arguments.
    #[error("{what} is not a function and cannot be followed by `(`")]
    NoFunction {
        /// What it is.
        what: String,
        /// What would be right.
        help: String,
        /// Its place.
        place: Place,
    },
}

impl SyntaxError {
    /// The place of the error.
    #[must_use]
    pub fn place(&self) -> Place {
        match self {
            Self::UnknownCharacter { place, .. }
            | Self::Unexpected { place, .. }
            | Self::Unclosed { place, .. }
            | Self::TooDeep { place, .. }
            | Self::TooHigh { place, .. }
            | Self::TooLong { place, .. }
            | Self::TooManyDigits { place, .. }
            | Self::NoFunction { place, .. } => *place,
        }
    }

    /// A hint at what would be correct, if there is one.
    ///
    /// ```
    /// use torse_syntax::formula::parse;
    /// let error = parse("sin^2(x)").unwrap_err();
    /// assert_eq!(error.to_string(), "the number 2 is not a function and cannot be followed by `(`");
    /// assert!(error.help().unwrap().contains("sin(x)^2"));
    /// ```
    #[must_use]
    pub fn help(&self) -> Option<String> {
        match self {
            Self::UnknownCharacter { help, .. } => help.map(str::to_owned),
            Self::Unexpected { help, .. } => help.clone(),
            Self::NoFunction { help, .. } => Some(help.clone()),
            Self::TooDeep { .. } | Self::TooHigh { .. } | Self::TooLong { .. } => Some(
                "give parts of the formula names of their own, under `let` or [define]".to_owned(),
            ),
            Self::Unclosed { .. } | Self::TooManyDigits { .. } => None,
        }
    }
}
