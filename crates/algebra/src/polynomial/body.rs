//! The shared data of all copies of a polynomial.

use crate::rational::Integer;
use crate::symbol::Symbol;
use dashu_int::ops::BitTest;
use num_integer::Integer as _;
use std::sync::Arc;
use torse_numbers::work;

/// The table of terms of a polynomial. Its memory is counted from [`Body::shared`] until it is dropped.
#[derive(PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Body {
    /// The symbols that occur, ascending.
    pub(super) symbols: Arc<[Symbol]>,
    /// The exponents: one row of `symbols.len()` numbers for each term; rows are strictly descending.
    pub(super) exponents: Vec<u16>,
    /// The nonzero integer coefficients, one for each term.
    pub(super) coefficients: Vec<Integer>,
    /// The common denominator: positive, and coprime to the content of the coefficients.
    pub(super) denominator: Integer,
}

impl Drop for Body {
    fn drop(&mut self) {
        work::give_back(self.bytes());
    }
}

impl Body {
    /// Counts the memory of a table and shares it; the table does not change afterwards.
    pub(super) fn shared(self) -> Arc<Self> {
        work::hold(self.bytes());
        Arc::new(self)
    }

    /// Estimates the bytes that the table occupies from the lengths of the first, middle and last coefficient.
    fn bytes(&self) -> usize {
        let terms = self.coefficients.len();
        let sample =
            [0, terms / 2, terms.saturating_sub(1)].map(|term| self.coefficients.get(term));
        let bits = |c: &Integer| c.bit_len();
        let longest = sample.into_iter().flatten().map(bits).max().unwrap_or(0);
        let term = size_of::<Integer>() + longest / 8;
        size_of::<Self>() + size_of_val(self.exponents.as_slice()) + terms * term
    }

    /// The rows of exponents.
    pub(super) fn rows(&self) -> impl Iterator<Item = &[u16]> {
        let width = self.symbols.len();
        (0..self.coefficients.len()).map(move |term| {
            self.exponents
                .get(term * width..(term + 1) * width)
                .unwrap_or(&[])
        })
    }

    /// Whether every symbol is seen to occur; needs no allocation for up to 64 symbols. `false` may also mean that
    /// there are more.
    fn all_occur(&self) -> bool {
        let width = self.symbols.len();
        if width > u64::BITS as usize {
            return false;
        }
        let all = u64::MAX >> (u64::BITS as usize - width);
        let mut seen = 0;
        self.exponents.chunks_exact(width).any(|row| {
            for (column, exponent) in row.iter().enumerate() {
                seen |= u64::from(*exponent > 0) << column;
            }
            seen == all
        })
    }

    /// Drops the columns of symbols that do not occur.
    pub(super) fn drop_absent_symbols(&mut self) {
        let width = self.symbols.len();
        if width == 0 || self.all_occur() {
            return;
        }
        let mut occurs = vec![false; width];
        for row in self.rows() {
            if occurs.iter().all(|seen| *seen) {
                return;
            }
            for (seen, exponent) in occurs.iter_mut().zip(row) {
                *seen |= *exponent > 0;
            }
        }
        if occurs.iter().all(|seen| *seen) {
            return;
        }
        self.exponents = self
            .rows()
            .flat_map(|row| {
                row.iter()
                    .zip(&occurs)
                    .filter(|(_, seen)| **seen)
                    .map(|(e, _)| *e)
            })
            .collect();
        self.symbols = self
            .symbols
            .iter()
            .zip(&occurs)
            .filter(|(_, seen)| **seen)
            .map(|(s, _)| s.clone())
            .collect();
    }

    /// Cancels the common factor of the coefficients and the denominator.
    pub(super) fn cancel_content(&mut self) {
        let common = self.content_within(&self.denominator);
        if !common.is_one() {
            self.denominator /= &common;
            for coefficient in &mut self.coefficients {
                *coefficient /= &common;
            }
        }
    }

    /// The greatest common divisor of a number and all coefficients.
    pub(super) fn content_within(&self, number: &Integer) -> Integer {
        // Neighbouring terms tend to have common factors. A spread order finds sooner that there is none.
        let step = self.coefficients.len().isqrt().max(1);
        let spread = (0..step).flat_map(|first| self.coefficients.iter().skip(first).step_by(step));
        let mut common = number.clone();
        for coefficient in spread {
            if common.is_one() {
                return common;
            }
            common = common.gcd(coefficient);
        }
        common
    }
}
