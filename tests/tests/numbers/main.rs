//! The numbers of the three papers, by two routes that share nothing: exactly, by the engine from the derivation files, and in
//! doubles, by the evaluators of `geometry` and the decompositions of nalgebra, which know nothing of any file.
//!
//! Each row has the exact number, an enclosure, the double, and the units in the last place between them; where the paper prints
//! the number, how far the print is from it. Those of the examples are a snapshot, and all of them the page `derivations/NUMBERS.md`.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    reason = "helpers of tests"
)]

mod ends;
mod exact;
mod examples;
mod matrices;
mod row;

use row::{Row, page};
use std::path::Path;
use torse_syntax::taxonomy::Kind;

/// No double is farther from its exact number, in units in the last place of the largest number of its vector or matrix; the
/// condition numbers of the Hermite systems are up to a thousand. The units of the number itself may be more, where it comes from a
/// difference of larger ones.
const MAX_ULPS: f64 = 1024.0;

fn all() -> Vec<(&'static str, Vec<Row>)> {
    vec![
        ("Example values", examples::rows()),
        ("Derivatives at both ends", ends::rows()),
        ("Matrices and determinants", matrices::rows()),
    ]
}

#[test]
fn every_number_of_the_papers_is_found_by_two_routes_and_is_as_it_was() {
    let parts = all();
    for row in parts.iter().flat_map(|(_, rows)| rows) {
        assert!(row.ulps <= MAX_ULPS, "{}: {row:?}", row.name());
    }
    insta::assert_snapshot!("example_values", page(&parts[..1]));
    let text = page(&parts);
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../derivations/NUMBERS.md");
    if std::env::var("INSTA_UPDATE").is_ok_and(|how| how == "always") {
        std::fs::write(&file, &text).unwrap();
    }
    let written = std::fs::read_to_string(&file).unwrap_or_default();
    assert!(
        written == text,
        "derivations/NUMBERS.md is not what is computed: INSTA_UPDATE=always writes it"
    );
}

#[test]
fn what_is_compared_with_a_print_stands_in_that_print() {
    let mut compared = 0;
    for row in examples::rows() {
        let Some(printed) = &row.printed else {
            continue;
        };
        let claim = exact::claim(&row.claim);
        let print = claim.entry.printed.replace('−', "-");
        // The copy at hand of one paper has `91, 8` for 91.8.
        let with_comma = printed.text.replace('.', ", ");
        let stands = print.contains(&printed.text) || print.contains(&with_comma);
        assert!(stands, "{}: {print}", row.name());
        compared += 1;
    }
    assert!(compared > 60, "{compared}");
}

#[test]
fn every_number_that_the_papers_print_in_decimals_has_a_row() {
    let rows = examples::rows();
    for claim in exact::claims() {
        let id = claim.entry.id.get_ref();
        let states = claim.entry.states.as_ref().map(toml::Spanned::get_ref);
        let decimals = states.is_some_and(|text| text.contains("agrees("));
        if decimals && claim.entry.kind != Kind::Remark {
            assert!(rows.iter().any(|row| row.claim == *id), "{id}");
        }
    }
}
