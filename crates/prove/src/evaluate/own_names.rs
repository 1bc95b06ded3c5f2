//! The names that the engine gives to symbols of its own, and texts without what tells them apart.

/// The sign that no text can write in a name.
const MARK: char = '\u{b0}';

/// The name of a symbol that nothing else has: the name in the text, and a number.
pub(super) fn numbered(name: &str, number: u64) -> String {
    format!("{name}{MARK}{number}")
}

/// The name of the variable of a derivative inside so many others.
pub(super) fn differential(name: &str, enclosing: u32) -> String {
    format!("{name}{MARK}'{enclosing}")
}

/// A text with the names that the statement has.
pub(super) fn in_words(text: &str) -> String {
    let mut parts = text.split(MARK);
    let first = parts.next().unwrap_or_default();
    let rest = parts.map(|part| {
        let number = part.strip_prefix('\'').unwrap_or(part);
        number.trim_start_matches(|c: char| c.is_ascii_digit())
    });
    std::iter::once(first).chain(rest).collect()
}

#[cfg(test)]
mod tests {
    use super::{differential, in_words, numbered};

    #[test]
    fn what_is_said_has_the_names_of_the_statement() {
        let text = format!("{}^2 + {}*y1'", differential("x", 0), numbered("n", 12));
        assert_eq!(in_words(&text), "x^2 + n*y1'");
    }
}
