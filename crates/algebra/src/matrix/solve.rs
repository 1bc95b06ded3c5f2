//! Linear systems and inverses.

use super::{Matrix, MatrixError};
use crate::scalar::{Scalar, ZeroTest};

impl<S: Scalar + ZeroTest> Matrix<S> {
    /// Solves `self * X = right` by Gauss-Jordan elimination. The pivot is the first entry known to be nonzero, which
    /// suits exact scalars; rounding errors are not controlled.
    ///
    /// # Errors
    /// [`MatrixError::NotSquare`], [`MatrixError::ShapeMismatch`], [`MatrixError::Singular`];
    /// [`MatrixError::PivotUndecided`] where no entry is known to be nonzero, but one may be.
    pub fn solve(&self, right: &Self) -> Result<Self, MatrixError> {
        let size = self.square_size()?;
        if right.row_count() != size {
            return Err(self.mismatch(right));
        }
        let mut rows: Vec<Vec<S>> = self
            .rows()
            .zip(right.rows())
            .map(|(a, b)| [a, b].concat())
            .collect();
        for k in 0..size {
            let Some(pivot_row) = (k..size).find(|&i| rows[i][k].is_known_nonzero()) else {
                return Err(if rows[k..].iter().all(|row| row[k].is_known_zero()) {
                    MatrixError::Singular { column: k }
                } else {
                    MatrixError::PivotUndecided { column: k }
                });
            };
            rows.swap(k, pivot_row);
            // Entries in columns up to k are not read again, so only the columns to the right are updated.
            let pivot = rows[k][k].clone();
            for entry in &mut rows[k][k + 1..] {
                *entry = entry.divided_by(&pivot)?;
            }
            let pivot_row = rows[k].clone();
            for (_, row) in rows.iter_mut().enumerate().filter(|(i, _)| *i != k) {
                let factor = row[k].clone();
                if factor.is_known_zero() {
                    continue;
                }
                for (entry, above) in row[k + 1..].iter_mut().zip(&pivot_row[k + 1..]) {
                    *entry = entry.clone() - factor.clone() * above.clone();
                }
            }
        }
        let entries = rows
            .into_iter()
            .flat_map(|row| row.into_iter().skip(size))
            .collect();
        Ok(Self {
            columns: right.columns,
            entries,
        })
    }

    /// The inverse matrix, by [`Matrix::solve`].
    ///
    /// # Errors
    /// Those of [`Matrix::solve`].
    pub fn inverse(&self) -> Result<Self, MatrixError> {
        self.solve(&self.identity_like(self.square_size()?)?)
    }
}
