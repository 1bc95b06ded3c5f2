//! Multiplication in a hash table, one range of rows after the other.
//!
//! A product of `n` and `m` terms has up to `n m` rows, and usually far fewer. Each row is looked up in a hash table
//! that sums its coefficients, so only the rows of the result are sorted and stored. To keep the table in the cache,
//! pivots split the rows into ranges of about [`BLOCK`] products, which are computed from the highest to the lowest.
//! Both factors are sorted, so the products `a_i * b` in a range come from consecutive terms of `b`, and a cursor for
//! each `a_i` finds them. The pivots are quantiles of a coarse grid of products; a bad split costs time and memory,
//! but changes no result. If all rows hash to one place, each lookup walks the table, so the work is bounded by the
//! number of products times the rows of a range.
//!
//! If there are few products they are sorted directly, since a table would not pay.

use super::coefficients::Coefficients;
use super::packed::Row;

/// The largest number of products that are sorted directly.
const MAX_SORTED: usize = 512;
/// The number of products of a range: their rows and sums fit into the second-level cache.
const BLOCK: usize = 1 << 12;
/// The number of grid products for each range.
const SAMPLES: usize = 16;

/// Passes the rows of the product with their nonzero sums to `emit`, in descending order. Both factors are in
/// descending order.
pub(super) fn product<R: Row, K: Coefficients>(
    kind: &K,
    a: &[(R, K::Factor)],
    b: &[(R, K::Factor)],
    mut emit: impl FnMut(&R, K::Sum),
) {
    // Each range visits every term of `a`, so `a` is the shorter factor.
    let (a, b) = if a.len() <= b.len() { (a, b) } else { (b, a) };
    let products = a.len().saturating_mul(b.len());
    let mut emit = |row: &R, sum| {
        if !kind.is_zero(&sum) {
            emit(row, sum);
        }
    };
    if products <= MAX_SORTED {
        sorted(kind, a, b, emit);
        return;
    }
    let block = BLOCK.max(a.len().saturating_mul(4));
    let pivots = pivots(a, b, products / block + 1);
    let mut cursors = vec![0_usize; a.len()];
    let mut table = Table::with_rows(block.min(products));
    for lowest in pivots.iter().map(Some).chain([None]) {
        for ((row_a, x), cursor) in a.iter().zip(&mut cursors) {
            for (row_b, y) in b.iter().skip(*cursor) {
                let row = row_a.plus(row_b);
                if lowest.is_some_and(|lowest| row < *lowest) {
                    break;
                }
                *cursor += 1;
                kind.add_product(table.sum(row, || kind.zero()), x, y);
            }
        }
        table.drain(|| kind.zero(), &mut emit);
    }
}

/// The product by sorting the pairs of terms by their rows.
fn sorted<R: Row, K: Coefficients>(
    kind: &K,
    a: &[(R, K::Factor)],
    b: &[(R, K::Factor)],
    mut emit: impl FnMut(&R, K::Sum),
) {
    let mut pairs = Vec::with_capacity(a.len() * b.len());
    for (row_a, x) in a {
        pairs.extend(b.iter().map(|(row_b, y)| (row_a.plus(row_b), x, y)));
    }
    // The rows made from one term of `a` are already in order, which makes the stable sort fast.
    pairs.sort_by(|p, q| q.0.cmp(&p.0));
    for run in pairs.chunk_by(|p, q| p.0 == q.0) {
        let mut sum = kind.zero();
        for (_, x, y) in run {
            kind.add_product(&mut sum, x, y);
        }
        if let Some((row, _, _)) = run.first() {
            emit(row, sum);
        }
    }
}

/// Up to `ranges - 1` rows, descending, that split the products into ranges of about the same size.
fn pivots<R: Row, F>(a: &[(R, F)], b: &[(R, F)], ranges: usize) -> Vec<R> {
    if ranges <= 1 {
        return vec![];
    }
    let grid = ranges.saturating_mul(SAMPLES).isqrt().max(1);
    let along = |terms: &[(R, F)]| -> Vec<R> {
        let places = (0..grid).map(|place| (2 * place + 1) * terms.len() / (2 * grid));
        let rows = places.filter_map(|place| terms.get(place));
        rows.map(|(row, _)| row.clone()).collect()
    };
    let (along_a, along_b) = (along(a), along(b));
    let pairs = along_a
        .iter()
        .flat_map(|x| along_b.iter().map(|y| x.plus(y)));
    let mut samples: Vec<R> = pairs.collect();
    samples.sort_unstable_by(|x, y| y.cmp(x));
    let step = samples.len().div_ceil(ranges).max(1);
    let mut pivots: Vec<R> = samples.into_iter().step_by(step).skip(1).collect();
    pivots.dedup();
    pivots
}

/// Sums by row: an open hash table with linear probing.
struct Table<R, S> {
    /// For each place one plus the number of its row, or 0 for a free place. There are at least twice as many places
    /// as rows.
    places: Vec<usize>,
    rows: Vec<R>,
    sums: Vec<S>,
    /// Rows and their numbers, used for sorting.
    order: Vec<(R, usize)>,
}

impl<R: Row, S> Table<R, S> {
    fn with_rows(rows: usize) -> Self {
        Self {
            places: vec![0; (2 * rows + 2).next_power_of_two()],
            rows: vec![],
            sums: vec![],
            order: vec![],
        }
    }

    /// The place of `row`, or the free place where it belongs.
    fn place(&self, row: &R) -> usize {
        let mask = self.places.len() - 1;
        // The upper bits of the hash depend on all bits of the row.
        let mut place = (row.hash() >> 32) as usize & mask;
        // The loop ends because at least half of the places are free; entries are valid row numbers.
        loop {
            let number = self.places[place];
            if number == 0 || self.rows[number - 1] == *row {
                return place;
            }
            place = (place + 1) & mask;
        }
    }

    /// The sum of `row`, which starts as `zero` for a new row.
    fn sum(&mut self, row: R, zero: impl Fn() -> S) -> &mut S {
        let place = self.place(&row);
        let mut number = self.places[place];
        if number == 0 {
            self.rows.push(row);
            self.sums.push(zero());
            number = self.rows.len();
            self.places[place] = number;
            if 2 * number >= self.places.len() {
                self.grow();
            }
        }
        &mut self.sums[number - 1]
    }

    fn grow(&mut self) {
        self.places = vec![0; 2 * self.places.len()];
        for number in 1..=self.rows.len() {
            let place = self.place(&self.rows[number - 1]);
            self.places[place] = number;
        }
    }

    /// Passes the rows in descending order with their sums to `emit`, and empties the table.
    fn drain(&mut self, zero: impl Fn() -> S, mut emit: impl FnMut(&R, S)) {
        self.order.extend(self.rows.drain(..).zip(0..));
        self.order.sort_unstable_by(|x, y| y.0.cmp(&x.0));
        for (row, number) in self.order.drain(..) {
            emit(&row, std::mem::replace(&mut self.sums[number], zero()));
        }
        self.sums.clear();
        self.places.fill(0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_that_was_made_too_small_grows_and_is_empty_after_it_was_drained() {
        let mut table = Table::with_rows(1);
        for rows in [3000_u64, 5, 7000] {
            // Each row comes three times.
            for number in (0..3 * rows).map(|n| n % rows) {
                *table.sum(number * number, || 0) += number + 1;
            }
            let mut drained = vec![];
            table.drain(|| 0, |row, sum| drained.push((*row, sum)));
            let expected = (0..rows).rev().map(|n| (n * n, 3 * (n + 1)));
            assert_eq!(drained, expected.collect::<Vec<_>>());
        }
    }
}
