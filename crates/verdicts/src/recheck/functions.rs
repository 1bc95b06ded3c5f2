//! Functions: the built-in ones, and calls of the paper's own with their derivatives.

use super::evaluate::{Bindings, Evaluator, MAX_COUNT, Result, Value, not_covered, transposed};
use super::number::{Quotient, Sum, Work};
use super::{linear, turn};
use num_traits::{One, Signed};
use torse_algebra::{Rational, Symbol, rational};
use torse_language::syntax::{Expr, Node};

impl Evaluator<'_> {
    /// The value of `head(arguments)`.
    pub(super) fn call(&self, head: &Expr, arguments: &[Expr], bound: &Bindings) -> Result<Value> {
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

    /// The value with the solution put in, if that depends on the variable.
    fn resolved_for(&self, value: Value, variable: &str) -> Result<Value> {
        if self
            .solved
            .values()
            .any(|solution| solution.mentions(variable))
        {
            return value.each(&|q| self.resolved(q));
        }
        Ok(value)
    }

    fn derived(&self, value: Value, name: &str, order: i64) -> Result<Value> {
        let value = self.resolved_for(value, name)?;
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
        let value = self.resolved_for(value.clone(), variable)?;
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
                    return if (0..=MAX_COUNT).contains(&n) {
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
