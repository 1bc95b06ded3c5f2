//! Determinants, inverses and linear systems.
//!
//! Elimination needs a pivot that is certainly nonzero. Where none is known, the determinant is expanded, which needs
//! no division, and solutions are computed from determinants by Cramer's rule.

use crate::arithmetic::Arithmetic;
use crate::no_value::{NoValue, Undefined, Unknown};
use crate::series::Series;

/// The largest size of a matrix.
const MAX_SIZE: usize = 12;
/// The largest size of a determinant that is expanded.
const MAX_EXPANDED: usize = 6;

type Rows<A> = Vec<Vec<Series<<A as Arithmetic>::Number>>>;

fn check_size(size: usize, limit: usize) -> Result<(), Unknown> {
    if size > limit {
        return Err(Unknown::Large { what: "a matrix" });
    }
    Ok(())
}

/// Whether the constant term of a series is certainly nonzero, so that the series may be divided by.
fn is_unit<A: Arithmetic>(x: &Series<A::Number>, a: &A) -> bool {
    match x {
        Series::Number(n) => a.is_zero(n) == Some(false),
        Series::Powers { terms, .. } => terms.first().is_some_and(|first| is_unit(first, a)),
    }
}

/// The determinant.
///
/// # Errors
/// [`NoValue::Unknown`] for matrices that are too large or not square.
pub fn determinant<A: Arithmetic>(rows: &Rows<A>, a: &A) -> Result<Series<A::Number>, NoValue> {
    check_size(rows.len(), MAX_SIZE)?;
    if rows.iter().any(|row| row.len() != rows.len()) {
        return Err(NoValue::shape("a matrix that is not square"));
    }
    let mut rest = rows.clone();
    let mut product = Series::integer(1, a);
    while !rest.is_empty() {
        let pivot = rest
            .iter()
            .position(|row| row.first().is_some_and(|x| is_unit(x, a)));
        let Some(pivot) = pivot else {
            return product.times(&expanded(&rest, a)?, a);
        };
        let row = rest.remove(pivot);
        let Some((leading, tail)) = row.split_first() else {
            break;
        };
        product = product.times(leading, a)?;
        if pivot % 2 == 1 {
            product = product.negated(a);
        }
        rest = rest
            .iter()
            .map(|other| {
                let Some((first, others)) = other.split_first() else {
                    return Ok(vec![]);
                };
                let factor = first.over(leading, a)?;
                let pairs = others.iter().zip(tail);
                pairs
                    .map(|(x, y)| x.minus(&factor.times(y, a)?, a))
                    .collect::<Result<Vec<_>, NoValue>>()
            })
            .collect::<Result<_, _>>()?;
    }
    Ok(product)
}

/// The determinant, expanded along its first row.
fn expanded<A: Arithmetic>(rows: &Rows<A>, a: &A) -> Result<Series<A::Number>, NoValue> {
    check_size(rows.len(), MAX_EXPANDED)?;
    let Some((first, rest)) = rows.split_first() else {
        return Ok(Series::integer(1, a));
    };
    let mut total = Series::integer(0, a);
    for (column, entry) in first.iter().enumerate() {
        if entry.is_zero(a) == Some(true) {
            continue;
        }
        let minor: Rows<A> = rest.iter().map(|row| without(row, column)).collect();
        let term = entry.times(&expanded(&minor, a)?, a)?;
        total = if column % 2 == 0 {
            total.plus(&term, a)?
        } else {
            total.minus(&term, a)?
        };
    }
    Ok(total)
}

fn without<T: Clone>(row: &[T], column: usize) -> Vec<T> {
    let kept = row.iter().enumerate().filter(|(c, _)| *c != column);
    kept.map(|(_, x)| x.clone()).collect()
}

/// Solves `matrix * X = right` by elimination, or by Cramer's rule where no pivot is known to be nonzero.
///
/// # Errors
/// [`Undefined::ZeroDivisor`] for a singular matrix, [`NoValue::Unknown`] if it is not known whether the matrix is
/// singular.
pub fn solution<A: Arithmetic>(
    matrix: &Rows<A>,
    right: &Rows<A>,
    a: &A,
) -> Result<Rows<A>, NoValue> {
    if right.len() != matrix.len() {
        return Err(NoValue::shape("the right side to the matrix"));
    }
    check_size(matrix.len(), MAX_SIZE)?;
    if matrix.iter().any(|row| row.len() != matrix.len()) {
        return Err(NoValue::shape("a matrix that is not square"));
    }
    match eliminated(matrix, right, a)? {
        Some(solution) => Ok(solution),
        None => by_determinants(matrix, right, a),
    }
}

/// Gauss-Jordan elimination; `None` if no pivot is certainly nonzero.
fn eliminated<A: Arithmetic>(
    matrix: &Rows<A>,
    right: &Rows<A>,
    a: &A,
) -> Result<Option<Rows<A>>, NoValue> {
    let size = matrix.len();
    let mut rest: Rows<A> = matrix
        .iter()
        .zip(right)
        .map(|(row, values)| row.iter().chain(values).cloned().collect())
        .collect();
    let mut done: Rows<A> = vec![];
    for column in 0..size {
        let unit = |row: &Vec<_>| row.get(column).is_some_and(|x| is_unit(x, a));
        let Some(pivot) = rest.iter().position(unit) else {
            return Ok(None);
        };
        let row = rest.remove(pivot);
        let Some(leading) = row.get(column) else {
            return Ok(None);
        };
        // The entries before this column are zero already.
        let lead: Vec<_> = row
            .iter()
            .enumerate()
            .map(|(place, x)| {
                if place < column {
                    Ok(x.clone())
                } else {
                    x.over(leading, a)
                }
            })
            .collect::<Result<_, _>>()?;
        for row in rest.iter_mut().chain(&mut done) {
            let Some(factor) = row.get(column).cloned() else {
                continue;
            };
            if factor.is_zero(a) == Some(true) {
                continue;
            }
            for (x, y) in row.iter_mut().zip(&lead).skip(column) {
                *x = x.minus(&factor.times(y, a)?, a)?;
            }
        }
        done.push(lead);
    }
    let values = |row: &Vec<Series<A::Number>>| row.iter().skip(size).cloned().collect();
    Ok(Some(done.iter().map(values).collect()))
}

/// Cramer's rule, column by column.
fn by_determinants<A: Arithmetic>(
    matrix: &Rows<A>,
    right: &Rows<A>,
    a: &A,
) -> Result<Rows<A>, NoValue> {
    let size = matrix.len();
    let denominator = determinant(matrix, a)?;
    if denominator.is_zero(a) == Some(true) {
        return Err(Undefined::ZeroDivisor.into());
    }
    let width = right.first().map_or(0, Vec::len);
    let entry = |unknown: usize, column: usize| {
        let replaced: Rows<A> = matrix
            .iter()
            .zip(right)
            .map(|(row, values)| {
                let mut row = row.clone();
                if let (Some(slot), Some(value)) = (row.get_mut(unknown), values.get(column)) {
                    slot.clone_from(value);
                }
                row
            })
            .collect();
        determinant(&replaced, a)?.over(&denominator, a)
    };
    (0..size)
        .map(|unknown| (0..width).map(|column| entry(unknown, column)).collect())
        .collect()
}

/// The identity matrix.
pub fn identity<A: Arithmetic>(size: usize, a: &A) -> Rows<A> {
    let row = |r| {
        (0..size)
            .map(|c| Series::integer(i64::from(r == c), a))
            .collect()
    };
    (0..size).map(row).collect()
}

/// The inverse.
///
/// # Errors
/// As [`solution`].
pub fn inverse<A: Arithmetic>(matrix: &Rows<A>, a: &A) -> Result<Rows<A>, NoValue> {
    solution(matrix, &identity(matrix.len(), a), a)
}

/// Solves `sum of x[k] columns[k] = -right` for each right side, ignoring redundant rows; `None` if no pivot is known
/// to be nonzero for one of the columns.
///
/// # Errors
/// The errors of the arithmetic.
pub fn solved_columns<A: Arithmetic>(
    columns: &Rows<A>,
    right: &Rows<A>,
    a: &A,
) -> Result<Option<Rows<A>>, NoValue> {
    let height = columns.first().map_or(0, Vec::len);
    let all = || columns.iter().chain(right);
    let mut rest: Rows<A> = (0..height)
        .map(|r| all().filter_map(|column| column.get(r).cloned()).collect())
        .collect();
    let mut done: Rows<A> = vec![];
    for place in 0..columns.len() {
        let unit = |row: &Vec<_>| row.get(place).is_some_and(|x| is_unit(x, a));
        let Some(pivot) = rest.iter().position(unit) else {
            return Ok(None);
        };
        let lead = rest.swap_remove(pivot);
        let Some(leading) = lead.get(place).cloned() else {
            return Ok(None);
        };
        let lead: Vec<_> = lead
            .iter()
            .map(|x| x.over(&leading, a))
            .collect::<Result<_, _>>()?;
        for row in rest.iter_mut().chain(&mut done) {
            let Some(factor) = row.get(place).cloned() else {
                continue;
            };
            if factor.is_zero(a) == Some(true) {
                continue;
            }
            for (x, y) in row.iter_mut().zip(&lead) {
                *x = x.minus(&factor.times(y, a)?, a)?;
            }
        }
        done.push(lead);
    }
    let solution = |column: usize| {
        let values = done.iter();
        let values = values.filter_map(|row| row.get(columns.len() + column));
        values.map(|x| x.negated(a)).collect()
    };
    Ok(Some((0..right.len()).map(solution).collect()))
}
