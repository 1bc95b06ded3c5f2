//! Joins of two curves (or plane families) of one basis family, solved for the next control points.
//!
//! With `e_0 = Q1[0]`, `e_i = Q1[i] - Q1[i-1]` at the start of the second and `d_0 = Q[m]`,
//! `d_i = Q[m-i+1] - Q[m-i]` at the end of the first,
//!
//! `F1^(j)(0) = sum over i <= j of a[j,i] e_i`, `F^(j)(1) = sum over i of b[j,i] d_i`.
//!
//! The condition `F1^(j)(0) = sum over l of t[j,l] F^(l)(1)` is triangular in the e_j, so forward
//! substitution solves it for every degree: `e_j = sum over i of c[j,i] d_i` with
//!
//! `c[j,i] = (sum over l of t[j,l] b[l,i] - sum over l < j of a[j,l] c[l,i]) / a[j,j]`.
//!
//! Small solutions are written out. Larger ones keep a, b and c as names, so that the conditions of
//! order three stay a page of short lines.

use super::end::{Curve, Differences, End, Family, Shape, checked};
use super::names::Names;
use super::{Derivation, DeriveError, Line};
use crate::condition::{different_from_zero, nonzero_expression};
use std::sync::Arc;
use torse_algebra::{Affine, Fraction, Polynomial, Symbol};
use torse_prove::decide::conditions::separated;
use torse_prove::evaluate::linear::solve_for;
use torse_prove::evaluate::value::UNPLACED;
use torse_prove::formula;
use torse_prove::unknown::Unknown;
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::formula::{Expr, Operator};

/// Maximum number of nodes of a point for which a solution is written out.
const MAX_WRITTEN_OUT: usize = 60;

/// Maximum order of a join.
const MAX_JOIN: u8 = 3;

/// A condition of geometric continuity.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Geometric {
    /// A common tangent (plane) at the join: `F1' = gamma F'`.
    G1,
    /// Farin-Boehm: the homogeneous coordinates join with equal first and second derivatives.
    FarinBoehm,
    /// The beta constraints: `F1' = gamma F'`, `F1'' = gamma^2 F'' + lambda F'`.
    Beta,
}

/// Derives the join of order `order` (C1, C2 or C3) of two curves of the family, with degrees m and n: the next control
/// points `Q1[0], ..., Q1[order]`. The shape parameters of the second curve carry the suffix 1.
///
/// # Errors
/// [`DeriveError`]: no such basis, an order outside 1..=3, ends that are not determined by the points.
pub fn continuity(
    declarations: &Declarations,
    basis: &str,
    order: u8,
    shape: Shape,
) -> Result<Derivation, DeriveError> {
    let order = checked(order, MAX_JOIN)?;
    let one = Fraction::integer(1);
    let rows = (0..=usize::from(order)).map(|j| vec![(j, one.clone())]);
    let kind = match shape.rational {
        true => "rational curves",
        false => "curves",
    };
    let title = format!("C{order} join of two {kind} of the family {basis}");
    let family = Family::new(declarations, basis, shape)?;
    let names = family.names()?;
    solved(&family, names, &title, &rows.collect::<Vec<_>>())
}

/// Derives a join with geometric continuity of two plane families (or curves in homogeneous coordinates).
///
/// # Errors
/// [`DeriveError`]: no such basis, ends that are not determined by the points.
pub fn geometric(
    declarations: &Declarations,
    basis: &str,
    condition: Geometric,
    shape: Shape,
) -> Result<Derivation, DeriveError> {
    let one = Fraction::integer(1);
    let family = Family::new(declarations, basis, shape)?;
    // The factors of the condition are named after the family and avoid its names.
    let mut names = family.names()?;
    let (gamma, lambda) = match condition {
        Geometric::G1 => (names.fresh("gamma"), String::new()),
        Geometric::FarinBoehm => (String::new(), String::new()),
        Geometric::Beta => (names.fresh("gamma"), names.fresh("lambda")),
    };
    let gamma = Fraction::named(&gamma);
    let point = vec![(0, one.clone())];
    let tangent = vec![(1, gamma.clone())];
    let (title, rows) = match condition {
        Geometric::G1 => ("G1 join", vec![point, tangent]),
        Geometric::FarinBoehm => (
            "Farin-Boehm G2 join",
            vec![point, vec![(1, one.clone())], vec![(2, one)]],
        ),
        Geometric::Beta => {
            let curvature = vec![(1, Fraction::named(&lambda)), (2, gamma.clone() * gamma)];
            ("G2-beta join", vec![point, tangent, curvature])
        }
    };
    let title = match shape.rational {
        true => format!("{title} of two rational curves of the family {basis}"),
        false => format!("{title} of two plane families over the basis {basis}"),
    };
    solved(&family, names, &title, &rows)
}

/// Returns the row j of a condition: `F1^(j) = sum of factor F^(l)`.
type Row = Vec<(usize, Fraction)>;

fn solved(
    family: &Family<'_>,
    mut names: Names,
    title: &str,
    rows: &[Row],
) -> Result<Derivation, DeriveError> {
    let mut parameters = family.symbols()?;
    let factors = rows.iter().flatten().flat_map(|(_, f)| f.symbols());
    let mut chosen: Vec<String> = factors.map(|s| s.to_string()).collect();
    chosen.sort();
    chosen.dedup();
    let own = |names: &mut Names| -> Vec<String> {
        let renamed = family.basis.parameters.iter();
        renamed.map(|p| names.fresh(&format!("{p}1"))).collect()
    };
    let second_parameters = own(&mut names);
    let (m, n) = (
        family.degree("m", &mut names),
        family.degree("n", &mut names),
    );
    let (q, q1) = (names.fresh("Q"), names.fresh("Q1"));
    let weights = family
        .is_rational()
        .then(|| [names.fresh("w"), names.fresh("w1")]);
    let [w, w1] = match &weights {
        Some([w, w1]) => [Some(w.as_str()), Some(w1.as_str())],
        None => [None, None],
    };
    let first = family.curve(&m, &q, w, &family.basis.parameters)?;
    let second = family.curve(&n, &q1, w1, &second_parameters)?;
    let title = format!("{title}, degrees {m} and {n}");
    let named = |degree: &Affine| -> Vec<String> {
        degree
            .multiples()
            .map(|(name, _)| name.to_owned())
            .collect()
    };
    let symbols = [named(&m), named(&n)].concat();
    parameters.extend(second_parameters);
    parameters.extend(chosen);
    if !family.is_triangular() {
        return linear(&first, &second, rows, (title, symbols, parameters));
    }
    let join = Join::new(&first, &second, rows)?;
    let written_out = join.written_out()?;
    let small = |line: &Line| line.right.size() <= MAX_WRITTEN_OUT;
    let (lines, divisors) = match written_out {
        Some(lines) if lines.iter().all(small) => (lines, join.divisors()),
        _ => join.abbreviated(&mut names),
    };
    let reach = join.b.iter().map(Vec::len).max().unwrap_or(1) - 1;
    let degrees = [
        first.degree_at_least(reach),
        second.degree_at_least(rows.len() - 1),
    ];
    let conditions = degrees.into_iter().flatten().chain(divisors).collect();
    let points = (0..=reach).map(|i| formula::expression(&first.point(End::Finish, i)));
    Ok(Derivation {
        title,
        points: points.collect(),
        degrees: symbols,
        parameters,
        lines,
        conditions,
    })
}

/// Derives a join whose conditions are linear equations for the next points: for families whose ends involve more
/// points than the order, and for rational curves. Points of the second curve that the equations leave free count as
/// given.
fn linear(
    first: &Curve,
    second: &Curve,
    rows: &[Row],
    (title, degrees, parameters): (String, Vec<String>, Vec<String>),
) -> Result<Derivation, DeriveError> {
    let order = u8::try_from(rows.len() - 1).unwrap_or(MAX_JOIN);
    let starts = second.derivatives(End::Start, order)?;
    let ends = first.derivatives(End::Finish, order)?;
    let forms: Vec<Fraction> = starts
        .iter()
        .zip(rows)
        .map(|(start, row)| {
            row.iter().fold(start.clone(), |form, (l, factor)| {
                let end = ends.get(*l).cloned().unwrap_or_else(Fraction::zero);
                form - factor.clone() * end
            })
        })
        .collect();
    let unknown = |j: usize| second.point(End::Start, j).symbols();
    let unknowns = (0..rows.len()).flat_map(unknown).filter_map(Unknown::new);
    let unknowns: Vec<Unknown> = unknowns.collect();
    let solution = solve_for(&forms, &unknowns, UNPLACED).map_err(|fault| DeriveError::Open {
        reason: fault.problem.to_string(),
    })?;
    let (mut lines, mut divisors, mut points) = (vec![], vec![], vec![]);
    for (j, unknown) in unknowns.iter().enumerate() {
        let symbol = unknown.symbol();
        let value = solution.values.get(symbol).cloned();
        let value = value.unwrap_or_else(Fraction::zero);
        divisors.extend(value.conditions().iter().cloned());
        points.extend(
            value
                .symbols()
                .into_iter()
                .filter(|s| matches!(s, Symbol::Indexed(..))),
        );
        lines.push(Line {
            label: format!("next point {j}"),
            left: formula::expression(&Fraction::symbol(symbol.clone())),
            right: formula::expression(&value),
        });
    }
    points.sort();
    points.dedup();
    let reach = rows.len() - 1;
    let degree = [first.degree_at_least(reach), second.degree_at_least(reach)];
    let divisors = separated(&divisors);
    let divisors = divisors.iter().filter(|p| second.can_vanish(p, reach));
    let points = points
        .into_iter()
        .map(|s| formula::expression(&Fraction::symbol(s)));
    Ok(Derivation {
        title,
        points: points.collect(),
        degrees,
        parameters,
        lines,
        conditions: degree
            .into_iter()
            .flatten()
            .chain(divisors.map(nonzero_expression))
            .collect(),
    })
}

/// The triangular system of a join.
struct Join<'a> {
    first: &'a Curve,
    second: &'a Curve,
    rows: &'a [Row],
    /// `a[j][i]`: the start of the second curve.
    a: Vec<Differences>,
    /// `b[j][i]`: the end of the first curve.
    b: Vec<Differences>,
}

/// Returns the entry `i`, or zero if there is none.
fn entry(row: &[Fraction], i: usize) -> Fraction {
    row.get(i).cloned().unwrap_or_else(Fraction::zero)
}

impl<'a> Join<'a> {
    fn new(first: &'a Curve, second: &'a Curve, rows: &'a [Row]) -> Result<Self, DeriveError> {
        let order = u8::try_from(rows.len() - 1).unwrap_or(MAX_JOIN);
        let all = |curve: &Curve, end: End| -> Result<Vec<Differences>, DeriveError> {
            let derivatives = curve.derivatives(end, order)?;
            let parts = derivatives.iter().map(|d| curve.differences(d, end));
            Ok(parts.collect())
        };
        let (a, b) = (all(second, End::Start)?, all(first, End::Finish)?);
        for (j, row) in a.iter().enumerate() {
            if row.len() > j + 1 {
                return Err(DeriveError::NotTriangular {
                    order: j,
                    index: row.len() - 1,
                });
            }
            if entry(row, j).is_zero() {
                return Err(DeriveError::Undetermined { order: j });
            }
        }
        Ok(Self {
            first,
            second,
            rows,
            a,
            b,
        })
    }

    /// Returns the next points as formulas of the given ones; `None` if a divisor is the zero function.
    fn written_out(&self) -> Result<Option<Vec<Line>>, DeriveError> {
        // Avoids the work if the formula is already too long.
        let longest = self.a.iter().chain(&self.b).flatten();
        if longest.map(|f| f.numerator().len()).max() > Some(8) {
            return Ok(None);
        }
        let width = self.b.iter().map(Vec::len).max().unwrap_or(0);
        let mut c: Vec<Differences> = vec![];
        let mut point = Fraction::zero();
        let mut lines = vec![];
        for (j, row) in self.rows.iter().enumerate() {
            let a = self.a.get(j).map_or(&[][..], Vec::as_slice);
            let mut solution = vec![];
            for i in 0..width {
                let wanted = row.iter().fold(Fraction::zero(), |sum, (l, factor)| {
                    let b = self.b.get(*l).map_or(&[][..], Vec::as_slice);
                    sum + factor.clone() * entry(b, i)
                });
                let known = c.iter().zip(a).fold(Fraction::zero(), |sum, (c, a)| {
                    sum + a.clone() * entry(c, i)
                });
                let Ok(quotient) = (wanted - known).over(&entry(a, j)) else {
                    return Ok(None);
                };
                point = point + quotient.clone() * self.first.difference(End::Finish, i);
                solution.push(quotient);
            }
            c.push(solution);
            lines.push(self.line(j, formula::expression(&point)));
        }
        Ok(Some(lines))
    }

    /// Returns the divisors a[j,j] that can vanish, as conditions.
    fn divisors(&self) -> Vec<Expr> {
        let diagonal = self.a.iter().enumerate().map(|(j, row)| entry(row, j));
        let mut all: Vec<Polynomial> = diagonal
            .flat_map(|f| {
                let own = std::iter::once(f.numerator().primitive().1);
                own.chain(f.conditions().iter().cloned())
                    .collect::<Vec<_>>()
            })
            .chain(
                self.b
                    .iter()
                    .flatten()
                    .flat_map(|f| f.conditions().to_vec()),
            )
            .filter(|p| self.second.can_vanish(p, self.rows.len() - 1))
            .collect();
        all.sort();
        all.dedup();
        all.iter().map(nonzero_expression).collect()
    }

    fn line(&self, j: usize, right: Expr) -> Line {
        Line {
            label: format!("next point {j}"),
            left: formula::expression(&self.second.point(End::Start, j)),
            right,
        }
    }

    /// Returns the divisor of the derivatives at both ends, if it can vanish.
    fn denominators(&self) -> Vec<Polynomial> {
        let entries = self.a.iter().chain(&self.b).flatten();
        let all = entries.flat_map(|f| f.conditions().to_vec());
        let all: Vec<Polynomial> = all
            .filter(|p| self.second.can_vanish(p, self.rows.len() - 1))
            .collect();
        separated(&all)
    }

    /// Returns the solution with names for the coefficients, and the divisors by name.
    fn abbreviated(&self, names: &mut Names) -> (Vec<Line>, Vec<Expr>) {
        let mut lines = vec![];
        let mut named = |letter: &str, rows: &[Differences], of: &str| -> Vec<Vec<Option<Expr>>> {
            let mut name = |j: usize, i: usize, value: &Fraction| {
                if value.is_zero() {
                    return None;
                }
                if value.as_rational().is_some() {
                    return Some(formula::expression(value));
                }
                let name = Expr::name(&names.fresh(&format!("{letter}{j}{i}")));
                lines.push(Line {
                    label: format!("derivative {j} at {of}, coefficient of difference {i}"),
                    left: name.clone(),
                    right: formula::expression(value),
                });
                Some(name)
            };
            let rows = rows.iter().enumerate();
            rows.map(|(j, row)| (0..).zip(row).map(|(i, v)| name(j, i, v)).collect())
                .collect()
        };
        let a = named("a", &self.a, "the start of the second");
        let b = named("b", &self.b, "the end of the first");
        let width = b.iter().map(Vec::len).max().unwrap_or(0);
        let mut c: Vec<Vec<Option<Expr>>> = vec![];
        let mut divisors = vec![];
        let (mut coefficients, mut points) = (vec![], vec![]);
        for (j, row) in self.rows.iter().enumerate() {
            let divisor = cell(&a, j, j);
            let pivot = self
                .a
                .get(j)
                .map_or_else(Fraction::zero, |row| entry(row, j));
            let can_vanish = self
                .second
                .can_vanish(pivot.numerator(), self.rows.len() - 1);
            divisors.extend(
                divisor
                    .clone()
                    .filter(|_| can_vanish)
                    .map(different_from_zero),
            );
            let mut solution = vec![];
            for i in 0..width {
                let wanted = row.iter().filter_map(|(l, factor)| {
                    Some((
                        Operator::Add,
                        times(formula::expression(factor), cell(&b, *l, i)?),
                    ))
                });
                let known = (0..j).filter_map(|l| {
                    Some((Operator::Subtract, times(cell(&a, j, l)?, cell(&c, l, i)?)))
                });
                let Some(sum) = total(wanted.chain(known)) else {
                    solution.push(None);
                    continue;
                };
                let value = over(sum, divisor.clone());
                if value.names().is_empty() {
                    solution.push(Some(value));
                    continue;
                }
                let name = Expr::name(&names.fresh(&format!("c{j}{i}")));
                coefficients.push(Line {
                    label: format!(
                        "difference {j} of the next points, coefficient of difference {i}"
                    ),
                    left: name.clone(),
                    right: value,
                });
                solution.push(Some(name));
            }
            let parts = solution.iter().enumerate().filter_map(|(i, c)| {
                let difference = formula::expression(&self.first.difference(End::Finish, i));
                Some((Operator::Add, times(c.clone()?, difference)))
            });
            let before = j.checked_sub(1).map(|before| {
                let before = self.second.point(End::Start, before);
                (Operator::Add, formula::expression(&before))
            });
            if let Some(right) = total(before.into_iter().chain(parts)) {
                points.push(self.line(j, right));
            }
            c.push(solution);
        }
        lines.extend(coefficients);
        lines.extend(points);
        let others = self.denominators().into_iter();
        divisors.extend(others.map(|p| nonzero_expression(&p)));
        (lines, divisors)
    }
}

fn cell(rows: &[Vec<Option<Expr>>], j: usize, i: usize) -> Option<Expr> {
    rows.get(j)?.get(i)?.clone()
}

fn is_one(expr: &Expr) -> bool {
    *expr == Expr::number(&torse_algebra::rational::integer(1))
}

/// Multiplies, without factors one.
fn times(a: Expr, b: Expr) -> Expr {
    match (is_one(&a), is_one(&b)) {
        (true, _) => b,
        (_, true) => a,
        _ => a.with(Operator::Multiply, b),
    }
}

/// Divides, without a divisor one.
fn over(above: Expr, below: Option<Expr>) -> Expr {
    match below {
        Some(below) if !is_one(&below) => above.with(Operator::Divide, below),
        _ => above,
    }
}

/// Adds signed terms; `None` for no terms.
fn total(terms: impl Iterator<Item = (Operator, Expr)>) -> Option<Expr> {
    terms.fold(None, |sum, (operator, term)| {
        Some(match (sum, operator) {
            (None, Operator::Subtract) => {
                Expr::made(torse_syntax::formula::Node::Negative(Arc::new(term)))
            }
            (None, _) => term,
            (Some(sum), operator) => sum.with(operator, term),
        })
    })
}
