//! What gives names a meaning in a scope: of a file, or of a function.
//!
//! One walk serves both. It goes into everything that the scope evaluates, defaults and decorators of functions among it, and stays out of
//! the bodies of functions, lambdas and classes, which have scopes of their own. The variable of a comprehension is one of
//! the comprehension; what `:=` binds in it is one of the scope.

use crate::grammar::{CodeNode, Text, children, within};

/// A name with the node that gives it a meaning.
pub(super) type Binding<'t> = (String, CodeNode<'t>);

/// What the nodes of a scope bind, once for each time.
pub(super) fn bindings<'t>(text: Text<'_>, scope: &[CodeNode<'t>]) -> Vec<Binding<'t>> {
    let mut found = vec![];
    let mut pending: Vec<CodeNode<'t>> = scope.to_vec();
    while let Some(node) = pending.pop() {
        let field = |name: &str| node.child_by_field_name(name);
        match node.kind() {
            "function_definition" => {
                bind(text, field("name"), node, &mut found);
                pending.extend(field("parameters"));
                pending.extend(field("return_type"));
                continue;
            }
            "class_definition" => {
                bind(text, field("name"), node, &mut found);
                pending.extend(field("superclasses"));
                continue;
            }
            "lambda" => {
                pending.extend(field("parameters"));
                continue;
            }
            // A name with a type alone has no value.
            "assignment" if field("right").is_none() => continue,
            "assignment" | "augmented_assignment" | "for_statement" => {
                bind(text, field("left"), node, &mut found);
            }
            "named_expression" => bind(text, field("name"), node, &mut found),
            "except_clause" => bind(text, field("alias"), node, &mut found),
            "as_pattern_target" | "delete_statement" | "case_pattern" | "ERROR" => {
                all(text, node, node, &mut found);
            }
            "type_alias_statement" => {
                let left = field("left").unwrap_or(node);
                all(text, left, node, &mut found);
            }
            "import_statement" | "import_from_statement" => {
                let names = imported(text, node).into_iter();
                found.extend(names.map(|import| (import.name, node)));
                continue;
            }
            _ => {}
        }
        pending.extend(children(node));
    }
    found
}

/// The names that a pattern binds. Entries and attributes bind none: `a[i], b.c = 1, 2`.
fn bind<'t>(
    text: Text<'_>,
    pattern: Option<CodeNode<'t>>,
    binder: CodeNode<'t>,
    into: &mut Vec<Binding<'t>>,
) {
    let mut pending: Vec<CodeNode<'t>> = pattern.into_iter().collect();
    while let Some(node) = pending.pop() {
        match node.kind() {
            "identifier" => into.push((text.text(node).to_owned(), binder)),
            "attribute" | "subscript" => {}
            _ => pending.extend(children(node)),
        }
    }
}

/// All names at a node and within it.
fn all<'t>(text: Text<'_>, node: CodeNode<'t>, binder: CodeNode<'t>, into: &mut Vec<Binding<'t>>) {
    let names = within(node).filter(|node| node.kind() == "identifier");
    into.extend(names.map(|name| (text.text(name).to_owned(), binder)));
}

/// The names that the functions of a file declare as global.
pub(super) fn declared_global<'t>(text: Text<'_>, root: CodeNode<'t>) -> Vec<Binding<'t>> {
    let mut found = vec![];
    for node in within(root).filter(|node| node.kind() == "global_statement") {
        all(text, node, node, &mut found);
    }
    found
}

/// A name that an import gives a meaning: a module, or something of one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Import {
    /// The name in the file.
    pub(super) name: String,
    pub(super) module: String,
    /// The name in the module; none for the module itself.
    pub(super) member: Option<String>,
    /// `a.b`, where that was imported and `a` alone is the name.
    pub(super) inner: Option<String>,
}

/// The names that an import gives a meaning, without those of `*`.
pub(super) fn imported(text: Text<'_>, node: CodeNode<'_>) -> Vec<Import> {
    let words = |name: &str| node.child_by_field_name(name).map(|node| text.text(node));
    let module = words("module_name");
    let skipped = usize::from(module.is_some());
    let mut found = vec![];
    for name in children(node).into_iter().skip(skipped) {
        if name.kind() == "wildcard_import" {
            continue;
        }
        let part = |field: &str| name.child_by_field_name(field).map(|node| text.text(node));
        let (own, alias) = match name.kind() {
            "aliased_import" => (part("name").unwrap_or(""), part("alias")),
            _ => (text.text(name), None),
        };
        let first = own.split('.').next().unwrap_or(own);
        found.push(match (module, alias) {
            (Some(module), alias) => Import {
                name: alias.unwrap_or(own).to_owned(),
                module: module.to_owned(),
                member: Some(own.to_owned()),
                inner: None,
            },
            (None, Some(alias)) => Import {
                name: alias.to_owned(),
                module: own.to_owned(),
                member: None,
                inner: None,
            },
            (None, None) => Import {
                name: first.to_owned(),
                module: first.to_owned(),
                member: None,
                inner: Some(own.to_owned()),
            },
        });
    }
    found
}

/// The module of which an import takes all names.
pub(super) fn imported_whole(text: Text<'_>, node: CodeNode<'_>) -> Option<String> {
    let module = node.child_by_field_name("module_name")?;
    let mut names = children(node).into_iter();
    let is_whole = names.any(|name| name.kind() == "wildcard_import");
    is_whole.then(|| text.text(module).to_owned())
}
