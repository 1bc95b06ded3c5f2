//! What may change the meaning of any name of a file: then none of them is sure.

use super::bindings::{bindings, imported};
use super::meaning::MODULES;
use crate::grammar::{CodeNode, Text, children, is_plain, within};
use std::collections::{BTreeMap, BTreeSet};

/// Functions and names by which a program reaches the names of a module.
const DYNAMIC: [&str; 11] = [
    "globals",
    "locals",
    "vars",
    "exec",
    "eval",
    "setattr",
    "delattr",
    "compile",
    "__import__",
    "__builtins__",
    "__loader__",
];

/// Modules that are doors to the names of others.
const DOORS: [&str; 6] = [
    "builtins",
    "__main__",
    "importlib",
    "ctypes",
    "gc",
    "inspect",
];

/// Attributes that are such doors; so are all that have two signs `_` on both sides but these.
const REACHING: [&str; 4] = ["modules", "_getframe", "f_globals", "f_locals"];
const HARMLESS: [&str; 14] = [
    "__all__",
    "__call__",
    "__class__",
    "__eq__",
    "__getitem__",
    "__hash__",
    "__new__",
    "__repr__",
    "__init__",
    "__name__",
    "__doc__",
    "__version__",
    "__file__",
    "__post_init__",
];

/// The variables of a function or a class, and the scope around it.
struct Scope {
    names: BTreeSet<String>,
    outer: Option<usize>,
}

/// The first place, given the names outside of functions and where they are first bound, at which a file reaches names in other ways than by binding them.
pub(super) fn unsure<'t>(
    text: Text<'_>,
    root: CodeNode<'t>,
    outside: &BTreeMap<String, usize>,
) -> Option<CodeNode<'t>> {
    let mut imports = BTreeSet::new();
    let mut scopes: Vec<Scope> = vec![];
    let mut pending: Vec<(CodeNode<'t>, Option<usize>)> = vec![(root, None)];
    let mut found: Vec<CodeNode<'t>> = vec![];
    let mut uses: Vec<(CodeNode<'t>, Option<usize>)> = vec![];
    let mut changes: Vec<(CodeNode<'t>, Option<usize>)> = vec![];
    while let Some((node, scope)) = pending.pop() {
        let field = |name: &str| node.child_by_field_name(name);
        match node.kind() {
            "import_statement" | "import_from_statement" => {
                for import in imported(text, node) {
                    let member = import.member.as_deref().unwrap_or("");
                    let first = import.module.split('.').next().unwrap_or("");
                    let path = format!("{}.{member}", import.module);
                    let is_read = match &import.member {
                        None => MODULES.iter().any(|m| m.split('.').next() == Some(first)),
                        Some(_) => MODULES.contains(&path.as_str()),
                    };
                    if DOORS.contains(&first) || REACHING.contains(&member) {
                        found.push(node);
                    }
                    imports.insert((import.name, is_read));
                }
                continue;
            }
            "function_definition" | "lambda" => {
                let mut names = BTreeSet::new();
                for parameter in field("parameters").map(children).unwrap_or_default() {
                    names.extend(parameter_name(text, parameter));
                    // What is evaluated outside.
                    let outer = ["value", "type"];
                    let outer = outer.map(|part| parameter.child_by_field_name(part));
                    pending.extend(outer.into_iter().flatten().map(|part| (part, scope)));
                }
                let body = field("body");
                let body: Vec<CodeNode<'t>> = body.into_iter().collect();
                names.extend(bindings(text, &body).into_iter().map(|(name, _)| name));
                scopes.push(Scope {
                    names,
                    outer: scope,
                });
                let inner = Some(scopes.len() - 1);
                pending.extend(body.into_iter().map(|part| (part, inner)));
                continue;
            }
            "class_definition" => {
                pending.extend(field("superclasses").map(|part| (part, scope)));
                // Names of a class are none of its methods.
                pending.extend(field("body").map(|part| (part, scope)));
                continue;
            }
            "keyword_argument" => {
                pending.extend(field("value").map(|part| (part, scope)));
                continue;
            }
            "attribute" => {
                let name = field("attribute").map_or("", |name| text.text(name));
                let is_inner = name.starts_with("__") && name.ends_with("__");
                if REACHING.contains(&name) || (is_inner && !HARMLESS.contains(&name)) {
                    found.push(node);
                }
                let object = field("object");
                // A module before a point is read; the module alone may be changed elsewhere.
                let object = object.filter(|object| object.kind() != "identifier");
                if let Some(name) = field("object").filter(|own| own.kind() == "identifier")
                    && DYNAMIC.contains(&text.text(name))
                {
                    uses.push((name, scope));
                }
                pending.extend(object.map(|part| (part, scope)));
                continue;
            }
            "identifier" => uses.push((node, scope)),
            _ => {}
        }
        let target = match node.kind() {
            "assignment" | "augmented_assignment" | "for_statement" | "for_in_clause" => {
                field("left")
            }
            "delete_statement" | "as_pattern_target" => Some(node),
            _ => None,
        };
        if let Some(target) = target {
            changes.push((target, scope));
        }
        pending.extend(children(node).into_iter().map(|part| (part, scope)));
    }
    let is_local = |name: &str, mut scope: Option<usize>| {
        while let Some(own) = scope.and_then(|scope| scopes.get(scope)) {
            if own.names.contains(name) {
                return true;
            }
            scope = own.outer;
        }
        false
    };
    let is_imported = |name: &str| imports.iter().any(|(own, _)| own == name);
    let is_module = |name: &str| imports.iter().any(|(own, is_read)| own == name && *is_read);
    for (node, scope) in uses {
        let name = text.text(node);
        let is_own = is_local(name, scope);
        // A name of the file is one of the language before the file binds it.
        let is_bound = outside
            .get(name)
            .is_some_and(|first| scope.is_some() || *first <= node.start_byte());
        let is_dynamic = DYNAMIC.contains(&name) && !is_bound;
        let is_passed = is_module(name) && !is_target(node);
        if !is_own && (is_dynamic || is_passed) {
            found.push(node);
        }
    }
    for (target, scope) in changes {
        for root in changed(target) {
            let name = text.text(root);
            if is_imported(name) && !is_local(name, scope) {
                found.push(root);
            }
        }
    }
    found.extend(odd_names(text, root, outside));
    found.into_iter().min_by_key(CodeNode::start_byte)
}

/// Whether an identifier is given a value here.
fn is_target(node: CodeNode<'_>) -> bool {
    let mut here = node;
    while let Some(parent) = here.parent() {
        match parent.kind() {
            "pattern_list" | "tuple_pattern" | "list_pattern" => here = parent,
            "assignment" | "augmented_assignment" | "for_statement" | "for_in_clause" => {
                return parent.child_by_field_name("left") == Some(here);
            }
            "as_pattern_target" | "delete_statement" | "global_statement" => return true,
            "except_clause" => return parent.child_by_field_name("alias") == Some(here),
            _ => return false,
        }
    }
    false
}

/// The names at whose attributes a target assigns something.
fn changed(target: CodeNode<'_>) -> Vec<CodeNode<'_>> {
    let mut found = vec![];
    let mut pending = vec![target];
    while let Some(node) = pending.pop() {
        if node.kind() != "attribute" {
            // An entry of an attribute is no attribute: `rcParams['size'] = 3`.
            if node.kind() != "subscript" {
                pending.extend(children(node));
            }
            continue;
        }
        let mut here = Some(node);
        while let Some(node) = here {
            if node.kind() == "identifier" {
                found.push(node);
            }
            let parts = ["object", "value", "function"];
            let mut parts = parts.into_iter().map(|part| node.child_by_field_name(part));
            here = parts.find_map(|part| part);
        }
    }
    found
}

/// The name of a parameter.
fn parameter_name(text: Text<'_>, parameter: CodeNode<'_>) -> Option<String> {
    let mut pending = vec![parameter];
    while let Some(node) = pending.pop() {
        if node.kind() == "identifier" {
            return Some(text.text(node).to_owned());
        }
        match node.child_by_field_name("name") {
            Some(name) => pending.push(name),
            None => pending.extend(children(node).first()),
        }
    }
    None
}

/// A name outside of functions of which the interpreter may make another one.
fn odd_names<'t>(
    text: Text<'_>,
    root: CodeNode<'t>,
    outside: &BTreeMap<String, usize>,
) -> Option<CodeNode<'t>> {
    if outside.keys().all(|name| is_plain(name)) {
        return None;
    }
    let is_odd = |node: &CodeNode<'t>| node.kind() == "identifier" && !is_plain(text.text(*node));
    within(root).filter(is_odd).last().or(Some(root))
}
