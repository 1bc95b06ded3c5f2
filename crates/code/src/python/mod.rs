//! Reads Python: functions of a module, the names that it imports and assigns.

mod expression;
mod names;
mod statement;

use crate::grammar::{CodeNode, Read, Text, children, place, tree};
use crate::program::{CodeLanguage, Function, Parameter, Program};
use expression::Reader;
use names::Imports;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_syntax::derivation::Source;

/// Decorators that leave the values of a function as they are.
const DECORATORS: [&str; 6] = [
    "lru_cache",
    "cache",
    "njit",
    "jit",
    "vectorize",
    "staticmethod",
];

/// Reads a file. What cannot be read of it is no error until it is asked for.
pub(crate) fn program(source: &Arc<Source>) -> Read<Program> {
    let tree = tree(source, CodeLanguage::Python)?;
    let text = Text { source };
    let statements = children(tree.root_node());
    let mut imports = Imports::default();
    let mut functions = BTreeSet::new();
    for node in &statements {
        match node.kind() {
            "import_statement" | "import_from_statement" => imports.add(text, *node)?,
            _ => {}
        }
        if let Some(function) = definition(*node) {
            functions.insert(text.text(text.field(function, "name")?).to_owned());
        }
    }
    let mut outside = vec![];
    let others = statements
        .iter()
        .filter(|node| definition(**node).is_none());
    others.for_each(|node| assigned(text, *node, &mut outside));
    let mut own = functions.clone();
    own.extend(outside.iter().cloned());
    let reader = Reader {
        text,
        imports: &imports,
        functions: &functions,
        own: &own,
    };
    let mut program = Program {
        source: Arc::clone(source),
        language: CodeLanguage::Python,
        functions: vec![],
        constants: vec![],
    };
    for node in statements {
        if definition(node).is_some() {
            program.functions.push(function(reader, node)?);
        } else if node.kind() == "expression_statement" && text.check(node).is_ok() {
            // What is not read here is missing where it is used.
            let steps = reader.step(node).unwrap_or_default();
            program.constants.extend(statement::constants(&steps));
        }
    }
    // What is assigned more than once, or by a function, has no one value.
    let changed = globals(text, tree.root_node());
    program.constants.retain(|(name, _)| {
        let times = outside.iter().filter(|other| *other == name).count();
        times == 1 && !changed.contains(name)
    });
    Ok(program)
}

/// The function that a statement defines.
fn definition(node: CodeNode<'_>) -> Option<CodeNode<'_>> {
    match node.kind() {
        "function_definition" => Some(node),
        "decorated_definition" => node
            .child_by_field_name("definition")
            .filter(|inner| inner.kind() == "function_definition"),
        _ => None,
    }
}

fn function(reader: Reader<'_>, node: CodeNode<'_>) -> Read<Function> {
    let text = reader.text;
    let inner = definition(node).unwrap_or(node);
    let name = text.field(inner, "name")?;
    let list = text.field(inner, "parameters")?;
    let mut parameters = vec![];
    let mut body = text.check(node).and_then(|()| undecorated(text, node));
    for parameter in children(list) {
        match read_parameter(reader, parameter) {
            Ok(read) => parameters.push(read),
            Err(error) => body = body.and(Err(error)),
        }
    }
    // Names that the function has itself hide those that the file imports.
    let mut own = reader.own.clone();
    own.extend(parameters.iter().map(|parameter| parameter.name.clone()));
    let mut inside = vec![];
    if body.is_ok() {
        assigned(text, text.field(inner, "body")?, &mut inside);
    }
    own.extend(inside);
    let reader = Reader {
        own: &own,
        ..reader
    };
    let body = body.and_then(|()| {
        let (is_async, block) = (
            text.text(inner).starts_with("async"),
            text.field(inner, "body")?,
        );
        if is_async {
            let help = "a function that computes its value when it is called is read";
            return Err(text.refused(name, "an async function is not read", help));
        }
        reader.steps(block)
    });
    Ok(Function {
        name: text.text(name).to_owned(),
        place: place(name),
        parameters,
        body,
    })
}

/// The names that are assigned at a node or within it, once for each time; not within functions and classes.
fn assigned(text: Text<'_>, node: CodeNode<'_>, into: &mut Vec<String>) {
    let mut pending = vec![node];
    while let Some(node) = pending.pop() {
        for name in ["left", "name"] {
            let is_pattern = name == "left" || node.kind() == "named_expression";
            let left = node.child_by_field_name(name).filter(|_| is_pattern);
            let is_operator = node.kind().ends_with("operator");
            let mut patterns: Vec<CodeNode<'_>> =
                left.filter(|_| !is_operator).into_iter().collect();
            while let Some(pattern) = patterns.pop() {
                match pattern.kind() {
                    "identifier" => into.push(text.text(pattern).to_owned()),
                    "pattern_list" | "tuple_pattern" | "list_pattern" | "tuple" | "list" => {
                        patterns.extend(children(pattern));
                    }
                    _ => {}
                }
            }
        }
        let inner = children(node).into_iter();
        pending.extend(inner.filter(|child| {
            !matches!(
                child.kind(),
                "function_definition" | "class_definition" | "lambda"
            )
        }));
    }
}

/// The names that functions declare as global.
fn globals(text: Text<'_>, root: CodeNode<'_>) -> BTreeSet<String> {
    let mut found = BTreeSet::new();
    let mut pending = vec![root];
    while let Some(node) = pending.pop() {
        let inner = children(node);
        if node.kind() == "global_statement" {
            found.extend(inner.iter().map(|name| text.text(*name).to_owned()));
        }
        pending.extend(inner);
    }
    found
}

/// Fails for a decorator that may change the values of a function.
fn undecorated(text: Text<'_>, node: CodeNode<'_>) -> Read<()> {
    if node.kind() != "decorated_definition" {
        return Ok(());
    }
    for decorator in children(node) {
        if decorator.kind() != "decorator" {
            continue;
        }
        let words = text.text(decorator).trim_start_matches('@');
        let name = words.split('(').next().unwrap_or(words).trim();
        let name = name.rsplit('.').next().unwrap_or(name);
        if !DECORATORS.contains(&name) {
            let message = format!("the decorator `{name}` may change the values of the function");
            let help = format!("these are read past: {}", DECORATORS.join(", "));
            return Err(text.refused(decorator, message, help));
        }
    }
    Ok(())
}

fn read_parameter(reader: Reader<'_>, node: CodeNode<'_>) -> Read<Parameter> {
    let text = reader.text;
    let name = match node.kind() {
        "identifier" => node,
        "typed_parameter" => children(node).into_iter().next().unwrap_or(node),
        "default_parameter" | "typed_default_parameter" => text.field(node, "name")?,
        _ => node,
    };
    if name.kind() != "identifier" {
        let message = "this parameter is not read";
        return Err(text.refused(node, message, "give each parameter a name: `def f(t, n=3)`"));
    }
    let default = node.child_by_field_name("value");
    let default = default.map(|value| reader.expression(value)).transpose()?;
    let kind = node.child_by_field_name("type").map(|kind| text.text(kind));
    Ok(Parameter {
        name: text.text(name).to_owned(),
        place: place(name),
        default,
        is_integer: kind == Some("int"),
    })
}
