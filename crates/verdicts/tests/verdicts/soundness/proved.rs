//! False statements that were proved, and true ones next to them.

use super::{expect, expect_one_of, expect_refuted_where, tried};
use torse_syntax::taxonomy::Verdict::{Conditional, False, Holds, Misprint, Undecided};

fn at_most(bound: f64) -> impl Fn(&str) -> bool {
    move |value| number(value) <= bound
}

/// The value of `p` or `p/q`.
fn number(text: &str) -> f64 {
    let parse = |part: &str| part.trim().parse::<f64>().expect("a rational number");
    match text.split_once('/') {
        Some((above, below)) => parse(above) / parse(below),
        None => parse(text),
    }
}

#[test]
fn a_bound_from_above_proves_no_bound_from_below() {
    let lines = "assume = ['2*a < 1']\nstates = 'a > 0'";
    expect_refuted_where("above", lines, "a", at_most(0.0));
}

#[test]
fn an_assumption_that_is_always_true_proves_no_square_negative() {
    let lines = "assume = ['2*a^2 > -1']\nstates = 'a^2 < 0'";
    expect("square", lines, False);
}

#[test]
fn a_fractional_multiple_of_an_assumption_is_used_with_its_sign() {
    let lines = "assume = ['2*a < 1']\nstates = 'a < 1/2'";
    expect("half", lines, Holds);
    let lines = "assume = ['3*a + 2*b < 1']\nstates = '6*a + 4*b < 2'";
    expect("twice", lines, Holds);
    let lines = "assume = ['3*a + 2*b < 1']\nstates = 'a + b > -1/2'";
    expect("other-way", lines, False);
}

#[test]
fn a_sum_whose_index_stands_in_an_argument_is_no_basis_sum() {
    let lines = "states = 'sum(i, 0, m, B[i,m](i*x)) == 1'";
    expect("argument", lines, False);
}

#[test]
fn a_derivative_in_a_function_is_taken_before_the_argument_is_put_in() {
    let head = "let = { \"C(x)\" = 'sum(i, 0, m, B[i,m](x)*P[i])', \"V(x)\" = 'D(C(x), x)' }\n";
    let zero = format!("{head}states = 'V(0) == 0'");
    expect("derivative-zero", &zero, False);
    let right = format!("{head}states = 'V(0) == m*(P[1] - P[0])'");
    expect("derivative-right", &right, Holds);
}

#[test]
fn at_in_a_function_replaces_its_own_name_only() {
    let head = "let = { \"G(x)\" = 'at(x^2, x, 3)' }\n";
    expect("at-bound", &format!("{head}states = 'G(5) == 25'"), False);
    expect("at-right", &format!("{head}states = 'G(5) == 9'"), Holds);
}

#[test]
fn a_derivative_is_taken_before_an_assumed_value_is_put_in() {
    let identity = "kind = \"identity\"\nassume = ['x == 1']\n";
    let right = format!("{identity}states = 'D(x^2, x) == 2'");
    expect("assumed-value", &right, Holds);
    let wrong = format!("{identity}states = 'D(x^2, x) == 0'");
    expect_one_of("assumed-zero", &wrong, &[False, Misprint]);
}

#[test]
fn a_partial_derivative_does_not_follow_an_assumed_equation() {
    let head = "assume = ['y == 1/x', 'x > 0']\n";
    expect("total", &format!("{head}states = 'D(x*y, x) == 0'"), False);
    expect(
        "partial",
        &format!("{head}states = 'D(x*y, x) == y'"),
        Holds,
    );
}

#[test]
fn a_derivative_by_a_parameter_is_taken_before_its_value_is_put_in() {
    let head = "symbols = { mu = {} }\nlet = { \"F(x)\" = 'x*mu' }\n";
    let wrong = format!("{head}states = 'D(F, mu)(mu) == 2*mu'");
    expect("parameter-wrong", &wrong, False);
    let right = format!("{head}states = 'D(F, mu)(mu) == mu'");
    expect("parameter-right", &right, Holds);
}

#[test]
fn a_denial_next_to_it_does_not_make_a_statement_one_about_some_degree() {
    let lines = "states = 'sum(j, 1, m, j) <= 3 and fails(x == 0)'";
    expect_refuted_where("denial", lines, "m", |m| number(m) >= 3.0);
}

#[test]
fn a_denial_of_what_is_true_is_false_wherever_the_statement_beside_it_has_a_value() {
    for states in [
        "sqrt(-x) >= 0 and fails(sqrt(x) >= 0)",
        "fails(sqrt(x) >= 0) and sqrt(-x) >= 0",
        "1/x == 1/x and fails(x == x)",
        "log(x) == log(x) and fails(x^2 >= 0)",
        "fails(x == 1) and fails(x == x)",
        "fails(x == x) and fails(x == 1)",
    ] {
        let lines = format!("symbols = {{ x = {{}} }}\nstates = '{states}'");
        expect("denied", &lines, False);
    }
    // It says nothing where it has none.
    for (assumed, states) in [
        ("x == 0", "1/x == 1/x and fails(x == x)"),
        ("x <= 0", "exp(log(x)) == x and fails(x == x)"),
        ("x == x", "sqrt(-1 - x^2) == 1 and fails(x == x)"),
    ] {
        let head = "symbols = { x = {} }\n";
        let lines = format!("{head}assume = ['{assumed}']\nstates = '{states}'");
        expect("nowhere", &lines, Undecided);
    }
}

#[test]
fn at_replaces_an_integer_in_indices_too() {
    let head = "symbols = { m = { integer = \">= 2\" } }\n";
    let wrong = format!("{head}states = 'at(m*P[m], m, 2) == 2*P[m]'");
    expect("index-wrong", &wrong, False);
    let right = format!("{head}states = 'at(m*P[m], m, 2) == 2*P[2]'");
    expect("index-right", &right, Holds);
}

#[test]
fn a_name_of_the_engines_own_cannot_be_written() {
    let lines = "symbols = { \"x½\" = { in = \"[-5, -4]\" } }\nstates = 'sin(pi/2*x) + x½ >= 0'";
    if let Ok(found) = tried("half-angle", lines) {
        assert_eq!(found.verdict(), False, "{found:#?}");
    }
}

#[test]
fn variation_diminishes_only_for_functions_that_sum_to_one() {
    let basis = "[basis.A]\nvariable = \"x\"\ndegree = 0\nseeds = ['1']\nstep = ['1', 'x']\n";
    let declarations = format!("{}{basis}", super::DECLARATIONS);
    let lines = "states = 'variation_diminishing(A)'";
    let found = crate::common::outcomes("variation", &declarations, &[lines]).remove(0);
    assert_eq!(found.verdict(), False, "{found:#?}");
    let lines = "states = 'variation_diminishing(B)'";
    expect("variation-bernstein", lines, Holds);
}

#[test]
fn a_derivative_reaches_the_symbols_in_the_seeds_of_a_basis() {
    let basis = "[basis.A]\nvariable = \"x\"\ndegree = 0\nseeds = ['a']\nstep = ['1 - x', 'x']\n";
    let declarations = format!("{}{basis}", super::DECLARATIONS);
    let claims = [
        "states = 'D(A[0,0](x), a) == 1'",
        "states = 'D(A[0,0](x), a) == 0'",
        "states = 'at(A[0,0](x), a, 3) == 3'",
    ];
    let found = crate::common::outcomes("seeds", &declarations, &claims);
    let verdicts: Vec<_> = found.iter().map(|outcome| outcome.verdict()).collect();
    assert_eq!(verdicts, [Holds, False, Holds], "{found:#?}");
}

#[test]
fn a_degree_below_that_of_the_seeds_is_an_empty_sum() {
    for (number, range) in [">= 2", "2..5"].into_iter().enumerate() {
        let lines = format!(
            "symbols = {{ m = {{ integer = \"{range}\" }} }}\nstates = 'sum(i, 0, m-3, B[i,m-3](x)) == 1'"
        );
        expect_refuted_where(&format!("empty-{number}"), &lines, "m", |m| m == "2");
    }
    let lines =
        "symbols = { m = { integer = \">= 3\" } }\nstates = 'sum(i, 0, m-3, B[i,m-3](x)) == 1'";
    expect("full", lines, Holds);
}

#[test]
fn a_sum_that_runs_over_the_last_point_is_an_error() {
    let lines = "states = 'sum(i, 0, m, B[i,m](x)*P[i+1]) == 0'";
    let error = tried("beyond", lines).expect_err("P[m+1] is outside 0..m");
    assert!(error.contains("outside"), "{error}");
}

#[test]
fn a_condition_is_no_way_around_an_index_left_free() {
    let lines = "states = 'sum(i, 0, m, B[i,m](x)*i/i) == 1'";
    let found = tried("free-index", lines);
    assert!(
        found
            .as_ref()
            .is_ok_and(|f| ![Holds, Conditional].contains(&f.verdict()))
            || found.is_err(),
        "the term is undefined at i = 0: {found:#?}"
    );
}

#[test]
fn an_alternative_of_hypotheses_proves_what_follows_from_each() {
    let lines = |statement: &str| format!("assume = ['a > 0 or b > 0']\nstates = '{statement}'");
    expect("each", &lines("fails(a > 0 and b > 0)"), Holds);
    expect("one", &lines("a + b > 0"), False);
    let apart = "assume = ['a > b or a < b']\nstates = 'a != b'";
    expect("apart", apart, Holds);
    let lines = "assume = ['a > 0 implies b > 0', 'a > 0']\nstates = 'b > 0'";
    expect("modus-ponens", lines, Holds);
}

#[test]
fn an_implication_is_its_conclusion_where_its_premise_holds() {
    expect("above-one", "states = 'a > 1 implies 2*a > 2'", Holds);
    expect_refuted_where(
        "above-minus-one",
        "states = 'a > -1 implies a^2 > 1'",
        "a",
        |a| number(a) > -1.0,
    );
    expect(
        "zero",
        "states = 'a*b == 0 implies (a == 0 or b == 0)'",
        Holds,
    );
    expect("empty", "states = 'a^2 < 0 implies b == 1'", Holds);
}

#[test]
fn zero_is_no_product_of_what_differs_from_zero() {
    // The only alternative that is left has the difference 0.
    expect("zero", "states = 'a != a or b == 1'", False);
    expect("zeros", "states = '(a != a or b != b) or b > 0'", False);
}

#[test]
fn what_is_assumed_bounds_products_and_quotients() {
    let lines =
        |assumed: &str, statement: &str| format!("assume = ['{assumed}']\nstates = '{statement}'");
    for (assumed, statement) in [
        ("a > 1", "a^2 > 1"),
        ("a > 1", "1/(a^2 - 1) > 0"),
        ("1 - 2*a < -1", "a^2 > 1"),
        ("a >= 1 and b > 2", "a*b > 1"),
        ("0 < a < 1/2", "a*(1 - a) < 1/4"),
        ("x > 1/2", "x^2 > 1/4"),
        ("m >= 4", "m^2 >= 16"),
        ("a*b > 0", "b/a > 0"),
        ("a*b < 0", "2*b/(3*a) < 0"),
    ] {
        expect("bounded", &lines(assumed, statement), Holds);
    }
    for (assumed, statement) in [
        ("a >= 1", "a^2 > 1"),
        ("a > -1", "a^2 > 1"),
        ("a > 1", "a^2 > 2"),
        ("a*b > 1", "a^2 > 1"),
        ("0 < a < 2", "a*(1 - a) < 1/4"),
        ("m >= 3", "m^2 >= 16"),
        ("a*b > 0", "b/a > 1"),
        ("a*b > 0", "a/b^2 > 0"),
    ] {
        expect("not-bounded", &lines(assumed, statement), False);
    }
}
