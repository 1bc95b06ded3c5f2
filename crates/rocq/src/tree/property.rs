//! Properties of bases: at every degree from that of the seeds on and for all values of the family's variable in its
//! declared set, for the values of the shape parameters outside.

use super::kinds::Kind;
use super::premises::Premises;
use super::scope::{Scope, words};
use super::translation::{all_of, compare};
use super::writer::{Writer, fresh};
use crate::code::{Code, Level};
use crate::gap::Untranslatable;
use crate::interval::within;
use std::collections::BTreeSet;
use torse_syntax::derivation::declarations::{Basis, SymbolKind};
use torse_syntax::formula::{Expr, Node};

impl<'a> Writer<'a> {
    /// A basis by its name.
    fn basis_named(&self, expr: &Expr) -> Result<(String, &'a Basis), Untranslatable> {
        let Node::Name(name) = &expr.node else {
            return Err(Untranslatable::Unread(
                "a property of what is no basis".to_owned(),
            ));
        };
        let basis = self.names.declarations.basis(name);
        let basis = basis.ok_or_else(|| Untranslatable::Unread(format!("`{name}` is no basis")))?;
        Ok((name.clone(), basis))
    }

    /// The premises under which the functions of a basis have values, for all values of its variable.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the basis.
    pub fn property_defined(
        &mut self,
        basis: &Expr,
        scope: &Scope,
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        let (name, basis) = self.basis_named(basis)?;
        let parts = basis.seeds.iter().chain([&basis.step.0, &basis.step.1]);
        let parts: Vec<&Expr> = parts.map(|part| &part.expr).collect();
        let Property {
            variable,
            inside,
            scope,
            ..
        } = self.property(&name, scope)?;
        for part in parts {
            for premise in self.gathered(part, &scope)? {
                let moves = words(premise.text()).any(|word| word == variable);
                premises.add(match moves {
                    true => Code::new(
                        format!("forall {variable} : R, {inside}{}", premise.text()),
                        Level::Open,
                    ),
                    false => premise,
                });
            }
        }
        Ok(())
    }

    /// That all functions of a basis are nonnegative.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the basis.
    pub fn nonnegative(&mut self, basis: &Expr, scope: &Scope) -> Result<Code, Untranslatable> {
        let (name, basis) = self.basis_named(basis)?;
        let members: i64 = basis.degree.into();
        let is_list = basis.is_list;
        let property = self.property(&name, scope)?;
        let Property {
            variable,
            inside,
            i,
            k,
            lowest,
            ..
        } = &property;
        let body = match is_list {
            true => {
                let member = |i: i64| {
                    let function = property.function(&i.to_string(), &members.to_string());
                    compare(&function, ">=", &Code::atom("0"))
                };
                all_of((0..=members).map(member).collect())?
                    .text()
                    .to_owned()
            }
            false => format!(
                "forall {i} {k} : Z, ({lowest} <= {k})%Z -> 0 <= {}",
                property.function(i, k).text()
            ),
        };
        let text = format!("forall {variable} : R, {inside}{body}");
        Ok(Code::new(text, Level::Open))
    }

    /// That the functions of each degree are linearly independent on the interval.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the basis.
    pub fn independent(&mut self, basis: &Expr, scope: &Scope) -> Result<Code, Untranslatable> {
        let (name, basis) = self.basis_named(basis)?;
        if basis.is_list {
            return Err(Untranslatable::Construct("the independence of a list"));
        }
        let property = self.property(&name, scope)?;
        let function = property.function(&property.i, &property.k);
        let Property {
            variable,
            inside,
            i,
            k,
            c,
            lowest,
            ..
        } = property;
        let text = format!(
            "forall ({k} : Z) ({c} : Z -> R), ({lowest} <= {k})%Z -> \
             (forall {variable} : R, {inside}sum 0 {k} (fun {i} => {c} {i} * {}) = 0) -> \
             forall {i} : Z, (0 <= {i} <= {k})%Z -> {c} {i} = 0",
            function.argument()
        );
        Ok(Code::new(text, Level::Open))
    }

    /// A basis at the values of its shape parameters outside, and names for what is quantified: its variable over its
    /// declared set, and indices and degree.
    fn property(&mut self, name: &str, scope: &Scope) -> Result<Property, Untranslatable> {
        let basis = self.names.declarations.basis(name);
        let basis = basis.ok_or_else(|| Untranslatable::Unread(format!("`{name}` is no basis")))?;
        if basis.counters.is_some() {
            return Err(Untranslatable::Construct(
                "a property of a basis whose step depends on the index",
            ));
        }
        let interval = match self.names.declarations.symbol(&basis.variable) {
            Some(SymbolKind::Real(interval)) => interval,
            _ => {
                return Err(Untranslatable::Unread(format!(
                    "`{}` is no number",
                    basis.variable
                )));
            }
        };
        if interval.formulas().next().is_some() {
            return Err(Untranslatable::Construct(
                "a property of a basis on an interval between formulas",
            ));
        }
        let head = self.family(name, basis)?;
        let mut all = self.with_symbols(&head, &scope.outside())?;
        let kinds = self.names.kinds_of_basis(name).into_iter().skip(1);
        let mut parameters = vec![];
        for (own, kind) in basis.parameters.iter().zip(kinds) {
            parameters.push(self.argument(&Expr::name(own), kind, &scope.outside())?);
        }
        let mut taken: BTreeSet<String> = all
            .iter()
            .chain(parameters.iter().map(|(code, _)| code))
            .flat_map(|code| words(code.text()))
            .collect();
        taken.insert(head.name.clone());
        let names = [basis.variable.as_str(), "i", "k", "c"];
        let [variable, i, k, c] = names.map(|like| {
            let name = fresh(like, &taken);
            taken.insert(name.clone());
            name
        });
        let inside = within(&variable, interval);
        let mut own =
            scope
                .outside()
                .with_local(&basis.variable, Code::atom(&variable), Kind::NUMBER);
        all.push(Code::atom(&variable));
        for (parameter, (code, kind)) in basis.parameters.iter().zip(parameters) {
            own = own.with_local(parameter, Code::atom(code.argument()), kind);
            all.push(code);
        }
        Ok(Property {
            head: head.name,
            arguments: all,
            inside: inside.map_or_else(String::new, |code| format!("{} -> ", code.text())),
            variable,
            i,
            k,
            c,
            lowest: basis.degree,
            scope: own,
        })
    }
}

/// A basis of which something is said for all values of its variable.
struct Property {
    head: String,
    arguments: Vec<Code>,
    variable: String,
    /// The premise that the variable is in its set.
    inside: String,
    i: String,
    k: String,
    c: String,
    lowest: u8,
    /// What its names stand for in seeds and step.
    scope: Scope,
}

impl Property {
    /// Function i of degree k.
    fn function(&self, i: &str, k: &str) -> Code {
        let mut all = self.arguments.clone();
        all.extend(
            [i, k].map(|n| match n.bytes().all(|byte| byte.is_ascii_digit()) {
                true => Code::atom(format!("{n}%Z")),
                false => Code::atom(n),
            }),
        );
        Code::apply(&self.head, &all)
    }
}
