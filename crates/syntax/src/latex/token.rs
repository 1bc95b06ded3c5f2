//! The tokens of TeX with its usual category codes: control sequences and characters.
//!
//! A comment ends with its line and leaves nothing. Blanks are one token, [`TexToken::Character`] of a blank, since text
//! needs them; blanks behind a control word belong to it. An empty line is the control word `par`.

use crate::formula::Place;

/// The largest number of tokens that are read, of a formula or of a manuscript after its macros are expanded.
pub const MAX_TEX_TOKENS: usize = 400_000;

/// A token.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum TexToken {
    /// `\frac` is `frac`, `\,` is `,`.
    Command(String),
    /// Any other character; braces, `^`, `_` and `&` are characters too.
    Character(char),
}

/// A token with its place in the text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PlacedTex {
    /// The token.
    pub token: TexToken,
    /// Its place.
    pub place: Place,
}

impl PlacedTex {
    /// Whether this is the character.
    #[must_use]
    pub fn is(&self, sign: char) -> bool {
        self.token == TexToken::Character(sign)
    }

    /// The name of a control sequence.
    #[must_use]
    pub fn command(&self) -> Option<&str> {
        match &self.token {
            TexToken::Command(name) => Some(name),
            TexToken::Character(_) => None,
        }
    }
}

/// Splits a text into tokens; reads at most [`MAX_TEX_TOKENS`], and says whether that were all.
#[must_use]
pub fn tex_tokens(text: &str) -> (Vec<PlacedTex>, bool) {
    let mut found: Vec<PlacedTex> = vec![];
    let mut signs = text.char_indices().peekable();
    while let Some((start, sign)) = signs.next() {
        if found.len() >= MAX_TEX_TOKENS {
            return (found, false);
        }
        let mut end = start + sign.len_utf8();
        let token = match sign {
            '\\' => {
                let mut name = String::new();
                while let Some((at, letter)) = signs.next_if(|(_, c)| c.is_ascii_alphabetic()) {
                    name.push(letter);
                    end = at + 1;
                }
                if name.is_empty() {
                    if let Some((at, other)) = signs.next() {
                        name.push(other);
                        end = at + other.len_utf8();
                    }
                } else if let Some((at, star)) = signs.next_if(|(_, c)| *c == '*') {
                    // `\section*`, `\operatorname*`; in a formula the star is read again.
                    name.push(star);
                    end = at + 1;
                }
                TexToken::Command(name)
            }
            '%' => {
                while signs.next_if(|(_, c)| *c != '\n').is_some() {}
                signs.next();
                while signs.next_if(|(_, c)| matches!(c, ' ' | '\t')).is_some() {}
                continue;
            }
            c if c.is_whitespace() => {
                let mut lines = usize::from(c == '\n');
                while let Some((at, c)) = signs.next_if(|(_, c)| c.is_whitespace()) {
                    lines += usize::from(c == '\n');
                    end = at + c.len_utf8();
                }
                match lines {
                    0 | 1 => TexToken::Character(' '),
                    _ => TexToken::Command("par".to_owned()),
                }
            }
            other => TexToken::Character(other),
        };
        let place = Place { start, end };
        found.push(PlacedTex { token, place });
    }
    (found, true)
}
