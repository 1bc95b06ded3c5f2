//! Values: numbers, vectors, matrices.
//!
//! A vector with one generic coordinate is a number here: the formula is evaluated in that coordinate, which
//! represents all. The number 0 matches every shape.

use crate::arithmetic::Arithmetic;
use crate::no_value::NoValue;
use crate::series::Series;
use std::fmt::Debug;

/// A number, a vector, or (a vector of rows) a matrix.
#[derive(Debug, Clone, PartialEq)]
pub enum Value<N> {
    /// A number.
    Number(Series<N>),
    /// The entries of a vector or the rows of a matrix.
    Many(Vec<Value<N>>),
}

type Outcome<N> = Result<Value<N>, NoValue>;
/// Pairs of corresponding numbers of two sides.
type Pairs<N> = Vec<(Series<N>, Series<N>)>;

impl<N: Clone + PartialEq + Debug> Value<N> {
    /// The number.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] for vectors and matrices.
    pub fn number(self) -> Result<Series<N>, NoValue> {
        match self {
            Self::Number(number) => Ok(number),
            Self::Many(_) => Err(NoValue::shape("a vector where a number is needed")),
        }
    }

    /// All numbers inside, in order.
    pub fn numbers(&self) -> Vec<&Series<N>> {
        match self {
            Self::Number(number) => vec![number],
            Self::Many(items) => items.iter().flat_map(Self::numbers).collect(),
        }
    }

    /// The entries of a vector of numbers.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] for numbers and matrices.
    pub fn entries(self) -> Result<Vec<Series<N>>, NoValue> {
        match self {
            Self::Many(items) => items.into_iter().map(Self::number).collect(),
            Self::Number(_) => Err(NoValue::shape("a number where a vector is needed")),
        }
    }

    /// The rows of a matrix, all of one length.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] for anything else.
    pub fn rows(self) -> Result<Vec<Vec<Series<N>>>, NoValue> {
        let Self::Many(rows) = self else {
            return Err(NoValue::shape("a number where a matrix is needed"));
        };
        let rows: Vec<Vec<Series<N>>> = rows
            .into_iter()
            .map(Self::entries)
            .collect::<Result<_, _>>()?;
        let width = rows.first().map_or(0, Vec::len);
        if rows.iter().any(|row| row.len() != width) {
            return Err(NoValue::shape("a list of rows of different lengths"));
        }
        Ok(rows)
    }

    /// A vector.
    pub fn vector(entries: Vec<Series<N>>) -> Self {
        Self::Many(entries.into_iter().map(Self::Number).collect())
    }

    /// A matrix of these rows.
    pub fn matrix(rows: Vec<Vec<Series<N>>>) -> Self {
        Self::Many(rows.into_iter().map(Self::vector).collect())
    }

    /// Changes every number in the value.
    ///
    /// # Errors
    /// The error of `change`.
    pub fn each(&self, change: &impl Fn(&Series<N>) -> Result<Series<N>, NoValue>) -> Outcome<N> {
        Ok(match self {
            Self::Number(number) => Self::Number(change(number)?),
            Self::Many(items) => Self::Many(
                items
                    .iter()
                    .map(|v| v.each(change))
                    .collect::<Result<_, _>>()?,
            ),
        })
    }

    /// The pairs of corresponding numbers of two values of one shape; 0 matches every shape.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] for other shapes.
    pub fn pairs<A: Arithmetic<Number = N>>(
        &self,
        other: &Self,
        a: &A,
    ) -> Result<Pairs<N>, NoValue> {
        let zero = || Series::integer(0, a);
        match (self, other) {
            (Self::Number(x), Self::Number(y)) => Ok(vec![(x.clone(), y.clone())]),
            (Self::Number(x), many) if x.is_zero(a) == Some(true) => Ok(many
                .numbers()
                .into_iter()
                .map(|y| (zero(), y.clone()))
                .collect()),
            (many, Self::Number(y)) if y.is_zero(a) == Some(true) => Ok(many
                .numbers()
                .into_iter()
                .map(|x| (x.clone(), zero()))
                .collect()),
            (Self::Many(xs), Self::Many(ys)) if xs.len() == ys.len() => {
                let pairs: Vec<Vec<_>> = xs
                    .iter()
                    .zip(ys)
                    .map(|(x, y)| x.pairs(y, a))
                    .collect::<Result<_, _>>()?;
                Ok(pairs.concat())
            }
            _ => Err(NoValue::shape("one side to the other")),
        }
    }

    /// `self + other`, entry by entry; 0 matches every shape.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] for different shapes, and the errors of the arithmetic.
    pub fn plus<A: Arithmetic<Number = N>>(&self, other: &Self, a: &A) -> Outcome<N> {
        match (self, other) {
            (Self::Number(x), Self::Number(y)) => Ok(Self::Number(x.plus(y, a)?)),
            (Self::Number(zero), many) | (many, Self::Number(zero))
                if zero.is_zero(a) == Some(true) =>
            {
                Ok(many.clone())
            }
            (Self::Many(xs), Self::Many(ys)) if xs.len() == ys.len() => Ok(Self::Many(
                xs.iter()
                    .zip(ys)
                    .map(|(x, y)| x.plus(y, a))
                    .collect::<Result<_, _>>()?,
            )),
            _ => Err(NoValue::shape("a summand to the other")),
        }
    }

    /// `-self`.
    pub fn negated<A: Arithmetic<Number = N>>(&self, a: &A) -> Self {
        match self {
            Self::Number(x) => Self::Number(x.negated(a)),
            Self::Many(items) => Self::Many(items.iter().map(|v| v.negated(a)).collect()),
        }
    }

    /// `self * other`: a number times anything, a matrix times a vector or a matrix.
    ///
    /// # Errors
    /// [`NoValue::Unknown`] for shapes that do not match, and the errors of the arithmetic.
    pub fn times<A: Arithmetic<Number = N>>(&self, other: &Self, a: &A) -> Outcome<N> {
        match (self, other) {
            (Self::Number(x), many) | (many, Self::Number(x)) => many.each(&|y| x.times(y, a)),
            (matrix, Self::Many(entries)) if matches!(entries.first(), Some(Self::Number(_))) => {
                let vector = other.clone().entries()?;
                let rows = matrix.clone().rows()?;
                let entries = rows.iter().map(|row| dot(row, &vector, a));
                Ok(Self::vector(entries.collect::<Result<_, _>>()?))
            }
            _ => {
                let (rows, columns) = (self.clone().rows()?, transposed(&other.clone().rows()?));
                let row = |row: &Vec<Series<N>>| {
                    columns
                        .iter()
                        .map(|column| dot(row, column, a))
                        .collect::<Result<Vec<_>, NoValue>>()
                };
                Ok(Self::matrix(
                    rows.iter().map(row).collect::<Result<_, _>>()?,
                ))
            }
        }
    }
}

/// `sum of x_i y_i`.
///
/// # Errors
/// [`NoValue::Unknown`] for different lengths, and the errors of the arithmetic.
pub fn dot<A: Arithmetic>(
    xs: &[Series<A::Number>],
    ys: &[Series<A::Number>],
    a: &A,
) -> Result<Series<A::Number>, NoValue> {
    if xs.len() != ys.len() {
        return Err(NoValue::shape("a vector to the other"));
    }
    let mut pairs = xs.iter().zip(ys);
    pairs.try_fold(Series::integer(0, a), |sum, (x, y)| {
        sum.plus(&x.times(y, a)?, a)
    })
}

/// The transposed matrix.
pub fn transposed<T: Clone>(rows: &[Vec<T>]) -> Vec<Vec<T>> {
    let width = rows.first().map_or(0, Vec::len);
    (0..width)
        .map(|c| rows.iter().filter_map(|row| row.get(c).cloned()).collect())
        .collect()
}
