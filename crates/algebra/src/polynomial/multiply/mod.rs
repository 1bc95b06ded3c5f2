//! Multiplication.
//!
//! Two choices are made independently. The arithmetic of the coefficients (`coefficients`): the smallest machine
//! integers that a bound computed from the factors proves sufficient, else integers of any size, or short fractions
//! if the common denominator is long (`quotients`). The layout of the rows: a table with a cell for every possible
//! row if the product fills its box of exponents well (`dense`), else a hash table (`sparse`), with rows packed into
//! a word of 64 or 128 bits if the degrees of the product fit (`packed`).
//!
//! The methods are those of M. Monagan and R. Pearce, "Sparse polynomial division using a heap" (Journal of Symbolic
//! Computation 46, 2011) for packing, and of FLINT for the choice of the layout; a hash table on ranges of rows
//! replaces the heap.

use super::add::{common_symbols, widened};
use super::coefficients::{Coefficients, DoubleWords, Integers, Words};
use super::packed::{Row, widths};
use super::quotients::Quotients;
use super::{Polynomial, cost, dense, sparse};
use crate::power::power;
use crate::rational::Integer;
use std::ops::Mul;
use torse_numbers::work::room;

/// After this many terms the remaining memory is checked again.
const TERMS_BETWEEN_CHECKS: usize = 1 << 14;

/// The highest exponent of each column of the product; `None` if one is above `u16::MAX`.
fn highest(rows_a: &[u16], rows_b: &[u16], columns: usize) -> Option<Vec<u16>> {
    let top = |rows: &[u16], column: usize| -> u16 {
        let exponents = rows.iter().skip(column).step_by(columns);
        exponents.copied().max().unwrap_or(0)
    };
    let sums = (0..columns).map(|column| top(rows_a, column).checked_add(top(rows_b, column)));
    sums.collect()
}

/// Computes the terms of the product: rows in descending order, and coefficients.
fn terms<K: Coefficients>(
    kind: &K,
    highest: &[u16],
    (rows_a, a): (&[u16], Vec<K::Factor>),
    (rows_b, b): (&[u16], Vec<K::Factor>),
) -> (Vec<u16>, Vec<Integer>) {
    if let Some(cells) = dense::cells::<K::Sum>(highest, a.len(), b.len()) {
        return dense::product(kind, highest, cells, (rows_a, &a), (rows_b, &b));
    }
    let widths = widths(highest);
    let bits: u32 = widths.iter().sum();
    if bits <= u64::BITS {
        sparse_terms::<u64, K>(kind, &widths, (rows_a, a), (rows_b, b))
    } else if bits <= u128::BITS {
        sparse_terms::<u128, K>(kind, &widths, (rows_a, a), (rows_b, b))
    } else {
        sparse_terms::<Box<[u16]>, K>(kind, &widths, (rows_a, a), (rows_b, b))
    }
}

/// Computes the terms in a hash table, with rows in the form `R`.
fn sparse_terms<R: Row, K: Coefficients>(
    kind: &K,
    widths: &[u32],
    (rows_a, a): (&[u16], Vec<K::Factor>),
    (rows_b, b): (&[u16], Vec<K::Factor>),
) -> (Vec<u16>, Vec<Integer>) {
    let packed = |rows: &[u16], coefficients: Vec<K::Factor>| -> Vec<(R, K::Factor)> {
        let rows = rows.chunks(widths.len()).map(|row| R::pack(row, widths));
        rows.zip(coefficients).collect()
    };
    let likely = a.len() + b.len();
    let mut exponents = Vec::with_capacity(likely * widths.len());
    let mut coefficients = Vec::with_capacity(likely);
    let bytes = cost::bytes_of_a_term(widths.len());
    let mut over = false;
    sparse::product(kind, &packed(rows_a, a), &packed(rows_b, b), |row, sum| {
        let terms = coefficients.len() + 1;
        if terms.is_multiple_of(TERMS_BETWEEN_CHECKS) {
            over = over || room(terms * bytes).is_err();
        }
        if over {
            return;
        }
        row.unpack(widths, &mut exponents);
        coefficients.push(kind.value(sum));
    });
    (exponents, coefficients)
}

/// # Panics
/// When an exponent of the product is above `u16::MAX` outside of a job: see [`torse_numbers::work`].
impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: Self) -> Polynomial {
        if self.is_zero() || other.is_zero() {
            return Polynomial::zero();
        }
        if let ([], [factor]) = (self.symbols(), self.body.coefficients.as_slice()) {
            return other.multiple(factor, &self.body.denominator);
        }
        if let ([], [factor]) = (other.symbols(), other.body.coefficients.as_slice()) {
            return self.multiple(factor, &other.body.denominator);
        }
        if cost::product(self, other).is_err() {
            return self.clone();
        }
        let symbols = common_symbols(self, other);
        let (rows_a, rows_b) = (widened(self, &symbols), widened(other, &symbols));
        let Some(highest) = highest(&rows_a, &rows_b, symbols.len()) else {
            cost::exponent_overflow();
            return self.clone();
        };
        let (a, b) = (&self.body.coefficients, &other.body.coefficients);
        let (exponents, coefficients) = if let Some((a, b)) = Words::factors(a, b) {
            terms(&Words, &highest, (&rows_a, a), (&rows_b, b))
        } else if let Some((a, b)) = DoubleWords::factors(a, b) {
            terms(&DoubleWords, &highest, (&rows_a, a), (&rows_b, b))
        } else if let Some(kind) = Quotients::if_faster(self, other) {
            let (a, b) = (Quotients::factors(self), Quotients::factors(other));
            terms(&kind, &highest, (&rows_a, a), (&rows_b, b))
        } else {
            terms(
                &Integers,
                &highest,
                (&rows_a, a.clone()),
                (&rows_b, b.clone()),
            )
        };
        let denominator = &self.body.denominator * &other.body.denominator;
        Polynomial::normalized(symbols, exponents, coefficients, denominator).reduced()
    }
}

impl Mul for Polynomial {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        &self * &other
    }
}

impl Polynomial {
    /// `self` to the power of `exponent`, by repeated squaring.
    ///
    /// # Panics
    /// When an exponent of the result is above `u16::MAX` outside of a job: see [`torse_numbers::work`].
    #[must_use]
    pub fn power(&self, exponent: u32) -> Self {
        let one = Self::constant(&crate::rational::integer(1));
        power(self, exponent, one, |a, b| a * b)
    }
}

#[cfg(test)]
mod tests;
