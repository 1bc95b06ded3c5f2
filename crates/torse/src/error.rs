//! What can go wrong, for all doors: one error with its place.

use miette::{Diagnostic, SourceCode};
use thiserror::Error as Failing;
#[cfg(feature = "designs")]
use torse_designs::DesignError;
use torse_syntax::derivation::{DerivationError, LoadError};

/// Why there is no answer.
#[derive(Debug, Failing, Diagnostic)]
#[non_exhaustive]
pub enum Error {
    /// A statement, a setting or the files of a paper cannot be read.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Load(#[from] LoadError),
    /// A formula can be read and makes no sense.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Formula(#[from] Box<DerivationError>),
    /// A name that no paper and no claim has.
    #[error("no paper and no claim is called `{name}`")]
    UnknownName {
        /// The name as given.
        name: String,
        /// What may have been meant.
        #[help]
        help: String,
    },
    /// A name that means several claims, where one is wanted.
    #[error("`{name}` means {} claims; one is wanted", ids.len())]
    #[diagnostic(help("{}", ids.join("\n")))]
    Ambiguous {
        /// The name as given.
        name: String,
        /// The claims it means.
        ids: Vec<String>,
    },
    /// The callback that watched the work has ended it.
    #[error("cancelled")]
    Cancelled,
    /// A document cannot be made.
    #[cfg(feature = "papers")]
    #[error(transparent)]
    Report(#[from] torse_report::ReportError),
    /// A design is wrong, or misses what is asked of it.
    #[cfg(feature = "designs")]
    #[error(transparent)]
    #[diagnostic(transparent)]
    Design(#[from] DesignFailure),
    /// Points, planes or curves of which nothing can be made.
    #[cfg(feature = "geometry")]
    #[error(transparent)]
    Geometry(#[from] torse_geometry::GeometryError),
    /// Something has no flat pattern.
    #[cfg(feature = "geometry")]
    #[error(transparent)]
    Pattern(#[from] torse_geometry::pattern::PatternError),
}

/// Where in a text something is wrong; lines and columns are counted from one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ErrorPlace {
    /// The file, or what stands in for one, such as `the statement`.
    pub file: String,
    /// The line.
    pub line: usize,
    /// The column, in characters.
    pub column: usize,
}

impl Error {
    /// Where it is wrong; none where that is not a place in a text. Of several mistakes of a design, the first.
    ///
    /// ```
    /// let error = torse::decide("x + == 1").unwrap_err();
    /// let place = error.place().ok_or("an error of a formula has a place")?;
    /// assert_eq!(place.file, "the statement");
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn place(&self) -> Option<ErrorPlace> {
        place(self).or_else(|| self.related()?.find_map(place))
    }

    /// What would help, if that is known.
    #[must_use]
    pub fn hint(&self) -> Option<String> {
        let first = || {
            self.related()?
                .find_map(|related| Some(related.help()?.to_string()))
        };
        let own = Diagnostic::help(self).map(|help| help.to_string());
        own.or_else(first)
    }
}

/// The place of the first label.
fn place(diagnostic: &dyn Diagnostic) -> Option<ErrorPlace> {
    let label = diagnostic.labels()?.next()?;
    let source: &dyn SourceCode = diagnostic.source_code()?;
    let read = source.read_span(label.inner(), 0, 0).ok()?;
    Some(ErrorPlace {
        file: read.name().unwrap_or_default().to_owned(),
        line: read.line() + 1,
        column: read.column() + 1,
    })
}

/// An error of a design that shows all its mistakes, each with its place and what would help.
#[cfg(feature = "designs")]
#[derive(Debug, Failing)]
#[error(transparent)]
pub struct DesignFailure(pub Box<DesignError>);

#[cfg(feature = "designs")]
impl Diagnostic for DesignFailure {
    fn help<'a>(&'a self) -> Option<Box<dyn std::fmt::Display + 'a>> {
        let help = self.0.help()?;
        Some(Box::new(help))
    }

    fn related<'a>(&'a self) -> Option<Box<dyn Iterator<Item = &'a dyn Diagnostic> + 'a>> {
        match &*self.0 {
            DesignError::Wrong { mistakes } => Some(Box::new(
                mistakes.iter().map(|mistake| mistake as &dyn Diagnostic),
            )),
            _ => None,
        }
    }
}

#[cfg(feature = "designs")]
impl From<DesignError> for DesignFailure {
    fn from(error: DesignError) -> Self {
        Self(Box::new(error))
    }
}

#[cfg(feature = "designs")]
impl From<DesignError> for Error {
    fn from(error: DesignError) -> Self {
        Self::Design(error.into())
    }
}
