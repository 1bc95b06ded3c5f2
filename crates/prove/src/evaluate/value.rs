//! What formulas evaluate to.

use super::quantity::Quantity;
use std::sync::Arc;
use torse_algebra::Fraction;
use torse_core::{Family, FamilyProperty, Printed};
use torse_syntax::formula::{Connective, Place, Relation};

/// A vector: its coordinates, or one generic coordinate that stands for all.
#[derive(Debug, Clone)]
pub struct Vector {
    /// The coordinates.
    pub entries: Vec<Quantity>,
    /// Whether the single coordinate is generic.
    pub generic: bool,
}

/// A statement with its formulas evaluated.
#[derive(Debug, Clone)]
pub enum Statement {
    /// `left relation right`.
    Compare {
        /// The relation.
        relation: Relation,
        /// The left side.
        left: Box<Value>,
        /// The right side.
        right: Box<Value>,
    },
    /// The printed decimals agree with the values, coordinate by coordinate.
    Agrees {
        /// The exact values.
        values: Vec<Fraction>,
        /// The printed numbers with their digits.
        printed: Vec<Printed>,
    },
    /// A property of a basis family at every degree.
    Family {
        /// The property.
        property: FamilyProperty,
        /// The family.
        family: Arc<Family>,
    },
    /// Several statements joined.
    Join(Connective, Box<Statement>, Box<Statement>),
    /// The negation.
    Not(Box<Statement>),
}

/// What a formula evaluates to.
#[derive(Debug, Clone)]
pub enum Value {
    /// A number.
    Scalar(Quantity),
    /// A vector.
    Vector(Vector),
    /// A matrix, by rows.
    Matrix(Vec<Vec<Quantity>>),
    /// A statement.
    Truth(Box<Statement>),
}

impl Value {
    /// The kind of value, for messages.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Scalar(_) => "a number",
            Self::Vector(_) => "a vector",
            Self::Matrix(_) => "a matrix",
            Self::Truth(_) => "a statement",
        }
    }

    /// All scalar entries, in order.
    #[must_use]
    pub fn entries(&self) -> Vec<&Quantity> {
        match self {
            Self::Scalar(q) => vec![q],
            Self::Vector(v) => v.entries.iter().collect(),
            Self::Matrix(rows) => rows.iter().flatten().collect(),
            Self::Truth(_) => vec![],
        }
    }

    /// The same value with every entry changed.
    ///
    /// # Errors
    /// Whatever the change returns.
    pub fn mapped<E>(&self, change: &impl Fn(&Quantity) -> Result<Quantity, E>) -> Result<Self, E> {
        Ok(match self {
            Self::Scalar(q) => Self::Scalar(change(q)?),
            Self::Vector(v) => Self::Vector(Vector {
                entries: v.entries.iter().map(change).collect::<Result<_, _>>()?,
                generic: v.generic,
            }),
            Self::Matrix(rows) => Self::Matrix(
                rows.iter()
                    .map(|row| row.iter().map(change).collect::<Result<_, _>>())
                    .collect::<Result<_, _>>()?,
            ),
            other => other.clone(),
        })
    }
}

impl From<Fraction> for Value {
    fn from(value: Fraction) -> Self {
        Self::Scalar(value.into())
    }
}

/// A place for values that no text wrote.
pub const UNPLACED: Place = Place { start: 0, end: 0 };
