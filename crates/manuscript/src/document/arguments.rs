//! Arguments, options and environments among the tokens of a manuscript.

use crate::macros::Unread;
use crate::words::plain;
use torse_syntax::latex::token::PlacedTex;

/// The largest number of tokens of an optional argument.
const MAX_OPTION: usize = 1_000;

/// Leaves out braces without a partner, and lists the first one.
pub(super) fn balanced(tokens: Vec<PlacedTex>) -> (Vec<PlacedTex>, Vec<Unread>) {
    let mut open: Vec<usize> = vec![];
    let mut alone: Vec<usize> = vec![];
    for (at, token) in tokens.iter().enumerate() {
        if token.is('{') {
            open.push(at);
        } else if token.is('}') && open.pop().is_none() {
            alone.push(at);
        }
    }
    alone.append(&mut open);
    alone.sort_unstable();
    let first = alone
        .first()
        .and_then(|at| tokens.get(*at))
        .map(|token| (token.place, "this brace has no partner".to_owned()));
    let mut next = alone.into_iter().peekable();
    let kept = tokens
        .into_iter()
        .enumerate()
        .filter(|(at, _)| next.next_if_eq(at).is_none());
    (
        kept.map(|(_, token)| token).collect(),
        first.into_iter().collect(),
    )
}

/// The argument in braces behind a position, and where it ends.
pub(super) fn argument(tokens: &[PlacedTex], mut at: usize) -> Option<(&[PlacedTex], usize)> {
    while tokens.get(at)?.is(' ') {
        at += 1;
    }
    if !tokens.get(at)?.is('{') {
        return None;
    }
    let (start, mut open) = (at + 1, 0_usize);
    for (end, token) in tokens.iter().enumerate().skip(at) {
        if token.is('{') {
            open += 1;
        } else if token.is('}') {
            open = open.saturating_sub(1);
            if open == 0 {
                return Some((tokens.get(start..end)?, end + 1));
            }
        }
    }
    None
}

/// The optional argument behind a position, and where it ends.
pub(super) fn option(tokens: &[PlacedTex], mut at: usize) -> Option<(&[PlacedTex], usize)> {
    while tokens.get(at)?.is(' ') {
        at += 1;
    }
    if !tokens.get(at)?.is('[') {
        return None;
    }
    let length = tokens
        .get(at..)?
        .iter()
        .take(MAX_OPTION)
        .position(|token| token.is(']'))?;
    Some((tokens.get(at + 1..at + length)?, at + length + 1))
}

/// A formula without labels, tags and their arguments, and without blanks at its ends.
pub(super) fn without_labels(tokens: &[PlacedTex]) -> Vec<PlacedTex> {
    let mut shown = vec![];
    let mut at = 0;
    while let Some(token) = tokens.get(at) {
        at += 1;
        match token.command() {
            Some("label" | "tag" | "tag*") => at = argument(tokens, at).map_or(at, |(_, end)| end),
            Some("nonumber" | "notag") => {}
            _ => shown.push(token.clone()),
        }
    }
    let blank = |token: &PlacedTex| token.is(' ') || token.command() == Some("par");
    while shown.last().is_some_and(blank) {
        shown.pop();
    }
    let start = shown
        .iter()
        .position(|token| !blank(token))
        .unwrap_or(shown.len());
    shown.split_off(start)
}

/// The position of the `\end` of an environment that began before `start`, and that behind it.
pub(super) fn end_of(tokens: &[PlacedTex], start: usize, name: &str) -> Option<(usize, usize)> {
    let mut open = 1_usize;
    for (at, token) in tokens.iter().enumerate().skip(start) {
        let (begins, ends) = (
            token.command() == Some("begin"),
            token.command() == Some("end"),
        );
        if !begins && !ends {
            continue;
        }
        let Some((other, after)) = argument(tokens, at + 1) else {
            continue;
        };
        if plain(other) != name {
            continue;
        }
        open = if begins { open + 1 } else { open - 1 };
        if open == 0 {
            return Some((at, after));
        }
    }
    None
}
