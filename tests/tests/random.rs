//! Random claims of every kind: the engine is never wrong about one, and seldom does not know; the semantics, asked by
//! itself, never contradicts what was made.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "helpers of tests")]

use torse_syntax::taxonomy::Verdict;
use torse_tests::random::Kind;
use torse_tests::random::claim::{Claim, Truth};
use torse_tests::random::judge::{
    Judgement, contradiction, judge, outcome, outcomes, run, seconded, semantics,
};
use torse_tests::random::variants::Variant;
use torse_verdicts::finding::Finding;
use torse_verdicts::statement::Contradiction;

const SEED: u64 = 1;

/// How many claims of a kind.
const CLAIMS: u64 = 500;
/// How many in a hundred may stay open.
const MAX_OPEN: u64 = 10;

/// How many in a hundred the semantics has to decide by itself: fewer where a claim may deny something everywhere, or
/// speaks of functions.
fn least_seconded(kind: Kind) -> u64 {
    match kind {
        Kind::Logic => 60,
        Kind::Properties => 75,
        // Integrals of products take more work than a point may.
        Kind::Integrals => 60,
        _ => 92,
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
        tally.open * 100 <= CLAIMS * MAX_OPEN,
        "{} of {CLAIMS} are open, such as\n{}",
        tally.open,
        tally.undecided[..tally.undecided.len().min(3)].join("\n")
    );
    assert!(
        tally.seconded * 100 >= CLAIMS * least_seconded(kind),
        "the semantics decides {} of {CLAIMS} by itself",
        tally.seconded
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
    parts_and_multiples_of_angles_are_never_judged_wrongly: Angles,
    exponentials_and_their_order_are_never_judged_wrongly: Exponentials,
    splines_on_knots_are_never_judged_wrongly: Splines,
    smooth_functions_are_never_judged_wrongly: Functions,
    integrals_are_never_judged_wrongly: Integrals,
    numbers_that_there_are_are_never_judged_wrongly: Exists,
    symbolic_powers_and_products_are_never_judged_wrongly: Powers,
}

/// The first claims of every kind.
fn some(count: u64) -> impl Iterator<Item = Claim> {
    let kinds = Kind::ALL.into_iter();
    kinds.flat_map(move |kind| (0..count).map(move |number| kind.claim(SEED, number)))
}

/// The verdict, with `misprint` as the `false` that it is; corrections depend on the order of the sides.
fn verdict(claim: &Claim) -> Option<Verdict> {
    outcome(claim).ok().map(|found| refuted(found.verdict()))
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
        let verdict = |o: Result<_, String>| o.ok().map(|o: torse_verdicts::Outcome| o.verdict());
        found.into_iter().map(verdict).collect()
    };
    let forwards: Vec<&Claim> = claims.iter().collect();
    let backwards: Vec<&Claim> = claims.iter().rev().collect();
    let mut second = verdicts(&backwards);
    second.reverse();
    assert_eq!(verdicts(&forwards), second);
}

#[test]
fn a_wrong_answer_and_a_wrong_construction_are_seen() {
    let mut claim = Kind::Polynomial.claim(SEED, 0);
    let points = semantics(&claim).expect("it makes sense");
    let answer = outcome(&claim);
    assert_eq!(contradiction(&claim, &points), None);
    assert_eq!(judge(&claim, &answer), Judgement::Right);
    claim.truth = match claim.truth {
        Truth::Holds => Truth::Fails(String::new()),
        _ => Truth::Holds,
    };
    assert!(matches!(judge(&claim, &answer), Judgement::Wrong(_)));
    assert!(!seconded(&claim, &points));
    let mut torn = answer.expect("it is decided");
    torn.finding = Finding::Contradicted(Contradiction {
        claimed: torn.verdict(),
        found: "x".to_owned(),
    });
    assert!(matches!(judge(&claim, &Ok(torn)), Judgement::Wrong(_)));
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
    const COUNT: u64 = 120;
    for kind in Kind::ALL {
        let fails = |number: &u64| matches!(kind.claim(SEED, *number).truth, Truth::Fails(_));
        let count = (0..COUNT).filter(fails).count();
        assert!(
            (COUNT * 3 / 10..=COUNT * 7 / 10).contains(&(count as u64)),
            "{}: {count}",
            kind.word()
        );
    }
}
