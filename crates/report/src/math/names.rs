//! The names of a claim as the paper prints them.
//!
//! A file says how a name is printed between dollar signs, `$\mathbf{p}_0^u$`; a name of which it says nothing is read by
//! one rule: trailing digits and what follows an underscore are subscripts, Greek words are Greek letters.

use super::markup;
use super::node::{Face, Node};
use std::collections::{BTreeMap, BTreeSet};
use torse_verdicts::outcome::Outcome;
use torse_verdicts::table::Table;

/// Greek letters by their names.
const GREEK: [(&str, &str); 34] = [
    ("alpha", "α"),
    ("beta", "β"),
    ("gamma", "γ"),
    ("delta", "δ"),
    ("epsilon", "ε"),
    ("zeta", "ζ"),
    ("eta", "η"),
    ("theta", "θ"),
    ("iota", "ι"),
    ("kappa", "κ"),
    ("lambda", "λ"),
    ("mu", "μ"),
    ("nu", "ν"),
    ("xi", "ξ"),
    ("pi", "π"),
    ("rho", "ρ"),
    ("sigma", "σ"),
    ("tau", "τ"),
    ("upsilon", "υ"),
    ("phi", "φ"),
    ("varphi", "φ"),
    ("chi", "χ"),
    ("psi", "ψ"),
    ("omega", "ω"),
    ("Gamma", "Γ"),
    ("Delta", "Δ"),
    ("Theta", "Θ"),
    ("Lambda", "Λ"),
    ("Xi", "Ξ"),
    ("Pi", "Π"),
    ("Sigma", "Σ"),
    ("Phi", "Φ"),
    ("Psi", "Ψ"),
    ("Omega", "Ω"),
];

/// Functions that typesetters know and set upright.
const FUNCTIONS: [&str; 13] = [
    "sin", "cos", "tan", "cot", "sec", "arcsin", "arccos", "arctan", "exp", "log", "ln", "min",
    "max",
];

/// The sign that stands in a printed name where its index belongs: `$Q_{\cdot,1}$`.
pub(super) const PLACE: char = '⋅';

pub(super) fn greek(word: &str) -> Option<&'static str> {
    let found = GREEK.iter().find(|(name, _)| *name == word);
    found.map(|(_, letter)| *letter)
}

pub(super) fn is_function(word: &str) -> bool {
    FUNCTIONS.contains(&word)
}

/// How the names of a claim are printed, and which names it has.
#[derive(Debug, Clone, Default)]
pub(crate) struct Names {
    printed: BTreeMap<String, Node>,
    known: BTreeSet<String>,
}

impl Names {
    /// The names of a claim and of its readings.
    pub(crate) fn of(outcome: &Outcome) -> Self {
        let mut names = Names::default();
        names.add(&outcome.table);
        for reading in &outcome.readings {
            names.add(&reading.outcome.table);
        }
        names
    }

    fn add(&mut self, table: &Table) {
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

    /// Whether the claim has a symbol, function or family of this name, whatever its primes.
    pub(super) fn knows(&self, name: &str) -> bool {
        self.known.contains(name) || self.known.contains(name.trim_end_matches('\''))
    }

    /// A name with its indices and as many primes more.
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

/// A name of which no file says how it is printed.
pub(super) fn by_rule(name: &str) -> Node {
    let mut parts = name.split('_');
    let first = parts.next().unwrap_or(name);
    let stem = first.trim_end_matches(|c: char| c.is_ascii_digit());
    if stem.is_empty() {
        return word(name);
    }
    let digits = first.get(stem.len()..).unwrap_or_default();
    let below = std::iter::once(digits).chain(parts);
    let below: Vec<Node> = below.filter(|part| !part.is_empty()).map(word).collect();
    decorated(word(stem), 0, below)
}

/// A letter, a Greek letter, a number, a function or an upright word.
fn word(word: &str) -> Node {
    if let Some(letter) = greek(word) {
        Node::italic(letter)
    } else if is_function(word) || word == "det" {
        Node::Function(word.to_owned())
    } else if word.chars().all(|c| c.is_ascii_digit()) {
        Node::Number(word.to_owned())
    } else if word.chars().count() == 1 {
        Node::italic(word)
    } else {
        Node::word(word)
    }
}

/// A printed name with indices and primes: indices go to the places that are kept for them, then behind its own
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
    // A coordinate of a vector is no other vector: bold letters keep their brackets.
    if below.is_none() && !indices.is_empty() && matches!(base, Node::Letter(_, Face::Bold)) {
        let vector = base.scripted(had + primes, None, above).round();
        return vector.scripted(0, Some(Node::joined(indices, ',')), None);
    }
    let all = below.into_iter().chain(indices);
    let all: Vec<Node> = all.collect();
    let below = (!all.is_empty()).then(|| Node::joined(all, ','));
    base.scripted(had + primes, below, above)
}

/// The name with indices at the places kept for them.
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
