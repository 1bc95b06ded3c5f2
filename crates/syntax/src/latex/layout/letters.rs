//! Single characters and letters.

use super::super::commands::{CommandKind, command_kind};
use super::super::error::LatexError;
use super::super::item::{Nucleus, TexFace, TexItem, look_alike};
use super::super::token::PlacedTex;
use crate::formula::Place;
use crate::greek;

pub(super) fn character(sign: char, place: Place) -> Result<Nucleus, LatexError> {
    let letter = |name: &str| Nucleus::Letter(name.to_owned(), TexFace::Plain);
    Ok(match sign {
        'a'..='z' | 'A'..='Z' => letter(&sign.to_string()),
        '+' | '-' | '*' | '/' | '=' | '<' | '>' | ',' | ';' | '.' | '!' | ':' => {
            Nucleus::Sign(sign.to_string())
        }
        '−' => Nucleus::Sign("-".to_owned()),
        '·' => Nucleus::Sign("cdot".to_owned()),
        '×' => Nucleus::Sign("times".to_owned()),
        '≤' => Nucleus::Sign("le".to_owned()),
        '≥' => Nucleus::Sign("ge".to_owned()),
        '≠' => Nucleus::Sign("ne".to_owned()),
        '…' => Nucleus::Dots,
        _ => match greek::by_sign(sign) {
            Some(found) => letter(found.name),
            None => {
                let message = format!("`{sign}` is not understood in a formula");
                return Err(LatexError::new(place, message));
            }
        },
    })
}

/// Refuses two forms of one Greek letter, `\phi` and `\varphi`, which have one name.
///
/// # Errors
/// [`LatexError`] at the second form.
pub fn one_form_of_each_letter(tokens: &[PlacedTex]) -> Result<(), LatexError> {
    let mut forms: Vec<(&str, &str)> = vec![];
    for token in tokens {
        let Some(form) = token.command() else {
            continue;
        };
        let CommandKind::Greek(letter) = command_kind(form) else {
            continue;
        };
        match forms.iter().find(|(other, _)| *other == letter) {
            Some((_, first)) if *first != form => {
                let message =
                    format!("`\\{first}` and `\\{form}` are two letters, and have one name here");
                return Err(LatexError::new(token.place, message));
            }
            Some(_) => {}
            None => forms.push((letter, form)),
        }
    }
    Ok(())
}

/// Whether a list is only this letter.
#[must_use]
pub fn is_letter(list: &[TexItem], letter: &str) -> bool {
    let plain =
        |face: TexFace| TexItem::new(Nucleus::Letter(letter.to_owned(), face), Place::default());
    look_alike(list, &[plain(TexFace::Plain)])
        || look_alike(list, &[plain(TexFace::Other("mathrm".to_owned()))])
}
