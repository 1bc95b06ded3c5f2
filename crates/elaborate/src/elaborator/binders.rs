//! Scopes: the meaning of names below binders.

use super::{Elaborator, Outcome, wrong};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_core::{Node, Term, Variable};
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{self, Expr};

/// The kind of a bound variable, which decides what may be done with it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Local {
    /// The parameter of a function, or a variable that replaces a symbol: it takes all values in a neighbourhood.
    Continuous,
    /// The index of a sum: an integer.
    Index,
}

/// The meaning of names at one place; takes precedence over the declarations.
#[derive(Debug, Clone, Default)]
pub(super) struct Scope {
    pub(super) locals: BTreeMap<String, (Variable, Local)>,
    pub(super) globals: BTreeMap<String, Variable>,
}

impl Scope {
    pub(super) fn with_local(&self, name: &str, variable: &Variable, local: Local) -> Self {
        let mut extended = self.clone();
        extended
            .locals
            .insert(name.to_owned(), (variable.clone(), local));
        extended
    }

    pub(super) fn with_global(&self, name: &str, variable: &Variable) -> Self {
        let mut extended = self.clone();
        extended.globals.insert(name.to_owned(), variable.clone());
        extended
    }

    /// The scope of the body of a definition: replaced symbols, but no local variables.
    pub(super) fn outside(&self) -> Self {
        Self {
            locals: BTreeMap::new(),
            globals: self.globals.clone(),
        }
    }
}

/// A name that `D` or `at` binds.
pub(super) struct Bound {
    /// The variable inside.
    pub(super) variable: Variable,
    /// The term that the name stands for outside.
    pub(super) outside: Term,
    /// The scope of the body.
    pub(super) scope: Scope,
}

/// The kind of binder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Use {
    Derivative,
    At,
}

impl Elaborator<'_> {
    /// Makes the variable that `D` or `at` binds, given the name in the text.
    pub(super) fn bound(&self, variable: &Expr, scope: &Scope, usage: Use) -> Outcome<Bound> {
        let place = variable.place;
        let formula::Node::Name(name) = &variable.node else {
            return Err(wrong(place, "a formula", "the name of a variable"));
        };
        let inner = self.fresh(name);
        if let Some((outer, local)) = scope.locals.get(name) {
            if *local == Local::Index && usage == Use::Derivative {
                return Err(wrong(
                    place,
                    "the index of a sum",
                    "a variable that takes every value near one",
                ));
            }
            return Ok(Bound {
                scope: scope.with_local(name, &inner, *local),
                outside: self.made(Node::Variable(outer.clone()), place),
                variable: inner,
            });
        }
        if self.declarations.definition(name).is_some() {
            return Err(wrong(
                place,
                "a definition",
                "the name of a declared symbol",
            ));
        }
        match (self.declarations.symbol(name), usage) {
            (Some(SymbolKind::Real(_)), _) | (Some(SymbolKind::Integer { .. }), Use::At) => {}
            (Some(SymbolKind::Integer { .. }), Use::Derivative) => {
                return Err(wrong(
                    place,
                    "an integer",
                    "a variable that takes every value near one",
                ));
            }
            (Some(_), _) => return Err(wrong(place, "a vector or family", "a number")),
            (None, _) => return Err(self.unknown(name, place, scope)),
        }
        let outside = match scope.globals.get(name) {
            Some(outer) => Node::Variable(outer.clone()),
            None => Node::Symbol(Arc::from(name.as_str())),
        };
        let outside = self.made(outside, place);
        Ok(Bound {
            scope: scope.with_global(name, &inner),
            outside,
            variable: inner,
        })
    }
}
