//! Where functions at arguments have values, and derivatives: below a derivative a formula has a value near the point,
//! and has derivatives itself where that is not plain.

use super::function::{Binding, derivative, is_name};
use super::kinds::Kind;
use super::premises::{Premises, mentions};
use super::scope::{Local, Scope, words};
use super::writer::{Value, Writer};
use crate::code::{Code, Level, integer_scope};
use crate::gap::Untranslatable;
use torse_syntax::formula::{Expr, Node};

impl Writer<'_> {
    /// The premises of a function at arguments.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the value.
    pub fn application_defined(
        &mut self,
        head: &Expr,
        arguments: &[Expr],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        let mut given = vec![];
        for argument in arguments {
            self.defined(argument, scope, premises)?;
            given.push(self.standing_for(argument, scope)?);
        }
        self.applied_defined(head, &given, scope, premises)
    }

    /// The texts that stand for what a definition depends on: its arguments, and the symbols that it reaches.
    ///
    /// # Errors
    /// [`Untranslatable::Unread`] for symbols that are not declared.
    pub fn texts(
        &self,
        name: &str,
        arguments: &[Local],
        scope: &Scope,
    ) -> Result<Vec<String>, Untranslatable> {
        let mut texts: Vec<String> = arguments.iter().map(|a| a.code.text().to_owned()).collect();
        for symbol in &self.names.of_definition(name).symbols {
            texts.push(self.standing(symbol, scope)?.text().to_owned());
        }
        Ok(texts)
    }

    /// What stands for a parameter of this value: an integer where it can.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the value.
    pub fn standing_for(&mut self, expr: &Expr, scope: &Scope) -> Result<Local, Untranslatable> {
        if let Some(code) = self.integer(expr, scope) {
            return Ok(Local {
                code: Code::atom(integer_scope(&code)),
                kind: Kind::Integer,
            });
        }
        let Value { code, shape } = self.value(expr, scope)?;
        Ok(Local {
            code: Code::atom(code.argument()),
            kind: Kind::Value(shape),
        })
    }

    /// The premises of a function at arguments that have values.
    fn applied_defined(
        &mut self,
        head: &Expr,
        arguments: &[Local],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        let bound = scope.bound();
        match &head.node {
            Node::Name(name) => {
                if let Some(definition) = self.names.definition(name, &bound) {
                    let body = &definition.body.expr;
                    let mut inside = scope.outside();
                    if definition.parameters.is_empty() {
                        return self.applied_defined(body, arguments, &inside, premises);
                    }
                    let texts = self.texts(name, arguments, scope)?;
                    if !premises.opened.insert((name.clone(), texts)) {
                        return Ok(());
                    }
                    for (parameter, local) in definition.parameters.iter().zip(arguments) {
                        inside = inside.with_local(parameter, local.code.clone(), local.kind);
                    }
                    return self.defined(body, &inside, premises);
                }
                let base = name.trim_end_matches('\'');
                if self.names.declarations.function(name).is_some() || base.len() == name.len() {
                    return Ok(());
                }
                let order = Code::atom((name.len() - base.len()).to_string());
                self.rate_defined(&Expr::name(base), 0, &order, arguments, scope, premises)
            }
            Node::Call(own, inner) => match (self.names.built_in(own, &bound), inner.as_slice()) {
                (Some("D"), [inner, rest @ ..]) => {
                    if let Some(order) = rest.get(1) {
                        self.defined(order, scope, premises)?;
                    }
                    let order = self.order(rest.get(1), scope)?;
                    let own = self.names.parameters(inner, &bound).unwrap_or_default();
                    let by = match rest.first() {
                        None => Some(0),
                        Some(variable) => own.iter().position(|name| is_name(variable, name)),
                    };
                    if let Some(by) = by {
                        return self.rate_defined(inner, by, &order, arguments, scope, premises);
                    }
                    let variable = rest.first();
                    let variable =
                        variable.ok_or(Untranslatable::Construct("a derivative by nothing"))?;
                    let reach = self.reach(inner, scope);
                    let binding = self.binding_beside(variable, &reach, scope, arguments)?;
                    self.near_applied(inner, &binding, &order, arguments, premises)
                }
                (Some("at"), [inner, variable, point]) => {
                    let inside = self.put_in_place(variable, point, scope, premises)?;
                    self.applied_defined(inner, arguments, &inside, premises)
                }
                _ => Ok(()),
            },
            _ => Ok(()),
        }
    }

    /// The premises of a derivative by a parameter.
    fn rate_defined(
        &mut self,
        inner: &Expr,
        by: usize,
        order: &Code,
        arguments: &[Local],
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        let names = self.names.parameters(inner, &scope.bound());
        let names = names.unwrap_or_default();
        let like = names.get(by).map_or("x", String::as_str);
        let at = arguments.get(by);
        let at = at.ok_or(Untranslatable::Construct("a derivative by no parameter"))?;
        let outside = match at.kind {
            Kind::Integer => super::function::real(&at.code),
            Kind::Value(_) => at.code.clone(),
        };
        let mut taken = scope.words("");
        taken.extend(arguments.iter().flat_map(|local| words(local.code.text())));
        let name = self.fresh_beside(like, &self.reach(inner, scope), taken);
        let mut inside = arguments.to_vec();
        if let Some(place) = inside.get_mut(by) {
            *place = Local {
                code: Code::atom(&name),
                kind: Kind::NUMBER,
            };
        }
        let binding = Binding {
            name,
            kind: Kind::NUMBER,
            outside,
            scope: scope.clone(),
        };
        self.near_applied(inner, &binding, order, &inside, premises)
    }

    /// The premises of the derivative of a function at arguments, one of which may be what the derivative binds.
    fn near_applied(
        &mut self,
        inner: &Expr,
        binding: &Binding,
        order: &Code,
        arguments: &[Local],
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        let mut found = Premises::default();
        self.applied_defined(inner, arguments, &binding.scope, &mut found)?;
        let function = self.function(inner, &binding.scope)?;
        let function = function.ok_or(Untranslatable::Construct(
            "a derivative of what is no function",
        ))?;
        let mut given = vec![];
        for (local, (_, kind)) in arguments.iter().zip(&function.parameters) {
            given.push(match (local.kind, kind) {
                (Kind::Integer, Kind::Value(_)) => {
                    (super::function::real(&local.code), Kind::NUMBER)
                }
                (own, _) => (local.code.clone(), own),
            });
        }
        let value = function.applied(self, &given)?;
        let rough = self.rough_applied(inner, arguments, &binding.scope, &binding.name)?;
        near(
            binding,
            found.into_vec(),
            rough.then_some(value),
            order,
            premises,
        )
    }
}

/// Adds what a derivative needs: its formula has a value near the point, and has derivatives where that is not plain.
///
/// # Errors
/// [`Untranslatable::Construct`] for orders and shapes whose derivatives are not stated.
pub(super) fn near(
    binding: &Binding,
    found: Vec<Code>,
    rough: Option<Value>,
    order: &Code,
    premises: &mut Premises,
) -> Result<(), Untranslatable> {
    let (name, at) = (&binding.name, binding.outside.argument());
    for premise in found {
        // What does not depend on the variable has no neighbourhood.
        if !mentions(premise.text(), name) {
            premises.add(premise);
            continue;
        }
        let near = format!("locally {at} (fun {name} => {})", premise.text());
        premises.add(Code::new(near, Level::Application));
    }
    let Some(value) = rough else {
        return Ok(());
    };
    if order.text().contains(' ') {
        return Err(Untranslatable::Construct("a derivative of symbolic order"));
    }
    let derived = derivative(name, value, order, &binding.outside)?;
    let text = derived.code.text();
    let text = match text.strip_prefix("Derive_n ") {
        Some(rest) => format!("ex_derive_n {rest}"),
        None => {
            return Err(Untranslatable::Construct(
                "a derivative of a vector with roots",
            ));
        }
    };
    premises.add(Code::new(text, Level::Application));
    Ok(())
}
