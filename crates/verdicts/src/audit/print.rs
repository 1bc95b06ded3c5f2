//! Reads numbers, names and relations off a printed sentence.

use std::collections::BTreeSet;
use torse_algebra::Rational;
use torse_syntax::formula::{Node, parse};
use torse_syntax::greek;

/// A printed sentence, taken apart.
#[derive(Debug, Default)]
pub struct Print {
    /// The numbers that stand for themselves. Excluded are numbers of references such as "Fig. 3" or "(5.16)", of names
    /// such as `a_3`, and the first numbers of enumerations such as "k = 0, 1, 2, ..., m".
    pub numbers: BTreeSet<Rational>,
    /// The same, with the numbers of names and enumerations.
    pub mentioned: BTreeSet<Rational>,
    /// The mathematical names: Greek letters in our spelling, and single Latin letters beside signs. Indices are left
    /// out, since they range over a family.
    pub names: BTreeSet<String>,
    /// The same, with all single Latin letters, some of which are words.
    pub letters: BTreeSet<String>,
    /// The number of relations outside enumerations.
    pub relations: usize,
    /// Equations.
    pub equal: bool,
    /// Signs of order.
    pub order: bool,
    /// Signs of membership, for example in an interval.
    pub range: bool,
    /// Signs of inequality.
    pub different: bool,
    /// The text in lower case.
    pub words: String,
}

/// Words before the number of a formula or figure.
const REFERENCES: [&str; 19] = [
    "eq.",
    "eqs.",
    "eq",
    "eqs",
    "fig.",
    "figs.",
    "figure",
    "figures",
    "theorem",
    "theorems",
    "sect.",
    "section",
    "definition",
    "example",
    "examples",
    "step",
    "equation",
    "equations",
    "table",
];

impl Print {
    /// Analyses a printed sentence.
    pub fn from_text(printed: &str) -> Self {
        let mut print = Self {
            words: printed.to_lowercase(),
            ..Self::default()
        };
        let letters: Vec<char> = printed.chars().collect();
        let mut last_word = String::new();
        let mut i = 0;
        while let Some(&c) = letters.get(i) {
            let rest = letters.get(i..).unwrap_or_default();
            if c.is_ascii_digit() {
                let length = number_length(rest);
                let text: String = rest.iter().take(length).collect();
                let before = i.checked_sub(1).and_then(|j| letters.get(j));
                if !REFERENCES.contains(&last_word.as_str())
                    && !reference(&letters, i, length)
                    && !ordinal(&letters, i, length)
                {
                    print.mentioned.extend(number(&text));
                    let dimension = matches!(rest.get(length..), Some(['D', ..] | ['-', 'd', ..]));
                    let named = dimension
                        || before.is_some_and(|c| c.is_alphabetic() || "_{'′".contains(*c));
                    if !named && !enumeration(&letters, i) {
                        print.numbers.extend(number(&text));
                    }
                }
                i += length;
                continue;
            }
            // A printed exponent, or part of a name such as C².
            let raised: String = rest.iter().map_while(|c| superscript(*c)).collect();
            if !raised.is_empty() {
                print.mentioned.extend(number(&raised));
                i += raised.len();
                last_word.clear();
                continue;
            }
            match c {
                // Half of `<=` or `>=`, which was counted, or of `!=`.
                '=' if matches!(
                    i.checked_sub(1).and_then(|j| letters.get(j)),
                    Some('<' | '>')
                ) => {}
                '=' if i.checked_sub(1).and_then(|j| letters.get(j)) == Some(&'!') => {
                    (print.relations, print.different) = (print.relations + 1, true);
                }
                '=' if !enumerates(rest) => {
                    (print.relations, print.equal) = (print.relations + 1, true);
                }
                '∈' => print.range = true,
                '<' | '>' | '≤' | '≥' | '⩽' | '⩾' | '≦' | '≧' | '≪' | '≫' => {
                    (print.relations, print.order) = (print.relations + 1, true);
                }
                '≠' => (print.relations, print.different) = (print.relations + 1, true),
                _ => {}
            }
            if let Some(name) = greek(c) {
                if !subscript(letters.get(..i).unwrap_or_default()) {
                    print.names.insert(name.to_owned());
                }
                print.letters.insert(name.to_owned());
            }
            if c.is_ascii_alphabetic() {
                let length = rest.iter().take_while(|c| c.is_alphabetic()).count();
                let word: String = rest.iter().take(length).collect();
                let after = rest.iter().skip(length).find(|c| **c != ' ');
                let near = letters.get(..i).unwrap_or_default();
                let before = near.iter().rev().find(|c| **c != ' ');
                let beside = |c: Option<&char>| c.is_some_and(|c| "_=<>+-−*/^(≤≥≠'′".contains(*c));
                let spelled = spells_a_letter(&word);
                if length == 1 || spelled {
                    print.letters.insert(word.clone());
                }
                let index = subscript(near) || enumerates_next(rest, length);
                if length == 1 && !index && (beside(after) || beside(before)) {
                    print.names.insert(word.clone());
                }
                let dot = rest.get(length) == Some(&'.');
                let joins = matches!(word.as_str(), "and" | "to");
                if !joins || !REFERENCES.contains(&last_word.as_str()) {
                    last_word = word.to_lowercase() + if dot { "." } else { "" };
                }
                i += length + usize::from(dot);
                continue;
            }
            if !c.is_whitespace() && !matches!(c, '(' | ')' | ',' | '-' | '–') {
                last_word.clear();
            }
            i += 1;
        }
        print
    }

    /// Whether one of these words, or a word with one of these beginnings, occurs.
    pub fn has_word_beginning_with(&self, beginnings: &[&str]) -> bool {
        let mut words = self.words.split(|c: char| !c.is_alphanumeric());
        words.any(|word| {
            beginnings
                .iter()
                .any(|beginning| word.starts_with(beginning))
        })
    }
}

/// Whether a number is the number of a formula: `(5.16)`, `(3.3a)`, `[7]`, or `(30)` after a blank.
fn reference(letters: &[char], start: usize, length: usize) -> bool {
    let before = |n: usize| start.checked_sub(n).and_then(|j| letters.get(j));
    let rest = letters.get(start + length..).unwrap_or_default();
    let lettered = rest.first().is_some_and(char::is_ascii_lowercase);
    let close = rest.get(usize::from(lettered));
    let number = letters.get(start..start + length).unwrap_or_default();
    match (before(1), close) {
        (Some('['), Some(']')) => true,
        (Some('('), Some(')')) => {
            let applied = before(2).is_some_and(|c| c.is_alphanumeric() || "'′]})".contains(*c));
            number.contains(&'.') || !applied
        }
        _ => false,
    }
}

/// Whether a number counts the steps of a list: `2. Consider ...`.
fn ordinal(letters: &[char], start: usize, length: usize) -> bool {
    let first = start
        .checked_sub(1)
        .is_none_or(|j| letters.get(j) == Some(&' '));
    let rest = letters.get(start + length..).unwrap_or_default();
    first && matches!(rest, ['.', ' ', next, ..] if next.is_uppercase())
}

/// Whether an index follows these letters: `i` after `R_` and after `R_{k,`.
fn subscript(before: &[char]) -> bool {
    match before {
        [.., '_'] => true,
        _ => {
            let open = before.iter().rposition(|c| *c == '{' || *c == '}');
            let braced = open.is_some_and(|i| before.get(i) == Some(&'{'));
            braced && open.is_some_and(|i| i > 0 && before.get(i - 1) == Some(&'_'))
        }
    }
}

/// Whether a list of values follows a name: `i = 0, 1, ..., k`.
fn enumerates_next(rest: &[char], length: usize) -> bool {
    let rest = rest.get(length..).unwrap_or_default();
    let blanks = rest.iter().take_while(|c| **c == ' ').count();
    let rest = rest.get(blanks..).unwrap_or_default();
    rest.first() == Some(&'=') && enumerates(rest)
}

/// Whether a list of integers follows an equals sign: `= 0, 1, ..., m`.
fn enumerates(rest: &[char]) -> bool {
    let mut rest = rest.iter().skip(1).skip_while(|c| **c == ' ').peekable();
    let mut digits = 0;
    while rest.peek().is_some_and(|c| c.is_ascii_digit()) {
        digits += 1;
        rest.next();
    }
    digits > 0 && rest.find(|c| **c != ' ') == Some(&',')
}

/// Whether a number stands in such a list.
fn enumeration(letters: &[char], start: usize) -> bool {
    let before = letters.get(..start).unwrap_or_default();
    let listed = |c: &char| c.is_ascii_digit() || matches!(c, ' ' | ',' | '.' | '…');
    let equals = before.iter().rposition(|c| !listed(c));
    let equals = equals.filter(|i| before.get(*i) == Some(&'='));
    equals.is_some_and(|i| enumerates(letters.get(i..).unwrap_or_default()))
}

fn number_length(rest: &[char]) -> usize {
    let digits = |from: usize| {
        let rest = rest.iter().skip(from);
        rest.take_while(|c| c.is_ascii_digit()).count()
    };
    let whole = digits(0);
    match rest.get(whole) {
        Some('.') if digits(whole + 1) > 0 => whole + 1 + digits(whole + 1),
        _ => whole,
    }
}

/// The value of digits.
fn number(text: &str) -> Option<Rational> {
    match parse(text).ok()?.node {
        Node::Number { value, .. } => Some(value),
        _ => None,
    }
}

/// Returns the digit that a superscript stands for.
fn superscript(c: char) -> Option<char> {
    let place = "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().position(|raised| raised == c)?;
    char::from_digit(u32::try_from(place).ok()?, 10)
}

/// Whether a word is our spelling of a Greek letter.
fn spells_a_letter(word: &str) -> bool {
    word != "pi" && greek::by_name(word).is_some()
}

/// Returns our spelling of a Greek letter.
fn greek(c: char) -> Option<&'static str> {
    // The number pi is not declared as a letter.
    let letter = greek::by_sign(c).filter(|letter| letter.name != "pi");
    letter.map(|letter| letter.name)
}

/// Returns the right side of a displayed definition: of `J(x; μ) = x φ + ψ` all but the left side.
pub fn explained(printed: &str) -> &str {
    let Some((name, _)) = printed.split_once('=') else {
        return printed;
    };
    let mut depth = 0_usize;
    let one_word = name.trim().chars().all(|c| {
        match c {
            '(' | '{' | '[' => depth += 1,
            ')' | '}' | ']' => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth > 0 || c != ' '
    });
    match one_word {
        true => printed.get(name.len()..).unwrap_or(printed),
        false => printed,
    }
}

/// Returns the stem of a name: `mu` of `mu1`, `E` of `E1_0`.
pub fn stem(name: &str) -> &str {
    let name = name.split_once('_').map_or(name, |(stem, _)| stem);
    name.trim_end_matches(|c: char| c.is_ascii_digit() || c == '\'')
}
