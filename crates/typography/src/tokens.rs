//! Sentences cut into words, letters, numbers, signs and blanks, before it is seen which of them are formulas.

use crate::PrintedNames;
use crate::letters::{greek_letter, is_function};

/// A stretch of letters, of digits, of blanks, or one sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A word of a language, which is no mathematics.
    Word,
    /// What may be mathematics and may be a word: a single letter.
    Letter,
    /// What is mathematics wherever it stands.
    Sure,
    Number,
    /// `+`, `=` and the like: mathematics between mathematics.
    Operator,
    Open,
    Close,
    Comma,
    Blank,
}

/// A stretch of a text, and what it is.
pub(crate) struct Token<'a> {
    pub(crate) kind: Kind,
    pub(crate) text: &'a str,
}

/// The text in tokens, none left out.
pub(crate) fn tokens<'a>(text: &'a str, names: &PrintedNames) -> Vec<Token<'a>> {
    let mut tokens: Vec<Token<'a>> = Vec::new();
    let mut rest = text;
    let (mut angle, mut bar, mut quoted) = (false, Kind::Open, false);
    while let Some(first) = rest.chars().next() {
        let (mut length, mut kind) = next(rest, first, bar, names);
        let is_first = tokens
            .last()
            .is_none_or(|token| matches!(token.kind, Kind::Blank | Kind::Open));
        if first == '\'' && is_first && rest.get(1..).is_some_and(begins_with_letter) {
            quoted = true;
        } else if quoted && first.is_alphabetic() {
            // The quotation mark that closes is no prime.
            let word = rest.get(..length).unwrap_or_default();
            let ends = rest
                .get(length..)
                .is_none_or(|after| !begins_with_letter(after));
            if ends && let Some(unquoted) = word.strip_suffix('\'') {
                (length, quoted) = (unquoted.len(), false);
                kind = next(unquoted, first, bar, names).1;
            }
        }
        let abbreviated = ABBREVIATIONS.iter().find(|word| rest.starts_with(**word));
        if let (true, Some(word)) = (is_first, abbreviated) {
            (length, kind) = (word.len(), Kind::Word);
        } else if names_a_class(&tokens) && first.is_ascii_alphabetic() && length > 1 {
            kind = Kind::Word;
        }
        if first == '|' {
            bar = match bar {
                Kind::Open => Kind::Close,
                _ => Kind::Open,
            };
        }
        // Prints have vectors in angle brackets: `q = <1, 2, 3>`.
        let before = tokens.iter().rev().find(|token| token.kind != Kind::Blank);
        if length == 1
            && first == '<'
            && before.is_some_and(|token| token.text == "=")
            && rest.contains('>')
        {
            (kind, angle) = (Kind::Open, true);
        } else if length == 1 && first == '>' && angle {
            (kind, angle) = (Kind::Close, false);
        }
        if first.is_ascii_digit() && is_of_a_figure(&tokens) {
            let end = rest.find(|c: char| !c.is_ascii_alphanumeric());
            (length, kind) = (end.unwrap_or(rest.len()), Kind::Word);
        } else if first == '.' && is_between_blanks(rest, &tokens) {
            kind = Kind::Operator;
        }
        let (taken, after) = rest.split_at_checked(length).unwrap_or((rest, ""));
        tokens.push(Token { kind, text: taken });
        rest = after;
    }
    tokens
}

/// Words with full stops.
const ABBREVIATIONS: [&str; 2] = ["i.e.", "e.g."];

fn begins_with_letter(text: &str) -> bool {
    text.starts_with(char::is_alphanumeric)
}

/// Whether a class of smoothness stands right before: "beta" of "G2 beta continuity" is a word.
fn names_a_class(tokens: &[Token<'_>]) -> bool {
    match tokens {
        [.., class, blank] if blank.kind == Kind::Blank => {
            class.kind == Kind::Word
                && class.text.len() == 2
                && class.text.starts_with(['G', 'C'])
                && class.text.ends_with(|c: char| c.is_ascii_digit())
        }
        _ => false,
    }
}

/// Whether a number comes next that is one of a figure: `Fig. 5a`, `Figure (5b)`.
fn is_of_a_figure(tokens: &[Token<'_>]) -> bool {
    let words = tokens.iter().rev();
    let mut words = words.filter(|token| token.kind != Kind::Blank && token.kind != Kind::Open);
    let last = match words.next() {
        Some(token) if token.text == "." => words.next(),
        other => other,
    };
    last.is_some_and(|token| matches!(token.text, "Fig" | "Figs" | "Figure" | "Figures"))
}

/// Whether a dot between blanks stands behind an operand: prints write a scalar product so.
fn is_between_blanks(rest: &str, tokens: &[Token<'_>]) -> bool {
    let blank = |token: &Token<'_>| token.kind == Kind::Blank;
    let operand = |token: &Token<'_>| {
        matches!(
            token.kind,
            Kind::Letter | Kind::Sure | Kind::Number | Kind::Close
        )
    };
    match tokens {
        [.., before, last] => rest.starts_with(". ") && blank(last) && operand(before),
        _ => false,
    }
}

/// The length of the next token in bytes, and what it is; `bar` is what a bar is here, the first or the second of two.
fn next(rest: &str, first: char, bar: Kind, names: &PrintedNames) -> (usize, Kind) {
    let length = |keep: &dyn Fn(char) -> bool| rest.find(|c| !keep(c)).unwrap_or(rest.len());
    if first.is_whitespace() {
        return (length(&char::is_whitespace), Kind::Blank);
    }
    if first.is_ascii_digit() {
        let end = length(&|c| c.is_ascii_digit() || c == '.');
        let taken = rest.get(..end).unwrap_or_default();
        let dots = taken.len() - taken.trim_end_matches('.').len();
        let end = if dots == 3 { end } else { end - dots };
        return match rest.get(end..).and_then(|after| after.chars().next()) {
            // 3D, 2nd, but not 2Q_1
            Some(c) if c.is_alphabetic() && c.is_ascii() && !names.knows(&c.to_string()) => {
                let word = rest.get(end..).unwrap_or_default();
                let letters = word
                    .find(|c: char| !c.is_alphabetic())
                    .unwrap_or(word.len());
                match word.get(letters..).and_then(|after| after.chars().next()) {
                    Some('_' | '^' | '(' | '[') if letters == 1 => (end, Kind::Number),
                    _ => (end + letters, Kind::Word),
                }
            }
            Some('_' | '^') => scripted(rest, end, Kind::Number),
            _ => (end, Kind::Number),
        };
    }
    if first.is_alphabetic() {
        let end = length(&|c| {
            is_greek(c) == is_greek(first) && c.is_alphanumeric()
                || c.is_ascii_digit()
                || matches!(c, '\'' | '′' | '\u{302}' | '\u{303}')
        });
        let word = rest.get(..end).unwrap_or_default();
        let trimmed = word.trim_end_matches('\'');
        let after = rest.get(end..).and_then(|after| after.chars().next());
        let kind = match word {
            "sum" | "sqrt" | "binom" if matches!(after, Some('_' | '(')) => Kind::Sure,
            _ => kind_of(word, names),
        };
        return match after {
            Some('_' | '^' | '~') => scripted(rest, end, kind),
            _ if is_function(word) && !applied(rest.get(end..).unwrap_or_default()) => {
                (end, Kind::Word)
            }
            // A word of the sentence with an apostrophe or in quotation marks.
            _ if kind == Kind::Word => (trimmed.len().max(1), Kind::Word),
            // B-spline, G1-continuous
            Some('-') if hyphenated(rest.get(end..).unwrap_or_default()) && kind != Kind::Sure => {
                (end, Kind::Word)
            }
            _ => (end, kind),
        };
    }
    match first {
        '(' | '[' => (1, Kind::Open),
        '|' if bar == Kind::Close && rest.get(1..2) == Some("^") => {
            (scripted(rest, 1, Kind::Close).0, Kind::Close)
        }
        ')' | ']' => match rest.get(1..).and_then(|after| after.chars().next()) {
            Some('_' | '^') if balanced(rest.get(1..).unwrap_or_default()) => {
                let (end, _) = scripted(rest, 1, Kind::Close);
                (end, Kind::Close)
            }
            _ => (1, Kind::Close),
        },
        ',' | ';' => (1, Kind::Comma),
        '√' => (first.len_utf8(), Kind::Sure),
        '∞' | '∂' | '∑' => (first.len_utf8(), Kind::Sure),
        '=' | '<' | '>' | '!' if rest.starts_with([first]) && rest.get(1..2) == Some("=") => {
            (2, Kind::Operator)
        }
        '-' if rest.starts_with("->") => (2, Kind::Operator),
        '/' if rest.starts_with("//") || rest.starts_with("/\\") => (2, Kind::Operator),
        '|' => (1, bar),
        '+' | '-' | '−' | '*' | '/' | '^' | '=' | '<' | '>' | '≤' | '≥' | '≠' | '≈' | '·' | '×'
        | '∈' | '→' => (first.len_utf8(), Kind::Operator),
        '²' | '³' => (first.len_utf8(), Kind::Sure),
        _ => (first.len_utf8(), Kind::Word),
    }
}

fn is_greek(c: char) -> bool {
    ('Α'..='ω').contains(&c)
}

/// Whether an argument follows the name of a function: a bracket, a number or a single letter.
fn applied(rest: &str) -> bool {
    let mut letters = rest.trim_start_matches(' ').chars();
    match letters.next() {
        Some(c) if c.is_ascii_alphabetic() => !letters.next().is_some_and(char::is_alphabetic),
        Some(c) => c == '(' || c.is_ascii_digit() || is_greek(c),
        None => false,
    }
}

/// Whether a hyphen is followed by a word.
fn hyphenated(rest: &str) -> bool {
    let letters = rest.chars().skip(1).take_while(|c| c.is_alphabetic());
    letters.count() > 1
}

fn balanced(rest: &str) -> bool {
    !rest.starts_with(['_', '^'])
        || rest
            .chars()
            .nth(1)
            .is_some_and(|c| c.is_alphanumeric() || c == '{')
}

/// A token with scripts behind: `Q_{k,1}^2`.
fn scripted(rest: &str, end: usize, base: Kind) -> (usize, Kind) {
    let mut end = end;
    let mut any = false;
    // A tilde that is typed behind its letter.
    if rest
        .get(end..)
        .is_some_and(|after| after.starts_with("~^") || after.starts_with("~_"))
    {
        end += 1;
    }
    while let Some(after) = rest.get(end..) {
        let mut chars = after.chars();
        if !matches!(chars.next(), Some('_' | '^')) {
            break;
        }
        let inside = chars.as_str();
        let taken = match inside.chars().next() {
            Some('{') => match closing(inside) {
                Some(length) => length,
                None => break,
            },
            Some('(') if after.starts_with('^') => break,
            Some(c) if c.is_alphanumeric() => inside
                .find(|c: char| !c.is_alphanumeric())
                .unwrap_or(inside.len()),
            _ => break,
        };
        any = true;
        end += 1 + taken;
        // Primes may stand behind a script.
        let primes = rest.get(end..).unwrap_or_default();
        end += primes.len() - primes.trim_start_matches('\'').len();
    }
    match any {
        true => (end, Kind::Sure),
        false => (end, base),
    }
}

/// The length of a group in braces.
fn closing(group: &str) -> Option<usize> {
    let mut depth = 0_usize;
    for (position, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => {
                depth -= 1;
                if depth == 0 {
                    return Some(position + 1);
                }
            }
            _ => {}
        }
    }
    None
}

fn kind_of(word: &str, names: &PrintedNames) -> Kind {
    let stem = word.trim_end_matches(['\'', '′']);
    let letters = stem.trim_end_matches(|c: char| c.is_ascii_digit());
    let numbered = letters.len() < stem.len();
    let primed = stem.len() < word.len();
    let one = letters
        .chars()
        .filter(|c| !matches!(c, '\u{302}' | '\u{303}'))
        .count()
        == 1;
    let letter = greek_letter(letters).is_some() || (one && letters.chars().all(is_greek));
    if letter || is_function(word) {
        return Kind::Sure;
    }
    match one {
        // G2 and C1 are classes of smoothness, unless the claim has symbols of these names.
        true if numbered && matches!(letters, "G" | "C" | "D") && !names.knows(stem) => Kind::Word,
        true if numbered || primed => Kind::Sure,
        true => Kind::Letter,
        false
            if names.knows(word)
                && (numbered || primed || letters.len() <= 3)
                && letters != "to" =>
        {
            Kind::Sure
        }
        false => Kind::Word,
    }
}
