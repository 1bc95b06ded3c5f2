//! Why LaTeX is not read as a formula.

use crate::formula::Place;

/// A part of a formula in LaTeX that has no reading here.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{message}")]
pub struct LatexError {
    /// What is not understood, and why.
    pub message: String,
    /// What may be written instead.
    pub help: Option<String>,
    /// Its place in the text.
    pub place: Place,
}

impl LatexError {
    /// Makes an error without a hint.
    #[must_use]
    pub fn new(place: Place, message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            help: None,
            place,
        }
    }

    /// Adds a hint.
    #[must_use]
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }
}
