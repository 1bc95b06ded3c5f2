//! Determinants by expansion and linear systems by plain elimination.

use super::Obstacle;
use super::number::{Quotient, Work};
use std::collections::BTreeMap;
use torse_algebra::Symbol;

/// The largest determinant that is expanded.
const MAX_SIZE: usize = 7;

fn not_covered(what: &str) -> Obstacle {
    Obstacle::NotCovered {
        what: what.to_owned(),
    }
}

/// The determinant, expanded along the first row.
pub fn determinant(rows: &[Vec<Quotient>], work: &Work) -> Result<Quotient, Obstacle> {
    if rows.len() > MAX_SIZE || rows.iter().any(|row| row.len() != rows.len()) {
        return Err(not_covered("a determinant that is large or not square"));
    }
    let Some((first, rest)) = rows.split_first() else {
        return Ok(Quotient::integer(1));
    };
    let mut total = Quotient::integer(0);
    for (column, entry) in first.iter().enumerate() {
        if entry.is_zero() {
            continue;
        }
        let minor = determinant(&without_column(rest, column), work)?;
        let term = entry.times(&minor, work)?;
        let signed = if column.is_multiple_of(2) {
            term
        } else {
            term.negated()
        };
        total = total.plus(&signed, work)?;
    }
    Ok(total)
}

fn without_column(rows: &[Vec<Quotient>], column: usize) -> Vec<Vec<Quotient>> {
    let keep = |row: &Vec<Quotient>| {
        let others = row.iter().enumerate().filter(|(c, _)| *c != column);
        others.map(|(_, entry)| entry.clone()).collect()
    };
    rows.iter().map(keep).collect()
}

/// The inverse: cofactors over the determinant.
pub fn inverse(rows: &[Vec<Quotient>], work: &Work) -> Result<Vec<Vec<Quotient>>, Obstacle> {
    let whole = determinant(rows, work)?;
    let entry = |r: usize, c: usize| {
        // The entry at (r, c) of the inverse is the cofactor of (c, r).
        let others = rows.iter().enumerate().filter(|(row, _)| *row != c);
        let others: Vec<Vec<Quotient>> = others.map(|(_, row)| row.clone()).collect();
        let minor = determinant(&without_column(&others, r), work)?;
        let cofactor = if (r + c).is_multiple_of(2) {
            minor
        } else {
            minor.negated()
        };
        cofactor.over(&whole, work)
    };
    (0..rows.len())
        .map(|r| (0..rows.len()).map(|c| entry(r, c)).collect())
        .collect()
}

/// Solves `form = 0` for all forms.
pub fn solve(
    forms: &[Quotient],
    unknowns: &[Symbol],
    work: &Work,
) -> Result<BTreeMap<Symbol, Quotient>, Obstacle> {
    let nonlinear = || not_covered("a given equation that is not linear in the unknowns");
    let mut rows: Vec<Vec<Quotient>> = vec![];
    for form in forms {
        // A quotient is zero where its numerator is.
        let mut rest = form.above.clone();
        let mut row = vec![];
        for unknown in unknowns {
            let (coefficient, others) = rest.split(unknown).ok_or_else(nonlinear)?;
            let mixed = unknowns
                .iter()
                .any(|u| coefficient.split(u).is_none_or(|(c, _)| !c.is_zero()));
            if mixed {
                return Err(nonlinear());
            }
            row.push(coefficient.into());
            rest = others;
        }
        row.push(Quotient::from(rest).negated());
        rows.push(row);
    }
    for column in 0..unknowns.len() {
        let entry = |row: &Vec<Quotient>| {
            row.get(column)
                .cloned()
                .unwrap_or_else(|| Quotient::integer(0))
        };
        let open = rows.iter().enumerate().skip(column);
        let candidates = open.filter(|(_, row)| !entry(row).is_zero());
        let pivot = candidates.min_by_key(|(_, row)| entry(row).above.terms().count());
        let Some(pivot) = pivot.map(|(position, _)| position) else {
            return Err(not_covered(
                "given equations that do not determine the unknowns",
            ));
        };
        rows.swap(column, pivot);
        let Some(lead) = rows.get(column).cloned() else {
            continue;
        };
        let lead = lead
            .iter()
            .map(|e| e.over(&entry(&lead), work))
            .collect::<Result<Vec<_>, _>>()?;
        for (position, row) in rows.iter_mut().enumerate() {
            let factor = entry(row).negated();
            if position == column {
                row.clone_from(&lead);
            } else if !factor.is_zero() {
                for (slot, other) in row.iter_mut().zip(&lead) {
                    *slot = slot.plus(&factor.times(other, work)?, work)?;
                }
            }
        }
    }
    let spare = rows.iter().skip(unknowns.len());
    if spare.flat_map(|row| row.last()).any(|rest| !rest.is_zero()) {
        return Err(not_covered("given equations that contradict each other"));
    }
    let values = rows.into_iter().filter_map(|mut row| row.pop());
    Ok(unknowns.iter().cloned().zip(values).collect())
}
