//! How names such as `mu_1`, `Q2`, `H''` are displayed.
//!
//! One generic rule without special cases: trailing digits and the parts after underscores are subscripts, names of
//! Greek letters become Greek letters, other words are set upright.

use crate::greek::{self, GreekLetter};

/// Functions that both Typst and LaTeX know and set upright.
const FUNCTIONS: [&str; 17] = [
    "sin", "cos", "tan", "cot", "sec", "arcsin", "arccos", "arctan", "exp", "log", "ln", "min",
    "max", "det", "sinh", "cosh", "tanh",
];

/// A name split into stem, subscripts and primes.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Name<'a> {
    /// The part that carries the subscripts.
    pub stem: &'a str,
    /// The trailing digits of the stem, then the parts after underscores.
    pub subscripts: Vec<&'a str>,
    /// The number of primes.
    pub primes: usize,
}

/// How a single word is displayed in mathematics.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Word<'a> {
    /// One letter, or digits: set as it is.
    Plain(&'a str),
    /// A Greek letter.
    Greek(GreekLetter),
    /// The name of a function that the typesetting languages know.
    Function(&'a str),
    /// A word, set upright.
    Text(&'a str),
}

impl<'a> Name<'a> {
    /// Splits a name.
    pub fn new(name: &'a str) -> Self {
        let body = name.trim_end_matches('\'');
        let primes = name.len() - body.len();
        let mut parts = body.split('_');
        let first = parts.next().unwrap_or(body);
        let stem = first.trim_end_matches(|c: char| c.is_ascii_digit());
        if stem.is_empty() {
            return Self {
                stem: body,
                subscripts: vec![],
                primes,
            };
        }
        let digits = first.get(stem.len()..).unwrap_or("");
        let subscripts = std::iter::once(digits)
            .chain(parts)
            .filter(|part| !part.is_empty())
            .collect();
        Self {
            stem,
            subscripts,
            primes,
        }
    }
}

impl<'a> Word<'a> {
    /// Classifies a word.
    pub fn new(word: &'a str) -> Self {
        if let Some(letter) = greek::by_name(word) {
            Self::Greek(letter)
        } else if FUNCTIONS.contains(&word) {
            Self::Function(word)
        } else if word.chars().count() == 1 || word.chars().all(|c| c.is_ascii_digit()) {
            Self::Plain(word)
        } else {
            Self::Text(word)
        }
    }
}

/// The name as an identifier of a programming language: primes become `_d1`, `_d2`, ..., and a reserved word gets a
/// trailing underscore.
pub(super) fn identifier(name: &str, reserved: &[&str]) -> String {
    let body = name.trim_end_matches('\'');
    match name.len() - body.len() {
        0 if reserved.contains(&name) => format!("{name}_"),
        0 => name.to_owned(),
        primes => format!("{body}_d{primes}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn digits_and_underscores_become_subscripts_and_primes_are_counted() {
        let mu = Name {
            stem: "mu",
            subscripts: vec!["1"],
            primes: 2,
        };
        assert_eq!(Name::new("mu1''"), mu);
        assert_eq!(Name::new("p0_u").subscripts, ["0", "u"]);
        assert_eq!(Name::new("p0u").stem, "p0u");
        assert_eq!(Name::new("_x").stem, "_x");
    }

    #[test]
    fn reserved_words_and_primes_make_safe_identifiers() {
        assert_eq!(identifier("lambda", &["lambda"]), "lambda_");
        assert_eq!(identifier("H''", &[]), "H_d2");
    }
}
