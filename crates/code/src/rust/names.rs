//! What names of Rust mean: those of the items of a file, those that it imports, and those of the standard library.
//!
//! A name has a meaning only if exactly one item of the file binds it, whatever that is a name of: types, values, modules and
//! macros are one list here. Whoever asks for another name is told why it has none.

use super::attributes::attribute;
use crate::grammar::{CodeNode, Read, Text, children, is_plain};
use crate::program::{call, operation};
use std::collections::{BTreeMap, BTreeSet};
use torse_numbers::rational::{integer, ratio};
use torse_syntax::formula::{Expr, Operator};

/// Macros outside of functions that are known to name nothing else.
const MACROS: [&str; 1] = ["thread_local"];
/// The most imports through which a name is followed.
const MAX_IMPORTS: usize = 8;

/// The names of a file.
#[derive(Debug, Clone, Default)]
pub(super) struct Names {
    bound: BTreeMap<String, Vec<Bound>>,
    /// The paths of which all names are imported.
    whole: Vec<Vec<String>>,
    /// The methods that traits of the file add to other types.
    methods: BTreeSet<String>,
    /// The macros that the file defines, anywhere.
    macros: BTreeSet<String>,
    /// The line at which any name may get another meaning.
    unsure: Option<usize>,
}

#[derive(Debug, Clone)]
struct Bound {
    what: What,
    line: usize,
    /// Whether an attribute may leave the item out or change it.
    is_conditional: bool,
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum What {
    /// The path that is imported.
    Import(Vec<String>),
    Item,
}

impl Names {
    /// The names of a file with these items.
    pub(super) fn new(text: Text<'_>, root: CodeNode<'_>) -> Self {
        let mut names = Self::default();
        let mut is_conditional = false;
        for item in children(root) {
            let line = item.start_position().row + 1;
            let mut bind = |name: &str, what| {
                if !is_plain(name) {
                    names.unsure.get_or_insert(line);
                }
                let bound = Bound {
                    what,
                    line,
                    is_conditional,
                };
                names.bound.entry(name.to_owned()).or_default().push(bound);
            };
            match item.kind() {
                "attribute_item" => {
                    is_conditional |= attribute(text, item).is_err();
                    continue;
                }
                "inner_attribute_item" => continue,
                "use_declaration" => {
                    let mut paths = vec![];
                    let argument = item.child_by_field_name("argument");
                    if argument.is_none_or(|node| paths_of(text, node, &[], &mut paths).is_none()) {
                        names.unsure.get_or_insert(line);
                    }
                    for (path, alias) in paths {
                        match alias {
                            Some(alias) if alias == "_" => {}
                            Some(alias) => {
                                bind_import(&mut names.bound, alias, path, line, is_conditional)
                            }
                            None => names.whole.push(path),
                        }
                    }
                }
                "extern_crate_declaration" => {
                    let alias = item.child_by_field_name("alias");
                    let name = alias.or_else(|| item.child_by_field_name("name"));
                    bind(name.map_or("", |name| text.text(name)), What::Item);
                }
                // Its names are those that it makes.
                "macro_invocation" | "expression_statement" => {
                    let words = text.text(item);
                    let name = words.split('!').next().unwrap_or("").trim();
                    if !MACROS.contains(&name) {
                        names.unsure.get_or_insert(line);
                    }
                }
                "ERROR" => drop(names.unsure.get_or_insert(line)),
                _ => {
                    if let Some(name) = item.child_by_field_name("name") {
                        bind(text.text(name), What::Item);
                    }
                }
            }
            is_conditional = false;
        }
        names.look_inside(text, root);
        let mut others = names.whole.iter();
        if others.any(|path| !is_standard(path)) {
            let line = children(root)
                .into_iter()
                .find(|item| item.kind() == "use_declaration" && text.text(*item).contains('*'));
            let line = line.map_or(1, |item| item.start_position().row + 1);
            names.unsure.get_or_insert(line);
        }
        names
    }

    /// Notes macros, and the methods of traits, wherever they stand.
    fn look_inside(&mut self, text: Text<'_>, root: CodeNode<'_>) {
        let own: BTreeSet<&str> = children(root)
            .into_iter()
            .filter(|item| matches!(item.kind(), "struct_item" | "enum_item" | "union_item"))
            .filter_map(|item| item.child_by_field_name("name"))
            .map(|name| text.text(name))
            .collect();
        let mut pending = vec![root];
        while let Some(node) = pending.pop() {
            let field = |name: &str| node.child_by_field_name(name);
            match node.kind() {
                "macro_definition" => {
                    self.macros
                        .extend(field("name").map(|name| text.text(name).to_owned()));
                }
                "attribute_item" if text.text(node).contains("macro_use") => {
                    self.unsure.get_or_insert(node.start_position().row + 1);
                }
                "trait_item" | "impl_item" => {
                    let kind = field("type").map_or("", |kind| text.text(kind));
                    let head = kind.split('<').next().unwrap_or(kind).trim();
                    let is_of_trait = node.kind() == "trait_item" || field("trait").is_some();
                    if is_of_trait && !own.contains(head) {
                        let functions = field("body").map(children).unwrap_or_default();
                        let names = functions
                            .into_iter()
                            .filter_map(|function| function.child_by_field_name("name"));
                        self.methods
                            .extend(names.map(|name| text.text(name).to_owned()));
                    }
                }
                _ => {}
            }
            pending.extend(children(node));
        }
    }

    /// The one item that binds a name; none if nothing does, and the reason if that is not sure.
    fn only(&self, name: &str) -> Result<Option<&Bound>, String> {
        if let Some(line) = self.unsure {
            return Err(format!(
                "what names mean in this file is not sure: line {line} may change it"
            ));
        }
        match self.bound.get(name).map(Vec::as_slice) {
            None | Some([]) => Ok(None),
            Some([only]) if !only.is_conditional => Ok(Some(only)),
            Some([only]) => Err(format!(
                "an attribute in line {} may leave `{name}` out or change it",
                only.line.saturating_sub(1).max(1)
            )),
            Some(several) => {
                let lines: Vec<String> = several.iter().map(|b| b.line.to_string()).collect();
                Err(format!(
                    "`{name}` gets a meaning more than once in this file: in lines {}",
                    lines.join(", ")
                ))
            }
        }
    }

    /// Fails for a name that is not sure.
    pub(super) fn check(&self, name: &str) -> Result<(), String> {
        self.only(name).map(|_| ())
    }

    /// Whether a name of the language, as `f64`, has its own meaning in the file.
    pub(super) fn is_standard(&self, name: &str) -> bool {
        match self.only(name) {
            Ok(None) => true,
            Ok(Some(Bound {
                what: What::Import(path),
                ..
            })) => self.resolved(path, 0).is_some_and(|path| {
                path.last().is_some_and(|last| last == name) && is_standard(&path)
            }),
            _ => false,
        }
    }

    /// Whether a method is none of a trait of the file.
    pub(super) fn is_method(&self, name: &str) -> bool {
        !self.methods.contains(name)
    }

    /// Whether a macro is the one of the standard library.
    pub(super) fn is_macro(&self, name: &str) -> bool {
        !self.macros.contains(name) && matches!(self.only(name), Ok(None))
    }

    /// A path with its first name replaced by what that imports; none if it begins with something of the file.
    fn resolved(&self, path: &[String], depth: usize) -> Option<Vec<String>> {
        let (first, rest) = path.split_first()?;
        if depth > MAX_IMPORTS || matches!(first.as_str(), "crate" | "self" | "super") {
            return None;
        }
        match self.only(first).ok()? {
            // `use std::f64;` binds what it begins with no second time.
            Some(Bound {
                what: What::Import(own),
                ..
            }) if own != path => {
                let mut whole = self.resolved(own, depth + 1)?;
                whole.extend_from_slice(rest);
                Some(whole)
            }
            Some(_) => None,
            None => Some(path.to_vec()),
        }
    }

    /// The constant of the standard library that a path names.
    pub(super) fn constant(&self, path: &str) -> Option<Expr> {
        let path = path.trim_start_matches("::").split("::");
        let path: Vec<String> = path.map(|part| part.trim().to_owned()).collect();
        let path = match path.as_slice() {
            [name] if !self.bound.contains_key(name) => {
                let mut whole = self.whole.iter().filter_map(|path| self.resolved(path, 0));
                let mut path = whole.find(|path| is_constants(path))?;
                path.push(name.clone());
                path
            }
            path => self.resolved(path, 0)?,
        };
        let (name, module) = path.split_last()?;
        is_constants(module).then(|| constant(name)).flatten()
    }

    /// The names that imports and items bind.
    pub(super) fn all(&self) -> impl Iterator<Item = &str> {
        self.bound.keys().map(String::as_str)
    }
}

fn bind_import(
    bound: &mut BTreeMap<String, Vec<Bound>>,
    alias: String,
    path: Vec<String>,
    line: usize,
    is_conditional: bool,
) {
    bound.entry(alias).or_default().push(Bound {
        what: What::Import(path),
        line,
        is_conditional,
    });
}

fn is_standard(path: &[String]) -> bool {
    let first = path.first().map(String::as_str);
    matches!(first, Some("std" | "core" | "alloc"))
}

/// Whether a path is `std::f64::consts`.
fn is_constants(path: &[String]) -> bool {
    match path {
        [library, kind, module] => {
            matches!(library.as_str(), "std" | "core")
                && matches!(kind.as_str(), "f64" | "f32")
                && module == "consts"
        }
        _ => false,
    }
}

/// The paths of an import with the names that they get; none for all names of a path. Fails where it is not understood.
fn paths_of(
    text: Text<'_>,
    node: CodeNode<'_>,
    before: &[String],
    into: &mut Vec<(Vec<String>, Option<String>)>,
) -> Option<()> {
    let path = |node: CodeNode<'_>| {
        let words = text.text(node).trim_start_matches("::").split("::");
        let words = words.map(|word| word.trim().to_owned());
        let mut path = before.to_vec();
        path.extend(words);
        path
    };
    match node.kind() {
        "identifier" | "scoped_identifier" => {
            let path = path(node);
            let name = path.last().cloned();
            into.push((path, name));
        }
        // `use a::b::{self}` is `use a::b`.
        "self" if !before.is_empty() => into.push((before.to_vec(), before.last().cloned())),
        "use_as_clause" => {
            let inner = node.child_by_field_name("path")?;
            let alias = text.text(node.child_by_field_name("alias")?).to_owned();
            let path = match inner.kind() {
                "self" => before.to_vec(),
                _ => path(inner),
            };
            into.push((path, Some(alias)));
        }
        "use_list" => {
            for inner in children(node) {
                paths_of(text, inner, before, into)?;
            }
        }
        "scoped_use_list" => {
            let head = node.child_by_field_name("path");
            let before = head.map_or_else(|| before.to_vec(), path);
            paths_of(text, node.child_by_field_name("list")?, &before, into)?;
        }
        "use_wildcard" => {
            let inner = children(node).first().copied();
            into.push((inner.map_or_else(|| before.to_vec(), path), None));
        }
        _ => return None,
    }
    Some(())
}

/// A constant of `std::f64::consts`.
fn constant(name: &str) -> Option<Expr> {
    let pi = |above: i64, below: i64| {
        let factor = ratio(above, below)?;
        let pi = Expr::name(operation::PI);
        Some(Expr::number(&factor).with(Operator::Multiply, pi))
    };
    match name {
        "PI" => Some(Expr::name(operation::PI)),
        "TAU" => pi(2, 1),
        "FRAC_PI_2" => pi(1, 2),
        "FRAC_PI_3" => pi(1, 3),
        "FRAC_PI_4" => pi(1, 4),
        "FRAC_PI_6" => pi(1, 6),
        "FRAC_PI_8" => pi(1, 8),
        "E" => Some(Expr::name(operation::E)),
        "SQRT_2" => Some(call(
            // No function of the file has such a name.
            "##sqrt",
            vec![call(
                operation::FLOAT,
                vec![Expr::number(&integer(2))],
                Default::default(),
            )],
            Default::default(),
        )),
        _ => None,
    }
}

/// The function of formulas that a method without arguments is.
pub(super) fn elementary(method: &str) -> Option<&'static str> {
    let all = [
        "sin", "cos", "tan", "exp", "sinh", "cosh", "tanh", "sqrt", "abs", "atan", "asin", "acos",
    ];
    match method {
        "ln" => Some("log"),
        _ => all.into_iter().find(|known| *known == method),
    }
}

/// Fails for parameters of a function that are constants: their names hide those of the file.
pub(super) fn without_constants(text: Text<'_>, function: CodeNode<'_>) -> Read<()> {
    let parameters = function.child_by_field_name("type_parameters");
    let parameters = parameters.map(children).unwrap_or_default();
    match parameters
        .iter()
        .find(|own| own.kind() == "const_parameter")
    {
        None => Ok(()),
        Some(own) => {
            let message = "a parameter that is a constant is not read";
            let help = "pass it as a parameter of the function: `n: usize`";
            Err(text.refused(*own, message, help))
        }
    }
}
