//! Lower bounds of the orders at 0 of the Bernstein coefficients of the determinants.
//!
//! Let `l_j = L[x^j]`, separated by monomials of the parameters. A determinant `D_r` is the Wronskian of `l_0, ...,
//! l_r`, and linear in each; so its coefficient of a monomial is a sum of Wronskians of one part of each `l_j`. A
//! Wronskian of functions that vanish to the orders `n_0, n_1, ...` vanishes at least to the order `sum (n_j - j)`,
//! since each of its terms does. If two of these orders are equal, one of the two functions may be replaced by a
//! combination of both that vanishes to one order more, without changing the Wronskian; this is used for the last
//! two. The Bernstein coefficient (A, B) is a combination of the coefficients of `u^i v^j` with i <= A and j <= B.
//! The same holds at the other corners of the box, where parameters are subtracted from one, and the best of these
//! bounds is used.

use super::operator::{Operator, Part, weight};
use super::series::taylor;
use super::{Exchange, SHAPES, Unfit, exact};
use crate::polynomial::Polynomial;

/// Larger than any order that is used: for a part that does not occur.
const NEVER: usize = usize::MAX / 4;

/// Lower bounds of the orders at 0 of the Bernstein coefficients, indexed by the rank (from 1) and the coefficient,
/// of degrees `total * rank`; `None` for a coefficient that is zero.
pub(super) struct Orders(Vec<Vec<Vec<Option<usize>>>>);

impl Orders {
    /// The bounds for all determinants of one degree; those of the ranks in `exact` are expanded symbolically.
    ///
    /// # Errors
    /// [`Unfit::Order`] if some `L[x^j]` does not vanish to the order j; [`Unfit::Rank`] for a rank that is too
    /// large.
    pub fn new(operator: &Operator, degree: usize, exact: &[u8]) -> Result<Self, Unfit> {
        let size = |rank: usize, place: usize| {
            if operator.used[place] {
                operator.total * rank + 1
            } else {
                1
            }
        };
        let start = |rank| vec![vec![0; size(rank, 1)]; size(rank, 0)];
        let mut all: Vec<Vec<Vec<usize>>> = (1..=degree).map(start).collect();
        for turned in [[false, false], [true, false], [false, true], [true, true]] {
            if (0..SHAPES).any(|place| turned[place] && !operator.used[place]) {
                continue;
            }
            let exchange = Exchange {
                swapped: false,
                turned,
            };
            let own = Operator::new(operator.seeds.exchanged(exchange))?;
            let columns = columns(&own, degree)?;
            for (rank, bounds) in (1..).zip(&mut all) {
                let powers = powers(&columns[..=rank], operator.total * rank);
                let (rows, width) = (bounds.len(), bounds[0].len());
                for (a, row) in bounds.iter_mut().enumerate() {
                    for (b, bound) in row.iter_mut().enumerate() {
                        let a = if turned[0] { rows - 1 - a } else { a };
                        let b = if turned[1] { width - 1 - b } else { b };
                        let below = powers.iter().take(a + 1).flat_map(|p| p.iter().take(b + 1));
                        *bound = (*bound).max(below.copied().min().unwrap_or(0));
                    }
                }
            }
        }
        let known = |order: usize| Some(order).filter(|order| *order < NEVER).or(Some(0));
        let mut all: Vec<Vec<Vec<Option<usize>>>> = all
            .into_iter()
            .map(|rows| {
                let row = |row: Vec<usize>| row.into_iter().map(known).collect();
                rows.into_iter().map(row).collect()
            })
            .collect();
        for rank in exact {
            let rank = usize::from(*rank);
            let own = exact::orders(operator, degree, rank, [size(rank, 0), size(rank, 1)])?;
            if let Some(slot) = all.get_mut(rank - 1) {
                *slot = own;
            }
        }
        Ok(Self(all))
    }

    /// The order of one coefficient; `None` if the coefficient is zero.
    pub fn get(&self, rank: usize, a: usize, b: usize) -> Option<usize> {
        let rows = rank.checked_sub(1).and_then(|place| self.0.get(place));
        *rows
            .and_then(|rows| rows.get(a)?.get(b))
            .unwrap_or(&Some(0))
    }
}

/// The parts of one `l_j`: a monomial in the parameters, and the order to which the part vanishes.
type Column = Vec<([usize; SHAPES], usize)>;

/// The parts of `l_0, ..., l_k`.
fn columns(operator: &Operator, degree: usize) -> Result<Vec<Column>, Unfit> {
    let length = degree + 2 * operator.order() + 2;
    let expanded: Vec<Vec<([u32; SHAPES], Vec<Polynomial>)>> = operator
        .parts
        .iter()
        .map(|parts| {
            let one = |part: &Part| (part.shape, taylor(&part.terms, length));
            parts.iter().map(one).collect()
        })
        .collect();
    let column = |j: usize| {
        let mut sums: Vec<([u32; SHAPES], Vec<Polynomial>)> = vec![];
        let mut power = vec![Polynomial::zero(); length];
        power[j] = Polynomial::one();
        sums.push(([0; SHAPES], power));
        for (i, parts) in (1..).zip(&expanded) {
            let weight = weight(i, j, degree);
            for (shape, series) in parts.iter().filter(|_| i <= j) {
                let place = match sums.iter().position(|(own, _)| own == shape) {
                    Some(place) => place,
                    None => {
                        sums.push((*shape, vec![Polynomial::zero(); length]));
                        sums.len() - 1
                    }
                };
                let moved = sums[place].1.iter_mut().skip(j - i);
                for (slot, coefficient) in moved.zip(series) {
                    slot.add(&coefficient.scaled(&weight));
                }
            }
        }
        let mut column = vec![];
        for (shape, series) in sums {
            if let Some(order) = series.iter().position(|c| !c.is_zero()) {
                if order < j {
                    return Err(Unfit::Order(u8::try_from(j).unwrap_or(u8::MAX)));
                }
                let shape = shape.map(|n| usize::try_from(n).unwrap_or(NEVER));
                column.push((shape, order));
            } else {
                // All computed coefficients vanish, so their number is a lower bound of the order.
                let shape = shape.map(|n| usize::try_from(n).unwrap_or(NEVER));
                column.push((shape, length));
            }
        }
        Ok(column)
    };
    (0..=degree).map(column).collect()
}

/// Lower bounds of the orders of the coefficients of `u^i v^j` in the Wronskian of these functions.
fn powers(columns: &[Column], most: usize) -> Vec<Vec<usize>> {
    let fresh = || vec![vec![NEVER; most + 1]; most + 1];
    let mut all = fresh();
    all[0][0] = 0;
    let step = |all: &mut Vec<Vec<usize>>, parts: &[([usize; SHAPES], usize)]| {
        let mut next = fresh();
        for (i, row) in all.iter().enumerate() {
            for (j, known) in row.iter().enumerate().filter(|(_, known)| **known < NEVER) {
                for ([di, dj], more) in parts {
                    if let Some(slot) = next.get_mut(i + di).and_then(|row| row.get_mut(j + dj)) {
                        *slot = (*slot).min(known + more);
                    }
                }
            }
        }
        *all = next;
    };
    let free = columns.len().saturating_sub(2);
    for (j, column) in columns.iter().enumerate().take(free) {
        let excess: Column = column.iter().map(|(shape, n)| (*shape, n - j)).collect();
        step(&mut all, &excess);
    }
    if let Some([before, last]) = columns.get(free..) {
        let pairs = before.iter().flat_map(|(a, n)| {
            last.iter().map(move |(b, m)| {
                let sum = n + m + usize::from(n == m);
                ([a[0] + b[0], a[1] + b[1]], sum - free - (free + 1))
            })
        });
        step(&mut all, &pairs.collect::<Column>());
    }
    all
}
