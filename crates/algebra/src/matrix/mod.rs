//! Small dense matrices over exact scalars.
//!
//! [`Matrix::determinant`] expands row by row (Laplace) and keeps one minor for each set of columns. It needs only
//! `+`, `-`, `*`, so it is correct over every commutative ring, including jets and polynomials. It takes `n 2^(n-1)`
//! products, the fewest of all methods for the sizes of geometry, and refuses `n >` [`Matrix::EXPANSION_LIMIT`].
//! [`Matrix::solve`] uses Gauss-Jordan elimination.

mod determinant;
mod solve;

use crate::scalar::{ExactError, Scalar};
use std::ops::{Add, Mul, Neg, Sub};

/// The operations of a commutative ring, implemented by every type that has them.
pub trait Ring:
    Clone + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Neg<Output = Self>
{
}

impl<T> Ring for T where
    T: Clone + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Neg<Output = T>
{
}

/// Why a matrix operation failed. Rows and columns are counted from zero.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum MatrixError {
    /// There are no rows or no columns.
    #[error("a matrix needs at least one row and one column")]
    Empty,
    /// A row is longer or shorter than the first.
    #[error("row {row} has {found} entries, the first row has {expected}")]
    Ragged {
        /// The offending row.
        row: usize,
        /// Its length.
        found: usize,
        /// The length of the first row.
        expected: usize,
    },
    /// The operation is for square matrices.
    #[error("the matrix is not square: {rows} by {columns}")]
    NotSquare {
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
    },
    /// The shapes do not fit together.
    #[error("{left_rows} by {left_columns} does not fit {right_rows} by {right_columns}")]
    ShapeMismatch {
        /// Rows of the left operand.
        left_rows: usize,
        /// Columns of the left operand.
        left_columns: usize,
        /// Rows of the right operand.
        right_rows: usize,
        /// Columns of the right operand.
        right_columns: usize,
    },
    /// There is no such row or column.
    #[error("index {index} is out of range, there are {count}")]
    OutOfRange {
        /// The offending index.
        index: usize,
        /// The number of rows or columns.
        count: usize,
    },
    /// The matrix is larger than an algorithm of exponential cost accepts.
    #[error("size {size} exceeds {limit}, the largest for this algorithm")]
    TooLarge {
        /// The number of rows.
        size: usize,
        /// The largest number of rows.
        limit: usize,
    },
    /// No entry of this column can be a pivot: the matrix is singular.
    #[error("the matrix is singular: no pivot in column {column}")]
    Singular {
        /// The column without a pivot.
        column: usize,
    },
    /// Some entry of this column may differ from zero, but none is known to (for enclosures).
    #[error("no entry of column {column} is known to be nonzero at this precision")]
    PivotUndecided {
        /// The column.
        column: usize,
    },
    /// A division of scalars failed.
    #[error(transparent)]
    Scalar(#[from] ExactError),
}

/// A matrix with at least one row and one column, stored row by row.
///
/// ```
/// use torse_algebra::{Matrix, rational::{integer, ratio}};
/// let a = Matrix::from_rows(vec![
///     vec![integer(2), integer(1)],
///     vec![integer(1), integer(3)],
/// ])?;
/// assert_eq!(a.determinant()?, integer(5));
/// let x = a.solve(&Matrix::column(vec![integer(1), integer(0)])?)?;
/// assert_eq!(x.get(0, 0), ratio(3, 5).as_ref());
/// # Ok::<(), torse_algebra::MatrixError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Matrix<T> {
    columns: usize,
    /// Row by row; a positive multiple of `columns`.
    entries: Vec<T>,
}

impl<T> Matrix<T> {
    /// Makes a matrix from its rows.
    ///
    /// # Errors
    /// [`MatrixError::Empty`] and [`MatrixError::Ragged`].
    pub fn from_rows(rows: Vec<Vec<T>>) -> Result<Self, MatrixError> {
        let columns = rows.first().map_or(0, Vec::len);
        if columns == 0 {
            return Err(MatrixError::Empty);
        }
        if let Some((row, wrong)) = rows
            .iter()
            .enumerate()
            .find(|(_, row)| row.len() != columns)
        {
            return Err(MatrixError::Ragged {
                row,
                found: wrong.len(),
                expected: columns,
            });
        }
        Ok(Self {
            columns,
            entries: rows.into_iter().flatten().collect(),
        })
    }

    /// Makes a matrix whose entries are `entry(row, column)`.
    ///
    /// # Errors
    /// [`MatrixError::Empty`].
    pub fn from_fn(
        rows: usize,
        columns: usize,
        mut entry: impl FnMut(usize, usize) -> T,
    ) -> Result<Self, MatrixError> {
        if rows == 0 || columns == 0 {
            return Err(MatrixError::Empty);
        }
        let mut entries = Vec::new();
        for row in 0..rows {
            entries.extend((0..columns).map(|column| entry(row, column)));
        }
        Ok(Self { columns, entries })
    }

    /// Makes a matrix of one column.
    ///
    /// # Errors
    /// [`MatrixError::Empty`].
    pub fn column(entries: Vec<T>) -> Result<Self, MatrixError> {
        if entries.is_empty() {
            return Err(MatrixError::Empty);
        }
        Ok(Self {
            columns: 1,
            entries,
        })
    }

    /// The number of rows.
    #[must_use]
    pub fn row_count(&self) -> usize {
        self.entries.len() / self.columns
    }

    /// The rows, from the top.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = &[T]> {
        self.entries.chunks_exact(self.columns)
    }

    /// The entry in this row and column, or `None` outside of the matrix.
    #[must_use]
    pub fn get(&self, row: usize, column: usize) -> Option<&T> {
        self.rows().nth(row).and_then(|entries| entries.get(column))
    }

    /// Maps each entry; the shape stays the same.
    #[must_use]
    pub fn map<U>(&self, entry: impl FnMut(&T) -> U) -> Matrix<U> {
        Matrix {
            columns: self.columns,
            entries: self.entries.iter().map(entry).collect(),
        }
    }

    /// The entry in this row and column, which must exist.
    fn at(&self, row: usize, column: usize) -> &T {
        &self.entries[row * self.columns + column]
    }

    /// The number of rows of a square matrix.
    fn square_size(&self) -> Result<usize, MatrixError> {
        let (rows, columns) = (self.row_count(), self.columns);
        if rows == columns {
            Ok(rows)
        } else {
            Err(MatrixError::NotSquare { rows, columns })
        }
    }

    fn mismatch<U>(&self, right: &Matrix<U>) -> MatrixError {
        MatrixError::ShapeMismatch {
            left_rows: self.row_count(),
            left_columns: self.columns,
            right_rows: right.row_count(),
            right_columns: right.columns,
        }
    }
}

impl<T: Clone> Matrix<T> {
    /// The transposed matrix.
    #[must_use]
    pub fn transposed(&self) -> Self {
        let rows = self.row_count();
        let entries = (0..self.columns)
            .flat_map(|column| (0..rows).map(move |row| self.at(row, column).clone()))
            .collect();
        Self {
            columns: rows,
            entries,
        }
    }

    /// The submatrix of these rows and columns, in the given order.
    ///
    /// # Errors
    /// [`MatrixError::OutOfRange`] and [`MatrixError::Empty`].
    pub fn submatrix(&self, rows: &[usize], columns: &[usize]) -> Result<Self, MatrixError> {
        for (indices, count) in [(rows, self.row_count()), (columns, self.columns)] {
            if let Some(&index) = indices.iter().find(|&&index| index >= count) {
                return Err(MatrixError::OutOfRange { index, count });
            }
        }
        Self::from_fn(rows.len(), columns.len(), |i, j| {
            self.at(rows[i], columns[j]).clone()
        })
    }
}

impl<T: Ring> Matrix<T> {
    /// The matrix product `self * right`.
    ///
    /// # Errors
    /// [`MatrixError::ShapeMismatch`] unless `right` has as many rows as `self` has columns.
    pub fn times(&self, right: &Self) -> Result<Self, MatrixError> {
        if self.columns != right.row_count() {
            return Err(self.mismatch(right));
        }
        let mut entries = Vec::with_capacity(self.row_count() * right.columns);
        for row in self.rows() {
            for column in 0..right.columns {
                let terms = row
                    .iter()
                    .enumerate()
                    .map(|(k, a)| a.clone() * right.at(k, column).clone());
                entries.extend(terms.reduce(Add::add));
            }
        }
        Ok(Self {
            columns: right.columns,
            entries,
        })
    }
}

impl<S: Scalar> Matrix<S> {
    /// The identity matrix of this size; its numbers are made in the context of an entry of `self`.
    fn identity_like(&self, size: usize) -> Result<Self, MatrixError> {
        let entry = self.at(0, 0);
        Self::from_fn(size, size, |i, j| {
            if i == j {
                entry.one_like()
            } else {
                entry.zero_like()
            }
        })
    }
}
