//! Bases: a `Definition` for a family, which takes variable and shape parameters, and then index and degree.

use super::kinds::Kind;
use super::scope::Scope;
use super::writer::{Head, Named, Value, Writer};
use crate::code::{Code, Level};
use crate::gap::Untranslatable;
use torse_syntax::derivation::declarations::Basis;
use torse_syntax::formula::Expr;

impl Writer<'_> {
    /// Function i of degree k of a basis at arguments; those that are left out are the declared names.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the values.
    pub fn member(
        &mut self,
        name: &str,
        basis: &Basis,
        indices: &[Expr],
        arguments: &[Expr],
        scope: &Scope,
    ) -> Result<Value, Untranslatable> {
        let [index, degree] = indices else {
            return Err(Untranslatable::Unread(format!(
                "`{name}` without index and degree"
            )));
        };
        let head = self.family(name, basis)?;
        let mut all = self.with_symbols(&head, scope)?;
        let given = self.arguments(basis, arguments, scope)?;
        for ((argument, scope), kind) in given.iter().zip(self.names.kinds_of_basis(name)) {
            match self.argument(argument, kind, scope)? {
                (code, Kind::Integer | Kind::NUMBER) => all.push(code),
                (_, Kind::Value(shape)) => {
                    return Err(Untranslatable::Shapes(format!(
                        "{shape} where a number is wanted"
                    )));
                }
            }
        }
        all.extend([self.index(index, scope)?, self.index(degree, scope)?]);
        Ok(Value::number(Code::apply(&head.name, &all)))
    }

    /// The arguments of a basis with those that are left out, each with the scope that it is meant in.
    ///
    /// # Errors
    /// [`Untranslatable::Unread`] where one that is left out is the name of a binder.
    pub fn arguments(
        &self,
        basis: &Basis,
        arguments: &[Expr],
        scope: &Scope,
    ) -> Result<Vec<(Expr, Scope)>, Untranslatable> {
        let given = arguments.iter().map(|e| (e.clone(), scope.clone()));
        let mut all: Vec<(Expr, Scope)> = given.collect();
        let names = std::iter::once(&basis.variable).chain(&basis.parameters);
        for left_out in names.skip(arguments.len()) {
            if scope.locals.contains_key(left_out) {
                let what = format!("`{left_out}` is left out where a binder has its name");
                return Err(Untranslatable::Unread(what));
            }
            all.push((Expr::name(left_out), scope.outside()));
        }
        Ok(all)
    }

    /// The definition of a basis.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the values of seeds and step.
    pub fn family(&mut self, name: &str, basis: &Basis) -> Result<Head, Untranslatable> {
        let names = std::iter::once(&basis.variable).chain(&basis.parameters);
        let kinds = self.names.kinds_of_basis(name);
        let own: Vec<(String, Kind)> = names.cloned().zip(kinds).collect();
        self.define(
            Named::Basis,
            name,
            &own,
            &["i", "k"],
            |writer, scope, last| {
                let mut seeds = vec![];
                for seed in &basis.seeds {
                    seeds.push(writer.number(&seed.expr, scope)?);
                }
                let step = [&basis.step.0, &basis.step.1];
                let (head, [a, b]) = match &basis.counters {
                    None => ("basis", step.map(|part| writer.number(&part.expr, scope))),
                    Some(counters) => (
                        "counted",
                        step.map(|part| writer.factor(counters, &part.expr, scope)),
                    ),
                };
                let arguments = [&[a?, b?, Code::list(&seeds)], last].concat();
                Ok(Value::number(Code::apply(head, &arguments)))
            },
        )
    }

    /// A factor of the step as a function of index and degree.
    fn factor(
        &mut self,
        (index, degree): &(String, String),
        factor: &Expr,
        scope: &Scope,
    ) -> Result<Code, Untranslatable> {
        let mut bound = scope.bound();
        bound.extend([index.clone(), degree.clone()]);
        let reach = self.names.reach(factor, &bound);
        let i = self.binder(index, &reach, scope);
        let inside = scope.with_local(index, Code::atom(&i), Kind::Integer);
        let k = self.binder(degree, &reach, &inside);
        let inside = inside.with_local(degree, Code::atom(&k), Kind::Integer);
        let body = self.number(factor, &inside)?;
        let text = format!("fun {i} {k} => {}", body.text());
        Ok(Code::new(text, Level::Open))
    }
}
