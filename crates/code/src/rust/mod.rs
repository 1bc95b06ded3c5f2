//! Reads Rust: free functions of a file, and its constants.

mod expression;
mod names;
mod statement;

use crate::grammar::{CodeNode, Read, Text, children, place, tree};
use crate::program::{CodeLanguage, Function, Parameter, Program};
use expression::Reader;
use names::{imported_constants, is_integer};
use statement::Ending;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_syntax::derivation::Source;

/// Reads a file. What cannot be read of it is no error until it is asked for.
pub(crate) fn program(source: &Arc<Source>) -> Read<Program> {
    let tree = tree(source, CodeLanguage::Rust)?;
    let text = Text { source };
    let items = children(tree.root_node());
    let mut imported = BTreeSet::new();
    let mut functions = BTreeSet::new();
    for item in &items {
        match item.kind() {
            "use_declaration" => imported.extend(imported_constants(text.text(*item))),
            "function_item" => {
                functions.insert(text.text(text.field(*item, "name")?).to_owned());
            }
            _ => {}
        }
    }
    let reader = Reader {
        text,
        imported: &imported,
        functions: &functions,
    };
    let mut program = Program {
        source: Arc::clone(source),
        language: CodeLanguage::Rust,
        functions: vec![],
        constants: vec![],
    };
    for item in items {
        match item.kind() {
            "function_item" => program.functions.push(function(reader, item)?),
            "const_item" if text.check(item).is_ok() => {
                let name = text.text(text.field(item, "name")?);
                // What is not read here is missing where it is used.
                if let Ok(value) = text.field(item, "value").and_then(|v| reader.expression(v)) {
                    program.constants.push((name.to_owned(), value));
                }
            }
            _ => {}
        }
    }
    Ok(program)
}

fn function(reader: Reader<'_>, node: CodeNode<'_>) -> Read<Function> {
    let text = reader.text;
    let name = text.field(node, "name")?;
    let mut parameters = vec![];
    let mut body = text.check(node);
    for parameter in children(text.field(node, "parameters")?) {
        match read_parameter(reader, parameter) {
            Ok(read) => parameters.push(read),
            Err(error) => body = body.and(Err(error)),
        }
    }
    let block = text.field(node, "body");
    let body = body.and_then(|()| reader.steps(block?, Ending::Value));
    Ok(Function {
        name: text.text(name).to_owned(),
        place: place(name),
        parameters,
        body,
    })
}

fn read_parameter(reader: Reader<'_>, node: CodeNode<'_>) -> Read<Parameter> {
    let text = reader.text;
    let pattern = node.child_by_field_name("pattern");
    let Some(name) = pattern.filter(|pattern| pattern.kind() == "identifier") else {
        let message = "this parameter is not read";
        return Err(text.refused(node, message, "give each parameter a name: `t: f64`"));
    };
    let kind = text.text(text.field(node, "type")?);
    if kind.starts_with("&mut") {
        let message = "a parameter that is changed is not read";
        return Err(text.refused(node, message, "return the new value"));
    }
    Ok(Parameter {
        name: text.text(name).to_owned(),
        place: place(name),
        default: None,
        is_integer: is_integer(kind),
    })
}
