//! Functions, as they are applied: definitions with parameters, declared functions, derivatives of functions, and
//! functions in which a declared symbol has another value.

use super::kinds::Kind;
use super::reach::Reach;
use super::scope::{Scope, words};
use super::writer::{Head, Named, Value, Writer, fresh};
use crate::code::{Code, Level};
use crate::gap::Untranslatable;
use crate::shape::Shape;
use std::collections::BTreeSet;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{Expr, Node};

/// A function.
#[derive(Debug, Clone)]
pub(super) struct Function {
    /// The names of its parameters, and which of them are integers; the others may have any shape.
    pub parameters: Vec<(String, Kind)>,
    form: Form,
}

/// How a function is written.
#[derive(Debug, Clone)]
enum Form {
    /// A declared function.
    Declared { name: Code, shape: Shape },
    /// A definition with the symbols that it takes.
    Defined { name: String, symbols: Vec<Code> },
    /// The derivative by a parameter.
    Rate {
        inner: Box<Function>,
        by: usize,
        order: Code,
    },
    /// The derivative by a declared symbol, which is called so inside, at its value outside.
    Partial {
        inner: Box<Function>,
        name: String,
        order: Code,
        at: Code,
    },
    /// The function where a declared symbol, which is called so inside, has another value.
    Moved {
        inner: Box<Function>,
        name: String,
        rocq_type: &'static str,
        value: Code,
    },
}

/// An argument, and what it is.
pub(super) type Argument = (Code, Kind);

impl Function {
    /// The function at arguments.
    ///
    /// # Errors
    /// [`Untranslatable::Construct`] for derivatives of matrices, and what is wrong with the body of a definition.
    pub fn applied(
        &self,
        writer: &mut Writer<'_>,
        arguments: &[Argument],
    ) -> Result<Value, Untranslatable> {
        let codes = || arguments.iter().map(|(code, _)| code.clone());
        match &self.form {
            Form::Declared { name, shape } => {
                let codes: Vec<Code> = codes().collect();
                Ok(Value::applied(name.text(), &codes, *shape))
            }
            Form::Defined { name, symbols } => {
                let kinds = arguments.iter().map(|(_, kind)| *kind);
                let own = self.parameters.iter().map(|(name, _)| name.clone());
                let own: Vec<(String, Kind)> = own.zip(kinds).collect();
                let head = writer.defined_head(name, &own)?;
                let all: Vec<Code> = symbols.iter().cloned().chain(codes()).collect();
                Ok(Value::applied(&head.name, &all, head.shape))
            }
            Form::Rate { inner, by, order } => {
                let parameter = inner.parameters.get(*by);
                let like = parameter.map_or("x", |(name, _)| name.as_str());
                let others = arguments.iter().enumerate().filter(|(i, _)| i != by);
                let others = others.flat_map(|(_, (code, _))| words(code.text()));
                let mut taken: BTreeSet<String> = others.collect();
                taken.extend(inner.words(writer));
                let variable = fresh(like, &taken);
                let mut inside = arguments.to_vec();
                let place = inside.get_mut(*by);
                let place =
                    place.ok_or(Untranslatable::Construct("a derivative by no parameter"))?;
                let moved = (Code::atom(&variable), place.1);
                let (at, _) = std::mem::replace(place, moved);
                derivative(&variable, inner.applied(writer, &inside)?, order, &at)
            }
            Form::Partial {
                inner,
                name,
                order,
                at,
            } => self.under(writer, name, arguments, |writer, arguments| {
                derivative(name, inner.applied(writer, arguments)?, order, at)
            }),
            Form::Moved {
                inner,
                name,
                rocq_type,
                value,
            } => self.under(writer, name, arguments, |writer, arguments| {
                let Value { code, shape } = inner.applied(writer, arguments)?;
                let code = put_in(name, rocq_type, &code, value);
                Ok(Value { code, shape })
            }),
        }
    }

    /// The names in it.
    fn words(&self, writer: &Writer<'_>) -> BTreeSet<String> {
        match &self.form {
            Form::Declared { name, .. } => words(name.text()).collect(),
            Form::Defined { name, symbols } => {
                let symbols = symbols.iter().flat_map(|code| words(code.text()));
                symbols.chain(writer.heads_of(name)).collect()
            }
            Form::Rate { inner, .. } => inner.words(writer),
            Form::Partial { inner, at, .. } => {
                let inner = inner.words(writer).into_iter();
                inner.chain(words(at.text())).collect()
            }
            Form::Moved { inner, value, .. } => {
                let inner = inner.words(writer).into_iter();
                inner.chain(words(value.text())).collect()
            }
        }
    }

    /// Arguments are those outside: where one of them mentions what is bound inside, it is given to a function.
    fn under(
        &self,
        writer: &mut Writer<'_>,
        name: &str,
        arguments: &[Argument],
        write: impl FnOnce(&mut Writer<'_>, &[Argument]) -> Result<Value, Untranslatable>,
    ) -> Result<Value, Untranslatable> {
        let mentions = |(code, _): &Argument| words(code.text()).any(|word| word == name);
        if !arguments.iter().any(mentions) {
            return write(writer, arguments);
        }
        let mut taken = self.words(writer);
        taken.insert(name.to_owned());
        let mut bound = String::new();
        let mut inside = vec![];
        for ((parameter, _), (_, kind)) in self.parameters.iter().zip(arguments) {
            let variable = fresh(parameter, &taken);
            taken.insert(variable.clone());
            bound.push_str(&format!(" ({variable} : {})", kind.rocq_type()));
            inside.push((Code::atom(variable), *kind));
        }
        let Value { code, shape } = write(writer, &inside)?;
        let head = format!("(fun{bound} => {})", code.text());
        let codes: Vec<Code> = arguments.iter().map(|(code, _)| code.clone()).collect();
        Ok(Value::applied(&head, &codes, shape))
    }
}

/// `Derive_n (fun x => body) order at`, entry by entry for a vector.
///
/// # Errors
/// [`Untranslatable::Construct`] for matrices.
pub(super) fn derivative(
    variable: &str,
    body: Value,
    order: &Code,
    at: &Code,
) -> Result<Value, Untranslatable> {
    let Value { code, shape } = body;
    let function = Code::new(format!("fun {variable} => {}", code.text()), Level::Open);
    let code = match shape {
        Shape::Number => Code::apply("Derive_n", &[function, order.clone(), at.clone()]),
        Shape::Vector(n) => {
            let size = Code::atom(n.to_string());
            Code::apply("vDerive", &[size, function, order.clone(), at.clone()])
        }
        Shape::Matrix(..) => return Err(Untranslatable::Construct("a derivative of a matrix")),
    };
    Ok(Value { code, shape })
}

/// `(fun x => body) value`
pub(super) fn put_in(name: &str, rocq_type: &str, body: &Code, value: &Code) -> Code {
    let head = format!("(fun {name} : {rocq_type} => {})", body.text());
    Code::apply(&head, std::slice::from_ref(value))
}

/// A name that `D`, `at` or `integral` binds, with what it is outside.
pub(super) struct Binding {
    /// What it is called inside.
    pub name: String,
    /// Whether it is an integer.
    pub kind: Kind,
    /// Its value outside.
    pub outside: Code,
    /// The scope inside.
    pub scope: Scope,
}

impl Writer<'_> {
    /// The function that a formula is, if it is one.
    ///
    /// # Errors
    /// [`Untranslatable`] for what has no translation.
    pub fn function(
        &mut self,
        expr: &Expr,
        scope: &Scope,
    ) -> Result<Option<Function>, Untranslatable> {
        match &expr.node {
            Node::Name(name) => self.named_function(name, scope),
            Node::Call(head, arguments) => {
                match (
                    self.names.built_in(head, &scope.bound()),
                    arguments.as_slice(),
                ) {
                    (Some("D"), [inner, rest @ ..]) => self.rate(inner, rest, scope),
                    (Some("at"), [inner, variable, point]) => {
                        if self.names.parameters(inner, &scope.bound()).is_none() {
                            return Ok(None);
                        }
                        let reach = self.reach(inner, scope);
                        let binding = self.binding(variable, &reach, scope)?;
                        let (value, _) = self.argument(point, binding.kind, scope)?;
                        let inner = self.function(inner, &binding.scope)?;
                        Ok(inner.map(|inner| Function {
                            parameters: inner.parameters.clone(),
                            form: Form::Moved {
                                inner: Box::new(inner),
                                name: binding.name,
                                rocq_type: binding.kind.rocq_type(),
                                value,
                            },
                        }))
                    }
                    _ => Ok(None),
                }
            }
            _ => Ok(None),
        }
    }

    fn named_function(
        &mut self,
        name: &str,
        scope: &Scope,
    ) -> Result<Option<Function>, Untranslatable> {
        if scope.locals.contains_key(name) || scope.moved.contains_key(name) {
            return Ok(None);
        }
        let declarations = self.names.declarations;
        if let Some(definition) = declarations.definition(name) {
            if definition.parameters.is_empty() {
                return self.function(&definition.body.expr, &scope.outside());
            }
            return self.defined_function(name, scope).map(Some);
        }
        if declarations.symbol(name).is_some() {
            return Ok(None);
        }
        if let Some(dimension) = declarations.function(name) {
            return Ok(Some(Function {
                parameters: vec![("x".to_owned(), Kind::NUMBER)],
                form: Form::Declared {
                    name: self.standing(name, scope)?,
                    shape: match dimension {
                        None | Some(1) => Shape::Number,
                        Some(n) => Shape::Vector(n.into()),
                    },
                },
            }));
        }
        let base = name.trim_end_matches('\'');
        if base.len() == name.len() {
            return Ok(None);
        }
        let order = Code::atom((name.len() - base.len()).to_string());
        let inner = self.named_function(base, scope)?;
        Ok(inner.map(|inner| rate(inner, 0, order)))
    }

    /// A definition with parameters.
    ///
    /// # Errors
    /// [`Untranslatable::Unread`] for what is none.
    pub fn defined_function(
        &mut self,
        name: &str,
        scope: &Scope,
    ) -> Result<Function, Untranslatable> {
        let definition = self.names.declarations.definition(name);
        let definition = definition.ok_or_else(|| Untranslatable::Unread(name.to_owned()))?;
        let kinds = self.names.kinds_of_definition(name);
        let parameters = definition.parameters.iter().cloned().zip(kinds).collect();
        let reach = self.names.of_definition(name);
        let symbols = reach.symbols.iter().map(|name| self.standing(name, scope));
        Ok(Function {
            parameters,
            form: Form::Defined {
                name: name.to_owned(),
                symbols: symbols.collect::<Result<_, _>>()?,
            },
        })
    }

    /// The `Definition` of a name with parameters of these kinds.
    fn defined_head(&mut self, name: &str, own: &[(String, Kind)]) -> Result<Head, Untranslatable> {
        let definition = self.names.declarations.definition(name);
        let definition = definition.ok_or_else(|| Untranslatable::Unread(name.to_owned()))?;
        self.define(Named::Definition, name, own, &[], |writer, scope, _| {
            writer.value(&definition.body.expr, scope)
        })
    }

    /// The function that `D(F, x, n)` is, if F is one.
    fn rate(
        &mut self,
        inner: &Expr,
        rest: &[Expr],
        scope: &Scope,
    ) -> Result<Option<Function>, Untranslatable> {
        let Some(own) = self.names.parameters(inner, &scope.bound()) else {
            return Ok(None);
        };
        let order = self.order(rest.get(1), scope)?;
        let by = match rest.first() {
            None => Some(0),
            Some(variable) => own.iter().position(|name| is_name(variable, name)),
        };
        if let Some(by) = by {
            let inner = self.function(inner, scope)?;
            return Ok(inner.map(|inner| rate(inner, by, order)));
        }
        let variable = rest.first();
        let variable = variable.ok_or(Untranslatable::Construct("a derivative by nothing"))?;
        let reach = self.reach(inner, scope);
        let binding = self.binding(variable, &reach, scope)?;
        let inner = self.function(inner, &binding.scope)?;
        Ok(inner.map(|inner| Function {
            parameters: inner.parameters.clone(),
            form: Form::Partial {
                inner: Box::new(inner),
                name: binding.name,
                order,
                at: binding.outside,
            },
        }))
    }

    /// The order of a derivative, 1 if it is left out.
    ///
    /// # Errors
    /// [`Untranslatable::Construct`] for what is no integer.
    pub fn order(&self, order: Option<&Expr>, scope: &Scope) -> Result<Code, Untranslatable> {
        let Some(order) = order else {
            return Ok(Code::atom("1"));
        };
        match self.literal(order, scope) {
            Some(order) if order >= 0 => Ok(Code::atom(order.to_string())),
            Some(_) => Err(Untranslatable::Construct("a derivative of negative order")),
            None => match self.integer(order, scope) {
                Some(_) => Ok(Code::apply("Z.to_nat", &[self.index(order, scope)?])),
                None => Err(Untranslatable::Construct(
                    "a derivative whose order is no integer",
                )),
            },
        }
    }

    /// What `D`, `at` or `integral` binds in a formula that reaches this.
    ///
    /// # Errors
    /// [`Untranslatable::Unread`] for what is neither a local name nor a declared number.
    pub fn binding(
        &mut self,
        variable: &Expr,
        reach: &Reach,
        scope: &Scope,
    ) -> Result<Binding, Untranslatable> {
        let Node::Name(name) = &variable.node else {
            return Err(Untranslatable::Unread("a binder without a name".to_owned()));
        };
        if let Some(local) = scope.locals.get(name) {
            let bound = self.binder(name, reach, scope);
            let outside = match local.kind {
                Kind::Integer => Code::apply("IZR", std::slice::from_ref(&local.code)),
                Kind::Value(_) => local.code.clone(),
            };
            return Ok(Binding {
                scope: scope.with_local(name, Code::atom(&bound), local.kind),
                name: bound,
                kind: local.kind,
                outside,
            });
        }
        let kind = match self.names.declarations.symbol(name) {
            Some(SymbolKind::Real(_) | SymbolKind::Vector(None)) => Kind::NUMBER,
            Some(SymbolKind::Integer { .. }) => Kind::Integer,
            _ => {
                return Err(Untranslatable::Unread(format!(
                    "`{name}` is bound and is no number"
                )));
            }
        };
        let mut others = reach.clone();
        others.symbols.remove(name);
        // Inside, the symbol has its own name wherever nothing else that is meant there has it.
        let own = self.symbol(name)?.to_owned();
        let bound = self.binder(
            &own,
            &others,
            &Scope {
                moved: scope
                    .moved
                    .iter()
                    .filter(|(other, _)| *other != name)
                    .map(|(other, code)| (other.clone(), code.clone()))
                    .collect(),
                locals: scope.locals.clone(),
            },
        );
        let outside = self.standing(name, scope)?;
        Ok(Binding {
            scope: scope.with_moved(name, Code::atom(&bound)),
            name: bound,
            kind,
            outside,
        })
    }

    /// A value as the argument of a parameter of this kind: an integer where one is wanted, else what it is.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the value, and where an integer is wanted.
    pub fn argument(
        &mut self,
        expr: &Expr,
        kind: Kind,
        scope: &Scope,
    ) -> Result<Argument, Untranslatable> {
        if kind == Kind::Integer {
            return Ok((self.index(expr, scope)?, Kind::Integer));
        }
        let plain = |expr: &Expr| matches!(expr.node, Node::Number { .. });
        let written = match &expr.node {
            Node::Negative(inner) => plain(inner),
            _ => plain(expr),
        };
        // What is an integer by its form is one in Rocq too.
        if let Some(code) = self.integer(expr, scope).filter(|_| !written) {
            return Ok((real(&code), Kind::NUMBER));
        }
        let Value { code, shape } = self.value(expr, scope)?;
        Ok((code, Kind::Value(shape)))
    }

    /// A function at arguments.
    ///
    /// # Errors
    /// [`Untranslatable`], as for their values.
    pub fn call(
        &mut self,
        function: &Function,
        arguments: &[Expr],
        scope: &Scope,
    ) -> Result<Value, Untranslatable> {
        if function.parameters.len() != arguments.len() {
            return Err(Untranslatable::Unread(
                "a wrong number of arguments".to_owned(),
            ));
        }
        let mut given = vec![];
        for (argument, (_, kind)) in arguments.iter().zip(&function.parameters) {
            given.push(self.argument(argument, *kind, scope)?);
        }
        function.applied(self, &given)
    }
}

/// An integer as a real number.
pub(super) fn real(code: &Code) -> Code {
    let text = code.text();
    let digits = text.strip_suffix("%Z").unwrap_or(text);
    match digits.bytes().all(|byte| byte.is_ascii_digit()) {
        true => Code::atom(digits),
        false => Code::apply("IZR", &[Code::atom(crate::code::integer_scope(code))]),
    }
}

fn rate(inner: Function, by: usize, order: Code) -> Function {
    Function {
        parameters: inner.parameters.clone(),
        form: Form::Rate {
            inner: Box::new(inner),
            by,
            order,
        },
    }
}

/// Whether a formula is this name.
pub(super) fn is_name(expr: &Expr, name: &str) -> bool {
    matches!(&expr.node, Node::Name(own) if own == name)
}

impl Writer<'_> {
    /// The same as [`Writer::binding`] where these texts stand beside the formula.
    pub fn binding_beside(
        &mut self,
        variable: &Expr,
        reach: &Reach,
        scope: &Scope,
        beside: &[super::scope::Local],
    ) -> Result<Binding, Untranslatable> {
        let binding = self.binding(variable, reach, scope)?;
        let taken: BTreeSet<String> = beside
            .iter()
            .flat_map(|local| words(local.code.text()))
            .collect();
        if !taken.contains(&binding.name) {
            return Ok(binding);
        }
        let name = self.fresh_beside(&binding.name, reach, taken);
        let Node::Name(own) = &variable.node else {
            return Ok(binding);
        };
        let scope = match scope.locals.contains_key(own) {
            true => scope.with_local(own, Code::atom(&name), binding.kind),
            false => scope.with_moved(own, Code::atom(&name)),
        };
        Ok(Binding {
            name,
            scope,
            ..binding
        })
    }
}
