//! Flags the same sentence in two papers with different verdicts: one policy applies to every paper.

use super::{RaisedFlag, raised};
use crate::outcome::Outcome;
use std::collections::BTreeSet;
use torse_syntax::derivation::Claim;
use torse_syntax::taxonomy::{Flag, Kind};

/// Sentences of fewer different words may agree by chance.
const FEWEST_WORDS: usize = 8;

/// The printed sentences of papers that are long enough to be compared, with their words.
pub(super) struct Sentences<'a> {
    list: Vec<(&'a Claim, &'a Outcome, BTreeSet<String>)>,
}

impl<'a> Sentences<'a> {
    pub fn new(claims: &[(&'a Claim, &'a Outcome)]) -> Self {
        let prose = claims
            .iter()
            .filter(|(claim, _)| !matches!(claim.entry.kind, Kind::Remark | Kind::Figure));
        let list = prose.filter_map(|(claim, outcome)| {
            let words = words(&claim.entry.printed);
            (words.len() >= FEWEST_WORDS).then_some((*claim, *outcome, words))
        });
        Self {
            list: list.collect(),
        }
    }

    /// Returns the claims of other papers with the same words and another verdict.
    pub fn other_verdicts(&self, claim: &Claim) -> Vec<RaisedFlag> {
        let own = claim.entry.id.get_ref();
        let mut list = self.list.iter();
        let Some((_, outcome, words)) = list.find(|(of, ..)| of.entry.id.get_ref() == own) else {
            return vec![];
        };
        let others = self.list.iter().filter(|(other, found, printed)| {
            paper(other.entry.id.get_ref()) != paper(own)
                && found.verdict() != outcome.verdict()
                && agree(words, printed)
        });
        let flags = others.map(|(other, ..)| {
            let id = other.entry.id.get_ref();
            raised(
                Flag::SamePrint,
                format!("`{id}` has the same words and another verdict"),
            )
        });
        flags.collect()
    }
}

/// The paper of a claim, by its id.
fn paper(id: &str) -> &str {
    id.split('/').next().unwrap_or(id)
}

/// Whether four of five words are in both.
fn agree(a: &BTreeSet<String>, b: &BTreeSet<String>) -> bool {
    5 * a.intersection(b).count() >= 4 * a.union(b).count()
}

/// The words and numbers of a sentence; single letters are names of things.
fn words(printed: &str) -> BTreeSet<String> {
    let lower = printed.to_lowercase();
    let words = lower.split(|c: char| !c.is_alphanumeric());
    let words = words.filter(|word| {
        word.chars().count() > 1 || word.chars().all(|c| c.is_ascii_digit()) && !word.is_empty()
    });
    words.map(str::to_owned).collect()
}
