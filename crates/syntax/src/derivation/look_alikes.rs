//! Look-alike characters: two names that look the same to a reader are different names, so the reader is warned.

use super::claim::Claim;
use super::declarations::Declarations;
use super::error::LookAlike;
use super::written::Written;
use crate::formula::{Expr, Node};
use std::collections::BTreeSet;

/// Pairs of characters: those of the first text look like the Latin or Greek ones at the same positions of the
/// second. Characters that readers of formulas distinguish, such as nu and v or the two shapes of phi, are left out.
///
/// From the list of confusable characters of Unicode Technical Standard 39.
const LOOK_ALIKES: [(&str, &str); 3] = [
    (
        "аесорхуіјѕԁһԛԝАВЕЅКМНІЈОРСТУХ",
        "aecopxyijsdhqwABESKMHIJOPCTYX",
    ),
    ("ΑΒΕΖΗΙΚΜΝΟΡΤΥΧο", "ABEZHIKMNOPTYXo"),
    // Micro sign, ohm sign, kelvin sign, angstrom sign; script letters and Roman numerals.
    (
        "\u{b5}\u{2126}\u{212a}\u{212b}\u{210e}\u{2113}\u{2170}\u{2174}\u{2179}",
        "\u{3bc}\u{3a9}K\u{c5}hlivx",
    ),
];

/// The character that a reader would take this one for.
fn look_alike(letter: char) -> Option<char> {
    let among = |(from, to): &(&str, &str)| {
        let place = from.chars().position(|own| own == letter)?;
        to.chars().nth(place)
    };
    LOOK_ALIKES.iter().find_map(among)
}

/// The name that a reader would take this one for; `None` if a character shows that the name is in another script.
///
/// ```
/// use torse_syntax::derivation::name_taken_for;
/// assert_eq!(name_taken_for("\u{b5}1").as_deref(), Some("\u{3bc}1"));
/// assert_eq!(name_taken_for("\u{440}\u{430}dius").as_deref(), Some("padius"));
/// assert_eq!(name_taken_for("mu"), None);
/// assert_eq!(name_taken_for("\u{441}\u{43a}\u{43e}\u{440}\u{43e}\u{441}\u{442}\u{44c}"), None);
/// ```
#[must_use]
pub fn name_taken_for(name: &str) -> Option<String> {
    let other: String = name.chars().map(|c| look_alike(c).unwrap_or(c)).collect();
    let greek = |c: char| ('\u{391}'..='\u{3c9}').contains(&c);
    let usual = |c: char| c.is_ascii() || greek(c) || c == '\u{c5}';
    (other != name && other.chars().all(usual)).then_some(other)
}

/// Finds names in formulas that a reader would take for others, each reported once for a file.
pub(super) fn look_alikes(declarations: &Declarations, claims: &[Claim]) -> Vec<LookAlike> {
    let mut search = Search::default();
    search.declarations(declarations);
    for claim in claims {
        search.claim(claim);
    }
    search.found
}

#[derive(Default)]
struct Search {
    /// The names reported so far, with their files.
    seen: BTreeSet<(String, String)>,
    found: Vec<LookAlike>,
}

impl Search {
    fn claim(&mut self, claim: &Claim) {
        self.declarations(&claim.declarations);
        let hypotheses = claim.given.iter().chain(&claim.assumptions);
        let formulas = hypotheses.map(|hypothesis| &hypothesis.formula);
        let formulas = formulas.chain(&claim.unknowns).chain(&claim.statement);
        let witnesses = claim.existentials.iter().filter_map(|s| s.witness.as_ref());
        formulas.chain(witnesses).for_each(|w| self.formula(w));
        for reading in &claim.readings {
            self.claim(&reading.claim);
        }
    }

    fn declarations(&mut self, declarations: &Declarations) {
        for (_, definition) in declarations.definitions() {
            self.formula(&definition.body);
        }
        for (_, basis) in declarations.bases() {
            let steps = [&basis.step.0, &basis.step.1];
            basis
                .seeds
                .iter()
                .chain(steps)
                .for_each(|w| self.formula(w));
        }
    }

    fn formula(&mut self, written: &Written) {
        let mut pending: Vec<&Expr> = vec![&written.expr];
        while let Some(expr) = pending.pop() {
            if let Node::Name(name) = &expr.node
                && let Some(other) = name_taken_for(name)
                && self
                    .seen
                    .insert((written.origin.source.name.clone(), name.clone()))
            {
                self.found
                    .push(LookAlike::new(&written.origin, expr.place, name, &other));
            }
            pending.extend(expr.parts());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_letter_of_the_table_has_one_that_it_is_taken_for_and_that_one_has_none() {
        for (from, to) in LOOK_ALIKES {
            assert_eq!(from.chars().count(), to.chars().count(), "{from}");
            for (letter, other) in from.chars().zip(to.chars()) {
                assert_ne!(letter, other);
                assert!(
                    letter.is_alphabetic() && other.is_alphabetic(),
                    "{letter}{other}"
                );
                assert_eq!(look_alike(other), None, "{other}");
            }
        }
    }
}
