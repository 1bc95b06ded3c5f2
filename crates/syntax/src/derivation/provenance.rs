//! The provenance of a hypothesis: either the paper states it, at a quoted place, or we assume it, for a stated
//! reason.

use super::error::{DerivationError, LoadError};
use super::schema::Text;
use super::schema::hypothesis::FromEntry;
use super::source::{Origin, Source, whole};
use super::table::Errors;
use super::written::Written;
use crate::formula::Place;
use std::sync::Arc;

/// An assumed formula.
#[derive(Debug, Clone)]
pub struct Hypothesis {
    /// The formula.
    pub formula: Written,
    /// Where the formula comes from.
    pub provenance: Provenance,
}

/// Where a hypothesis comes from.
#[derive(Debug, Clone)]
pub enum Provenance {
    /// It is part of the statement in the file; no claim is made about the printed text.
    Stated,
    /// The paper states it in these words.
    Printed(Quote),
    /// The paper does not state it; it is our assumption.
    Ours {
        /// Why it is assumed.
        reason: String,
    },
}

impl Provenance {
    /// The quoted words of the paper.
    #[must_use]
    pub fn quote(&self) -> Option<&Quote> {
        match self {
            Self::Printed(quote) => Some(quote),
            Self::Stated | Self::Ours { .. } => None,
        }
    }

    /// Whether it is our assumption.
    #[must_use]
    pub fn is_ours(&self) -> bool {
        matches!(self, Self::Ours { .. })
    }
}

/// Words of the paper.
#[derive(Debug, Clone)]
pub struct Quote {
    /// The words.
    pub words: String,
    /// The id of the claim whose printed text contains them.
    pub claim: String,
    /// The place of the quotation in the file.
    pub origin: Origin,
}

impl Quote {
    /// Quotes words of a file. The printed text is that of the claim `within` if given, else of the claim `own`.
    #[must_use]
    pub fn new(source: &Arc<Source>, words: &Text, within: Option<&Text>, own: &str) -> Self {
        Self {
            words: words.get_ref().clone(),
            claim: within.map_or_else(|| own.to_owned(), |id| id.get_ref().clone()),
            origin: Origin::from_spanned(source, words),
        }
    }

    /// Whether a printed text contains the words; differences in whitespace are ignored.
    #[must_use]
    pub fn stands_in(&self, printed: &str) -> bool {
        let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        plain(printed).contains(&plain(&self.words))
    }

    /// Whether these are the words of a print with what it leaves out: its pieces between `...`, remarks in square
    /// brackets aside, stand in them in their order. A print that leaves nothing out has nothing to fill.
    #[must_use]
    pub fn fills(&self, printed: &str) -> bool {
        let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        let pieces = pieces(printed);
        let words = plain(&self.words);
        let mut rest = words.as_str();
        pieces.len() > 1
            && pieces.iter().all(|piece| {
                let found = rest.split_once(plain(piece).as_str());
                rest = found.map_or(rest, |(_, after)| after);
                found.is_some()
            })
    }
}

/// A print at `...` and at remarks in square brackets with words in them, cut into what stands between.
fn pieces(printed: &str) -> Vec<&str> {
    let mut pieces = vec![];
    let (mut start, mut position) = (0, 0);
    while let Some(rest) = printed.get(position..).filter(|rest| !rest.is_empty()) {
        let length = gap(rest);
        if length > 0 {
            pieces.extend(printed.get(start..position));
            start = position + length;
        }
        let step = rest.chars().next().map_or(1, char::len_utf8);
        position += length.max(step);
    }
    pieces.extend(printed.get(start..));
    pieces
}

/// How long `...` or a remark in square brackets is with which a text begins; zero where it begins with neither. A bracket
/// is one of a formula unless two words of letters stand in it, or `...`.
fn gap(text: &str) -> usize {
    if text.starts_with("...") {
        return 3;
    }
    let inner = text.strip_prefix('[').and_then(|rest| rest.split_once(']'));
    let Some((inner, _)) = inner else {
        return 0;
    };
    let is_word = |word: &&str| word.len() > 1 && word.chars().all(char::is_alphabetic);
    let is_remark = inner.trim() == "..." || inner.split_whitespace().filter(is_word).count() > 1;
    match is_remark {
        true => inner.len() + 2,
        false => 0,
    }
}

/// Reads the fields `printed`, `in` and `ours`, of which either the first or the last is required. `own` is the id of
/// the claim that contains them, if a claim does.
pub(super) fn provenance(
    source: &Arc<Source>,
    from: &FromEntry,
    own: Option<&str>,
    place: std::ops::Range<usize>,
    errors: &mut Errors,
) -> Provenance {
    let wrong = |text: Option<&Text>, message: &str, help: &str| {
        let (origin, place) = match text {
            Some(text) => (Origin::from_spanned(source, text), whole(text)),
            None => (
                Origin::range(source, place.start, place.end),
                Place::default(),
            ),
        };
        let error = DerivationError::at(&origin, place, message).with_help(help);
        LoadError::Derivation(Box::new(error))
    };
    let one_of = "`printed = '...'` quotes the paper, `ours = '...'` gives our reason";
    let mistake = match (&from.printed, &from.within, &from.ours) {
        (Some(words), within, None) => {
            let words_of = own.or(within.as_ref().map(|id| id.get_ref().as_str()));
            if words.get_ref().trim().is_empty() {
                wrong(Some(words), "an empty quote says nothing", one_of)
            } else if let Some(own) = words_of {
                return Provenance::Printed(Quote::new(source, words, within.as_ref(), own));
            } else {
                let help = "name the claim in whose `printed` the words stand: `printed_in = 'paper/thm-1'`";
                wrong(Some(words), "nothing says where this is printed", help)
            }
        }
        (None, None, Some(reason)) if !reason.get_ref().trim().is_empty() => {
            let reason = reason.get_ref().clone();
            return Provenance::Ours { reason };
        }
        (None, None, Some(reason)) => wrong(Some(reason), "the reason is missing", one_of),
        (Some(_), _, Some(reason)) => {
            let message = "a hypothesis is `printed` or `ours`, not both";
            wrong(Some(reason), message, one_of)
        }
        (None, Some(within), _) => {
            let message = "this names a claim, but no words of it are quoted";
            wrong(Some(within), message, one_of)
        }
        (None, None, None) => wrong(None, "nothing says where this is from", one_of),
    };
    errors.0.push(mistake);
    Provenance::Stated
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fills(words: &str, printed: &str) -> bool {
        let source = Arc::new(Source::new(String::new(), String::new()));
        let words = toml::Spanned::new(0..0, words.to_owned());
        Quote::new(&source, &words, None, "p/a").fills(printed)
    }

    #[test]
    fn words_fill_what_a_print_leaves_out_and_nothing_else() {
        let whole = "For fixed c the length and location of J(0) will not change";
        assert!(fills(
            whole,
            "[with c fixed] the ... location of J(0) will not change"
        ));
        assert!(fills(whole, "the length ... of J(0) will not change"));
        assert!(fills(
            whole,
            "... location of J(0) [and of others] will not change"
        ));
        assert!(!fills(
            whole,
            "the location ... length of J(0) will not change"
        ));
        assert!(!fills(whole, "the length ... of J(1) will not change"));
        assert!(!fills(whole, "the length and location of J(0)"));
        // Brackets of a formula are none of a remark.
        assert!(!fills("[a - b] c d", "[a - b] c"));
        assert!(fills("[a - b] c d e", "[a - b] c [...] e"));
    }
}
