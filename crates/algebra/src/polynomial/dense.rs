//! Multiplication in a table that has one cell for every possible row of exponents of the product.
//!
//! Cells are numbered by reading the exponents as the digits of a mixed-base number, most significant first. So the
//! number of a product of terms is the sum of their numbers, and the cells from last to first are the rows in
//! descending order: nothing has to be sorted. The method pays if the table is not much larger than the number of
//! products.

use super::coefficients::Coefficients;
use crate::rational::Integer;

/// The largest size of a table in bytes, not counting the memory of its big integers.
const MAX_BYTES: usize = 1 << 25;
/// The largest number of cells for each product of two terms.
const CELLS_PER_PRODUCT: usize = 4;
/// With fewer products, setting up a table does not pay.
const MIN_PRODUCTS: usize = 256;

/// The number of cells of a table of sums `S`, or `None` if the table does not pay: then there are too many cells for
/// each product of two terms, or too few products.
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

/// Computes the terms of the product in a table of `cells` cells.
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

/// The cell number of a row: its exponents as digits.
fn number(row: &[u16], highest: &[u16]) -> usize {
    row.iter().zip(highest).fold(0, |number, (digit, top)| {
        number * (usize::from(*top) + 1) + usize::from(*digit)
    })
}

/// Reads the nonzero cells: their rows in descending order, and their values.
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
                // The digit is at most `last`, which is a u16, so the cast is exact.
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
