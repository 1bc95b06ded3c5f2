//! The error of the library, with its place in a text.

use miette::{Diagnostic, SourceCode};
use serde::Serialize;
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
    /// No paper and no claim has this name.
    #[error("no paper and no claim is called `{name}`")]
    UnknownName {
        /// The name as given.
        name: String,
        /// The nearest known name.
        #[help]
        help: String,
    },
    /// A name matches several claims, where one is required.
    #[error("`{name}` matches {} claims; choose one", ids.len())]
    #[diagnostic(help("{}", ids.join("\n")))]
    Ambiguous {
        /// The name as given.
        name: String,
        /// The matching claims.
        ids: Vec<String>,
    },
    /// A letter about a paper of which nothing is decided.
    #[error("no statement of `{paper}` is decided, so that a letter would say nothing")]
    #[diagnostic(help(
        "write `states = '...'` under its claims; `torse verify {paper}` says what is still to be stated"
    ))]
    NothingDecided {
        /// The paper.
        paper: String,
    },
    /// The observer ended the work.
    #[error("cancelled")]
    Cancelled,
    /// A document could not be made.
    #[cfg(feature = "papers")]
    #[error(transparent)]
    Report(#[from] torse_report::ReportError),
    /// A design is wrong, or misses a requirement.
    #[cfg(feature = "designs")]
    #[error(transparent)]
    #[diagnostic(transparent)]
    Design(#[from] DesignFailure),
    /// Nothing can be made from these points, planes or curves.
    #[cfg(feature = "geometry")]
    #[error(transparent)]
    Geometry(#[from] torse_geometry::GeometryError),
    /// Something has no flat pattern.
    #[cfg(feature = "geometry")]
    #[error(transparent)]
    Pattern(#[from] torse_geometry::pattern::PatternError),
}

/// The place of an error in a text; lines and columns are counted from one.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct ErrorPlace {
    /// The file, or what stands in for one, such as `the statement`.
    pub file: String,
    /// The line.
    pub line: usize,
    /// The column, in characters.
    pub column: usize,
}

impl ErrorPlace {
    /// The place at a line and a column of a file.
    #[must_use]
    pub fn new(file: impl Into<String>, line: usize, column: usize) -> Self {
        let file = file.into();
        Self { file, line, column }
    }
}

/// Something that is wrong, with its place, for where it is shown beside the text.
///
/// ```
/// let wrong = torse::decide("x + wrong(y) == 1").unwrap_err().messages();
/// let json = serde_json::to_value(&wrong)?;
/// assert_eq!((&json[0]["place"]["column"], &json[0]["length"]), (&5.into(), &5.into()));
/// # Ok::<(), serde_json::Error>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[non_exhaustive]
pub struct ErrorMessage {
    /// The place, if it is in a text.
    pub place: Option<ErrorPlace>,
    /// How many characters of its line from there on are wrong; none without a place.
    pub length: usize,
    /// What is wrong, and why.
    pub text: String,
    /// What would help, if known.
    pub hint: Option<String>,
}

impl ErrorMessage {
    /// What is wrong at a place, if it has one; nothing more is known.
    #[must_use]
    pub fn new(place: Option<ErrorPlace>, text: impl Into<String>) -> Self {
        Self {
            place,
            length: 0,
            text: text.into(),
            hint: None,
        }
    }
}

impl Error {
    /// Returns everything that is wrong, each with its place: of a design the first ten mistakes.
    ///
    /// ```
    /// let error = torse::Design::read("cone.toml", "[points]\nA = [0, 0]\nB = [1]\n").unwrap_err();
    /// let lines: Vec<_> = error.messages().iter().map(|m| m.place.as_ref().map(|at| at.line)).collect();
    /// assert_eq!(lines, [Some(2), Some(3), Some(4)]);
    /// let wrong = torse::decide("x + == 1").unwrap_err().messages().remove(0);
    /// assert_eq!(wrong.place.map(|at| at.column), Some(5));
    /// ```
    #[must_use]
    pub fn messages(&self) -> Vec<ErrorMessage> {
        let related: Vec<ErrorMessage> =
            self.related().into_iter().flatten().map(message).collect();
        match related.is_empty() {
            true => vec![message(self)],
            false => related,
        }
    }

    /// Returns the place of the error; none if it is not in a text. For several mistakes of a design, the first.
    ///
    /// ```
    /// let error = torse::decide_where("x == 1", "x in [0, 1]; y >").unwrap_err();
    /// let place = error.place().ok_or("an error of a formula has a place")?;
    /// assert_eq!((place.file.as_str(), place.line, place.column), ("the setting", 1, 17));
    /// # Ok::<(), &str>(())
    /// ```
    #[must_use]
    pub fn place(&self) -> Option<ErrorPlace> {
        diagnostic_place(self)
    }

    /// Returns what would help, if known.
    #[must_use]
    pub fn hint(&self) -> Option<String> {
        let first = || {
            self.related()?
                .find_map(|related| Some(related.help()?.to_string()))
        };
        let own = Diagnostic::help(self).map(|help| help.to_string());
        own.or_else(first)
    }

    /// Says everything in plain text, for where its place cannot be shown beside it: what is wrong and why, with file,
    /// line and column, and what would help; the mistakes of a design each on a line of its own.
    ///
    /// ```
    /// let error = torse::Design::read("cone.toml", "[points]\nA = [0, 0]\nB = [1]\n").unwrap_err();
    /// let lines: Vec<String> = error.in_full().lines().map(str::to_owned).collect();
    /// assert_eq!(lines[0], "3 mistakes in the design");
    /// assert!(lines[1].starts_with("cone.toml:2:5: ") && lines[2].starts_with("cone.toml:3:5: "), "{lines:?}");
    /// ```
    #[must_use]
    pub fn in_full(&self) -> String {
        let related = self.related().into_iter().flatten();
        let lines = std::iter::once(line(self)).chain(related.map(line));
        lines.collect::<Vec<String>>().join("\n")
    }
}

/// One diagnostic with its place, its causes and its help.
fn line(diagnostic: &dyn Diagnostic) -> String {
    let place = label_place(diagnostic);
    let place = place.map(|at| format!("{}:{}:{}: ", at.file, at.line, at.column));
    let causes = std::iter::successors(diagnostic.source(), |cause| cause.source());
    let causes: String = causes.map(|cause| format!(": {cause}")).collect();
    let help = diagnostic.help().map(|help| format!(" ({help})"));
    let [place, help] = [place, help].map(Option::unwrap_or_default);
    format!("{place}{diagnostic}{causes}{help}")
}

/// One diagnostic as a message.
pub(crate) fn message(diagnostic: &dyn Diagnostic) -> ErrorMessage {
    let causes = std::iter::successors(diagnostic.source(), |cause| cause.source());
    let causes: String = causes.map(|cause| format!(": {cause}")).collect();
    ErrorMessage {
        length: label_length(diagnostic).unwrap_or_default(),
        place: label_place(diagnostic),
        text: format!("{diagnostic}{causes}"),
        hint: diagnostic.help().map(|help| help.to_string()),
    }
}

/// Where something is wrong, as its diagnostic says; of several mistakes, the first that has a place.
#[must_use]
pub fn diagnostic_place(diagnostic: &dyn Diagnostic) -> Option<ErrorPlace> {
    label_place(diagnostic).or_else(|| diagnostic.related()?.find_map(label_place))
}

/// How many characters the first label has on its first line.
fn label_length(diagnostic: &dyn Diagnostic) -> Option<usize> {
    let label = diagnostic.labels()?.next()?;
    let read = diagnostic.source_code()?.read_span(label.inner(), 0, 0);
    let read = read.ok()?;
    let text = String::from_utf8_lossy(read.data());
    Some(text.lines().next().unwrap_or_default().chars().count())
}

/// The place of the first label.
fn label_place(diagnostic: &dyn Diagnostic) -> Option<ErrorPlace> {
    let label = diagnostic.labels()?.next()?;
    let source: &dyn SourceCode = diagnostic.source_code()?;
    let read = source.read_span(label.inner(), 0, 0).ok()?;
    Some(ErrorPlace {
        file: read.name().unwrap_or_default().to_owned(),
        line: read.line() + 1,
        column: read.column() + 1,
    })
}

/// The most mistakes of a design that are shown.
#[cfg(feature = "designs")]
const MAX_MISTAKES: usize = 10;

/// An error of a design that shows its mistakes, each with its place and what would help: the first ten, and how many more
/// there are.
#[cfg(feature = "designs")]
#[derive(Debug, Failing)]
#[error(transparent)]
pub struct DesignFailure(pub Box<DesignError>);

#[cfg(feature = "designs")]
impl Diagnostic for DesignFailure {
    fn help<'a>(&'a self) -> Option<Box<dyn std::fmt::Display + 'a>> {
        if let DesignError::Wrong { mistakes } = &*self.0 {
            let more = mistakes.len().checked_sub(MAX_MISTAKES);
            let more = more.filter(|more| *more > 0)?;
            return Some(Box::new(format!("{more} more are not shown")));
        }
        let help = self.0.help()?;
        Some(Box::new(help))
    }

    fn related<'a>(&'a self) -> Option<Box<dyn Iterator<Item = &'a dyn Diagnostic> + 'a>> {
        match &*self.0 {
            DesignError::Wrong { mistakes } => Some(Box::new(
                mistakes
                    .iter()
                    .take(MAX_MISTAKES)
                    .map(|mistake| mistake as &dyn Diagnostic),
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
