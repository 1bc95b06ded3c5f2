//! Multiplication.
//!
//! Exponent rows are packed into one machine word of 64 or 128 bits when the degrees of the product
//! fit, so that comparing and adding rows is one instruction; coefficients run in `i128` where a bound
//! from the factors proves that no sum can overflow, in big integers otherwise. The rows `a_i * b` are
//! sorted already, so a run-detecting merge sort of their concatenation combines them in
//! O(n m log n) word operations. Products that fill their box of exponents well go by a table instead
//! (`dense`).

use super::add::{common_symbols, widened};
use super::dense;
use super::{Polynomial, cost};
use crate::rational::Integer;
use crate::symbol::Symbol;
use std::ops::Mul;
use std::sync::Arc;

/// A packed exponent row: the order of words is the order of rows, and adding words adds rows.
trait Packed: Copy + Ord {
    fn pack(row: &[u16], width: u32) -> Self;
    fn unpack(self, columns: usize, width: u32, into: &mut Vec<u16>);
    fn plus(self, other: Self) -> Self;
}

macro_rules! packed {
    ($word:ty) => {
        impl Packed for $word {
            fn pack(row: &[u16], width: u32) -> Self {
                row.iter().fold(0, |word, exponent| {
                    word.wrapping_shl(width) | <$word>::from(*exponent)
                })
            }
            fn unpack(self, columns: usize, width: u32, into: &mut Vec<u16>) {
                let mask = (1 << width) - 1;
                for column in (0..u32::try_from(columns).unwrap_or(0)).rev() {
                    // The mask leaves at most 16 bits, so nothing is lost.
                    into.push(((self >> (column * width)) & mask) as u16);
                }
            }
            fn plus(self, other: Self) -> Self {
                self + other
            }
        }
    };
}
packed!(u64);
packed!(u128);

/// The number of bits a column of the product needs.
fn column_width(a: &[u16], b: &[u16]) -> u32 {
    let highest = |rows: &[u16]| u32::from(rows.iter().copied().max().unwrap_or(0));
    (32 - (highest(a) + highest(b)).leading_zeros()).max(1)
}

/// Every coefficient as `i128`, if all products and their sums stay below 2^127.
pub(super) fn small(a: &[Integer], b: &[Integer]) -> Option<(Vec<i128>, Vec<i128>)> {
    let convert = |c: &[Integer]| {
        c.iter()
            .map(|c| i128::try_from(c.clone()).ok())
            .collect::<Option<Vec<_>>>()
    };
    let (a, b) = (convert(a)?, convert(b)?);
    let bits = |c: &[i128]| {
        128 - c
            .iter()
            .map(|c| c.unsigned_abs())
            .max()
            .unwrap_or(0)
            .leading_zeros()
    };
    let collisions = usize::BITS - a.len().min(b.len()).leading_zeros();
    (bits(&a) + bits(&b) + collisions < 127).then_some((a, b))
}

/// Sorts the products of all terms and merges equal rows.
fn merged<W: Packed, C>(
    a: &[(W, C)],
    b: &[(W, C)],
    times: impl Fn(&C, &C) -> C,
    add: impl Fn(&mut C, C),
) -> Vec<(W, C)> {
    let mut products: Vec<(W, C)> = Vec::with_capacity(a.len() * b.len());
    for (word_a, c_a) in a {
        products.extend(
            b.iter()
                .map(|(word_b, c_b)| (word_a.plus(*word_b), times(c_a, c_b))),
        );
    }
    products.sort_by_key(|(word, _)| std::cmp::Reverse(*word));
    let mut result: Vec<(W, C)> = Vec::with_capacity(products.len().min(a.len() + b.len()));
    for (word, coefficient) in products {
        match result.last_mut() {
            Some((last, sum)) if *last == word => add(sum, coefficient),
            _ => result.push((word, coefficient)),
        }
    }
    result
}

fn packed_product<W: Packed>(
    symbols: &Arc<[Symbol]>,
    width: u32,
    (rows_a, a): (&[u16], &Polynomial),
    (rows_b, b): (&[u16], &Polynomial),
) -> Polynomial {
    let columns = symbols.len();
    let words = |rows: &[u16], len: usize| -> Vec<W> {
        (0..len)
            .map(|t| {
                W::pack(
                    rows.get(t * columns..(t + 1) * columns).unwrap_or(&[]),
                    width,
                )
            })
            .collect()
    };
    let (words_a, words_b) = (words(rows_a, a.len()), words(rows_b, b.len()));
    let terms: Vec<(W, Integer)> =
        if let Some((small_a, small_b)) = small(&a.coefficients, &b.coefficients) {
            let pair = |w: Vec<W>, c: Vec<i128>| w.into_iter().zip(c).collect::<Vec<_>>();
            merged(
                &pair(words_a, small_a),
                &pair(words_b, small_b),
                |x, y| x * y,
                |sum, c| *sum += c,
            )
            .into_iter()
            .filter(|(_, c)| *c != 0)
            .map(|(word, c)| (word, Integer::from(c)))
            .collect()
        } else {
            let pair =
                |w: Vec<W>, c: &[Integer]| w.into_iter().zip(c.iter().cloned()).collect::<Vec<_>>();
            merged(
                &pair(words_a, &a.coefficients),
                &pair(words_b, &b.coefficients),
                |x, y| x * y,
                |sum, c| *sum += c,
            )
            .into_iter()
            .filter(|(_, c)| !c.is_zero())
            .collect()
        };
    let mut exponents = Vec::with_capacity(terms.len() * columns);
    let mut coefficients = Vec::with_capacity(terms.len());
    for (word, coefficient) in terms {
        word.unpack(columns, width, &mut exponents);
        coefficients.push(coefficient);
    }
    Polynomial::normalized(
        Arc::clone(symbols),
        exponents,
        coefficients,
        &a.denominator * &b.denominator,
    )
}

/// The product with unpacked rows, for degrees or symbol counts that fit no word.
fn wide_product(
    symbols: &Arc<[Symbol]>,
    (rows_a, a): (&[u16], &Polynomial),
    (rows_b, b): (&[u16], &Polynomial),
) -> Polynomial {
    let columns = symbols.len().max(1);
    let mut terms = Vec::with_capacity(a.len() * b.len());
    for (row_a, c_a) in rows_a.chunks(columns).zip(&a.coefficients) {
        for (row_b, c_b) in rows_b.chunks(columns).zip(&b.coefficients) {
            terms.push((
                row_a
                    .iter()
                    .zip(row_b)
                    .map(|(x, y)| x.saturating_add(*y))
                    .collect(),
                c_a * c_b,
            ));
        }
    }
    Polynomial::collected(Arc::clone(symbols), terms, &a.denominator * &b.denominator)
}

impl Mul for &Polynomial {
    type Output = Polynomial;
    fn mul(self, other: Self) -> Polynomial {
        if self.is_zero() || other.is_zero() {
            return Polynomial::zero();
        }
        if let Some(factor) = self.as_constant() {
            return other.scaled(&factor);
        }
        if let Some(factor) = other.as_constant() {
            return self.scaled(&factor);
        }
        cost::product(self, other);
        let symbols = common_symbols(self, other);
        let (rows_a, rows_b) = (widened(self, &symbols), widened(other, &symbols));
        let (a, b) = ((&*rows_a, self), (&*rows_b, other));
        if let Some(product) = dense::product(&symbols, a, b) {
            return product.reduced();
        }
        let width = column_width(&rows_a, &rows_b);
        let needed = width.saturating_mul(u32::try_from(symbols.len()).unwrap_or(u32::MAX));
        let product = if needed <= u64::BITS {
            packed_product::<u64>(&symbols, width, a, b)
        } else if needed <= u128::BITS {
            packed_product::<u128>(&symbols, width, a, b)
        } else {
            wide_product(&symbols, a, b)
        };
        product.reduced()
    }
}

impl Mul for Polynomial {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        &self * &other
    }
}

impl Polynomial {
    /// `self` to the power `exponent`, by repeated squaring.
    #[must_use]
    pub fn power(&self, exponent: u32) -> Self {
        let mut result = Self::constant(&crate::rational::integer(1));
        let (mut base, mut rest) = (self.clone(), exponent);
        while rest > 0 {
            if rest % 2 == 1 {
                result = &result * &base;
            }
            rest /= 2;
            if rest > 0 {
                base = &base * &base;
            }
        }
        result
    }
}
