//! `coefficients`: the derivatives of forms by symbols.
//!
//! A form in which no unknown of `given` equations occurs is differentiated as it stands, at the symbol's own value:
//! `Derive_n (fun p0 => form) 1 p0`. The symbol is hidden by the variable of its name. Where unknowns occur they are functions of the symbol, see [`crate::along`].

use crate::code::{Code, Level};
use crate::context::{Context, Used, Value};
use crate::defined::{Premises, mentions};
use crate::degree::is_linear;
use crate::gap::Gap;
use crate::shape::Shape;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_language::core::{Node, Set, Term};

const NO_LIST: Gap = Gap::Construct("`coefficients` of what is no list");

impl Context<'_> {
    /// Entry (r, c) is the derivative of form r by symbol c.
    pub(crate) fn coefficients(&mut self, forms: &Term, symbols: &Term) -> Result<Value, Gap> {
        let forms = items(forms).ok_or(NO_LIST)?;
        let symbols = items(symbols).ok_or(NO_LIST)?;
        let mut rows = vec![];
        for form in forms {
            let mut row = vec![];
            for symbol in symbols {
                row.push(self.coefficient(form, symbol)?);
            }
            rows.push(Code::list(&row));
        }
        Ok(Value {
            code: Code::list(&rows),
            shape: Shape::Matrix(forms.len(), symbols.len()),
        })
    }

    fn coefficient(&mut self, form: &Term, symbol: &Term) -> Result<Code, Gap> {
        let (Node::Symbol(declared) | Node::Vector(declared, None)) = &*symbol.node else {
            return Err(Gap::Construct("`coefficients` of members of families"));
        };
        if matches!(self.symbols.get(declared), Some(Set::Integer { .. })) {
            return Err(Gap::Construct("`coefficients` of integers"));
        }
        if self.has_unknowns(symbol) {
            return Err(Gap::Construct("coefficients of unknowns of equations"));
        }
        let mut before = None;
        if self.has_unknowns(form) {
            // The functions of a statement are not arguments of its definitions.
            if self.is_in_definition() || !Used::of(form).variables.is_empty() {
                return Err(Gap::Theory(
                    "coefficients along given equations, in a definition or below a binder",
                ));
            }
            let unknowns = self.unknowns().to_vec();
            let along = self.along(declared, &unknowns)?;
            before = Some(self.moved(along.values()));
        } else if !is_linear(form, declared) {
            self.unclear_forms(true);
        }
        let name = self.symbol(declared)?.to_owned();
        let body = self.number(form);
        if let Some(before) = before {
            self.moved(before);
        }
        let function = Code::new(format!("fun {name} => {}", body?.text()), Level::Open);
        let arguments = [function, Code::atom("1"), Code::atom(name)];
        Ok(Code::apply("Derive_n", &arguments))
    }

    /// The premises of forms, which have to be defined whatever their symbols are.
    pub(crate) fn coefficients_defined(
        &mut self,
        arguments: &[Term],
        premises: &mut Premises,
    ) -> Result<(), Gap> {
        let [forms, symbols] = arguments else {
            return Err(NO_LIST);
        };
        let found = self.gathered(forms, premises)?;
        let mut names = BTreeSet::new();
        symbols.declared_names(&mut |name| {
            names.insert(Arc::clone(name));
        });
        for name in names {
            let name = self.symbol(&name)?;
            if found.iter().any(|premise| mentions(premise.text(), name)) {
                return Err(Gap::Construct(
                    "forms that divide by what they are forms in",
                ));
            }
        }
        Ok(())
    }
}

/// The terms of a list, through definitions.
fn items(list: &Term) -> Option<&[Term]> {
    match &*list.node {
        Node::List(items) => Some(items),
        Node::Opened { body, .. } => items(body),
        _ => None,
    }
}
