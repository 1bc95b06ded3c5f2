//! Where a hypothesis is from: whether the paper says it, and where, or we do, and why.

use super::error::{DerivationError, LoadError};
use super::schema::Text;
use super::schema::hypothesis::FromEntry;
use super::source::{Origin, Source, whole};
use super::table::Errors;
use super::written::Written;
use crate::formula::Place;
use std::sync::Arc;

/// A formula that is assumed.
#[derive(Debug, Clone)]
pub struct Hypothesis {
    /// The formula.
    pub formula: Written,
    /// Where it is from.
    pub provenance: Provenance,
}

/// Where a hypothesis is from.
#[derive(Debug, Clone)]
pub enum Provenance {
    /// It is part of the statement as the file states it; nothing is said of the print.
    Stated,
    /// The paper says it.
    Printed(Quote),
    /// The paper does not say it.
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

    /// Whether the paper does not say it.
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
    /// The id of the claim in whose print they stand.
    pub claim: String,
    /// Where the quote stands in the file.
    pub origin: Origin,
}

impl Quote {
    /// Words of a file; `within` names the claim, else it is `own`.
    #[must_use]
    pub fn new(source: &Arc<Source>, words: &Text, within: Option<&Text>, own: &str) -> Self {
        Self {
            words: words.get_ref().clone(),
            claim: within.map_or_else(|| own.to_owned(), |id| id.get_ref().clone()),
            origin: Origin::from_spanned(source, words),
        }
    }

    /// Whether a print has these words; blanks and line ends are all one.
    #[must_use]
    pub fn stands_in(&self, printed: &str) -> bool {
        let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        plain(printed).contains(&plain(&self.words))
    }
}

/// What `printed`, `in` and `ours` say; one of the first and last is wanted. `own` is the id of the claim that says it,
/// if it is one.
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
