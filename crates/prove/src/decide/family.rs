//! Properties of a whole basis family, for every degree.
//!
//! **Nonnegativity.** If the seeds and both factors of the step are nonnegative on the domain, so are the
//! functions of every degree: the step adds products of nonnegative functions (induction).
//!
//! **Linear independence.** For one degree the functions are brought to normal form; they are linearly
//! dependent at a choice of the shape parameters if and only if the matrix of their coefficients has less
//! than full rank there. A rank drop at one admissible choice refutes the statement exactly. For a proof
//! at every degree see [`independent`].

use super::domain::Domain;
use super::order::truth;
use super::sharpness::{Bounded, Bounds};
use super::sign;
use super::value::{Proof, quotient};
use super::witness::{self, Point};
use super::witness_search;
use super::{Decision, Refutation, Unsettled};
use crate::evaluate::Evaluator;
use crate::evaluate::value::UNPLACED;
use crate::unknown::mentions;
use torse_algebra::{Fraction, Matrix, Polynomial, Symbol};
use torse_certificate::family::{Nonnegative, Part};
use torse_certificate::point::{Comparison, Counterexample, Failure};
use torse_core::Family;
use torse_syntax::fault::Fault;
use torse_syntax::formula::Relation;

/// The degrees that are looked at one by one.
pub(super) const DEGREES: u8 = 4;

/// The seeds and step of a family as formulas of its variable and of the values that its shape parameters have on the domain:
/// a hypothesis may have given a parameter a value.
pub(super) fn family(
    basis: &Family,
    evaluator: &Evaluator<'_>,
) -> Result<([Fraction; 2], Vec<Fraction>), Fault> {
    let variable = basis.variables.iter().take(1);
    let variable = variable.map(|variable| Fraction::named(variable.name()));
    let value = |name: &str| {
        let value = evaluator.fixed().get(name).cloned();
        value.unwrap_or_else(|| Fraction::named(name))
    };
    let own: Vec<Fraction> = variable.chain(basis.parameters().map(value)).collect();
    let ((a, b), seeds) = evaluator.family(basis, &own)?;
    Ok(([a, b], seeds))
}

/// Whether the domain says something of the variable of a family. A property speaks of all values in the declared set of the
/// variable, whatever the hypotheses say of the symbol of that name.
pub(super) fn restricts_variable(basis: &Family, domain: &Domain<'_>) -> bool {
    let variable = Symbol::named(basis.variable());
    let constraints = domain.constraints.iter().map(|c| &c.value);
    let solved = domain.solved().iter().map(|(_, value)| value);
    let radicands = domain.roots.iter().map(|root| &root.radicand);
    let mut values = constraints.chain(solved).chain(radicands);
    let mut symbols = domain.solved().iter().map(|(symbol, _)| symbol);
    let is_solved = symbols.any(|symbol| symbol.depends_on(basis.variable()));
    let mut pivots = domain.pivots().iter();
    is_solved
        || values.any(|value| mentions(value, &variable))
        || pivots.any(|pivot| mentions(&pivot.clone().into(), &variable))
}

/// A divisor of seeds or step factors that is not known to be nonzero: where it vanishes the functions have no value, and a
/// property of them has none.
///
/// # Errors
/// [`Fault`] when the seeds cannot be evaluated.
pub(super) fn vanishing_divisor(
    basis: &Family,
    domain: &Domain<'_>,
    evaluator: &Evaluator<'_>,
) -> Result<Option<String>, Fault> {
    let (step, seeds) = family(basis, evaluator)?;
    for function in seeds.iter().chain(&step) {
        let ordered = domain.with_ordered_exponentials(&function.symbols());
        let mut divisors = function.conditions().iter();
        if let Some(divisor) = divisors.find(|divisor| !sign::never_zero(divisor, &ordered)) {
            let divisor = crate::formula::expression(&divisor.clone().into());
            return Ok(Some(torse_syntax::notation::text(&divisor)));
        }
    }
    Ok(None)
}

/// Decides whether every function of every degree is nonnegative on the domain.
///
/// # Errors
/// [`Fault`] when the seeds cannot be evaluated.
pub fn nonnegative(
    basis: &Family,
    domain: &Domain<'_>,
    evaluator: &Evaluator<'_>,
) -> Result<Decision, Fault> {
    let (step, seeds) = family(basis, evaluator)?;
    let mut parts = vec![];
    let all = step
        .iter()
        .map(|p| (false, p))
        .chain(seeds.iter().map(|p| (true, p)));
    for (is_seed, part) in all {
        if let Some(proved) = nonnegative_fraction(part, is_seed, domain) {
            parts.extend(proved);
            continue;
        }
        let text = torse_syntax::notation::text(&crate::formula::expression(part));
        if is_seed
            && let Some(point) = witness_search::find(part, &[], domain, Relation::Less)
            && let Some(point) = witness::described(
                &point,
                Comparison::Seed,
                std::slice::from_ref(part),
                &[Fraction::zero()],
            )
        {
            return Ok(Decision::Refuted(Box::new(Refutation::at(point))));
        }
        let what = if is_seed { "seed" } else { "step factor" };
        return Ok(Decision::open(
            format!("the sign of the {what} {text} is not settled"),
            &["Bernstein coefficients", "simple points"],
        ));
    }
    Ok(Decision::Proven(Proof::Nonnegative(Nonnegative { parts })))
}

/// A function of a family that is nowhere negative where it is defined, with what shows it of its numerator and of the
/// factors of its denominator that change the sign.
fn nonnegative_fraction(
    function: &Fraction,
    is_seed: bool,
    domain: &Domain<'_>,
) -> Option<Vec<Part<Polynomial>>> {
    let ordered = domain.with_ordered_exponentials(&function.symbols());
    let odd = function.denominator_factors().filter(|(_, n)| n % 2 == 1);
    let polynomials = std::iter::once(function.numerator()).chain(odd.map(|(factor, _)| factor));
    polynomials
        .map(|p| nonnegative_part(&p.clone().into(), is_seed, &ordered))
        .collect()
}

/// A function of a family that is nowhere negative on the domain, with what shows it.
pub(super) fn nonnegative_part(
    function: &Fraction,
    is_seed: bool,
    domain: &Domain<'_>,
) -> Option<Part<Polynomial>> {
    let polynomial = function.as_polynomial()?;
    let sign = match polynomial.is_zero() {
        true => None,
        false => Some(sign::nonnegative(polynomial, domain)?),
    };
    Some(Part {
        is_seed,
        function: polynomial.clone(),
        sign,
    })
}

/// What is to be zero or more for all functions of a family to be: where a seed is negative, a function is; where the seeds
/// and the step factors are not, no function is.
///
/// # Errors
/// [`Fault`] when the seeds cannot be evaluated.
pub fn bounds(basis: &Family, evaluator: &Evaluator<'_>) -> Result<Bounds, Fault> {
    let (step, seeds) = family(basis, evaluator)?;
    let bounded = |functions: &[Fraction]| -> Option<Vec<Bounded>> {
        let polynomials = functions.iter().map(Fraction::as_polynomial);
        let bounded = polynomials.map(|polynomial| {
            Some(Bounded {
                polynomial: polynomial?.clone(),
                strict: false,
            })
        });
        bounded.collect()
    };
    Ok(match (bounded(&seeds), bounded(&step)) {
        (Some(seeds), steps) => Bounds {
            needed: seeds,
            besides: steps,
        },
        (None, _) => Bounds {
            needed: vec![],
            besides: None,
        },
    })
}

/// All functions of one degree.
pub(super) fn functions(step: &[Fraction; 2], seeds: &[Fraction], raise: u8) -> Vec<Fraction> {
    let mut row = seeds.to_vec();
    for _ in 0..raise {
        let mut next = vec![Fraction::zero(); row.len() + 1];
        for (i, function) in row.iter().enumerate() {
            for (offset, factor) in step.iter().enumerate() {
                if let Some(slot) = next.get_mut(i + offset) {
                    *slot = slot.clone() + factor.clone() * function.clone();
                }
            }
        }
        row = next;
    }
    row
}

/// Rows: functions; columns: monomials in the variable and its sine and cosine; entries: polynomials in
/// the shape parameters.
fn coefficient_rows(functions: &[Fraction], variable: &str) -> Option<Vec<Vec<Fraction>>> {
    use std::collections::BTreeMap;
    let mut columns: BTreeMap<Polynomial, Vec<Polynomial>> = BTreeMap::new();
    for (row, function) in functions.iter().enumerate() {
        for term in function.as_polynomial()?.terms() {
            let (mut monomial, mut rest) = (
                Polynomial::integer(1),
                Polynomial::constant(&term.coefficient),
            );
            for (symbol, exponent) in term.powers {
                let power = Polynomial::symbol(symbol.clone()).power(u32::from(exponent));
                let target = if symbol.depends_on(variable) {
                    &mut monomial
                } else {
                    &mut rest
                };
                *target = &*target * &power;
            }
            let column = columns
                .entry(monomial)
                .or_insert_with(|| vec![Polynomial::zero(); functions.len()]);
            if let Some(slot) = column.get_mut(row) {
                *slot = &*slot + &rest;
            }
        }
    }
    let rows = (0..functions.len())
        .map(|row| {
            columns
                .values()
                .map(|c| c.get(row).cloned().unwrap_or_else(Polynomial::zero).into())
                .collect()
        })
        .collect();
    Some(rows)
}

/// A nonzero vector c with c A = 0 for numbers A, if the rows are dependent.
fn dependency(rows: &[Vec<Fraction>]) -> Option<Vec<Fraction>> {
    // Eliminate on [A | I]; a row of zeros in A leaves the combination on the right.
    let count = rows.len();
    let mut work: Vec<(Vec<Fraction>, Vec<Fraction>)> = rows
        .iter()
        .enumerate()
        .map(|(i, row)| {
            (
                row.clone(),
                (0..count)
                    .map(|j| Fraction::integer(i64::from(i == j)))
                    .collect(),
            )
        })
        .collect();
    let width = rows.first().map_or(0, Vec::len);
    let mut done = 0;
    for column in 0..width {
        let pivot = (done..count).find(|r| {
            work.get(*r)
                .and_then(|(a, _)| a.get(column))
                .is_some_and(|f| !f.is_zero())
        });
        let Some(pivot) = pivot else { continue };
        work.swap(done, pivot);
        let (lead_row, lead_mark) = work.get(done)?.clone();
        let lead = lead_row.get(column)?.clone();
        for (row, mark) in work.iter_mut().skip(done + 1) {
            let factor = row.get(column)?.over(&lead).ok()?;
            if factor.is_zero() {
                continue;
            }
            for (slot, f) in row
                .iter_mut()
                .zip(&lead_row)
                .chain(mark.iter_mut().zip(&lead_mark))
            {
                *slot = slot.clone() - factor.clone() * f.clone();
            }
        }
        done += 1;
    }
    work.into_iter()
        .find(|(row, _)| row.iter().all(Fraction::is_zero))
        .map(|(_, mark)| mark)
}

/// Decides whether the functions of every degree are linearly independent for all shape parameters of
/// the domain.
///
/// # Errors
/// [`Fault`] when the seeds cannot be evaluated.
pub fn independent(
    basis: &Family,
    domain: &Domain<'_>,
    evaluator: &Evaluator<'_>,
) -> Result<Decision, Fault> {
    let (step, seeds) = family(basis, evaluator)?;
    let not_polynomial =
        || Fault::limit(UNPLACED, "the functions of the family are no polynomials");
    let mut tried = vec![];
    for raise in 0..DEGREES {
        let degree = basis.degree + raise;
        let row = functions(&step, &seeds, raise);
        let rows = coefficient_rows(&row, basis.variable()).ok_or_else(not_polynomial)?;
        for point in parameter_points(basis, domain) {
            let at: Option<Vec<Vec<Fraction>>> = rows
                .iter()
                .map(|r| r.iter().map(|f| witness::at_point(f, &point)).collect())
                .collect();
            let Some(combination) = at.as_deref().and_then(dependency) else {
                continue;
            };
            let point = Counterexample {
                at: witness::values(&point),
                others: vec![],
                failure: Failure::Dependent {
                    family: basis.name.to_string(),
                    degree: u32::from(degree),
                    combination: combination.iter().map(quotient).collect(),
                },
            };
            return Ok(Decision::Refuted(Box::new(Refutation::at(point))));
        }
        match full_rank(&rows, domain) {
            true => tried.push(format!(
                "degree {degree}: a minor of the coefficient matrix never vanishes on the domain"
            )),
            false => tried.push(format!(
                "degree {degree}: no dependency at simple shape parameters"
            )),
        }
    }
    Ok(Decision::Open(Unsettled {
        reason: "independence is not proved for every degree".to_owned(),
        instances: vec![],
        tried,
    }))
}

/// Simple shape parameters, corners first; none where a hypothesis gives one of them a value that is no number.
pub(super) fn parameter_points(basis: &Family, domain: &Domain<'_>) -> Vec<Point> {
    let mut points = vec![Point::new()];
    for name in basis.parameters() {
        let symbol = Symbol::named(name);
        let mut solved = domain.solved().iter();
        if let Some((_, value)) = solved.find(|(own, _)| *own == symbol) {
            let is_number = value
                .as_polynomial()
                .and_then(Polynomial::as_constant)
                .is_some();
            if !is_number {
                return vec![];
            }
            for point in &mut points {
                point.insert(symbol.clone(), value.clone());
            }
            continue;
        }
        let interval = domain.interval(&symbol);
        let ends = [interval.lower, interval.upper].into_iter().flatten();
        let mut values: Vec<Fraction> = ends.filter(|b| b.closed).map(|b| b.value).collect();
        values.extend(
            domain
                .candidates(&symbol, witness::turns(&[], &symbol))
                .into_iter()
                .take(4),
        );
        points = points
            .into_iter()
            .flat_map(|point| {
                let symbol = symbol.clone();
                values
                    .iter()
                    .map(move |value| {
                        let mut more = point.clone();
                        more.insert(symbol.clone(), value.clone());
                        more
                    })
                    .collect::<Vec<_>>()
            })
            .collect();
    }
    points.retain(|point| {
        domain.constraints.iter().all(|c| {
            witness::at_point(&c.value, point)
                .is_some_and(|value| truth(&value, c.relation) == Some(true))
        })
    });
    points
}

/// Whether some maximal minor is known not to vanish on the domain.
fn full_rank(rows: &[Vec<Fraction>], domain: &Domain<'_>) -> bool {
    let (count, width) = (rows.len(), rows.first().map_or(0, Vec::len));
    // Windows of neighbouring columns are enough to find one in practice.
    (0..=width.saturating_sub(count)).any(|start| {
        let square: Vec<Vec<Fraction>> = rows
            .iter()
            .map(|r| r.iter().skip(start).take(count).cloned().collect())
            .collect();
        Matrix::from_rows(square)
            .and_then(|m| m.determinant())
            .is_ok_and(|d| {
                d.as_polynomial()
                    .is_some_and(|p| sign::never_zero(p, domain))
            })
    })
}
