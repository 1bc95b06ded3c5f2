//! What the letter e stands for: the base of the exponential function, or a number of the text.
//!
//! | in the formulas of one text | e is |
//! |---|---|
//! | with exponents that have letters, or behind `\ln`, and nowhere without an exponent | the base |
//! | defined, `e = ...`, or in a set, `e \in (0, 1)` | a number of the text |
//! | without an exponent or with digits alone for exponents, and never with other exponents | a number of the text |
//! | both, or with digits alone for exponents wherever it stands | either: two readings |

use super::item::{Nucleus, TexFace, TexItem};

/// How the letter e stands in the formulas of one text.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct BaseUses {
    /// With an exponent that has a letter, or behind a logarithm.
    as_base: bool,
    /// With an exponent of digits.
    as_power: bool,
    /// Without an exponent.
    alone: bool,
    /// On the left of `=` or `\in`.
    is_given: bool,
}

/// What a text says of the letter e.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum BaseLetter {
    /// It is the base of the exponential function.
    Base,
    /// It is a number of the text.
    Number,
    /// Nothing says which of both.
    Open,
}

/// Whether an item is the letter e, italic or upright, without subscript and prime.
pub(super) fn is_letter_e(item: &TexItem) -> bool {
    let Nucleus::Letter(letters, face) = &item.nucleus else {
        return false;
    };
    let is_plain = match face {
        TexFace::Plain => true,
        TexFace::Other(face) => face == "mathrm",
        _ => false,
    };
    letters == "e" && is_plain && item.below.is_none() && item.primes == 0
}

fn has_letter(list: &[TexItem]) -> bool {
    list.iter().any(|item| {
        matches!(
            item.nucleus,
            Nucleus::Letter(..) | Nucleus::Operator(_) | Nucleus::Big(_)
        ) || item.lists().into_iter().any(has_letter)
    })
}

impl BaseUses {
    /// Notes the letter where it stands in a list.
    pub(super) fn add(&mut self, item: &TexItem, before: Option<&TexItem>, next: Option<&TexItem>) {
        match item.above.as_deref() {
            Some(exponent) if has_letter(exponent) => self.as_base = true,
            Some(_) => self.as_power = true,
            None => self.alone = true,
        }
        let is_logarithm = |item: &TexItem| matches!(&item.nucleus, Nucleus::Operator(name) if matches!(name.as_str(), "ln" | "log"));
        self.as_base |= before.is_some_and(is_logarithm);
        let starts = before.is_none_or(|before| {
            before.is_sign(",")
                || before.is_sign("quad")
                || before.is_sign(";")
                || matches!(before.nucleus, Nucleus::Words(_))
        });
        self.is_given |= starts
            && item.above.is_none()
            && next
                .is_some_and(|next| next.is_sign("=") || next.is_sign(":=") || next.is_sign("in"));
    }

    /// What the letter is, where the text has it.
    pub(super) fn letter(self) -> BaseLetter {
        match self {
            Self { is_given: true, .. } => BaseLetter::Number,
            Self {
                as_base: true,
                as_power: _,
                alone: false,
                ..
            } => BaseLetter::Base,
            Self { as_base: true, .. } => BaseLetter::Open,
            Self {
                as_power: true,
                alone: false,
                ..
            } => BaseLetter::Open,
            _ => BaseLetter::Number,
        }
    }
}
