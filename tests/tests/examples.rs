//! The papers' numbers: exact strings and enclosures, as the engine computes them.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "helpers of tests")]

use std::path::Path;
use torse_syntax::derivation::load;
use torse_verdicts::Outcome;
use torse_verdicts::engine::decide_claim;
use torse_verdicts::words;

fn outcome(id: &str) -> Outcome {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../derivations");
    let papers = load(&folder).expect("the derivations load");
    let (paper, claim) = papers
        .iter()
        .flat_map(|p| p.claims.iter().map(move |c| (p, c)))
        .find(|(_, c)| c.entry.id.get_ref() == id)
        .expect("the claim exists");
    decide_claim(&paper.head.id, claim).expect("the claim makes sense")
}

#[test]
fn the_third_plane_of_example_5_2_rounds_to_the_printed_decimals() {
    let steps = words::steps(&outcome("gbt-developable/ex-5.2.Q22"));
    insta::assert_json_snapshot!(steps);
}

#[test]
fn the_determinant_of_the_cubic_system_is_the_fourth_power_of_k() {
    let found = outcome("hermite-developable/eq-3.5.det");
    assert_eq!(found.parsed().unwrap().text, "det(A35) == k^4");
    insta::assert_json_snapshot!((found.verdict(), found.evidence()));
}

#[test]
fn the_missing_factor_of_the_beta_condition_is_found() {
    let found = outcome("gbt-developable/thm-4.c");
    let found = found.correction().unwrap();
    insta::assert_json_snapshot!((&found.edits, found.unique));
}

#[test]
fn the_spurious_exclusion_of_the_quartic_system_is_refuted_by_its_determinant() {
    let found = outcome("hermite-developable/eq-3.6.det");
    insta::assert_json_snapshot!((
        found.verdict(),
        found.derived().map(|d| &d.text),
        found.witness()
    ));
}
