//! Determinants and the adjugate.

use super::{Matrix, MatrixError, Ring};
use crate::fault_injection::{InjectedFault, injected};
use crate::scalar::Scalar;
use std::collections::BTreeMap;

impl<T> Matrix<T> {
    /// The largest number of rows that [`Matrix::determinant`] accepts; it costs `16 * 2^15` products.
    pub const EXPANSION_LIMIT: usize = 16;
}

impl<T: Ring> Matrix<T> {
    /// The determinant over any commutative ring, by expansion.
    ///
    /// After `k` rows there is one minor for each set of `k` columns. The next row gives the minor of a
    /// set `S` as the sum of its entries `a_j`, `j` in `S`, times the minor of `S` without `j`, with the sign
    /// `(-1)^(number of columns of S right of j)`.
    ///
    /// # Errors
    /// [`MatrixError::NotSquare`] and [`MatrixError::TooLarge`].
    pub fn determinant(&self) -> Result<T, MatrixError> {
        let size = self.square_size()?;
        if size > Self::EXPANSION_LIMIT {
            return Err(MatrixError::TooLarge {
                size,
                limit: Self::EXPANSION_LIMIT,
            });
        }
        let mut rows = self.rows();
        let first = rows.next().unwrap_or_default();
        let mut minors: BTreeMap<u32, T> = first
            .iter()
            .enumerate()
            .map(|(j, entry)| (1 << j, entry.clone()))
            .collect();
        for row in rows {
            let mut larger = BTreeMap::new();
            for (set, minor) in &minors {
                for (j, entry) in row.iter().enumerate().filter(|(j, _)| set >> j & 1 == 0) {
                    let product = entry.clone() * minor.clone();
                    let to_the_right = (set >> j).count_ones();
                    let term = if to_the_right % 2 == 0
                        || injected(InjectedFault::DeterminantWithoutSigns)
                    {
                        product
                    } else {
                        -product
                    };
                    let joined = set | 1 << j;
                    let sum = match larger.remove(&joined) {
                        Some(sum) => sum + term,
                        None => term,
                    };
                    larger.insert(joined, sum);
                }
            }
            minors = larger;
        }
        // After all rows only the minor of all columns remains.
        minors.into_values().next().ok_or(MatrixError::Empty)
    }
}

impl<S: Scalar> Matrix<S> {
    /// The adjugate: the transposed matrix of signed minors. `A adj(A) = adj(A) A = det(A) 1` over every
    /// commutative ring, singular or not.
    ///
    /// # Errors
    /// [`MatrixError::NotSquare`] and [`MatrixError::TooLarge`].
    pub fn adjugate(&self) -> Result<Self, MatrixError> {
        let size = self.square_size()?;
        if size == 1 {
            return self.identity_like(1);
        }
        let all_but = |index: usize| (0..size).filter(|&i| i != index).collect::<Vec<_>>();
        let mut entries = Vec::with_capacity(size * size);
        for i in 0..size {
            for j in 0..size {
                let minor = self.submatrix(&all_but(j), &all_but(i))?.determinant()?;
                entries.push(if (i + j) % 2 == 0 { minor } else { -minor });
            }
        }
        Ok(Self {
            columns: size,
            entries,
        })
    }
}
