//! The names of a claim as the paper prints them.
//!
//! A file gives the printed form of a name between dollar signs, `$\mathbf{p}_0^u$`; other names follow the rule of
//! [`super::letters`].

use super::letters::{by_rule, greek_letter, is_function};
use super::markup;
use super::node::{Face, Node};
use std::collections::{BTreeMap, BTreeSet};
use torse_verdicts::dependencies::Dependencies;
use torse_verdicts::outcome::Outcome;

/// The sign in a printed name where its index belongs: `$Q_{\cdot,1}$`.
pub(super) const PLACE: char = '⋅';

/// The names of a claim, and their printed forms.
#[derive(Debug, Clone, Default)]
pub(crate) struct Names {
    printed: BTreeMap<String, Node>,
    known: BTreeSet<String>,
    /// The letters that the paper prints bold.
    vectors: BTreeSet<char>,
}

impl Names {
    /// Collects the names of a claim and of its readings.
    pub(crate) fn new(outcome: &Outcome) -> Self {
        let mut names = Names::default();
        names.add(&outcome.claim.table);
        for reading in outcome.readings() {
            names.add(&reading.outcome.claim.table);
        }
        names
    }

    /// Whether all names of a formula are the paper's: a file gives their printed forms, or they are single letters,
    /// with an index of one digit or none.
    pub(crate) fn are_of_the_paper(&self, formula: &str) -> bool {
        let word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '\'');
        let mut words = formula
            .split(|c| !word(c))
            .filter(|name| name.starts_with(char::is_alphabetic));
        words.all(|name| {
            let stem = name.trim_end_matches('\'');
            let letter = stem.trim_end_matches(|c: char| c.is_ascii_digit());
            let index = stem.len() - letter.len();
            if stem.starts_with("printed") {
                return false;
            }
            let simple = letter.chars().count() == 1 || greek_letter(letter).is_some();
            self.printed.contains_key(stem)
                || self.printed.contains_key(name)
                || is_function(stem)
                || (simple && index <= 1)
                || matches!(
                    stem,
                    "sum" | "binom" | "D" | "sqrt" | "and" | "det" | "cross" | "dot" | "pi"
                )
        })
    }

    /// Adds the names of another claim; if both have a name, this claim's form is kept.
    pub(crate) fn extend(&mut self, others: Names) {
        for (name, node) in others.printed {
            self.printed.entry(name).or_insert(node);
        }
        self.known.extend(others.known);
        self.vectors.extend(others.vectors);
    }

    /// A typed formula, in which no letter has a face, with the paper's vectors bold.
    pub(super) fn with_vectors(&self, node: Node) -> Node {
        match self.vectors.is_empty() {
            true => node,
            false => node.with_bold(&self.vectors),
        }
    }

    fn add(&mut self, table: &Dependencies) {
        self.vectors.extend(&table.bold);
        let symbols = table.symbols.iter().map(|s| (s.name.as_str(), &s.display));
        let definitions = table.definitions.iter();
        let definitions = definitions.map(|d| (d.head.text.as_str(), &d.display));
        let bases = table
            .bases
            .iter()
            .map(|b| (b.head.text.as_str(), &b.display));
        for (head, display) in symbols.chain(definitions).chain(bases) {
            let name = head.split(['(', '[']).next().unwrap_or(head);
            self.known.insert(name.to_owned());
            if let Some(node) = display.as_deref().and_then(markup::dollars) {
                self.printed.insert(name.to_owned(), node);
            }
        }
    }

    /// Whether the claim has a symbol, function or family of this name, with any number of primes.
    pub(super) fn knows(&self, name: &str) -> bool {
        self.known.contains(name) || self.known.contains(name.trim_end_matches('\''))
    }

    /// Sets a name with its indices and this many further primes.
    pub(super) fn name(&self, name: &str, primes: usize, indices: Vec<Node>) -> Node {
        let stem = name.trim_end_matches('\'');
        let own = name.len() - stem.len();
        if let Some(node) = self.printed.get(name) {
            return decorated(node.clone(), primes, indices);
        }
        if let Some(node) = self.printed.get(stem) {
            return decorated(node.clone(), own + primes, indices);
        }
        decorated(by_rule(stem), own + primes, indices)
    }
}

/// Sets a printed name with indices and primes: indices go to the places reserved for them, then after its own
/// subscripts; primes and indices go before the arguments that a name may have, `a(x)`.
fn decorated(name: Node, primes: usize, mut indices: Vec<Node>) -> Node {
    let name = filled(name, &mut indices);
    if primes == 0 && indices.is_empty() {
        return name;
    }
    if let Node::Row(mut nodes) = name {
        return match nodes.last() {
            Some(Node::Fenced(..)) if nodes.len() == 2 => {
                let head = nodes.remove(0);
                Node::row([decorated(head, primes, indices)].into_iter().chain(nodes))
            }
            _ => decorated(Node::Row(nodes).round(), primes, indices),
        };
    }
    let (base, had, below, above) = match name {
        Node::Scripts {
            base,
            primes,
            below,
            above,
        } => (*base, primes, below.map(|b| *b), above.map(|b| *b)),
        other => (other, 0, None, None),
    };
    // A coordinate of a vector is not another vector: bold letters keep their brackets.
    if below.is_none() && !indices.is_empty() && matches!(base, Node::Letter(_, Face::Bold)) {
        let vector = base.scripted(had + primes, None, above).round();
        return vector.scripted(0, Some(Node::joined(indices, ',')), None);
    }
    let all = below.into_iter().chain(indices);
    let all: Vec<Node> = all.collect();
    let below = (!all.is_empty()).then(|| Node::joined(all, ','));
    base.scripted(had + primes, below, above)
}

/// Sets the name with indices at their reserved places.
fn filled(node: Node, indices: &mut Vec<Node>) -> Node {
    match node {
        Node::Sign(PLACE) if !indices.is_empty() => indices.remove(0),
        Node::Row(nodes) => Node::row(nodes.into_iter().map(|node| filled(node, indices))),
        Node::Scripts {
            base,
            primes,
            below,
            above,
        } => {
            let below = below.map(|node| Box::new(filled(*node, indices)));
            let above = above.map(|node| Box::new(filled(*node, indices)));
            Node::Scripts {
                base,
                primes,
                below,
                above,
            }
        }
        other => other,
    }
}
