//! Claims that say that there are numbers: with the numbers, found, and without any.

use crate::common;

use torse_syntax::taxonomy::Verdict::{Conditional, False, Holds, Undecided};
use torse_verdicts::engine::decide_claim;
use torse_verdicts::outcome::Outcome;

const SHARED: &str = r#"
[symbols]
x = { in = "[0, 1]" }
a = {}
b = {}
r = {}
s = {}
t = { in = "[0, 1]" }
u = { in = "(0, 1)" }
v = { in = "[a, b]" }
m = { integer = ">= 1" }
p = { vector = 3 }
"#;

#[track_caller]
fn outcome(exists: &str, states: &str) -> Outcome {
    let lines = format!("exists = {exists}\nstates = \"{states}\"");
    let found = common::outcomes("there", SHARED, &[&lines]);
    let found = found.into_iter().next().expect("one claim");
    assert_eq!(found.contradiction(), None, "{lines}");
    found
}

#[track_caller]
fn refused(exists: &str, states: &str, reason: &str) {
    let found = outcome(exists, states);
    assert_eq!(found.verdict(), Undecided, "{exists} {states}");
    assert!(
        found.steps().concat().contains(reason),
        "{:?}",
        found.steps()
    );
}

#[test]
fn a_number_is_found_from_linear_equations_and_shown() {
    let found = outcome("['r', 's']", "r + s == a and r - s == b");
    assert_eq!(found.verdict(), Holds);
    assert!(
        found
            .steps()
            .contains(&"there is r = 1/2*(a + b)".to_owned())
    );
    assert!(found.net().unwrap().netted && found.replay().unwrap().replayed);
    assert_eq!(outcome("['r', 's']", "r + s == a").verdict(), Holds);
    assert_eq!(
        outcome("['r']", "r*(x + 1)/r == x + 1 and r == x + 2").verdict(),
        Holds
    );
}

#[test]
fn a_divisor_of_the_witness_is_a_condition_that_a_premise_takes_away() {
    for exists in ["['r']", "['r == b/a']"] {
        let found = outcome(exists, "r*a == b");
        assert_eq!(found.verdict(), Conditional);
        assert_eq!(found.conditions()[0].text, "a != 0");
        assert_eq!(outcome(exists, "a != 0 implies r*a == b").verdict(), Holds);
    }
}

#[test]
fn the_number_has_to_be_in_its_interval() {
    assert_eq!(outcome("['t']", "t == x^2").verdict(), Holds);
    let found = outcome("['u']", "u == x^2");
    assert_eq!(found.verdict(), False);
    assert!(
        found.steps().concat().contains("there is no u at x = 0"),
        "{:?}",
        found.steps()
    );
    assert_eq!(
        outcome("['v == (a + b)/2']", "a <= b implies 2*v == a + b").verdict(),
        Undecided
    );
    let inside = "exists = ['v == (a + b)/2']\nassume = ['a <= b']\nstates = '2*v == a + b'";
    assert_eq!(
        common::outcomes("there", SHARED, &[inside])[0].verdict(),
        Holds
    );
}

#[test]
fn a_witness_that_fails_refutes_nothing_by_itself() {
    refused(
        "['r == a']",
        "r == a + 1",
        "it is not shown that no other number works there",
    );
    refused("['r']", "r^2 == a", "the witness fails");
    assert_eq!(outcome("['r == 2']", "r^2 == -1").verdict(), False);
}

#[test]
fn a_witness_has_a_value_wherever_its_divisors_do_not_vanish() {
    refused(
        "['r == sqrt(a)']",
        "r^2 == a",
        "a witness that may be undefined",
    );
    refused(
        "['r == 1/(m - 1)']",
        "r*(m - 1) == 1",
        "a witness that may be undefined",
    );
    refused(
        "['r == a^m']",
        "r == a^m",
        "a witness that may be undefined",
    );
    assert_eq!(outcome("['r == abs(a)']", "r^2 == a^2").verdict(), Holds);
    assert_eq!(
        outcome("['r == norm(p)']", "r^2 == dot(p, p)").verdict(),
        Holds
    );
}

#[test]
fn nothing_else_speaks_of_the_number() {
    refused("['r == s', 's == 1']", "r == 1", "`s` is existential");
    for states in ["fails(r == a)", "r == a and fails(r == b)"] {
        let lines = format!("exists = ['r']\nstates = '{states}'");
        let paper = common::paper("there", SHARED, &[&lines]);
        let error = decide_claim("there", &paper.claims[0]).unwrap_err();
        let error = error.to_string();
        for said in ["`fails` inside", "of a claim without `exists`"] {
            assert!(error.contains(said), "{states}: {error}");
        }
    }
    // What is denied at each point speaks of points.
    assert_eq!(outcome("['r == a + 1']", "not (r == a)").verdict(), Holds);
    let nowhere = outcome("['r']", "not (r == r)");
    assert!(
        !matches!(nowhere.verdict(), Holds | Conditional),
        "{nowhere:?}"
    );
    let assumed = "exists = ['r']\nassume = ['r > 0']\nstates = 'r == a'";
    let found = common::outcomes("there", SHARED, &[assumed]);
    assert_eq!(found[0].verdict(), Undecided);
    for exists in ["['m']", "['p']", "['r', 'r']", "['r > 1']", "['q']"] {
        let lines = format!("exists = {exists}\nstates = 'a == a'");
        assert!(
            common::loaded("there", SHARED, &[&lines]).is_err(),
            "{exists}"
        );
    }
}

#[test]
fn the_symbol_of_the_number_is_another_one_inside_of_derivatives() {
    assert_eq!(outcome("['r == x']", "D(r*x, x) == r").verdict(), Holds);
    assert_eq!(outcome("['r == x']", "D(r^2, r) == 2*x").verdict(), Holds);
}
