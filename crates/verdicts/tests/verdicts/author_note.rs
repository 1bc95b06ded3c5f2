//! The sentence that tells what was found.

use crate::common;

use torse_verdicts::engine::decide_claim;

#[test]
fn a_hole_with_a_name_that_nothing_declares_is_a_mistake() {
    let decided = |hole: &str| {
        let claim = format!("states = 'x == x'\nfinding = 'it is {{{hole}}}'");
        let paper = common::paper("finding", "[symbols]\nx = {}\n", &[&claim]);
        decide_claim("finding", &paper.claims[0]).map_err(|error| error.to_string())
    };
    assert!(decided("at(x^2, x, 3)").is_ok());
    // Without a witness no number is known of x.
    assert_eq!(
        decided("x^2 : 3").unwrap_err(),
        "this is not a number at the witness of the finding"
    );
    assert_eq!(decided("x + z").unwrap_err(), "`z` is not declared");
}
