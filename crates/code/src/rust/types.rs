//! Types of Rust: which numbers are integers, whose division rounds.

use super::names::Names;
use crate::grammar::{CodeNode, Text, children, within};
use crate::program::{Kind, Type};
use std::collections::BTreeMap;

/// The types of integers.
const INTEGERS: [&str; 12] = [
    "usize", "isize", "u8", "u16", "u32", "u64", "u128", "i8", "i16", "i32", "i64", "i128",
];

/// The types that a file names, and what they are, if that is read.
#[derive(Debug, Clone, Default)]
pub(super) struct Aliases {
    named: BTreeMap<String, Option<Named>>,
}

#[derive(Debug, Clone)]
struct Named {
    meaning: Type,
    /// The type of numbers that it is another name of.
    number: Option<String>,
}

impl Aliases {
    /// The types that items of a file name.
    pub(super) fn new(text: Text<'_>, items: &[CodeNode<'_>], names: &Names) -> Self {
        let mut found = Self::default();
        // Whatever has a name of the file is none of the language, until it is read as another name of one.
        let own = names.all().filter(|name| !names.is_standard(name));
        found.named = own.map(|name| (name.to_owned(), None)).collect();
        let mut targets = vec![];
        for item in items {
            let is_type = matches!(
                item.kind(),
                "type_item" | "struct_item" | "enum_item" | "union_item" | "trait_item"
            );
            let Some(name) = item.child_by_field_name("name").filter(|_| is_type) else {
                continue;
            };
            let name = text.text(name).to_owned();
            let is_twice = names.check(&name).is_err();
            let target = item.child_by_field_name("type");
            let is_plain = item.child_by_field_name("type_parameters").is_none();
            let is_alias = item.kind() == "type_item" && is_plain && !is_twice;
            targets.extend(target.filter(|_| is_alias).map(|target| (name, target)));
        }
        // A name of a name is read when that one is.
        for _ in 0..targets.len() {
            for (name, target) in &targets {
                let read = found.read(text, *target).map(|meaning| Named {
                    meaning,
                    number: found.number(text, *target),
                });
                found.named.insert(name.clone(), read);
            }
        }
        found
    }

    /// The types as they are within a function, whose parameters of types hide others.
    pub(super) fn within(&self, text: Text<'_>, function: CodeNode<'_>) -> Self {
        let mut own = self.clone();
        let parameters = function.child_by_field_name("type_parameters");
        for node in parameters.into_iter().flat_map(within) {
            if matches!(node.kind(), "type_identifier" | "identifier") {
                own.named.insert(text.text(node).to_owned(), None);
            }
        }
        own
    }

    /// What a type is, if it is read.
    pub(super) fn read(&self, text: Text<'_>, node: CodeNode<'_>) -> Option<Type> {
        let field = |name: &str| node.child_by_field_name(name);
        let words = text.text(node);
        match node.kind() {
            "primitive_type" | "type_identifier" => match self.named.get(words) {
                Some(named) => named.as_ref().map(|named| named.meaning.clone()),
                None if INTEGERS.contains(&words) => {
                    let is_natural = words.starts_with('u');
                    Some(Type::Number(match is_natural {
                        true => Kind::Natural,
                        false => Kind::Whole,
                    }))
                }
                None if matches!(words, "f64" | "f32") => Some(Type::Number(Kind::Float)),
                None => None,
            },
            "reference_type" => {
                let mut parts = children(node).into_iter();
                let is_mutable = parts.any(|part| part.kind() == "mutable_specifier");
                self.read(text, field("type")?).filter(|_| !is_mutable)
            }
            "array_type" => Some(Type::Each(Box::new(self.read(text, field("element")?)?))),
            "tuple_type" => {
                let all = children(node).into_iter();
                let all = all.map(|part| self.read(text, part));
                Some(Type::Tuple(all.collect::<Option<_>>()?))
            }
            "generic_type" => {
                let name = text.text(field("type")?);
                let is_list = name == "Vec" && !self.named.contains_key(name);
                match children(field("type_arguments")?).as_slice() {
                    [inner] if is_list => Some(Type::Each(Box::new(self.read(text, *inner)?))),
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// The type of numbers of a name, if it is one.
    pub(super) fn number(&self, text: Text<'_>, node: CodeNode<'_>) -> Option<String> {
        let words = text.text(node).trim();
        match self.named.get(words) {
            Some(named) => named.as_ref()?.number.clone(),
            None => {
                let is_known = INTEGERS.contains(&words) || matches!(words, "f64" | "f32");
                is_known.then(|| words.to_owned())
            }
        }
    }
}
