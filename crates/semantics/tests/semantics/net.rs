//! The net: statements that are true stand, statements that are false are caught.

use crate::support::{claim, is_caught, is_empty, is_never_denied, netted, stands};
use torse_semantics::{Judgement, Outside, ViolationStatistics, Witness};

#[test]
fn multiples_of_assumptions_below_one() {
    is_caught("assume = ['2*a < 1']", "a > 0");
    is_caught("assume = ['2*a^2 > -1']", "a^2 < 0");
}

#[test]
fn a_sum_whose_index_stands_in_an_argument() {
    is_caught("", "sum(j, 0, m, B[j,m](j*x)) == 1");
    stands("", "sum(j, 0, m, B[j,m](x)) == 1");
}

#[test]
fn derivatives_at_bound_names() {
    let curve = r#"let = { "C(x)" = 'sum(j, 0, m, B[j,m](x)*P[j])', "V(x)" = 'D(C(x), x)' }"#;
    is_caught(curve, "V(0) == 0");
    stands(curve, "V(0) == m*(P[1] - P[0])");
    stands(curve, "C(0) == P[0] and C(1) == P[m]");
    is_caught(curve, "C'(0) == P[m] - P[m-1]");
    let square = r#"let = { "G(x)" = 'at(x^2, x, 3)' }"#;
    is_caught(square, "G(5)*y == 25*y");
    stands(square, "G(5)*y == 9*y");
    stands("assume = ['x == 1']", "D(x^2, x) == 2");
    is_caught("assume = ['x == 1']", "D(x^2, x) == 0");
    is_caught("assume = ['y == 1/x', 'x > 0']", "D(x*y, x) == 0");
    stands("assume = ['y == 1/x', 'x > 0']", "D(x*y, x) == y");
    let shape = r#"let = { "F(x)" = 'x*mu' }"#;
    is_caught(shape, "D(F, mu)(mu) == 2*mu");
    stands(shape, "D(F, mu)(mu) == mu");
}

#[test]
fn a_conjunction_with_a_denial() {
    is_caught("", "sum(j, 1, m, j) <= 3 and fails(x == 0)");
    stands("", "sum(j, 1, m, j) >= 1 and fails(x == 0)");
}

#[test]
fn at_replaces_degrees_and_indices() {
    is_caught("", "at(m*P[m], m, 2) == 2*P[m]");
    stands("assume = ['m >= 2']", "at(m*P[m], m, 2) == 2*P[2]");
}

#[test]
fn a_half_angle_is_no_name_of_the_user() {
    is_caught(
        "symbols = { h = { in = \"[-5, -4]\" } }",
        "sin(pi/2*x) + h >= 0",
    );
}

#[test]
fn functions_that_do_not_sum_to_one_do_not_diminish_variation() {
    is_caught("", "variation_diminishing(H)");
    stands("", "variation_diminishing(B)");
}

#[test]
fn degrees_below_the_seeds_and_indices_outside() {
    is_caught("", "sum(j, 0, n-3, B[j,n-3](x)) == 1");
    let tally = netted(&claim("", "sum(j, 0, m, B[j,m](x)*P[j+1]) == 0"));
    assert_eq!(
        (tally.holding, tally.failing.is_some()),
        (0, false),
        "{tally:?}"
    );
    assert!(tally.undefined > 0);
}

#[test]
fn integers_stay_integers() {
    stands("", "sin(pi*m) == 0");
    stands("", "i <= m");
    stands(
        "symbols = { m = { integer = \"1..2\" } }",
        "sum(j, 1, i, j) <= 3",
    );
    stands("assume = ['m >= 1']", "(1-o)*P[0] + o*P[1] == P[o]");
}

#[test]
fn replaced_symbols_keep_their_ranges() {
    stands("assume = ['x == y^2']", "y <= 1");
    stands("assume = ['w == 1 - u - v']", "u + v <= 1");
    stands(
        "symbols = { x = {} }\nassume = ['x > 0', 'x == -y']",
        "y < 0",
    );
    stands("assume = ['y == y^2']", "y^2 - y == 0");
    stands("assume = ['a*b == 1']", "b != 0");
    stands("assume = ['a*b == 0', '1 + a < 1/2']", "b >= 0");
    is_caught("assume = ['m >= 2']", "sum(j, 1, m, j) <= 3");
}

/// The statement where the condition fails.
fn where_fails(fields: &str, states: &str, condition: &str) -> ViolationStatistics {
    claim(fields, states).judge_violations(&claim(fields, condition))
}

#[test]
fn a_condition_is_needed_where_the_statement_is_undefined_or_false_without_it() {
    stands("", "y/y == 1");
    let divisor = where_fails("", "y/y == 1", "y != 0");
    assert_eq!(
        (divisor.undefined, divisor.judged()),
        (10, 10),
        "{divisor:?}"
    );
    assert_eq!(
        divisor.needed_at.map(|p| p.to_string()).as_deref(),
        Some("y = 0")
    );

    let factor = where_fails("", "(a - b)*y*y > 0 or a <= b", "y != 0");
    assert!(factor.failing > 0 && factor.holding > 0, "{factor:?}");
    let point = factor.needed_at.expect("a point").to_string();
    assert!(point.contains("y = 0"), "{point}");
}

#[test]
fn a_condition_that_is_not_needed_leaves_the_statement_true_where_it_fails() {
    let beyond = where_fails("", "y*a == a*y", "y != 0");
    assert_eq!((beyond.holding, beyond.needed_at), (10, None));
}

#[test]
fn a_point_at_which_a_condition_nearly_fails_satisfies_it() {
    // Where y is the root of two the quotient is undefined; no rational number is.
    let beyond = where_fails("", "(y^2 - 2)/(y^2 - 2) == 1", "y^2 - 2 != 0");
    assert_eq!((beyond.judged(), beyond.needed_at), (0, None));
}

#[test]
fn a_condition_with_pi_fails_at_simple_numbers() {
    let beyond = where_fails("", "(y - 1)/(y - 1) == 1", "pi^2*(y - 1) != 0");
    assert_eq!(beyond.undefined, 10, "{beyond:?}");
    assert_eq!(
        beyond.needed_at.map(|p| p.to_string()).as_deref(),
        Some("y = 1")
    );
}

#[test]
fn coefficients_are_read_along_the_solutions_of_given_equations() {
    let solved = "given = ['2*r + b == a*s']\nsolve_for = ['r']";
    stands(solved, "coefficients([r, r + s], [s])[1,1] == a/2");
    stands(
        solved,
        "coefficients([r, r + s], [s, b]) == [[a/2, -1/2], [a/2 + 1, -1/2]]",
    );
    is_caught(solved, "coefficients([r], [s])[1,1] == 0");
    // Two unknowns, a conjunction, and an equation that speaks of coefficients itself.
    let two =
        "let = { both = 'r + s == a and r - s == b' }\ngiven = ['both']\nsolve_for = ['r', 's']";
    stands(two, "coefficients([r*c], [a, b]) == [[c/2, c/2]]");
    let inner = "given = ['coefficients([3*r], [r])[1,1]*s == a']\nsolve_for = ['s']";
    stands(inner, "s == a/3 and coefficients([s], [a])[1,1] == 1/3");
}

#[test]
fn a_statement_without_symbols_has_one_point() {
    let tally = netted(&claim("", "1 + 1 == 2"));
    assert_eq!((tally.attempts, tally.holding, tally.single), (1, 1, true));
    let tally = netted(&claim("", "1 + 1 == 3"));
    assert!(tally.failing.is_some());
    let tally = netted(&claim("", "y == y"));
    assert_eq!((tally.holding, tally.single), (20, false));
}

#[test]
fn some_points_lie_at_the_edges() {
    // Few numbers drawn between ends, or from all, are ends or zero.
    is_caught("", "a*a > 0");
    is_caught("", "y != 0 or a != 0");
}

#[test]
fn a_condition_excepts_points() {
    let c = claim("", "y > 0");
    let conditions = [c.statement()];
    let tally = torse_semantics::judge_samples(&c.reading(), &conditions, "t/c", 20, 4_000_000);
    assert!(tally.excepted > 0 && tally.holding == 20, "{tally:?}");
}

#[test]
fn empty_domains_have_no_points() {
    is_empty("assume = ['1 == 2']", "y == y");
}

#[test]
fn properties_of_bases() {
    stands("", "nonnegative(B)");
    is_caught("", "nonnegative(T)");
    stands("", "independent(B)");
}

#[test]
fn witnesses_are_checked_in_every_set_and_hypothesis() {
    let c = claim("assume = ['x == y^2']", "y <= 1");
    let check = |point: &[(&str, &str)]| c.check(point);
    assert_eq!(
        check(&[("x", "4"), ("y", "2")]),
        Witness::Outside(Outside::Set {
            name: "x".to_owned()
        })
    );
    assert!(matches!(
        check(&[("x", "1"), ("y", "2")]),
        Witness::Outside(Outside::Hypothesis { number: 0, .. })
    ));
    assert_eq!(
        check(&[("x", "1/2"), ("y", "sqrt(1/2)")]),
        Witness::Stands(Judgement::True)
    );
    assert!(matches!(
        check(&[("x°", "1"), ("y", "2")]),
        Witness::Unreadable(_)
    ));
    let c = claim("", "sin(pi*m) == 0");
    assert!(matches!(
        c.check(&[("m", "3/2")]),
        Witness::Outside(Outside::Set { .. })
    ));
    let c = claim("", "y/y == 1 and y == 1");
    assert!(matches!(
        c.check(&[("y", "0")]),
        Witness::Stands(Judgement::Undefined(_))
    ));
    let c = claim("", "P[0] == P[m]");
    assert_eq!(
        c.check(&[("m", "2"), ("P[0]", "1"), ("P[2]", "1/3")]),
        Witness::Refutes
    );
    assert!(matches!(
        c.check(&[("m", "2"), ("P[0]", "1")]),
        Witness::Stands(Judgement::Unknown(_))
    ));
}

#[test]
fn equations_under_linear_systems_stand_and_their_slips_are_caught() {
    let plane = "given = ['a*r + b*s == e', 'c*r + d*s == f']\nsolve_for = ['r', 's']\nassume = ['a*d != b*c']";
    stands(plane, "r*(a*d - b*c) == d*e - b*f");
    is_caught(plane, "r*(a*d - b*c) == d*e + b*f");
    stands(
        plane,
        "r*(a*d - b*c) == d*e - b*f and sin(pi/2*x)^2 + cos(pi/2*x)^2 == 1",
    );
    is_caught(
        plane,
        "r*(a*d - b*c) == d*e - b*f and sin(pi*x) == 2*sin(pi/2*x)",
    );
    // What is solved for may have a range, or stand in an inequality: then its number is looked at.
    is_caught(
        "given = ['r == x + 1']\nsolve_for = ['r']",
        "r > 1 and r == x + 1",
    );
    stands(
        "given = ['r == x + 1']\nsolve_for = ['r']",
        "r >= 1 and r == x + 1",
    );
}

#[test]
fn a_product_of_two_unknowns_is_not_solved_by_one_step() {
    // At every solution s is 1/2; where one step of Newton's method ends, it is not.
    let product = "given = ['r*s == 1', 'r*s + r == 3']\nsolve_for = ['r', 's']";
    is_never_denied(product, "fails(2*s == 1)");
    stands(product, "2*s == 1");
}

#[test]
fn a_point_that_equations_determine_is_judged_once() {
    let two = "given = ['r + s == 3', 'r - s == 1']\nsolve_for = ['r', 's']";
    for states in ["r == 2*s", "r > s", "r == 2*s and sqrt(r*s - 1) == 1"] {
        let tally = netted(&claim(two, states));
        assert_eq!(
            (tally.holding, tally.single),
            (1, true),
            "{states}: {tally:?}"
        );
    }
    is_caught(two, "r == s");
    // Another number is free, in the statement or in the equations; or there are two points.
    stands(two, "r*x == 2*s*x");
    stands(
        "given = ['r + s == a', 'r - s == 1']\nsolve_for = ['r', 's']",
        "2*r == a + 1",
    );
    let circle = netted(&claim("assume = ['r^2 == 1']", "r == 1"));
    assert!(!circle.single, "{circle:?}");
}

#[test]
fn an_equation_is_visited_where_it_does_not_move_with_a_symbol() {
    let product = "assume = ['y*(a^2 - 2) == 0']";
    is_caught(product, "y == 0");
    stands(product, "y == 0 or a^2 == 2");
    is_caught("", "y*(a^2 - 2) == 0 and b*(c^2 + 1) == y implies b == 0");
    is_caught("", "y^2 - y*a == 2*y - 2*a implies y == a");
    is_caught("", "(a - b^3)^2 > 0");
    let visited = netted(&claim(product, "y == 0 or a^2 == 2"));
    assert!(
        visited.branches > 0 && visited.unvisited.is_empty(),
        "{visited:?}"
    );
}
