//! Words of a text, and the raw text of arguments.

use torse_syntax::latex::token::{PlacedTex, TexToken};

/// The text of tokens, braces left out.
pub fn plain(tokens: &[PlacedTex]) -> String {
    let mut text = String::new();
    for token in tokens {
        match &token.token {
            TexToken::Character('{' | '}') => {}
            TexToken::Character('~') => text.push(' '),
            TexToken::Character(sign) => text.push(*sign),
            TexToken::Command(name) => text.push_str(command_text(name)),
        }
    }
    tidy(&text)
}

/// The words that a command without mathematics stands for; none for most.
pub fn command_text(name: &str) -> &str {
    match name {
        "par" | " " | "," | ";" | "quad" | "qquad" | "\\" | "item" | "newline" => " ",
        "&" => "&",
        "%" => "%",
        "_" => "_",
        "#" => "#",
        "$" => "$",
        "{" => "{",
        "}" => "}",
        "ldots" | "dots" => "...",
        "ss" => "ß",
        "o" => "ø",
        "and" => ", ",
        "LaTeX" => "LaTeX",
        _ => "",
    }
}

/// One blank between words, none at the ends and before punctuation.
pub fn tidy(text: &str) -> String {
    let words = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let mut tidied = words;
    for sign in [",", ".", ";", ":"] {
        tidied = tidied.replace(&format!(" {sign}"), sign);
    }
    tidied.replace("``", "“").replace("''", "”")
}

/// LaTeX of tokens, as it could be typed again.
pub fn typed(tokens: &[PlacedTex]) -> String {
    let mut text = String::new();
    for (at, token) in tokens.iter().enumerate() {
        match &token.token {
            TexToken::Character(sign) => text.push(*sign),
            TexToken::Command(name) => {
                text.push('\\');
                text.push_str(name);
                let letter = matches!(tokens.get(at + 1).map(|next| &next.token), Some(TexToken::Character(next)) if next.is_ascii_alphabetic());
                if letter && name.ends_with(|c: char| c.is_ascii_alphabetic()) {
                    text.push(' ');
                }
            }
        }
    }
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
