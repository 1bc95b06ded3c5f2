//! Derives the right side anew in the printed terms.
//!
//! A formula with more than two slips is still built from the right parts. Its terms, and their products with one
//! further name of the claim, get unknown rational coefficients; the equations for them are linear, and solved exactly
//! modulo a prime. Printed terms come first, so a further name enters only where they do not suffice. A solution is
//! **proved** like any statement. The whole side is tried first, then each definition in it alone.

use super::alphabet::alphabet;
use super::residue::{of_fraction, of_rational, power, solved, to_rational};
use super::subject::Subject;
use super::target::other_side;
use super::terms::{Atoms, Powers, Terms, product};
use crate::condition::nonzero;
use crate::correction::Correction;
use num_traits::Zero;
use std::collections::BTreeMap;
use torse_algebra::Fraction;
use torse_algebra::mersenne::{minus, plus, times};
use torse_algebra::rational::integer;
use torse_prove::context::PreparedClaim;
use torse_prove::decide_statement;
use torse_prove::evaluate::Evaluator;
use torse_prove::evaluate::value::Value;
use torse_syntax::derivation::{Claim, Written};
use torse_syntax::formula::{Expr, Node};
use torse_syntax::notation;

/// Maximum number of further names.
const MAX_NAMES: usize = 40;
/// Number of equations beyond that of unknowns.
const SURPLUS: usize = 6;
/// Maximum number of points at which a divisor may vanish before the search gives up.
const MAX_MISSES: u64 = 20;

/// The part that is derived anew: `rest + factor*body`, with the body unknown.
struct Shape {
    definition: Option<String>,
    body: Terms,
    factor: Terms,
    rest: Terms,
}

/// Searches for the printed side in its own terms.
#[must_use]
pub fn search(claim: &Claim, statement: &Written) -> Option<Correction> {
    let subject = Subject::from_claim(claim, statement)?;
    let case = PreparedClaim::new(claim, statement, BTreeMap::new()).ok()?;
    let wanted = single(other_side(&case.statement, &subject.path)?)?;
    let mut atoms = Atoms::default();
    let printed = atoms.expanded(&subject.formula)?;
    let shapes = shapes(claim, &printed, &mut atoms);
    let further = further(claim, statement, &subject, &case.evaluator, &mut atoms);
    let most = shapes.iter().map(|s| 2 * s.body.len()).max()? + SURPLUS;
    let points = points(&subject, &case.evaluator, &atoms, &wanted, most)?;
    shapes.iter().find_map(|shape| {
        let found = solutions(shape, &further, &points);
        let (best, outermost) = found.iter().min_by_key(|(terms, _)| terms.len())?;
        let body = atoms.collected(best, outermost);
        let unique = found.len() == 1;
        proved(claim, statement, &subject, shape, &body, unique)
    })
}

/// The value of a number or a generic vector.
pub(super) fn single(value: &Value) -> Option<Fraction> {
    match value.entries().as_slice() {
        [entry] => entry.as_fraction().cloned(),
        _ => None,
    }
}

/// Returns the whole side, and each definition that it is linear in.
fn shapes(claim: &Claim, printed: &Terms, atoms: &mut Atoms) -> Vec<Shape> {
    let mut shapes = vec![Shape {
        definition: None,
        body: printed.clone(),
        factor: vec![(Powers::new(), integer(1))],
        rest: vec![],
    }];
    for (atom, expr) in atoms.all().to_vec().iter().enumerate() {
        let Node::Name(name) = &expr.node else {
            continue;
        };
        let exponent = |(powers, _): &(Powers, _)| powers.get(&atom).copied().unwrap_or(0);
        if printed.iter().any(|t| !(0..=1).contains(&exponent(t))) {
            continue;
        }
        let definition = claim.declarations.definition(name);
        let body = definition.filter(|d| d.parameters.is_empty());
        let Some(body) = body.and_then(|d| atoms.expanded(&d.body.expr)) else {
            continue;
        };
        let (with, rest): (Terms, Terms) = printed.iter().cloned().partition(|t| exponent(t) == 1);
        let inverse = vec![(Powers::from([(atom, -1)]), integer(1))];
        shapes.extend(product(&with, &inverse).map(|factor| Shape {
            definition: Some(name.clone()),
            body,
            factor,
            rest,
        }));
    }
    // A single term has no shape to keep.
    shapes.retain(|shape| shape.body.len() > 1);
    shapes
}

/// Returns the atoms that printed terms may be multiplied with: numbers that the claim names, pi, and the numbers that
/// its file defines.
fn further(
    claim: &Claim,
    statement: &Written,
    subject: &Subject,
    evaluator: &Evaluator<'_>,
    atoms: &mut Atoms,
) -> Vec<usize> {
    let mut names = alphabet(claim, &statement.expr, &subject.formula).names;
    names.push("pi".to_owned());
    let here = &claim.origin.source.name;
    let defined = claim.declarations.definitions();
    let own = defined.filter(|(name, definition)| {
        definition.parameters.is_empty()
            && definition.body.origin.source.name == *here
            && !Subject::is_printed(name)
    });
    names.extend(own.map(|(name, _)| name.to_owned()));
    names.truncate(MAX_NAMES);
    let scalar = |name: &String| {
        let value = evaluator.evaluate(&Expr::name(name)).ok()?;
        matches!(value, Value::Scalar(_))
            .then(|| single(&value))
            .flatten()
    };
    let mut found: Vec<usize> = vec![];
    for name in &names {
        if scalar(name).is_some_and(|value| value.as_rational().is_none()) {
            let atom = atoms.number(&Expr::name(name));
            if !found.contains(&atom) {
                found.push(atom);
            }
        }
    }
    found
}

/// Residues at a point: of the atoms, and of the required value of the side.
struct Point {
    atoms: Vec<u64>,
    wanted: u64,
}

fn points(
    subject: &Subject,
    evaluator: &Evaluator<'_>,
    atoms: &Atoms,
    wanted: &Fraction,
    count: usize,
) -> Option<Vec<Point>> {
    let values = atoms
        .all()
        .iter()
        .map(|atom| single(&evaluator.evaluate(&subject.side(atom)).ok()?))
        .collect::<Option<Vec<Fraction>>>()?;
    let last = u64::try_from(count).ok()? + MAX_MISSES;
    let at = |point: u64| {
        let atoms = values.iter().map(|v| of_fraction(v, point));
        Some(Point {
            atoms: atoms.collect::<Option<_>>()?,
            wanted: of_fraction(wanted, point)?,
        })
    };
    let points: Vec<Point> = (1..=last).filter_map(at).take(count).collect();
    (points.len() == count).then_some(points)
}

impl Point {
    fn monomial(&self, powers: &Powers) -> Option<u64> {
        powers.iter().try_fold(1, |product, (atom, exponent)| {
            Some(times(product, power(*self.atoms.get(*atom)?, *exponent)?))
        })
    }

    fn sum(&self, terms: &Terms) -> Option<u64> {
        terms.iter().try_fold(0, |sum, (powers, value)| {
            let term = times(of_rational(value)?, self.monomial(powers)?);
            Some(plus(sum, term))
        })
    }
}

/// Returns the bodies that make the side right: in the printed terms if possible, else with one further name.
fn solutions(shape: &Shape, further: &[usize], points: &[Point]) -> Vec<(Terms, Vec<usize>)> {
    let printed: Vec<Powers> = shape
        .body
        .iter()
        .map(|(powers, _)| powers.clone())
        .collect();
    if let Some(terms) = solution(shape, &printed, points) {
        return vec![(terms, vec![])];
    }
    let with = |name: &usize| {
        let times_name = |powers: &Powers| {
            let mut powers = powers.clone();
            *powers.entry(*name).or_default() += 1;
            powers.retain(|_, e| *e != 0);
            powers
        };
        let mut columns = printed.clone();
        for powers in printed.iter().map(times_name) {
            if !columns.contains(&powers) {
                columns.push(powers);
            }
        }
        let mut terms = solution(shape, &columns, points)?;
        // Terms keep the order of the print, multiplied or not.
        let products: Vec<Powers> = printed.iter().map(times_name).collect();
        let place = |powers: &Powers| {
            let own = printed.iter().position(|p| p == powers);
            own.or_else(|| products.iter().position(|p| p == powers))
        };
        terms.sort_by_key(|(powers, _)| place(powers));
        Some((terms, vec![*name]))
    };
    further.iter().filter_map(with).collect()
}

fn solution(shape: &Shape, columns: &[Powers], points: &[Point]) -> Option<Terms> {
    let row = |point: &Point| {
        let factor = point.sum(&shape.factor)?;
        let mut row = columns
            .iter()
            .map(|powers| Some(times(factor, point.monomial(powers)?)))
            .collect::<Option<Vec<u64>>>()?;
        row.push(minus(point.wanted, point.sum(&shape.rest)?));
        Some(row)
    };
    let points = points.iter().take(columns.len() + SURPLUS);
    let rows = points.map(row).collect::<Option<Vec<_>>>()?;
    let values = solved(rows, columns.len())?;
    let mut terms = vec![];
    for (powers, value) in columns.iter().zip(values) {
        let value = to_rational(value)?;
        if !value.is_zero() {
            terms.push((powers.clone(), value));
        }
    }
    Some(terms)
}

fn proved(
    claim: &Claim,
    statement: &Written,
    subject: &Subject,
    shape: &Shape,
    body: &Expr,
    unique: bool,
) -> Option<Correction> {
    let edited = match &shape.definition {
        None => body.clone(),
        Some(name) => replaced(&subject.formula, name, body),
    };
    let expr = subject.statement(&statement.expr, &edited);
    if super::is_tautology(claim, &expr, subject) {
        return None;
    }
    let trial = Written {
        expr: expr.clone(),
        origin: statement.origin.clone(),
    };
    let conditions = decide_statement(claim, &trial).ok()?.conditions()?;
    let derived = match &shape.definition {
        None => "the right side derived anew from the printed terms".to_owned(),
        Some(name) => format!(
            "`{name}` derived anew from its printed terms: `{}`",
            notation::text(body)
        ),
    };
    Some(Correction {
        statement: notation::formula(&expr),
        conditions: conditions.iter().map(nonzero).collect(),
        edits: vec![derived],
        unique,
    })
}

/// Replaces a name in the formula by a formula.
fn replaced(expr: &Expr, name: &str, by: &Expr) -> Expr {
    if matches!(&expr.node, Node::Name(own) if own == name) {
        return by.clone();
    }
    expr.with_parts(|part| replaced(part, name, by))
}
