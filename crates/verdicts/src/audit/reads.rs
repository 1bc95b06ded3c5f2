//! Flags a correction whose words are not what is decided again.
//!
//! What an author reads is `reads` of a corrigendum; what is decided with all corrections in force is the corrected
//! statement. A slip in the words alone would pass every decision.

use super::corrected_words::CorrectedWords;
use super::formulas::Formulas;
use super::occurrences::{Differing, differing_names, differing_numbers, differing_relations};
use super::passages::split_outside_brackets;
use super::print::Print;
use super::setting::Setting;
use super::{RaisedFlag, Subject, one_flag_for};
use crate::outcome::Outcome;
use crate::restore::in_force;
use std::collections::BTreeSet;
use torse_syntax::derivation::Claim;
use torse_syntax::formula::{Expr, Node, Operator};
use torse_syntax::taxonomy::Flag;

/// Flags the corrected words of a claim that differ from its corrected statement. `printed` is the subject of the claim as it
/// is printed: what its words do not state already, the words that replace them need not state either.
pub(super) fn differing_corrections(
    claim: &Claim,
    outcome: &Outcome,
    setting: &Setting<'_>,
    printed: &Subject<'_>,
) -> Vec<RaisedFlag> {
    let id = claim.entry.id.get_ref();
    let Some(correction) = setting.correction(id) else {
        return vec![];
    };
    let mut corrected = in_force(correction.corrected, Some(outcome));
    if corrected.statement.is_none() || correction.reads.is_empty() {
        return vec![];
    }
    let reads = correction.reads.join(" / ");
    // What the paper says beside the corrected words.
    let context = format!(
        "{reads} / {} / {}",
        correction.beside.join(" / "),
        setting.prints(claim)
    );
    corrected.entry.printed = reads;
    let subject = Subject {
        claim: &corrected,
        outcome,
        formulas: Formulas::new(&corrected),
        print: Print::from_text(&corrected.entry.printed),
        context: Print::from_text(&context),
        rests_on: vec![],
        relations_of_all_parts: 0,
        is_worked: printed.is_worked,
    };
    let differing = |subject: &Subject<'_>| {
        [
            differing_numbers(subject),
            differing_names(subject),
            differing_relations(subject),
        ]
    };
    let found = differing(&subject).into_iter().zip(differing(printed));
    let mut flags = vec![];
    for (what, (found, before)) in ["numbers", "names", "relations"].into_iter().zip(found) {
        let Differing { lacks, adds } = found.beside(&before);
        let lacks = one_flag_for(
            Flag::ReadsOtherwise,
            &format!("{what} of `reads` that the corrected statement lacks"),
            lacks,
        );
        let adds = one_flag_for(
            Flag::ReadsOtherwise,
            &format!("{what} of the corrected statement that `reads` lacks"),
            adds,
        );
        flags.extend(lacks.into_iter().chain(adds));
    }
    let words = corrected_words(claim, outcome, setting);
    let otherwise = words.iter().flat_map(|words| {
        let each = words.reads.iter().map(|reads| words.compared(reads));
        each.flat_map(|found| found.otherwise).collect::<Vec<_>>()
    });
    let states = words
        .as_ref()
        .map(CorrectedWords::states)
        .unwrap_or_default();
    let otherwise = otherwise.map(|formula| format!("`{formula}` for `{states}`"));
    flags.extend(one_flag_for(
        Flag::ReadsAnotherFormula,
        "formulas of `reads` that the corrected statement does not have",
        otherwise.collect(),
    ));
    flags.extend(one_flag_for(
        Flag::ReadsOtherwise,
        "sides of `reads` with as many plus and minus signs as no part of the corrected statement has",
        differing_signs(&subject),
    ));
    flags
}

/// The words of the correction of a claim, ready to be compared with what is decided for the same fault.
pub(super) fn corrected_words(
    claim: &Claim,
    outcome: &Outcome,
    setting: &Setting<'_>,
) -> Option<CorrectedWords> {
    let correction = setting.correction(claim.entry.id.get_ref())?;
    if correction.reads.is_empty() {
        return None;
    }
    // One that is not restated may still state the error of the print; what it assumes is stated.
    let siblings = correction.siblings.iter().filter_map(|restored| {
        let mut sibling = restored.claim.clone();
        if !restored.restated {
            sibling.statement = sibling.assumptions.first().map(|own| own.formula.clone());
        }
        sibling.statement.is_some().then_some(sibling)
    });
    let own = in_force(correction.corrected, Some(outcome));
    let decided: Vec<Claim> = [own].into_iter().chain(siblings).collect();
    let (own, around) = (&claim.entry.printed, setting.prints(claim));
    Some(CorrectedWords::new(
        decided,
        &correction.reads,
        own,
        &around,
    ))
}

/// How many plus and minus signs.
type SignCount = (usize, usize);

/// Returns the sides of the print with as many plus and minus signs as no part of the statement has.
fn differing_signs(subject: &Subject<'_>) -> Vec<String> {
    let mut stated = BTreeSet::new();
    for expr in &subject.formulas.reached {
        add_sign_counts(expr, &mut stated);
    }
    let sides = split_outside_brackets(&subject.claim.entry.printed, SIDES).into_iter();
    let differing = sides.filter(|side| {
        let count = printed_signs(side);
        count != (0, 0) && !stated.contains(&count)
    });
    differing.map(|side| format!("`{}`", side.trim())).collect()
}

/// Adds the counts of a formula and of each part of it; returns its own.
fn add_sign_counts(expr: &Expr, found: &mut BTreeSet<SignCount>) -> SignCount {
    let own = match &expr.node {
        Node::Binary(Operator::Add, ..) => (1, 0),
        Node::Binary(Operator::Subtract, ..) | Node::Negative(_) => (0, 1),
        _ => (0, 0),
    };
    let parts = expr.parts().into_iter();
    let count = parts.fold(own, |(plus, minus), part| {
        let (more_plus, more_minus) = add_sign_counts(part, found);
        (plus + more_plus, minus + more_minus)
    });
    found.insert(count);
    count
}

/// The signs between the sides of a printed formula: relations, commas and semicolons.
const SIDES: &str = "=<>≤≥≠∈,;";

/// Counts the signs of a printed formula; a hyphen in a word is none.
fn printed_signs(text: &str) -> SignCount {
    let letters: Vec<char> = text.chars().collect();
    let (mut plus, mut minus) = (0, 0);
    for (at, sign) in letters.iter().enumerate() {
        match sign {
            '+' => plus += 1,
            '−' => minus += 1,
            '-' if !joins_words(&letters, at) => minus += 1,
            _ => {}
        }
    }
    (plus, minus)
}

/// Whether a hyphen stands between letters, one of which belongs to a word.
fn joins_words(letters: &[char], at: usize) -> bool {
    let before = letters.get(..at).unwrap_or_default().iter().rev();
    let after = letters.get(at + 1..).unwrap_or_default().iter();
    let before = before.take_while(|c| c.is_alphabetic()).count();
    let after = after.take_while(|c| c.is_alphabetic()).count();
    before > 0 && after > 0 && before + after > 2
}
