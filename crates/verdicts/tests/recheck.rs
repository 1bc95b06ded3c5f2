//! The naive evaluator agrees with the engine, and does not agree with wrong outcomes.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::path::Path;
use torse_language::derivation::{Claim, Paper, load};
use torse_language::notation::Formula;
use torse_language::words::Verdict;
use torse_prove::evidence::Evidence;
use torse_verdicts::engine;
use torse_verdicts::outcome::{Correction, Outcome};
use torse_verdicts::recheck::{Recheck, claim as recheck};

fn paper() -> Paper {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/papers");
    load(&folder).unwrap().remove(0)
}

fn named<'a>(paper: &'a Paper, name: &str) -> &'a Claim {
    let id = format!("small/{name}");
    paper
        .claims
        .iter()
        .find(|c| *c.entry.id.get_ref() == id)
        .unwrap()
}

fn decided(paper: &Paper, name: &str) -> Outcome {
    engine::decide_claim(&paper.head.id, named(paper, name)).unwrap()
}

/// An outcome with another verdict.
fn with(outcome: &Outcome, verdict: Verdict, evidence: Evidence) -> Outcome {
    Outcome {
        verdict,
        evidence: Some(evidence),
        correction: None,
        data: None,
        witness: None,
        ..outcome.clone()
    }
}

const TRUE: [&str; 9] = [
    "unity",
    "symmetry",
    "tangent",
    "second",
    "join",
    "lagrange",
    "inverse",
    "angles",
    "solution-at",
];

#[test]
fn identities_that_the_engine_proves_are_confirmed() {
    let paper = paper();
    for name in TRUE {
        let outcome = decided(&paper, name);
        assert!(
            matches!(outcome.verdict, Verdict::Holds | Verdict::Conditional),
            "{name}: {outcome:?}"
        );
        let result = recheck(named(&paper, name), &outcome);
        assert!(
            matches!(result, Recheck::Confirmed { .. }),
            "{name}: {result:?}"
        );
    }
}

#[test]
fn a_true_identity_called_false_is_contradicted() {
    let paper = paper();
    let template = decided(&paper, "unity");
    for name in TRUE {
        let result = recheck(
            named(&paper, name),
            &with(&template, Verdict::False, Evidence::Witness),
        );
        assert!(
            matches!(result, Recheck::Contradicted { .. }),
            "{name}: {result:?}"
        );
    }
}

#[test]
fn a_false_identity_called_true_is_contradicted_at_its_first_failing_instance() {
    let paper = paper();
    let template = decided(&paper, "unity");
    for (name, expected) in [("false-tangent", "k = 2"), ("false-late", "k = 4")] {
        let wrong = with(&template, Verdict::Holds, Evidence::Induction);
        let Recheck::Contradicted { instance, .. } = recheck(named(&paper, name), &wrong) else {
            panic!("{name} is not contradicted");
        };
        assert_eq!(instance, expected);
        let right = with(&template, Verdict::False, Evidence::Witness);
        let result = recheck(named(&paper, name), &right);
        assert_eq!(
            result,
            Recheck::Confirmed {
                instances: vec![expected.to_owned()]
            }
        );
    }
}

#[test]
fn a_correction_is_replayed_too() {
    let paper = paper();
    let refuted = with(
        &decided(&paper, "unity"),
        Verdict::Misprint,
        Evidence::Witness,
    );
    let corrected = |text: &str| Outcome {
        correction: Some(Correction {
            statement: Formula {
                text: text.to_owned(),
                ..Formula::default()
            },
            edits: vec![],
            unique: true,
        }),
        ..refuted.clone()
    };
    let claim = named(&paper, "false-tangent");
    let right = corrected("G'(0) == 1/2*(2*(k - 2) + pi*(1 + mu))*(R[1] - R[0])");
    assert!(matches!(recheck(claim, &right), Recheck::Confirmed { .. }));
    let wrong = corrected("G'(0) == 1/2*(2*(k - 2) + pi*(2 + mu))*(R[1] - R[0])");
    assert!(matches!(
        recheck(claim, &wrong),
        Recheck::Contradicted { .. }
    ));
}

#[test]
fn degrees_take_their_smallest_values_in_different_orders() {
    let paper = paper();
    let outcome = decided(&paper, "join");
    let Recheck::Confirmed { instances } = recheck(named(&paper, "join"), &outcome) else {
        panic!("the join is not confirmed");
    };
    assert_eq!(instances, ["m = 3, n = 3", "m = 4, n = 5", "m = 5, n = 4"]);
}

#[test]
fn what_rests_on_no_identity_is_not_replayed() {
    let paper = paper();
    let result = recheck(named(&paper, "inequality"), &decided(&paper, "inequality"));
    assert!(
        matches!(result, Recheck::NotReplayable { .. }),
        "{result:?}"
    );
}
