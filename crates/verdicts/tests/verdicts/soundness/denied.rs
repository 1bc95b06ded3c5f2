//! `fails(p)`, properties of a basis whose shape parameters have values, and points that satisfy an equation only nearly.

use super::adversary::{found, found_open};
use torse_syntax::taxonomy::Verdict::{Conditional, False, Holds, Undecided, Vacuous};

/// At c = 1 the functions are those of Bernstein; beyond it the second one is negative at x = 0.
const SHAPED: &str = r#"
[symbols]
x = { in = "[0, 1]" }
c = { in = "[0, 2]" }
e = { in = "[-1, 2]" }
y = { in = "[0, 1]" }
[basis.A]
variable = "x"
parameters = ["c"]
degree = 1
seeds = ["(1 - x)*c", "1 - (1 - x)*c"]
step = ["1 - x", "x"]
[basis.G]
variable = "x"
parameters = ["c", "e"]
degree = 1
seeds = ["(1 - x)*c*e", "x"]
step = ["1 - x", "x"]
"#;

#[test]
fn a_shape_parameter_has_the_value_that_a_hypothesis_gives_it() {
    for value in [
        "c == 1",
        "2*c == 1",
        "c == 1 - y^2",
        "c == y",
        "c*(1 + y^2) == 1",
    ] {
        let lines = format!("assume = ['{value}']\nstates = 'nonnegative(A)'");
        found(SHAPED, &lines, &[Holds, Undecided]);
        let lines = format!("assume = ['{value}']\nstates = 'fails(nonnegative(A))'");
        found(SHAPED, &lines, &[False, Undecided]);
        let lines = format!("states = 'fails({value} implies nonnegative(A))'");
        found(SHAPED, &lines, &[False, Undecided]);
    }
    found(
        SHAPED,
        "given = ['c == 1']\nsolve_for = ['c']\nstates = 'fails(nonnegative(A))'",
        &[False, Undecided],
    );
    for value in ["e == 1", "e == c", "e*c == 0"] {
        let lines = format!("assume = ['{value}']\nstates = 'fails(nonnegative(G))'");
        found(SHAPED, &lines, &[False, Undecided]);
    }
    // What is false stays false.
    found(
        SHAPED,
        "assume = ['c == 2 - y^2']\nstates = 'nonnegative(A)'",
        &[False, Undecided],
    );
    found(
        SHAPED,
        "assume = ['e == c - 1']\nstates = 'fails(nonnegative(G))'",
        &[Holds, Undecided],
    );
}

#[test]
fn a_shape_parameter_that_is_a_definition_is_no_number_of_the_point() {
    for states in ["nonnegative(A)", "fails(nonnegative(A))"] {
        let lines = format!("let = {{ c = '1' }}\nstates = '{states}'");
        found(SHAPED, &lines, &[Undecided]);
    }
}

#[test]
fn a_property_of_a_basis_is_about_all_values_of_its_variable() {
    for assumed in ["x > 1/2", "x == 1/2", "c == x", "x >= c"] {
        let lines = format!("assume = ['{assumed}', 'c < 3/2']\nstates = 'nonnegative(A)'");
        found(SHAPED, &lines, &[False, Undecided]);
    }
}

#[test]
fn what_is_said_to_fail_somewhere_is_seen_to_fail_there() {
    let numbers = "[symbols]\nn = { integer = \">= 0\" }\nx = {}\ny = {}\nz = {}\n";
    for (premise, conclusion) in [
        ("(sum(i, 0, n, i) - 55)*y == 0", "y == 0"),
        ("sum(i, 0, n, i)*y == 55*y", "y == 0"),
        ("(sum(i, 0, n, i^2) - 385)*y == 0", "y == 0"),
        ("(sum(i, 0, n, i) - 55)*(x - y) == 0", "x <= y"),
        ("(n^2 - 100)*y == 0", "y == 0"),
        ("x*(y - x) == 0", "x == y"),
        ("(z - 3)*y == 0", "y == 0"),
        ("(integral(exp(x), x, 0, z) - 7)*y == 0", "y == 0"),
    ] {
        let lines = format!("states = 'fails({premise} implies {conclusion})'");
        found(numbers, &lines, &[Holds, Undecided]);
    }
    for true_everywhere in ["y^2 >= 0", "x == y implies x^2 == y^2", "x*y == y*x"] {
        let lines = format!("states = 'fails({true_everywhere})'");
        found(numbers, &lines, &[False]);
    }
}

#[test]
fn an_end_that_does_not_belong_to_a_set_is_no_point_of_it_however_near() {
    let within = |set: &str| format!("[symbols]\nx = {{ in = \"{set}\" }}\ny = {{}}\n");
    for (set, statement) in [
        ("(0, pi)", "sin(x) != 0"),
        ("(0, pi/2)", "sin(2*x) != 0"),
        ("(-pi, pi)", "cos(x/2) != 0"),
        ("(0, pi)", "sin(x)*y == 0 implies y == 0"),
        ("[0, pi/2)", "cos(x)*y == 0 implies y == 0"),
        ("(0, pi/4)", "y*(tan(x) - 1) == 0 implies y == 0"),
    ] {
        found(&within(set), &format!("states = '{statement}'"), &[Holds]);
    }
    found(
        &within("(0, pi)"),
        "assume = ['sin(x) == 0']\nstates = 'x == 7'",
        &[Vacuous, Undecided],
    );
    // The end itself is one.
    found(&within("(0, pi]"), "states = 'sin(x) != 0'", &[False]);
}

#[test]
fn an_equation_that_comes_nearer_to_true_without_end_has_no_solution() {
    let numbers = "[symbols]\nx = {}\ny = {}\n";
    found(numbers, "states = 'tanh(x) != 1'", &[Holds, Undecided]);
    found(
        numbers,
        "assume = ['tanh(x) == y']\nstates = 'y < 1'",
        &[Holds, Undecided],
    );
    found(
        numbers,
        "assume = ['tanh(x) == y']\nstates = 'fails(y < 1)'",
        &[False, Undecided],
    );
    found(
        numbers,
        "states = '(x^2 - 2)*y == 0 implies y == 0'",
        &[Conditional],
    );
}

#[test]
fn a_factor_that_cancels_in_a_hypothesis_does_not_vanish() {
    let unit = "[symbols]\nx = { in = \"[0, 1]\" }\ny = { in = \"(-1, 1)\" }\n";
    for (assumed, states) in [
        ("(x - 1)*(x/x) == 0", "x == 1"),
        ("(abs(x) - 1)*(x/x) == 0", "x == 1"),
    ] {
        let lines = format!("assume = ['{assumed}']\nstates = '{states}'");
        found(unit, &lines, &[Holds]);
    }
    found(
        unit,
        "assume = ['(y/y)*(y - 0) == 0']\nstates = 'y == 1'",
        &[Vacuous, Undecided],
    );
}

#[test]
fn a_condition_that_denies_the_conclusion_is_no_condition() {
    let vectors = "[symbols]\np = { vector = 3 }\nq = { vector = 3 }\nr = { vector = 3 }\n";
    found(
        vectors,
        "states = 'dot(p, q) == dot(p, r) and cross(p, q) == cross(p, r) and norm(p) > 0 implies q == r'",
        &[Holds, Undecided],
    );
}

#[test]
fn a_refuted_property_names_the_value_that_a_hypothesis_gives_a_parameter() {
    let steps = r#"
[symbols]
x = { in = "[0, 1]" }
d = { in = "[0, 3]" }
y = {}
[basis.I]
variable = "x"
parameters = ["d"]
degree = 1
seeds = ["1 - d*x", "d*x"]
step = ["1 - d*x", "d*x"]
"#;
    let outcome = found(
        steps,
        "assume = ['d == 2']\nstates = 'variation_diminishing(I)'",
        &[False, Undecided],
    );
    if let Some(witness) = outcome.witness() {
        assert!(
            witness
                .at
                .iter()
                .any(|(name, value)| name == "d" && value == "2")
        );
    }
}

#[test]
fn no_condition_is_needed_because_one_witness_has_no_value_there() {
    let numbers = "[symbols]\na = {}\nb = {}\nc = {}\nv = {}\nw = {}\n";
    for (exists, assumed, states) in [
        ("['v', 'w']", "a^2 + b^2 > 0", "v*a + w*b == c"),
        ("['v', 'w']", "a^2 + b^2 == 1", "v*a + w*b == 1"),
        ("['v']", "c^2 == a^2", "v*a == c"),
    ] {
        let lines = format!("exists = {exists}\nassume = ['{assumed}']\nstates = '{states}'");
        found_open(numbers, &lines, &[Holds, Conditional, Undecided]);
        let paper = crate::common::loaded("witnesses", numbers, &[&lines]).unwrap();
        let claim = &paper.claims[0];
        let outcome = torse_verdicts::engine::decide_claim("witnesses", claim).unwrap();
        let mut conditions = outcome.net().into_iter().flat_map(|net| &net.conditions);
        assert!(conditions.all(|own| !own.seen_needed()), "{outcome:#?}");
    }
}
