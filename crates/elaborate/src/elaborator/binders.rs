//! What names mean below binders, and the names that binders take.

use super::{Elaborator, Outcome, wrong};
use std::collections::BTreeMap;
use std::sync::Arc;
use torse_core::{Node, Term, Variable};
use torse_syntax::derivation::declarations::SymbolKind;
use torse_syntax::formula::{self, Expr};

/// What may be done with the variable of a binder.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Local {
    /// The parameter of a function, or what stands for a symbol: it takes every value near one.
    Continuous,
    /// The index of a sum: an integer.
    Index,
}

/// What names mean at one place, before the declarations are asked.
#[derive(Debug, Clone, Default)]
pub(super) struct Scope {
    pub(super) locals: BTreeMap<String, (Variable, Local)>,
    pub(super) globals: BTreeMap<String, Variable>,
}

impl Scope {
    pub(super) fn with_local(&self, name: &str, variable: &Variable, local: Local) -> Self {
        let mut more = self.clone();
        more.locals
            .insert(name.to_owned(), (variable.clone(), local));
        more
    }

    pub(super) fn with_global(&self, name: &str, variable: &Variable) -> Self {
        let mut more = self.clone();
        more.globals.insert(name.to_owned(), variable.clone());
        more
    }

    /// What a definition sees.
    pub(super) fn outside(&self) -> Self {
        Self {
            locals: BTreeMap::new(),
            globals: self.globals.clone(),
        }
    }
}

/// A name that `D` or `at` binds.
pub(super) struct Bound {
    /// What stands for it inside.
    pub(super) variable: Variable,
    /// What it is outside.
    pub(super) outside: Term,
    /// The scope inside.
    pub(super) scope: Scope,
}

/// What binds a name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Use {
    Derivative,
    At,
}

impl Elaborator<'_> {
    /// The variable that `D` or `at` binds, from the name in the text.
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
