//! Why a design cannot be used.

use std::path::PathBuf;
use torse_exchange::{ExchangeError, FileKind, ReadError};
use torse_geometry::GeometryError;
use torse_geometry::pattern::PatternError;
use torse_plot::FigureError;
use torse_syntax::derivation::DerivationError;
use torse_syntax::similar::similar;

/// What ends a command before it has an answer, or is the answer.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum DesignError {
    /// The file is not there, or no text.
    #[error("cannot read {path}: {reason}")]
    Unreadable {
        /// The path as given.
        path: String,
        /// What the system said.
        reason: String,
    },
    /// The file is a file of another kind.
    #[error(
        "{path} is {kind}, and a design is a TOML file; curves are read from {} files too",
        FileKind::READ
    )]
    OtherKind {
        /// The path as given.
        path: String,
        /// What the file is.
        kind: FileKind,
    },
    /// A file of another program has no face with rulings between its edges.
    #[error("{path} has no face that can be unrolled: {}", reasons.join("; "))]
    NoFace {
        /// The path as given.
        path: String,
        /// Why, face by face.
        reasons: Vec<String>,
    },
    /// A file of another program cannot be read.
    #[error("{path}: {reason}")]
    Listing {
        /// The path as given.
        path: String,
        /// Why.
        reason: ReadError,
    },
    /// The file is wrong.
    #[error("{} mistake{} in the design", mistakes.len(), if mistakes.len() == 1 { "" } else { "s" })]
    Wrong {
        /// All of it, in the order of the file.
        mistakes: Vec<DerivationError>,
    },
    /// A file name whose extension is not a format of the command.
    #[error("unknown file extension: {}", path.display())]
    Format {
        /// The file.
        path: PathBuf,
        /// The endings.
        known: &'static [&'static str],
    },
    /// A name that no patch, piece or number has.
    #[error("no {what} of the design is called `{name}`")]
    NoSuch {
        /// What was looked for.
        what: &'static str,
        /// The name as given.
        name: String,
        /// The names there are.
        known: Vec<String>,
    },
    /// The name of a face that is there, and left out.
    #[error("`{name}` is left out: {reason}")]
    LeftOut {
        /// The face.
        name: String,
        /// Why.
        reason: String,
    },
    /// A number of the command line is outside its range.
    #[error("{name} = {value} is outside {range}")]
    OutOfRange {
        /// What it is.
        name: &'static str,
        /// Its value.
        value: f64,
        /// The range.
        range: &'static str,
    },
    /// A patch has no value where one is asked for.
    #[error("patch `{patch}`: {reason}")]
    Patch {
        /// The patch.
        patch: String,
        /// Why.
        reason: GeometryError,
    },
    /// A piece cannot be unrolled: the design misses what is demanded of it.
    #[error("`{piece}` cannot be unrolled: {reason}")]
    Unroll {
        /// The chain or the patch.
        piece: String,
        /// Why.
        reason: PatternError,
        /// The strain that has to be allowed for all pieces to be unrolled, where that is what is missing.
        needed: Option<f64>,
    },
    /// A piece cannot be bent as the design says.
    #[error("`{piece}` has no blank: {reason}")]
    Blank {
        /// The chain or the patch.
        piece: String,
        /// Why.
        reason: String,
    },
    /// The parts cannot be written as they were asked for.
    #[error("`{design}`: {reason}")]
    Parts {
        /// The design.
        design: String,
        /// Why.
        reason: String,
    },
    /// There is nothing to unroll.
    #[error("`{design}` has surfaces only, and only patches are unrolled")]
    NoPatch {
        /// The design.
        design: String,
    },
    /// A mark cannot be carried to the pattern.
    #[error("a mark on `{patch}`: {reason}")]
    Mark {
        /// The patch.
        patch: String,
        /// Why.
        reason: String,
    },
    /// A pattern file is not one of this design.
    #[error("{path}: {reason}")]
    Pattern {
        /// The file.
        path: String,
        /// What is wrong with it.
        reason: String,
    },
    /// A file cannot be made or written.
    #[error(transparent)]
    Exchange(#[from] ExchangeError),
    /// A picture cannot be drawn.
    #[error(transparent)]
    Figure(#[from] FigureError),
}

/// How a command ends that has no answer, in the terms of the command's manual.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// The command line cannot be followed.
    Usage,
    /// The design file is wrong, or another file that was named.
    BadFile,
    /// An output cannot be made or written.
    Output,
    /// The design misses what is demanded of it.
    Missed,
}

impl DesignError {
    /// Returns how the command ends.
    #[must_use]
    pub fn ending(&self) -> Ending {
        match self {
            Self::Format { .. }
            | Self::NoSuch { .. }
            | Self::OutOfRange { .. }
            | Self::Parts { .. } => Ending::Usage,
            Self::Unreadable { .. }
            | Self::OtherKind { .. }
            | Self::Listing { .. }
            | Self::Wrong { .. }
            | Self::Pattern { .. } => Ending::BadFile,
            Self::Patch { .. }
            | Self::Unroll { .. }
            | Self::Blank { .. }
            | Self::NoPatch { .. }
            | Self::NoFace { .. }
            | Self::LeftOut { .. }
            | Self::Mark { .. } => Ending::Missed,
            Self::Exchange(_) | Self::Figure(_) => Ending::Output,
        }
    }

    /// Returns what would help.
    #[must_use]
    pub fn help(&self) -> Option<String> {
        match self {
            Self::Format { path, known } if path.as_os_str() == "-" && known.contains(&"dxf") => {
                Some(format!(
                    "standard output has no name: add `--as dxf`, or another of `{}`",
                    known.join("`, `")
                ))
            }
            Self::Format { known, .. } => Some(format!("the extensions are .{}", known.join(", ."))),
            Self::NoSuch { what, known, .. } if known.is_empty() => {
                Some(format!("the design has no {what}"))
            }
            Self::NoSuch { name, known, .. } => {
                let near = similar(name, known.iter().map(String::as_str));
                let near = near.map_or(String::new(), |near| format!("did you mean `{near}`? "));
                Some(format!("{near}there are `{}`", known.join("`, `")))
            }
            Self::Unroll { reason, needed, .. } => match reason {
                PatternError::NotDevelopable { .. } => needed.map(|strain| {
                    format!(
                        "`--allow-strain {:.1e}` flattens it all the same and marks the file",
                        1.05 * strain
                    )
                }),
                PatternError::Regression { .. } => {
                    Some("trim the patch with `part`, or cut it on one side of the edge".to_owned())
                }
                PatternError::CrossesItself { .. } => Some(
                    "cut the chain into shorter ones, or lay it out with `layout = \"apart\"`"
                        .to_owned(),
                ),
                _ => None,
            },
            Self::OtherKind { kind, .. } if kind.is_read() => Some(
                "`torse inspect` lists what is in it; a design takes a curve with `import = \"FILE#name\"`"
                    .to_owned(),
            ),
            Self::NoPatch { .. } => Some(
                "a developable is a patch: `ruled`, `envelope`, `cone`, `connect` and others under [patches.NAME]"
                    .to_owned(),
            ),
            _ => None,
        }
    }
}
