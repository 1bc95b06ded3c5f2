//! Reads Python: functions of a module, the names that it imports and assigns.

mod bindings;
mod calls;
mod expression;
mod globals;
mod meaning;
mod names;
mod statement;
mod unsure;

use crate::grammar::{CodeNode, Read, Text, children, place, tree};
use crate::program::{CodeLanguage, Constant, Function, Kind, Parameter, Program, Type};
use bindings::bindings;
use expression::Reader;
use names::Names;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_syntax::derivation::Source;
use torse_syntax::formula::Expr;

/// Decorators that leave the values of a function as they are.
const DECORATORS: [(&str, &str); 4] = [
    ("functools", "lru_cache"),
    ("functools", "cache"),
    ("numba", "njit"),
    ("numba", "jit"),
];

/// Reads a file. What cannot be read of it is no error until it is asked for.
pub(crate) fn program(source: &Arc<Source>) -> Read<Program> {
    let tree = tree(source, CodeLanguage::Python)?;
    let text = Text { source };
    let root = tree.root_node();
    let names = Names::new(text, root);
    let functions = names.functions();
    let reader = Reader {
        text,
        names: &names,
        functions: &functions,
        locals: &BTreeSet::new(),
    };
    let mut program = Program {
        source: Arc::clone(source),
        language: CodeLanguage::Python,
        functions: vec![],
        constants: vec![],
    };
    for node in children(root) {
        if let Some(inner) = definition(node) {
            let mut function = function(reader, node)?;
            if let Err(message) = names.name(&function.name) {
                let help = "give each thing of the file a name of its own";
                let name = text.field(inner, "name")?;
                function.body = Err(text.refused(name, message, help));
            }
            program.functions.push(function);
        } else if node.kind() == "expression_statement" {
            program.constants.extend(constants(reader, root, node));
        }
    }
    Ok(program)
}

/// The names that a statement outside of functions gives a value, with their values, or the reason why these are not read.
fn constants(reader: Reader<'_>, root: CodeNode<'_>, node: CodeNode<'_>) -> Vec<Constant> {
    let text = reader.text;
    let position = node.start_byte();
    let steps = text.check(node).and_then(|()| evaluated(reader, node));
    let steps = steps.and_then(|()| reader.step(node));
    let unread = |node| {
        let help = "a constant is a name with a value, `c = 3`, or several with as many values";
        text.refused(node, "this constant is not read", help)
    };
    let values: Read<Vec<(String, Expr)>> = steps.map(|steps| statement::constants(&steps));
    let mut found: Vec<Constant> = vec![];
    for (name, _) in bindings(text, &[node]) {
        let value = match &values {
            Ok(values) => {
                let mut own = values.iter().filter(|(own, _)| *own == name);
                let value = own.next().map(|(_, value)| value.clone());
                value.ok_or_else(|| unread(node))
            }
            Err(error) => Err(error.clone()),
        };
        found.push(Constant {
            is_only_read: globals::is_only_read(reader, root, node, &name),
            name,
            position,
            value,
        });
    }
    found
}

/// Fails for what is evaluated outside of functions while names may still get another meaning.
fn evaluated(reader: Reader<'_>, node: CodeNode<'_>) -> Read<()> {
    let position = node.start_byte();
    if !reader.names.is_before_imports(position) || is_literal(node) {
        return Ok(());
    }
    let message = "this is computed before all names are imported, and may use others";
    Err(reader
        .text
        .refused(node, message, "import all names at the top of the file"))
}

/// Whether nothing of it has a name, but what it is assigned to.
fn is_literal(node: CodeNode<'_>) -> bool {
    let mut pending = vec![node];
    while let Some(node) = pending.pop() {
        match node.kind() {
            "identifier" => return false,
            "assignment" => pending.extend(node.child_by_field_name("right")),
            _ => pending.extend(children(node)),
        }
    }
    true
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
    let block = text.field(inner, "body")?;
    let mut parameters: Vec<Parameter> = vec![];
    let mut body = text.check(node).and_then(|()| undecorated(reader, node));
    body = body.and(text.name(name).map(|_| ()));
    let indented = |sign: char| text.text(inner).lines().any(|line| line.starts_with(sign));
    if indented(' ') && indented('\t') {
        let message = "some lines of this function begin with spaces, and some with tabs";
        body = body.and(Err(text.refused(name, message, "indent by spaces alone")));
    }
    for parameter in children(list) {
        match read_parameter(reader, parameter) {
            Ok(read) => parameters.push(read),
            Err(error) => body = body.and(Err(error)),
        }
    }
    let assigned: BTreeSet<String> = match body.is_ok() {
        true => bindings(text, &[block])
            .into_iter()
            .map(|(name, _)| name)
            .collect(),
        false => BTreeSet::new(),
    };
    // Names that the function has itself hide those of the file.
    let mut locals = assigned.clone();
    locals.extend(parameters.iter().map(|parameter| parameter.name.clone()));
    let reader = Reader {
        locals: &locals,
        ..reader
    };
    let body = body.and_then(|()| {
        if text.text(inner).starts_with("async") {
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
        let origin = reader.names.origin(object, name);
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
    let default = default.map(|value| {
        evaluated(reader, value)?;
        reader.expression(value)
    });
    let default = default.transpose()?;
    let kind = node.child_by_field_name("type").map(|kind| text.text(kind));
    Ok(Parameter {
        name: text.name(name)?.to_owned(),
        place: place(name),
        default,
        declared: match kind {
            Some("int") => Type::Number(Kind::Whole),
            _ => Type::Open,
        },
    })
}
