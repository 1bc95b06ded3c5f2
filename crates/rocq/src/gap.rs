//! Why nothing is written for a claim.

use thiserror::Error;

/// What is missing before a statement, or its proof, can be written. The words are shown as they stand.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
pub enum Untranslatable {
    /// A construct that has no translation.
    #[error("no translation of {0}")]
    Construct(&'static str),
    /// Values of different shapes meet.
    #[error("shapes that do not fit: {0}")]
    Shapes(String),
    /// A formula of the outcome cannot be read back.
    #[error("cannot be read back: {0}")]
    Unread(String),
    /// The statement is larger than anyone would read.
    #[error("the statement has more than {limit} parts")]
    Size {
        /// How many are allowed.
        limit: usize,
    },
    /// The theory library has nothing that proves such statements.
    #[error("missing theory: {0}")]
    Theory(&'static str),
    /// The verdict says nothing that could be proved.
    #[error("nothing to prove: the verdict is `{0}`")]
    NothingToProve(&'static str),
}
