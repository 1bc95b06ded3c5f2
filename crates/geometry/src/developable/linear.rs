//! Small linear systems over any scalar.

use crate::coordinate::{Coordinate, is_zero};
use crate::error::{GeometryError, Place, Result};

/// The solution of `matrix x = right`, with vectors as unknowns, by Gauss elimination.
///
/// The pivot of each column is the entry that lies furthest from zero where that is known (partial
/// pivoting on f64 and rationals), otherwise the first that is not known to vanish.
///
/// # Errors
/// [`GeometryError::SingularSystem`] when no pivot is left, naming `what`;
/// [`GeometryError::LengthMismatch`] when the matrix is not square or the right side does not fit.
///
/// ```
/// use torse_algebra::rational::{integer, ratio};
/// use torse_geometry::developable::solve;
/// let matrix = vec![vec![integer(0), integer(2)], vec![integer(3), integer(1)]];
/// let x = solve("a test", matrix, vec![[integer(4)], [integer(9)]])?;
/// assert_eq!(x, [[ratio(7, 3).unwrap()], [integer(2)]]);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn solve<S: Coordinate, const D: usize>(
    what: &'static str,
    matrix: Vec<Vec<S>>,
    right: Vec<[S; D]>,
) -> Result<Vec<[S; D]>> {
    let size = matrix.len();
    for (index, row) in matrix.iter().enumerate() {
        if row.len() != size {
            return Err(GeometryError::LengthMismatch {
                what,
                index,
                expected: size,
                given: row.len(),
            });
        }
    }
    if right.len() != size {
        return Err(GeometryError::LengthMismatch {
            what,
            index: size,
            expected: size,
            given: right.len(),
        });
    }
    let mut open: Vec<(Vec<S>, [S; D])> = matrix.into_iter().zip(right).collect();
    let mut solved: Vec<(Vec<S>, [S; D])> = Vec::with_capacity(size);
    for column in 0..size {
        let singular = || GeometryError::SingularSystem {
            what,
            at: Place::Index(column),
        };
        let index = pivot(&open, column).ok_or_else(singular)?;
        let (row, value) = open.swap_remove(index);
        let Some(head) = row.get(column).cloned() else {
            return Err(singular());
        };
        for (other, target) in &mut open {
            let Some(entry) = other.get(column) else {
                continue;
            };
            let factor = entry.divided_by(&head).map_err(|_| singular())?;
            eliminate(other, target, &factor, &row, &value, column);
        }
        solved.push((row, value));
    }
    let mut solution: Vec<[S; D]> = Vec::with_capacity(size);
    // Backwards: solution holds x[size-1], x[size-2], ..
    for (column, (row, value)) in solved.iter().enumerate().rev() {
        let singular = || GeometryError::SingularSystem {
            what,
            at: Place::Index(column),
        };
        let mut rest = value.clone();
        for (entry, known) in row.iter().rev().zip(&solution) {
            for (slot, k) in rest.iter_mut().zip(known) {
                *slot = slot.clone() - entry.clone() * k.clone();
            }
        }
        let head = row.get(column).ok_or_else(singular)?;
        for slot in &mut rest {
            *slot = slot.divided_by(head).map_err(|_| singular())?;
        }
        solution.push(rest);
    }
    solution.reverse();
    Ok(solution)
}

fn eliminate<S: Coordinate, const D: usize>(
    row: &mut [S],
    right: &mut [S; D],
    factor: &S,
    pivot_row: &[S],
    pivot_right: &[S; D],
    from: usize,
) {
    for (entry, p) in row.iter_mut().zip(pivot_row).skip(from) {
        *entry = entry.clone() - factor.clone() * p.clone();
    }
    for (entry, p) in right.iter_mut().zip(pivot_right) {
        *entry = entry.clone() - factor.clone() * p.clone();
    }
}

/// The index of the row to eliminate with.
fn pivot<S: Coordinate, const D: usize>(rows: &[(Vec<S>, [S; D])], column: usize) -> Option<usize> {
    let square = |index: usize| {
        let entry = rows.get(index)?.0.get(column)?;
        Some(entry.clone() * entry.clone())
    };
    let mut best: Option<(usize, S)> = None;
    for index in 0..rows.len() {
        let Some(size) = square(index) else { continue };
        if is_zero(&size) {
            continue;
        }
        let larger = match &best {
            None => true,
            Some((_, s)) => (size.clone() - s.clone()).sign() == Some(std::cmp::Ordering::Greater),
        };
        if larger {
            best = Some((index, size));
        }
    }
    best.map(|(index, _)| index)
}

/// Names the parameter that makes a system singular.
pub(super) fn singular_for<S: Coordinate>(what: &'static str, k: &S) -> GeometryError {
    GeometryError::SingularSystem {
        what,
        at: Place::Parameter(k.approximate()),
    }
}
