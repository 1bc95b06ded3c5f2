//! `coefficients`: the derivatives of forms by symbols, and by members of families.

use super::scope::{Scope, words};
use super::writer::{Value, Writer};
use crate::code::{Code, Level};
use crate::gap::Untranslatable;
use crate::place::Place;
use crate::shape::Shape;
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{Expr, Node};

const NO_LIST: Untranslatable = Untranslatable::Construct("`coefficients` of what is no list");

impl Writer<'_> {
    /// Entry (r, c) is the derivative of form r by symbol c.
    ///
    /// # Errors
    /// [`Untranslatable`], as for the forms, and for what is no symbol.
    pub fn coefficients(
        &mut self,
        forms: &Expr,
        symbols: &Expr,
        scope: &Scope,
    ) -> Result<Value, Untranslatable> {
        let (forms, inside) = self.items(forms, scope).ok_or(NO_LIST)?;
        let (symbols, outside) = self.items(symbols, scope).ok_or(NO_LIST)?;
        let mut rows = vec![];
        for form in &forms {
            let mut row = vec![];
            for symbol in &symbols {
                row.push(self.coefficient(form, &inside, symbol, &outside)?);
            }
            rows.push(Code::list(&row));
        }
        Ok(Value {
            code: Code::list(&rows),
            shape: Shape::Matrix(forms.len(), symbols.len()),
        })
    }

    /// The formulas of a list, through definitions, and the scope that they are meant in.
    fn items(&self, list: &Expr, scope: &Scope) -> Option<(Vec<Expr>, Scope)> {
        match &list.node {
            Node::List(items) => Some((items.clone(), scope.clone())),
            Node::Name(name) => {
                let definition = self.names.definition(name, &scope.bound())?;
                let plain = definition.parameters.is_empty();
                plain.then(|| self.items(&definition.body.expr, &scope.outside()))?
            }
            _ => None,
        }
    }

    fn coefficient(
        &mut self,
        form: &Expr,
        scope: &Scope,
        symbol: &Expr,
        outside: &Scope,
    ) -> Result<Code, Untranslatable> {
        let place = self.place(symbol, outside)?;
        let kind = self.names.declarations.symbol(&place.declared);
        if matches!(kind, Some(SymbolKind::Integer { .. })) {
            return Err(Untranslatable::Construct("`coefficients` of integers"));
        }
        let unknowns = self.unknown_names();
        if unknowns.contains(&*place.declared) {
            return Err(Untranslatable::Construct(
                "coefficients of unknowns of equations",
            ));
        }
        let reach = self.reach(form, scope);
        if reach.symbols.iter().any(|name| unknowns.contains(name)) {
            if self.depth > 0 || !scope.locals.is_empty() {
                return Err(Untranslatable::Theory(
                    "coefficients along given equations, in a definition or below a binder",
                ));
            }
            return self.coefficient_along(form, scope, &place);
        }
        if !place.is_member() {
            let name = Expr::name(&place.declared);
            let binding = self.binding(&name, &reach, scope)?;
            let body = self.number(form, &binding.scope)?;
            return Ok(derivative(&binding.name, &body, &place.own()));
        }
        let mut taken = scope.words("");
        taken.extend(words(place.own().text()));
        let variable = self.fresh_beside("t", &reach, taken);
        let changed = place.with(&place.name, &Code::atom(&variable))?;
        let inside = scope.with_moved(&place.declared, changed);
        let body = self.number(form, &inside)?;
        Ok(derivative(&variable, &body, &place.own()))
    }

    /// The place that a formula names: a symbol, or a member of a family of numbers.
    ///
    /// # Errors
    /// [`Untranslatable`] for vectors and their coordinates, and for members that are vectors.
    pub fn place(&self, symbol: &Expr, scope: &Scope) -> Result<Place, Untranslatable> {
        let no_symbol = || Untranslatable::Construct("`coefficients` of what is no symbol");
        let bound = scope.bound();
        let (name, indices): (&str, &[Expr]) = match &symbol.node {
            Node::Name(name) => match self.names.definition(name, &bound) {
                Some(definition) => {
                    return self.place(&definition.body.expr, &scope.outside());
                }
                None => (name, &[]),
            },
            Node::Index(head, indices) => match &head.node {
                Node::Name(name) => (name, indices),
                _ => return Err(no_symbol()),
            },
            _ => return Err(no_symbol()),
        };
        match self.names.declarations.symbol(name) {
            Some(SymbolKind::Family {
                dimension: None | Some(1),
                ..
            }) if !indices.is_empty() => {}
            Some(SymbolKind::Family { .. }) => {
                return Err(Untranslatable::Construct(
                    "`coefficients` of members that are vectors",
                ));
            }
            Some(SymbolKind::Real(_) | SymbolKind::Integer { .. } | SymbolKind::Vector(None))
                if indices.is_empty() => {}
            _ => return Err(no_symbol()),
        }
        let codes = indices.iter().map(|index| self.index(index, scope));
        Ok(Place {
            declared: name.into(),
            name: self.standing(name, scope)?.text().to_owned(),
            indices: codes.collect::<Result<_, _>>()?,
        })
    }

    /// Forms have to have values whatever their symbols are.
    ///
    /// # Errors
    /// [`Untranslatable::Construct`] where they divide by what they are forms in.
    pub fn coefficients_defined(
        &mut self,
        forms: &Expr,
        symbols: &Expr,
        scope: &Scope,
    ) -> Result<(), Untranslatable> {
        let found = self.gathered(forms, scope)?;
        let (symbols, outside) = self.items(symbols, scope).ok_or(NO_LIST)?;
        for symbol in &symbols {
            let name = self.place(symbol, &outside)?.name;
            let mut words = found.iter().flat_map(|premise| words(premise.text()));
            if words.any(|word| word == name) {
                return Err(Untranslatable::Construct(
                    "forms that divide by what they are forms in",
                ));
            }
        }
        Ok(())
    }
}

/// `Derive_n (fun t => form) 1 at`
pub(super) fn derivative(variable: &str, form: &Code, at: &Code) -> Code {
    let function = Code::new(format!("fun {variable} => {}", form.text()), Level::Open);
    Code::apply("Derive_n", &[function, Code::atom("1"), at.clone()])
}
