//! Multiplication into a table with a cell for every row of exponents that the product can have.
//!
//! The cells are numbered by exponents as digits of a number with mixed base, most significant first, so
//! the number of a product of terms is the sum of their numbers, and the cells from last to first are the
//! rows in descending order: nothing is sorted. Worth it while the table is not much larger than the
//! number of products that fall into it.

use super::Polynomial;
use super::multiply::small;
use crate::rational::Integer;
use crate::symbol::Symbol;
use std::sync::Arc;

/// The most cells of a table: 32 MiB.
const MAX_CELLS: usize = 1 << 21;
/// The most cells for each product of two terms.
const CELLS_PER_PRODUCT: usize = 4;
/// A table is not worth its setup for fewer products.
const MIN_PRODUCTS: usize = 256;

/// The product by a table, where that is faster than sorting: few cells and coefficients of a word.
pub(super) fn product(
    symbols: &Arc<[Symbol]>,
    (rows_a, a): (&[u16], &Polynomial),
    (rows_b, b): (&[u16], &Polynomial),
) -> Option<Polynomial> {
    let products = a.len().checked_mul(b.len())?;
    if products < MIN_PRODUCTS {
        return None;
    }
    let bases = bases(rows_a, rows_b, symbols.len())?;
    let cells = bases.iter().try_fold(1_usize, |cells, base| {
        cells.checked_mul(*base).filter(|cells| *cells <= MAX_CELLS)
    })?;
    if cells > products.saturating_mul(CELLS_PER_PRODUCT) {
        return None;
    }
    let (small_a, small_b) = small(&a.coefficients, &b.coefficients)?;
    let terms = |rows: &[u16], coefficients: &[i128]| -> Option<Vec<(usize, i64)>> {
        let numbers = rows.chunks(symbols.len()).map(|row| number(row, &bases));
        let words = coefficients.iter().map(|c| i64::try_from(*c).ok());
        numbers.zip(words).map(|(n, c)| Some((n, c?))).collect()
    };
    let (terms_a, terms_b) = (terms(rows_a, &small_a)?, terms(rows_b, &small_b)?);
    let mut table = vec![0_i128; cells];
    for (start, x) in &terms_a {
        let Some(cells) = table.get_mut(*start..) else {
            continue;
        };
        for (offset, y) in &terms_b {
            if let Some(cell) = cells.get_mut(*offset) {
                *cell += i128::from(*x) * i128::from(*y);
            }
        }
    }
    let (exponents, coefficients) = read(&table, &bases);
    let denominator = &a.denominator * &b.denominator;
    let symbols = Arc::clone(symbols);
    Some(Polynomial::normalized(
        symbols,
        exponents,
        coefficients,
        denominator,
    ))
}

/// One more than the highest exponent of each column of the product; none without columns.
fn bases(rows_a: &[u16], rows_b: &[u16], columns: usize) -> Option<Vec<usize>> {
    let highest = |rows: &[u16]| {
        let mut highest = vec![0_u16; columns];
        for row in rows.chunks(columns.max(1)) {
            for (top, exponent) in highest.iter_mut().zip(row) {
                *top = (*top).max(*exponent);
            }
        }
        highest
    };
    let tops = highest(rows_a).into_iter().zip(highest(rows_b));
    let bases = tops.map(|(a, b)| usize::from(a) + usize::from(b) + 1);
    (columns > 0).then(|| bases.collect())
}

/// The number of a row: its exponents as digits.
fn number(row: &[u16], bases: &[usize]) -> usize {
    row.iter().zip(bases).fold(0, |number, (digit, base)| {
        number * base + usize::from(*digit)
    })
}

/// The rows of the cells that are not zero, in descending order, and their contents.
fn read(table: &[i128], bases: &[usize]) -> (Vec<u16>, Vec<Integer>) {
    let Some((last, leading)) = bases.split_last() else {
        return (vec![], vec![]);
    };
    // Every base is a sum of two exponents and one, and at most the number of cells.
    let tops = leading.iter().map(|base| u16::try_from(base - 1));
    let tops: Vec<u16> = tops.map(|top| top.unwrap_or(u16::MAX)).collect();
    let mut row = tops.clone();
    let filled = table.iter().filter(|c| **c != 0).count();
    let mut exponents = Vec::with_capacity(filled * bases.len());
    let mut coefficients = Vec::with_capacity(filled);
    // A run of cells differs in the last exponent only.
    for run in table.rchunks(*last) {
        for (digit, cell) in run.iter().enumerate().rev() {
            if *cell != 0 {
                exponents.extend(row.iter().copied());
                exponents.push(u16::try_from(digit).unwrap_or(u16::MAX));
                coefficients.push(Integer::from(*cell));
            }
        }
        for (digit, top) in row.iter_mut().zip(&tops).rev() {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::polynomial::add::widened;
    use proptest::prelude::*;

    fn polynomial(terms: &[(i64, u16, u16, u16)]) -> Polynomial {
        let [x, y, z] = ["x", "y", "z"].map(Polynomial::named);
        terms
            .iter()
            .map(|(c, i, j, k)| {
                let powers = [(&x, i), (&y, j), (&z, k)];
                powers.iter().fold(Polynomial::integer(*c), |p, (v, e)| {
                    &p * &v.power(u32::from(**e))
                })
            })
            .fold(Polynomial::zero(), |sum, term| &sum + &term)
    }

    fn terms() -> impl Strategy<Value = Vec<(i64, u16, u16, u16)>> {
        proptest::collection::vec((-9_i64..=9, 0_u16..4, 0_u16..4, 0_u16..4), 40..60)
    }

    proptest! {
        #[test]
        fn the_table_gives_the_sum_of_the_products_by_single_terms(a in terms(), b in terms()) {
            let (p, q) = (polynomial(&a), polynomial(&b));
            // A product by one term is below the least size of a table: it goes the other way.
            let one_by_one = a
                .iter()
                .map(|term| &polynomial(std::slice::from_ref(term)) * &q)
                .fold(Polynomial::zero(), |sum, product| &sum + &product);
            let symbols = p.symbols.clone();
            let rows = (widened(&p, &symbols), widened(&q, &symbols));
            if let Some(table) = product(&symbols, (&rows.0, &p), (&rows.1, &q)) {
                prop_assert_eq!(table, one_by_one);
            }
        }
    }

    #[test]
    fn a_well_filled_product_goes_by_the_table_and_a_scattered_one_does_not() {
        let filled = polynomial(
            &(0..4)
                .flat_map(|i| (0..4).flat_map(move |j| (0..4).map(move |k| (1, i, j, k))))
                .collect::<Vec<_>>(),
        );
        let scattered = polynomial(
            &(0..20)
                .map(|i| (1, 37 * i, 41 * i, 43 * i))
                .collect::<Vec<_>>(),
        );
        for (p, expected) in [(filled, true), (scattered, false)] {
            let symbols = p.symbols.clone();
            let rows = widened(&p, &symbols);
            let table = product(&symbols, (&rows, &p), (&rows, &p));
            assert_eq!(table.is_some(), expected);
        }
    }
}
