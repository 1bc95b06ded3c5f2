//! Statements in which everything is composed with everything.

use torse_tests::composed::{Composed, claim};
use torse_tests::random::claim::Truth;

const SEED: u64 = 1;

#[test]
fn about_half_of_them_are_true() {
    let all: Vec<Composed> = (0..400).map(|number| claim(SEED, number)).collect();
    let fails = |made: &&Composed| matches!(made.claim.truth, Truth::Fails(_));
    let count = all.iter().filter(fails).count();
    assert!((120..=280).contains(&count), "{count}");
}

#[test]
fn a_composed_claim_is_a_function_of_its_seed() {
    for number in 0..40 {
        let (one, other) = (claim(SEED, number), claim(SEED, number));
        assert_eq!(one.claim.file(), other.claim.file());
        assert_eq!(one.claim.truth, other.claim.truth);
    }
    assert_ne!(claim(1, 7).claim.file(), claim(2, 7).claim.file());
}
