//! The symbols of a proposal: every name that occurs and that no formula defines, with its set.
//!
//! A range is one that a formula of the text gives. A name in the bounds of a sum, in an index, a factorial, a binomial or an exponent is an
//! integer. Vectors and curves are of space; a function that no formula defines is any smooth function of one variable. Where the text says
//! nothing more, a comment asks.

use crate::meaning::{Meaning, Meanings};
use std::collections::{BTreeMap, BTreeSet};
use torse_syntax::formula::functions::is_function;
use torse_syntax::formula::{Expr, Node, Operator};
use torse_syntax::latex::{LatexCondition, LatexKind};
use torse_syntax::notation::text;

/// A declaration.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ProposedSymbol {
    /// The name.
    pub name: String,
    /// Its set, as an inline table.
    pub set: String,
    /// Where the set is from, or what to ask.
    pub comment: String,
}

/// How the names of formulas occur.
#[derive(Debug, Default)]
struct Occurrences {
    names: BTreeSet<String>,
    integers: BTreeSet<String>,
    /// The ranges of the indices of families, where each is the index of a sum.
    indices: BTreeMap<String, BTreeSet<Option<Vec<String>>>>,
    /// The indices of families that are numbers.
    numerals: BTreeMap<String, BTreeSet<Vec<String>>>,
}

/// The symbols of a manuscript, and the names of which none can be declared, each with the reason.
pub fn symbols(meanings: &Meanings) -> (Vec<ProposedSymbol>, BTreeMap<String, String>) {
    let mut found = Occurrences::default();
    for (head, body, _) in &meanings.definitions {
        let parameters = parameters(head);
        found.walk(
            body,
            &parameters
                .iter()
                .map(|name| (name.clone(), None))
                .collect::<Vec<_>>(),
        );
    }
    for (variable, functions) in meanings.bases.values() {
        found.names.insert(variable.clone());
        for body in functions.values() {
            found.walk(body, &[]);
        }
    }
    for meaning in &meanings.formulas {
        for formula in stated(meaning) {
            found.walk(formula, &[]);
        }
    }
    let defined: BTreeSet<String> = meanings
        .definitions
        .iter()
        .map(|(head, _, _)| head.split(['(', '[']).next().unwrap_or(head).to_owned())
        .collect();
    let mut symbols = vec![];
    let mut unknown = BTreeMap::new();
    let mut pending: Vec<String> = found.names.iter().cloned().collect();
    let mut done = BTreeSet::new();
    while let Some(name) = pending.pop() {
        let is_known = defined.contains(&name)
            || meanings.bases.contains_key(&name)
            || name == "pi"
            || is_function(&name);
        if is_known || !done.insert(name.clone()) {
            continue;
        }
        match declared(&name, meanings, &found) {
            Ok((symbol, more)) => {
                symbols.push(symbol);
                pending.extend(more);
            }
            Err(why) => {
                unknown.insert(name, why);
            }
        }
    }
    symbols.sort_by(|a, b| a.name.cmp(&b.name));
    (symbols, unknown)
}

/// The formulas that a meaning states, or may state.
pub fn stated(meaning: &Meaning) -> Vec<&Expr> {
    match meaning {
        Meaning::Defines {
            states, conditions, ..
        } => states
            .iter()
            .chain(conditions.iter().filter_map(formula_of))
            .collect(),
        Meaning::States {
            formula,
            conditions,
        } => std::iter::once(formula)
            .chain(conditions.iter().filter_map(formula_of))
            .collect(),
        Meaning::Ambiguous { first, others } => std::iter::once(&first.formula)
            .chain(others.iter().map(|(_, other)| &other.formula))
            .collect(),
        Meaning::Nothing | Meaning::Unread(_) => vec![],
    }
}

fn formula_of(condition: &LatexCondition) -> Option<&Expr> {
    match condition {
        LatexCondition::Formula(formula) => Some(formula),
        _ => None,
    }
}

fn parameters(head: &str) -> Vec<String> {
    let Some((_, inner)) = head.split_once(['(', '[']) else {
        return vec![];
    };
    inner
        .trim_end_matches([')', ']'])
        .split(", ")
        .map(str::to_owned)
        .collect()
}

/// The declaration of a name, and the names that it mentions.
fn declared(
    name: &str,
    meanings: &Meanings,
    found: &Occurrences,
) -> Result<(ProposedSymbol, Vec<String>), String> {
    let symbol = |set: String, comment: &str| ProposedSymbol {
        name: name.to_owned(),
        set,
        comment: comment.to_owned(),
    };
    let plain = |set: &str, comment: &str| Ok((symbol(set.to_owned(), comment), vec![]));
    match meanings.names.kind(name) {
        Some(LatexKind::Vector) => plain("{ vector = 3 }", "a vector of space, or `vector = 2`?"),
        Some(LatexKind::Matrix) => Err("it is a matrix that no formula defines".to_owned()),
        Some(LatexKind::Basis { .. }) => Err("not all of its functions are defined".to_owned()),
        Some(LatexKind::Open) => Err("it is a number or a function".to_owned()),
        Some(LatexKind::Function {
            parameters,
            is_vector,
        }) => match parameters.len() {
            1 => plain(
                if *is_vector {
                    "{ function = 3 }"
                } else {
                    "{ function = 1 }"
                },
                "any smooth function; if the text defines it, define it under [define]",
            ),
            count => Err(format!(
                "it is a function of {count} variables that no formula defines"
            )),
        },
        Some(LatexKind::Family { indices, is_vector }) => {
            let dimension = if *is_vector { 3 } else { 1 };
            let ranges = found.indices.get(name);
            let range = ranges
                .filter(|ranges| ranges.len() == 1)
                .and_then(|ranges| ranges.first().cloned().flatten())
                .filter(|ranges| {
                    found
                        .numerals
                        .get(name)
                        .is_none_or(|all| all.iter().all(|at| is_within(at, ranges)))
                });
            match range {
                Some(ranges) => {
                    let quoted = ranges
                        .iter()
                        .map(|range| format!("\"{range}\""))
                        .collect::<Vec<_>>()
                        .join(", ");
                    let set = format!("{{ family = {dimension}, indices = [{quoted}] }}");
                    Ok((symbol(set, "the bounds of the sum"), vec![]))
                }
                None if *indices == 1 => plain(
                    &format!("{{ family = {dimension} }}"),
                    "for which indices? `indices = [\"0..n\"]`",
                ),
                None => Err("the ranges of its indices are not given".to_owned()),
            }
        }
        Some(LatexKind::Number) | None => Ok(number(name, meanings, found)),
    }
}

/// Whether numbers are indices of these ranges, as far as the ends of these are numbers.
fn is_within(numerals: &[String], ranges: &[String]) -> bool {
    let fits = |(number, range): (&String, &String)| {
        let (Some((low, high)), Ok(number)) = (range.split_once(".."), number.parse::<u64>())
        else {
            return false;
        };
        match (low.parse::<u64>(), high.parse::<u64>()) {
            (Ok(low), Ok(high)) => (low..=high).contains(&number),
            // The first one is in every range that is not empty.
            (Ok(low), Err(_)) => number == low,
            _ => false,
        }
    };
    numerals.iter().zip(ranges).all(fits)
}

fn number(name: &str, meanings: &Meanings, found: &Occurrences) -> (ProposedSymbol, Vec<String>) {
    let symbol = |set: String, comment: String| ProposedSymbol {
        name: name.to_owned(),
        set,
        comment,
    };
    let is_integer = found.integers.contains(name);
    match meanings.ranges.get(name) {
        Some((LatexCondition::Integers { low, high, .. }, line)) => {
            let set = integers(low, high.as_ref());
            let more = low
                .names()
                .into_iter()
                .chain(high.iter().flat_map(Expr::names))
                .map(str::to_owned)
                .collect();
            (symbol(set, format!("line {line}")), more)
        }
        Some((LatexCondition::Interval { low, high, .. }, line)) if is_integer => {
            match (&low.0, &high.0) {
                (Some(least), Some(most)) => (
                    symbol(integers(least, Some(most)), format!("line {line}")),
                    vec![],
                ),
                (Some(least), None) => (
                    symbol(integers(least, None), format!("line {line}")),
                    vec![],
                ),
                _ => (
                    symbol(
                        "{ integer = \">= 0\" }".to_owned(),
                        "which integers?".to_owned(),
                    ),
                    vec![],
                ),
            }
        }
        Some((range @ LatexCondition::Interval { low, high, .. }, line)) => {
            let ends = low.0.iter().chain(&high.0);
            let more = ends.flat_map(Expr::names).map(str::to_owned).collect();
            (
                symbol(
                    format!("{{ in = \"{}\" }}", interval(range).unwrap_or_default()),
                    format!("line {line}"),
                ),
                more,
            )
        }
        _ if is_integer => (
            symbol(
                "{ integer = \">= 0\" }".to_owned(),
                "which integers? the text gives no range".to_owned(),
            ),
            vec![],
        ),
        _ => (
            symbol(
                "{}".to_owned(),
                "which numbers? the text gives no range".to_owned(),
            ),
            vec![],
        ),
    }
}

/// A range of integers as an inline table.
pub fn integers(low: &Expr, high: Option<&Expr>) -> String {
    match high {
        Some(high) => format!("{{ integer = \"{}..{}\" }}", text(low), text(high)),
        None => format!("{{ integer = \">= {}\" }}", text(low)),
    }
}

/// An interval as text.
pub fn interval(condition: &LatexCondition) -> Option<String> {
    let LatexCondition::Interval { low, high, .. } = condition else {
        return None;
    };
    let (open, below) = match low {
        (Some(low), closed) => (if *closed { "[" } else { "(" }, text(low)),
        (None, _) => ("(", "-inf".to_owned()),
    };
    let (above, close) = match high {
        (Some(high), closed) => (text(high), if *closed { "]" } else { ")" }),
        (None, _) => ("inf".to_owned(), ")"),
    };
    Some(format!("{open}{below}, {above}{close}"))
}

/// A bound name with its range, if it is the index of a sum.
type Bound = (String, Option<String>);

impl Occurrences {
    fn integers_of(&mut self, formula: &Expr, bound: &[Bound]) {
        for name in formula.names() {
            if !bound.iter().any(|(own, _)| own == name) && name != "pi" {
                self.integers.insert(name.to_owned());
            }
        }
    }

    fn walk(&mut self, formula: &Expr, bound: &[Bound]) {
        match &formula.node {
            Node::Name(name) => {
                if !bound.iter().any(|(own, _)| own == name) {
                    self.names.insert(name.trim_end_matches('\'').to_owned());
                }
            }
            Node::Call(head, arguments) => {
                let called = match &head.node {
                    Node::Name(name) => name.as_str(),
                    _ => "",
                };
                match (called, arguments.as_slice()) {
                    (
                        "sum" | "product",
                        [
                            Expr {
                                node: Node::Name(index),
                                ..
                            },
                            low,
                            high,
                            body,
                        ],
                    ) => {
                        for end in [low, high] {
                            self.walk(end, bound);
                            self.integers_of(end, bound);
                        }
                        let mut inner = bound.to_vec();
                        inner.push((
                            index.clone(),
                            Some(format!("{}..{}", text(low), text(high))),
                        ));
                        self.walk(body, &inner);
                        return;
                    }
                    ("binom", [n, k]) => {
                        self.integers_of(n, bound);
                        self.integers_of(k, bound);
                    }
                    ("factorial", [n]) => self.integers_of(n, bound),
                    _ => {}
                }
                self.walk(head, bound);
                for argument in arguments {
                    self.walk(argument, bound);
                }
            }
            Node::Index(head, indices) => {
                self.walk(head, bound);
                if let Node::Name(name) = &head.node {
                    let range = |index: &Expr| match &index.node {
                        Node::Name(name) => bound
                            .iter()
                            .rev()
                            .find(|(own, _)| own == name)
                            .and_then(|(_, range)| range.clone()),
                        _ => None,
                    };
                    if indices
                        .iter()
                        .all(|index| matches!(index.node, Node::Number { .. }))
                    {
                        let numerals = indices.iter().map(text).collect();
                        self.numerals
                            .entry(name.clone())
                            .or_default()
                            .insert(numerals);
                    } else {
                        let ranges = indices.iter().map(range).collect();
                        self.indices.entry(name.clone()).or_default().insert(ranges);
                    }
                }
                for index in indices {
                    self.walk(index, bound);
                    self.integers_of(index, bound);
                }
            }
            Node::Binary(Operator::Power, base, exponent) => {
                self.walk(base, bound);
                self.walk(exponent, bound);
                self.integers_of(exponent, bound);
            }
            _ => {
                for part in formula.parts() {
                    self.walk(part, bound);
                }
            }
        }
    }
}
