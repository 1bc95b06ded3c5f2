//! Lists outside of functions: whether a list keeps the values that it was made of.

use super::bindings::bindings;
use super::expression::Reader;
use super::meaning::Meaning;
use super::names::Sure;
use crate::grammar::{CodeNode, children};
use crate::program::operation;

/// The deepest chain of functions through which a list is followed.
const MAX_CHAIN: usize = 8;
/// The nesting of a list that is not known.
const UNKNOWN: usize = 9;

/// Whether all that a file does with a name, which a statement gives a value, is to read the entries of a list.
pub(super) fn is_only_read(
    reader: Reader<'_>,
    root: CodeNode<'_>,
    statement: CodeNode<'_>,
    name: &str,
) -> bool {
    let mut right = children(statement).first().copied();
    while let Some(node) = right.filter(|node| node.kind() == "assignment") {
        right = node.child_by_field_name("right");
    }
    let depth = right.map_or(UNKNOWN, |right| nesting(reader, right));
    Search {
        reader,
        root,
        name,
        depth,
        chain: 0,
    }
    .is_read(root)
}

/// How many brackets a list has within each other.
fn nesting(reader: Reader<'_>, node: CodeNode<'_>) -> usize {
    let inner = |node: CodeNode<'_>| {
        let parts = children(node).into_iter();
        parts.map(|part| nesting(reader, part)).max().unwrap_or(0)
    };
    match node.kind() {
        "list" | "tuple" | "list_comprehension" => 1 + inner(node),
        "integer" | "float" | "for_in_clause" => 0,
        "binary_operator" | "unary_operator" | "parenthesized_expression" => inner(node),
        "call" => {
            let function = node.child_by_field_name("function");
            let is_array = function.is_some_and(|own| {
                let found = meaning(reader, own);
                matches!(found, Some(Meaning::Function(operation::VECTOR)))
            });
            match node.child_by_field_name("arguments") {
                Some(arguments) if is_array => inner(arguments),
                _ => UNKNOWN,
            }
        }
        "attribute" => match meaning(reader, node) {
            Some(Meaning::Pi | Meaning::E) => 0,
            _ => UNKNOWN,
        },
        _ => UNKNOWN,
    }
}

/// What a function means that is called.
fn meaning(reader: Reader<'_>, function: CodeNode<'_>) -> Option<Meaning> {
    let text = reader.text;
    match function.kind() {
        "identifier" => match reader.names.name(text.text(function)) {
            Ok(Sure::Known(found)) => Some(found),
            _ => None,
        },
        "attribute" => {
            let module = reader
                .names
                .module(text.text(function.child_by_field_name("object")?));
            let member = text.text(function.child_by_field_name("attribute")?);
            super::meaning::meaning(&module.ok()??, member)
        }
        _ => None,
    }
}

/// A search for what changes a list of a name, or may give it another name.
#[derive(Clone, Copy)]
struct Search<'s, 't> {
    reader: Reader<'s>,
    root: CodeNode<'t>,
    name: &'s str,
    /// The nesting of the list.
    depth: usize,
    chain: usize,
}

impl Search<'_, '_> {
    /// Whether the name is only read at a node and within it.
    fn is_read(self, node: CodeNode<'_>) -> bool {
        let text = self.reader.text;
        let mut pending = vec![node];
        while let Some(node) = pending.pop() {
            if node.kind() == "function_definition" && self.hides(node) {
                continue;
            }
            if node.kind() == "identifier" && text.text(node) == self.name && !self.is_fine(node) {
                return false;
            }
            pending.extend(children(node));
        }
        true
    }

    /// Whether a function has a variable of the name.
    fn hides(self, function: CodeNode<'_>) -> bool {
        let text = self.reader.text;
        let body: Vec<CodeNode<'_>> = function.child_by_field_name("body").into_iter().collect();
        let names = bindings(text, &body).into_iter().map(|(name, _)| name);
        let mut own: Vec<String> = names.collect();
        let parameters = function.child_by_field_name("parameters");
        let mut parameters = parameters.map(children).unwrap_or_default();
        while let Some(parameter) = parameters.pop() {
            match parameter.kind() {
                "identifier" => own.push(text.text(parameter).to_owned()),
                // A default is read outside of the function.
                "default_parameter" | "typed_default_parameter" => {
                    parameters.extend(parameter.child_by_field_name("name"));
                }
                _ => parameters.extend(children(parameter)),
            }
        }
        own.iter().any(|other| other == self.name)
    }

    /// Whether a function that is called may be a variable of a function around it.
    fn is_local(self, called: CodeNode<'_>) -> bool {
        let text = self.reader.text.text(called);
        let search = Search {
            name: text.split('.').next().unwrap_or(text),
            ..self
        };
        let mut here = called.parent();
        while let Some(node) = here {
            let is_scope = matches!(node.kind(), "function_definition" | "lambda");
            if is_scope && search.hides(node) {
                return true;
            }
            here = node.parent();
        }
        false
    }

    /// Whether an occurrence of the name reads entries.
    fn is_fine(self, name: CodeNode<'_>) -> bool {
        let text = self.reader.text;
        let mut here = name;
        let mut depth = self.depth;
        let is_field = |parent: CodeNode<'_>, field: &str, child: CodeNode<'_>| {
            let mut cursor = parent.walk();
            let mut all = parent.children_by_field_name(field, &mut cursor);
            all.any(|own| own == child)
        };
        let mut indices = 0;
        while let Some(parent) = here.parent() {
            if parent.kind() != "subscript" || !is_field(parent, "value", here) {
                break;
            }
            let mut cursor = parent.walk();
            let all = parent.children_by_field_name("subscript", &mut cursor);
            // A part of a list between two ends is as deep as the list.
            depth = depth.saturating_sub(all.filter(|index| index.kind() != "slice").count());
            indices += 1;
            here = parent;
        }
        let Some(parent) = here.parent() else {
            return false;
        };
        let is_target = match parent.kind() {
            "assignment" | "augmented_assignment" => is_field(parent, "left", here),
            "for_statement" | "for_in_clause" => is_field(parent, "left", here),
            "pattern_list" | "tuple_pattern" | "list_pattern" | "delete_statement" => true,
            _ => false,
        };
        if is_target {
            // The name itself is given its value once, which is counted elsewhere.
            return indices == 0 && parent.kind() == "assignment";
        }
        match (parent.kind(), depth) {
            ("attribute", _) => false,
            (_, 0) => true,
            ("for_statement" | "for_in_clause", 1) => is_field(parent, "right", here),
            ("binary_operator" | "comparison_operator", 1) => true,
            ("argument_list", _) => {
                let Some(call) = parent.parent().filter(|call| call.kind() == "call") else {
                    return false;
                };
                let Some(function) = call.child_by_field_name("function") else {
                    return false;
                };
                if self.is_local(function) {
                    return false;
                }
                // What has more arguments than are read may write into them.
                let count = children(parent).len();
                match meaning(self.reader, function) {
                    Some(Meaning::Function(operation::LENGTH | operation::VECTOR)) => count == 1,
                    Some(Meaning::Function(operation::AS_VECTOR)) => false,
                    Some(Meaning::Function("dot" | "cross" | operation::ZIP)) => {
                        depth == 1 && count == 2
                    }
                    Some(Meaning::Function(_)) => depth == 1 && count == 1,
                    Some(_) => false,
                    None => {
                        let called = text.text(function);
                        let position = children(parent).iter().position(|own| *own == here);
                        let is_own = function.kind() == "identifier"
                            && self.reader.functions.contains(called);
                        is_own && position.is_some_and(|n| self.is_read_by(called, n, depth))
                    }
                }
            }
            _ => false,
        }
    }

    /// Whether the functions of a name only read an argument.
    fn is_read_by(self, function: &str, position: usize, depth: usize) -> bool {
        let text = self.reader.text;
        let statements = children(self.root);
        let definitions = statements
            .iter()
            .filter_map(|node| super::definition(*node));
        let mut own = definitions.filter(|node| {
            let name = node.child_by_field_name("name");
            name.is_some_and(|name| text.text(name) == function)
        });
        self.chain < MAX_CHAIN
            && own.all(|node| {
                let parameters = node.child_by_field_name("parameters").map(children);
                let parameter = parameters.and_then(|all| all.get(position).copied());
                let parameter = parameter.map(|parameter| match parameter.kind() {
                    "identifier" => parameter,
                    _ => children(parameter).first().copied().unwrap_or(parameter),
                });
                let body = node.child_by_field_name("body");
                parameter.zip(body).is_some_and(|(parameter, body)| {
                    let search = Search {
                        name: text.text(parameter),
                        chain: self.chain + 1,
                        depth,
                        ..self
                    };
                    parameter.kind() == "identifier" && search.is_read(body)
                })
            })
    }
}
