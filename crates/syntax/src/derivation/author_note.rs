//! The author's note on a claim: a sentence about the finding, with formulas in braces that are evaluated.
//!
//! Numbers that can be computed are not typed: in `'the two planes meet at {cosine : degrees}'` the number is
//! computed from the definitions of the claim, at the witness if there is one. Braces between dollar signs belong to
//! mathematics.

use super::error::{DerivationError, LoadError};
use super::schema::Text;
use super::source::{Origin, Source};
use super::written::Written;
use crate::formula::{Place, parse};
use std::sync::Arc;

/// A sentence in which formulas (holes) are replaced by their values.
#[derive(Debug, Clone)]
pub struct AuthorNote {
    /// Words and holes, in order.
    pub pieces: Vec<Piece>,
}

impl AuthorNote {
    /// The formulas of the holes.
    pub fn holes(&self) -> impl Iterator<Item = &Written> {
        self.pieces.iter().filter_map(|piece| match piece {
            Piece::Words(_) => None,
            Piece::Hole(formula, _) => Some(formula),
        })
    }
}

impl AuthorNote {
    /// The sentence as a text, or `None` if it has holes.
    #[must_use]
    pub fn without_holes(&self) -> Option<String> {
        let words = self.pieces.iter().map(|piece| match piece {
            Piece::Words(words) => Some(words.as_str()),
            Piece::Hole(..) => None,
        });
        words.collect()
    }
}

/// A part of an author's note.
#[derive(Debug, Clone)]
pub enum Piece {
    /// Words, with mathematics between dollar signs.
    Words(String),
    /// A formula whose value is shown, and the format of the number.
    Hole(Written, Form),
}

/// The format of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// An integer or simple fraction as it is, other numbers with four digits.
    Plain,
    /// A decimal with this many significant digits.
    Digits(u8),
    /// A percentage.
    Percent,
    /// The number is a cosine; its angle is shown in degrees.
    Degrees,
}

/// The largest number of digits of a hole.
const MAX_DIGITS: u8 = 30;

/// Reads an author's note.
pub(super) fn author_note(source: &Arc<Source>, text: &Text) -> Result<AuthorNote, LoadError> {
    let origin = Origin::from_spanned(source, text);
    let wrong = |start: usize, end: usize, message: String| {
        let error = DerivationError::at(&origin, Place { start, end }, message)
            .with_help("a hole is `{formula}`, `{formula : 3}` for three digits, `{formula : percent}` or `{cosine : degrees}`; braces between dollar signs are mathematics");
        LoadError::Derivation(Box::new(error))
    };
    let text = text.get_ref();
    let (mut pieces, mut words, mut mathematics) = (vec![], String::new(), false);
    let mut position = 0;
    while let Some(next) = text.get(position..).and_then(|rest| rest.chars().next()) {
        mathematics ^= next == '$';
        if mathematics || !matches!(next, '{' | '}') {
            words.push(next);
            position += next.len_utf8();
            continue;
        }
        let rest = text.get(position + 1..).unwrap_or("");
        let end = rest.find('}').filter(|_| next == '{');
        let Some(inside) = end.and_then(|end| rest.get(..end)) else {
            let message = format!("this `{next}` is not matched");
            return Err(wrong(position, position + 1, message));
        };
        let (formula, form) = inside.split_once(':').unwrap_or((inside, ""));
        let start = position + 1;
        let origin = origin.clone().after(start);
        let expr = parse(formula).map_err(|error| {
            LoadError::Derivation(Box::new(DerivationError::syntax(&origin, &error)))
        })?;
        let form = read_form(form).ok_or_else(|| {
            let message = format!("`{}` is not a format of a number", form.trim());
            wrong(start + formula.len() + 1, start + inside.len(), message)
        })?;
        pieces.push(Piece::Words(std::mem::take(&mut words)));
        pieces.push(Piece::Hole(Written { expr, origin }, form));
        position = start + inside.len() + 1;
    }
    if mathematics {
        let last = text.rfind('$').unwrap_or(0);
        return Err(wrong(last, last + 1, "this `$` is not matched".to_owned()));
    }
    pieces.push(Piece::Words(words));
    pieces.retain(|piece| !matches!(piece, Piece::Words(words) if words.is_empty()));
    Ok(AuthorNote { pieces })
}

fn read_form(text: &str) -> Option<Form> {
    match text.trim() {
        "" => Some(Form::Plain),
        "percent" => Some(Form::Percent),
        "degrees" => Some(Form::Degrees),
        digits => {
            let digits = digits.parse().ok();
            digits
                .filter(|n| (1..=MAX_DIGITS).contains(n))
                .map(Form::Digits)
        }
    }
}
