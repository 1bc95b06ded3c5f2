//! Definitions of a file: heads and bodies.

use super::declarations::{Declarations, Definition};
use super::error::{DerivationError, LoadError};
use super::source::{Origin, Source};
use super::table::Errors;
use super::written::written;
use crate::syntax::{Expr, Node, Place, is_name, parse};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use toml::Spanned;

/// Parses definitions: the key is a name or a head `F(z, mu)`. Those that are wrong are marked as such.
pub(super) fn add_definitions(
    declarations: &mut Declarations,
    source: &Arc<Source>,
    table: &BTreeMap<String, Spanned<String>>,
    errors: &mut Errors,
) {
    for (head, text) in table {
        let definition = definition(source, head, text);
        match errors.keep(definition) {
            Some((name, definition)) => declarations.define(name, definition),
            None => declarations.spoil([name_of(head)]),
        }
    }
}

/// What a head `F(z, mu)` defines, even if it is wrong.
pub(super) fn name_of(head: &str) -> String {
    let name = head.split_once('(').map_or(head, |(name, _)| name);
    name.trim().to_owned()
}

fn definition(
    source: &Arc<Source>,
    head: &str,
    text: &Spanned<String>,
) -> Result<(String, Definition), LoadError> {
    let body = written(source, text)?;
    let name = |expr: &Expr| match &expr.node {
        Node::Name(name) if is_name(name) => Some(name.clone()),
        _ => None,
    };
    let parts = parse(head).ok().and_then(|head| match &head.node {
        Node::Call(function, arguments) => {
            let parameters: Option<Vec<String>> = arguments.iter().map(name).collect();
            Some((name(function)?, parameters?))
        }
        _ => Some((name(&head)?, vec![])),
    });
    let Some((name, parameters)) = parts else {
        let message = format!("`{head}` is no name and no head such as `F(z, mu)`");
        return Err(wrong(&body.origin, message));
    };
    let distinct: BTreeSet<&String> = parameters.iter().collect();
    if distinct.len() != parameters.len() {
        let message = format!("`{head}` has two parameters of the same name");
        return Err(wrong(&body.origin, message));
    }
    Ok((name, Definition { parameters, body }))
}

fn wrong(origin: &Origin, message: String) -> LoadError {
    let place = Place { start: 0, end: 1 };
    LoadError::Derivation(Box::new(DerivationError::at(origin, place, message)))
}
