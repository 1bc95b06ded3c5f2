//! Names of the numbers of a point: symbols, coordinates, and members of families.

use std::fmt;
use std::sync::Arc;

/// The name of a number of a point. Names are ordered alphabetically, members by their indices.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Name {
    /// A declared number, integer, or the generic coordinate of a vector.
    Symbol(Arc<str>),
    /// A coordinate of a declared vector, counted from 1.
    Coordinate(Arc<str>, u8),
    /// A member of a declared family: its indices, and the coordinate counted from 1, or `None` for a number or the
    /// generic coordinate.
    Member(Arc<str>, Vec<i64>, Option<u8>),
}

impl Name {
    /// The declared name of which this is a part.
    #[must_use]
    pub fn declared(&self) -> &Arc<str> {
        match self {
            Self::Symbol(name) | Self::Coordinate(name, _) | Self::Member(name, ..) => name,
        }
    }
}

impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Symbol(name) => write!(f, "{name}"),
            Self::Coordinate(name, coordinate) => write!(f, "{name}[{coordinate}]"),
            Self::Member(name, indices, coordinate) => {
                let indices: Vec<String> = indices.iter().map(ToString::to_string).collect();
                write!(f, "{name}[{}]", indices.join(","))?;
                match coordinate {
                    Some(coordinate) => write!(f, "[{coordinate}]"),
                    None => Ok(()),
                }
            }
        }
    }
}
