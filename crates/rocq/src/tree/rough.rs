//! Whether something occurs in a formula that is not smooth wherever it has a value.

use super::premises::{Premises, mentions};
use super::scope::{Local, Scope};
use super::writer::Writer;
use crate::gap::Untranslatable;
use torse_syntax::formula::{Expr, Node, Operator};

impl Writer<'_> {
    /// Whether something occurs that is not smooth wherever it has a value: roots, and powers with symbols in the
    /// exponent, of what depends on this name.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the values.
    pub fn rough(
        &mut self,
        expr: &Expr,
        scope: &Scope,
        name: &str,
    ) -> Result<bool, Untranslatable> {
        self.visit()?;
        let bound = scope.bound();
        match &expr.node {
            Node::Name(own) => match self.names.definition(own, &bound) {
                Some(definition) if definition.parameters.is_empty() => {
                    self.rough(&definition.body.expr, &scope.outside(), name)
                }
                _ => Ok(false),
            },
            Node::Binary(Operator::Power, base, exponent) => {
                if self.literal(exponent, scope).is_none()
                    && mentions(self.number(base, scope)?.text(), name)
                {
                    return Ok(true);
                }
                Ok(self.rough(base, scope, name)?)
            }
            Node::Call(head, arguments) => {
                if let Some(own) = self.names.built_in(head, &bound) {
                    return match (own, arguments.as_slice()) {
                        ("sqrt" | "norm" | "abs", [inner]) => Ok(!self.is_positive(inner, scope)),
                        ("min" | "max", _) => Ok(true),
                        ("sum" | "product", [index, _, _, term]) => {
                            let (_, inside) = self.counted(index, term, scope)?;
                            self.rough(term, &inside, name)
                        }
                        ("at", [inner, variable, point]) => {
                            let none = &mut Premises::default();
                            let inside = self.put_in_place(variable, point, scope, none)?;
                            Ok(self.rough(point, scope, name)?
                                || self.rough(inner, &inside, name)?)
                        }
                        ("D", [inner, variable, ..]) => {
                            let reach = self.reach(inner, scope);
                            let binding = self.binding(variable, &reach, scope)?;
                            self.rough(inner, &binding.scope, name)
                        }
                        _ => self.any_rough(arguments, scope, name),
                    };
                }
                if self.any_rough(arguments, scope, name)? {
                    return Ok(true);
                }
                if matches!(&head.node, Node::Index(..)) {
                    return Ok(false);
                }
                let mut given = vec![];
                for argument in arguments {
                    given.push(self.standing_for(argument, scope)?);
                }
                self.rough_applied(head, &given, scope, name)
            }
            _ => {
                for part in expr.parts() {
                    if self.rough(part, scope, name)? {
                        return Ok(true);
                    }
                }
                Ok(false)
            }
        }
    }

    fn any_rough(
        &mut self,
        exprs: &[Expr],
        scope: &Scope,
        name: &str,
    ) -> Result<bool, Untranslatable> {
        for expr in exprs {
            if self.rough(expr, scope, name)? {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// The same of a function at arguments.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the values.
    pub fn rough_applied(
        &mut self,
        head: &Expr,
        arguments: &[Local],
        scope: &Scope,
        name: &str,
    ) -> Result<bool, Untranslatable> {
        let bound = scope.bound();
        match &head.node {
            Node::Name(own) => {
                if let Some(definition) = self.names.definition(own, &bound) {
                    let body = &definition.body.expr;
                    let mut inside = scope.outside();
                    if definition.parameters.is_empty() {
                        return self.rough_applied(body, arguments, &inside, name);
                    }
                    for (parameter, local) in definition.parameters.iter().zip(arguments) {
                        inside = inside.with_local(parameter, local.code.clone(), local.kind);
                    }
                    return self.rough(body, &inside, name);
                }
                let base = own.trim_end_matches('\'');
                match base.len() < own.len() && self.names.declarations.function(own).is_none() {
                    true => self.rough_applied(&Expr::name(base), arguments, scope, name),
                    false => Ok(false),
                }
            }
            Node::Call(own, inner) => match (self.names.built_in(own, &bound), inner.as_slice()) {
                (Some("D"), [inner, ..]) => self.rough_applied(inner, arguments, scope, name),
                (Some("at"), [inner, variable, point]) => {
                    let none = &mut Premises::default();
                    let inside = self.put_in_place(variable, point, scope, none)?;
                    self.rough_applied(inner, arguments, &inside, name)
                }
                _ => Ok(false),
            },
            _ => Ok(false),
        }
    }
}
