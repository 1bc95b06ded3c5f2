//! A curve of a family at the ends of its interval.

use super::names::Names;
use super::{Derivation, DeriveError, Line, MAX_ORDER};
use crate::condition::nonzero_expression;
use num_traits::{Signed, Zero};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_algebra::{Affine, Fraction, Polynomial, Rational, Symbol, rational};
use torse_prove::decide::conditions::separated;
use torse_prove::decide::interval::exact;
use torse_prove::evaluate::Evaluator;
use torse_prove::evaluate::quantity::Quantity;
use torse_prove::evaluate::series::{Axis, Series, Target, here};
use torse_prove::evaluate::value::UNPLACED;
use torse_prove::formula;
use torse_syntax::derivation::declarations::{Basis, Declarations, SymbolKind};
use torse_syntax::formula::{Expr, Node, Operator, Relation};

/// Maximum number of nodes of a derivative that is written out.
const MAX_WRITTEN_OUT: usize = 80;

/// Maximum degree, if it is a number.
const MAX_DEGREE: u8 = 12;

/// Maximum degree at which divisors are tested for zeros.
const MAX_ROOT: usize = 10_000;

/// An end of the interval of a curve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum End {
    /// The end with the first control point.
    Start,
    /// The end with the last control point.
    Finish,
}

/// A curve of a family with symbolic degree: its series over the points `points[0], points[1], ...`.
#[derive(Debug, Clone)]
pub(super) struct Curve {
    basis_name: String,
    variable: String,
    /// The two ends of the interval.
    interval: [Fraction; 2],
    /// The degree.
    pub degree: Affine,
    /// The name of the control points.
    pub points: String,
    /// The name of the weights of a rational curve.
    pub weights: Option<String>,
    /// The degree of the seeds, the minimum.
    pub least_degree: u8,
    /// The curve without its points.
    of: Functions,
}

/// Coefficients of the points of a curve.
#[derive(Debug, Clone)]
enum Functions {
    /// For a symbolic degree.
    Operator(Box<Axis>),
    /// For a degree that is a number.
    Listed(Vec<Fraction>),
}

/// The requested curve: its degree, and whether it is rational.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Shape {
    /// The degree, if it is a number.
    pub degree: Option<u8>,
    /// Whether every point has a weight, and the curve is divided by the sum of the weights times the functions.
    pub rational: bool,
}

/// A derivative at an end in differences: `parts[0] R_0 + sum of parts[i] (R_i - R_(i-1))`, indices counted
/// from the end, differences in the direction of the curve.
pub(super) type Differences = Vec<Fraction>;

/// The basis, its interval and the symbols it depends on.
pub(super) struct Family<'a> {
    evaluator: Evaluator<'a>,
    pub name: String,
    pub basis: Arc<Basis>,
    interval: [Fraction; 2],
    shape: Shape,
}

impl<'a> Family<'a> {
    /// Looks a basis up.
    pub fn new(
        declarations: &'a Declarations,
        name: &str,
        shape: Shape,
    ) -> Result<Self, DeriveError> {
        let unknown = || DeriveError::UnknownBasis {
            name: name.to_owned(),
        };
        let basis = Arc::clone(declarations.basis(name).ok_or_else(unknown)?);
        let interval = match declarations.symbol(&basis.variable) {
            Some(SymbolKind::Real(interval)) => {
                interval.lower.as_ref().zip(interval.upper.as_ref())
            }
            _ => None,
        };
        let (lower, upper) = interval.ok_or_else(|| DeriveError::Interval {
            variable: basis.variable.clone(),
        })?;
        // A list of functions exists in its own degree only.
        let own = basis.is_list.then_some(basis.degree);
        let degree = match (own, shape.degree) {
            (Some(own), Some(degree)) if own != degree => {
                return Err(DeriveError::OneDegree { degree: own });
            }
            (own, degree) => own.or(degree),
        };
        if degree.is_none() && basis.counters.is_some() {
            return Err(DeriveError::NeedsDegree {
                name: name.to_owned(),
            });
        }
        if degree.is_some_and(|degree| degree < basis.degree || degree > MAX_DEGREE) {
            return Err(DeriveError::Degree {
                least: basis.degree,
                most: MAX_DEGREE,
            });
        }
        Ok(Self {
            shape: Shape { degree, ..shape },
            evaluator: Evaluator::new(declarations),
            name: name.to_owned(),
            interval: [exact(&lower.value), exact(&upper.value)],
            basis,
        })
    }

    /// Returns the functions of a degree with these names for the shape parameters.
    fn functions(&self, degree: u8, parameters: &[String]) -> Result<Vec<Fraction>, DeriveError> {
        let number = |n: u8| Expr::number(&rational::integer(i64::from(n)));
        let faulty = |fault| DeriveError::Basis {
            name: self.name.clone(),
            fault: Box::new(fault),
        };
        let renamed = |mut function: Fraction| {
            // Renames in two steps, so that no parameter captures another one.
            for (own, _) in self.basis.parameters.iter().zip(parameters) {
                let between = Fraction::named(&format!("{own}\u{b0}"));
                function = function.at(own, &between)?;
            }
            for (own, name) in self.basis.parameters.iter().zip(parameters) {
                function = function.at(&format!("{own}\u{b0}"), &Fraction::named(name))?;
            }
            Ok(function)
        };
        let mut all = vec![];
        for index in 0..=degree {
            let indices = vec![number(index), number(degree)];
            let member = Node::Index(Arc::new(Expr::name(&self.name)), indices);
            let value = self.evaluator.evaluate(&Expr::made(member));
            let value = value.map_err(faulty)?;
            let value = value
                .entries()
                .first()
                .and_then(|q| q.as_fraction().cloned());
            let function = value.unwrap_or_else(Fraction::zero);
            let function = renamed(function).map_err(|source| DeriveError::End {
                name: self.name.clone(),
                source,
            });
            all.push(function?);
        }
        Ok(all)
    }

    /// Returns the name of the degree, unless the family has its own.
    pub fn degree(&self, name: &str, names: &mut Names) -> Affine {
        match self.shape.degree {
            Some(degree) => Affine::number(i64::from(degree)),
            None => Affine::symbol(&names.fresh(name)),
        }
    }

    /// Whether curves are rational.
    pub fn is_rational(&self) -> bool {
        self.shape.rational
    }

    /// Whether its conditions are solved step by step; those of other families are solved as linear equations.
    pub fn is_triangular(&self) -> bool {
        self.shape.degree.is_none() && !self.shape.rational
    }

    /// Step factors and seeds with these names for the shape parameters.
    fn formulas(
        &self,
        parameters: &[String],
    ) -> Result<((Fraction, Fraction), Vec<Fraction>), DeriveError> {
        let values: Vec<Fraction> = std::iter::once(&self.basis.variable)
            .chain(parameters)
            .map(|name| Fraction::named(name))
            .collect();
        self.evaluator
            .elaborator()
            .family(&self.name, UNPLACED)
            .and_then(|family| self.evaluator.family(&family, &values))
            .map_err(|fault| DeriveError::Basis {
                name: self.name.clone(),
                fault: Box::new(fault),
            })
    }

    /// The real symbols that the family depends on: its shape parameters, then all others.
    pub fn symbols(&self) -> Result<Vec<String>, DeriveError> {
        let mut all = self.basis.parameters.clone();
        let parts = match self.shape.degree {
            Some(degree) => self.functions(degree, &self.basis.parameters)?,
            None => {
                let ((a, b), seeds) = self.formulas(&self.basis.parameters)?;
                [vec![a, b], seeds].concat()
            }
        };
        for symbol in parts.iter().flat_map(Fraction::symbols) {
            for name in symbol.names() {
                if **name != *self.basis.variable && !all.contains(&name.to_string()) {
                    all.push(name.to_string());
                }
            }
        }
        Ok(all)
    }

    /// Returns the names that nothing else may have.
    pub fn names(&self) -> Result<Names, DeriveError> {
        let variable = std::iter::once(self.basis.variable.clone());
        Ok(Names::new(variable.chain(self.symbols()?)))
    }

    /// Returns the curve of this degree over these points, with these names for the shape parameters.
    pub fn curve(
        &self,
        degree: &Affine,
        points: &str,
        weights: Option<&str>,
        parameters: &[String],
    ) -> Result<Curve, DeriveError> {
        let of = match self.shape.degree {
            Some(degree) => Functions::Listed(self.functions(degree, parameters)?),
            None => {
                let (operator, seeds) = self.formulas(parameters)?;
                Functions::Operator(Box::new(Axis {
                    operator,
                    power: degree.clone() - Affine::number(i64::from(self.basis.degree)),
                    seeds,
                    lowest: 0,
                    target: Target::Sum,
                }))
            }
        };
        Ok(Curve {
            basis_name: self.name.clone(),
            variable: self.basis.variable.clone(),
            interval: self.interval.clone(),
            degree: degree.clone(),
            points: points.to_owned(),
            weights: weights.map(str::to_owned),
            least_degree: self.basis.degree,
            of,
        })
    }
}

impl Curve {
    /// The parameter value of an end.
    fn value(&self, end: End) -> &Fraction {
        let [lower, upper] = &self.interval;
        match end {
            End::Start => lower,
            End::Finish => upper,
        }
    }

    /// The index of the point `i` steps from an end.
    fn index(&self, end: End, i: usize) -> Affine {
        let i = Affine::number(i64::try_from(i).unwrap_or(i64::MAX));
        match end {
            End::Start => i,
            End::Finish => self.degree.clone() - i,
        }
    }

    /// The point `i` steps from an end.
    pub fn point(&self, end: End, i: usize) -> Fraction {
        Fraction::symbol(Symbol::indexed(&self.points, vec![self.index(end, i)]))
    }

    /// The weight `i` steps from an end.
    pub fn weight(&self, end: End, i: usize) -> Option<Fraction> {
        let name = self.weights.as_ref()?;
        Some(Fraction::symbol(Symbol::indexed(
            name,
            vec![self.index(end, i)],
        )))
    }

    /// The curve and its derivatives up to `order` at an end, as combinations of control points.
    ///
    /// Of a rational curve N/W, from `N^(n) = sum of binom(n, j) W^(n-j) R^(j)`.
    pub fn derivatives(&self, end: End, order: u8) -> Result<Vec<Fraction>, DeriveError> {
        let at = |name: &str, index: Affine| Fraction::symbol(Symbol::indexed(name, vec![index]));
        let Some(weights) = &self.weights else {
            return self.combinations(end, order, &|index| at(&self.points, index));
        };
        let above = self.combinations(end, order, &|index| {
            at(weights, index.clone()) * at(&self.points, index)
        })?;
        let below = self.combinations(end, order, &|index| at(weights, index))?;
        let mut all: Vec<Fraction> = vec![];
        let Some(weight) = below.first() else {
            return Ok(all);
        };
        for (n, above) in above.iter().enumerate() {
            let mut rest = above.clone();
            let mut binomial = rational::integer(1);
            for (j, known) in all.iter().enumerate() {
                let rate = below.get(n - j).cloned().unwrap_or_else(Fraction::zero);
                rest = rest - Fraction::from(binomial.clone()) * rate * known.clone();
                let (up, down) = (
                    i64::try_from(n - j).unwrap_or(0),
                    i64::try_from(j + 1).unwrap_or(1),
                );
                binomial = binomial * rational::integer(up) / rational::integer(down);
            }
            let value = rest.over(weight).map_err(|source| DeriveError::End {
                name: self.basis_name.clone(),
                source,
            });
            all.push(value?);
        }
        Ok(all)
    }

    /// Returns the sum of the functions times the coefficients at their indices, and its derivatives, at an end.
    fn combinations(
        &self,
        end: End,
        order: u8,
        at: &dyn Fn(Affine) -> Fraction,
    ) -> Result<Vec<Fraction>, DeriveError> {
        let exact = |source| DeriveError::End {
            name: self.basis_name.clone(),
            source,
        };
        let mut derivative = match &self.of {
            Functions::Operator(axis) => Quantity::from(Series {
                axes: vec![(**axis).clone()],
                factor: Fraction::integer(1),
                points: at(Affine::symbol(&here(0))),
            }),
            Functions::Listed(functions) => {
                let terms = functions.iter().zip(0..);
                let terms = terms.map(|(function, i)| function.clone() * at(Affine::number(i)));
                terms.fold(Fraction::zero(), |sum, term| sum + term).into()
            }
        };
        let mut all = vec![];
        for _ in 0..=order {
            let at_end = derivative
                .mapped(|f| f.at(&self.variable, self.value(end)))
                .map_err(exact)?;
            let mut total = at_end.plain;
            for series in at_end.series {
                let (value, left) = series.settled(&|_| None, &|_| None).map_err(exact)?;
                if !left.is_empty() {
                    return Err(DeriveError::NoCollapse {
                        name: self.basis_name.clone(),
                        variable: self.variable.clone(),
                        value: self.value(end).to_string(),
                    });
                }
                total = total + value;
            }
            all.push(total);
            derivative = derivative.derivative(&self.variable);
        }
        Ok(all)
    }

    /// Returns the coefficients of the points, counted from an end.
    fn weights(&self, combination: &Fraction, end: End) -> Vec<Fraction> {
        let below = Fraction::from(combination.denominator());
        let mut weights: BTreeMap<usize, Fraction> = BTreeMap::new();
        for symbol in combination.symbols() {
            let Symbol::Indexed(name, index) = &symbol else {
                continue;
            };
            if **name != *self.points {
                continue;
            }
            let steps = index.first().and_then(|index| {
                let from = self.index(end, 0);
                let steps = match end {
                    End::Start => index.clone() - from,
                    End::Finish => from - index.clone(),
                };
                usize::try_from(steps.as_number()?).ok()
            });
            let weight = Fraction::from(combination.numerator().partial(&symbol)).over(&below);
            if let (Some(steps), Ok(weight)) = (steps, weight) {
                weights.insert(steps, weight.under(combination.conditions()));
            }
        }
        let count = weights.last_key_value().map_or(0, |(last, _)| last + 1);
        (0..count)
            .map(|i| weights.remove(&i).unwrap_or_else(Fraction::zero))
            .collect()
    }

    /// Writes a combination of points in differences.
    pub fn differences(&self, combination: &Fraction, end: End) -> Differences {
        let weights = self.weights(combination, end);
        let mut sum = Fraction::zero();
        let mut parts: Differences = weights
            .into_iter()
            .rev()
            .map(|weight| {
                sum = sum.clone() + weight;
                sum.clone()
            })
            .collect();
        parts.reverse();
        if end == End::Finish {
            // R_k - R_(k-1) runs along the curve, opposite to the count from the end.
            for part in parts.iter_mut().skip(1) {
                *part = -part.clone();
            }
        }
        parts
    }

    /// Returns the difference that the part `i` belongs to; for 0, the point itself.
    pub fn difference(&self, end: End, i: usize) -> Fraction {
        let point = self.point(end, i);
        match (i.checked_sub(1), end) {
            (None, _) => point,
            (Some(before), End::Start) => point - self.point(end, before),
            (Some(before), End::Finish) => self.point(end, before) - point,
        }
    }

    /// Writes a derivative in differences with named coefficients, and adds the lines that define these.
    fn abbreviated(
        &self,
        derivative: &Fraction,
        end: End,
        order: usize,
        label: &str,
        names: &mut Names,
        lines: &mut Vec<Line>,
    ) -> Expr {
        let letter = match end {
            End::Start => "a",
            End::Finish => "b",
        };
        let parts = self.differences(derivative, end).into_iter().enumerate();
        let terms = parts.filter(|(_, part)| !part.is_zero()).map(|(i, part)| {
            let left = Expr::name(&names.fresh(&format!("{letter}{order}{i}")));
            lines.push(Line {
                label: format!("{label}, coefficient of difference {i}"),
                left: left.clone(),
                right: formula::expression(&part),
            });
            left.with(
                Operator::Multiply,
                formula::expression(&self.difference(end, i)),
            )
        });
        let sum = terms.reduce(|sum, term| sum.with(Operator::Add, term));
        sum.unwrap_or_else(|| formula::expression(&Fraction::zero()))
    }

    /// Whether a divisor can be zero at an allowed degree. A polynomial in the degree alone is tested up to Cauchy's
    /// bound of its roots, `1 + max |c_i| / |c_n|`.
    pub fn can_vanish(&self, divisor: &Polynomial, least: usize) -> bool {
        if divisor.as_constant().is_some() {
            return divisor.is_zero();
        }
        let mut names = self.degree.multiples();
        let Some((degree, _)) = names.next() else {
            return true;
        };
        let degree = Symbol::named(degree);
        if divisor.symbols() != std::slice::from_ref(&degree) {
            return true;
        }
        let coefficients: Vec<Rational> = divisor
            .coefficients_in(&degree)
            .iter()
            .filter_map(Polynomial::as_constant)
            .collect();
        let lead = coefficients.last().map_or_else(Rational::zero, Signed::abs);
        let largest = coefficients.iter().map(Signed::abs).max();
        let bound = largest.unwrap_or_else(Rational::zero) / lead + rational::integer(1);
        let least = least.max(usize::from(self.least_degree));
        (least..=MAX_ROOT)
            .map(|n| rational::integer(i64::try_from(n).unwrap_or(i64::MAX)))
            .take_while(|n| *n <= bound)
            .any(|n| {
                let horner = |value: Rational, c: &Rational| value * &n + c;
                coefficients
                    .iter()
                    .rev()
                    .fold(Rational::zero(), horner)
                    .is_zero()
            })
    }

    /// `degree >= least`, unless it is a number.
    pub fn degree_at_least(&self, least: usize) -> Option<Expr> {
        let least = least.max(usize::from(self.least_degree));
        let (name, _) = self.degree.multiples().next()?;
        Some(compared(name, Relation::AtLeast, least))
    }
}

/// `name relation number`.
fn compared(name: &str, relation: Relation, number: usize) -> Expr {
    let number = rational::integer(i64::try_from(number).unwrap_or(i64::MAX));
    Expr::made(Node::Compare(
        Arc::new(Expr::name(name)),
        vec![(relation, Expr::number(&number))],
    ))
}

/// Checks a requested order.
pub(super) fn checked(order: u8, most: u8) -> Result<u8, DeriveError> {
    if (1..=most).contains(&order) {
        Ok(order)
    } else {
        Err(DeriveError::Order { order, most })
    }
}

/// Returns value and derivatives up to `order` of the curve `G` over the points `R[0], ..., R[k]` at both ends.
///
/// # Errors
/// [`DeriveError`]: no such basis, an order outside 1..=[`MAX_ORDER`], a basis without values at the ends.
pub fn end_derivatives(
    declarations: &Declarations,
    basis: &str,
    order: u8,
    shape: Shape,
) -> Result<Derivation, DeriveError> {
    let order = checked(order, MAX_ORDER)?;
    let family = Family::new(declarations, basis, shape)?;
    let mut names = family.names()?;
    let degree = family.degree("k", &mut names);
    let points = names.fresh("R");
    let head = names.fresh("G");
    let weights = family.is_rational().then(|| names.fresh("w"));
    let parameters = &family.basis.parameters;
    let curve = family.curve(&degree, &points, weights.as_deref(), parameters)?;
    let (mut lines, mut used, mut conditions, mut reach) = (vec![], vec![], vec![], 0);
    for (end, word) in [(End::Start, "start"), (End::Finish, "end")] {
        let derivatives = curve.derivatives(end, order)?;
        let count = derivatives
            .iter()
            .map(|d| curve.weights(d, end).len())
            .max()
            .unwrap_or(0);
        reach = reach.max(count.saturating_sub(1));
        used.extend((0..count).map(|i| curve.point(end, i)));
        used.extend((0..count).filter_map(|i| curve.weight(end, i)));
        for (n, derivative) in derivatives.iter().enumerate() {
            conditions.extend(derivative.conditions().iter().cloned());
            let label = match n {
                0 => format!("the curve at the {word}"),
                _ => format!("derivative {n} at the {word}"),
            };
            let mut right = formula::expression(derivative);
            if right.size() > MAX_WRITTEN_OUT {
                right = curve.abbreviated(derivative, end, n, &label, &mut names, &mut lines);
            }
            let function = Expr::name(&format!("{head}{}", "'".repeat(n)));
            let place = formula::expression(curve.value(end));
            lines.push(Line {
                label,
                left: Expr::made(Node::Call(Arc::new(function), vec![place])),
                right,
            });
        }
    }
    let conditions = separated(&conditions);
    let bound = curve.degree_at_least(reach).into_iter();
    let mut points: Vec<Expr> = vec![];
    for point in used.iter().map(formula::expression) {
        // At a numeric degree both ends may use the same.
        if !points.contains(&point) {
            points.push(point);
        }
    }
    let kind = match family.is_rational() {
        true => "a rational curve",
        false => "a curve",
    };
    Ok(Derivation {
        title: format!(
            "Derivatives up to order {order} at the ends of {kind} of the family {basis}, degree {degree}"
        ),
        degrees: degree
            .multiples()
            .map(|(name, _)| name.to_owned())
            .collect(),
        parameters: family.symbols()?,
        points,
        lines,
        conditions: bound
            .chain(conditions.iter().map(nonzero_expression))
            .collect(),
    })
}
