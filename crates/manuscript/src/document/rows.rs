//! Rows of displayed mathematics: which of them are one formula.

use super::arguments::without_labels;
use torse_syntax::latex::token::{PlacedTex, TexToken};
use torse_syntax::latex::{CommandKind, command_kind, is_relation_sign};

/// What the rows of an environment are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Rows {
    /// Lines of one formula.
    Lines,
    /// Aligned: a formula may have several.
    Aligned,
    /// Formulas each.
    EachAlone,
}

/// Whether a row goes on with the rows before it: it begins with a sign that asks for an operand on its left, they end with one
/// that asks for an operand on its right, or it has no relation, where rows are not formulas each.
pub(super) fn goes_on(before: &[Vec<PlacedTex>], row: &[PlacedTex], rows: Rows) -> bool {
    let row = significant(row);
    let (Some(first), Some(last)) = (
        row.first(),
        before.last().and_then(|before| significant(before).pop()),
    ) else {
        return false;
    };
    is_sign(first) || is_sign(&last) || rows != Rows::EachAlone && !row.iter().any(is_relation)
}

/// The tokens of rows that are one formula, with the signs between rows.
pub(super) fn joined(rows: &[Vec<PlacedTex>]) -> Vec<PlacedTex> {
    let mut tokens: Vec<PlacedTex> = vec![];
    for row in rows {
        if let Some(last) = tokens.last() {
            let end_of_row = PlacedTex {
                token: TexToken::Command("\\".to_owned()),
                place: last.place,
            };
            tokens.push(end_of_row);
        }
        tokens.extend(row.iter().cloned());
    }
    tokens
}

/// The tokens that are seen on paper, without spaces and braces.
fn significant(row: &[PlacedTex]) -> Vec<PlacedTex> {
    let is_seen = |token: &PlacedTex| match &token.token {
        TexToken::Character(sign) => !matches!(sign, ' ' | '~' | '&' | '{' | '}'),
        TexToken::Command(name) => {
            !matches!(command_kind(name), CommandKind::Ignored(_))
                && !matches!(name.as_str(), "quad" | "qquad")
        }
    };
    without_labels(row).into_iter().filter(is_seen).collect()
}

/// Whether a token asks for operands beside it.
fn is_sign(token: &PlacedTex) -> bool {
    match &token.token {
        TexToken::Character(sign) => matches!(sign, '+' | '-' | '*' | '/') || is_relation(token),
        TexToken::Command(name) => {
            is_relation(token)
                || matches!(
                    command_kind(name),
                    CommandKind::Sign("cdot" | "times" | "*" | "/" | "pm" | "mp")
                )
        }
    }
}

fn is_relation(token: &PlacedTex) -> bool {
    match &token.token {
        TexToken::Character(sign) => matches!(sign, '=' | '<' | '>'),
        TexToken::Command(name) => match command_kind(name) {
            CommandKind::Sign(sign) => {
                is_relation_sign(sign)
                    || matches!(sign, "to" | "implies" | "iff" | "sim" | "parallel" | "perp")
            }
            _ => false,
        },
    }
}
