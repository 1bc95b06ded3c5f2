//! Matrices and linear systems over fractions.

use super::quantity::Quantity;
use super::value::{Value, Vector};
use super::wrong_type;
use crate::unknown::Unknown;
use std::collections::BTreeMap;
use torse_algebra::matrix::{Matrix, MatrixError};
use torse_algebra::{Fraction, Polynomial, Rational, Symbol};
use torse_syntax::fault::{Fault, Problem};
use torse_syntax::formula::Place;

fn matrix<T>(rows: Vec<Vec<T>>, place: Place) -> Result<Matrix<T>, Fault> {
    Matrix::from_rows(rows).map_err(|e| fault(&e, place))
}

/// The entries as rational numbers, if all are, and nothing was divided by that may vanish.
fn rational(rows: &[Vec<Fraction>]) -> Option<Vec<Vec<Rational>>> {
    let number = |entry: &Fraction| match entry.conditions() {
        [] => entry.as_rational(),
        _ => None,
    };
    rows.iter()
        .map(|row| row.iter().map(number).collect())
        .collect()
}

fn fault(error: &MatrixError, place: Place) -> Fault {
    match error {
        MatrixError::Singular { .. } => Fault::at(
            place,
            Problem::ZeroDivisor {
                divisor: "the determinant".to_owned(),
            },
        ),
        other => Fault::at(
            place,
            Problem::Shapes {
                left: other.to_string(),
                right: "the operation".to_owned(),
            },
        ),
    }
}

/// The entries as quantities.
fn quantities(matrix: &Matrix<Fraction>) -> Vec<Vec<Quantity>> {
    matrix
        .rows()
        .map(|row| row.iter().cloned().map(Quantity::from).collect())
        .collect()
}

/// The determinant.
pub(super) fn determinant(rows: &[Vec<Fraction>], place: Place) -> Result<Fraction, Fault> {
    let determinant = match rational(rows) {
        Some(rows) => matrix(rows, place)?.determinant().map(Fraction::from),
        None => matrix(rows.to_vec(), place)?.determinant(),
    };
    determinant.map_err(|e| fault(&e, place))
}

/// The inverse, by the adjugate: the determinant is the only divisor.
pub(super) fn inverse(rows: &[Vec<Fraction>], place: Place) -> Result<Value, Fault> {
    Ok(Value::Matrix(quantities(&inverted(rows, place)?)))
}

/// The most terms that the determinant may have in all entries of an inverse together: each of them has it as a divisor.
const MAX_INVERSE: usize = 100_000;

fn inverted(rows: &[Vec<Fraction>], place: Place) -> Result<Matrix<Fraction>, Fault> {
    let determinant = determinant(rows, place)?;
    let terms = determinant.numerator().len();
    if terms.saturating_mul(rows.len() * rows.len()) > MAX_INVERSE {
        return Err(Fault::limit(
            place,
            format!("the inverse of a matrix whose determinant has {terms} terms"),
        ));
    }
    let inverse = Fraction::integer(1)
        .over(&determinant)
        .map_err(|e| Fault::exact(place, e))?;
    let adjugate = match rational(rows) {
        Some(rows) => {
            let adjugate = matrix(rows, place)?.adjugate();
            adjugate.map(|adjugate| adjugate.map(|entry| entry.clone().into()))
        }
        None => matrix(rows.to_vec(), place)?.adjugate(),
    };
    let adjugate = adjugate.map_err(|e| fault(&e, place))?;
    Ok(adjugate.map(|entry: &Fraction| entry.clone() * inverse.clone()))
}

/// The solution x of `A x = right`, for a vector or a matrix of right sides.
pub(super) fn solve(rows: &[Vec<Fraction>], right: &Value, place: Place) -> Result<Value, Fault> {
    let inverse = inverted(rows, place)?;
    let columns: Vec<Vec<Quantity>> = match right {
        Value::Vector(v) if !v.generic => v.entries.iter().map(|q| vec![q.clone()]).collect(),
        Value::Matrix(rows) => rows.clone(),
        other => {
            return Err(wrong_type(
                place,
                other.kind(),
                "a vector or matrix of right sides",
            ));
        }
    };
    let left: Vec<Vec<Quantity>> = quantities(&inverse);
    let product = super::matrix_product(&left, &columns, place)?;
    Ok(match right {
        Value::Vector(_) => Value::Vector(Vector {
            entries: product.into_iter().flatten().collect(),
            generic: false,
        }),
        _ => Value::Matrix(product),
    })
}

/// `form = sum of row[i] * unknowns[i] + rest`, if it is linear in the unknowns, which stand in no function.
pub(crate) fn linear_form(
    form: &Fraction,
    unknowns: &[Unknown],
) -> Option<(Vec<Fraction>, Fraction)> {
    let involved = |p: &Polynomial| {
        let mut own = p.symbols().iter();
        own.any(|symbol| unknowns.iter().any(|unknown| unknown.stands_in(symbol)))
    };
    if form.denominator_factors().any(|(p, _)| involved(p)) {
        return None;
    }
    let below: Fraction = form.denominator().into();
    let over = |p: Polynomial| {
        Fraction::from(p)
            .over(&below)
            .ok()
            .map(|f| f.under(form.conditions()))
    };
    let mut rest = form.numerator().clone();
    let mut row = vec![];
    for unknown in unknowns {
        let by_power = rest.coefficients_in(unknown.symbol());
        let coefficient = match by_power.as_slice() {
            [] | [_] => Polynomial::zero(),
            [_, linear] => linear.clone(),
            _ => return None,
        };
        if involved(&coefficient) {
            return None;
        }
        if by_power.len() == 2 {
            rest = by_power.into_iter().next()?;
        }
        row.push(over(coefficient)?);
    }
    if involved(&rest) {
        return None;
    }
    Some((row, over(rest)?))
}

/// A solved linear system.
#[derive(Debug, Clone, Default)]
pub struct Solution {
    /// The value of each symbol.
    pub values: BTreeMap<Symbol, Fraction>,
    /// The equations that determine them, by their places.
    pub used: Vec<usize>,
    /// What the equations say beyond that: each is zero.
    pub rest: Vec<Fraction>,
}

/// Longer determinants are not multiplied out: then every pivot is a condition.
const MAX_DETERMINANT: usize = 400;

/// Solves linear equations `form = 0` for unknowns.
///
/// The values are those of Cramer's rule, so they are known wherever the determinant is not zero; the pivots of the
/// elimination, which may vanish there, are no conditions.
///
/// # Errors
/// A [`Fault`] when the equations are not linear or do not determine the symbols.
pub fn solve_for(
    forms: &[Fraction],
    unknowns: &[Unknown],
    place: Place,
) -> Result<Solution, Fault> {
    let mut rows: Vec<(Vec<Fraction>, Fraction)> = vec![];
    for form in forms {
        let split = linear_form(form, unknowns);
        rows.push(split.ok_or_else(|| {
            wrong_type(
                place,
                "a nonlinear equation",
                "equations linear in the unknowns",
            )
        })?);
    }
    let divisors: Vec<Polynomial> = forms.iter().flat_map(|f| f.conditions().to_vec()).collect();
    let mut determinant = Some(Fraction::integer(1));
    let mut places: Vec<usize> = (0..rows.len()).collect();
    let mut chosen = vec![];
    // Gauss-Jordan elimination; every pivot is recorded by the fractions themselves.
    let mut used: Vec<(usize, Vec<Fraction>, Fraction)> = vec![];
    for column in 0..unknowns.len() {
        let pivot = rows
            .iter()
            .position(|(row, _)| row.get(column).is_some_and(|f| !f.is_zero()));
        let Some(pivot) = pivot else {
            let name = unknowns
                .get(column)
                .map_or_else(String::new, |unknown| unknown.symbol().to_string());
            return Err(Fault::limit(
                place,
                format!("the given equations do not determine {name}"),
            ));
        };
        let (row, constant) = rows.remove(pivot);
        chosen.push(places.remove(pivot));
        let lead = row.get(column).cloned().unwrap_or_else(Fraction::zero);
        determinant = determinant
            .filter(|d| d.numerator().len() * lead.numerator().len() <= MAX_DETERMINANT)
            .map(|d| d * lead.clone().without_conditions());
        let exact = |e| Fault::exact(place, e);
        let row: Vec<Fraction> = row
            .iter()
            .map(|f| f.over(&lead))
            .collect::<Result<_, _>>()
            .map_err(exact)?;
        let constant = constant.over(&lead).map_err(exact)?;
        let eliminate = |other: &mut Vec<Fraction>, other_constant: &mut Fraction| {
            let factor = other.get(column).cloned().unwrap_or_else(Fraction::zero);
            if factor.is_zero() {
                return;
            }
            for (slot, f) in other.iter_mut().zip(&row) {
                *slot = slot.clone() - factor.clone() * f.clone();
            }
            *other_constant = other_constant.clone() - factor * constant.clone();
        };
        for (other, other_constant) in &mut rows {
            eliminate(other, other_constant);
        }
        for (_, other, other_constant) in &mut used {
            eliminate(other, other_constant);
        }
        used.push((column, row, constant));
    }
    let known = |value: Fraction| match &determinant {
        Some(determinant) => {
            let condition = determinant.numerator().primitive().1;
            let nonconstant = condition.as_constant().is_none();
            let conditions: Vec<Polynomial> =
                nonconstant.then_some(condition).into_iter().collect();
            value
                .without_conditions()
                .under(&conditions)
                .under(&divisors)
        }
        None => value,
    };
    let mut values = BTreeMap::new();
    for (column, _, constant) in used {
        if let Some(unknown) = unknowns.get(column) {
            values.insert(unknown.symbol().clone(), known(-constant));
        }
    }
    let rest = rows.into_iter().map(|(_, constant)| known(constant));
    Ok(Solution {
        values,
        used: chosen,
        rest: rest.filter(|form| !form.is_zero()).collect(),
    })
}
