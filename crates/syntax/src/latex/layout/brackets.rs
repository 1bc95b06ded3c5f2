//! Brackets, fences of `\left` and `\right`, and bars.

use super::super::error::LatexError;
use super::super::item::{Nucleus, TexItem};
use super::super::token::{PlacedTex, TexToken};
use super::{Layout, Listed, Stop, is_operator};
use crate::formula::Place;

impl Layout<'_> {
    /// Lays out a list and takes what closes it.
    pub(super) fn closed(&mut self, stop: Stop, close: char, start: Place) -> Listed {
        let inner = self.list(stop)?;
        match self.take(close) {
            true => Ok(inner),
            false => Err(LatexError::new(start, "this bracket is never closed")),
        }
    }

    pub(super) fn closing(&mut self, start: Place, open: char) -> Result<char, LatexError> {
        let found = self.peek().map(|token| token.token.clone());
        let close = match found {
            Some(TexToken::Character(sign @ (')' | ']'))) => sign,
            Some(TexToken::Command(name)) if name == "}" => '}',
            Some(TexToken::Command(name)) if name == "rangle" => '⟩',
            Some(TexToken::Command(name)) if name == "rvert" => '|',
            Some(TexToken::Command(name)) if name == "rVert" => '‖',
            _ => return Err(LatexError::new(start, "this bracket is never closed")),
        };
        let fits = match open {
            '(' | '[' => matches!(close, ')' | ']'),
            '{' => close == '}',
            '⟨' => close == '⟩',
            other => close == other,
        };
        if !fits {
            return Err(LatexError::new(
                start.to(self.place()),
                "the brackets do not fit together",
            ));
        }
        self.next += 1;
        Ok(close)
    }

    /// Adds the items of a group in braces: braces of one item, or without scripts, are invisible.
    pub(super) fn group(&mut self, list: &mut Vec<TexItem>, mut inner: Vec<TexItem>, start: Place) {
        self.blanks();
        let scripted = self
            .peek()
            .is_some_and(|token| token.is('^') || token.is('_') || token.is('\''));
        match (inner.len(), scripted) {
            (0, true) => self.push(list, Nucleus::Group(vec![]), start),
            (1, true) if inner.first().is_some_and(TexItem::is_bare) => list.append(&mut inner),
            (_, true) => self.push(list, Nucleus::Group(inner), start),
            (_, false) => list.append(&mut inner),
        }
    }

    /// Lays out `\left( ... \right)`.
    pub(super) fn fence(
        &mut self,
        list: &mut Vec<TexItem>,
        place: Place,
    ) -> Result<(), LatexError> {
        let open = self.delimiter(place)?;
        let inner = self.list(Stop::Right)?;
        if self.peek().and_then(PlacedTex::command) != Some("right") {
            return Err(LatexError::new(place, "`\\left` has no `\\right`"));
        }
        self.next += 1;
        let close = self.delimiter(place)?;
        let inner_place = place;
        self.push(list, Nucleus::Fenced(open, inner, close), inner_place);
        Ok(())
    }

    pub(super) fn delimiter(&mut self, place: Place) -> Result<char, LatexError> {
        self.blanks();
        let sign = match self.peek().map(|token| &token.token) {
            Some(TexToken::Character(sign @ ('(' | ')' | '[' | ']' | '|' | '.'))) => *sign,
            Some(TexToken::Command(name)) => match name.as_str() {
                "{" | "lbrace" => '{',
                "}" | "rbrace" => '}',
                "|" | "Vert" | "lVert" | "rVert" => '‖',
                "vert" | "lvert" | "rvert" => '|',
                "langle" => '⟨',
                "rangle" => '⟩',
                "lbrack" => '[',
                "rbrack" => ']',
                _ => return Err(LatexError::new(place, "this bracket is not understood")),
            },
            _ => return Err(LatexError::new(place, "this bracket is not understood")),
        };
        self.next += 1;
        Ok(sign)
    }
}

/// Refuses bars that could be paired in another way: `|a|b|c|`.
pub(super) fn pairs_of_bars(list: &[TexItem]) -> Result<(), LatexError> {
    let bars = |item: &TexItem| matches!(item.nucleus, Nucleus::Fenced('|', _, '|'));
    let mut since: Option<usize> = None;
    for (at, item) in list.iter().enumerate() {
        if bars(item) {
            if let Some(before) = since {
                let between = list.get(before + 1..at).unwrap_or(&[]);
                // `|a| |b|` as well as `|a|b|c|`; signs between them settle it.
                if !between.iter().any(is_operator) && !between.is_empty() {
                    let error = LatexError::new(item.place, "the bars can be paired in two ways");
                    return Err(error.with_help("write `\\lvert` and `\\rvert`"));
                }
            }
            since = Some(at);
        }
    }
    Ok(())
}
