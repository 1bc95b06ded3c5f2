//! Statements as one types them, each with its verdict by hand, by what went wrong.

use torse_syntax::derivation::question;
use torse_verdicts::engine::decide_claim;

/// The verdict, with its condition if there is one.
fn answer(states: &str, setting: &str) -> String {
    let paper = question(states, setting).unwrap_or_else(|error| panic!("{states}: {error}"));
    let found = decide_claim("questions", &paper.claims[0]);
    let found = found.unwrap_or_else(|error| panic!("{states}: {error}"));
    if let Some(contradiction) = found.contradiction() {
        return format!("contradiction: {contradiction}");
    }
    let conditions: Vec<&str> = found.conditions().iter().map(|c| c.text.as_str()).collect();
    let verdict = format!("{:?}", found.verdict()).to_lowercase();
    match conditions.as_slice() {
        [] => verdict,
        all => format!("{verdict}: {}", all.join(" and ")),
    }
}

/// Each statement in its setting has this answer.
#[track_caller]
fn answers(all: &[(&str, &str, &str)]) {
    let wrong = all.iter().filter_map(|(states, setting, right)| {
        let found = answer(states, setting);
        (found != *right).then(|| format!("{states} | {setting}\n    {found}, not {right}"))
    });
    let wrong: Vec<String> = wrong.collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_root_is_positive_for_a_reason_that_does_not_rest_on_that() {
    answers(&[
        ("1/(x^2 + sqrt(x)) > 0", "x^2 > 2", "holds"),
        ("1/(abs(x) + sqrt(x)) > 0", "x^2 > 2", "holds"),
        ("1/x >= 1 implies sqrt(x - 2) >= 0", "", "holds"),
        ("z > 0", "x^2 > 2; (sqrt(x) + y^2)*z == 1", "holds"),
    ]);
}

#[test]
fn a_half_is_no_integer() {
    answers(&[
        ("y == 0", "m in 0..1; y*(m - 1/2) == 0", "holds"),
        ("abs(y) >= 0", "m in 0..1; y*(m - 1/2) == 0", "holds"),
        (
            "y == 0",
            "m in 0..; n in 0..; y*(m/3 + n/6 - 1/4) == 0",
            "holds",
        ),
    ]);
}

#[test]
fn a_hypothesis_without_a_value_is_not_satisfied_whatever_it_says() {
    answers(&[
        ("x^2 > 0", "0 == 0*(1/x)", "holds"),
        ("x^2 > 0", "D(1/x, y) == 0", "holds"),
        ("x^2 > 0", "y*(1/x) == 0", "holds"),
        ("x^2 > 0 and n >= 0", "n in 0..3; n == 0/x", "holds"),
        ("x^2 > 0", "[1/x, 2][2] == 2", "holds"),
        ("x != 0", "f(1/x) == 1; f(t) := 1", "holds"),
        ("at(1, y, 1/x) == 1 implies x^2 > 0", "", "holds"),
        ("y*(1/x) == 0 implies x^2 > 0", "", "holds"),
        ("[1/x, x][2] != 0", "", "conditional: x != 0"),
        ("f(1/x, x^2) > 0", "f(s, t) := t", "conditional: x != 0"),
    ]);
}

#[test]
fn a_sum_that_may_be_empty_asks_for_no_values() {
    // At n = 0 each hypothesis says 0 == 0, also at x = 0.
    for setting in [
        "sum(i, 1, n, 0/x) == 0; n in 0..",
        "sum(i, 1, n, 1/x) >= 0; n in 0..",
        "sum(i, 0, n - 1, i/x) == 0; n in 0..",
    ] {
        let found = answer("x != 0", setting);
        assert!(
            ["false", "undecided"].contains(&found.as_str()),
            "{setting}: {found}"
        );
    }
    answers(&[("x != 0", "sum(i, 1, n, 1/x) >= 0; n in 1..", "holds")]);
}

#[test]
fn factors_of_divisors_that_cancel_in_a_hypothesis_do_not_matter() {
    answers(&[
        (
            "D(abs(z*z), z) > 0 or D(abs(z*z), z) <= 0",
            "",
            "conditional: z != 0",
        ),
        (
            "abs(z)/(2*abs(z)) > z or abs(z)/(2*abs(z)) <= z",
            "z in 0..3; z*0 == 0",
            "conditional: z != 0",
        ),
        (
            "z/z > y or z/z <= y",
            "n in -2..1; n*(z - 1) == 0",
            "conditional: z != 0",
        ),
    ]);
}

#[test]
fn what_is_denied_twice_is_said() {
    answers(&[
        ("not (not (x > 0 implies x > 0))", "", "holds"),
        ("y == y", "not (not (x > 0 implies x > 0))", "holds"),
        ("not (x > 0 and not (y > 0 implies y >= 0))", "", "holds"),
        ("not (not (not (x > 0 implies x >= 0)))", "", "false"),
        ("not (not (not (x > 0 and x < 0)))", "", "holds"),
    ]);
}

#[test]
fn near_a_zero_of_a_divisor_a_hypothesis_has_no_value_that_is_known() {
    answers(&[
        ("x^2 != 2", "abs(y/(x^2 - 2)) >= 0", "holds"),
        ("x^2 != 2", "1/(x^2 - 2) > 0 or y > 0", "holds"),
        ("x^2 != 2", "y/(x^2 - 2) > 0 implies z > 0", "holds"),
        ("x^3 != 2", "1/(x^3 - 2) > 0 or z > 0", "holds"),
    ]);
}

#[test]
fn an_integer_that_bounds_another_has_the_value_of_the_instance() {
    for states in ["x^n > m", "(1 + x)^n > m"] {
        let found = answer(states, "n in 0..3; m in 0..n");
        assert!(found == "false" || found == "misprint", "{states}: {found}");
    }
}

#[test]
fn conditions_are_no_more_than_what_the_statement_divides_by() {
    answers(&[
        ("1/(x + y)^2 > 0", "x*y == 0", "conditional: x + y != 0"),
        ("1/(x - n)^2 > 0", "n in 1..4", "conditional: n - x != 0"),
        (
            "1/(x - z) == 1/(x - z)",
            "x != -2 or x != 3",
            "conditional: x - z != 0",
        ),
        (
            "1/(x - z) == 1/(x - z)",
            "x == 1 or x > 2",
            "conditional: x - z != 0",
        ),
        (
            "(x > 1 implies y == 2) implies (y - z)/(y - z) == 1",
            "",
            "conditional: y - z != 0",
        ),
        ("norm(u/norm(u)) == 1", "u: vector 3; norm(u) > 0", "holds"),
        (
            "1/(2*x^2 + 2*x*z + z^2) == 1/((x + z)^2 + x^2)",
            "x*(z - x) != 0",
            "holds",
        ),
        (
            "norm([z, z])/(z^2 + (x + 1)^2) >= 0",
            "sqrt(x + 1) != 0",
            "holds",
        ),
        ("(y/(y - 1))^2 >= 0", "1/sqrt(y^2 - 1) != 0", "holds"),
        ("1/y > 0 or 1/y <= 0", "abs(abs(1/y)) >= 0", "holds"),
    ]);
}

#[test]
fn what_a_hypothesis_keeps_from_zero_is_not_zero_for_the_checker_either() {
    answers(&[
        // The bound of a radicand is a hypothesis, and no declared range.
        ("sqrt(x) < x", "x > 1", "holds"),
        ("sqrt(x) <= x", "x >= 1", "holds"),
        ("sqrt(x) < x", "x >= 1", "false"),
        ("x > 1 implies sqrt(x) < x", "", "holds"),
        ("sqrt(x) < x", "x in [0, 5]; x >= 2", "holds"),
        ("sqrt(2*x - 1/2) != x", "x >= 7/3", "holds"),
        ("sqrt(2*x - 1) != x", "x >= 1/2", "false"),
        ("not (sqrt(x) == x)", "x >= 2", "holds"),
        ("x*sqrt(x) >= x", "x >= 1", "holds"),
        ("sqrt(x) <= x - 1", "x >= 3", "holds"),
        ("fails(sqrt(x) < x)", "x >= 2", "false"),
        // A symbol with an open range is eliminated by an equation.
        ("x^2 > 0", "x in (0, inf); x == y^2", "holds"),
        ("x^2 > 0", "x in [0, inf); x == y^2", "false"),
        ("x*y != 0", "x in (0, inf); x == y^2", "holds"),
        ("x*y^2 >= 0", "x in (0, inf); x == y^2", "holds"),
        ("x^2 > 0", "x in (0, inf); x == sin(y)", "holds"),
        ("x*y^2 >= 0", "x in (1, inf); x == y^2", "holds"),
        ("t^2 > 0", "t in (0, 1); t == y*z", "holds"),
        ("t^2 > 0", "t in (0, 1); t == 1 - y^2", "holds"),
        ("x*y^2 <= 0", "x in (-inf, 0); x == -y^2", "holds"),
        (
            "r*(x^2 + y^2) >= 0",
            "r in (0, inf); r == x^2 + y^2",
            "holds",
        ),
        // A hypothesis that is no equation keeps a symbol of another from zero.
        ("y != 0", "y >= 1; x*y == 0", "holds"),
        ("y != 0", "y >= 0; x*y == 0", "false"),
        ("sqrt(y) != 0", "y >= 1; x*y == 0", "holds"),
        ("abs(x) != y", "y >= 1; x*y == 0", "holds"),
        ("sqrt(x^2 + y^2) != abs(x)", "y >= 1; x*y == 0", "holds"),
    ]);
}

#[test]
fn a_root_that_an_equation_names_is_nonzero_where_its_radicand_is() {
    answers(&[
        ("y != 0", "sqrt(x^2 + 1) == y", "holds"),
        ("sqrt(x^2 + 1) != 0", "sqrt(x^2 + 1) == y", "holds"),
        ("norm([x, 1]) != 0", "norm([x, 1]) == y", "holds"),
        ("y != 0", "r in (0, inf); sqrt(r) == y", "holds"),
        ("y != 0", "r in (0, inf); y - sqrt(r)/(1 + r) == 0", "holds"),
        (
            "sqrt(y^2) >= 0",
            "r in (0, inf); y - sqrt(r)/(1 + r) == 0",
            "holds",
        ),
        ("z != 0", "sqrt(x - y) == z; x > y", "holds"),
        ("sqrt(x^2 + 1) == y implies sqrt(x^2 + 1) != 0", "", "holds"),
        // Where the radicand may vanish.
        ("y != 0", "sqrt(x^2) == y", "false"),
        ("z != 0", "sqrt(x - y) == z; x >= y", "false"),
    ]);
}

#[test]
fn a_product_of_sine_and_cosine_is_at_most_a_half() {
    answers(&[
        ("sin(t)*cos(t) < 1", "sin(t) + 2*cos(t) == 1", "holds"),
        ("sin(t)*cos(t) != 1", "sin(t) + 2*cos(t) == 1", "holds"),
        ("sin(2*t) < 2", "sin(t) + 2*cos(t) == 1", "holds"),
        ("sin(t)*cos(t) < 1", "sin(t) + cos(t) == 1", "holds"),
        (
            "x*y != -1",
            "x == cos(t); y == sin(t); 3*x - 2*y == 2",
            "holds",
        ),
        (
            "3*x - 2*y == 2 implies x*y != -1",
            "x == cos(t); y == sin(t)",
            "holds",
        ),
        ("sin(t)*cos(t) < 0", "sin(t) + cos(t) == 1", "false"),
    ]);
}

#[test]
fn a_point_that_satisfies_the_hypotheses_nearly_contradicts_no_strict_order() {
    // Where s is large, tanh(s) is 1 to all digits that are computed.
    for value in [
        "tanh(s)",
        "tanh(2*s)",
        "sinh(s)/cosh(s)",
        "(exp(s) - 1)/(exp(s) + 1)",
    ] {
        let named = format!("x == {value}");
        answers(&[
            ("x < 1", &named, "holds"),
            ("x != 1", &named, "holds"),
            ("x > -1", &named, "holds"),
            ("1 - x > 0", &named, "holds"),
            ("x^2 < 1", &named, "holds"),
            ("x < 1/2", &named, "false"),
        ]);
    }
}

#[test]
fn a_polynomial_of_one_variable_may_have_roots_of_different_multiplicity() {
    answers(&[
        ("x^4 - 4*x + 3 >= 0", "", "holds"),
        ("x^4 - x^3 - x + 1 >= 0", "", "holds"),
        ("3*x^4 - 4*x^3 + 1 >= 0", "", "holds"),
        ("x^8 - 8*x + 7 >= 0", "", "holds"),
        ("(x - 1)^3*(x + 1)^2 >= 0", "x >= 1", "holds"),
        ("(x - 1)^3*(x + 1)^2 >= 0", "x >= 0", "false"),
        ("(x^2 - 3)^2*(x^2 + 1) > 0", "", "false"),
        ("(3*x^2 - 2)^2 > 0", "", "false"),
        ("(x^2 - x - 1)^2*(x^2 + 1) > 0", "", "false"),
        ("(x^2 - 2)^2 + (x^3 - 2*x)^2 > 0", "", "false"),
        ("x^4 - 4*x + 3 > 0", "", "false"),
    ]);
}

#[test]
fn a_false_statement_between_ordered_numbers_gets_its_point() {
    let knots = "a < b; b < c; c < d; d < e; e < f; f < g; g < h";
    for states in [
        "g > 0",
        "a*g > 0",
        "g - a > 1/10",
        "h < a + 100",
        "e < c + d",
        "d + e <= c + f",
        "b + f == 2*d",
        "e^2 <= d*f",
        "g < 2*f - e",
        "f < 3*c",
    ] {
        answers(&[(states, knots, "false")]);
    }
    answers(&[
        ("y - x < 1000", "x < y", "false"),
        ("z - x > 1/100", "x < y; y < z", "false"),
        ("(a - b)*(c - d) > 0", "a < b; b < c; c < d", "holds"),
    ]);
}
