//! The semantics agrees with the prover, and does not agree with wrong outcomes.

use std::path::Path;
use std::sync::Arc;
use torse_certificate::Proof;
use torse_prove::evidence::{Evidence, Witness};
use torse_syntax::derivation::{Claim, Paper, load};
use torse_syntax::notation::Formula;
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::certificate::DecisionCertificate;
use torse_verdicts::correction::Correction;
use torse_verdicts::engine;
use torse_verdicts::finding::Finding;
use torse_verdicts::judged::{Judged, Net};
use torse_verdicts::outcome::Outcome;
use torse_verdicts::recheck::{Recheck, claim as recheck};
use torse_verdicts::statement::{ProvedStatement, RefutedStatement, Repair};

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

/// The same claim, called proved.
fn called_true(outcome: &Outcome) -> Outcome {
    let statement = ProvedStatement {
        evidence: Evidence::Induction,
        conditions: vec![],
        needed: vec![],
        certificate: Arc::new(DecisionCertificate::Proof {
            conditions: vec![],
            of: Proof::Parts(vec![]),
        }),
        ranges: vec![],
        witnesses: vec![],
    };
    Outcome {
        finding: Finding::Proved(judged(statement)),
        ..outcome.clone()
    }
}

/// Something that nobody has judged yet.
fn judged<T>(statement: T) -> Box<Judged<T>> {
    Box::new(Judged {
        statement,
        net: Net::without_points("made by a test"),
        replay: None,
    })
}

/// A refutation at this point.
fn refuted(outcome: &Outcome, at: &[(&str, &str)]) -> Outcome {
    let numbers = at.iter().map(|(n, v)| ((*n).to_owned(), (*v).to_owned()));
    let statement = RefutedStatement {
        evidence: Evidence::Witness,
        witness: Some(Witness {
            at: numbers.collect(),
            left: String::new(),
            right: String::new(),
            left_decimal: String::new(),
            right_decimal: String::new(),
        }),
        difference: None,
        derived: None,
        certificate: None,
        repair: None,
        data: None,
        search_ended_early: false,
        parts: vec![],
        no_number: None,
    };
    Outcome {
        finding: Finding::Refuted(judged(statement)),
        ..outcome.clone()
    }
}

#[track_caller]
fn is_contradicted(claim: &Claim, outcome: &Outcome) -> String {
    match recheck(claim, outcome) {
        Recheck::Contradicted { found } => found,
        other => panic!("{}: {other:?}", outcome.claim.id),
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
    "inequality",
];

#[test]
fn what_the_prover_proves_is_netted() {
    let paper = paper();
    for name in TRUE {
        let outcome = decided(&paper, name);
        assert!(
            matches!(outcome.verdict(), Verdict::Holds | Verdict::Conditional),
            "{name}: {outcome:?}"
        );
        let result = recheck(named(&paper, name), &outcome);
        assert!(matches!(result, Recheck::Netted(_)), "{name}: {result:?}");
    }
}

#[test]
fn a_condition_that_no_point_of_the_domain_violates_is_not_netted() {
    // The right side is the polynomial of Motzkin, which is nowhere negative and no sum of squares, and gamma > 0: there is no
    // solution for lambda = 0, and no proof of that is found.
    let paper = paper();
    let outcome = decided(&paper, "solution-beyond");
    assert_eq!(outcome.verdict(), Verdict::Conditional);
    let Recheck::Decided(net) = recheck(named(&paper, "solution-beyond"), &outcome) else {
        panic!("it is netted");
    };
    assert!(net.why.unwrap().contains("lambda != 0"));
    assert_eq!(net.decided, 60);
}

#[test]
fn a_condition_that_the_prover_settles_is_none() {
    // lambda*t == gamma > 0 has no solution for lambda = 0.
    let paper = paper();
    let outcome = decided(&paper, "solution-at");
    assert_eq!(outcome.verdict(), Verdict::Holds, "{outcome:?}");
    assert_eq!(outcome.conditions(), []);
    let result = recheck(named(&paper, "solution-at"), &outcome);
    assert!(matches!(result, Recheck::Netted(_)), "{result:?}");
}

#[test]
fn identities_are_decided_exactly_at_small_degrees() {
    let paper = paper();
    let Recheck::Netted(net) = recheck(named(&paper, "unity"), &decided(&paper, "unity")) else {
        panic!("the partition of unity is not netted");
    };
    assert_eq!(net.instances, 3, "k = 2, 3 and 4: {net:?}");
}

#[test]
fn a_false_statement_called_true_is_contradicted_at_a_degree_at_which_it_fails() {
    let paper = paper();
    for name in ["false-tangent", "false-late"] {
        let right = decided(&paper, name);
        assert!(right.witness().is_some(), "{right:?}");
        let wrong = called_true(&right);
        let found = is_contradicted(named(&paper, name), &wrong);
        assert!(found.contains("k = "), "{found}");
    }
}

#[test]
fn a_true_statement_called_false_is_contradicted_at_its_witness() {
    let paper = paper();
    let claim = named(&paper, "inequality");
    let outcome = decided(&paper, "inequality");
    let found = is_contradicted(claim, &refuted(&outcome, &[("mu", "1/2")]));
    assert!(found.contains("true at its witness"), "{found}");
    let found = is_contradicted(claim, &refuted(&outcome, &[("mu", "7")]));
    assert!(found.contains("outside of the domain"), "{found}");
}

#[test]
fn a_correction_is_judged_like_a_proof() {
    let paper = paper();
    let refuted = decided(&paper, "false-tangent");
    let corrected = |text: &str| {
        let correction = Correction {
            statement: Formula {
                text: text.to_owned(),
            },
            conditions: vec![],
            edits: vec![],
            unique: true,
        };
        let statement = RefutedStatement {
            repair: Some(Repair::Misprint(correction)),
            ..refuted.refuted().unwrap().clone()
        };
        Outcome {
            finding: Finding::Refuted(judged(statement)),
            ..refuted.clone()
        }
    };
    let claim = named(&paper, "false-tangent");
    let right = corrected("G'(0) == 1/2*(2*(k - 2) + pi*(1 + mu))*(R[1] - R[0])");
    let Recheck::Netted(net) = recheck(claim, &right) else {
        panic!("the correction is not netted");
    };
    assert!(net.correction.unwrap().decided >= 20);
    let wrong = corrected("G'(0) == 1/2*(2*(k - 2) + pi*(2 + mu))*(R[1] - R[0])");
    let found = is_contradicted(claim, &wrong);
    assert!(found.starts_with("the correction is wrong"), "{found}");
}
