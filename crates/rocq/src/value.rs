//! Core terms as values of Rocq: real numbers, lists of them, lists of lists.
//!
//! These are the values of the lemmas that scripts prove; those that are read are written from trees, a second time and
//! on purpose: `crate::tree`. The order of the print is kept, and nothing is simplified. Rocq's operations are total;
//! where a term is undefined is said apart, see [`crate::defined`].

use crate::code::{Code, Level, integer_scope};
use crate::context::{Context, Kind, Local, Used, Value};
use crate::gap::Untranslatable;
use crate::integer::{is_zero, literal};
use crate::kinds::kinds;
use crate::shape::Shape;
use std::sync::Arc;
use torse_core::{BuiltIn, Family, Node, Points, Set, Term, Variable};
use torse_syntax::formula::Operator;

impl Value {
    fn number(code: Code) -> Self {
        Self {
            code,
            shape: Shape::Number,
        }
    }

    fn applied(head: &str, arguments: &[Code], shape: Shape) -> Self {
        Self {
            code: Code::apply(head, arguments),
            shape,
        }
    }
}

/// The zero of a shape.
#[must_use]
pub fn zero(shape: Shape) -> Code {
    match shape {
        Shape::Number => Code::atom("0"),
        Shape::Vector(n) => Code::apply("zeros", &[Code::atom(n.to_string())]),
        Shape::Matrix(rows, columns) => Code::apply(
            "mzeros",
            &[
                Code::atom(rows.to_string()),
                Code::atom(columns.to_string()),
            ],
        ),
    }
}

impl Context<'_> {
    /// The value of a term.
    ///
    /// # Errors
    /// [`Untranslatable`] for what has no translation, and for shapes that do not fit.
    pub fn value(&mut self, term: &Term) -> Result<Value, Untranslatable> {
        match &*term.node {
            Node::Number(value) => Ok(Value::number(Code::rational(value))),
            Node::Pi => Ok(Value::number(Code::atom("PI"))),
            Node::Symbol(name) => {
                let code = Code::atom(self.symbol(name)?);
                Ok(Value::number(match self.symbols.get(name) {
                    Some(Set::Integer { .. }) => Code::apply("IZR", &[code]),
                    _ => code,
                }))
            }
            Node::Variable(variable) => {
                let Local { code, kind } = self.local(variable)?.clone();
                Ok(match kind {
                    Kind::Integer => Value::number(Code::apply("IZR", &[code])),
                    Kind::Value(shape) => Value { code, shape },
                })
            }
            Node::Vector(name, dimension) => {
                let code = Code::atom(self.symbol(name)?);
                let shape = dimension.map_or(Shape::Number, |n| Shape::Vector(n.into()));
                Ok(Value { code, shape })
            }
            Node::Member(points, indices) => self.member(points, indices),
            Node::Basis {
                family,
                index,
                degree,
                arguments,
            } => self.basis(family, index, degree, arguments),
            Node::Negative(inner) => {
                let Value { code, shape } = self.value(inner)?;
                Ok(match shape {
                    Shape::Number => Value::number(Code::new(
                        format!("- {}", code.within(Level::Negative)),
                        Level::Negative,
                    )),
                    Shape::Vector(_) => Value::applied("vopp", &[code], shape),
                    Shape::Matrix(..) => Value::applied("mopp", &[code], shape),
                })
            }
            Node::Binary(operator, a, b) => self.binary(*operator, a, b),
            Node::List(items) => self.list(items),
            Node::Entry(of, indices) => self.entry(of, indices),
            Node::Sum {
                index,
                low,
                high,
                term,
            } => self.sum(index, low, high, term),
            Node::Product { .. } => Err(Untranslatable::Construct("a product over an index")),
            Node::Integral { .. } => Err(Untranslatable::Construct("an integral")),
            Node::Let {
                variable,
                value,
                body,
            } => self.instead(variable, value, body),
            Node::Derivative {
                variable,
                order,
                body,
                at,
                ..
            } => self.derivative(variable, order, body, at),
            Node::Apply(function, arguments) => self.applied(*function, arguments),
            Node::Opened { name, body, .. } => {
                let address = Arc::as_ptr(&term.node).addr();
                let used = Used::from_term(body);
                let body = body.clone();
                let head = self.define(address, name, &used, &[], &[], |context, _| {
                    context.value(&body)
                })?;
                let arguments = self.arguments(&head)?;
                Ok(Value {
                    code: Code::apply(&head.name, &arguments),
                    shape: head.shape,
                })
            }
        }
    }

    /// A number.
    ///
    /// # Errors
    /// As [`Context::value`], and [`Untranslatable::Shapes`] for vectors.
    pub fn number(&mut self, term: &Term) -> Result<Code, Untranslatable> {
        let Value { code, shape } = self.value(term)?;
        match shape {
            Shape::Number => Ok(code),
            other => Err(Untranslatable::Shapes(format!(
                "{other} where a number is wanted"
            ))),
        }
    }

    /// An integer in its scope, as an argument.
    ///
    /// # Errors
    /// [`Untranslatable::Construct`] for what is no integer by its form.
    pub fn index(&self, term: &Term) -> Result<Code, Untranslatable> {
        let code = self.integer(term);
        let code = code.ok_or(Untranslatable::Construct(
            "an index that is not made of integers",
        ))?;
        Ok(Code::atom(integer_scope(&code)))
    }

    fn member(&mut self, points: &Arc<Points>, indices: &[Term]) -> Result<Value, Untranslatable> {
        if points.ranges.is_empty() && indices.len() != 1 {
            return Err(Untranslatable::Construct(
                "a family of several indices without ranges",
            ));
        }
        let indices = indices.iter().map(|index| self.index(index));
        let indices = indices.collect::<Result<Vec<_>, _>>()?;
        let shape = match points.dimension {
            None | Some(1) => Shape::Number,
            Some(n) => Shape::Vector(n.into()),
        };
        let name = self.symbol(&points.name)?;
        Ok(Value::applied(name, &indices, shape))
    }

    fn basis(
        &mut self,
        family: &Arc<Family>,
        index: &Term,
        degree: &Term,
        arguments: &[Term],
    ) -> Result<Value, Untranslatable> {
        let (name, mut all) = self.family(family)?;
        for (argument, kind) in arguments.iter().zip(kinds(family)) {
            all.push(self.argument_of(argument, &kind)?);
        }
        all.extend([self.index(index)?, self.index(degree)?]);
        Ok(Value::number(Code::apply(&name, &all)))
    }

    /// The definition of a family, and its first arguments: function i of degree k at the arguments is
    /// `name ... x mu nu i k`.
    ///
    /// # Errors
    /// As [`Context::value`].
    pub fn family(&mut self, family: &Arc<Family>) -> Result<(String, Vec<Code>), Untranslatable> {
        let own: Vec<(Variable, Kind)> = family
            .variables
            .iter()
            .cloned()
            .zip(kinds(family))
            .collect();
        let used = Used::of_family(family);
        let address = Arc::as_ptr(family).addr();
        let head = self.define(
            address,
            &family.name,
            &used,
            &own,
            &["i", "k"],
            |context, last| {
                let mut seeds = vec![];
                for seed in &family.seeds {
                    seeds.push(context.number(inside(seed))?);
                }
                let step = [&family.step.0, &family.step.1];
                let (head, [a, b]) = match &family.counters {
                    None => ("basis", step.map(|part| context.number(inside(part)))),
                    Some(counters) => (
                        "counted",
                        step.map(|part| context.factor(counters, inside(part))),
                    ),
                };
                let arguments = [&[a?, b?, Code::list(&seeds)], last].concat();
                Ok(Value::number(Code::apply(head, &arguments)))
            },
        )?;
        let arguments = self.arguments(&head)?;
        Ok((head.name, arguments))
    }

    fn binary(&mut self, operator: Operator, a: &Term, b: &Term) -> Result<Value, Untranslatable> {
        if operator == Operator::Power {
            return self.power(a, b);
        }
        let (left, right) = (self.value(a)?, self.value(b)?);
        let (x, y) = (&left.code, &right.code);
        let both = [x.clone(), y.clone()];
        let swapped = [y.clone(), x.clone()];
        use Operator::{Add, Divide, Multiply, Subtract};
        use Shape::{Matrix, Number, Vector};
        let value = match (operator, left.shape, right.shape) {
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
            (Add | Subtract, shape, Number) if is_zero(b) => Value {
                code: x.clone(),
                shape,
            },
            (Add, Number, shape) if is_zero(a) => Value {
                code: y.clone(),
                shape,
            },
            (_, x, y) => return Err(Untranslatable::Shapes(format!("{x} and {y}"))),
        };
        Ok(value)
    }

    fn power(&mut self, a: &Term, b: &Term) -> Result<Value, Untranslatable> {
        let base = self.number(a)?;
        if let Some(exponent) = literal(b) {
            let power = |exponent: u64| {
                let text = format!("{} ^ {exponent}", base.below(Level::Power));
                Code::new(text, Level::Power)
            };
            let size = power(exponent.unsigned_abs());
            return Ok(Value::number(if exponent >= 0 {
                size
            } else {
                Code::infix(&Code::atom("1"), "/", &size, Level::Product)
            }));
        }
        let exponent = self.index(b)?;
        Ok(Value::number(Code::apply("powerRZ", &[base, exponent])))
    }

    fn list(&mut self, items: &[Term]) -> Result<Value, Untranslatable> {
        let values = items.iter().map(|item| self.value(item));
        let values = values.collect::<Result<Vec<_>, _>>()?;
        let vector = values
            .iter()
            .map(|value| value.shape)
            .find(|shape| *shape != Shape::Number);
        let mut codes = vec![];
        for (item, value) in items.iter().zip(values) {
            codes.push(match (vector, value.shape) {
                (None, Shape::Number) => value.code,
                (Some(wanted @ Shape::Vector(_)), shape) if shape == wanted => value.code,
                (Some(wanted @ Shape::Vector(_)), Shape::Number) if is_zero(item) => zero(wanted),
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

    fn entry(&mut self, of: &Term, indices: &[Term]) -> Result<Value, Untranslatable> {
        let Value {
            mut code,
            mut shape,
        } = self.value(of)?;
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
            let argument = match literal(index) {
                Some(place) if (1..=length).any(|inside| i64::try_from(inside) == Ok(place)) => {
                    Code::atom(place.to_string())
                }
                Some(_) => return Err(Untranslatable::Construct("an entry outside of its vector")),
                None => Code::apply("Z.to_nat", &[self.index(index)?]),
            };
            code = Code::apply(head, &[code, argument]);
            shape = inner;
        }
        Ok(Value { code, shape })
    }

    fn sum(
        &mut self,
        index: &Variable,
        low: &Term,
        high: &Term,
        term: &Term,
    ) -> Result<Value, Untranslatable> {
        let (low, high) = (self.index(low)?, self.index(high)?);
        let name = self.bind(index, Kind::Integer);
        let body = self.value(term)?;
        self.release(index);
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

    /// `body` with the variable standing for a value: an applied definition takes it as its argument, everything else is
    /// written with `let`.
    fn instead(
        &mut self,
        variable: &Variable,
        value: &Term,
        body: &Term,
    ) -> Result<Value, Untranslatable> {
        let local = self.standing_for(value)?;
        if applies(body) || local.code.text().chars().all(|c| c.is_alphanumeric()) {
            self.bind_to(variable, local);
            return self.value(body);
        }
        let Local { code, kind } = local;
        let name = self.bind(variable, kind);
        let inner = self.value(body)?;
        self.release(variable);
        let text = format!("let {name} := {} in {}", code.text(), inner.code.text());
        Ok(Value {
            code: Code::new(text, Level::Open),
            shape: inner.shape,
        })
    }

    /// What a variable of this value stands for: an integer where it can, so that it can be an index.
    ///
    /// # Errors
    /// As [`Context::value`].
    pub fn standing_for(&mut self, value: &Term) -> Result<Local, Untranslatable> {
        if let Some(code) = self.integer(value) {
            let code = Code::atom(integer_scope(&code));
            return Ok(Local {
                code,
                kind: Kind::Integer,
            });
        }
        let Value { code, shape } = self.value(value)?;
        Ok(Local {
            code,
            kind: Kind::Value(shape),
        })
    }

    fn derivative(
        &mut self,
        variable: &Variable,
        order: &Term,
        body: &Term,
        at: &Term,
    ) -> Result<Value, Untranslatable> {
        let order = match literal(order) {
            Some(order) if order >= 0 => Code::atom(order.to_string()),
            Some(_) => return Err(Untranslatable::Construct("a derivative of negative order")),
            None => match self.integer(order) {
                Some(order) => Code::apply("Z.to_nat", &[Code::atom(integer_scope(&order))]),
                None => {
                    return Err(Untranslatable::Construct(
                        "a derivative whose order is no integer",
                    ));
                }
            },
        };
        let at = self.number(at)?;
        let name = self.bind(variable, Kind::Value(Shape::Number));
        let body = self.value(body)?;
        self.release(variable);
        let function = Code::new(format!("fun {name} => {}", body.code.text()), Level::Open);
        Ok(match body.shape {
            Shape::Number => Value::number(Code::apply("Derive_n", &[function, order, at])),
            shape @ Shape::Vector(n) => {
                let size = Code::atom(n.to_string());
                Value::applied("vDerive", &[size, function, order, at], shape)
            }
            Shape::Matrix(..) => return Err(Untranslatable::Construct("a derivative of a matrix")),
        })
    }

    fn applied(&mut self, function: BuiltIn, arguments: &[Term]) -> Result<Value, Untranslatable> {
        match (function, arguments) {
            (BuiltIn::Binomial, [n, j]) => {
                let arguments = [self.number(n)?, self.index(j)?];
                return Ok(Value::number(Code::apply("binom", &arguments)));
            }
            (BuiltIn::Factorial, [n]) => {
                let n = self.index(n)?;
                return Ok(Value::number(Code::apply("factorial", &[n])));
            }
            (BuiltIn::Identity, [n]) => {
                let size = literal(n).and_then(|n| usize::try_from(n).ok());
                let size = size.ok_or(Untranslatable::Construct(
                    "an identity matrix of symbolic size",
                ))?;
                let argument = Code::atom(size.to_string());
                return Ok(Value::applied(
                    "identity",
                    &[argument],
                    Shape::Matrix(size, size),
                ));
            }
            (BuiltIn::Coefficients, [forms, unknowns]) => {
                return self.coefficients(forms, unknowns);
            }
            _ => {}
        }
        let values = arguments.iter().map(|argument| self.value(argument));
        let values = values.collect::<Result<Vec<_>, _>>()?;
        let codes: Vec<Code> = values.iter().map(|value| value.code.clone()).collect();
        let shapes: Vec<Shape> = values.iter().map(|value| value.shape).collect();
        use Shape::{Matrix, Number, Vector};
        let (head, shape) = match (function, shapes.as_slice()) {
            (BuiltIn::SquareRoot, [Number]) => ("sqrt", Number),
            (BuiltIn::Sine, [Number]) => ("sin", Number),
            (BuiltIn::Cosine, [Number]) => ("cos", Number),
            (BuiltIn::Exponential, [Number]) => ("exp", Number),
            (BuiltIn::Logarithm, _) => return Err(Untranslatable::Theory("logarithms")),
            (BuiltIn::ArcTangent | BuiltIn::ArcSine, _) => {
                return Err(Untranslatable::Theory("arcs"));
            }
            (BuiltIn::Dot, [Vector(n), Vector(m)]) if n == m => ("dot", Number),
            (BuiltIn::Cross, [Vector(3), Vector(3)]) => ("cross", Vector(3)),
            (BuiltIn::Norm, [Vector(_)]) => ("norm", Number),
            (BuiltIn::Determinant, [Matrix(n, m)]) if n == m => ("det", Number),
            (BuiltIn::Transpose, [Matrix(n, m)]) => ("transpose", Matrix(*m, *n)),
            (BuiltIn::Inverse, [Matrix(n, m)]) if n == m => ("inverse", Matrix(*n, *n)),
            (BuiltIn::Solve, [Matrix(n, m), Vector(l)]) if n == m && m == l => {
                ("solve", Vector(*n))
            }
            _ => {
                return Err(Untranslatable::Shapes(
                    "the arguments of a built-in function".to_owned(),
                ));
            }
        };
        Ok(Value::applied(head, &codes, shape))
    }
}

/// The formula of a part of a family, which is opened under the name of the family.
fn inside(part: &Term) -> &Term {
    match &*part.node {
        Node::Opened { body, .. } => body,
        _ => part,
    }
}

/// Whether a term is an applied definition: its variables occur as arguments.
fn applies(body: &Term) -> bool {
    match &*body.node {
        Node::Opened { .. } => true,
        Node::Let { body, .. } => applies(body),
        _ => false,
    }
}
