//! The built-in functions.

use super::quantity::Quantity;
use super::value::{Statement, Value};
use super::{Environment, Evaluator, linear, symbolic_degree, wrong_type};
use crate::decide::order::order;
use crate::roots::square::root_of;
use std::cmp::Ordering;
use torse_algebra::fault_injection::{InjectedFault, injected};
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Polynomial, Rational, Symbol};
use torse_core::{BuiltIn, Printed, Term, Variable};
use torse_syntax::fault::Fault;
use torse_syntax::formula::Place;

impl Evaluator<'_> {
    /// The value of a built-in function.
    pub(super) fn apply(
        &self,
        function: BuiltIn,
        arguments: &[Term],
        place: Place,
        bound: &Environment,
    ) -> Result<Value, Fault> {
        match (function, arguments) {
            (BuiltIn::Binomial, [top, bottom]) => self.binomial(top, bottom, bound),
            (BuiltIn::Factorial, [n]) => {
                let form = self.index(n, bound)?;
                let n = form.as_number().filter(|n| (0..=200).contains(n));
                let n = n.ok_or_else(|| Fault::limit(place, format!("the factorial of {form}")))?;
                Ok(
                    Fraction::from((1..=n).fold(integer(1), |product, i| product * integer(i)))
                        .into(),
                )
            }
            (BuiltIn::Sine | BuiltIn::Cosine, [argument]) => {
                let value = self.in_angle(|| self.number(argument, bound))?;
                let (sine, cosine) = value
                    .sine_cosine()
                    .map_err(|e| Fault::exact(argument.place, e))?;
                Ok(self
                    .at_sample(if function == BuiltIn::Sine {
                        sine
                    } else {
                        cosine
                    })
                    .into())
            }
            (BuiltIn::Exponential, [argument]) => {
                let value = self.in_angle(|| self.number(argument, bound))?;
                let power = value.exponential();
                let power = power.map_err(|e| Fault::exact(argument.place, e))?;
                Ok(self.at_sample(power).into())
            }
            (BuiltIn::Logarithm, [argument]) => {
                let value = self.number(argument, bound)?.logarithm();
                Ok(value.map_err(|e| Fault::exact(argument.place, e))?.into())
            }
            (BuiltIn::ArcTangent, [argument]) => {
                let value = self.number(argument, bound)?.arctangent();
                Ok(value.map_err(|e| Fault::exact(argument.place, e))?.into())
            }
            (BuiltIn::ArcSine, [argument]) => {
                let value = self.number(argument, bound)?.arcsine();
                Ok(value.map_err(|e| Fault::exact(argument.place, e))?.into())
            }
            (BuiltIn::SquareRoot, [radicand]) => {
                let value = self.number(radicand, bound)?;
                square_root(&value, radicand.place).map(Value::from)
            }
            (BuiltIn::Dot, [a, b]) => self.dot(a, b, bound).map(Value::Scalar),
            (BuiltIn::Cross, [a, b]) => {
                let (a, b) = (self.coordinates(a, bound)?, self.coordinates(b, bound)?);
                let ([a1, a2, a3], [b1, b2, b3]) = (a.as_slice(), b.as_slice()) else {
                    return Err(super::shapes(place, "cross(a, b)", "two vectors of 3"));
                };
                let minor = |x: &Quantity, y: &Quantity, u: &Quantity, v: &Quantity| {
                    Ok(super::multiplied(x, v, place)?.minus(&super::multiplied(y, u, place)?))
                };
                Ok(super::sum::vector(vec![
                    minor(a2, a3, b2, b3)?,
                    minor(a3, a1, b3, b1)?,
                    minor(a1, a2, b1, b2)?,
                ]))
            }
            (BuiltIn::Norm, [v]) => {
                let square = self.dot(v, v, bound)?;
                let square = square
                    .as_fraction()
                    .ok_or_else(|| symbolic_degree(v.place))?;
                square_root(square, v.place).map(Value::from)
            }
            (BuiltIn::Determinant, [m]) => {
                linear::determinant(&self.matrix(m, bound)?, m.place).map(Value::from)
            }
            (BuiltIn::Inverse, [m]) => linear::inverse(&self.matrix(m, bound)?, m.place),
            (BuiltIn::Solve, [m, right]) => {
                let right_value = self.value(right, bound)?;
                linear::solve(&self.matrix(m, bound)?, &right_value, right.place)
            }
            (BuiltIn::Transpose, [m]) => {
                let rows = match self.value(m, bound)? {
                    Value::Matrix(rows) => rows,
                    other => return Err(wrong_type(m.place, other.kind(), "a matrix")),
                };
                let width = rows.first().map_or(0, Vec::len);
                let column = |c: usize| rows.iter().filter_map(|row| row.get(c).cloned()).collect();
                Ok(Value::Matrix((0..width).map(column).collect()))
            }
            (BuiltIn::Identity, [n]) => {
                let n = self
                    .index(n, bound)?
                    .as_number()
                    .and_then(|n| usize::try_from(n).ok())
                    .filter(|n| *n <= 16);
                let n = n.ok_or_else(|| Fault::limit(place, "an identity matrix of this size"))?;
                let entry = |r, c| Fraction::integer(i64::from(r == c)).into();
                Ok(Value::Matrix(
                    (0..n)
                        .map(|r| (0..n).map(|c| entry(r, c)).collect())
                        .collect(),
                ))
            }
            (BuiltIn::Coefficients, [forms, unknowns]) => {
                self.coefficients(forms, unknowns, place, bound)
            }
            _ => Err(wrong_type(
                place,
                "these arguments",
                "as many as the function takes",
            )),
        }
    }

    /// A plain scalar.
    pub(super) fn number(&self, expr: &Term, bound: &Environment) -> Result<Fraction, Fault> {
        match self.value(expr, bound)? {
            Value::Scalar(q) => q
                .as_fraction()
                .cloned()
                .ok_or_else(|| symbolic_degree(expr.place)),
            other => Err(wrong_type(expr.place, other.kind(), "a number")),
        }
    }

    /// The coordinates of a vector.
    fn coordinates(&self, expr: &Term, bound: &Environment) -> Result<Vec<Quantity>, Fault> {
        match self.value(expr, bound)? {
            Value::Vector(v) if !v.generic => Ok(v.entries),
            Value::Vector(_) => Err(wrong_type(
                expr.place,
                "a generic vector",
                "a vector with coordinates (declare its dimension)",
            )),
            other => Err(wrong_type(expr.place, other.kind(), "a vector")),
        }
    }

    fn dot(&self, a: &Term, b: &Term, bound: &Environment) -> Result<Quantity, Fault> {
        let place = a.place.to(b.place);
        let (a, b) = (self.coordinates(a, bound)?, self.coordinates(b, bound)?);
        if a.len() != b.len() {
            return Err(super::shapes(
                place,
                &format!("a vector of {}", a.len()),
                &format!("a vector of {}", b.len()),
            ));
        }
        a.iter()
            .zip(&b)
            .try_fold(Quantity::from(Fraction::zero()), |sum, (x, y)| {
                Ok(sum.plus(&super::multiplied(x, y, place)?))
            })
    }

    fn matrix(&self, expr: &Term, bound: &Environment) -> Result<Vec<Vec<Fraction>>, Fault> {
        match self.value(expr, bound)? {
            Value::Matrix(rows) => rows
                .iter()
                .map(|row| {
                    row.iter()
                        .map(|q| {
                            q.as_fraction()
                                .cloned()
                                .ok_or_else(|| symbolic_degree(expr.place))
                        })
                        .collect()
                })
                .collect(),
            other => Err(wrong_type(expr.place, other.kind(), "a matrix")),
        }
    }

    fn binomial(&self, top: &Term, bottom: &Term, bound: &Environment) -> Result<Value, Fault> {
        let place = top.place.to(bottom.place);
        let (n, j) = (self.index(top, bound)?, self.index(bottom, bound)?);
        let Some(chosen) = j.as_number() else {
            return Err(Fault::limit(
                place,
                format!("the binomial coefficient of {n} over {j}: its lower index is no number"),
            ));
        };
        if chosen < 0 || n.as_number().is_some_and(|n| n >= 0 && chosen > n) {
            return Ok(Fraction::zero().into());
        }
        if chosen > 200 {
            return Err(Fault::limit(
                place,
                format!("the binomial coefficient of {n} over {j}: its lower index is above 200"),
            ));
        }
        // n (n - 1) ... (n - j + 1) / j!, also for a symbolic n.
        let n = super::series::polynomial_of(&n);
        let product = (0..chosen).fold(Polynomial::integer(1), |product, i| {
            (&product * &(&n - &Polynomial::integer(i)))
                .scaled(&Rational::new(1.into(), (i + 1).into()))
        });
        Ok(Fraction::from(product).into())
    }

    /// The values that are compared with printed numbers, as many.
    pub(super) fn agreement(
        &self,
        value: &Term,
        printed: &[Printed],
        place: Place,
        bound: &Environment,
    ) -> Result<Statement, Fault> {
        let values = match self.value(value, bound)? {
            Value::Truth(_) => {
                return Err(wrong_type(value.place, "no number", "a number or vector"));
            }
            numbers => numbers
                .entries()
                .into_iter()
                .map(|q| {
                    q.as_fraction()
                        .cloned()
                        .ok_or_else(|| symbolic_degree(value.place))
                })
                .collect::<Result<Vec<_>, _>>()?,
        };
        if values.len() != printed.len() {
            let (left, right) = (
                format!("{} values", values.len()),
                format!("{} printed numbers", printed.len()),
            );
            return Err(super::shapes(place, &left, &right));
        }
        Ok(Statement::Agrees {
            values,
            printed: printed.to_vec(),
        })
    }

    /// The derivative of the body by its variable: at a symbol that nothing else has, then its value is put in.
    pub(super) fn derivative(
        &self,
        variable: &Variable,
        order: &Term,
        body: &Term,
        at: &Term,
        place: Place,
        bound: &Environment,
    ) -> Result<Value, Fault> {
        let form = self.index(order, bound)?;
        let order = form
            .as_number()
            .and_then(|n| u32::try_from(n).ok())
            .filter(|n| *n <= 12)
            .ok_or_else(|| Fault::limit(place, format!("a derivative of order {form}")))?;
        let enclosing = self.derivatives.get();
        let name = self.differential(variable.name(), enclosing);
        let mut inner = bound.clone();
        inner.insert(variable.number(), Fraction::named(&name).into());
        if injected(InjectedFault::ValueBeforeDerivative) {
            inner.insert(variable.number(), self.number(at, bound)?.into());
        }
        self.derivatives.set(enclosing + 1);
        let body = self.value(body, &inner);
        self.derivatives.set(enclosing);
        let value = (0..order).try_fold(body?, |value, _| {
            value.mapped(&|q: &Quantity| Ok::<_, Fault>(q.derivative(&name)))
        })?;
        let point = self.number(at, bound)?;
        self.placed(&value, &name, &point, place)
    }
}

/// The square root of a rational number, or of the square of a number that is in the algebra: `(pi - 3)^2`.
fn square_root(value: &Fraction, place: Place) -> Result<Fraction, Fault> {
    match value.as_rational() {
        Some(q) => Polynomial::square_root(&q)
            .map(Fraction::from)
            .map_err(|e| Fault::exact(place, e)),
        None => root_of_number(value)
            .ok_or_else(|| Fault::limit(place, format!("the square root of {value}"))),
    }
}

/// The number that is not negative and has this square.
fn root_of_number(value: &Fraction) -> Option<Fraction> {
    if !value.symbols().iter().all(Symbol::is_number) {
        return None;
    }
    let root = root_of(value)?;
    let is_root = (root.clone() * root.clone() - value.clone()).is_zero();
    match order(&root).filter(|_| is_root)? {
        Ordering::Less => Some(-root),
        Ordering::Equal | Ordering::Greater => Some(root),
    }
}
