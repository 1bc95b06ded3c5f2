//! Hypotheses that are ours: needed ones are conditions, others are dropped, in the order of the file.

use crate::common;

use torse_syntax::taxonomy::Verdict;
use torse_verdicts::claim_record::{HypothesisSource, Role};
use torse_verdicts::outcome::Outcome;

const SYMBOLS: &str = r#"
[symbols]
x = {}
y = {}
mu = { in = "[-1, 1]" }
"#;

fn outcome(name: &str, lines: &str) -> Outcome {
    common::outcomes(name, SYMBOLS, &[lines]).remove(0)
}

/// Verdict, conditions, and whether each hypothesis is needed.
fn told(outcome: &Outcome) -> (Verdict, Vec<&str>, Vec<Option<bool>>) {
    let conditions = outcome.conditions().iter().map(|c| c.text.as_str());
    let needed = outcome.claim.assumed.iter().map(|h| h.needed);
    (outcome.verdict(), conditions.collect(), needed.collect())
}

#[test]
fn a_needed_hypothesis_of_ours_is_a_condition() {
    let ours = "assume = [{ states = 'x > 1', ours = 'why' }]\nstates = 'x > 0'";
    let found = outcome("ours", ours);
    assert_eq!(
        told(&found),
        (Verdict::Conditional, vec!["x > 1"], vec![Some(true)])
    );
    let net = found.net().unwrap();
    assert!(net.netted, "{net:?}");
    assert!(net.conditions[0].failing > 0, "{net:?}");
    assert!(
        matches!(&found.claim.assumed[0].from, HypothesisSource::Ours { reason } if reason == "why")
    );
}

#[test]
fn the_same_hypothesis_carries_a_verdict_if_it_is_printed_or_stated() {
    for entry in ["'x > 1'", "{ states = 'x > 1', printed = 'p' }"] {
        let lines = format!("assume = [{entry}]\nstates = 'x > 0'");
        let found = outcome("printed", &lines);
        assert_eq!(
            told(&found),
            (Verdict::Holds, vec![], vec![None]),
            "{entry}"
        );
    }
}

#[test]
fn an_unneeded_hypothesis_of_ours_is_none() {
    let lines = "assume = [{ states = 'x > 1', ours = 'why' }]\nstates = 'x^2 >= 0'";
    let found = outcome("unneeded", lines);
    assert_eq!(told(&found), (Verdict::Holds, vec![], vec![Some(false)]));
}

#[test]
fn of_two_hypotheses_of_which_either_suffices_the_first_goes() {
    let either = |first: &str, second: &str| {
        let entry = |states: &str| format!("{{ states = '{states}', ours = 'why' }}");
        let lines = format!(
            "assume = [{}, {}]\nstates = 'x > 0'",
            entry(first),
            entry(second)
        );
        outcome("either", &lines)
    };
    let needed = vec![Some(false), Some(true)];
    let found = either("x > 1", "x > 2");
    assert_eq!(
        told(&found),
        (Verdict::Conditional, vec!["x > 2"], needed.clone())
    );
    let found = either("x > 2", "x > 1");
    assert_eq!(told(&found), (Verdict::Conditional, vec!["x > 1"], needed));
}

#[test]
fn a_range_of_ours_falls_back_to_the_one_it_narrows_or_to_the_line() {
    let narrowed = "symbols = { mu = { in = '(0, 1]', ours = 'why' } }\nstates = ";
    let found = outcome("narrowed", &format!("{narrowed}'mu > 0'"));
    assert_eq!(
        told(&found),
        (Verdict::Conditional, vec!["0 < mu <= 1"], vec![Some(true)])
    );
    assert_eq!(found.claim.assumed[0].role, Role::Range);
    let found = outcome("outer", &format!("{narrowed}'mu >= -1'"));
    assert_eq!(told(&found), (Verdict::Holds, vec![], vec![Some(false)]));
    let new = "symbols = { t = { in = '[0, 1]', ours = 'why' } }\nstates = 't >= 0'";
    let found = outcome("line", new);
    assert_eq!(
        told(&found),
        (Verdict::Conditional, vec!["0 <= t <= 1"], vec![Some(true)])
    );
}

#[test]
fn a_hypothesis_that_only_excludes_a_zero_divisor_leaves_the_divisor_as_the_condition() {
    let lines = "assume = [{ states = 'y > 3', ours = 'why' }]\nstates = 'y/y == 1'";
    let found = outcome("divisor", lines);
    assert_eq!(
        told(&found),
        (Verdict::Conditional, vec!["y != 0"], vec![Some(false)])
    );
}

#[test]
fn an_equation_of_ours_is_a_condition_wherever_it_stands() {
    let assumed = "assume = [{ states = 'x == y', ours = 'why' }]\nstates = 'x^2 == x*y'";
    let found = outcome("assumed", assumed);
    assert_eq!(
        told(&found),
        (Verdict::Conditional, vec!["x == y"], vec![Some(true)])
    );
    assert!(found.net().unwrap().netted, "{:?}", found.net());
    let given = "given = ['x == 1', { states = 'y == 2', ours = 'why' }]\nsolve_for = ['x', 'y']\nstates = 'x + y == 3'";
    let found = outcome("given", given);
    assert_eq!(
        told(&found),
        (Verdict::Conditional, vec!["y == 2"], vec![None, Some(true)])
    );
}

#[test]
fn a_correction_has_the_hypotheses_of_ours_that_it_needs_as_conditions() {
    let lines = "kind = 'identity'\nassume = [{ states = 'x == y', ours = 'why' }]\nstates = '2*x + x^2 == 3*y + x*y'";
    let found = outcome("corrected", lines);
    let correction = found.correction().expect("it is a misprint");
    let conditions: Vec<&str> = correction
        .conditions
        .iter()
        .map(|c| c.text.as_str())
        .collect();
    assert_eq!(
        (found.verdict(), conditions),
        (Verdict::Misprint, vec!["x == y"])
    );
}

#[test]
fn a_refutation_drops_nothing() {
    let lines = "assume = [{ states = 'x > 1', ours = 'why' }]\nstates = 'x > 3'";
    let found = outcome("refuted", lines);
    assert_eq!(told(&found), (Verdict::False, vec![], vec![None]));
}
