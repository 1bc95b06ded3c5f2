//! Existential symbols: the field `exists` of a claim.
//!
//! `exists = ['r', 's == a/b']` says: for all values of the other symbols there are r and s in their declared
//! intervals for which the statement is true. The formula after `==`, in the other symbols, is a witness.

use super::declarations::{Declarations, SymbolKind};
use super::error::{DerivationError, LoadError};
use super::source::{Origin, Source, whole};
use super::table::Errors;
use super::written::{Written, written};
use crate::formula::{Node, Relation};
use std::sync::Arc;
use toml::Spanned;

/// A number that a claim says to exist.
#[derive(Debug, Clone)]
pub struct Existential {
    /// The symbol.
    pub name: String,
    /// The witness, if the claim gives one.
    pub witness: Option<Written>,
    /// The place of the entry.
    pub origin: Origin,
}

/// Reads the entries of `exists`; invalid ones are reported and left out.
pub(super) fn existentials(
    source: &Arc<Source>,
    declarations: &Declarations,
    entries: &[Spanned<String>],
    errors: &mut Errors,
) -> Vec<Existential> {
    let mut found: Vec<Existential> = vec![];
    for text in entries {
        let Some(formula) = errors.keep(written(source, text)) else {
            continue;
        };
        let origin = formula.origin.clone();
        let wrong = |message: String| {
            let help = "write `exists = ['r', 's == a/b']`: declared real numbers, each once, and perhaps what they are";
            let error = DerivationError::at(&origin, whole(text), message).with_help(help);
            LoadError::Derivation(Box::new(error))
        };
        let parts = match formula.expr.node {
            Node::Name(name) => Some((name, None)),
            Node::Compare(first, rest) => match (&first.node, rest.as_slice()) {
                (Node::Name(name), [(Relation::Equal, value)]) => {
                    Some((name.clone(), Some(value.clone())))
                }
                _ => None,
            },
            _ => None,
        };
        let Some((name, value)) = parts else {
            let message = format!("`{}` does not name a number that exists", text.get_ref());
            errors.0.push(wrong(message));
            continue;
        };
        let real = matches!(declarations.symbol(&name), Some(SymbolKind::Real(_)));
        if !real || found.iter().any(|other| other.name == name) {
            let message = if real {
                format!("`{name}` is named twice")
            } else {
                format!("`{name}` is not declared as a real number")
            };
            errors.0.push(wrong(message));
            continue;
        }
        let witness = value.map(|expr| Written {
            expr,
            origin: origin.clone(),
        });
        found.push(Existential {
            name,
            witness,
            origin: origin.clone(),
        });
    }
    found
}
