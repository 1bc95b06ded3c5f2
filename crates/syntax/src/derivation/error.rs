//! Errors of derivation files, shown with file, line and caret.

use super::source::{Origin, Source};
use crate::formula::{Place, SyntaxError};
use miette::{Diagnostic, NamedSource, SourceSpan};
use std::ops::Range;
use std::sync::Arc;

/// A mistake in a derivation file, its place, and a hint at what would be correct.
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

    /// Returns the file of the mistake, and the bytes of its text that are wrong.
    #[must_use]
    pub fn source_range(&self) -> (&Arc<Source>, Range<usize>) {
        source_range(&self.source_code, self.span)
    }

    /// Adds a hint at what would be correct.
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

/// A warning: a name that a reader would take for another one. It is a name of its own, so this is not an error.
#[derive(Debug, Clone, thiserror::Error, Diagnostic)]
#[error("`{name}` is written with {letters}, and looks like `{other}`")]
#[diagnostic(
    severity(Warning),
    help("these are two names; `{other}` is written with letters of its own")
)]
pub struct LookAlike {
    /// The name as it stands in the file.
    pub name: String,
    /// The name that a reader would take it for.
    pub other: String,
    /// The characters that look like other ones, by their Unicode numbers.
    letters: String,
    #[source_code]
    source_code: NamedSource<Arc<Source>>,
    #[label("here")]
    span: SourceSpan,
}

impl LookAlike {
    /// Warns of a name at a place of a formula; `other` is the name that a reader would take it for.
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

    /// Returns the file of the name, and its bytes in the text.
    #[must_use]
    pub fn source_range(&self) -> (&Arc<Source>, Range<usize>) {
        source_range(&self.source_code, self.span)
    }
}

/// A file and the bytes of a span that lie in its text.
fn source_range(
    source: &NamedSource<Arc<Source>>,
    span: SourceSpan,
) -> (&Arc<Source>, Range<usize>) {
    let source = source.inner();
    let length = source.text.len();
    let start = span.offset().min(length);
    let end = start.saturating_add(span.len()).min(length);
    (source, start..end)
}

/// Why a folder of derivations could not be loaded.
#[derive(Debug, thiserror::Error, Diagnostic)]
pub enum LoadError {
    /// A file or folder could not be read.
    #[error("cannot read {path}: {reason}")]
    Unreadable {
        /// The path as given.
        path: String,
        /// The reason that the system gave.
        reason: String,
    },
    /// The folder contains no paper.
    #[error("no `*/paper.toml` in {path}")]
    #[diagnostic(help("a folder of derivations has one folder a paper, each with a paper.toml"))]
    Empty {
        /// The path as given.
        path: String,
    },
    /// A file is invalid.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Derivation(#[from] Box<DerivationError>),
}
