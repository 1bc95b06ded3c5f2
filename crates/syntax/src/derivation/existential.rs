//! What a claim says there is: the field `exists`.
//!
//! `exists = ['r', 's == a/b']` says of the numbers r and s that for all values of the other symbols there are some in their
//! declared intervals for which the statement is true. Behind `==` stands a witness, a formula in the other symbols.

use super::declarations::{Declarations, SymbolKind};
use super::error::{DerivationError, LoadError};
use super::source::{Origin, Source, whole};
use super::table::Errors;
use super::written::{Written, written};
use crate::formula::{Node, Relation};
use std::sync::Arc;
use toml::Spanned;

/// A number of which a claim says that there is one.
#[derive(Debug, Clone)]
pub struct Existential {
    /// The symbol that stands for it.
    pub name: String,
    /// What it is, if the claim says it.
    pub witness: Option<Written>,
    /// Where it is named.
    pub origin: Origin,
}

/// The entries of `exists` that are well formed.
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
            let message = format!("`{}` names no number that there is", text.get_ref());
            errors.0.push(wrong(message));
            continue;
        };
        let real = matches!(declarations.symbol(&name), Some(SymbolKind::Real(_)));
        if !real || found.iter().any(|other| other.name == name) {
            let message = match real {
                true => format!("`{name}` is named twice"),
                false => format!("`{name}` is not declared as a real number"),
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
