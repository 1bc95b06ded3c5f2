//! A single statement with a one-line setting, read as a paper of one claim, for users without a folder of
//! derivations.
//!
//! The setting is a list with semicolons between its entries:
//!
//! | entry | meaning |
//! |---|---|
//! | `x in [0, 1]`, `a, b in (0, inf)` | symbols with their interval |
//! | `n in 0..`, `i in 0..n`, `k in ..5` | integers |
//! | `p: vector 3`, `f: function 1` | vectors, smooth functions |
//! | `H(t) := t^2 + 1` | a definition |
//! | `x >= 0`, `a^2 + b^2 == 1` | a hypothesis |
//!
//! An undeclared name is a real number.

use super::definitions::name_of;
use super::error::LoadError;
use super::load::paper;
use super::paper::Paper;
use super::source::Source;
use crate::formula::{Expr, Node, parse};
use std::collections::BTreeSet;
use std::sync::Arc;
use toml::{Table, Value};

/// The id of the paper; the id of its claim begins with it.
const PAPER: &str = "question";

/// Makes a paper whose only claim, `question/1`, states `states` in this setting.
///
/// # Errors
/// The first mistake in the statement or the setting, at its place.
///
/// ```
/// let paper = torse_syntax::derivation::question("x + y >= x", "x, y in [0, 1]")?;
/// assert_eq!(paper.claims[0].entry.id.get_ref(), "question/1");
/// # Ok::<(), torse_syntax::derivation::LoadError>(())
/// ```
pub fn question(states: &str, setting: &str) -> Result<Paper, LoadError> {
    let setting = Setting::read(setting);
    let mut symbols = setting.symbols.clone();
    for name in setting.undeclared(states) {
        symbols.insert(name, Value::Table(Table::new()));
    }
    let mut head = Table::new();
    let mut about = Table::new();
    for (key, value) in [("id", PAPER), ("title", ""), ("authors", ""), ("venue", "")] {
        about.insert(key.to_owned(), text(value));
    }
    about.insert("claims".to_owned(), Value::Array(vec![text("claim.toml")]));
    head.insert("paper".to_owned(), Value::Table(about));
    head.insert("symbols".to_owned(), Value::Table(symbols));
    head.insert(
        "define".to_owned(),
        Value::Table(setting.definitions.clone()),
    );
    let mut claim = Table::new();
    for (key, value) in [
        ("id", "question/1"),
        ("at", ""),
        ("kind", "identity"),
        ("printed", states),
        ("states", states),
    ] {
        claim.insert(key.to_owned(), text(value));
    }
    claim.insert(
        "assume".to_owned(),
        Value::Array(setting.hypotheses.clone()),
    );
    let mut claims = Table::new();
    claims.insert("claim".to_owned(), Value::Array(vec![Value::Table(claim)]));
    let (head, claims) = (head.to_string(), claims.to_string());
    paper(|name| {
        let (name, text) = match name {
            "paper.toml" => ("the setting", &head),
            _ => ("the statement", &claims),
        };
        Ok(Arc::new(Source {
            name: name.to_owned(),
            text: text.clone(),
        }))
    })
}

fn text(text: &str) -> Value {
    Value::String(text.to_owned())
}
/// The declarations and hypotheses of a setting.
/// What the entries of a setting declare.
#[derive(Default)]
struct Setting {
    symbols: Table,
    definitions: Table,
    hypotheses: Vec<Value>,
}

impl Setting {
    /// Reads the entries. An entry that is not a declaration is taken for a hypothesis, whose syntax is checked
    /// later.
    fn read(setting: &str) -> Self {
        let mut read = Self::default();
        for entry in setting.split(';').map(str::trim) {
            if entry.is_empty() {
                continue;
            }
            if let Some((defined, body)) = entry.split_once(":=") {
                let defined = defined.trim().to_owned();
                read.definitions.insert(defined, text(body.trim()));
            } else if let Some((names, set)) = declared(entry, " in ").or(declared(entry, ":")) {
                for name in names {
                    read.symbols.insert(name.to_owned(), symbol(set));
                }
            } else {
                read.hypotheses.push(text(entry));
            }
        }
        read
    }

    /// The undeclared names that the statement and the setting use as numbers, in alphabetical order.
    fn undeclared(&self, states: &str) -> BTreeSet<String> {
        let bodies = self
            .definitions
            .iter()
            .map(|(head, body)| (parameters(head), body));
        let hypotheses = self.hypotheses.iter().map(|formula| (vec![], formula));
        let mut used = BTreeSet::new();
        let mut add = |formula: &str, bound: &[String]| {
            if let Ok(formula) = parse(formula) {
                free_numbers(&formula, bound, &mut used);
            }
        };
        add(states, &[]);
        for (bound, formula) in bodies.chain(hypotheses) {
            add(formula.as_str().unwrap_or_default(), &bound);
        }
        // The bounds of declared sets may contain symbols too.
        for set in self.symbols.values().filter_map(Value::as_table) {
            for end in set.values().filter_map(Value::as_str) {
                let ends = end.split(['[', ']', '(', ')', ',', '.', '<', '>', '=']);
                ends.for_each(|end| add(end, &[]));
            }
        }
        let heads = self.definitions.keys().map(|head| name_of(head));
        let defined: BTreeSet<String> = heads.collect();
        used.retain(|name| {
            !self.symbols.contains_key(name) && !defined.contains(name) && name != "inf"
        });
        used
    }
}

/// The names before the sign and the text after it, if all of them are names.
fn declared<'e>(entry: &'e str, sign: &str) -> Option<(Vec<&'e str>, &'e str)> {
    let (names, set) = entry.split_once(sign)?;
    let names: Vec<&str> = names.split(',').map(str::trim).collect();
    let is_name = |name: &&str| {
        let mut letters = name.chars();
        letters.next().is_some_and(char::is_alphabetic)
            && letters.all(|c| c.is_alphanumeric() || c == '_')
    };
    names.iter().all(is_name).then_some((names, set.trim()))
}

/// The declaration of a symbol with this set.
fn symbol(set: &str) -> Value {
    let mut declaration = Table::new();
    let mut insert = |key: &str, value: Value| declaration.insert(key.to_owned(), value);
    let dimension = |count: &str| {
        let count = count.trim();
        count.parse().map_or_else(|_| text(count), Value::Integer)
    };
    if let Some(count) = set.strip_prefix("vector ") {
        insert("vector", dimension(count));
    } else if let Some(count) = set.strip_prefix("function ") {
        insert("function", dimension(count));
    } else if set.starts_with(['[', '(']) {
        insert("in", text(set));
    } else if let Some((low, high)) = set.split_once("..") {
        let (low, high) = (low.trim(), high.trim());
        let range = match (low.is_empty(), high.is_empty()) {
            (false, true) => format!(">= {low}"),
            (true, false) => format!("<= {high}"),
            _ => format!("{low}..{high}"),
        };
        insert("integer", text(&range));
    } else {
        // Not a known form: leave it to the loader to report.
        insert("in", text(set));
    }
    Value::Table(declaration)
}

/// The parameters of a head `H(t)`.
fn parameters(head: &str) -> Vec<String> {
    let Some((_, rest)) = head.split_once(['(', '[']) else {
        return vec![];
    };
    let names = rest.trim_end_matches([')', ']']).split(',');
    names.map(|name| name.trim().to_owned()).collect()
}

/// Collects the names that stand for numbers, except the bound variables of sums and products, and functions that are
/// applied. The variable of an integral is a declared symbol, like that of a derivative.
fn free_numbers(formula: &Expr, bound: &[String], found: &mut BTreeSet<String>) {
    match &formula.node {
        Node::Name(name) => {
            let name = name.trim_end_matches('\'');
            if name != "pi" && !bound.iter().any(|other| other == name) {
                found.insert(name.to_owned());
            }
        }
        Node::Call(head, arguments) => {
            let called = match &head.node {
                Node::Name(name) => name.as_str(),
                _ => {
                    free_numbers(head, bound, found);
                    ""
                }
            };
            let binder = match called {
                "sum" | "product" => arguments.first(),
                _ => None,
            };
            let mut inner = bound.to_vec();
            if let Some(Node::Name(index)) = binder.map(|index| &index.node) {
                inner.push(index.clone());
            }
            for argument in arguments {
                free_numbers(argument, &inner, found);
            }
        }
        Node::Index(indexed, indices) => {
            // The name of a family or a vector is declared.
            if !matches!(indexed.node, Node::Name(_)) {
                free_numbers(indexed, bound, found);
            }
            for index in indices {
                free_numbers(index, bound, found);
            }
        }
        _ => {
            for part in formula.parts() {
                free_numbers(part, bound, found);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(states: &str, setting: &str) -> Vec<String> {
        Setting::read(setting)
            .undeclared(states)
            .into_iter()
            .collect()
    }

    #[test]
    fn what_is_used_as_a_number_and_not_declared_is_a_number() {
        assert_eq!(names("sin(x)^2 + cos(x)^2 == 1", ""), ["x"]);
        assert_eq!(names("sum(i, 0, n, q^i) == 1", "n in 0.."), ["q"]);
        assert_eq!(names("transpose([[a, b]])[2, 1] == p[1]", ""), ["a", "b"]);
        assert_eq!(names("H(1) == a", "H(t) := t*b"), ["a", "b"]);
        assert_eq!(
            names("integral(t^2, t, 0, c) == pi", "x in [a, 1]; y > 0"),
            ["a", "c", "t", "y"]
        );
    }

    #[test]
    fn a_setting_declares_sets_functions_and_hypotheses() {
        let paper = question(
            "D(f(x), x) == D(f(x), x) and n >= 0",
            "x in [0, 1]; n in 0..; f: function 1; p, q: vector 3; x > 1/2",
        );
        let claim = &paper.unwrap().claims[0];
        assert_eq!(claim.assumptions.len(), 1);
        for name in ["x", "n", "p", "q"] {
            assert!(claim.declarations.symbol(name).is_some(), "{name}");
        }
    }

    #[test]
    fn what_is_wrong_in_it_is_an_error_with_its_place() {
        for (states, setting) in [
            ("x ==", ""),
            ("x == 1", "x in somewhere"),
            ("x == 1", "y >"),
            ("\"", "x := ;"),
        ] {
            assert!(question(states, setting).is_err(), "{states} | {setting}");
        }
    }
}
