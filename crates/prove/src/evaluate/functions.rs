//! The built-in functions.

use super::quantity::Quantity;
use super::value::{FamilyProperty, Function, Statement, Value};
use super::{Bindings, Evaluator, linear, symbolic_degree, wrong_type};
use std::sync::Arc;
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Polynomial, Rational};
use torse_language::fault::{Fault, Problem};
use torse_language::syntax::{Expr, Node, Place};

/// The names of the built-in functions.
pub(super) const NAMES: [&str; 21] = [
    "sum",
    "D",
    "at",
    "binom",
    "factorial",
    "sin",
    "cos",
    "sqrt",
    "dot",
    "cross",
    "det",
    "transpose",
    "inverse",
    "solve",
    "norm",
    "agrees",
    "coefficients",
    "identity",
    "nonnegative",
    "independent",
    "variation_diminishing",
];

impl Evaluator<'_> {
    /// The value of `head(arguments)`.
    pub(super) fn call(
        &self,
        expr: &Expr,
        head: &Expr,
        arguments: &[Expr],
        bound: &Bindings,
    ) -> Result<Value, Fault> {
        if let Node::Index(family, indices) = &head.node
            && let Node::Name(name) = &family.node
            && let Some(basis) = self.declarations.basis(name)
        {
            return self.member(name, basis, indices, arguments, expr.place, bound);
        }
        if let Node::Name(name) = &head.node
            && NAMES.contains(&name.as_str())
            && !bound.contains_key(name)
            && self.declarations.definition(name).is_none()
        {
            return self.built_in(name, arguments, expr.place, bound);
        }
        match self.value(head, bound)? {
            Value::Function(function) => {
                let values = arguments
                    .iter()
                    .map(|a| self.value(a, bound))
                    .collect::<Result<Vec<_>, _>>()?;
                self.apply(&function, &values, expr.place)
            }
            other => Err(wrong_type(head.place, other.kind(), "a function")),
        }
    }

    fn built_in(
        &self,
        name: &str,
        arguments: &[Expr],
        place: Place,
        bound: &Bindings,
    ) -> Result<Value, Fault> {
        let count = |wanted: &str| {
            Fault::at(
                place,
                Problem::Count {
                    name: name.to_owned(),
                    wanted: wanted.to_owned(),
                    found: arguments.len(),
                },
            )
        };
        match (name, arguments) {
            ("sum", [index, low, high, term]) => match &index.node {
                Node::Name(index) => self.sum(index, low, high, term, place, bound),
                _ => Err(wrong_type(index.place, "a formula", "the name of an index")),
            },
            ("sum", _) => Err(count("sum(index, low, high, term)")),
            ("D", [function, rest @ ..]) if rest.len() <= 2 => {
                self.symbolically(|| self.derivative(function, rest, place, bound))
            }
            ("D", _) => Err(count("D(F, variable, order)")),
            ("at", [inner, variable, point]) => {
                let Node::Name(variable) = &variable.node else {
                    return Err(wrong_type(
                        variable.place,
                        "a formula",
                        "the name of a variable",
                    ));
                };
                self.symbolically(|| {
                    let value = self.value(inner, bound)?;
                    let point = self.number(point, bound)?;
                    self.placed(&value, variable, &point, place)
                })
            }
            ("at", _) => Err(count("at(formula, variable, point)")),
            ("binom", [top, bottom]) => self.binomial(top, bottom, bound),
            ("factorial", [n]) => {
                let form = self.index(n, bound)?;
                let n = form.as_number().filter(|n| (0..=200).contains(n));
                let n = n.ok_or_else(|| Fault::limit(place, format!("the factorial of {form}")))?;
                Ok(
                    Fraction::from((1..=n).fold(integer(1), |product, i| product * integer(i)))
                        .into(),
                )
            }
            ("sin" | "cos", [argument]) => {
                let value = self.in_angle(|| self.number(argument, bound))?;
                let (sine, cosine) = value
                    .sine_cosine()
                    .map_err(|e| Fault::exact(argument.place, e))?;
                Ok(self
                    .at_sample(if name == "sin" { sine } else { cosine })
                    .into())
            }
            ("sqrt", [radicand]) => {
                let value = self.number(radicand, bound)?;
                square_root(&value, radicand.place).map(Value::from)
            }
            ("dot", [a, b]) => self.dot(a, b, bound).map(Value::Scalar),
            ("cross", [a, b]) => {
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
            ("norm", [v]) => {
                let square = self.dot(v, v, bound)?;
                let square = square
                    .as_fraction()
                    .ok_or_else(|| symbolic_degree(v.place))?;
                square_root(square, v.place).map(Value::from)
            }
            ("det", [m]) => linear::determinant(&self.matrix(m, bound)?, m.place).map(Value::from),
            ("inverse", [m]) => linear::inverse(&self.matrix(m, bound)?, m.place),
            ("solve", [m, right]) => {
                let right_value = self.value(right, bound)?;
                linear::solve(&self.matrix(m, bound)?, &right_value, right.place)
            }
            ("transpose", [m]) => {
                let rows = match self.value(m, bound)? {
                    Value::Matrix(rows) => rows,
                    other => return Err(wrong_type(m.place, other.kind(), "a matrix")),
                };
                let width = rows.first().map_or(0, Vec::len);
                let column = |c: usize| rows.iter().filter_map(|row| row.get(c).cloned()).collect();
                Ok(Value::Matrix((0..width).map(column).collect()))
            }
            ("identity", [n]) => {
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
            ("agrees", [value, printed]) => self.agreement(value, printed, bound),
            ("nonnegative" | "independent" | "variation_diminishing", [family]) => {
                self.family_property(name, family)
            }
            ("coefficients", [forms, unknowns]) => {
                let (forms, unknowns) = (self.value(forms, bound)?, self.value(unknowns, bound)?);
                linear::coefficients(&forms, &unknowns, place)
            }
            _ => Err(count(match name {
                "binom" | "dot" | "cross" | "solve" | "agrees" | "coefficients" => "two arguments",
                _ => "one argument",
            })),
        }
    }

    /// A statement about a whole basis family.
    fn family_property(&self, name: &str, family: &Expr) -> Result<Value, Fault> {
        let basis = match &family.node {
            Node::Name(name) => self.declarations.basis(name),
            _ => None,
        };
        let basis =
            basis.ok_or_else(|| wrong_type(family.place, "a formula", "the name of a basis"))?;
        let property = match name {
            "nonnegative" => FamilyProperty::Nonnegative,
            "independent" => FamilyProperty::Independent,
            _ => FamilyProperty::VariationDiminishing,
        };
        Ok(Value::Truth(Box::new(Statement::Family {
            property,
            basis: Arc::clone(basis),
        })))
    }

    /// A plain scalar.
    fn number(&self, expr: &Expr, bound: &Bindings) -> Result<Fraction, Fault> {
        match self.value(expr, bound)? {
            Value::Scalar(q) => q
                .as_fraction()
                .cloned()
                .ok_or_else(|| symbolic_degree(expr.place)),
            other => Err(wrong_type(expr.place, other.kind(), "a number")),
        }
    }

    /// The coordinates of a vector.
    fn coordinates(&self, expr: &Expr, bound: &Bindings) -> Result<Vec<Quantity>, Fault> {
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

    fn dot(&self, a: &Expr, b: &Expr, bound: &Bindings) -> Result<Quantity, Fault> {
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

    fn matrix(&self, expr: &Expr, bound: &Bindings) -> Result<Vec<Vec<Fraction>>, Fault> {
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

    /// `D(F, x, n)` of a function is a function; of a formula, a formula.
    fn derivative(
        &self,
        inner: &Expr,
        rest: &[Expr],
        place: Place,
        bound: &Bindings,
    ) -> Result<Value, Fault> {
        let value = self.value(inner, bound)?;
        let order = match rest.get(1) {
            None => 1,
            Some(order) => {
                let form = self.index(order, bound)?;
                let order = form
                    .as_number()
                    .and_then(|n| u32::try_from(n).ok())
                    .filter(|n| *n <= 12);
                order.ok_or_else(|| Fault::limit(place, format!("a derivative of order {form}")))?
            }
        };
        let variable = match rest.first().map(|e| (&e.node, e.place)) {
            Some((Node::Name(name), _)) => Some(name.clone()),
            Some((_, place)) => {
                return Err(wrong_type(place, "a formula", "the name of a variable"));
            }
            None => None,
        };
        match value {
            Value::Function(mut function) => {
                let parameter = variable.or_else(|| function.parameters.first().cloned());
                let known = parameter.filter(|p| function.parameters.contains(p));
                match known {
                    Some(parameter) => {
                        function.derivatives.push((parameter, order));
                        Ok(Value::Function(function))
                    }
                    None => self.parameter_derivative(&function, rest, order, place, bound),
                }
            }
            value => {
                let variable = variable.ok_or_else(|| {
                    wrong_type(place, "a formula", "a variable to differentiate by")
                })?;
                (0..order).try_fold(value, |value, _| {
                    value.mapped(&|q: &Quantity| Ok(q.derivative(&variable)))
                })
            }
        }
    }

    /// The derivative of a function by a symbol that is no parameter of it: by a shape parameter, say.
    fn parameter_derivative(
        &self,
        function: &Function,
        rest: &[Expr],
        order: u32,
        place: Place,
        _bound: &Bindings,
    ) -> Result<Value, Fault> {
        let symbol = rest.first().map(|e| e.node.clone());
        let Some(Node::Name(symbol)) = symbol else {
            return Err(wrong_type(
                place,
                "a function",
                "a parameter to differentiate by",
            ));
        };
        if self.declarations.symbol(&symbol).is_none() {
            return Err(self.unknown(
                &symbol,
                rest.first().map_or(place, |e| e.place),
                &Bindings::new(),
            ));
        }
        // D(F, mu) is the function whose body is D(body, mu).
        let made = Expr::made;
        let n = Rational::from_integer(order.into());
        let body = made(Node::Call(
            Arc::new(Expr::name("D")),
            vec![function.body.clone(), Expr::name(&symbol), Expr::number(&n)],
        ));
        Ok(Value::Function(Box::new(Function {
            body,
            ..function.clone()
        })))
    }

    fn binomial(&self, top: &Expr, bottom: &Expr, bound: &Bindings) -> Result<Value, Fault> {
        let place = top.place.to(bottom.place);
        let (n, j) = (self.index(top, bound)?, self.index(bottom, bound)?);
        let Some(chosen) = j.as_number() else {
            return Err(Fault::limit(
                place,
                format!("the binomial coefficient of {n} over {j}"),
            ));
        };
        if chosen < 0 || n.as_number().is_some_and(|n| n >= 0 && chosen > n) {
            return Ok(Fraction::zero().into());
        }
        if chosen > 200 {
            return Err(Fault::limit(
                place,
                format!("the binomial coefficient of {n} over {j}"),
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

    /// `agrees(value, printed)`: the printed numbers are read with their digits.
    fn agreement(&self, value: &Expr, printed: &Expr, bound: &Bindings) -> Result<Value, Fault> {
        let values: Vec<Fraction> = match self.value(value, bound)? {
            Value::Function(_) | Value::Truth(_) => {
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
                .collect::<Result<_, _>>()?,
        };
        let items: Vec<&Expr> = match &printed.node {
            Node::List(items) => items.iter().collect(),
            _ => vec![printed],
        };
        let digits = |item: &Expr| -> Result<(Rational, u32), Fault> {
            match &item.node {
                Node::Number { value, decimals } => Ok((value.clone(), decimals.unwrap_or(0))),
                Node::Negative(inner) => match &inner.node {
                    Node::Number { value, decimals } => Ok((-value.clone(), decimals.unwrap_or(0))),
                    _ => Err(wrong_type(item.place, "a formula", "a printed number")),
                },
                _ => Err(wrong_type(item.place, "a formula", "a printed number")),
            }
        };
        let printed_values = items
            .into_iter()
            .map(digits)
            .collect::<Result<Vec<_>, _>>()?;
        if values.len() != printed_values.len() {
            let (left, right) = (
                format!("{} values", values.len()),
                format!("{} printed numbers", printed_values.len()),
            );
            return Err(super::shapes(printed.place, &left, &right));
        }
        Ok(Value::Truth(Box::new(Statement::Agrees {
            values,
            printed: printed_values,
        })))
    }
}

/// The square root of a rational number, or of a perfect square of a monomial.
fn square_root(value: &Fraction, place: Place) -> Result<Fraction, Fault> {
    match value.as_rational() {
        Some(q) => Polynomial::square_root(&q)
            .map(Fraction::from)
            .map_err(|e| Fault::exact(place, e)),
        None => Err(Fault::limit(place, format!("the square root of {value}"))),
    }
}
