//! Finds the slip behind a printed determinant: which entries of the matrix give exactly the printed value?
//!
//! A determinant that is wrong for the printed matrix is often that of a matrix in which one or two entries differ: by
//! the sign, by a factor more, by a factor less. The determinant is evaluated modulo a prime at pseudo-random points
//! for every such change of one entry, then of two; a match is **proved** with the changed matrix.

use super::ansatz::single;
use super::data::with;
use super::edit::placed;
use super::residue::{of_fraction, power};
use crate::certificate::DecisionCertificate;
use crate::correction::{DataChange, DataCorrection};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use torse_algebra::mersenne::{minus, times};
use torse_algebra::rational::integer;
use torse_prove::context::PreparedClaim;
use torse_prove::decide_statement;
use torse_prove::evaluate::Evaluator;
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::{Expr, Node, Operator, Relation};
use torse_syntax::notation;

/// Maximum size of a matrix.
const MAX_SIDE: usize = 8;
/// Number of points at which a changed determinant must match before it is proved.
const POINTS: std::ops::RangeInclusive<u64> = 1..=3;
/// Maximum number of changes that are proved.
const MAX_PROOFS: usize = 8;

/// A square matrix of residues, row by row.
type Residues = Vec<Vec<u64>>;

/// An entry, by row and column, and what it may have been.
#[derive(Debug, Clone)]
struct Slip {
    row: usize,
    column: usize,
    entry: Expr,
    /// Its residue at each point.
    values: Vec<u64>,
}

/// Searches for the entries behind a refuted `det(M) == value`, where M is a definition of the file.
#[must_use]
pub fn search(claim: &Claim, statement: &Written) -> Option<DataCorrection> {
    let (name, printed) = sides(&statement.expr)?;
    let body = &claim.declarations.definition(name)?.body.expr;
    let rows = square(body)?;
    let case = PreparedClaim::new(claim, statement, BTreeMap::new()).ok()?;
    let at = |expr: &Expr| residues(expr, &case.evaluator);
    let wanted = at(printed)?;
    let entries: Vec<Vec<Vec<u64>>> = rows
        .iter()
        .map(|row| row.iter().map(at).collect::<Option<_>>())
        .collect::<Option<_>>()?;
    let names: BTreeSet<&str> = printed.names().into_iter().chain(body.names()).collect();
    let mut slips = vec![];
    for (r, row) in rows.iter().enumerate() {
        for (c, entry) in row.iter().enumerate() {
            // A zero stays zero under every change.
            if entries.get(r)?.get(c)?.iter().all(|value| *value == 0) {
                continue;
            }
            slips.extend(slipped(entry, &names).into_iter().filter_map(|entry| {
                Some(Slip {
                    row: r,
                    column: c,
                    values: at(&entry)?,
                    entry,
                })
            }));
        }
    }
    let agrees = |changes: &[&Slip]| {
        (0..wanted.len()).all(|point| {
            let at_point = |values: &Vec<u64>| values.get(point).copied().unwrap_or(0);
            let mut matrix: Residues = entries
                .iter()
                .map(|row| row.iter().map(at_point).collect())
                .collect();
            for slip in changes {
                let row = matrix.get_mut(slip.row);
                if let Some(slot) = row.and_then(|row| row.get_mut(slip.column)) {
                    *slot = at_point(&slip.values);
                }
            }
            determinant(matrix) == wanted.get(point).copied()
        })
    };
    let one = slips.iter().map(|slip| vec![slip]);
    let one: Vec<Vec<&Slip>> = one.filter(|change| agrees(change)).collect();
    let found = match one.is_empty() {
        false => one,
        true => two(&slips).filter(|change| agrees(change)).collect(),
    };
    let mut proved = found
        .iter()
        .take(MAX_PROOFS)
        .filter_map(|change| proved(claim, statement, name, change));
    let mut best = proved.next()?;
    best.unique = proved.next().is_none();
    Some(best)
}

/// Two changes of different entries.
fn two(slips: &[Slip]) -> impl Iterator<Item = Vec<&Slip>> {
    slips.iter().enumerate().flat_map(move |(position, first)| {
        let later = slips.iter().skip(position + 1);
        let others = later.filter(|s| (s.row, s.column) != (first.row, first.column));
        others.map(move |second| vec![first, second])
    })
}

/// Returns the name of the matrix and the printed value of `det(M) == value`.
fn sides(statement: &Expr) -> Option<(&str, &Expr)> {
    let Node::Compare(left, rest) = &statement.node else {
        return None;
    };
    let [(Relation::Equal, right)] = rest.as_slice() else {
        return None;
    };
    let other = |name| (name, right);
    matrix(left)
        .map(other)
        .or_else(|| Some((matrix(right)?, left)))
}

/// Returns the M of `det(M)`.
fn matrix(expr: &Expr) -> Option<&str> {
    let Node::Call(function, arguments) = &expr.node else {
        return None;
    };
    let Node::Name(function) = &function.node else {
        return None;
    };
    match arguments.as_slice() {
        [one] if function == "det" => match &one.node {
            Node::Name(name) => Some(name),
            _ => None,
        },
        _ => None,
    }
}

/// Returns the rows of a square matrix that is written out.
fn square(body: &Expr) -> Option<Vec<&[Expr]>> {
    let Node::List(rows) = &body.node else {
        return None;
    };
    let rows: Vec<&[Expr]> = rows
        .iter()
        .map(|row| match &row.node {
            Node::List(entries) if entries.len() == rows.len() => Some(entries.as_slice()),
            _ => None,
        })
        .collect::<Option<_>>()?;
    (rows.len() <= MAX_SIDE).then_some(rows)
}

/// Returns the residues of a number at the points.
fn residues(expr: &Expr, evaluator: &Evaluator<'_>) -> Option<Vec<u64>> {
    let value = single(&evaluator.evaluate(expr).ok()?)?;
    POINTS.map(|point| of_fraction(&value, point)).collect()
}

/// Returns what an entry may have been: with the other sign, with one of the names as a factor more or less.
fn slipped(entry: &Expr, names: &BTreeSet<&str>) -> Vec<Expr> {
    let mut slips = vec![negated(entry)];
    for name in names {
        let factor = Arc::new(Expr::name(name));
        let more = Node::Binary(Operator::Multiply, Arc::new(entry.clone()), factor);
        slips.push(Expr::made(more));
        slips.extend(without_factor(entry, name));
    }
    slips
}

/// Returns `-8*k` for `8*k`.
fn negated(entry: &Expr) -> Expr {
    match &entry.node {
        Node::Negative(inner) => (**inner).clone(),
        Node::Binary(Operator::Multiply, a, b) => {
            let first = Arc::new(negated(a));
            Expr::made(Node::Binary(Operator::Multiply, first, Arc::clone(b)))
        }
        _ => Expr::made(Node::Negative(Arc::new(entry.clone()))),
    }
}

/// Returns `-5` for `-5*k`.
fn without_factor(entry: &Expr, name: &str) -> Option<Expr> {
    let is_name = |expr: &Expr| matches!(&expr.node, Node::Name(own) if own == name);
    match &entry.node {
        Node::Negative(inner) => {
            let inner = Arc::new(without_factor(inner, name)?);
            Some(Expr::made(Node::Negative(inner)))
        }
        Node::Binary(Operator::Multiply, a, b) if is_name(b) => Some((**a).clone()),
        Node::Binary(Operator::Multiply, a, b) if is_name(a) => Some((**b).clone()),
        _ if is_name(entry) => Some(Expr::number(&integer(1))),
        _ => None,
    }
}

/// Computes the determinant by elimination; `None` only if the rows do not fit.
fn determinant(mut rows: Residues) -> Option<u64> {
    let mut product = 1;
    for column in 0..rows.len() {
        let entry = |row: &Vec<u64>| row.get(column).copied();
        let pivot = rows
            .iter()
            .skip(column)
            .position(|row| entry(row) != Some(0));
        let Some(pivot) = pivot else {
            return Some(0);
        };
        if pivot > 0 {
            rows.swap(column, column + pivot);
            product = minus(0, product);
        }
        let lead = rows.get(column)?.clone();
        let leading = entry(&lead)?;
        product = times(product, leading);
        let inverse = power(leading, -1)?;
        for row in rows.iter_mut().skip(column + 1) {
            let factor = times(entry(row)?, inverse);
            for (slot, other) in row.iter_mut().zip(&lead) {
                *slot = minus(*slot, times(factor, *other));
            }
        }
    }
    Some(product)
}

/// Returns the statement with the changed matrix, if it is proved without conditions.
fn proved(
    claim: &Claim,
    statement: &Written,
    name: &str,
    slips: &[&Slip],
) -> Option<DataCorrection> {
    let mut definition = claim.declarations.definition(name)?.clone();
    let mut changes = vec![];
    for slip in slips {
        let path = [slip.row, slip.column];
        let old = definition.body.expr.parts().into_iter().nth(slip.row)?;
        let old = notation::formula(old.parts().into_iter().nth(slip.column)?);
        changes.push(DataChange {
            name: format!("{name}[{},{}]", slip.row + 1, slip.column + 1),
            old,
            new: notation::formula(&slip.entry),
        });
        definition.body.expr = placed(&definition.body.expr, &path, slip.entry.clone());
    }
    let mut declarations = (*claim.declarations).clone();
    declarations.define(name.to_owned(), definition);
    let decided = decide_statement(&with(claim, declarations), statement).ok()?;
    let certificate = DecisionCertificate::from_decision(&decided)?;
    certificate
        .is_unconditional_proof()
        .then(|| DataCorrection {
            changes,
            certificate: Arc::new(certificate),
            unique: true,
            explains: vec![claim.entry.id.get_ref().clone()],
            contradicts: vec![],
            explains_example: false,
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_determinant_is_that_of_the_rule_of_sarrus() {
        let rows = vec![vec![0, 2, 3], vec![4, 5, 6], vec![7, 8, 10]];
        // 2*6*7 + 3*4*8 - 3*5*7 - 2*4*10
        assert_eq!(determinant(rows), Some(minus(84 + 96, 105 + 80)));
        assert_eq!(determinant(vec![vec![1, 2], vec![2, 4]]), Some(0));
    }

    #[test]
    fn an_entry_slips_by_its_sign_and_by_a_factor() {
        let texts = |text: &str| {
            let entry = torse_syntax::formula::parse(text).unwrap();
            let slips = slipped(&entry, &BTreeSet::from(["k"]));
            slips.iter().map(notation::text).collect::<Vec<_>>()
        };
        assert_eq!(texts("-80"), ["80", "-80*k"]);
        assert_eq!(texts("8*k"), ["-8*k", "8*k*k", "8"]);
        assert_eq!(texts("k"), ["-k", "k*k", "1"]);
    }
}
