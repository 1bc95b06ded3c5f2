//! `coefficients`: the derivatives of forms with respect to symbols.
//!
//! A form without unknowns of `given` equations is differentiated as it stands, at the symbol's own value: `Derive_n
//! (fun p0 => form) 1 p0`, in which the variable hides the symbol of its name; for a member of a family, `Derive_n (fun
//! t => form with update1 P 2 t in place of P) 1 (P 2)`. If unknowns occur, they are functions of the symbol, see
//! [`crate::implicit_derivative`].

use crate::code::{Code, Level};
use crate::context::{Context, Used, Value};
use crate::defined::{Premises, mentions};
use crate::gap::Untranslatable;
use crate::place::Place;
use crate::shape::Shape;
use std::sync::Arc;
use torse_core::degree::is_linear;
use torse_core::{Node, Set, Term};

const NO_LIST: Untranslatable = Untranslatable::Construct("`coefficients` of what is no list");

impl Context<'_> {
    /// Entry (r, c) is the derivative of form r with respect to symbol c.
    pub(crate) fn coefficients(
        &mut self,
        forms: &Term,
        symbols: &Term,
    ) -> Result<Value, Untranslatable> {
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

    fn coefficient(&mut self, form: &Term, symbol: &Term) -> Result<Code, Untranslatable> {
        let declared = declared(symbol)?;
        if matches!(self.symbols.get(declared), Some(Set::Integer { .. })) {
            return Err(Untranslatable::Construct("`coefficients` of integers"));
        }
        if self.has_unknowns(symbol) {
            return Err(Untranslatable::Construct(
                "coefficients of unknowns of equations",
            ));
        }
        if self.has_unknowns(form) {
            return self.coefficient_along(form, symbol);
        }
        if !is_linear(form, &[Arc::clone(declared)].into()) {
            self.unclear_forms(true);
        }
        let place = self.place(symbol)?;
        if !place.is_member() {
            let body = self.number(form)?;
            return Ok(derivative(&place.name, &body, &place.own()));
        }
        let variable = self.fresh("t");
        let changed = place.with(&place.name, &Code::atom(&variable))?.argument();
        let before = self.moved(vec![(place.declared.clone(), changed)]);
        let body = self.number(form);
        self.moved(before);
        self.free(&variable);
        Ok(derivative(&variable, &body?, &place.own()))
    }

    /// Along equations: the unknowns are functions of the symbol.
    fn coefficient_along(&mut self, form: &Term, symbol: &Term) -> Result<Code, Untranslatable> {
        // The functions of a statement are not arguments of its definitions.
        if self.is_in_definition() || !Used::from_term(form).variables.is_empty() {
            return Err(Untranslatable::Theory(
                "coefficients along given equations, in a definition or below a binder",
            ));
        }
        let unknowns = self.unknowns().to_vec();
        let along = self.along(symbol, &unknowns)?;
        let before = self.moved(along.moved);
        let body = self.number(form);
        self.moved(before);
        Ok(derivative(&along.variable, &body?, &along.own))
    }

    /// Adds the premises of forms, which have to be defined for all values of their symbols.
    pub(crate) fn coefficients_defined(
        &mut self,
        arguments: &[Term],
        premises: &mut Premises,
    ) -> Result<(), Untranslatable> {
        let [forms, symbols] = arguments else {
            return Err(NO_LIST);
        };
        let found = self.gathered(forms, premises)?;
        for symbol in items(symbols).ok_or(NO_LIST)? {
            let name = self.symbol(declared(symbol)?)?;
            if found.iter().any(|premise| mentions(premise.text(), name)) {
                return Err(Untranslatable::Construct(
                    "forms that divide by what they are forms in",
                ));
            }
        }
        Ok(())
    }
}

/// `Derive_n (fun t => form) 1 at`
fn derivative(variable: &str, form: &Code, at: &Code) -> Code {
    let function = Code::new(format!("fun {variable} => {}", form.text()), Level::Open);
    Code::apply("Derive_n", &[function, Code::atom("1"), at.clone()])
}

/// Returns the terms of a list, through definitions.
fn items(list: &Term) -> Option<&[Term]> {
    match &*list.node {
        Node::List(items) => Some(items),
        Node::Opened { body, .. } => items(body),
        _ => None,
    }
}

/// Returns the declared name of a symbol or a member.
fn declared(symbol: &Term) -> Result<&Arc<str>, Untranslatable> {
    match &*symbol.node {
        Node::Symbol(name) | Node::Vector(name, None) => Ok(name),
        Node::Member(points, _) => Ok(&points.name),
        Node::Opened { body, .. } => declared(body),
        _ => Err(Untranslatable::Construct(
            "`coefficients` of what is no symbol",
        )),
    }
}

impl Context<'_> {
    /// Returns the place that a term names.
    ///
    /// # Errors
    /// [`Untranslatable`] for vectors and their coordinates, and for members that are vectors.
    pub(crate) fn place(&mut self, symbol: &Term) -> Result<Place, Untranslatable> {
        if let Node::Opened { body, .. } = &*symbol.node {
            return self.place(body);
        }
        let name = declared(symbol)?;
        let indices = match &*symbol.node {
            Node::Member(points, indices) => {
                if points.dimension.is_some_and(|dimension| dimension > 1) {
                    return Err(Untranslatable::Construct(
                        "`coefficients` of members that are vectors",
                    ));
                }
                let codes = indices.iter().map(|index| self.index(index));
                codes.collect::<Result<Vec<_>, _>>()?
            }
            _ => vec![],
        };
        Ok(Place {
            declared: Arc::clone(name),
            name: self.symbol(name)?.to_owned(),
            indices,
        })
    }
}
