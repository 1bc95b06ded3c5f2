//! Prints that read as something else than they say: names of functions without a backslash, mixed numbers, the imaginary unit.

use super::error::LatexError;
use super::item::{Nucleus, TexFace, TexItem};

/// Functions whose names are often typed as letters.
const TYPED: [&str; 12] = [
    "sin", "cos", "tan", "exp", "log", "sinh", "cosh", "tanh", "det", "max", "min", "sqrt",
];

/// Fails at the first print of this kind in a list, or in the lists within.
pub(super) fn no_suspects(items: &[TexItem]) -> Result<(), LatexError> {
    let is_index = binds(items, "i");
    suspects(items, is_index)
}

fn suspects(items: &[TexItem], is_index: bool) -> Result<(), LatexError> {
    for (at, item) in items.iter().enumerate() {
        let rest = items.get(at..).unwrap_or(&[]);
        if let Some(name) = typed_function(rest) {
            let error = LatexError::new(
                item.place,
                format!("the letters of `{name}` are a product here"),
            );
            return Err(error.with_help(format!("write `\\{name}`, or the product with `\\cdot`")));
        }
        if let [number, fraction, ..] = rest
            && is_mixed(number, fraction)
        {
            let error = LatexError::new(
                fraction.place,
                "a number before a fraction of numbers: a product, or a mixed number?",
            );
            return Err(error.with_help("write `\\cdot` or `+` between them"));
        }
        if !is_index && is_letter(item, "e") && item.above.as_deref().is_some_and(has_imaginary) {
            let error = LatexError::new(
                item.place,
                "`i` in an exponent of e may be the imaginary unit, and the language has real numbers alone",
            );
            return Err(
                error.with_help("state the real and the imaginary part, or write another letter")
            );
        }
        for list in item.lists() {
            suspects(list, is_index)?;
        }
    }
    Ok(())
}

fn is_letter(item: &TexItem, wanted: &str) -> bool {
    matches!(&item.nucleus, Nucleus::Letter(letter, TexFace::Plain) if letter == wanted)
}

/// The function whose name the letters before a bracket spell.
fn typed_function(rest: &[TexItem]) -> Option<&'static str> {
    TYPED.into_iter().find(|name| {
        let letters = name.chars().map(String::from);
        let spelled = letters
            .zip(rest)
            .filter(|(letter, item)| is_letter(item, letter) && item.is_bare());
        spelled.count() == name.len()
            && rest
                .get(name.len())
                .is_some_and(|next| matches!(next.nucleus, Nucleus::Fenced('(', ..)))
    })
}

fn is_mixed(number: &TexItem, fraction: &TexItem) -> bool {
    let is_number = |list: &[TexItem]| matches!(list, [one] if matches!(one.nucleus, Nucleus::Number(_)) && one.is_bare());
    matches!(number.nucleus, Nucleus::Number(_))
        && number.is_bare()
        && matches!(&fraction.nucleus, Nucleus::Fraction(over, under) if is_number(over) && is_number(under))
}

/// Whether the letter i is a factor of an exponent.
fn has_imaginary(above: &[TexItem]) -> bool {
    above.iter().any(|item| {
        is_letter(item, "i") && item.is_bare()
            || match &item.nucleus {
                Nucleus::Fraction(over, _) => has_imaginary(over),
                Nucleus::Fenced(_, inner, _) => has_imaginary(inner),
                _ => false,
            }
    })
}

/// Whether a letter is an index: of a sum, or in a subscript.
fn binds(items: &[TexItem], letter: &str) -> bool {
    items.iter().any(|item| {
        let below = item.below.as_deref().unwrap_or(&[]);
        below.iter().any(|item| is_letter(item, letter))
            || item.lists().into_iter().any(|list| binds(list, letter))
    })
}
