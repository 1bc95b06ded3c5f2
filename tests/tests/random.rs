//! Random claims of every kind: the engine is never wrong about one, and seldom does not know.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "helpers of tests")]

use torse_language::words::Verdict;
use torse_tests::random::Kind;
use torse_tests::random::claim::{Claim, Truth};
use torse_tests::random::judge::{outcome, outcomes, run};
use torse_tests::random::variants::Variant;

const SEED: u64 = 1;
const CLAIMS: u64 = 120;

/// How many in a hundred may stay open: ten, and more where procedures are known to be missing (a point at which two
/// alternatives fail, signs under two nonlinear assumptions, total positivity).
fn most_open(kind: Kind) -> u64 {
    match kind {
        Kind::Logic => 30,
        Kind::Assumptions => 22,
        Kind::Properties => 18,
        _ => 10,
    }
}

/// Never wrong, and seldom open.
#[track_caller]
fn never_wrong(kind: Kind) {
    let tally = run(kind, SEED, 0, CLAIMS);
    assert!(
        tally.wrong.is_empty(),
        "{} of {CLAIMS} are wrong, such as\n{}",
        tally.wrong.len(),
        tally.wrong[..tally.wrong.len().min(3)].join("\n")
    );
    assert!(
        tally.open * 100 <= CLAIMS * most_open(kind),
        "{} of {CLAIMS} are open, such as\n{}",
        tally.open,
        tally.undecided[..tally.undecided.len().min(3)].join("\n")
    );
}

macro_rules! never_wrong {
    ($($name:ident: $kind:ident,)*) => {
        $(
            #[test]
            fn $name() {
                never_wrong(Kind::$kind);
            }
        )*
    };
}

never_wrong! {
    products_and_their_expansions_are_never_judged_wrongly: Polynomial,
    order_relations_are_never_judged_wrongly: Inequality,
    quotients_are_never_judged_wrongly: Division,
    vectors_and_matrices_are_never_judged_wrongly: Vectors,
    derivatives_of_bound_names_are_never_judged_wrongly: Calculus,
    what_follows_from_given_equations_is_never_judged_wrongly: Given,
    sums_of_symbolic_degree_are_never_judged_wrongly: Degree,
    assumptions_are_never_used_wrongly: Assumptions,
    integers_of_dependent_ranges_are_never_judged_wrongly: Integers,
    and_or_and_not_are_never_judged_wrongly: Logic,
    printed_decimals_are_never_judged_wrongly: Decimals,
    properties_of_a_basis_are_never_judged_wrongly: Properties,
}

/// The first claims of every kind.
fn some(count: u64) -> impl Iterator<Item = Claim> {
    let kinds = Kind::ALL.into_iter();
    kinds.flat_map(move |kind| (0..count).map(move |number| kind.claim(SEED, number)))
}

/// The verdict, with `misprint` as the `false` that it is; corrections depend on the order of the sides.
fn verdict(claim: &Claim) -> Option<Verdict> {
    outcome(claim).ok().map(|found| refuted(found.verdict))
}

fn refuted(verdict: Verdict) -> Verdict {
    match verdict {
        Verdict::Misprint => Verdict::False,
        other => other,
    }
}

#[track_caller]
fn the_same(variant: Variant) {
    let mut changed = vec![];
    for mut claim in some(32) {
        claim.word = "property";
        let other = variant.of(&claim);
        let (before, after) = (verdict(&claim), verdict(&other));
        if before != after {
            changed.push(format!(
                "{}{before:?}\n{}{after:?}\n",
                claim.file(),
                other.file()
            ));
        }
    }
    assert!(
        changed.is_empty(),
        "{}: {}",
        changed.len(),
        changed.join("\n")
    );
}

#[test]
fn other_names_change_no_verdict() {
    the_same(Variant::Renamed);
}

#[test]
fn exchanged_sides_change_no_verdict() {
    the_same(Variant::Exchanged);
}

#[test]
fn hypotheses_in_another_order_change_no_verdict() {
    the_same(Variant::Reordered);
}

#[test]
fn claims_in_another_order_change_no_verdict() {
    let claims: Vec<Claim> = some(12)
        .map(|mut claim| {
            claim.word = "property";
            claim
        })
        .collect();
    let verdicts = |claims: &[&Claim]| -> Vec<Option<Verdict>> {
        let found = outcomes(claims).expect("all claims make sense");
        let verdict = |o: Result<_, String>| o.ok().map(|o: torse_verdicts::Outcome| o.verdict);
        found.into_iter().map(verdict).collect()
    };
    let forwards: Vec<&Claim> = claims.iter().collect();
    let backwards: Vec<&Claim> = claims.iter().rev().collect();
    let mut second = verdicts(&backwards);
    second.reverse();
    assert_eq!(verdicts(&forwards), second);
}

#[test]
fn a_claim_is_a_function_of_its_seed() {
    for (first, second) in some(20).zip(some(20)) {
        assert_eq!(first.file(), second.file());
        assert_eq!(first.truth, second.truth);
    }
    let (one, two) = (Kind::Degree.claim(1, 7), Kind::Degree.claim(2, 7));
    assert_ne!(one.file(), two.file());
}

#[test]
fn between_a_third_and_two_thirds_of_the_claims_of_a_kind_are_false() {
    for kind in Kind::ALL {
        let fails = |number: &u64| matches!(kind.claim(SEED, *number).truth, Truth::Fails(_));
        let count = (0..CLAIMS).filter(fails).count();
        assert!(
            (CLAIMS * 3 / 10..=CLAIMS * 7 / 10).contains(&(count as u64)),
            "{}: {count}",
            kind.word()
        );
    }
}
