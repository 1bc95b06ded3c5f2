//! True statements that were called false or vacuous.

use super::{expect, expect_one_of, expect_refuted_where, outcome};
use torse_syntax::taxonomy::Verdict::{Conditional, False, Holds, Undecided, Vacuous};

/// The first 160 digits of pi after the point.
const PI: &str = "3.1415926535897932384626433832795028841971693993751058209749445923078164062862089986280348253421170679821480865132823066470938446095505822317253594081284811174502";

#[test]
fn integers_under_a_sine_are_integers() {
    let lines = "states = 'sin(pi*m) == 0'";
    expect_one_of("sine", lines, &[Holds, Undecided]);
    let lines = "states = 'cos(pi*m) == 1'";
    expect("cosine", lines, False);
}

#[test]
fn an_index_stays_below_the_integer_that_bounds_it() {
    let lines = "symbols = { i = { integer = \"0..m\" } }\nstates = 'i <= m'";
    expect("below", lines, Holds);
}

#[test]
fn an_index_stays_below_the_greatest_value_of_its_bound() {
    let lines = "symbols = { m = { integer = \"1..2\" }, i = { integer = \"0..m\" } }\nstates = 'sum(j, 1, i, j) <= 3'";
    expect("greatest", lines, Holds);
}

#[test]
fn two_names_for_one_point_have_one_value() {
    let lines = "symbols = { o = { integer = \"0..1\" } }\nstates = '(1-o)*P[0] + o*P[1] == P[o]'";
    expect("two-names", lines, Holds);
}

#[test]
fn an_eliminated_symbol_leaves_its_range_behind() {
    let lines = "assume = ['x == y^2']\nstates = 'y <= 1'";
    expect_one_of("range", lines, &[Holds, Undecided]);
    let simplex = "symbols = { u = { in = \"[0, 1]\" }, v = { in = \"[0, 1]\" }, w = { in = \"[0, inf)\" } }\n";
    let lines = format!("{simplex}assume = ['w == 1 - u - v']\nstates = 'u + v <= 1'");
    expect("simplex", &lines, Holds);
}

#[test]
fn an_unknown_leaves_its_range_behind() {
    let simplex = "symbols = { u = { in = \"[0, 1]\" }, v = { in = \"[0, 1]\" }, w = { in = \"[0, inf)\" } }\n";
    let lines =
        format!("{simplex}given = ['u + v + w == 1']\nsolve_for = ['w']\nstates = 'u + v <= 1'");
    expect("unknown", &lines, Holds);
}

#[test]
fn an_eliminated_integer_leaves_its_range_and_its_integrality_behind() {
    let integers = "symbols = { n = { integer = \">= -5\" } }\n";
    let lines = format!("{integers}assume = ['m == n - 3']\nstates = 'n >= 4'");
    expect("integers", &lines, Holds);
    let lines = "assume = ['m == 2*a']\nstates = '4*a^2 >= 1'";
    expect("doubled", lines, Holds);
    let lines = "assume = ['m == 2*a']\nstates = '2*a != 3/2'";
    expect_one_of("integral", lines, &[Holds, Undecided]);
}

#[test]
fn an_equation_outside_of_the_declared_range_is_vacuous() {
    expect("outside", "assume = ['x == 2']\nstates = 'y == 0'", Vacuous);
    let lines = "assume = ['x == 2 + y^2']\nstates = 'y == 0'";
    expect("outside-by-a-square", lines, Vacuous);
    let lines = "assume = ['m == 1/2']\nstates = 'y == 0'";
    expect("no-integer", lines, Vacuous);
    let lines = "given = ['x + 1 == 3']\nsolve_for = ['x']\nstates = 'y == 0'";
    expect("outside-given", lines, Vacuous);
}

#[test]
fn a_replaced_symbol_is_replaced_in_every_constraint() {
    let lines = "assume = ['x > 0', 'x == -y']\nstates = 'y < 0'";
    expect("constraint", lines, Holds);
    let lines = "assume = ['x == -y', 'x > 0']\nstates = 'y < 0'";
    expect("constraint-after", lines, Holds);
}

#[test]
fn an_equation_for_a_symbol_in_its_own_terms_is_respected() {
    let lines = "assume = ['y == y^2']\nstates = 'y^2 - y == 0'";
    expect("self", lines, Holds);
    let lines = "assume = ['y == y^2']\nstates = 'y == 1'";
    expect_one_of("self-false", lines, &[False, Undecided]);
}

#[test]
fn a_factor_of_a_product_that_is_one_does_not_vanish() {
    let lines = "assume = ['a*b == 1']\nstates = 'b != 0'";
    expect("factor", lines, Holds);
}

#[test]
fn a_product_that_vanishes_has_two_branches() {
    let lines = "assume = ['a*b == 0', '1 + a < 1/2']\nstates = 'b >= 0'";
    expect("branch", lines, Holds);
    let lines = "assume = ['a*b == 0']\nstates = 'b == 0'";
    expect_one_of("one-branch", lines, &[False, Conditional, Undecided]);
}

#[test]
fn a_basis_is_not_tried_at_an_open_end() {
    let basis = "[basis.A]\nvariable = \"x\"\nparameters = [\"mu\"]\ndegree = 1\nseeds = ['1', 'mu*x']\nstep = ['1 - x', 'x']\n";
    let declared = |range: &str| {
        let symbols = format!("[symbols]\nmu = {{ in = \"{range}\" }}");
        let declarations = super::DECLARATIONS.replace("[symbols]", &symbols);
        format!("{declarations}{basis}")
    };
    let lines = "states = 'independent(A)'";
    let found = crate::common::outcomes("open-end", &declared("(0, 1]"), &[lines]).remove(0);
    assert_eq!(found.verdict(), Undecided, "{found:#?}");
    let found = crate::common::outcomes("closed-end", &declared("[0, 1]"), &[lines]).remove(0);
    assert_eq!(found.verdict(), False, "{found:#?}");
}

#[test]
fn an_excluded_degree_does_not_make_the_others_vacuous() {
    let lines = "assume = ['m >= 2']\nstates = 'sum(j, 1, m, j) <= 3'";
    expect_refuted_where("excluded", lines, "m", |m| {
        m.parse::<u32>().is_ok_and(|m| m >= 3)
    });
    let lines = "symbols = { m = { integer = \"1..3\" } }\nassume = ['m <= 2']\nstates = 'sum(j, 1, m, j) <= 3'";
    expect("excluded-last", lines, Holds);
}

#[test]
fn printed_decimals_have_digits_of_their_own_each() {
    expect(
        "digits",
        "states = 'agrees([0.13, 0.12], [0.1, 0.12])'",
        Holds,
    );
    expect(
        "digits-wrong",
        "states = 'agrees([0.13, 0.12], [0.2, 0.12])'",
        False,
    );
    expect(
        "negative-zero",
        "states = 'agrees([-0.004, 0.5], [-0.00, 0.5])'",
        Holds,
    );
}

#[test]
fn many_printed_digits_are_compared_to_the_last() {
    for digits in [20, 76, 77, 78, 100, 300] {
        let threes = "3".repeat(digits);
        let lines = format!("states = 'agrees(1/3, 0.{threes})'");
        expect(&format!("threes-{digits}"), &lines, Holds);
        let lines = format!("states = 'agrees(1/3, 0.{threes}4)'");
        expect(&format!("threes-wrong-{digits}"), &lines, False);
    }
}

#[test]
fn a_point_whose_assumption_is_not_settled_refutes_nothing() {
    // pi minus these digits is about 2.8e-160, so the assumption says that y is negative.
    let lines = format!("assume = ['(pi - {PI})*y < 0']\nstates = 'y < 0'");
    expect_one_of("unsettled", &lines, &[Holds, Undecided]);
    let lines = format!("assume = ['pi < {PI}']\nstates = 'y == 0'");
    expect_one_of("unsettled-vacuous", &lines, &[Vacuous, Undecided]);
}

#[test]
fn a_witness_satisfies_its_assumptions_and_ranges() {
    let found = outcome(
        "inside",
        "assume = ['x == y^2', 'y > 0']\nstates = 'y < 1/2'",
    );
    assert_eq!(found.verdict(), False, "{found:#?}");
    let witness = found.witness().expect("a point");
    let y = witness
        .at
        .iter()
        .find(|(name, _)| name == "y")
        .map(|(_, value)| value.clone());
    let x = witness
        .at
        .iter()
        .find(|(name, _)| name == "x")
        .map(|(_, value)| value.clone());
    assert!(y.is_some(), "{:?}", witness.at);
    if let (Some(x), Some(y)) = (x, y) {
        let check = format!("states = '({x}) == ({y})^2 and ({y}) >= 1/2 and ({x}) <= 1'");
        expect("inside-check", &check, Holds);
    }
}
