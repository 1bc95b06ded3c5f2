//! Reads Python: functions of a module, the names that it imports and assigns.

mod expression;
mod globals;
mod names;
mod statement;

use crate::grammar::{CodeNode, Read, Text, children, place, tree};
use crate::program::{CodeLanguage, Constant, Function, Kind, Parameter, Program, Type};
use expression::Reader;
use names::Imports;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_syntax::derivation::Source;

/// Decorators that leave the values of a function as they are.
const DECORATORS: [(&str, &str); 4] = [
    ("functools", "lru_cache"),
    ("functools", "cache"),
    ("numba", "njit"),
    ("numba", "jit"),
];

/// Functions by which a program changes what names mean.
const DYNAMIC: [&str; 6] = ["globals", "locals", "vars", "exec", "setattr", "delattr"];

/// Reads a file. What cannot be read of it is no error until it is asked for.
pub(crate) fn program(source: &Arc<Source>) -> Read<Program> {
    let tree = tree(source, CodeLanguage::Python)?;
    let text = Text { source };
    let statements = children(tree.root_node());
    let mut imports = Imports::default();
    let mut functions = BTreeSet::new();
    // Names that assignments outside of functions give a value, once for each time, and those that get a meaning otherwise.
    let mut outside = vec![];
    let mut others: Vec<(String, usize)> = vec![];
    for node in &statements {
        if let Some(function) = definition(*node) {
            functions.insert(text.text(text.field(function, "name")?).to_owned());
            continue;
        }
        match node.kind() {
            "import_statement" | "import_from_statement" => {
                imports.add(text, *node)?;
                let names = names::imported(text, *node).into_iter();
                others.extend(names.map(|name| (name, node.start_byte())));
            }
            "expression_statement" => assigned(text, *node, &mut outside),
            _ => {
                let mut own = vec![];
                globals::bound(text, *node, &mut own);
                imports.disturb(own);
            }
        }
    }
    imports.disturb(globals::declared(text, tree.root_node()));
    let mut own = functions.clone();
    own.extend(outside.iter().cloned());
    let reader = Reader {
        text,
        imports: &imports,
        functions: &functions,
        own: &own,
        locals: &BTreeSet::new(),
    };
    let mut program = Program {
        source: Arc::clone(source),
        language: CodeLanguage::Python,
        functions: vec![],
        constants: vec![],
    };
    let is_dynamic = globals::mentions(text, tree.root_node(), &DYNAMIC);
    // Whether what is written at a place is all that a name means.
    let is_plain = |name: &String, node: CodeNode<'_>| {
        !is_dynamic
            && !others
                .iter()
                .any(|(own, at)| own == name && *at > node.start_byte())
            && !imports.is_hidden(name, node.start_byte())
            && !imports.is_before_whole(node.start_byte())
    };
    for node in &statements {
        if let Some(inner) = definition(*node) {
            let mut function = function(reader, *node)?;
            if !is_plain(&function.name, *node) || outside.contains(&function.name) {
                let message = format!("`{}` gets another meaning in this file", function.name);
                let help = "give the function a name of its own, and import before it";
                let name = text.field(inner, "name")?;
                function.body = Err(text.refused(name, message, help));
            }
            program.functions.push(function);
        } else if node.kind() == "expression_statement" && text.check(*node).is_ok() {
            // What is not read here is missing where it is used.
            let steps = reader.step(*node).unwrap_or_default();
            for (name, value) in statement::constants(&steps) {
                let times = outside.iter().filter(|other| **other == name).count();
                if times == 1 && is_plain(&name, *node) && !functions.contains(&name) {
                    let is_only_read =
                        globals::is_only_read(reader, tree.root_node(), *node, &name);
                    program.constants.push(Constant {
                        name,
                        value,
                        is_only_read,
                    });
                }
            }
        }
    }
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
    let mut body = text.check(node).and_then(|()| undecorated(reader, node));
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
    let mut locals: BTreeSet<String> = inside.iter().cloned().collect();
    own.extend(inside);
    let assigned = locals.clone();
    locals.extend(parameters.iter().map(|parameter| parameter.name.clone()));
    let reader = Reader {
        own: &own,
        locals: &locals,
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
        result: Type::Open,
        locals: assigned,
        is_cached: node.kind() == "decorated_definition",
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

/// Fails for a decorator that may change the values of a function.
fn undecorated(reader: Reader<'_>, node: CodeNode<'_>) -> Read<()> {
    let text = reader.text;
    if node.kind() != "decorated_definition" {
        return Ok(());
    }
    for decorator in children(node) {
        if decorator.kind() != "decorator" {
            continue;
        }
        let words = text.text(decorator).trim_start_matches('@');
        let written = words.split('(').next().unwrap_or(words).trim();
        let (object, name) = match written.rsplit_once('.') {
            Some((object, name)) => (Some(object.trim()), name.trim()),
            None => (None, written),
        };
        let is_own = reader.own.contains(object.unwrap_or(name));
        let origin = reader.imports.origin(object, name).filter(|_| !is_own);
        let is_read = origin.is_some_and(|(module, name)| {
            let mut known = DECORATORS.iter();
            known.any(|(own, known)| *own == module && *known == name)
        });
        if !is_read {
            let message = format!("the decorator `{name}` may change the values of the function");
            let known = DECORATORS.map(|(module, name)| format!("{module}.{name}"));
            let help = format!("these are read past: {}", known.join(", "));
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
        declared: match kind {
            Some("int") => Type::Number(Kind::Whole),
            _ => Type::Open,
        },
    })
}
