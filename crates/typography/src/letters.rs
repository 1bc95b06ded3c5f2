//! Sets names whose printed form no file gives, by one rule: trailing digits and the part after an underscore are
//! subscripts, Greek words are Greek letters, known functions and other words are upright.

use crate::math_box::MathBox;
use torse_syntax::greek;

/// Functions that typesetters know and set upright.
pub const FUNCTIONS: [&str; 16] = [
    "sin", "cos", "tan", "cot", "sec", "arcsin", "arccos", "arctan", "exp", "log", "ln", "min",
    "max", "sinh", "cosh", "tanh",
];

pub(crate) fn greek_letter(word: &str) -> Option<char> {
    greek::by_latex(word).map(|letter| letter.sign)
}

pub(crate) fn is_function(word: &str) -> bool {
    FUNCTIONS.contains(&word)
}

/// What a function of the language is called in print, if typesetters know it: `atan` is printed `arctan`.
pub(crate) fn printed_function(name: &str) -> Option<&str> {
    match name {
        "atan" => Some("arctan"),
        "asin" => Some("arcsin"),
        "acos" => Some("arccos"),
        _ => is_function(name).then_some(name),
    }
}

/// Sets a name whose printed form no file gives.
pub(crate) fn by_rule(name: &str) -> MathBox {
    let mut parts = name.split('_');
    let first = parts.next().unwrap_or(name);
    let stem = first.trim_end_matches(|c: char| c.is_ascii_digit());
    if stem.is_empty() {
        return word(name);
    }
    let digits = first.get(stem.len()..).unwrap_or_default();
    let below = std::iter::once(digits).chain(parts);
    let below: Vec<MathBox> = below.filter(|part| !part.is_empty()).map(word).collect();
    let below = (!below.is_empty()).then(|| MathBox::joined(below, ','));
    word(stem).scripted(0, below, None)
}

/// Sets a letter, a Greek letter, a number, a function or an upright word.
fn word(word: &str) -> MathBox {
    if let Some(letter) = greek_letter(word) {
        MathBox::italic(letter.encode_utf8(&mut [0; 4]))
    } else if is_function(word) || word == "det" {
        MathBox::Function(word.to_owned())
    } else if word.chars().all(|c| c.is_ascii_digit()) {
        MathBox::Number(word.to_owned())
    } else if word.chars().count() == 1 {
        MathBox::italic(word)
    } else {
        MathBox::word(word)
    }
}
