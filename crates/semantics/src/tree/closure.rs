//! Functions as values: SEMANTICS.md, "Functions".
//!
//! A function is differentiated only when it is applied, so no series leaves the derivative that made it.

use super::environment::{Chain, Environment, Moved, Part};
use super::evaluate::Evaluator;
use crate::arithmetic::Arithmetic;
use crate::no_value::{NoValue, Undefined, Unknown};
use crate::series::Series;
use crate::value::Value;
use std::rc::Rc;
use torse_numbers::Rational;
use torse_numbers::rational::integer;
use torse_syntax::derivation::declarations::{Definition, SymbolKind};
use torse_syntax::formula::{Expr, Node};

/// The largest order of a derivative.
const MAX_ORDER: i64 = 40;

/// A function, to be applied.
#[derive(Debug)]
pub(super) enum Closure<'a, N> {
    /// A definition with parameters, with the moved names at the place where its name occurs.
    Body {
        definition: &'a Definition,
        moved: Chain<Moved<'a, N>>,
    },
    /// The derivative of a function by one of its parameters.
    ByParameter {
        function: Rc<Self>,
        parameter: usize,
        order: i64,
    },
    /// The derivative of a function by a declared symbol, or by a name that is bound outside, at a point.
    BySymbol {
        tree: &'a Expr,
        environment: Environment<'a, N>,
        symbol: &'a str,
        point: Series<N>,
        order: i64,
        parameters: Vec<&'a str>,
    },
    /// A declared smooth function.
    Given { name: &'a str },
}

impl<'a, N> Closure<'a, N> {
    /// The names of the parameters.
    fn parameters(&self) -> Vec<&'a str> {
        match self {
            Self::Body { definition, .. } => {
                definition.parameters.iter().map(String::as_str).collect()
            }
            Self::ByParameter { function, .. } => function.parameters(),
            Self::BySymbol { parameters, .. } => parameters.clone(),
            Self::Given { .. } => vec!["x"],
        }
    }
}

type Function<'a, A> = Rc<Closure<'a, <A as Arithmetic>::Number>>;
type Place<'a, A> = Environment<'a, <A as Arithmetic>::Number>;

impl<'a, A: Arithmetic> Evaluator<'a, '_, A> {
    /// The function that a formula denotes, if it denotes one. Only the points of `at` and the orders of `D` are
    /// evaluated.
    pub(super) fn function(
        &self,
        tree: &'a Expr,
        place: &Place<'a, A>,
    ) -> Result<Option<Function<'a, A>>, NoValue> {
        match &tree.node {
            Node::Name(name) => self.named_function(name, place),
            Node::Call(head, arguments) => {
                let Node::Name(head) = &head.node else {
                    return Ok(None);
                };
                match (self.built_in(head, place), arguments.as_slice()) {
                    (Some("D"), [inner, rest @ ..]) => self.differentiated(inner, rest, place),
                    (Some("at"), [inner, name, point]) => {
                        // Whether it is a function does not depend on the point.
                        if self.function(inner, place)?.is_none() {
                            return Ok(None);
                        }
                        let inside = self.bind_at(name, point, place)?;
                        self.function(inner, &inside)
                    }
                    _ => Ok(None),
                }
            }
            _ => Ok(None),
        }
    }

    fn named_function(
        &self,
        name: &'a str,
        place: &Place<'a, A>,
    ) -> Result<Option<Function<'a, A>>, NoValue> {
        if place.local(name).is_some() {
            return Ok(None);
        }
        if let Some(definition) = self.declarations.definition(name) {
            if definition.parameters.is_empty() {
                let _deeper = self.deeper()?;
                return self.function(&definition.body.expr, &place.outside());
            }
            return Ok(Some(Rc::new(Closure::Body {
                definition,
                moved: place.moved.clone(),
            })));
        }
        if self.declarations.symbol(name).is_some() {
            return Ok(None);
        }
        if self.declarations.function(name).is_some() {
            return Ok(Some(Rc::new(Closure::Given { name })));
        }
        // `F''` is the second derivative of F by its first parameter.
        let base = name.trim_end_matches('\'');
        let primes = name.len() - base.len();
        if primes == 0 {
            return Ok(None);
        }
        let function = self.named_function(base, place)?;
        Ok(function.map(|function| {
            Rc::new(Closure::ByParameter {
                function,
                parameter: 0,
                order: i64::try_from(primes).unwrap_or(i64::MAX),
            })
        }))
    }

    /// `D(F, x, n)` of a function F: by its parameter x if it has one of that name, otherwise by the outer meaning of
    /// x.
    fn differentiated(
        &self,
        inner: &'a Expr,
        rest: &'a [Expr],
        place: &Place<'a, A>,
    ) -> Result<Option<Function<'a, A>>, NoValue> {
        let Some(function) = self.function(inner, place)? else {
            return Ok(None);
        };
        let order = match rest.get(1) {
            None => 1,
            Some(order) => self.integer(order, "the order of a derivative", place)?,
        };
        let parameters = function.parameters();
        let by = match rest.first().map(|name| &name.node) {
            None => Some(0),
            Some(Node::Name(name)) => parameters.iter().position(|p| p == name),
            Some(_) => return Err(NoValue::shape("a formula to differentiate by")),
        };
        if let Some(parameter) = by {
            return Ok(Some(Rc::new(Closure::ByParameter {
                function,
                parameter,
                order,
            })));
        }
        let name = rest.first().ok_or_else(no_variable)?;
        let symbol = self.variable(name, place)?;
        let point = self.named_value(symbol, place)?.number()?;
        Ok(Some(Rc::new(Closure::BySymbol {
            tree: inner,
            environment: place.clone(),
            symbol,
            point,
            order,
            parameters,
        })))
    }

    /// The variable of a derivative or an integral.
    pub(super) fn variable(
        &self,
        name: &'a Expr,
        place: &Place<'a, A>,
    ) -> Result<&'a str, NoValue> {
        let Node::Name(name) = &name.node else {
            return Err(NoValue::shape("a formula where a name is needed"));
        };
        if let Some(local) = place.local(name) {
            return if local.is_index {
                Err(NoValue::shape("an index where a variable is needed"))
            } else {
                Ok(name)
            };
        }
        let is_definition = self.declarations.definition(name).is_some();
        match self.declarations.symbol(name) {
            Some(SymbolKind::Real(_)) if !is_definition => Ok(name),
            _ => Err(no_variable()),
        }
    }

    /// The environment inside of a binder of a variable; the variable is bound in the layer in which its name is
    /// found.
    pub(super) fn bound(
        &self,
        name: &'a str,
        value: Series<A::Number>,
        place: &Place<'a, A>,
    ) -> Place<'a, A> {
        match place.local(name) {
            Some(local) => place.with_local(name, Value::Number(value), local.is_index),
            None => self.moving(name, Part::Whole, value, place),
        }
    }

    /// The environment inside of `at(.., name, point)`.
    pub(super) fn bind_at(
        &self,
        name: &'a Expr,
        point: &'a Expr,
        place: &Place<'a, A>,
    ) -> Result<Place<'a, A>, NoValue> {
        let value = self.value(point, place)?;
        let Node::Name(name) = &name.node else {
            return Err(NoValue::shape("a formula where a name is needed"));
        };
        if let Some(local) = place.local(name) {
            return Ok(place.with_local(name, value, local.is_index));
        }
        let is_definition = self.declarations.definition(name).is_some();
        match self.declarations.symbol(name) {
            Some(SymbolKind::Real(_) | SymbolKind::Integer { .. }) if !is_definition => {
                Ok(self.moving(name, Part::Whole, value.number()?, place))
            }
            _ => Err(no_variable()),
        }
    }

    /// The value of a function at arguments.
    pub(super) fn apply(
        &self,
        function: &Closure<'a, A::Number>,
        mut arguments: Vec<Value<A::Number>>,
    ) -> Result<Value<A::Number>, NoValue> {
        match function {
            Closure::Body { definition, moved } => self.called(definition, moved, arguments),
            Closure::ByParameter {
                function,
                parameter,
                order,
            } => {
                let slot = arguments.get(*parameter).cloned();
                let slot = slot.ok_or_else(|| NoValue::shape("a number of arguments"))?;
                self.derivative(*order, &slot.number()?, |moved| {
                    if let Some(slot) = arguments.get_mut(*parameter) {
                        *slot = Value::Number(moved);
                    }
                    self.apply(function, arguments)
                })
            }
            Closure::BySymbol {
                tree,
                environment,
                symbol,
                point,
                order,
                ..
            } => self.derivative(*order, point, |moved| {
                let inside = self.bound(symbol, moved, environment);
                let function = self.function(tree, &inside)?.ok_or_else(no_variable)?;
                self.apply(&function, arguments)
            }),
            Closure::Given { name } => {
                let [argument] = arguments.as_slice() else {
                    return Err(NoValue::shape("a number of arguments"));
                };
                self.smooth_value(name, &argument.clone().number()?)
            }
        }
    }

    /// `order!` times the coefficient of `e^order` in the value of `inside` at `point + e`.
    ///
    /// The infinitesimal has a level above all that are in use, so a function applied inside of another derivative
    /// gets one of its own. The result is checked not to contain it any more.
    pub(super) fn derivative(
        &self,
        order: i64,
        point: &Series<A::Number>,
        inside: impl FnOnce(Series<A::Number>) -> Result<Value<A::Number>, NoValue>,
    ) -> Result<Value<A::Number>, NoValue> {
        let a = self.arithmetic;
        let what = "the order of a derivative";
        if order < 0 {
            return Err(Undefined::Negative { what }.into());
        }
        if order > MAX_ORDER {
            return Err(Unknown::Large { what }.into());
        }
        let terms = usize::try_from(order).unwrap_or(0);
        let factorial: Rational = (1..=order).map(integer).product();
        let factorial = Series::rational(&factorial, a);
        self.at_new_level(|level| {
            let value = inside(point.clone().shifted(level, terms, a))?;
            self.check_levels(&value, level)?;
            value.each(&|series| series.coefficient(level, terms, a).times(&factorial, a))
        })
    }

    /// Runs `inside` with a new level, and checks that the level does not occur in its result.
    pub(super) fn at_new_level(
        &self,
        inside: impl FnOnce(usize) -> Result<Value<A::Number>, NoValue>,
    ) -> Result<Value<A::Number>, NoValue> {
        let outer = self.level.get();
        self.level.set(outer + 1);
        let value = inside(outer + 1);
        self.level.set(outer);
        let value = value?;
        self.check_levels(&value, outer)?;
        Ok(value)
    }

    /// Fails if an infinitesimal above this level occurs, which happens only if the evaluator is wrong.
    fn check_levels(&self, value: &Value<A::Number>, max_level: usize) -> Result<(), NoValue> {
        if value
            .numbers()
            .iter()
            .all(|series| series.level() <= max_level)
        {
            Ok(())
        } else {
            Err(Unknown::Confused.into())
        }
    }
}

fn no_variable() -> NoValue {
    NoValue::shape("a name that is no variable")
}
