//! The shapes of values.

use std::fmt;

/// The shape of the value of a term. A vector of any dimension is one generic coordinate, a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shape {
    /// A real number, `R`.
    Number,
    /// A vector of this many numbers, `list R`.
    Vector(usize),
    /// A matrix of so many rows and columns, `list (list R)`.
    Matrix(usize, usize),
}

impl Shape {
    /// Returns the type of such values.
    #[must_use]
    pub fn rocq_type(self) -> &'static str {
        match self {
            Self::Number => "R",
            Self::Vector(_) => "list R",
            Self::Matrix(..) => "list (list R)",
        }
    }
}

impl fmt::Display for Shape {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Number => write!(f, "a number"),
            Self::Vector(n) => write!(f, "a vector of {n}"),
            Self::Matrix(rows, columns) => {
                write!(f, "a matrix of {rows} rows and {columns} columns")
            }
        }
    }
}
