//! Determinants and the adjugate.

use super::{Matrix, MatrixError, Ring};
use crate::planted::{Planted, planted};
use crate::rational::{Integer, Rational};
use crate::scalar::{Scalar, ZeroTest};
use dashu_int::ops::DivRem;
use num_traits::Zero;
use std::collections::BTreeMap;

/// Division in an integral domain where it comes out even.
pub trait ExactDivision: Sized {
    /// The element `q` with `self = q * by`; `None` if there is none or `by` is zero.
    fn exact_quotient(&self, by: &Self) -> Option<Self>;
}

impl ExactDivision for Integer {
    fn exact_quotient(&self, by: &Self) -> Option<Self> {
        if by.is_zero() {
            return None;
        }
        let (quotient, remainder) = self.div_rem(by);
        remainder.is_zero().then_some(quotient)
    }
}

impl ExactDivision for Rational {
    fn exact_quotient(&self, by: &Self) -> Option<Self> {
        (!by.is_zero()).then(|| self / by)
    }
}

impl<T> Matrix<T> {
    /// The most rows that [`Matrix::determinant`] expands: `16 * 2^15` products.
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
                    let term = if to_the_right % 2 == 0 || planted(Planted::DeterminantWithoutSigns)
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
        // Only the set of all columns is left.
        minors.into_values().next().ok_or(MatrixError::Empty)
    }
}

impl<T: Ring + ZeroTest + ExactDivision> Matrix<T> {
    /// The determinant over an integral domain, by fraction-free elimination (Bareiss).
    ///
    /// With the previous pivot `p` (at first one), each step replaces `a_ij` by
    /// `(a_kk a_ij - a_ik a_kj) / p`, which by Sylvester's identity is the minor of rows `0..=k, i` and
    /// columns `0..=k, j`: the division comes out even.
    ///
    /// # Errors
    /// [`MatrixError::NotSquare`]; [`MatrixError::PivotUndecided`] where zero cannot be decided.
    pub fn determinant_fraction_free(&self) -> Result<T, MatrixError> {
        let size = self.square_size()?;
        let mut rows: Vec<Vec<T>> = self.rows().map(<[T]>::to_vec).collect();
        let mut previous: Option<T> = None;
        for k in 0..size - 1 {
            let Some(pivot_row) = (k..size).find(|&i| rows[i][k].is_known_nonzero()) else {
                return match rows[k..].iter().all(|row| row[k].is_known_zero()) {
                    true => Ok(rows[k][k].clone()),
                    false => Err(MatrixError::PivotUndecided { column: k }),
                };
            };
            if pivot_row != k {
                // Exchanging two rows changes the sign; the negated row restores it.
                rows.swap(k, pivot_row);
                for entry in &mut rows[pivot_row] {
                    *entry = -entry.clone();
                }
            }
            let (done, below) = rows.split_at_mut(k + 1);
            let pivot_row = &done[k];
            for row in below {
                for j in k + 1..size {
                    let minor = pivot_row[k].clone() * row[j].clone()
                        - row[k].clone() * pivot_row[j].clone();
                    row[j] = match &previous {
                        None => minor,
                        Some(p) => minor
                            .exact_quotient(p)
                            .ok_or(MatrixError::InexactDivision)?,
                    };
                }
            }
            previous = Some(pivot_row[k].clone());
        }
        Ok(rows[size - 1][size - 1].clone())
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
