//! Definitions of a derivation file.

use super::declarations::{Declarations, Definition, taken};
use super::error::{DerivationError, LoadError};
use super::source::{Origin, Source};
use super::table::Errors;
use super::written::written;
use crate::formula::functions::is_function_of_values;
use crate::formula::{Expr, Node, Place, is_name, parse};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;
use toml::Spanned;

/// Parses definitions. The key is a name, a head `F(z, mu)`, or a member `Q[i]` of a family. Invalid ones are
/// reported and marked.
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
            None => declarations.mark_invalid([name_of(head)]),
        }
    }
}

/// The name that a head such as `F(z, mu)` defines; works for malformed heads too.
pub(super) fn name_of(head: &str) -> String {
    let name = head.split(['(', '[']).next().unwrap_or(head);
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
        Node::Call(function, arguments) | Node::Index(function, arguments) => {
            let parameters: Option<Vec<String>> = arguments.iter().map(name).collect();
            let indexed = matches!(head.node, Node::Index(..));
            Some((name(function)?, parameters?, indexed))
        }
        _ => Some((name(&head)?, vec![], false)),
    });
    let Some((name, parameters, indexed)) = parts else {
        let message = format!("`{head}` is neither a name nor a head such as `F(z, mu)` or `Q[i]`");
        return Err(wrong(&body.origin, message));
    };
    if is_function_of_values(&name) {
        return Err(wrong(&body.origin, taken(&name)));
    }
    let distinct: BTreeSet<&String> = parameters.iter().collect();
    if distinct.len() != parameters.len() {
        let message = format!("`{head}` has two parameters of the same name");
        return Err(wrong(&body.origin, message));
    }
    let definition = Definition {
        parameters,
        indexed,
        body,
    };
    Ok((name, definition))
}

fn wrong(origin: &Origin, message: String) -> LoadError {
    let place = Place { start: 0, end: 1 };
    LoadError::Derivation(Box::new(DerivationError::at(origin, place, message)))
}
