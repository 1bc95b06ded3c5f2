//! Intervals whose ends are formulas: what they say is assumed, of every symbol that occurs.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    reason = "helpers of tests"
)]

use crate::common;

use torse_syntax::taxonomy::Verdict::{self, False, Holds};
use torse_verdicts::outcome::Outcome;
use torse_verdicts::words;

const BOUNDED: &str = r#"
[symbols]
x = {}
a = {}
b = { in = "(a, inf)" }
c = { in = "(0, inf)" }
t = { in = "[a, b]" }
s = { in = "(0, 2*c)" }
u = { in = "[0, s)" }
"#;

/// The same symbols without the ends that are formulas; the cases assume these.
const FREE: &str = r#"
[symbols]
x = {}
a = {}
b = {}
c = { in = "(0, inf)" }
t = {}
s = { in = "(0, inf)" }
u = { in = "[0, inf)" }
"#;

const CASES: [(&str, &str, Verdict); 12] = [
    ("(t - a)*(b - t) >= 0", "'a < b', 'a <= t', 't <= b'", Holds),
    ("(t - a)*(b - t) > 0", "'a < b', 'a <= t', 't <= b'", False),
    (
        "(b - t)/(b - a) + (t - a)/(b - a) == 1",
        "'a < b', 'a <= t', 't <= b'",
        Holds,
    ),
    ("(t - a)/(b - a) <= 1", "'a < b', 'a <= t', 't <= b'", Holds),
    ("(t - a)/(b - a) < 1", "'a < b', 'a <= t', 't <= b'", False),
    ("s*(2*c - s) > 0", "'s < 2*c'", Holds),
    ("s*(c - s) > 0", "'s < 2*c'", False),
    ("u < 2*c", "'u < s', 's < 2*c'", Holds),
    ("u < c", "'u < s', 's < 2*c'", False),
    ("u/s < 1", "'u < s', 's < 2*c'", Holds),
    // The variable of a derivative is not the symbol: nothing is assumed of it, and so nothing of its ends.
    ("D(t^2, t) == 2*t", "'a < b', 'a <= t', 't <= b'", Holds),
    ("x^2 + a^2 >= 0", "", Holds),
];

fn outcome(shared: &str, states: &str, assumed: &str) -> Outcome {
    let lines = format!("states = \"{states}\"\nassume = [{assumed}]");
    let mut found = common::outcomes("ends", shared, &[&lines]);
    assert_eq!(found.len(), 1, "{states}");
    found.remove(0)
}

#[test]
fn an_end_that_is_a_formula_is_what_would_be_assumed() {
    for (states, assumed, wanted) in CASES {
        let (bounded, free) = (outcome(BOUNDED, states, ""), outcome(FREE, states, assumed));
        for found in [&bounded, &free] {
            assert_eq!(
                found.verdict(),
                wanted,
                "{states}: {:#?}",
                words::steps(found)
            );
            assert_eq!(found.contradiction(), None, "{states}");
        }
        assert_eq!(bounded.conditions(), free.conditions(), "{states}");
    }
}

#[test]
fn what_fails_outside_of_the_interval_alone_holds_and_what_fails_inside_has_a_witness_there() {
    assert_eq!(outcome(BOUNDED, "t >= a", "").verdict(), Holds);
    let slip = outcome(BOUNDED, "t >= a + (b - a)/2", "");
    assert_eq!(slip.verdict(), False);
    let witness = slip.witness().expect("a point at which it fails");
    assert!(format!("{witness:?}").contains('t'), "{witness:?}");
    // Nothing is known of t where it has no declared interval.
    assert_eq!(outcome(FREE, "t >= a", "").verdict(), False);
}

#[test]
fn an_end_does_not_bound_what_does_not_occur() {
    // There is no t with a <= t <= b where b < a; of the claims about a and b alone none gets that for free.
    let shared = "[symbols]\na = {}\nb = {}\nt = { in = \"[a, b]\" }\nf = { function = 1 }\n";
    assert_eq!(outcome(shared, "a <= b", "").verdict(), False);
    assert_eq!(
        outcome(shared, "at(t^2, t, b) >= a - b", "").verdict(),
        False
    );
    assert_eq!(outcome(shared, "t - t >= a - b", "").verdict(), Holds);
}
