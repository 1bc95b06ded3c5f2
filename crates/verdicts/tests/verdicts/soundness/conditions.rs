//! Conditions and witnesses: true ones, needed ones, and none that is lost.

use super::{conditions, expect, expect_one_of, expect_refuted_where, outcome, tried};
use torse_syntax::taxonomy::Verdict::{Conditional, False, Holds, Undecided, Vacuous};

#[test]
fn an_inequation_of_vectors_keeps_its_condition() {
    let found = expect("different", "states = '[1/y, 1] != [0, 2]'", Conditional);
    assert_eq!(conditions(&found), ["y != 0"]);
}

#[test]
fn a_denial_needs_one_point_at_which_its_statement_is_defined_and_false() {
    expect("denied", "states = 'fails([1/y, 1] == [0, 2])'", Holds);
}

#[test]
fn a_conjunction_keeps_the_conditions_of_both_parts() {
    let lines = "states = 'a/a == 1 and [1/y, 1] != [0, 2]'";
    let found = expect("both", lines, Conditional);
    let mut found = conditions(&found);
    found.sort_unstable();
    assert_eq!(found, ["a != 0", "y != 0"]);
}

#[test]
fn a_function_that_is_defined_nowhere_has_no_condition_in_a_name_of_the_engine() {
    let lines = "let = { \"F(x)\" = '0/cos(pi/2*x)' }\nstates = \"F'(1) == 0\"";
    let found = expect_one_of("nowhere", lines, &[Vacuous, Undecided]);
    let text = format!("{found:?}");
    assert!(!text.contains('°') && !text.contains('#'), "{text}");
}

#[test]
fn no_part_of_a_refuted_conjunction_is_undefined_at_its_witness() {
    let lines = "states = 'y/y == 1 and y == 1'";
    expect_refuted_where("undefined-part", lines, "y", |y| y != "0");
}

#[test]
fn a_witness_gives_one_point_one_value() {
    let head = "let = { \"C(x)\" = 'sum(i, 0, m, B[i,m](x)*P[i])' }\n";
    let lines = format!("{head}states = \"C'(0) == P[m] - P[m-1]\"");
    expect_refuted_where("impossible", &lines, "m", |m| m != "1");
}

#[test]
fn the_condition_of_a_linear_system_is_its_determinant() {
    let head = "given = ['a*r + b*s == e', 'c*r + d*s == f']\nsolve_for = ['r', 's']\n";
    let lines = format!("{head}states = 's == (a*f - c*e)/(a*d - b*c)'");
    let found = expect("system", &lines, Conditional);
    let texts = conditions(&found);
    assert!(
        matches!(texts.as_slice(), [one] if one.contains("a*d") && one.contains("b*c")),
        "{texts:?}"
    );
}

#[test]
fn what_follows_without_division_has_no_condition() {
    let head = "given = ['a*r + b*s == e', 'c*r + d*s == f']\nsolve_for = ['r', 's']\n";
    let lines = |states: &str| format!("{head}states = '{states}'");
    expect("rule", &lines("s*(a*d - b*c) == a*f - c*e"), Holds);
    expect("sum", &lines("y*(a*r + b*s) + c*r == y*e + f - d*s"), Holds);
    let both = "[s*(a*d - b*c), r*(a*d - b*c)] == [a*f - c*e, d*e - b*f]";
    expect("both", &lines(both), Holds);
    // At a d = b c the equations say nothing of s alone, nor of a multiple by something else.
    expect("alone", &lines("s*a*(a*d - b*c) == a*(a*f - c*e)"), Holds);
    let lines = lines("s/a*(a*d - b*c) == f - c*e/a");
    let found = expect("divided", &lines, Conditional);
    assert_eq!(conditions(&found), ["a != 0"]);
}

#[test]
fn what_does_not_follow_without_division_keeps_its_condition() {
    let one = "given = ['a*r == a*b']\nsolve_for = ['r']\n";
    expect(
        "cancelled",
        &format!("{one}states = 'r*c == b*c'"),
        Conditional,
    );
    expect(
        "multiple",
        &format!("{one}states = 'r*a*c == b*a*c'"),
        Holds,
    );
    // A coefficient is that of the solution, which needs the divisor.
    let read = format!("{one}states = 'coefficients([a*r], [b]) == [[a]]'");
    expect("coefficient", &read, Conditional);
}

#[test]
fn a_divisor_that_vanishes_at_no_integer_is_no_condition() {
    expect("integer", "states = '(2*m - 3)/(2*m - 3) == 1'", Holds);
}

#[test]
fn a_divisor_that_vanishes_nowhere_is_no_condition() {
    expect("squares", "states = '(y^2 + 1)/(y^2 + 1) == 1'", Holds);
    let lines =
        "symbols = { phi = { in = \"(0, pi)\" } }\nstates = '(1 - cos(phi))/(1 - cos(phi)) == 1'";
    expect("open-angle", lines, Holds);
}

#[test]
fn a_left_out_argument_under_a_parameter_of_the_same_name_is_an_error() {
    let lines = "let = { \"C(x)\" = 'sum(i, 0, m, B[i,m]*P[i])' }\nstates = 'C(0) == C(1)'";
    let found = tried("left-out", lines);
    assert!(found.is_err(), "{found:#?}");
}

#[test]
fn a_denial_says_not_everywhere() {
    expect("not-everywhere", "states = 'fails(x == 1/2)'", Holds);
    expect("everywhere", "states = 'fails(x - x == 0)'", False);
}

#[test]
fn a_denial_of_a_comparison_is_about_the_point() {
    expect(
        "at-points",
        "assume = ['not (a == 0)']\nstates = 'a != 0'",
        Holds,
    );
    expect("premise", "states = 'not (a == 0) implies a != 0'", Holds);
    expect(
        "both",
        "states = 'not (a > 0 and b > 0) implies a <= 0 or b <= 0'",
        Holds,
    );
    expect("wrong", "states = 'not (a == 0)'", False);
    expect("implied", "states = 'not (x >= 0 implies x > 2)'", Holds);
}

#[test]
fn what_fails_somewhere_stands_alone_or_beside_others() {
    expect(
        "beside",
        "states = 'x >= 0 and fails(x == 0) and fails(x == 1)'",
        Holds,
    );
    for lines in [
        "states = 'not fails(x == 0)'",
        "states = 'fails(x == 0) or x == 0'",
        "states = 'x == 0 implies fails(x == 1)'",
        "states = 'fails(fails(x == 0))'",
        "states = 'at(fails(x == 0), x, 1)'",
        "assume = ['fails(x == 0)']\nstates = 'x == 0'",
        "states = 'not nonnegative(B)'",
    ] {
        assert!(tried("misplaced", lines).is_err(), "{lines}");
    }
}

#[test]
fn an_instance_that_is_not_defined_is_no_error() {
    let lines = "symbols = { s = { integer = \">= 0\" } }\nstates = 'D(B[0,s](x), x) == -s*B[0,s-1](x) and s >= 1'";
    expect_one_of("instance", lines, &[Holds, Conditional, Undecided]);
}

#[test]
fn an_empty_interval_is_vacuous() {
    let lines = "symbols = { x = { in = \"[1, 0]\" } }\nstates = 'x == 7'";
    expect("interval", lines, Vacuous);
    let lines = "symbols = { x = { in = \"(1, 1)\" } }\nstates = 'x == 7'";
    expect("open-point", lines, Vacuous);
    let lines = "symbols = { k = { integer = \"3..2\" } }\nstates = 'k == 7'";
    expect("integers", lines, Vacuous);
}

#[test]
fn a_contradiction_is_vacuous() {
    expect(
        "contradiction",
        "assume = ['1 == 2']\nstates = 'y == 7'",
        Vacuous,
    );
    expect("order", "assume = ['1 > 2']\nstates = 'y == 7'", Vacuous);
    let lines = "assume = ['a == 1', 'a == 2']\nstates = 'y == 7'";
    expect("two-values", lines, Vacuous);
}

#[test]
fn a_condition_that_an_assumption_excludes_is_none() {
    let found = outcome(
        "assumed",
        "assume = ['y > 2']\nstates = '(y - 1)/(y - 1) == 1'",
    );
    assert_eq!(
        (found.verdict(), found.conditions().len()),
        (Holds, 0),
        "{found:#?}"
    );
}

#[test]
fn what_the_hypotheses_keep_from_zero_is_no_condition() {
    // A sum of squares one of which differs from zero, and a number whose square is above one.
    for (assumed, states) in [
        ("a != 0", "1/(a^2 + y^2) > 0"),
        ("a != 0", "a^2/sqrt(a^2 + y^2) >= 0"),
        ("y^2 > 1", "abs(a/y) == abs(a)/abs(y)"),
    ] {
        let lines = format!("assume = ['{assumed}']\nstates = '{states}'");
        let found = expect("settled", &lines, Holds);
        assert_eq!(conditions(&found), [""; 0], "{states}");
        assert!(found.replay().unwrap().is_whole(), "{states}");
    }
    let found = expect("open", "states = '1/a^2 > 0'", Conditional);
    assert_eq!(conditions(&found), ["a != 0"]);
}

#[test]
fn a_root_is_positive_before_what_it_occurs_in() {
    let lines = "assume = ['y > 0']\nstates = '1/(a + sqrt(a^2 + y)) == (sqrt(a^2 + y) - a)/y'";
    let found = expect("conjugate", lines, Holds);
    assert!(found.replay().unwrap().is_whole());
}

#[test]
fn every_alternative_has_to_be_defined() {
    for (states, wanted) in [
        ("1/b > 0 or 1/b <= 0", "b != 0"),
        ("1/y == 1/y or a > 2", "y != 0"),
        ("(b/y == b/y or y > 0) and b == b", "y != 0"),
        ("a > 2 or a <= 2 or 1/(b - abs(y)) > 1", "abs(y) - b != 0"),
        ("b <= 0 or 1/b > 0", "b != 0"),
    ] {
        let found = expect("alternatives", &format!("states = '{states}'"), Conditional);
        assert_eq!(conditions(&found), [wanted], "{states}");
    }
    // Where a premise is false or undefined nothing is asserted.
    for states in ["b != 0 implies b/b == 1", "1/b > 0 implies b > 0"] {
        expect("premise", &format!("states = '{states}'"), Holds);
    }
}

#[test]
fn a_divisor_that_is_zero_for_some_integer_of_a_short_range_is_a_condition() {
    for (states, wanted) in [
        ("1/k^2 > 0", &["k != 0"][..]),
        ("1/(k*(k - 1)) >= 0", &["k != 0", "k - 1 != 0"]),
        ("D(1/k^2*b, b) > 0", &["k != 0"]),
    ] {
        let lines = format!("symbols = {{ k = {{ integer = \"0..3\" }} }}\nstates = '{states}'");
        let found = expect("short", &lines, Conditional);
        assert_eq!(conditions(&found), wanted, "{states}");
    }
}

#[test]
fn what_divides_a_power_of_a_hypothesis_is_not_zero() {
    for (assumed, states) in [
        ("a*y != 0", "abs(y)/(a^2 + y^2) >= 0"),
        ("a*y != 0", "1/(abs(y) + abs(a)) > 0"),
        ("a != 0", "1/(abs(a)^2 + y^2) > 0"),
        ("(a + y)/a < 1", "1/(abs(a)^2 + (a + y)^2) > 0"),
    ] {
        let lines = format!("assume = ['{assumed}']\nstates = '{states}'");
        let found = expect("power", &lines, Holds);
        assert!(found.replay().unwrap().is_whole(), "{states}");
    }
}

#[test]
fn squares_are_not_all_zero_where_a_hypothesis_fails() {
    for assumed in ["a + y != 0", "a + y >= 1", "a - 2*y^3 > 0"] {
        let lines = format!("assume = ['{assumed}']\nstates = '1/(a^2 + y^4) > 0'");
        let found = expect("squares", &lines, Holds);
        assert!(found.replay().unwrap().is_whole(), "{assumed}");
    }
    for lines in ["", "assume = ['a + y != 1']\n"] {
        let lines = format!("{lines}states = '1/(a^2 + y^4) > 0'");
        let found = expect("squares", &lines, Conditional);
        assert_eq!(conditions(&found), ["a^2 + y^4 != 0"]);
    }
}

#[test]
fn a_difference_of_roots_is_zero_only_where_its_norm_is() {
    for (assumed, states) in [
        (
            "a != y",
            "1/(sqrt(a) - sqrt(y)) == (sqrt(a) + sqrt(y))/(a - y)",
        ),
        ("a^2 != y^2", "1/(a - abs(y)) == (a + abs(y))/(a^2 - y^2)"),
        ("a^2 - 1 != 0", "1/(sqrt(a + 1)^2 - 2) == 1/(a - 1)"),
    ] {
        let lines = format!("assume = ['{assumed}']\nstates = '{states}'");
        let found = expect("norm", &lines, Holds);
        assert!(found.replay().unwrap().is_whole(), "{states}");
    }
}

#[test]
fn an_angle_in_a_square_is_bounded() {
    let symbols = "symbols = { k = { in = \"(-1, 1)\" } }\n";
    for states in [
        "1 - sin(a - b)^2 >= 0",
        "(1 - k^2*sin(a - b)^2)/(1 - k^2*sin(a - b)^2) == 1",
        "(sin(a)*c - cos(a))^2 >= 0",
    ] {
        let found = expect("angle", &format!("{symbols}states = '{states}'"), Holds);
        assert!(found.replay().unwrap().is_whole(), "{states}");
    }
}

#[test]
fn what_an_evaluation_does_not_need_has_to_be_defined_too() {
    for (states, wanted) in [
        ("abs(y/(a^2 - 2)) >= 0 or y > 1", "a^2 - 2 != 0"),
        ("abs(abs(y/(a^2 - 2))) >= 0", "a^2 - 2 != 0"),
        (
            "abs(integral(x/(a - 3), x, 0, 1)) >= 0 or y > 0",
            "a - 3 != 0",
        ),
        ("[1/a, 2][2] == 2", "a != 0"),
        ("at(1, y, 1/a) == 1", "a != 0"),
        ("transpose([[1/a, 2], [3, 4]])[1,2] == 3", "a != 0"),
        ("[a, b][y/y] == a", "y != 0"),
        ("sum(i, y/y, 2, a) == 2*a", "y != 0"),
        ("sum(i, 1, m, 0/a) == 0", "a != 0"),
        ("D(a^3, a, y/y) == 3*a^2", "y != 0"),
        ("agrees(a/a, 1.0)", "a != 0"),
        ("sum(i, 0, m, B[i,m](1/y)) == 1", "y != 0"),
        ("abs(sqrt(tan(a))) >= 0", "cos(a) != 0"),
    ] {
        let found = expect("unneeded", &format!("states = '{states}'"), Conditional);
        assert_eq!(conditions(&found), [wanted], "{states}");
    }
}

#[test]
fn a_root_that_is_not_zero_has_a_radicand_that_is_not() {
    for (assumed, states) in [
        ("sqrt(y) != 0", "y > 0"),
        ("sqrt(y)*a != 0", "y > 0"),
        ("1/sqrt(y) > 0", "y > 0"),
        ("sqrt(y - 1) != 0", "(1/(y - 1))^2 > 0"),
        ("a == a", "1/(sqrt(y^2 + 1)^2 + a^2) > 0"),
    ] {
        let lines = format!("assume = ['{assumed}']\nstates = '{states}'");
        let found = expect("root", &lines, Holds);
        assert!(found.replay().unwrap().is_whole(), "{assumed}");
    }
    let found = expect(
        "halves",
        "states = '1/sqrt(a) > a or 1/sqrt(a) <= a'",
        Conditional,
    );
    assert_eq!(conditions(&found), ["a != 0"]);
}

#[test]
fn a_condition_is_needed_if_a_point_without_it_fails_though_others_satisfy_the_statement() {
    let check = |name: &str, lines: &str| {
        let found = expect(name, lines, Conditional);
        let net = found.net().unwrap();
        assert!(!net.conditions.is_empty(), "{found:#?}");
        assert!(net.conditions.iter().all(|own| own.seen_needed()));
        net.conditions.iter().map(|own| own.holding).sum::<u64>()
    };
    assert_eq!(check("divisor", "states = 'a/y == a*(1/y)'"), 0);
    // Where y is zero and b is not, a is zero all the same.
    let either = "assume = ['a*y == 0', 'a*b == 0']\nstates = 'a == 0'";
    assert!(check("either", either) > 0);
    let vector = "assume = ['a*[y, b] == [0, 0]']\nstates = 'a == 0'";
    assert!(check("vector", vector) > 0);
}
