//! The words of corrections are what is decided: slips in them, one by one, are seen.

use super::{LOADED, PAPERS};
use torse_syntax::derivation::Paper;
use torse_verdicts::audit::{CorrectedWords, FormulasOfWords, corrected_words, is_formula};

/// The words of each correction of each paper, ready to be compared.
fn all() -> Vec<(String, CorrectedWords)> {
    let mut found = vec![];
    for (paper, outcome) in LOADED.iter().zip(PAPERS.iter()) {
        for claim in &paper.claims {
            let id = claim.entry.id.get_ref();
            let outcome = outcome.claims.iter().find(|of| of.claim.id == *id);
            let alone = std::slice::from_ref::<Paper>(paper);
            let words = outcome.and_then(|outcome| corrected_words(alone, claim, outcome));
            found.extend(words.map(|words| (id.clone(), words)));
        }
    }
    found
}

/// Texts with one slip: a sign turned, a digit changed, or two letters exchanged that stand in scripts.
fn mutants(text: &str) -> Vec<String> {
    let letters: Vec<char> = text.chars().collect();
    let with = |changes: &[(usize, char)]| {
        let mut changed = letters.clone();
        for (at, letter) in changes {
            changed[*at] = *letter;
        }
        changed.into_iter().collect::<String>()
    };
    let mut found = vec![];
    for (at, letter) in letters.iter().enumerate() {
        let joins = |c: Option<&char>| c.is_some_and(|c| c.is_alphabetic());
        let before = at.checked_sub(1).and_then(|i| letters.get(i));
        let hyphen = joins(before) && joins(letters.get(at + 1)) && !text.contains("_{");
        match letter {
            '+' => found.push(with(&[(at, '-')])),
            '-' | '−' if !hyphen => found.push(with(&[(at, '+')])),
            _ => {}
        }
        if let Some(digit) = letter.to_digit(10) {
            let other = char::from_digit((digit + 1) % 10, 10).unwrap();
            found.push(with(&[(at, other)]));
        }
    }
    // The letters and digits in scripts.
    let mut scripts = vec![];
    let mut at = 0;
    while at < letters.len() {
        if matches!(letters[at], '_' | '^') {
            match letters.get(at + 1) {
                Some('{') => {
                    let close = (at..letters.len()).find(|i| letters[*i] == '}');
                    let end = close.unwrap_or(letters.len());
                    scripts.extend((at + 2..end).filter(|i| letters[*i].is_alphanumeric()));
                    at = end;
                }
                Some(c) if c.is_alphanumeric() => scripts.push(at + 1),
                _ => {}
            }
        }
        at += 1;
    }
    for pair in scripts.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        if letters[a] != letters[b] {
            found.push(with(&[(a, letters[b]), (b, letters[a])]));
        }
    }
    found
}

/// Whether a correction with these words is flagged.
fn flagged(found: &FormulasOfWords) -> bool {
    !found.otherwise.is_empty()
}

#[test]
fn no_correction_reads_another_formula_than_is_decided() {
    let words = all();
    assert!(words.len() > 90, "{}", words.len());
    for (id, words) in &words {
        for reads in &words.reads {
            let found = words.compared(reads);
            assert!(!flagged(&found), "{id}: {:?}", found.otherwise);
        }
    }
}

#[test]
fn every_formula_of_a_correction_that_nothing_decides_is_known() {
    let mut unread = String::new();
    for (id, words) in all() {
        for found in words.reads.iter().map(|reads| words.compared(reads)) {
            for formula in found.unread {
                unread.push_str(&format!("{id}: {formula}\n"));
            }
        }
    }
    insta::assert_snapshot!("unread_words", unread);
}

#[test]
fn the_error_of_the_paper_is_no_correction_of_it() {
    let all = all();
    for (id, right, wrong) in [
        (
            "gbt-surfaces/thm-2.a3",
            "(-1 + 2μ_1 + ν_1)",
            "(1 + 2μ_1 - ν_1)",
        ),
        (
            "gbt-surfaces/thm-2.b3",
            "(1 + μ_1 - ν_1)",
            "(1 - μ_1 + ν_1)",
        ),
        (
            "gbt-surfaces/thm-2.b3",
            "(1 + μ_1 - ν_1)",
            "(1 - μ_1 - ν_1)",
        ),
        ("gbt-surfaces/eq-25.2.a", "Q^X_{l,1}", "Q^X_{k,1}"),
        ("gbt-surfaces/eq-25.2.a", "Q^X_{l,1}", "Q^X_{l,0}"),
    ] {
        let (_, words) = all.iter().find(|(other, _)| other == id).unwrap();
        let [reads] = words.reads.as_slice() else {
            panic!("{id} has one correction")
        };
        assert!(reads.contains(right), "{id}: {reads}");
        let found = words.compared(&reads.replacen(right, wrong, 1));
        assert!(flagged(&found), "{id} with {wrong}: {found:?}");
    }
}

/// Of the slips, one in so many is tried.
const EVERY: usize = 5;

#[test]
fn nearly_every_slip_in_the_formulas_of_corrections_is_seen() {
    let (mut tried, mut flags, mut seen) = (0, 0, 0);
    let mut number = 0;
    for (_, words) in &all() {
        for reads in &words.reads {
            let own = words.compared(reads);
            for formula in own.decided.iter().filter(|text| is_formula(text)) {
                for mutant in mutants(formula) {
                    let slip = reads.replacen(formula.as_str(), &mutant, 1);
                    number += 1;
                    if slip == *reads || number % EVERY != 0 {
                        continue;
                    }
                    let found = words.compared(&slip);
                    tried += 1;
                    flags += usize::from(flagged(&found));
                    // What is no longer read is missed in the list of what is not.
                    seen += usize::from(flagged(&found) || found.unread != own.unread);
                }
            }
        }
    }
    assert!(tried > 150, "{tried}");
    assert!(flags * 100 >= tried * 70, "{flags} of {tried} are flagged");
    assert!(seen * 100 >= tried * 95, "{seen} of {tried} are seen");
}
