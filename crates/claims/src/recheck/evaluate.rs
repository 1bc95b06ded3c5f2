//! The syntax tree at concrete integers, straight from the definitions.

use super::number::{Quotient, Sum, Work};
use super::{Obstacle, linear, turn};
use crate::evaluate::scope::{Basis, Declarations, SymbolKind};
use crate::syntax::{Expr, Node, Operator};
use num_traits::{One, Signed};
use std::cell::Cell;
use std::collections::BTreeMap;
use torse_algebra::{Rational, Symbol, rational};

/// How deep definitions may nest.
const MAX_DEPTH: usize = 60;
/// The longest sum and the highest power and degree.
const MAX_COUNT: i64 = 60;

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

type Bindings = BTreeMap<String, Value>;
type Result<T> = std::result::Result<T, Obstacle>;

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

fn not_covered(what: impl Into<String>) -> Obstacle {
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

    fn each(&self, change: &impl Fn(&Quotient) -> Result<Quotient>) -> Result<Self> {
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

    fn number(self) -> Result<Quotient> {
        match self {
            Self::Number(number) => Ok(number),
            _ => Err(not_covered("a vector where a number is needed")),
        }
    }

    fn rows(self) -> Result<Vec<Vec<Quotient>>> {
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

    fn matrix(rows: Vec<Vec<Quotient>>) -> Self {
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
        let all = self.solved.iter();
        all.fold(Ok(number.clone()), |number, (symbol, value)| {
            number?.with(symbol, value, self.work)
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

    fn deeper<T>(&self, inner: impl FnOnce() -> Result<T>) -> Result<T> {
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
    fn member(
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

    fn sum(&self, a: Value, b: Value) -> Result<Value> {
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

    fn product(&self, a: Value, b: Value) -> Result<Value> {
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

    fn dot(&self, a: &[&Quotient], b: &[&Quotient]) -> Result<Quotient> {
        if a.len() != b.len() {
            return Err(not_covered("a product of different lengths"));
        }
        a.iter()
            .zip(b)
            .try_fold(Quotient::integer(0), |sum, (x, y)| {
                sum.plus(&x.times(y, self.work)?, self.work)
            })
    }

    fn call(&self, head: &Expr, arguments: &[Expr], bound: &Bindings) -> Result<Value> {
        if let Node::Index(family, indices) = &head.node
            && let Node::Name(name) = &family.node
            && let Some(basis) = self.declarations.basis(name)
        {
            return self.member(basis, indices, arguments, bound);
        }
        if let Node::Name(name) = &head.node
            && !bound.contains_key(name)
            && self.declarations.definition(name).is_none()
            && let Some(value) = self.built_in(name, arguments, bound)?
        {
            return Ok(value);
        }
        let Value::Function {
            parameters,
            body,
            derivatives,
        } = self.value(head, bound)?
        else {
            return Err(not_covered("a call of what is no function"));
        };
        if parameters.len() != arguments.len() {
            return Err(not_covered("a call with another number of arguments"));
        }
        let values = arguments
            .iter()
            .map(|a| self.value(a, bound))
            .collect::<Result<Vec<_>>>()?;
        if derivatives.is_empty() {
            let inner = parameters.into_iter().zip(values).collect();
            return self.deeper(|| self.value(&body, &inner));
        }
        // Differentiate with fresh variables, then put the arguments in.
        let fresh = |name: &str| format!("{name}\u{b0}");
        let inner = parameters.iter().map(|p| {
            (
                p.clone(),
                Value::Number(Sum::symbol(Symbol::named(&fresh(p))).into()),
            )
        });
        let mut value = self.deeper(|| self.value(&body, &inner.collect()))?;
        for (name, order) in &derivatives {
            let name = if parameters.contains(name) {
                fresh(name)
            } else {
                name.clone()
            };
            value = self.derived(value, &name, *order)?;
        }
        parameters
            .iter()
            .zip(values)
            .try_fold(value, |value, (parameter, argument)| {
                self.placed(&value, &fresh(parameter), &argument.number()?)
            })
    }

    fn derived(&self, value: Value, name: &str, order: i64) -> Result<Value> {
        (0..order.min(MAX_COUNT)).try_fold(value, |value, _| {
            value.each(&|q| q.derivative(name, self.work))
        })
    }

    /// The value with a variable at a point.
    fn placed(&self, value: &Value, variable: &str, point: &Quotient) -> Result<Value> {
        let put = |symbol: &Symbol| match symbol {
            Symbol::Named(n) if **n == *variable => Ok(Some(point.clone())),
            Symbol::Sin(n, angle) | Symbol::Cos(n, angle) if **n == *variable => {
                let radians = match angle {
                    torse_algebra::Angle::Radian => point.clone(),
                    torse_algebra::Angle::QuarterTurn => {
                        let quarter =
                            Sum::symbol(Symbol::Pi).scaled(&Rational::new(1.into(), 2.into()));
                        point.times(&quarter.into(), self.work)?
                    }
                };
                let (sine, cosine) = turn::sine_cosine(&radians, self.work)?;
                Ok(Some(if matches!(symbol, Symbol::Sin(..)) {
                    sine
                } else {
                    cosine
                }))
            }
            _ => Ok(None),
        };
        value.each(&|q| q.replaced(&put, self.work))
    }

    /// The built-in functions; `None` for other names.
    fn built_in(&self, name: &str, arguments: &[Expr], bound: &Bindings) -> Result<Option<Value>> {
        let value = |e: &Expr| self.value(e, bound);
        let named = |e: &Expr| match &e.node {
            Node::Name(name) => Ok(name.clone()),
            _ => Err(not_covered("a formula where a name is needed")),
        };
        Ok(Some(match (name, arguments) {
            ("sum", [index, low, high, term]) => {
                let (index, low, high) = (
                    named(index)?,
                    self.integer(low, bound)?,
                    self.integer(high, bound)?,
                );
                if high - low > MAX_COUNT {
                    return Err(not_covered("a sum this long"));
                }
                let mut inner = bound.clone();
                let zero = Value::Number(Quotient::integer(0));
                (low..=high).try_fold(zero, |total, i| {
                    inner.insert(index.clone(), Value::Number(Quotient::integer(i)));
                    self.sum(total, self.value(term, &inner)?)
                })?
            }
            ("D", [function, rest @ ..]) => {
                let order = rest
                    .get(1)
                    .map_or(Ok(1), |order| self.integer(order, bound))?;
                let variable = rest.first().map(named).transpose()?;
                match (value(function)?, variable) {
                    (
                        Value::Function {
                            parameters,
                            body,
                            mut derivatives,
                        },
                        variable,
                    ) => {
                        let by = variable.or_else(|| parameters.first().cloned());
                        derivatives
                            .push((by.ok_or_else(|| not_covered("this derivative"))?, order));
                        Value::Function {
                            parameters,
                            body,
                            derivatives,
                        }
                    }
                    (value, Some(variable)) => self.derived(value, &variable, order)?,
                    _ => return Err(not_covered("a derivative by nothing")),
                }
            }
            ("at", [inner, variable, point]) => {
                self.placed(&value(inner)?, &named(variable)?, &value(point)?.number()?)?
            }
            ("binom", [n, k]) => {
                let (n, k) = (self.integer(n, bound)?, self.integer(k, bound)?);
                if k > n || k < 0 || n > MAX_COUNT {
                    return if n <= MAX_COUNT && n >= 0 {
                        Ok(Some(Value::Number(Quotient::integer(0))))
                    } else {
                        Err(not_covered("this binomial"))
                    };
                }
                let product = (1..=k).fold(Rational::one(), |p, i| {
                    p * Rational::new((n - k + i).into(), i.into())
                });
                Value::Number(Quotient::number(product))
            }
            ("factorial", [n]) => {
                let n = self.integer(n, bound)?.min(MAX_COUNT);
                Value::Number(Quotient::number((1..=n).map(rational::integer).product()))
            }
            ("sin", [x]) => Value::Number(turn::sine_cosine(&value(x)?.number()?, self.work)?.0),
            ("cos", [x]) => Value::Number(turn::sine_cosine(&value(x)?.number()?, self.work)?.1),
            ("sqrt", [x]) => Value::Number(root(&self.resolved(&value(x)?.number()?)?)?),
            ("norm", [v]) => {
                let v = value(v)?;
                Value::Number(root(
                    &self.resolved(&self.dot(&v.numbers(), &v.numbers())?)?,
                )?)
            }
            ("dot", [a, b]) => Value::Number(self.dot(&value(a)?.numbers(), &value(b)?.numbers())?),
            ("cross", [a, b]) => {
                let (a, b) = (value(a)?, value(b)?);
                let ([a1, a2, a3], [b1, b2, b3]) = (&a.numbers()[..], &b.numbers()[..]) else {
                    return Err(not_covered("a cross product outside of space"));
                };
                let minor = |x: &Quotient, v: &Quotient, y: &Quotient, u: &Quotient| {
                    let second = y.times(u, self.work)?.negated();
                    Ok(Value::Number(
                        x.times(v, self.work)?.plus(&second, self.work)?,
                    ))
                };
                Value::Many(vec![
                    minor(a2, b3, a3, b2)?,
                    minor(a3, b1, a1, b3)?,
                    minor(a1, b2, a2, b1)?,
                ])
            }
            ("det", [m]) => Value::Number(linear::determinant(&value(m)?.rows()?, self.work)?),
            ("inverse", [m]) => Value::matrix(linear::inverse(&value(m)?.rows()?, self.work)?),
            ("solve", [m, right]) => {
                let inverse = Value::matrix(linear::inverse(&value(m)?.rows()?, self.work)?);
                self.product(inverse, value(right)?)?
            }
            ("transpose", [m]) => Value::matrix(transposed(&value(m)?.rows()?)),
            ("identity", [n]) => {
                let n = self.integer(n, bound)?.min(MAX_COUNT);
                let row = |r| {
                    (0..n)
                        .map(|c| Quotient::integer(i64::from(r == c)))
                        .collect()
                };
                Value::matrix((0..n).map(row).collect())
            }
            ("coefficients", [forms, unknowns]) => {
                let (forms, unknowns) = (value(forms)?, value(unknowns)?);
                let row = |form: &&Quotient| {
                    unknowns
                        .numbers()
                        .iter()
                        .map(|u| self.coefficient(form, u))
                        .collect()
                };
                Value::matrix(forms.numbers().iter().map(row).collect::<Result<_>>()?)
            }
            _ => return Ok(None),
        }))
    }

    fn coefficient(&self, form: &Quotient, unknown: &Quotient) -> Result<Quotient> {
        let symbol = unknown
            .as_symbol()
            .ok_or_else(|| not_covered("coefficients of a formula"))?;
        let form = self.resolved(form)?;
        let below_free = form.below.split(&symbol).is_some_and(|(c, _)| c.is_zero());
        match form.above.split(&symbol) {
            Some((c, _)) if below_free => {
                Quotient::from(c).over(&form.below.clone().into(), self.work)
            }
            _ => Err(not_covered("coefficients of what is not linear")),
        }
    }
}

fn transposed(rows: &[Vec<Quotient>]) -> Vec<Vec<Quotient>> {
    let width = rows.first().map_or(0, Vec::len);
    (0..width)
        .map(|c| rows.iter().filter_map(|row| row.get(c).cloned()).collect())
        .collect()
}

/// The square root of a positive rational: `sqrt(p/q) = sqrt(p q)/q`, squares pulled out.
fn root(value: &Quotient) -> Result<Quotient> {
    let number = value.as_constant().filter(|v| !v.is_negative());
    let number = number.ok_or_else(|| not_covered("a square root of a formula"))?;
    let product = i64::try_from(number.numer() * number.denom());
    let mut rest = product
        .ok()
        .filter(|p| *p < 1 << 40)
        .ok_or_else(|| not_covered("a root this large"))?;
    let mut sum = Sum::constant(Rational::new(1.into(), number.denom().clone()));
    if rest == 0 {
        return Ok(Quotient::integer(0));
    }
    let mut prime = 2;
    while rest > 1 {
        if prime * prime > rest {
            prime = rest;
        }
        let mut exponent = 0;
        while rest % prime == 0 {
            rest /= prime;
            exponent += 1;
        }
        let whole = (0..exponent / 2)
            .map(|_| rational::integer(prime))
            .product();
        sum = sum.scaled(&whole);
        if exponent % 2 == 1 {
            let prime = u32::try_from(prime).map_err(|_| not_covered("a root this large"))?;
            sum = sum.times(&Sum::symbol(Symbol::Root(prime)), &Work::default())?;
        }
        prime += 1;
    }
    Ok(sum.into())
}
