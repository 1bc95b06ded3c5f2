//! Reads Rust: free functions of a file, and its constants.

mod attributes;
mod expression;
mod methods;
mod names;
mod statement;
mod types;

use crate::grammar::{CodeNode, Read, Text, children, place, tree};
use crate::program::{CodeLanguage, Constant, Function, Parameter, Program, Type};
use attributes::{attribute, attributes};
use expression::Reader;
use names::{Names, without_constants};
use statement::Ending;
use std::collections::BTreeSet;
use std::sync::Arc;
use torse_syntax::derivation::Source;
use types::Aliases;

/// Reads a file. What cannot be read of it is no error until it is asked for.
pub(crate) fn program(source: &Arc<Source>) -> Read<Program> {
    let tree = tree(source, CodeLanguage::Rust)?;
    let text = Text { source };
    let items = children(tree.root_node());
    let names = Names::new(text, tree.root_node());
    let mut functions = BTreeSet::new();
    for item in &items {
        if item.kind() == "function_item" {
            functions.insert(text.text(text.field(*item, "name")?).to_owned());
        }
    }
    let aliases = Aliases::new(text, &items, &names);
    let reader = Reader {
        text,
        names: &names,
        functions: &functions,
        aliases: &aliases,
    };
    let mut program = Program {
        source: Arc::clone(source),
        language: CodeLanguage::Rust,
        functions: vec![],
        constants: vec![],
    };
    // An attribute of the file, or the one before an item, may leave the item out.
    let mut of_file = Ok(());
    let mut before: Read<()> = Ok(());
    for item in items {
        match item.kind() {
            "inner_attribute_item" => of_file = of_file.and(attribute(text, item)),
            "attribute_item" => before = before.and(attribute(text, item)),
            "function_item" => {
                let mut function = function(reader, item)?;
                if let Err(message) = names.check(&function.name) {
                    let help = "leave the other ones out, whatever their attributes say";
                    let name = text.field(item, "name")?;
                    function.body = Err(text.refused(name, message, help));
                }
                let attributes = of_file.clone().and(before);
                function.body = attributes.and(function.body);
                before = Ok(());
                program.functions.push(function);
            }
            "const_item" => {
                let name = text.text(text.field(item, "name")?);
                let value = text.check(item).and_then(|()| text.field(item, "value"));
                let value = value.and_then(|value| reader.expression(value));
                let attributes = of_file.clone().and(before).and(attributes(text, item));
                program.constants.push(Constant {
                    name: name.to_owned(),
                    position: 0,
                    value: attributes.and(value),
                    is_only_read: true,
                });
                before = Ok(());
            }
            _ => before = Ok(()),
        }
    }
    Ok(program)
}

fn function(reader: Reader<'_>, node: CodeNode<'_>) -> Read<Function> {
    let text = reader.text;
    let name = text.field(node, "name")?;
    let mut parameters = vec![];
    let mut body = text.check(node).and_then(|()| attributes(text, node));
    body = body.and(without_constants(text, node));
    let own = reader.aliases.within(text, node);
    let reader = Reader {
        aliases: &own,
        ..reader
    };
    for parameter in children(text.field(node, "parameters")?) {
        if parameter.kind() == "attribute_item" {
            continue;
        }
        match read_parameter(reader, parameter) {
            Ok(read) => parameters.push(read),
            Err(error) => body = body.and(Err(error)),
        }
    }
    let block = text.field(node, "body");
    let body = body.and_then(|()| reader.steps(block?, Ending::Value));
    let result = node.child_by_field_name("return_type");
    let result = result.and_then(|kind| own.read(text, kind));
    Ok(Function {
        name: text.text(name).to_owned(),
        place: place(name),
        parameters,
        result: result.unwrap_or(Type::Open),
        locals: BTreeSet::new(),
        is_cached: false,
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
    let kind = text.field(node, "type")?;
    if text.text(kind).starts_with("&mut") {
        let message = "a parameter that is changed is not read";
        return Err(text.refused(node, message, "return the new value"));
    }
    let declared = reader.aliases.read(text, kind).ok_or_else(|| {
        let message = "this type is not read: whether it is one of integers is not known";
        let help = "numbers, arrays, slices, `Vec`s and tuples of them are read: `t: f64`";
        text.refused(kind, message, help)
    })?;
    Ok(Parameter {
        name: text.name(name)?.to_owned(),
        place: place(name),
        default: None,
        declared,
    })
}
