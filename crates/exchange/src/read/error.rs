//! Why a file cannot be read.

use super::kind::FileKind;
use std::fmt;
use torse_geometry::GeometryError;

/// The result of reading.
pub type ReadResult<T> = Result<T, ReadError>;

/// Where in a file something is wrong: a line, an entity, both or neither.
#[derive(Debug, Clone, PartialEq, Eq, Default, PartialOrd, Ord)]
pub struct FilePlace {
    /// The line, counted from one.
    pub line: Option<usize>,
    /// The entity, as the format names it: `#21`, `SPLINE 2F`, `path p1`.
    pub entity: Option<String>,
}

impl FilePlace {
    /// A line.
    #[must_use]
    pub fn line(line: usize) -> Self {
        Self {
            line: Some(line),
            entity: None,
        }
    }

    /// An entity that begins in a line.
    #[must_use]
    pub fn entity(line: usize, entity: impl Into<String>) -> Self {
        Self {
            line: Some(line),
            entity: Some(entity.into()),
        }
    }
}

impl fmt::Display for FilePlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.line, &self.entity) {
            (Some(line), Some(entity)) => write!(f, "line {line}, {entity}: "),
            (Some(line), None) => write!(f, "line {line}: "),
            (None, Some(entity)) => write!(f, "{entity}: "),
            (None, None) => Ok(()),
        }
    }
}

/// What stands against reading a file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ReadError {
    /// It is of a kind that is not read.
    #[error("this is {kind}; read are {}", FileKind::READ)]
    Kind {
        /// What it is.
        kind: FileKind,
    },
    /// Something in it is wrong.
    #[error("{place}{reason}")]
    Wrong {
        /// Where.
        place: FilePlace,
        /// What.
        reason: String,
    },
    /// The geometry refuses what it says.
    #[error("{place}{reason}")]
    Geometry {
        /// Where.
        place: FilePlace,
        /// Why.
        reason: Box<GeometryError>,
    },
    /// There is more of something than is read.
    #[error("{place}more than {most} {what}")]
    TooMuch {
        /// Where the bound was passed.
        place: FilePlace,
        /// What there is too much of.
        what: &'static str,
        /// How much is read.
        most: usize,
    },
    /// The unit that was given is not the one that the file states.
    #[error("the file states {stated} as its unit of length, and {given} was given")]
    OtherUnit {
        /// The unit of the file.
        stated: String,
        /// The other.
        given: String,
    },
    /// There is nothing to read: no curve, face or mesh.
    #[error("there is no curve, face or mesh in it{}", skipped(passed_over))]
    Nothing {
        /// What was passed over, in words.
        passed_over: String,
    },
}

fn skipped(words: &str) -> String {
    match words {
        "" => String::new(),
        words => format!("; passed over: {words}"),
    }
}

/// An error at a line.
pub(super) fn at_line(line: usize, reason: impl Into<String>) -> ReadError {
    ReadError::Wrong {
        place: FilePlace::line(line),
        reason: reason.into(),
    }
}

/// An error at a place.
pub(super) fn at(place: &FilePlace, reason: impl Into<String>) -> ReadError {
    ReadError::Wrong {
        place: place.clone(),
        reason: reason.into(),
    }
}

/// The objection of the geometry at a place.
pub(super) fn refused(place: &FilePlace) -> impl FnOnce(GeometryError) -> ReadError {
    let place = place.clone();
    move |reason| ReadError::Geometry {
        place,
        reason: Box::new(reason),
    }
}
