//! The grammar that highlights formulas in editors has the words of the language.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::collections::BTreeSet;
use torse_syntax::formula::WORDS;
use torse_syntax::formula::functions::FUNCTIONS;

/// The alternatives of a pattern of the grammar, between `(?:` and the next `)`.
fn alternatives(grammar: &serde_json::Value, rule: &str) -> BTreeSet<String> {
    let pattern = grammar["repository"][rule]["match"].as_str().unwrap();
    let (_, rest) = pattern.split_once("(?:").unwrap();
    let (words, _) = rest.split_once(')').unwrap();
    words.split('|').map(str::to_owned).collect()
}

#[test]
fn the_grammar_of_editors_has_the_functions_and_words_of_the_language() {
    let path = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../docs/editors/vscode/torse.tmLanguage.json"
    );
    let grammar: serde_json::Value =
        serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let owned = |words: &[&str]| -> BTreeSet<String> {
        words.iter().map(|word| (*word).to_owned()).collect()
    };
    assert_eq!(alternatives(&grammar, "function"), owned(&FUNCTIONS));
    assert_eq!(alternatives(&grammar, "word"), owned(&WORDS));
}
