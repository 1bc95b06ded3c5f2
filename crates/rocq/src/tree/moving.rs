//! The unknowns that move with a symbol whose coefficient is asked for.

use super::scope::Scope;
use crate::code::Code;
use crate::place::Place;
use std::sync::Arc;

/// The unknowns as functions of one symbol.
#[derive(Debug, Clone)]
pub(super) struct Along {
    /// The symbol.
    pub place: Place,
    /// The variable that it is where it moves.
    pub variable: String,
    /// The functions: their names, and the unknowns.
    pub functions: Vec<(String, Place)>,
    /// What stands for declared names where the symbol moves.
    pub moved: Vec<(Arc<str>, Code)>,
}

impl Along {
    /// A scope in which the symbol moves.
    pub fn scope(&self, scope: &Scope) -> Scope {
        let moved = self.moved.iter();
        moved.fold(scope.clone(), |scope, (name, code)| {
            scope.with_moved(name, code.clone())
        })
    }
}
