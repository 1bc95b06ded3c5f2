//! Where a formula of a paper fails, in names that the paper has.

use crate::names::printed_names;
use crate::sentence;
use crate::statements::is_refuted;
use crate::text::visible;
use torse_typography::{Prose, in_words, spans};
use torse_verdicts::outcome::{Outcome, PaperFault};
use torse_verdicts::repair;

/// Whether a witness has a number for a letter that stands in the print and in no correction. Such a letter may mean
/// nothing, and a number for it refutes nothing.
pub(super) fn is_about_a_letter(fault: &PaperFault, outcome: &Outcome) -> bool {
    let stands = |letter: &str, text: &str| {
        text.match_indices(letter).any(|(at, _)| {
            let before = text.get(..at).and_then(|text| text.chars().next_back());
            let after = text
                .get(at + letter.len()..)
                .and_then(|text| text.chars().next());
            let joined = |c: Option<char>| c.is_some_and(|c| c.is_ascii_lowercase());
            !joined(before) && !joined(after)
        })
    };
    let is_gone = |name: &String| {
        let mut changes = fault.changes.iter();
        name.len() == 1
            && fault
                .changes
                .iter()
                .any(|change| stands(name, &change.printed))
            && !changes.any(|change| stands(name, &change.reads))
    };
    let witness = outcome.witness().into_iter();
    let mut names = witness.flat_map(sentence::point).map(|(name, _)| name);
    names.any(is_gone)
}

/// Whether a witness has a number for a point or a vector, each coordinate of which it stands for.
pub(super) fn is_in_one_coordinate(outcome: &Outcome) -> bool {
    let generic = outcome.claim.table.symbols.iter();
    let mut generic = generic.filter(|symbol| symbol.is_generic);
    let Some(witness) = outcome.witness() else {
        return false;
    };
    let head = |name: &str| name.split(['[', '(', '\'']).next().map(str::to_owned);
    generic.any(|symbol| {
        sentence::point(witness).any(|(name, _)| head(name).as_deref() == Some(&symbol.name))
    })
}

/// A counterexample of more characters is left to the report.
const MAX_COUNTEREXAMPLE_LENGTH: usize = 400;

/// Where a formula of the paper fails; none where that cannot be said in names that the paper has. The formulas of sentences
/// are ours, and what they come to at a point tells an author nothing.
pub(super) fn counterexample(outcome: &Outcome) -> Option<Prose> {
    let witness = outcome.witness()?;
    let names = printed_names(outcome);
    let stated = outcome.parsed()?;
    let of_the_paper = names.are_of_the_paper(&stated.text)
        && sentence::point(witness).all(|(name, _)| names.are_of_the_paper(name));
    let plain_value = |text: &str| !text.starts_with('[');
    let is_shown = is_refuted(outcome)
        && repair::is_sought(outcome.claim.kind)
        && of_the_paper
        && plain_value(&witness.left)
        && plain_value(&witness.right);
    let why = is_shown
        .then(|| sentence::counterexample(outcome))
        .flatten()?;
    if why.chars().count() > MAX_COUNTEREXAMPLE_LENGTH {
        return None;
    }
    // What is no equation in print has no sides there.
    let has_sides = outcome
        .claim
        .printed
        .contains(['=', '<', '>', '≤', '≥', '≠']);
    let why = match has_sides {
        true => why,
        false => why.replace("the right side", "what is printed"),
    };
    // Two sides of one name would be said to differ from themselves.
    let (left, right) = stated.text.split_once(" == ")?;
    let shown = |side: &str| in_words(&spans(&format!("`{side}`"), &names));
    (shown(left) != shown(right)).then(|| spans(&visible(&why), &names))
}
