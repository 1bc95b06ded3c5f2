//! Claims that say that there are numbers: with the numbers, found, and without any.

use crate::common;

use torse_numbers::fault_injection::{InjectedFault, with};
use torse_syntax::taxonomy::Verdict::{Conditional, False, Holds, Undecided};
use torse_verdicts::engine::decide_claim;
use torse_verdicts::outcome::Outcome;
use torse_verdicts::recheck::{Recheck, claim as recheck};
use torse_verdicts::words;

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
        words::steps(&found).concat().contains(reason),
        "{:?}",
        words::steps(&found)
    );
}

#[test]
fn a_number_is_found_from_linear_equations_and_shown() {
    let found = outcome("['r', 's']", "r + s == a and r - s == b");
    assert_eq!(found.verdict(), Holds);
    assert!(words::steps(&found).contains(&"there is r = 1/2*(a + b)".to_owned()));
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
        words::steps(&found)
            .concat()
            .contains("there is no u at x = 0"),
        "{:?}",
        words::steps(&found)
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

/// With the witness in place a root or a logarithm has no value at some of the points that the claim is about.
const UNDEFINED_SOMEWHERE: [(&str, &str); 16] = [
    ("['r == a']", "exp(log(r)) == a"),
    ("['r == a']", "sqrt(r)^2 == a"),
    ("['r == a']", "log(r) == log(r) and r == a"),
    ("['r == 1/a']", "log(a*r) == 0"),
    ("['r == a']", "1/sqrt(r) > 0 and r == a"),
    ("['r == a']", "norm([r, sqrt(r)]) >= 0 and r == a"),
    ("['r == 2']", "D(log(r*a), a) == 1/a and r == 2"),
    ("['u == a']", "log(u) == log(u) and u == a"),
    ("['r == a']", "log(r*b) == log(r) + log(b) and r == a"),
    ("['r == x - 1']", "log(r) <= r - 1 and r < x"),
    ("['r == a', 's == b']", "sqrt(r*s)^2 == a*b"),
    ("['r == a']", "a >= -1 implies sqrt(r)^2 == a"),
    ("['r == exp(1/a)']", "log(r) == log(r) and r > 0"),
    ("['r == x^2']", "log(r) == log(r) and r == x^2"),
    ("['r == a']", "sin(asin(r)) == a"),
    ("['r == a']", "atan(sqrt(r)) == atan(sqrt(r)) and r == a"),
];

#[test]
fn a_root_or_a_logarithm_of_the_number_has_a_value_or_nothing_is_said() {
    for (exists, states) in UNDEFINED_SOMEWHERE {
        refused(exists, states, "with an existential number in it");
    }
    for (exists, states) in [
        ("['r == x']", "sqrt(r)^2 == x"),
        ("['r == x + 1']", "exp(log(r)) == x + 1"),
        ("['r == exp(a)']", "log(r) == a"),
        (
            "['r == a^2 + 1']",
            "exp(log(r)) == a^2 + 1 and 1/sqrt(r) > 0",
        ),
        ("['r == u']", "log(r/(1 + x)) <= 0 and r == u"),
        ("['r == a']", "a >= 0 implies sqrt(r)^2 == a"),
        ("['r == abs(a)']", "sqrt(r)^2 == abs(a)"),
        // The claim is about points at which the logarithm without the number has a value.
        ("['r == 2']", "log(a) + log(r) == log(2*a)"),
    ] {
        assert_eq!(
            outcome(exists, states).verdict(),
            Holds,
            "{exists} {states}"
        );
    }
    let assumed = "exists = ['r == a']\nassume = ['a > 1']\nstates = 'exp(log(r)) == a'";
    let found = common::outcomes("there", SHARED, &[assumed]);
    assert_eq!(found[0].verdict(), Holds);
}

/// A part with the number in it has no value somewhere, and no condition would say so.
const UNDEFINED_WITHOUT_CONDITION: [(&str, &str); 29] = [
    // Where the premise is false the set may be empty.
    ("['e == a']", "a > 0 implies exp(log(e)) == e"),
    ("['e == a']", "a >= 0 implies sqrt(e)^2 == e"),
    // The value of a function at the number.
    ("['r == 0']", "exp(log(f(r))) == f(r) and r == 0"),
    ("['r == a']", "sqrt(f'(r))^2 == f'(r) and r == a"),
    ("['r == 0']", "1/f(r)^2 > 0 implies r == 0"),
    // Derivatives and lengths that are not used, or whose root says where they are defined.
    (
        "['r == a']",
        "[1, D(log(1 + abs(r)), r)][1] == 1 and r == a",
    ),
    (
        "['r == a']",
        "norm([1, tan(r)])^2 == 1 + tan(r)^2 and r == a",
    ),
    ("['r == a']", "0*norm([r/r, tan(r)]) == 0 and r == a"),
    (
        "['r == a']",
        "[1, norm([1, D(abs(r), r)])][1] == 1 and r == a",
    ),
    ("['r == a']", "[1, Q[1,1](u)][1] == 1 and r == a"),
    ("['r == a']", "agrees(0*Q[1,1](u), 0) and r == a"),
    // A premise that is undefined is not false.
    ("['r == a']", "1/r^2 > 0 implies a != 0"),
    ("['r == a']", "tan(r)^2 >= 0 implies cos(a) != 0"),
    (
        "['r == a']",
        "det(inverse([[r, 0], [0, 1]]))^2 > 0 implies a != 0",
    ),
    ("['r == a']", "b == b implies (1/r^2 > 0 implies a != 0)"),
    ("['r == a']", "(1/r == b implies r*b == 1) and r == a"),
    // A value that is not used.
    ("['r == a']", "log(at(u, b, 1/r)) == log(u) and r == a"),
    ("['r == a']", "log(first(r^2 + 1, tan(r))) == log(a^2 + 1)"),
    (
        "['r == a']",
        "exp(0*inverse([[1, 1/2], [1, r]])[1,1]) == 1 and r == a",
    ),
    (
        "['r == a']",
        "inverse([[1, 1/2], [1, r]])[1,1]^0 == 1 and r == a",
    ),
    ("['r == a']", "exp(0*r^(0 - 1)) == 1 and r == a"),
    ("['r == a']", "[1, r^(1 - 2)][1] == 1 and r == a"),
    ("['r == a']", "[1, r^l][1] == 1 and r == a"),
    ("['r == a']", "exp(0*N[0,1](t0, r)) == 1 and r == a"),
    // Seeds that name the number.
    ("['r == a']", "log(M[1,1](1)) == log(M[1,1](1)) and r == a"),
    ("['r == a']", "exp(0*Q[1,1](1)) == 1 and r == a"),
    (
        "['r == a']",
        "sum(i, 0, m + 1, E[i,m+1](t0, r)) == 1 and r == a",
    ),
    (
        "['r == a']",
        "product(j, 1, m, (j + 1)/j*one(1/(r + j))) == m + 1 and r == a",
    ),
    (
        "['r == a']",
        "integral(one(1/(r - t0)), t0, 0, 1) == 1 and r == a",
    ),
];

const BASES: &str = r#"
[symbols]
a = {}
b = {}
r = {}
t0 = {}
u = { in = "(0, 1)" }
e = { in = "[0, a]" }
f = { function = 1 }
l = { integer = "-2..2" }
m = { integer = ">= 1" }
[define]
"first(x, y)" = 'x'
"one(x)" = '1'
[basis.E]
variable = "t0"
parameters = ["c"]
degree = 0
seeds = ['1']
step = ['1 - t0/c', 't0/c']
[basis.N]
variable = "t0"
parameters = ["c"]
degree = 1
seeds = ['1 - t0/c', 't0/c']
step = ['1 - t0', 't0']
[basis.M]
variable = "t0"
degree = 1
seeds = ['1 - r*t0', 'r*t0']
step = ['1 - t0', 't0']
[basis.Q]
variable = "t0"
degree = 1
seeds = ['1 - t0/r', 't0/r']
step = ['1 - t0', 't0']
[basis.B]
variable = "t0"
parameters = ["c"]
degree = 1
seeds = ['1 - c*t0', 'c*t0']
step = ['1 - t0', 't0']
"#;

#[test]
fn what_may_have_no_value_is_a_condition_or_the_claim_is_refused() {
    let decided = |exists: &str, states: &str| {
        let lines = format!("exists = {exists}\nstates = \"{states}\"");
        let found = common::outcomes("there", BASES, &[&lines]);
        assert_eq!(found[0].contradiction(), None, "{lines}");
        found[0].verdict()
    };
    for (exists, states) in UNDEFINED_WITHOUT_CONDITION {
        assert_eq!(decided(exists, states), Undecided, "{exists} {states}");
    }
    for (states, verdict) in [
        ("[1, 1/r][1] == 1 and r == a", Conditional),
        ("exp(0/(r - 1)) == 1 and r == a", Conditional),
        ("sum(j, 1, 2, 0/(r - j)) == 0 and r == a", Conditional),
        ("B[0,1](t0, r) + B[1,1](t0, r) == 1 and r == a", Holds),
        ("a^2 > 0 implies 1/r^2 > 0 and r == a", Holds),
        ("(r >= 0 implies r == abs(a)) and r == a", Holds),
        ("norm([r, a])^2 == 2*a^2 and r == a", Holds),
        ("f(a) + r == f(a) + a and r == a", Holds),
    ] {
        assert_eq!(decided("['r == a']", states), verdict, "{states}");
    }
    // More divisors than are looked at.
    let many: Vec<String> = (1..=70).map(|k| format!("1/(r - {k})")).collect();
    let many = format!("[1, {}][1] == 1 and r == a", many.join(", "));
    assert_eq!(decided("['r == a']", &many), Undecided);
}

/// At some point of the other symbols an end of the set has no value: there is no set there, and so no number.
const NO_SET_SOMEWHERE: [(&str, &str); 11] = [
    ("[0, abs(log((3*a - 1)^2))]", "e == 0"),
    ("[-log((3*a - 1)^2)^2, inf)", "e == 0"),
    ("[0, 1 + 0*log((3*a - 1)^2)]", "e == 0"),
    ("[0, exp(log((3*a - 1)^2))]", "e == 0"),
    ("[0, exp(log((b - 2)^2))]", "e == 0"),
    ("[0, exp(log((b - 2)^2))]", "e <= sqrt((b - 2)^2)"),
    ("[0, sqrt(a)]", "e == 0"),
    ("[0, sqrt(a)]", "a > 1 implies e == 0"),
    ("[0, norm([1/a, 1])]", "e == 0"),
    ("[0, sqrt(1/a^2)]", "e == 0"),
    ("[0, sum(j, 1, 2, 1/(a - j))^2]", "e == 0"),
];

#[test]
fn an_end_of_the_set_of_a_number_has_a_value_or_nothing_is_said() {
    let decided = |set: &str, states: &str| {
        let lines = format!(
            "symbols = {{ e = {{ in = '{set}' }} }}\nexists = ['e == 0']\nstates = '{states}'"
        );
        let found = common::outcomes("there", SHARED, &[&lines]);
        assert_eq!(found[0].contradiction(), None, "{lines}");
        found[0].verdict()
    };
    for (set, states) in NO_SET_SOMEWHERE {
        assert_eq!(decided(set, states), Undecided, "{set} {states}");
    }
    for (set, verdict) in [
        ("[0, 1/(3*a - 1)^2]", Conditional),
        ("[0, sqrt(a^2 + 1)]", Holds),
        ("[0, sqrt(x)]", Holds),
        ("[0, log(2)]", Holds),
        ("[0, log(1 + u)]", Holds),
        ("[0, norm(p)]", Holds),
    ] {
        assert_eq!(decided(set, "e == 0"), verdict, "{set}");
    }
}

#[test]
fn the_semantics_finds_a_point_at_which_the_number_leaves_a_root_without_a_value() {
    for (exists, states) in &UNDEFINED_SOMEWHERE[..7] {
        let lines = format!("exists = {exists}\nstates = \"{states}\"");
        let found = with(InjectedFault::WitnessValueAssumed, || {
            common::outcomes("there", SHARED, &[&lines])
        });
        assert_eq!(found[0].verdict(), Undecided, "{lines}");
        let divides = words::steps(&found[0]).concat().contains("divides by zero");
        assert!(found[0].contradiction().is_some() || divides, "{lines}");
    }
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

#[test]
fn of_a_number_that_the_file_gives_nothing_says_that_a_condition_is_needed() {
    for (exists, states) in [
        ("['r == a^2/a']", "r*a == a^2"),
        ("['r == a']", "r/r == 1"),
        ("['r == b/a']", "r*a^2 == a*b"),
    ] {
        let found = outcome(exists, states);
        assert_eq!(found.verdict(), Conditional, "{exists} {states}");
        let net = found.net().unwrap();
        // Another number may do where this one has no value: r = a, 1, 0.
        let is_needed = |own: &torse_verdicts::judged::ConditionCheck| own.seen_needed();
        assert!(!net.conditions.iter().any(is_needed), "{exists} {states}");
        assert!(net.why.as_ref().unwrap().contains("another witness may do"));
    }
}

#[test]
fn numbers_that_there_are_are_not_contradicted_at_small_integers() {
    for (exists, states) in [
        ("['r', 's']", "r + s == a and r - s == b"),
        ("['r']", "2*r == a + m"),
    ] {
        let lines = format!("exists = {exists}\nstates = '{states}'");
        let paper = common::paper("there", SHARED, &[&lines]);
        let claim = &paper.claims[0];
        let found = decide_claim(&paper.head.id, claim).unwrap();
        assert_eq!(found.verdict(), Holds, "{states}");
        let again = recheck(claim, &found);
        assert!(matches!(again, Recheck::Netted(_)), "{states}: {again:?}");
    }
}
