//! What can be wrong with a derivation file: one error type that shows file, line and caret.

use super::source::{Origin, Source};
use crate::formula::{Place, SyntaxError};
use miette::{Diagnostic, NamedSource, SourceSpan};
use std::sync::Arc;

/// A mistake in a derivation file, with the place where it stands and what would be right.
#[derive(Debug, Clone, thiserror::Error, Diagnostic)]
#[error("{message}")]
pub struct DerivationError {
    /// What is wrong.
    pub message: String,
    #[source_code]
    source_code: NamedSource<Arc<Source>>,
    #[label("{label}")]
    span: SourceSpan,
    label: String,
    #[help]
    help: Option<String>,
}

impl DerivationError {
    /// An error at a place of a formula.
    #[must_use]
    pub fn at(origin: &Origin, place: Place, message: impl Into<String>) -> Self {
        Self {
            message: message.into(),
            source_code: origin.named_source(),
            span: origin.span(place),
            label: "here".to_owned(),
            help: None,
        }
    }

    /// The same error with a hint what would be right.
    #[must_use]
    pub fn with_help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// A syntax error of a formula.
    #[must_use]
    pub fn syntax(origin: &Origin, error: &SyntaxError) -> Self {
        let shown = Self::at(origin, error.place(), error.to_string());
        match error.help() {
            Some(help) => shown.with_help(help),
            None => shown,
        }
    }
}

/// A name that a reader takes for another one. It is a name of its own, so this is no mistake.
#[derive(Debug, Clone, thiserror::Error, Diagnostic)]
#[error("`{name}` is written with {letters}, and looks like `{other}`")]
#[diagnostic(
    severity(Warning),
    help("these are two names; `{other}` is written with letters of its own")
)]
pub struct LookAlike {
    /// The name as it stands in the file.
    pub name: String,
    /// The name that it is taken for.
    pub other: String,
    /// Which letters are not those that they seem to be, by their numbers in Unicode.
    letters: String,
    #[source_code]
    source_code: NamedSource<Arc<Source>>,
    #[label("here")]
    span: SourceSpan,
}

impl LookAlike {
    /// A name at a place of a formula, and the one that it is taken for.
    #[must_use]
    pub fn new(origin: &Origin, place: Place, name: &str, other: &str) -> Self {
        let pairs = name.chars().zip(other.chars());
        let wrong = pairs.filter(|(own, usual)| own != usual);
        let letters: Vec<String> = wrong
            .map(|(own, _)| format!("U+{:04X}", own as u32))
            .collect();
        Self {
            name: name.to_owned(),
            other: other.to_owned(),
            letters: letters.join(", "),
            source_code: origin.named_source(),
            span: origin.span(place),
        }
    }
}

/// Why a folder of derivations could not be loaded.
#[derive(Debug, thiserror::Error, Diagnostic)]
pub enum LoadError {
    /// A file or folder could not be read.
    #[error("cannot read {path}: {reason}")]
    Unreadable {
        /// The path as given.
        path: String,
        /// What the system said.
        reason: String,
    },
    /// The folder holds no paper.
    #[error("no `*/paper.toml` in {path}")]
    #[diagnostic(help("a folder of derivations has one folder a paper, each with a paper.toml"))]
    Empty {
        /// The path as given.
        path: String,
    },
    /// A file is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Derivation(#[from] Box<DerivationError>),
}
