//! Flags excuses by a defective copy that no defect of a copy explains.

use super::{RaisedFlag, Subject, one_flag_for};
use torse_syntax::taxonomy::Flag;

/// Words for something other than a letter, a script or a factor.
const WORDS: [&str; 6] = [
    "sign",
    "plus",
    "minus",
    "inequality",
    "equation",
    "reference",
];

/// A sign, a relation or the number of an equation that the copy is said to have confused.
pub(super) fn unfounded_excuses(subject: &Subject<'_>) -> Vec<RaisedFlag> {
    let text = subject.claim.entry.garbled.as_ref();
    let text = text.map_or("", |text| text.get_ref());
    one_flag_for(
        Flag::GarbledExcuse,
        "no defect of a copy explains",
        confused_signs(text),
    )
}

/// Returns what in an excuse is neither of these.
fn confused_signs(text: &str) -> Vec<String> {
    let words = WORDS.iter().filter(|word| text.contains(*word));
    let mut list: Vec<String> = words.map(|word| (*word).to_owned()).collect();
    // "X for Y", where X or Y is a single sign.
    let tokens: Vec<&str> = text.split_whitespace().collect();
    let is_sign = |token: &&str| {
        matches!(
            *token,
            "+" | "-" | "−" | "<" | ">" | "≤" | "≥" | "=" | "<=" | ">="
        )
    };
    list.extend(
        tokens
            .iter()
            .filter(|token| is_sign(token))
            .map(|token| (*token).to_owned()),
    );
    // The number of an equation stands in parentheses, with a point: (3.6).
    let number = |part: &&str| {
        let digits = |c: char| c.is_ascii_digit();
        part.split_once('.').is_some_and(|(a, b)| {
            !a.is_empty() && !b.is_empty() && a.chars().all(digits) && b.chars().all(digits)
        })
    };
    let brackets = text
        .split('(')
        .skip(1)
        .filter_map(|rest| rest.split(')').next());
    list.extend(brackets.filter(number).map(|part| format!("({part})")));
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn letters_and_factors_are_excused_and_signs_and_numbers_of_equations_are_not() {
        for text in [
            "e for c",
            "q_1^u for q_0^u",
            "a lost k",
            "a comma lost between 2 and 400",
            "q for o, and a lost line",
        ] {
            assert_eq!(confused_signs(text), [""; 0], "{text}");
        }
        assert_eq!(confused_signs("+ for -"), ["+", "-"]);
        assert_eq!(confused_signs("(3.6) for (3.7)"), ["(3.6)", "(3.7)"]);
        assert_eq!(confused_signs("a minus that the copy lost"), ["minus"]);
    }
}
