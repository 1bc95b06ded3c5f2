//! Why nothing is written for a claim.

use thiserror::Error;

/// What is missing for a statement or its proof. The words are shown as they stand.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum Untranslatable {
    /// A construct that has no translation.
    #[error("no translation of {0}")]
    Construct(&'static str),
    /// The shapes of two values differ.
    #[error("shapes that do not fit: {0}")]
    Shapes(String),
    /// A formula of the outcome cannot be read back.
    #[error("cannot be read back: {0}")]
    Unread(String),
    /// The statement is too large to be read.
    #[error("the statement has more than {limit} parts")]
    Size {
        /// The maximum.
        limit: usize,
    },
    /// The library has nothing that proves such statements.
    #[error("missing theory: {0}")]
    Theory(&'static str),
    /// The verdict says nothing that could be proved.
    #[error("nothing to prove: the verdict is `{0}`")]
    NothingToProve(&'static str),
}
