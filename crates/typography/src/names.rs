//! The names of a claim as the paper prints them.
//!
//! A file gives the printed form of a name between dollar signs, `$\mathbf{p}_0^u$`; other names follow the rule of
//! [`crate::letters`].

use crate::letters::{by_rule, greek_letter, is_function};
use crate::markup;
use crate::math_box::{LetterFace, MathBox};
use std::collections::{BTreeMap, BTreeSet};

/// The sign in a printed name where its index belongs: `$Q_{\cdot,1}$`.
pub(crate) const PLACE: char = '⋅';

/// The names of a claim, and their printed forms.
#[derive(Debug, Clone, Default)]
pub struct PrintedNames {
    printed: BTreeMap<String, MathBox>,
    known: BTreeSet<String>,
    /// The letters that the paper prints bold.
    vectors: BTreeSet<char>,
    /// The letters that it does not: those of the components of a vector, for instance.
    light: BTreeSet<char>,
}

impl PrintedNames {
    /// Adds a name, or the head of a definition, with its printed form between dollar signs if there is one.
    pub fn declare(&mut self, head: &str, display: Option<&str>) {
        let name = head.split(['(', '[']).next().unwrap_or(head);
        self.known.insert(name.to_owned());
        if let Some(node) = display.and_then(markup::dollars) {
            self.light.extend(node.light_letter());
            self.printed.insert(name.to_owned(), node);
        }
    }

    /// Adds letters that the paper prints bold: those of vectors.
    pub fn print_bold(&mut self, letters: impl IntoIterator<Item = char>) {
        self.vectors.extend(letters);
    }

    /// Whether all names of a formula are the paper's: a file gives their printed forms, or they are single letters,
    /// with an index of one digit or none.
    pub fn are_of_the_paper(&self, formula: &str) -> bool {
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
    pub fn extend(&mut self, others: PrintedNames) {
        for (name, node) in others.printed {
            self.printed.entry(name).or_insert(node);
        }
        self.known.extend(others.known);
        self.vectors.extend(others.vectors);
        self.light.extend(others.light);
    }

    /// A typed formula, in which no letter has a face, with the paper's vectors bold.
    pub(crate) fn with_vectors(&self, node: MathBox) -> MathBox {
        let bold: BTreeSet<char> = self.vectors.difference(&self.light).copied().collect();
        match bold.is_empty() {
            true => node,
            false => node.with_bold(&bold),
        }
    }

    /// Whether the claim has a symbol, function or family of this name, with any number of primes.
    pub(crate) fn knows(&self, name: &str) -> bool {
        self.known.contains(name) || self.known.contains(name.trim_end_matches('\''))
    }

    /// Sets a name with its indices and this many further primes.
    pub(crate) fn name(&self, name: &str, primes: usize, indices: Vec<MathBox>) -> MathBox {
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
fn decorated(name: MathBox, primes: usize, mut indices: Vec<MathBox>) -> MathBox {
    let name = filled(name, &mut indices);
    if primes == 0 && indices.is_empty() {
        return name;
    }
    if let MathBox::Row(mut nodes) = name {
        return match nodes.last() {
            Some(MathBox::Fenced(..)) if nodes.len() == 2 => {
                let head = nodes.remove(0);
                MathBox::row([decorated(head, primes, indices)].into_iter().chain(nodes))
            }
            _ => decorated(MathBox::Row(nodes).round(), primes, indices),
        };
    }
    let (base, had, below, above) = match name {
        MathBox::Scripts {
            base,
            primes,
            below,
            above,
        } => (*base, primes, below.map(|b| *b), above.map(|b| *b)),
        other => (other, 0, None, None),
    };
    // A coordinate of a vector is not another vector: bold letters keep their brackets.
    if below.is_none()
        && !indices.is_empty()
        && matches!(base, MathBox::Letter(_, LetterFace::Bold))
    {
        let vector = base.scripted(had + primes, None, above).round();
        return vector.scripted(0, Some(MathBox::joined(indices, ',')), None);
    }
    let all = below.into_iter().chain(indices);
    let all: Vec<MathBox> = all.collect();
    let below = (!all.is_empty()).then(|| MathBox::joined(all, ','));
    base.scripted(had + primes, below, above)
}

/// Sets the name with indices at their reserved places.
fn filled(node: MathBox, indices: &mut Vec<MathBox>) -> MathBox {
    match node {
        MathBox::Sign(PLACE) if !indices.is_empty() => indices.remove(0),
        MathBox::Row(nodes) => MathBox::row(nodes.into_iter().map(|node| filled(node, indices))),
        MathBox::Scripts {
            base,
            primes,
            below,
            above,
        } => {
            let below = below.map(|node| Box::new(filled(*node, indices)));
            let above = above.map(|node| Box::new(filled(*node, indices)));
            MathBox::Scripts {
                base,
                primes,
                below,
                above,
            }
        }
        other => other,
    }
}
