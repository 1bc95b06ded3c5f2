//! Formulas as values of Rocq: real numbers, lists of them, lists of lists, in the order of the text.
//!
//! The values of core terms are written a second time, on purpose, by the file of this name above this folder. Rocq's
//! operations are total; where a formula has no value is said apart, see [`super::defined`].

use super::function::{derivative, put_in};
use super::kinds::Kind;
use super::premises::squared_difference;
use super::reach::with;
use super::scope::Scope;
use super::writer::{Named, Value, Writer};
use crate::code::{Code, Level};
use crate::gap::Untranslatable;
use crate::shape::Shape;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{Expr, Node, Operator};

/// The zero of a shape.
pub(super) fn zero(shape: Shape) -> Code {
    let size = |n: usize| Code::atom(n.to_string());
    match shape {
        Shape::Number => Code::atom("0"),
        Shape::Vector(n) => Code::apply("zeros", &[size(n)]),
        Shape::Matrix(rows, columns) => Code::apply("mzeros", &[size(rows), size(columns)]),
    }
}

impl Writer<'_> {
    /// The value of a formula.
    ///
    /// # Errors
    /// [`Untranslatable`] for what has no translation, and for shapes that do not fit.
    pub fn value(&mut self, expr: &Expr, scope: &Scope) -> Result<Value, Untranslatable> {
        self.visit()?;
        match &expr.node {
            Node::Number { value, .. } => Ok(Value::number(Code::rational(value))),
            Node::Name(name) => self.named(name, scope),
            Node::Call(head, arguments) => self.called(head, arguments, scope),
            Node::Index(head, indices) => self.indexed(head, indices, scope),
            Node::Negative(inner) => {
                let Value { code, shape } = self.value(inner, scope)?;
                Ok(match shape {
                    Shape::Number => Value::number(Code::new(
                        format!("- {}", code.within(Level::Negative)),
                        Level::Negative,
                    )),
                    Shape::Vector(_) => Value::applied("vopp", &[code], shape),
                    Shape::Matrix(..) => Value::applied("mopp", &[code], shape),
                })
            }
            Node::Binary(Operator::Power, a, b) => self.power(a, b, scope),
            Node::Binary(operator, a, b) => self.binary(*operator, a, b, scope),
            Node::List(items) => self.list(items, scope),
            Node::Compare(..) | Node::Join(..) | Node::Not(_) => Err(Untranslatable::Unread(
                "a statement where a value is wanted".to_owned(),
            )),
        }
    }

    /// A number.
    ///
    /// # Errors
    /// As [`Writer::value`], and [`Untranslatable::Shapes`] for vectors.
    pub fn number(&mut self, expr: &Expr, scope: &Scope) -> Result<Code, Untranslatable> {
        let Value { code, shape } = self.value(expr, scope)?;
        match shape {
            Shape::Number => Ok(code),
            other => Err(Untranslatable::Shapes(format!(
                "{other} where a number is wanted"
            ))),
        }
    }

    fn named(&mut self, name: &str, scope: &Scope) -> Result<Value, Untranslatable> {
        if let Some(local) = scope.locals.get(name) {
            return Ok(Value::number(match local.kind {
                Kind::Integer => super::function::real(&local.code),
                Kind::Value(shape) => {
                    let code = local.code.clone();
                    return Ok(Value { code, shape });
                }
            }));
        }
        let declarations = self.names.declarations;
        if let Some(definition) = declarations.definition(name) {
            if !definition.parameters.is_empty() {
                return Err(Untranslatable::Unread(format!(
                    "the function `{name}` alone"
                )));
            }
            let body = &definition.body.expr;
            let head = self.define(Named::Definition, name, &[], &[], |writer, scope, _| {
                writer.value(body, scope)
            })?;
            let symbols = self.with_symbols(&head, scope)?;
            return Ok(Value::applied(&head.name, &symbols, head.shape));
        }
        match declarations.symbol(name) {
            Some(SymbolKind::Real(_) | SymbolKind::Vector(None)) => {
                return Ok(Value::number(self.standing(name, scope)?));
            }
            Some(SymbolKind::Integer { .. }) => {
                return Ok(Value::number(super::function::real(
                    &self.standing(name, scope)?,
                )));
            }
            Some(SymbolKind::Vector(Some(n))) => {
                return Ok(Value {
                    code: self.standing(name, scope)?,
                    shape: Shape::Vector((*n).into()),
                });
            }
            Some(SymbolKind::Family { .. }) => {
                return Err(Untranslatable::Unread(format!(
                    "the family `{name}` without an index"
                )));
            }
            None => {}
        }
        match name {
            "pi" => Ok(Value::number(Code::atom("PI"))),
            _ => Err(Untranslatable::Unread(format!("`{name}` is no value"))),
        }
    }

    fn called(
        &mut self,
        head: &Expr,
        arguments: &[Expr],
        scope: &Scope,
    ) -> Result<Value, Untranslatable> {
        let bound = scope.bound();
        if let Node::Index(family, indices) = &head.node
            && let Node::Name(name) = &family.node
            && let Some(basis) = self.names.basis(name, &bound)
        {
            return self.member(name, basis, indices, arguments, scope);
        }
        if let Some(name) = self.names.built_in(head, &bound) {
            return self.built_in(name, arguments, scope);
        }
        match self.function(head, scope)? {
            Some(function) => self.call(&function, arguments, scope),
            None => Err(Untranslatable::Unread(
                "what is applied is no function".to_owned(),
            )),
        }
    }

    fn indexed(
        &mut self,
        head: &Expr,
        indices: &[Expr],
        scope: &Scope,
    ) -> Result<Value, Untranslatable> {
        let bound = scope.bound();
        if let Node::Name(name) = &head.node {
            if let Some(definition) = self.names.definition(name, &bound)
                && definition.indexed
            {
                let function = self.defined_function(name, scope)?;
                return self.call(&function, indices, scope);
            }
            if let Some(basis) = self.names.basis(name, &bound) {
                return self.member(name, basis, indices, &[], scope);
            }
            if self.names.is_symbol(name, &bound)
                && let Some(SymbolKind::Family { dimension, ranges }) =
                    self.names.declarations.symbol(name)
            {
                // The coordinate of a point may stand behind its indices.
                if let Some((coordinate, indices)) = indices.split_last()
                    && indices.len() == ranges.len()
                    && !ranges.is_empty()
                    && dimension.is_some_and(|n| n > 1)
                {
                    let point = self.indexed(head, indices, scope)?;
                    return self.entry(point, std::slice::from_ref(coordinate), scope);
                }
                if ranges.is_empty() && indices.len() != 1 {
                    return Err(Untranslatable::Construct(
                        "a family of several indices without ranges",
                    ));
                }
                let indices = indices.iter().map(|index| self.index(index, scope));
                let indices = indices.collect::<Result<Vec<_>, _>>()?;
                let shape = match dimension {
                    None | Some(1) => Shape::Number,
                    Some(n) => Shape::Vector((*n).into()),
                };
                // What stands for a family may be applied itself.
                let family = self.standing(name, scope)?.argument();
                return Ok(Value::applied(&family, &indices, shape));
            }
        }
        let whole = self.value(head, scope)?;
        self.entry(whole, indices, scope)
    }

    fn entry(
        &mut self,
        of: Value,
        indices: &[Expr],
        scope: &Scope,
    ) -> Result<Value, Untranslatable> {
        let Value {
            mut code,
            mut shape,
        } = of;
        for index in indices {
            let (length, head, inner) = match shape {
                Shape::Number => {
                    return Err(Untranslatable::Construct(
                        "a coordinate of a generic coordinate",
                    ));
                }
                Shape::Vector(length) => (length, "entry", Shape::Number),
                Shape::Matrix(rows, columns) => (rows, "row", Shape::Vector(columns)),
            };
            let argument = match self.literal(index, scope) {
                Some(place) if (1..=length).any(|inside| i64::try_from(inside) == Ok(place)) => {
                    Code::atom(place.to_string())
                }
                Some(_) => return Err(Untranslatable::Construct("an entry outside of its vector")),
                None => Code::apply("Z.to_nat", &[self.index(index, scope)?]),
            };
            code = Code::apply(head, &[code, argument]);
            shape = inner;
        }
        Ok(Value { code, shape })
    }

    fn binary(
        &mut self,
        operator: Operator,
        a: &Expr,
        b: &Expr,
        scope: &Scope,
    ) -> Result<Value, Untranslatable> {
        let (left, right) = (self.value(a, scope)?, self.value(b, scope)?);
        let (x, y) = (&left.code, &right.code);
        let both = [x.clone(), y.clone()];
        let swapped = [y.clone(), x.clone()];
        use Operator::{Add, Divide, Multiply, Subtract};
        use Shape::{Matrix, Number, Vector};
        Ok(match (operator, left.shape, right.shape) {
            (Add, Number, Number) => Value::number(Code::infix(x, "+", y, Level::Sum)),
            (Subtract, Number, Number) => Value::number(Code::infix(x, "-", y, Level::Sum)),
            (Multiply, Number, Number) => Value::number(Code::infix(x, "*", y, Level::Product)),
            (Divide, Number, Number) => Value::number(Code::infix(x, "/", y, Level::Product)),
            (Add, Vector(n), Vector(m)) if n == m => Value::applied("vadd", &both, left.shape),
            (Subtract, Vector(n), Vector(m)) if n == m => Value::applied("vsub", &both, left.shape),
            (Add, Matrix(..), Matrix(..)) if left.shape == right.shape => {
                Value::applied("madd", &both, left.shape)
            }
            (Subtract, Matrix(..), Matrix(..)) if left.shape == right.shape => {
                Value::applied("msub", &both, left.shape)
            }
            (Multiply, Number, Vector(_)) => Value::applied("vscale", &both, right.shape),
            (Multiply, Vector(_), Number) => Value::applied("vscale", &swapped, left.shape),
            (Multiply, Number, Matrix(..)) => Value::applied("mscale", &both, right.shape),
            (Multiply, Matrix(..), Number) => Value::applied("mscale", &swapped, left.shape),
            (Divide, Vector(_), Number) => Value::applied("vdiv", &both, left.shape),
            (Divide, Matrix(..), Number) => Value::applied("mdiv", &both, left.shape),
            (Multiply, Matrix(rows, n), Vector(m)) if n == m => {
                Value::applied("mvec", &both, Vector(rows))
            }
            (Multiply, Matrix(rows, n), Matrix(m, columns)) if n == m => {
                Value::applied("mmul", &both, Matrix(rows, columns))
            }
            (Add | Subtract, shape, Number) if self.is_zero(b, scope) => Value {
                code: x.clone(),
                shape,
            },
            (Add, Number, shape) if self.is_zero(a, scope) => Value {
                code: y.clone(),
                shape,
            },
            (_, x, y) => return Err(Untranslatable::Shapes(format!("{x} and {y}"))),
        })
    }

    fn power(&mut self, a: &Expr, b: &Expr, scope: &Scope) -> Result<Value, Untranslatable> {
        let base = self.number(a, scope)?;
        let Some(exponent) = self.literal(b, scope) else {
            let exponent = self.index(b, scope)?;
            return Ok(Value::number(Code::apply("powerRZ", &[base, exponent])));
        };
        let text = format!("{} ^ {}", base.below(Level::Power), exponent.unsigned_abs());
        let size = Code::new(text, Level::Power);
        Ok(Value::number(if exponent >= 0 {
            size
        } else {
            Code::infix(&Code::atom("1"), "/", &size, Level::Product)
        }))
    }

    fn list(&mut self, items: &[Expr], scope: &Scope) -> Result<Value, Untranslatable> {
        let values = items.iter().map(|item| self.value(item, scope));
        let values = values.collect::<Result<Vec<_>, _>>()?;
        let shapes = values.iter().map(|value| value.shape);
        let vector = shapes.clone().find(|shape| *shape != Shape::Number);
        let mut codes = vec![];
        for (item, value) in items.iter().zip(values) {
            codes.push(match (vector, value.shape) {
                (None, Shape::Number) => value.code,
                (Some(wanted @ Shape::Vector(_)), shape) if shape == wanted => value.code,
                (Some(wanted @ Shape::Vector(_)), Shape::Number) if self.is_zero(item, scope) => {
                    zero(wanted)
                }
                (_, other) => {
                    return Err(Untranslatable::Shapes(format!(
                        "{other} in a list of others"
                    )));
                }
            });
        }
        let shape = match vector {
            Some(Shape::Vector(columns)) => Shape::Matrix(codes.len(), columns),
            _ => Shape::Vector(codes.len()),
        };
        Ok(Value {
            code: Code::list(&codes),
            shape,
        })
    }

    fn built_in(
        &mut self,
        name: &str,
        arguments: &[Expr],
        scope: &Scope,
    ) -> Result<Value, Untranslatable> {
        match (name, arguments) {
            ("sum", [index, low, high, term]) => self.sum(index, low, high, term, scope),
            ("product", _) => Err(Untranslatable::Construct("a product over an index")),
            ("integral", _) => Err(Untranslatable::Construct("an integral")),
            ("D", [inner, variable, rest @ ..]) => {
                let order = self.order(rest.first(), scope)?;
                let reach = self.reach(inner, scope);
                let binding = self.binding(variable, &reach, scope)?;
                let body = self.value(inner, &binding.scope)?;
                derivative(&binding.name, body, &order, &binding.outside)
            }
            ("at", [inner, variable, point]) => {
                let reach = self.reach(inner, scope);
                let binding = self.binding(variable, &reach, scope)?;
                let (value, _) = self.argument(point, binding.kind, scope)?;
                let body = self.value(inner, &binding.scope)?;
                let rocq_type = binding.kind.rocq_type();
                Ok(Value {
                    code: put_in(&binding.name, rocq_type, &body.code, &value),
                    shape: body.shape,
                })
            }
            ("binom", [n, j]) => {
                let arguments = [self.number(n, scope)?, self.index(j, scope)?];
                Ok(Value::number(Code::apply("binom", &arguments)))
            }
            ("factorial", [n]) => {
                let n = self.index(n, scope)?;
                Ok(Value::number(Code::apply("factorial", &[n])))
            }
            ("identity", [n]) => {
                let size = self.literal(n, scope);
                let size = size.and_then(|n| usize::try_from(n).ok());
                let size = size.ok_or(Untranslatable::Construct(
                    "an identity matrix of symbolic size",
                ))?;
                let argument = Code::atom(size.to_string());
                let shape = Shape::Matrix(size, size);
                Ok(Value::applied("identity", &[argument], shape))
            }
            ("coefficients", [forms, symbols]) => self.coefficients(forms, symbols, scope),
            // Other ways to write quotients, roots and exponentials.
            ("tan", [angle]) => {
                let angle = self.number(angle, scope)?;
                let part = |head| Code::apply(head, std::slice::from_ref(&angle));
                let quotient = Code::infix(&part("sin"), "/", &part("cos"), Level::Product);
                Ok(Value::number(quotient))
            }
            ("abs", [x]) => {
                let x = self.number(x, scope)?;
                let square = Code::infix(&x, "*", &x, Level::Product);
                Ok(Value::number(Code::apply("sqrt", &[square])))
            }
            ("min" | "max", [a, b]) => {
                let (a, b) = (self.number(a, scope)?, self.number(b, scope)?);
                let size = Code::apply("sqrt", &[squared_difference(&a, &b)]);
                let sign = if name == "max" { "+" } else { "-" };
                let sum = Code::infix(&a, "+", &b, Level::Sum);
                let twice = Code::infix(&sum, sign, &size, Level::Sum);
                let half = Code::infix(&twice, "/", &Code::atom("2"), Level::Product);
                Ok(Value::number(half))
            }
            ("cosh" | "sinh" | "tanh", [x]) => {
                let x = self.number(x, scope)?;
                let opposite = format!("- {}", x.within(Level::Negative));
                let up = Code::apply("exp", &[x]);
                let down = Code::apply("exp", &[Code::new(opposite, Level::Negative)]);
                let sum = || Code::infix(&up, "+", &down, Level::Sum);
                let above = match name {
                    "cosh" => sum(),
                    _ => Code::infix(&up, "-", &down, Level::Sum),
                };
                let below = match name {
                    "tanh" => sum(),
                    _ => Code::atom("2"),
                };
                Ok(Value::number(Code::infix(
                    &above,
                    "/",
                    &below,
                    Level::Product,
                )))
            }
            _ => self.plain(name, arguments, scope),
        }
    }

    /// A built-in function of values.
    fn plain(
        &mut self,
        name: &str,
        arguments: &[Expr],
        scope: &Scope,
    ) -> Result<Value, Untranslatable> {
        let values = arguments.iter().map(|argument| self.value(argument, scope));
        let values = values.collect::<Result<Vec<_>, _>>()?;
        let codes: Vec<Code> = values.iter().map(|value| value.code.clone()).collect();
        let shapes: Vec<Shape> = values.iter().map(|value| value.shape).collect();
        use Shape::{Matrix, Number, Vector};
        let (head, shape) = match (name, shapes.as_slice()) {
            ("sqrt", [Number]) => ("sqrt", Number),
            ("sin", [Number]) => ("sin", Number),
            ("cos", [Number]) => ("cos", Number),
            ("exp", [Number]) => ("exp", Number),
            ("log", _) => return Err(Untranslatable::Theory("logarithms")),
            ("atan" | "asin" | "acos", _) => return Err(Untranslatable::Theory("arcs")),
            ("dot", [Vector(n), Vector(m)]) if n == m => ("dot", Number),
            ("cross", [Vector(3), Vector(3)]) => ("cross", Vector(3)),
            ("norm", [Vector(_)]) => ("norm", Number),
            ("det", [Matrix(n, m)]) if n == m => ("det", Number),
            ("transpose", [Matrix(n, m)]) => ("transpose", Matrix(*m, *n)),
            ("inverse", [Matrix(n, m)]) if n == m => ("inverse", Matrix(*n, *n)),
            ("solve", [Matrix(n, m), Vector(l)]) if n == m && m == l => ("solve", Vector(*n)),
            _ => {
                let what = "the arguments of a built-in function".to_owned();
                return Err(Untranslatable::Shapes(what));
            }
        };
        Ok(Value::applied(head, &codes, shape))
    }

    fn sum(
        &mut self,
        index: &Expr,
        low: &Expr,
        high: &Expr,
        term: &Expr,
        scope: &Scope,
    ) -> Result<Value, Untranslatable> {
        let (low, high) = (self.index(low, scope)?, self.index(high, scope)?);
        let (name, inside) = self.counted(index, term, scope)?;
        let body = self.value(term, &inside)?;
        let function = Code::new(format!("fun {name} => {}", body.code.text()), Level::Open);
        Ok(match body.shape {
            Shape::Number => Value::number(Code::apply("sum", &[low, high, function])),
            shape @ Shape::Vector(n) => {
                let size = Code::atom(n.to_string());
                Value::applied("vsum", &[size, low, high, function], shape)
            }
            Shape::Matrix(..) => return Err(Untranslatable::Construct("a sum of matrices")),
        })
    }

    /// What the index of a sum is called, and the scope of its terms.
    ///
    /// # Errors
    /// [`Untranslatable::Unread`] for an index without a name.
    pub fn counted(
        &self,
        index: &Expr,
        term: &Expr,
        scope: &Scope,
    ) -> Result<(String, Scope), Untranslatable> {
        let Node::Name(like) = &index.node else {
            return Err(Untranslatable::Unread("a sum over no name".to_owned()));
        };
        let reach = self.names.reach(term, &with(&scope.bound(), index));
        let name = self.binder(like, &reach, scope);
        let inside = scope.with_local(like, Code::atom(&name), Kind::Integer);
        Ok((name, inside))
    }
}
