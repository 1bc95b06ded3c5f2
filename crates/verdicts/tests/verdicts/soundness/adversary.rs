//! Claims of an adversary, by what went wrong: each has a truth of its own, found by hand and by an evaluator of its own.

use crate::common;
use torse_syntax::taxonomy::Verdict::{
    self, Conditional, False, Holds, Misprint, Undecided, Vacuous,
};
use torse_verdicts::outcome::Outcome;

/// Declarations of claims that bring their own symbols.
const PLAIN: &str = "[symbols]\nx = {}\n";

/// The outcome of a claim; an error where it makes no sense.
fn decided(declarations: &str, lines: &str) -> Result<Outcome, String> {
    let paper = common::loaded("adversary", declarations, &[lines]).map_err(|e| e.to_string())?;
    let claim = &paper.claims[0];
    torse_verdicts::engine::decide_claim("adversary", claim).map_err(|e| e.to_string())
}

/// The verdict is one of these, and no level contradicts another. A condition is right only with a point at which it fails
/// and the statement fails beside it.
#[track_caller]
pub(super) fn found(declarations: &str, lines: &str, accepted: &[Verdict]) -> Outcome {
    let found = decided(declarations, lines).unwrap_or_else(|error| panic!("{lines}: {error}"));
    assert!(found.contradiction().is_none(), "{lines}: {found:#?}");
    assert!(accepted.contains(&found.verdict()), "{lines}: {found:#?}");
    if found.verdict() == Conditional {
        let net = found.net().unwrap();
        assert!(
            net.conditions.iter().any(|sides| sides.seen_needed()),
            "{lines}: {found:#?}"
        );
    }
    found
}

/// The claim is proved under a condition of which nothing is said but that.
#[track_caller]
pub(super) fn found_open(declarations: &str, lines: &str, accepted: &[Verdict]) {
    let found = decided(declarations, lines).unwrap_or_else(|error| panic!("{lines}: {error}"));
    assert!(found.contradiction().is_none(), "{lines}: {found:#?}");
    assert!(accepted.contains(&found.verdict()), "{lines}: {found:#?}");
}

/// The same, where the claim may also make no sense.
#[track_caller]
fn found_or_wrong(declarations: &str, lines: &str, accepted: &[Verdict]) {
    if decided(declarations, lines).is_ok() {
        found(declarations, lines, accepted);
    }
}

/// The claim makes no sense.
#[track_caller]
fn wrong(declarations: &str, lines: &str) {
    let found = decided(declarations, lines);
    assert!(found.is_err(), "{lines}: {found:#?}");
}

#[test]
fn mixed_derivatives_of_arbitrary_functions_add_their_orders() {
    found(
        PLAIN,
        r#"symbols = { f = { function = 1 }, u = {  }, v = {  } }
states = "D(D(f(u + v), u), v) == 0""#,
        &[False, Misprint],
    );
    found(
        PLAIN,
        r#"symbols = { f = { function = 1 }, u = {  }, v = {  } }
states = "D(D(f(u*v), v), u) == f'(u*v)""#,
        &[False, Misprint],
    );
    found(
        PLAIN,
        r#"symbols = { f = { function = 1 }, u = {  }, w = {  } }
let = { "X(u)" = "D(f(u + w), w)" }
states = "X'(u) == 0""#,
        &[False, Misprint],
    );
    found(
        PLAIN,
        r#"symbols = { f = { function = 1 }, u = {  }, v = {  } }
states = "D(D(f(u + v)*v, u), v) == f'(u + v)""#,
        &[False, Misprint],
    );
    found(
        PLAIN,
        r#"symbols = { f = { function = 1 }, u = {  }, v = {  }, x = {  }, y = {  } }
let = { "G(x, y)" = "f(x*y)" }
states = "D(D(G)(3, v), v) == f'(3*v) + 3*v*f''(3*v)""#,
        &[Holds],
    );
    found(
        PLAIN,
        r#"symbols = { f = { function = 1 }, u = {  }, v = {  } }
states = "D(D(f(u*v), v), u) == f'(u*v) + u*v*f''(u*v)""#,
        &[Holds],
    );
}

#[test]
fn a_value_of_a_function_is_no_unknown() {
    found(
        PLAIN,
        r#"symbols = { x = {  } }
assume = ["sin(x) == 2"]
states = "x == 5""#,
        &[Vacuous],
    );
    found(
        PLAIN,
        r#"symbols = { y = {  } }
assume = ["exp(y) == 1"]
states = "y == 0""#,
        &[Holds],
    );
    found(
        PLAIN,
        r#"symbols = { y = {  }, z = {  } }
assume = ["exp(y) == exp(z)"]
states = "y == z""#,
        &[Holds],
    );
    found(
        PLAIN,
        r#"symbols = { y = {  }, z = {  } }
assume = ["exp(y) == z"]
states = "z > 0""#,
        &[Holds],
    );
    found(
        PLAIN,
        r#"symbols = { x = {  } }
assume = ["pi == x"]
states = "x > 3""#,
        &[Holds],
    );
    found(
        PLAIN,
        r#"symbols = { x = {  } }
assume = ["pi == 3"]
states = "x == 7""#,
        &[Vacuous],
    );
    found_or_wrong(
        PLAIN,
        r#"symbols = { x = {  }, y = {  } }
given = ["sin(y) == x"]
solve_for = ["sin(y)"]
states = "x <= 1""#,
        &[Holds],
    );
    found(
        PLAIN,
        r#"symbols = { x = {  } }
states = "exp(x) == 1 implies x == 0""#,
        &[Holds],
    );
    found(
        PLAIN,
        r#"symbols = { x = {  }, y = {  }, t = {  } }
assume = ["cos(t) == x", "sin(t) == y"]
states = "x^2 + y^2 == 1""#,
        &[Holds],
    );
}

#[test]
fn a_divisor_of_an_elimination_is_not_lost() {
    found(
        PLAIN,
        r#"symbols = { x = {  }, y = {  }, z = {  }, w = {  } }
assume = ["x*(y^2 - 2) == 0"]
states = "exp(x) == 1""#,
        &[False, Misprint, Conditional],
    );
    // No point at which the divisor vanishes can be written: the condition is not said to be needed.
    found_open(
        PLAIN,
        r#"symbols = { x = {  }, y = {  }, z = {  }, w = {  } }
assume = ["x*(exp(y) - 2) == 0"]
states = "cos(x) == 1""#,
        &[False, Misprint, Conditional],
    );
    found(
        PLAIN,
        r#"symbols = { x = {  }, y = {  } }
given = ["x*(y^2 - 2) == y^2 - 2"]
solve_for = ["x"]
states = "exp(x) == exp(1)""#,
        &[False, Misprint, Conditional],
    );
    found(
        PLAIN,
        r#"symbols = { x = {  }, y = {  } }
states = "x*(y^2 - 2) == 0 implies exp(x) == 1""#,
        &[False, Misprint, Conditional],
    );
    found(
        r#"[symbols]
x = {}

[basis.B]
variable = "x"
degree = 0
seeds = ["1"]
step = ["1 - x", "x"]
"#,
        r#"symbols = { x = {  }, y = {  }, z = {  }, m = { integer = ">= 0" }, P = { family = "any", indices = ["0..m"] } }
assume = ["(x - 1)*(y^2 - 2) == 0"]
states = "sum(i,0,m,B[i,m](x)*P[i]) == P[m]""#,
        &[False, Misprint, Conditional],
    );
    found(
        PLAIN,
        r#"symbols = { x = {  }, y = {  }, z = {  }, i = { integer = "0..3" }, m = { integer = ">= 0" }, w = { family = 1, indices = ["0..9"] } }
assume = ["i*(y^2 - 2) == 0"]
states = "exp(i) == 1""#,
        &[False, Misprint, Conditional],
    );
    // Of a number that exists "only if" is not said.
    found_open(
        PLAIN,
        r#"symbols = { r = {  }, x = {  }, y = {  } }
assume = ["x*(y^2 - 2) == 0"]
exists = ["r"]
states = "r == exp(x) and r == 1""#,
        &[False, Misprint, Conditional],
    );
    found(
        PLAIN,
        r#"symbols = { x = {  }, y = {  } }
assume = ["x^2 - x*y == 2*x - 2*y"]
states = "exp(x) == exp(y)""#,
        &[False, Misprint, Conditional],
    );
    found(
        PLAIN,
        r#"symbols = { x = {  }, y = {  }, z = {  }, w = {  } }
assume = ["x*(y^2 - 2) == 0", "z*(w^2+1) == x"]
states = "z == 0""#,
        &[False, Misprint, Conditional],
    );
    found(
        PLAIN,
        r#"symbols = { x = {  }, y = {  }, z = {  }, w = {  }, v = {  } }
states = "x*(y^2 - 2) == 0 and z*(w^2 + 1) == x implies z == 0""#,
        &[False, Misprint, Conditional],
    );
}

#[test]
fn at_sets_what_a_property_of_a_basis_is_about() {
    found(
        r#"[symbols]
x = {}

[basis.A]
variable = "x"
degree = 1
seeds = ["(1-x)*c", "1 - (1-x)*c"]
step = ["1 - x", "x"]
"#,
        r#"symbols = { x = { in = "[0, 1]" }, c = { in = "[0, 1]" } }
states = "at(nonnegative(A), c, 2)""#,
        &[False, Misprint],
    );
    wrong(
        r#"[symbols]
x = {}

[basis.L]
variable = "x"
degree = 1
seeds = ["1-x", "x"]
"#,
        r#"symbols = { x = { in = "[0, 1]" } }
states = "at(nonnegative(L), x, 5)""#,
    );
    found(
        r#"[symbols]
x = {}

[basis.A]
variable = "x"
parameters = ["c"]
degree = 1
seeds = ["(1-x)*c", "1 - (1-x)*c"]
step = ["1 - x", "x"]
"#,
        r#"symbols = { x = { in = "[0, 1]" }, c = { in = "[0, 2]" } }
states = "c <= 1 implies nonnegative(A)""#,
        &[Holds],
    );
}

#[test]
fn a_denied_hypothesis_is_about_the_point() {
    found(
        PLAIN,
        r#"symbols = { x = {  } }
assume = ["not (x == 0)"]
states = "x != 0""#,
        &[Holds],
    );
}

#[test]
fn a_root_of_a_basis_function_looks_into_the_seeds() {
    found(
        r#"[symbols]
x = {}

[basis.A]
variable = "x"
degree = 0
seeds = ["mu"]
step = ["1 - x", "x"]
"#,
        r#"symbols = { x = { in = "[0, 1]" }, mu = { in = "[0, inf)" } }
states = "sqrt(A[0,0](x)) == at(sqrt(A[0,0](x)), mu, 4)""#,
        &[False, Misprint, Undecided],
    );
    found(
        r#"[symbols]
x = {}

[basis.A]
variable = "x"
degree = 0
seeds = ["mu"]
step = ["1 - x", "x"]
"#,
        r#"symbols = { x = { in = "[0, 1]" }, mu = { in = "(0, inf)" } }
states = "sqrt(A[0,0](x)) == integral(sqrt(A[0,0](x)), mu, 0, 1)""#,
        &[False, Misprint, Undecided],
    );
}

#[test]
fn an_integral_over_a_place_without_a_value_has_none() {
    found(
        PLAIN,
        r#"symbols = { x = {  } }
states = "integral(x/x, x, -1, 1) == 3""#,
        &[Vacuous, Undecided],
    );
}

#[test]
fn what_the_prover_finds_is_no_contradiction() {
    found(
        PLAIN,
        r#"symbols = { x = {  } }
states = "(x > 0 implies x > 1) or x > 0""#,
        &[Holds],
    );
    found(
        PLAIN,
        r#"symbols = { m = { integer = ">= -2" }, i = { integer = "0..1" }, w = { family = 1, indices = ["0..m"] } }
assume = ["m != 2"]
states = "w[1] == w[0]""#,
        &[False, Misprint],
    );
    found(
        PLAIN,
        r#"symbols = { m = { integer = ">= -2" }, i = { integer = "0..1" }, w = { family = 1, indices = ["0..m"] } }
assume = ["m < 0"]
states = "w[0] == 1""#,
        &[Vacuous, Undecided],
    );
    found(
        PLAIN,
        r#"symbols = { t = {  } }
assume = ["cos(t) == 0"]
states = "sin(t) == 1""#,
        &[False, Misprint],
    );
    found(
        PLAIN,
        r#"symbols = { m = { integer = ">= 0" } }
assume = ["m^2 == 2"]
states = "m == 7""#,
        &[Vacuous],
    );
}

#[test]
fn constants_and_values_of_functions_determine_what_stands_in_them() {
    let free = "[symbols]\nx = {}\ny = {}\nz = {}\nth = {}\nw = {}\nn = { vector = 3 }\nm = { vector = 3 }\n";
    let holding = [
        "assume = ['x*y == exp(z)']\nstates = 'x*y == exp(z)'",
        "assume = ['exp(z) == 2']\nstates = 'exp(z) == 2'",
        "states = 'exp(z) == 1 implies z == 0'",
        "assume = ['exp(z) == x']\nstates = 'x > 0'",
        "assume = ['x*y == cos(th)']\nstates = 'x*y <= 1'",
        "assume = ['exp(z) == w', 'z <= 0']\nstates = 'w <= 1'",
        "assume = ['dot(n,m) == cos(th)', 'dot(n,n) == 1', 'dot(m,m) == 1']\nstates = 'dot(cross(n,m),cross(n,m)) == sin(th)^2'",
        "assume = ['x + y + z == pi']\nstates = 'sin(x) == sin(y + z)'",
        "assume = ['x + y == pi']\nstates = 'x + y == pi'",
        "assume = ['x*y == pi']\nstates = 'x*y > 3'",
        "assume = ['x*y == sqrt(2)']\nstates = 'x^2*y^2 == 2'",
    ];
    for lines in holding {
        found(free, lines, &[Holds]);
    }
    found(
        free,
        "assume = ['cos(th) == 2']\nstates = 'x == 5'",
        &[Vacuous],
    );
    // A point with a value for `exp(z)` is none.
    found(
        free,
        "assume = ['exp(z) == x', 'x > 1']\nstates = 'z > 0'",
        &[Holds, Undecided],
    );
}

#[test]
fn what_an_equation_became_is_no_reason_why_its_divisor_does_not_vanish() {
    let free = "[symbols]\nx = {}\ny = {}\nz = {}\n";
    // At x = -4 and y = 0 the second equation holds as well.
    let lines = "assume = ['x*y == y', 'y == x + 4']\nstates = 'x == 1'";
    found(free, lines, &[False, Misprint, Conditional]);
    // There are no points but where the divisor is zero.
    for lines in [
        "assume = ['x*y == 0', 'y == 0']\nstates = 'x == 0'",
        "assume = ['x*y == y', 'y == 0']\nstates = 'exp(x) == exp(1)'",
    ] {
        found(free, lines, &[False, Misprint]);
    }
    found(
        free,
        "assume = ['x*y == 0', 'y == 0']\nstates = 'x*z == z*x + y'",
        &[Holds],
    );
}

#[test]
fn what_hypotheses_settle_is_no_condition() {
    let free = "[symbols]\nx = {}\ny = {}\nn = { vector = 3 }\n";
    for lines in [
        "assume = ['x^2+y^2 == 1']\nstates = 'x/(x^2+y^2) == x'",
        "assume = ['dot(n,n) == 1']\nstates = 'x/dot(n,n) == x'",
        "assume = ['0 < y', 'y < x']\nstates = '(x^2-y^2)/(x^2-y^2) == 1'",
    ] {
        found(free, lines, &[Holds]);
    }
}

#[test]
fn a_statement_without_a_value_anywhere_does_not_hold() {
    found(
        PLAIN,
        "states = '1/0 == 1 or x == x'",
        &[Undecided, Vacuous],
    );
    found(
        PLAIN,
        "states = 'sqrt(-1 - x^2) == sqrt(-1 - x^2)'",
        &[Undecided, Vacuous],
    );
}

#[test]
fn a_root_under_an_integral_is_no_mistake_of_the_file() {
    let lines = "states = 'integral(norm([x^2 - 4, 2*x]), x, 0, 1) == 5'";
    found(PLAIN, lines, &[Undecided]);
}
