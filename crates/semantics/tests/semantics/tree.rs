//! Trees mean what the language says, where a second reading of the text went wrong, or might.

use crate::support::{in_declarations, in_shared};
use torse_semantics::Judgement;

#[track_caller]
fn is(expected: bool, states: &str, point: &[(&str, &str)]) {
    let found = in_shared("", states, point);
    assert_eq!(found.decided(), Some(expected), "{states}: {found}");
}

#[track_caller]
fn is_undefined(states: &str, point: &[(&str, &str)]) {
    let found = in_shared("", states, point);
    assert!(
        matches!(found, Judgement::Undefined(_)),
        "{states}: {found}"
    );
}

const FUNCTION: &str = "symbols = { f = { function = 1 }, u = {}, v = {} }";

#[track_caller]
fn of_function(expected: bool, states: &str, point: &[(&str, &str)]) {
    let found = in_shared(FUNCTION, states, point);
    assert_eq!(found.decided(), Some(expected), "{states}: {found}");
}

#[test]
fn orders_of_derivatives_by_different_variables_add() {
    let point = [("u", "2"), ("v", "3")];
    of_function(true, "D(D(f(u*v), v), u) == f'(u*v) + u*v*f''(u*v)", &point);
    of_function(false, "D(D(f(u*v), v), u) == f'(u*v)", &point);
    of_function(false, "D(D(f(u + v), u), v) == 0", &point);
    of_function(false, "D(D(f(u + v)*v, u), v) == f'(u + v)", &point);
    of_function(
        true,
        "D(D(f(u + v)*v, u), v) == f'(u + v) + v*f''(u + v)",
        &point,
    );
}

#[test]
fn a_definition_sees_what_is_moved() {
    let fields =
        format!("{FUNCTION}\nlet = {{ \"X(u)\" = 'D(f(u + v), v)', \"G(x, y)\" = 'f(x*y)' }}");
    let found = |states: &str| in_shared(&fields, states, &[("u", "2"), ("v", "3")]).decided();
    assert_eq!(found("X'(u) == 0"), Some(false));
    assert_eq!(found("X'(u) == f''(u + v)"), Some(true));
    assert_eq!(
        found("D(D(G)(3, v), v) == f'(3*v) + 3*v*f''(3*v)"),
        Some(true)
    );
    assert_eq!(found("at(X(1), v, 5) == f'(6)"), Some(true));
}

#[test]
fn functions_at_one_place_under_two_names_are_the_same() {
    of_function(true, "f(u) == f(v)", &[("u", "2"), ("v", "2")]);
    of_function(false, "f(u) == f(v)", &[("u", "2"), ("v", "3")]);
    of_function(false, "D(f(u), u, 3) == f''(u)", &[("u", "2"), ("v", "3")]);
}

#[test]
fn an_integrand_without_a_value_somewhere_has_no_integral() {
    is_undefined("integral(y/y, y, -1, 1) == 3", &[("y", "2")]);
    is_undefined("integral(1/(y - 1/3), y, -1, 1) == 3", &[("y", "2")]);
    is_undefined("integral(tan(y), y, 1, 2) == 3", &[("y", "2")]);
    is(true, "integral(1/(y + 2), y, 0, 0) == 0", &[("y", "2")]);
    is(true, "integral(y^2, y, -1, 1) == 2/3", &[("y", "2")]);
    is(
        true,
        "D(integral(a*y^2, y, 0, a), a) == 4*a^3/3",
        &[("y", "2"), ("a", "3")],
    );
}

const BASES: &str = r#"
[symbols]
x = { in = "[0, 1]" }
c = {}
mu = {}
[basis.A]
variable = "x"
degree = 1
seeds = ["(1-x)*c", "1 - (1-x)*c"]
step = ["1 - x", "x"]
[basis.S]
variable = "x"
parameters = ["c"]
degree = 1
seeds = ["(1-x)*c", "1 - (1-x)*c"]
step = ["1 - x", "x"]
[basis.R]
variable = "x"
degree = 0
seeds = ["mu"]
step = ["1 - x", "x"]
"#;

#[test]
fn a_property_is_about_the_shape_parameters_of_the_point() {
    for basis in ["A", "S"] {
        let found = |states: &str, c: &str| {
            in_declarations(BASES, &states.replace('A', basis), &[("c", c)]).decided()
        };
        assert_eq!(found("at(nonnegative(A), c, 2)", "1/2"), Some(false));
        assert_eq!(found("at(nonnegative(A), c, 1/2)", "2"), Some(true));
        assert_eq!(found("c <= 1 implies nonnegative(A)", "1/2"), Some(true));
        assert_eq!(found("c <= 1 implies nonnegative(A)", "2"), Some(true));
        assert_eq!(found("nonnegative(A)", "2"), Some(false));
        assert_eq!(found("not nonnegative(A)", "2"), Some(true));
        assert_eq!(found("independent(A)", "1/2"), Some(true));
        assert_eq!(found("independent(A)", "0"), Some(false));
        assert_eq!(found("variation_diminishing(A)", "1"), Some(true));
    }
    let by_variable = in_declarations(BASES, "at(nonnegative(S), x, 5)", &[("c", "1")]);
    assert!(
        matches!(by_variable, Judgement::Unknown(_)),
        "{by_variable}"
    );
}

#[test]
fn seeds_see_what_is_moved() {
    let found = |states: &str| {
        let point = [("mu", "2"), ("x", "1/2"), ("c", "0")];
        in_declarations(BASES, states, &point).decided()
    };
    assert_eq!(
        found("sqrt(R[0,0](x)) == at(sqrt(R[0,0](x)), mu, 4)"),
        Some(false)
    );
    assert_eq!(found("at(sqrt(R[0,0](x)), mu, 4) == 2"), Some(true));
    assert_eq!(found("integral(R[0,0](x), mu, 0, 1) == 1/2"), Some(true));
    assert_eq!(found("D(R[1,2](x), mu) == 2*x*(1 - x)"), Some(true));
}

#[test]
fn a_denial_is_about_the_point() {
    is(true, "not (y == 0) implies y != 0", &[("y", "0")]);
    is(true, "not (y == 0)", &[("y", "1")]);
    is(false, "not (y == 0)", &[("y", "0")]);
    is(true, "not (y > 0 and y < 1)", &[("y", "2")]);
    is_undefined("not (1/y == 0)", &[("y", "0")]);
    is(true, "fails(y == 0)", &[("y", "1")]);
}

#[test]
fn a_root_that_begins_with_zero_has_no_derivative() {
    is_undefined("D(sqrt(y^4), y) == 0", &[("y", "0")]);
    is(true, "D(sqrt(y^4), y) == 2*y", &[("y", "3")]);
    is_undefined("D(y^y, y) == 0", &[("y", "2")]);
    is_undefined("D(a*sqrt(a*y - 4), y) == 1", &[("y", "2"), ("a", "2")]);
}

#[test]
fn nested_derivatives_have_infinitesimals_of_their_own() {
    // A function that is differentiated inside of a derivative by the same name, and applied at what is moved.
    is(true, "D(y*D(a*y, a), y) == 2*y", &[("y", "3"), ("a", "5")]);
    is(
        true,
        "D(y*at(D(y*a, a), a, y), y) == 2*y",
        &[("y", "3"), ("a", "5")],
    );
    is(
        true,
        "D(D(y^3*a^2, y)*a, a) == 9*y^2*a^2",
        &[("y", "3"), ("a", "5")],
    );
    let fields = "let = { \"F(s)\" = 's^2*y', \"G(s)\" = 'D(F(s*r), s)' }";
    let found =
        |states: &str| in_shared(fields, states, &[("y", "3"), ("r", "5"), ("s", "7")]).decided();
    assert_eq!(found("D(F'(y), y) == 4*y"), Some(true));
    assert_eq!(found("D(F, y)(s) == s^2"), Some(true));
    assert_eq!(found("D(D(F, y)(y), y) == 2*y"), Some(true));
    assert_eq!(found("D(G(y), r) == 4*y^2*r"), Some(true));
    assert_eq!(found("D(at(F, y, y^2)(2), y) == 8*y"), Some(true));
}

#[test]
fn coefficients_move_members_and_coordinates() {
    let point = [
        ("m", "2"),
        ("a", "2"),
        ("P[0]", "1"),
        ("P[1]", "3"),
        ("P[2]", "5"),
        ("p[1]", "1"),
        ("p[2]", "2"),
        ("p[3]", "3"),
    ];
    is(
        true,
        "coefficients([a*P[1] + P[0], 3], [P[0], P[1]]) == [[1, a], [0, 0]]",
        &point,
    );
    is(
        true,
        "coefficients([dot(p, [a, 1, 0])], [p]) == [[2, 1, 0]]",
        &point,
    );
    is(
        true,
        "coefficients([dot(p, [a, 1, 0])], [p[2]]) == [[1]]",
        &point,
    );
    is_undefined("coefficients([P[0]^2], [P[0]]) == 2", &point);
}
