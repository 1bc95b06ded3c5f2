//! Multiplication into a table with a cell for every row of exponents that the product can have.
//!
//! The cells are numbered by exponents as digits of a number with mixed base, most significant first, so
//! the number of a product of terms is the sum of their numbers, and the cells from last to first are the
//! rows in descending order: nothing is sorted. Worth it while the table is not much larger than the
//! number of products that fall into it.

use super::coefficients::Coefficients;
use crate::rational::Integer;

/// The most bytes of a table, without what its big integers hold elsewhere.
const MAX_BYTES: usize = 1 << 25;
/// The most cells for each product of two terms.
const CELLS_PER_PRODUCT: usize = 4;
/// A table is not worth its setup for fewer products.
const MIN_PRODUCTS: usize = 256;

/// The number of cells of a table of sums `S`, where it is worth making: few cells for each product of two terms.
pub(super) fn cells<S>(highest: &[u16], terms_a: usize, terms_b: usize) -> Option<usize> {
    let products = terms_a.checked_mul(terms_b)?;
    if products < MIN_PRODUCTS {
        return None;
    }
    let room = MAX_BYTES / size_of::<S>().max(1);
    let limit = room.min(products.saturating_mul(CELLS_PER_PRODUCT));
    highest.iter().try_fold(1_usize, |cells, top| {
        cells
            .checked_mul(usize::from(*top) + 1)
            .filter(|cells| *cells <= limit)
    })
}

/// The terms of the product, by a table of `cells` cells.
pub(super) fn product<K: Coefficients>(
    kind: &K,
    highest: &[u16],
    cells: usize,
    (rows_a, a): (&[u16], &[K::Factor]),
    (rows_b, b): (&[u16], &[K::Factor]),
) -> (Vec<u16>, Vec<Integer>) {
    let numbers = |rows: &[u16]| -> Vec<usize> {
        let rows = rows.chunks(highest.len());
        rows.map(|row| number(row, highest)).collect()
    };
    let (numbers_a, numbers_b) = (numbers(rows_a), numbers(rows_b));
    let mut table = vec![kind.zero(); cells];
    for (start, x) in numbers_a.iter().zip(a) {
        let Some(cells) = table.get_mut(*start..) else {
            continue;
        };
        for (offset, y) in numbers_b.iter().zip(b) {
            if let Some(cell) = cells.get_mut(*offset) {
                kind.add_product(cell, x, y);
            }
        }
    }
    read(kind, &mut table, highest)
}

/// The number of a row: its exponents as digits.
fn number(row: &[u16], highest: &[u16]) -> usize {
    row.iter().zip(highest).fold(0, |number, (digit, top)| {
        number * (usize::from(*top) + 1) + usize::from(*digit)
    })
}

/// The rows of the cells that are not zero, in descending order, and their contents.
fn read<K: Coefficients>(
    kind: &K,
    table: &mut [K::Sum],
    highest: &[u16],
) -> (Vec<u16>, Vec<Integer>) {
    let Some((last, leading)) = highest.split_last() else {
        return (vec![], vec![]);
    };
    let filled = table.iter().filter(|sum| !kind.is_zero(sum)).count();
    let mut exponents = Vec::with_capacity(filled * highest.len());
    let mut coefficients = Vec::with_capacity(filled);
    let mut row = leading.to_vec();
    // A run of cells differs in the last exponent only.
    for run in table.rchunks_mut(usize::from(*last) + 1) {
        for (digit, cell) in run.iter_mut().enumerate().rev() {
            if !kind.is_zero(cell) {
                coefficients.push(kind.value(std::mem::replace(cell, kind.zero())));
                exponents.extend_from_slice(&row);
                // At most `last`, so nothing is lost.
                exponents.push(digit as u16);
            }
        }
        for (digit, top) in row.iter_mut().zip(leading).rev() {
            match digit.checked_sub(1) {
                Some(less) => {
                    *digit = less;
                    break;
                }
                None => *digit = *top,
            }
        }
    }
    (exponents, coefficients)
}
