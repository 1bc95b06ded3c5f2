//! Flags what the letter of a paper says of a claim and its verdict does not.

use super::setting::Setting;
use super::{RaisedFlag, raised};
use crate::outcome::Outcome;
use std::collections::BTreeSet;
use torse_syntax::derivation::Claim;
use torse_syntax::notation::text;
use torse_syntax::taxonomy::{Flag, Verdict};

/// Returns a fault that is said to show in a claim whose verdict accuses it of nothing.
pub(super) fn without_verdict(
    claim: &Claim,
    outcome: &Outcome,
    setting: &Setting<'_>,
) -> Vec<RaisedFlag> {
    let verdict = outcome.verdict();
    let accuses_nothing = matches!(
        verdict,
        Verdict::Holds
            | Verdict::Definition
            | Verdict::Reproduced
            | Verdict::Partial
            | Verdict::OutOfScope
    );
    let faults = setting.faults_in(claim.entry.id.get_ref());
    // What may be a slip of the copy is asked, and accuses nobody.
    let is_asked = claim.entry.garbled.is_some();
    let faults = faults.filter(|_| accuses_nothing && !is_asked);
    let flag = |fault: &str| {
        let evidence =
            format!("`{fault}` is said to show in it, and nothing in it is refuted or limited");
        raised(Flag::AccusedWithoutVerdict, evidence)
    };
    faults.map(flag).collect()
}

/// Returns corrections of a sentence that replace letters, indices and numbers and no word, and that state what one of its
/// readings states and is true: a repair is no reading.
pub(super) fn corrected_readings(
    claim: &Claim,
    outcome: &Outcome,
    setting: &Setting<'_>,
) -> Vec<RaisedFlag> {
    let corrected = setting.correction(claim.entry.id.get_ref());
    let corrected = corrected.and_then(|own| own.corrected.claim.statement.as_ref());
    let corrected = corrected.map(|statement| text(&statement.expr));
    let mut readings = claim.readings.iter().zip(outcome.readings());
    let is_repair = readings.any(|(reading, found)| {
        let stated = reading.claim.statement.as_ref().map(|own| text(&own.expr));
        stated.is_some() && stated == corrected && is_true(found.outcome.verdict())
    });
    if !is_repair {
        return vec![];
    }
    let changes = setting.changes_of(claim.entry.id.get_ref());
    let symbolic = changes.filter_map(|(printed, reads)| changed_signs(printed, reads));
    let flag = |(old, new): (String, String)| {
        let evidence = format!("`{old}` is read as `{new}`: a correction, and no reading");
        raised(Flag::CorrectedReading, evidence)
    };
    symbolic.map(flag).collect()
}

fn is_true(verdict: Verdict) -> bool {
    matches!(
        verdict,
        Verdict::Holds | Verdict::Conditional | Verdict::Definition
    )
}

/// The signs that change between two texts with the same words; none if a word changes or comes or goes.
fn changed_signs(printed: &str, reads: &str) -> Option<(String, String)> {
    let (old, new) = (tokens(printed), tokens(reads));
    let words = |of: &[String]| -> Vec<String> {
        let words = of.iter().filter(|token| is_word(token));
        words.cloned().collect()
    };
    if words(&old) != words(&new) || old == new {
        return None;
    }
    let only = |of: &[String], other: &[String]| {
        let other: BTreeSet<&String> = other.iter().collect();
        let only: BTreeSet<&str> = of
            .iter()
            .filter(|token| !other.contains(token))
            .map(String::as_str)
            .collect();
        only.into_iter().collect::<Vec<_>>().join(" ")
    };
    Some((only(&old, &new), only(&new, &old)))
}

/// A word of three letters or more; shorter ones are names.
fn is_word(token: &str) -> bool {
    token.chars().count() > 2 && token.chars().all(char::is_alphabetic)
}

/// Words, names and numbers, and each other sign for itself.
fn tokens(text: &str) -> Vec<String> {
    let mut tokens: Vec<String> = vec![];
    let mut last_joins = false;
    for c in text.chars() {
        let joins = c.is_alphanumeric();
        match tokens.last_mut() {
            Some(last) if joins && last_joins => last.push(c),
            _ if c.is_whitespace() => {}
            _ => tokens.push(c.to_string()),
        }
        last_joins = joins;
    }
    tokens
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_letter_or_number_is_a_correction_and_another_word_is_not() {
        let changed = |printed, reads| changed_signs(printed, reads).is_some();
        assert!(changed("Q_k ∈ R^m, m = 2, 3", "Q_k ∈ R^d, d = 2, 3"));
        assert!(changed(
            "equation (3.3) is shown",
            "equation (3.2) is shown"
        ));
        assert!(!changed(
            "equation (3.3) is shown",
            "equation (3.3) is shown"
        ));
        assert!(!changed("it is necessary", "it is sufficient"));
        assert!(!changed(
            "x is positive",
            "x is positive where y > 0 as well"
        ));
    }
}
