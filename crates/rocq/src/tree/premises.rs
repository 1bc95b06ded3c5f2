//! What has to be true for a formula to have a value, collected in the order of the text.

use super::scope::words;
use crate::code::{Code, Level};
use std::collections::BTreeSet;

/// Premises, in the order of the text, none of them twice.
#[derive(Debug, Default)]
pub(super) struct Premises {
    found: Vec<Code>,
    /// The definitions that were looked into, with the texts that stood for what they depend on.
    pub opened: BTreeSet<(String, Vec<String>)>,
}

impl Premises {
    /// Adds one.
    pub fn add(&mut self, premise: Code) {
        if !self.found.contains(&premise) {
            self.found.push(premise);
        }
    }

    /// The premises.
    pub fn into_vec(self) -> Vec<Code> {
        self.found
    }
}

/// A comparison of numbers.
pub(super) fn relation(left: &Code, sign: &str, right: &Code) -> Code {
    let (left, right) = (left.within(Level::Sum), right.within(Level::Sum));
    Code::new(format!("{left} {sign} {right}"), Level::Relation)
}

/// The square of a difference.
pub(super) fn squared_difference(a: &Code, b: &Code) -> Code {
    let gap = Code::infix(a, "-", b, Level::Sum);
    Code::infix(&gap, "*", &gap, Level::Product)
}

/// A number is not zero.
pub(super) fn nonzero(code: &Code) -> Code {
    relation(code, "<>", &Code::atom("0"))
}

/// An integer without the mark of its scope, for a place in that scope.
pub(super) fn plain(code: &Code) -> String {
    let text = code.text();
    match text.strip_suffix("%Z") {
        Some(inner) => match inner.trim_start_matches('(').trim_end_matches(')') {
            number if number.chars().all(|c| c.is_ascii_digit()) => number.to_owned(),
            _ => inner.to_owned(),
        },
        None => text.to_owned(),
    }
}

/// A statement in the scope of integers.
pub(super) fn integers(text: String) -> Code {
    Code::atom(format!("({text})%Z"))
}

/// Whether a name occurs in a text.
pub(super) fn mentions(text: &str, name: &str) -> bool {
    words(text).any(|word| word == name)
}
