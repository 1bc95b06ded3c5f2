//! The syntax tree at concrete integers, straight from the definitions.

use super::Obstacle;
use super::number::{Quotient, Sum, Work};
use num_traits::Signed;
use std::cell::Cell;
use std::collections::BTreeMap;
use torse_algebra::{Rational, Symbol, rational};
use torse_language::derivation::declarations::{Basis, Declarations, SymbolKind};
use torse_language::syntax::{Expr, Node, Operator};

/// How deep definitions may nest.
const MAX_DEPTH: usize = 60;
/// The longest sum and the highest power and degree.
pub(super) const MAX_COUNT: i64 = 60;

/// What a formula is worth. A vector with one generic coordinate is a number.
#[derive(Debug, Clone)]
pub enum Value {
    /// A number.
    Number(Quotient),
    /// A vector or, nested, a matrix.
    Many(Vec<Value>),
    /// A function: its parameters, its body and the derivatives to take of it.
    Function {
        parameters: Vec<String>,
        body: Expr,
        derivatives: Vec<(String, i64)>,
    },
}

pub(super) type Bindings = BTreeMap<String, Value>;
pub(super) type Result<T> = std::result::Result<T, Obstacle>;

/// Evaluates formulas at one instance.
pub struct Evaluator<'a> {
    /// What names mean.
    pub declarations: &'a Declarations,
    /// The integer symbols.
    pub integers: BTreeMap<String, i64>,
    /// Symbols fixed by assumptions, replaced where they are met.
    pub known: BTreeMap<Symbol, Quotient>,
    /// Symbols determined by the given equations, replaced at the end: their values are large.
    pub solved: BTreeMap<Symbol, Quotient>,
    /// The work so far.
    pub work: &'a Work,
    /// How deep definitions are nested now.
    pub depth: Cell<usize>,
}

pub(super) fn not_covered(what: impl Into<String>) -> Obstacle {
    Obstacle::NotCovered { what: what.into() }
}

impl Value {
    /// All numbers inside, in order.
    pub fn numbers(&self) -> Vec<&Quotient> {
        match self {
            Self::Number(number) => vec![number],
            Self::Many(items) => items.iter().flat_map(Self::numbers).collect(),
            Self::Function { .. } => vec![],
        }
    }

    pub(super) fn each(&self, change: &impl Fn(&Quotient) -> Result<Quotient>) -> Result<Self> {
        Ok(match self {
            Self::Number(number) => Self::Number(change(number)?),
            Self::Many(items) => Self::Many(
                items
                    .iter()
                    .map(|v| v.each(change))
                    .collect::<Result<_>>()?,
            ),
            Self::Function { .. } => return Err(not_covered("arithmetic with a function")),
        })
    }

    pub(super) fn number(self) -> Result<Quotient> {
        match self {
            Self::Number(number) => Ok(number),
            _ => Err(not_covered("a vector where a number is needed")),
        }
    }

    pub(super) fn rows(self) -> Result<Vec<Vec<Quotient>>> {
        let Self::Many(rows) = self else {
            return Err(not_covered("a number where a matrix is needed"));
        };
        rows.iter()
            .map(|row| match row {
                Self::Many(entries) => entries.iter().map(|e| e.clone().number()).collect(),
                _ => Err(not_covered("a vector where a matrix is needed")),
            })
            .collect()
    }

    pub(super) fn matrix(rows: Vec<Vec<Quotient>>) -> Self {
        let row = |row: Vec<Quotient>| Self::Many(row.into_iter().map(Self::Number).collect());
        Self::Many(rows.into_iter().map(row).collect())
    }
}

impl Evaluator<'_> {
    /// The value of a formula.
    pub fn value(&self, expr: &Expr, bound: &Bindings) -> Result<Value> {
        self.work.spend(1)?;
        match &expr.node {
            Node::Number { value, .. } => Ok(Value::Number(Quotient::number(value.clone()))),
            Node::Name(name) => self.named(name, bound),
            Node::Call(head, arguments) => self.call(head, arguments, bound),
            Node::Index(head, indices) => self.indexed(head, indices, bound),
            Node::Negative(inner) => self.value(inner, bound)?.each(&|q| Ok(q.negated())),
            Node::Binary(operator, a, b) => {
                self.binary(*operator, self.value(a, bound)?, self.value(b, bound)?)
            }
            Node::List(items) => Ok(Value::Many(
                items
                    .iter()
                    .map(|i| self.value(i, bound))
                    .collect::<Result<_>>()?,
            )),
            Node::Compare(..) | Node::Join(..) | Node::Not(_) => {
                Err(not_covered("a statement inside a formula"))
            }
        }
    }

    /// The number with the solution of the given equations put in.
    pub fn resolved(&self, number: &Quotient) -> Result<Quotient> {
        let mut all = self.solved.iter();
        all.try_fold(number.clone(), |number, (symbol, value)| {
            number.with(symbol, value, self.work)
        })
    }

    /// An integer.
    pub fn integer(&self, expr: &Expr, bound: &Bindings) -> Result<i64> {
        let value = self.value(expr, bound)?.number()?.as_constant();
        let whole = value
            .filter(Rational::is_integer)
            .map(|v| i64::try_from(v.to_integer()));
        whole
            .and_then(std::result::Result::ok)
            .ok_or_else(|| not_covered("an index that is no integer"))
    }

    fn leaf(&self, name: &str) -> Value {
        let symbol = Symbol::named(name);
        Value::Number(match self.known.get(&symbol) {
            Some(value) => value.clone(),
            None => Sum::symbol(symbol).into(),
        })
    }

    /// A point: one generic coordinate, or all of them.
    fn point(&self, name: &str, dimension: Option<u8>) -> Value {
        match dimension {
            None | Some(1) => self.leaf(name),
            Some(d) => Value::Many((1..=d).map(|c| self.leaf(&format!("{name}.{c}"))).collect()),
        }
    }

    fn named(&self, name: &str, bound: &Bindings) -> Result<Value> {
        if let Some(value) = bound.get(name) {
            return Ok(value.clone());
        }
        if let Some(value) = self.integers.get(name) {
            return Ok(Value::Number(Quotient::integer(*value)));
        }
        if let Some(definition) = self.declarations.definition(name) {
            if definition.parameters.is_empty() {
                return self.deeper(|| self.value(&definition.body.expr, &Bindings::new()));
            }
            return Ok(Value::Function {
                parameters: definition.parameters.clone(),
                body: definition.body.expr.clone(),
                derivatives: vec![],
            });
        }
        match self.declarations.symbol(name) {
            Some(SymbolKind::Real(_) | SymbolKind::Integer { .. }) => return Ok(self.leaf(name)),
            Some(SymbolKind::Vector(dimension)) => return Ok(self.point(name, *dimension)),
            _ => {}
        }
        if name == "pi" {
            return Ok(Value::Number(Sum::symbol(Symbol::Pi).into()));
        }
        let base = name.trim_end_matches('\'');
        if base.len() < name.len()
            && let Value::Function {
                parameters,
                body,
                mut derivatives,
            } = self.named(base, bound)?
            && let Some(first) = parameters.first()
        {
            derivatives.push((
                first.clone(),
                i64::try_from(name.len() - base.len()).unwrap_or(i64::MAX),
            ));
            return Ok(Value::Function {
                parameters,
                body,
                derivatives,
            });
        }
        Err(not_covered(format!("the name {name}")))
    }

    pub(super) fn deeper<T>(&self, inner: impl FnOnce() -> Result<T>) -> Result<T> {
        if self.depth.get() >= MAX_DEPTH {
            return Err(not_covered("definitions nested this deep"));
        }
        self.depth.set(self.depth.get() + 1);
        let result = inner();
        self.depth.set(self.depth.get() - 1);
        result
    }

    fn indexed(&self, head: &Expr, indices: &[Expr], bound: &Bindings) -> Result<Value> {
        if let Node::Name(name) = &head.node
            && !bound.contains_key(name)
            && self.declarations.definition(name).is_none()
        {
            if let Some(basis) = self.declarations.basis(name) {
                return self.member(basis, indices, &[], bound);
            }
            if let Some(SymbolKind::Family { dimension, .. }) = self.declarations.symbol(name) {
                let index = indices
                    .iter()
                    .map(|i| self.integer(i, bound))
                    .collect::<Result<Vec<_>>>()?;
                return Ok(self.point(&format!("{name}{index:?}"), *dimension));
            }
        }
        indices
            .iter()
            .try_fold(self.value(head, bound)?, |value, index| {
                let position = usize::try_from(self.integer(index, bound)? - 1).ok();
                let Value::Many(items) = value else {
                    return Err(not_covered("an index of a number"));
                };
                position
                    .and_then(|p| items.get(p).cloned())
                    .ok_or_else(|| not_covered("an entry outside"))
            })
    }

    /// `g[i,k](x, mu)`: the seeds, then `g[i,j+1] = a g[i,j] + b g[i-1,j]`.
    pub(super) fn member(
        &self,
        basis: &Basis,
        indices: &[Expr],
        arguments: &[Expr],
        bound: &Bindings,
    ) -> Result<Value> {
        let [index, degree] = indices else {
            return Err(not_covered("a member of a family without two indices"));
        };
        let (index, degree) = (self.integer(index, bound)?, self.integer(degree, bound)?);
        let steps = degree - i64::from(basis.degree);
        if !(0..=MAX_COUNT).contains(&steps) {
            return Err(not_covered(format!("a family at degree {degree}")));
        }
        let mut inner = Bindings::new();
        for (name, argument) in std::iter::once(&basis.variable)
            .chain(&basis.parameters)
            .zip(arguments)
        {
            inner.insert(name.clone(), self.value(argument, bound)?);
        }
        let formula = |expr: &Expr| self.deeper(|| self.value(expr, &inner)?.number());
        let (a, b) = (formula(&basis.step.0.expr)?, formula(&basis.step.1.expr)?);
        let mut row = basis
            .seeds
            .iter()
            .map(|s| formula(&s.expr))
            .collect::<Result<Vec<_>>>()?;
        for _ in 0..steps {
            let zero = Quotient::integer(0);
            let kept = row.iter().chain(std::iter::once(&zero));
            let moved = std::iter::once(&zero).chain(&row);
            row = kept
                .zip(moved)
                .map(|(same, before)| {
                    a.times(same, self.work)?
                        .plus(&b.times(before, self.work)?, self.work)
                })
                .collect::<Result<_>>()?;
        }
        let entry = usize::try_from(index)
            .ok()
            .and_then(|i| row.get(i).cloned());
        Ok(Value::Number(entry.unwrap_or_else(|| Quotient::integer(0))))
    }

    pub(super) fn binary(&self, operator: Operator, a: Value, b: Value) -> Result<Value> {
        match operator {
            Operator::Add => self.sum(a, b),
            Operator::Subtract => self.sum(a, b.each(&|q| Ok(q.negated()))?),
            Operator::Multiply => self.product(a, b),
            Operator::Divide => {
                let divisor = b.number()?;
                a.each(&|q| q.over(&divisor, self.work))
            }
            Operator::Power => {
                let (base, exponent) = (a.number()?, b.number()?.as_constant());
                let exponent =
                    exponent.filter(|e| e.is_integer() && e.abs() <= rational::integer(MAX_COUNT));
                let exponent = exponent.ok_or_else(|| not_covered("this power"))?;
                let count = i64::try_from(exponent.to_integer()).unwrap_or(0);
                let power = (0..count.abs()).try_fold(Quotient::integer(1), |power, _| {
                    power.times(&base, self.work)
                })?;
                Ok(Value::Number(if count < 0 {
                    Quotient::integer(1).over(&power, self.work)?
                } else {
                    power
                }))
            }
        }
    }

    pub(super) fn sum(&self, a: Value, b: Value) -> Result<Value> {
        match (a, b) {
            (Value::Number(a), Value::Number(b)) => Ok(Value::Number(a.plus(&b, self.work)?)),
            (Value::Number(zero), other) | (other, Value::Number(zero)) if zero.is_zero() => {
                Ok(other)
            }
            (Value::Many(a), Value::Many(b)) if a.len() == b.len() => Ok(Value::Many(
                a.into_iter()
                    .zip(b)
                    .map(|(a, b)| self.sum(a, b))
                    .collect::<Result<_>>()?,
            )),
            _ => Err(not_covered("a sum of different shapes")),
        }
    }

    pub(super) fn product(&self, a: Value, b: Value) -> Result<Value> {
        match (a, b) {
            (Value::Number(factor), other) | (other, Value::Number(factor)) => {
                other.each(&|q| q.times(&factor, self.work))
            }
            (a, Value::Many(entries)) if matches!(entries.first(), Some(Value::Number(_))) => {
                let column = Value::Many(entries);
                a.rows()?
                    .iter()
                    .map(|row| self.dot(&row.iter().collect::<Vec<_>>(), &column.numbers()))
                    .map(|entry| entry.map(Value::Number))
                    .collect::<Result<_>>()
                    .map(Value::Many)
            }
            (a, b) => {
                let (a, b) = (a.rows()?, transposed(&b.rows()?));
                let entry = |row: &Vec<Quotient>, column: &Vec<Quotient>| {
                    self.dot(
                        &row.iter().collect::<Vec<_>>(),
                        &column.iter().collect::<Vec<_>>(),
                    )
                };
                let rows = a
                    .iter()
                    .map(|row| b.iter().map(|column| entry(row, column)).collect());
                Ok(Value::matrix(rows.collect::<Result<_>>()?))
            }
        }
    }

    pub(super) fn dot(&self, a: &[&Quotient], b: &[&Quotient]) -> Result<Quotient> {
        if a.len() != b.len() {
            return Err(not_covered("a product of different lengths"));
        }
        a.iter()
            .zip(b)
            .try_fold(Quotient::integer(0), |sum, (x, y)| {
                sum.plus(&x.times(y, self.work)?, self.work)
            })
    }
}

pub(super) fn transposed(rows: &[Vec<Quotient>]) -> Vec<Vec<Quotient>> {
    let width = rows.first().map_or(0, Vec::len);
    (0..width)
        .map(|c| rows.iter().filter_map(|row| row.get(c).cloned()).collect())
        .collect()
}
