//! Sentences that may be read in two ways.

use crate::common;

use torse_prove::evidence::Evidence;
use torse_syntax::taxonomy::Verdict;
use torse_verdicts::consequences::{Fate, consequences};
use torse_verdicts::outcome::Outcome;
use torse_verdicts::words;

fn read(name: &str, first: &str, second: &str) -> Outcome {
    let reading = |name: &str, states: &str| {
        format!("{{ name = '{name}', says = 'the {name} one', {states} }}")
    };
    let lines = format!(
        "readings = [{}, {}]",
        reading("literal", first),
        reading("kind", second)
    );
    let symbols = "[symbols]\nx = { in = '[0, 1]' }\ny = {}\n";
    common::outcomes(name, symbols, &[&lines]).remove(0)
}

#[test]
fn readings_with_different_verdicts_accuse_nobody() {
    let found = read("differ", "states = 'x > 0'", "states = 'x >= 0'");
    assert_eq!(
        (found.verdict(), found.evidence()),
        (Verdict::Depends, None)
    );
    assert!(found.witness().is_none() && found.correction().is_none());
    let verdicts: Vec<Verdict> = found
        .readings()
        .iter()
        .map(|r| r.outcome.verdict())
        .collect();
    assert_eq!(verdicts, [Verdict::False, Verdict::Holds]);
    assert!(found.readings()[0].outcome.witness().is_some());
    assert_eq!(
        words::steps(&found)[0],
        "read as “literal” (the literal one): it is false"
    );
    assert_eq!(Fate::from_verdict(found.verdict()), Fate::Open);
}

#[test]
fn readings_that_agree_give_the_verdict_with_the_weakest_evidence_and_all_conditions() {
    let found = read("hold", "states = '2*x == x + x'", "states = 'x >= 0'");
    assert_eq!(
        (found.verdict(), found.evidence()),
        (Verdict::Holds, Some(Evidence::Inequality))
    );
    assert!(found.net().unwrap().netted);
    assert!(found.replay().unwrap().replayed);
    let found = read(
        "conditions",
        "states = 'y/y == 1'",
        "states = '(y - 1)/(y - 1) == 1'",
    );
    let conditions: Vec<&str> = found.conditions().iter().map(|c| c.text.as_str()).collect();
    assert_eq!(
        (found.verdict(), conditions),
        (Verdict::Conditional, vec!["y != 0", "y - 1 != 0"])
    );
    let found = read("false", "states = 'x > 0'", "states = 'x < 1'");
    assert_eq!(
        (found.verdict(), found.evidence()),
        (Verdict::False, Some(Evidence::Witness))
    );
    assert!(found.witness().is_some());
}

#[test]
fn of_a_refuted_conjunction_each_part_is_told() {
    let symbols = "[symbols]\nx = { in = '[0, 1]' }\n";
    let claim = "states = 'x >= 0 and x > 0 and 2*x == x + x'";
    let found = common::outcomes("parts", symbols, &[claim]).remove(0);
    assert_eq!(found.verdict(), Verdict::False);
    let told: Vec<String> = words::steps(&found)
        .into_iter()
        .filter(|s| s.starts_with("the part"))
        .collect();
    assert_eq!(
        told,
        [
            "the part `x >= 0` holds, by a certificate of sign",
            "the part `x > 0` fails",
            "the part `2*x == x + x` holds, by an identity",
        ]
    );
}

#[test]
fn what_survives_under_a_condition_says_so() {
    let symbols = "[symbols]\nx = { in = '[0, 1]' }\n";
    let claims = [
        "states = 'x > 0'",
        "states = 'x/x == 1'\nuses = ['survives/1']",
    ];
    let outcomes = common::outcomes("survives", symbols, &claims);
    let outcomes: Vec<&Outcome> = outcomes.iter().collect();
    let resting = consequences("survives/1", &outcomes);
    assert_eq!(resting[0].fate, Fate::SurvivesIf);
    assert_eq!(resting[0].conditions[0].text, "x != 0");
    assert!(resting[0].fate.survives());
}
