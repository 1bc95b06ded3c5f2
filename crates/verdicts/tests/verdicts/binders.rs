//! Integrals, products, symbolic powers, sums over no basis, families by a formula in their index, lists of functions.

use crate::common;

use torse_syntax::taxonomy::Verdict::{self, Conditional, False, Holds, Undecided};
use torse_verdicts::words;

const SHARED: &str = r#"
[symbols]
x = { in = "[0, 1]" }
y = {}
t = {}
s = {}
a = {}
i = { integer = "0..3" }
j = { integer = "0..m" }
l = { integer = "0..m" }
m = { integer = ">= 1" }
n = { integer = ">= 0" }
P = { family = "any", indices = ["0..m"] }
w = { family = 1, indices = ["0..m"] }
c = { function = 1 }

[basis.B]
variable = "x"
degree = 0
seeds = ['1']
step = ['1 - x', 'x']

[basis.T]
variable = "x"
degree = 1
seeds = ['1 - x', 'x']

[define]
"Q[j]" = '2*P[j]'
"R[j, l]" = 'j*P[l]'
"#;

/// Verdict and reason.
#[track_caller]
fn decided(states: &str, wanted: Verdict) -> String {
    let found = common::stated("binders", SHARED, &[states]);
    let found = found.first().expect("one claim");
    assert_eq!(found.contradiction(), None, "{states}");
    assert_eq!(
        found.verdict(),
        wanted,
        "{states}: {:?}",
        words::steps(found)
    );
    words::steps(found).concat()
}

#[track_caller]
fn refused(states: &str, reason: &str) {
    let steps = decided(states, Undecided);
    assert!(steps.contains(reason), "{states}: {steps}");
}

#[test]
fn integrals_are_differences_of_antiderivatives() {
    decided("integral(B[i,3](x), x, 0, 1) == 1/4", Holds);
    decided(
        "integral(t^2*sin(t), t, 0, s) == 2*s*sin(s) + (2 - s^2)*cos(s) - 2",
        Holds,
    );
    decided(
        "integral(cos(t/2)*sin(t), t, 0, s) == 4/3*(1 - cos(s/2)^3)",
        Holds,
    );
    decided(
        "integral(exp(-2*t)*cos(t), t, 0, s) == (2 + exp(-2*s)*(sin(s) - 2*cos(s)))/5",
        Holds,
    );
    decided("integral(y*t, t, s, 1) == y*(1 - s^2)/2", Holds);
    decided("integral(exp(a*t), t, 0, 1) == (exp(a) - 1)/a", Conditional);
    decided("integral(t*sin(t), t, 0, s) == sin(s) + s*cos(s)", False);
}

#[test]
fn an_integral_that_is_not_carried_says_why() {
    refused(
        "integral(1/(t^2 + 1), t, 0, s) == s",
        "a quotient by what changes with its variable",
    );
    refused(
        "integral(exp(t^2), t, 0, s) == s",
        "not linear in its variable",
    );
    refused(
        "sum(j, 0, m, integral(B[j,m](x), x, 0, 1)) == 1",
        "a sum of symbolic degree",
    );
    let root = "states = 'integral(sqrt(t^2 + 1), t, 0, s) == s'";
    let found = common::outcomes("binders", SHARED, &[root]).remove(0);
    assert_eq!(found.verdict(), Undecided);
    assert!(words::steps(&found)[0].contains("a root that depends on the variable of an integral"));
}

#[test]
fn symbolic_powers_are_operators_without_a_shift() {
    decided("(1 - x)^m*(1 - x) == (1 - x)^(m + 1)", Holds);
    decided("D((1 - x)^m, x) == -m*(1 - x)^(m - 1)", Holds);
    decided("(x*y)^m*x^n == x^(m + n)*y^m", Holds);
    decided("(y^m)^2 == y^(2*m) and (2*y)^m == 2^m*y^m", Holds);
    decided("B[0,m](x) == (1 - x)^m and B[m,m](x) == x^m", Holds);
    decided(
        "at((1 - x)^m, x, 1) == 0 and at((1 - x)^m, x, 0) == 1",
        Holds,
    );
    decided(
        "sum(j, 0, m, binom(m, j)*y^(m - j)*s^j) == (y + s)^m",
        Holds,
    );
    decided("y^m == y^(m + 1)", False);
    decided("D(x^m, x) == (m + 1)*x^(m - 1)", False);
}

#[test]
fn a_symbolic_power_that_is_not_carried_says_why() {
    refused(
        "y^(m - 2)*y^2 == y^m",
        "the symbolic power m-2, which may be negative",
    );
    refused(
        "sum(j, 0, m, B[j,m](x)*y^j) == (1 - x + x*y)^m",
        "the symbolic power j, which",
    );
    refused(
        "(1 - x)^m + x^m <= 1",
        "an order relation of symbolic degree",
    );
}

#[test]
fn sums_of_powers_have_closed_forms() {
    decided("sum(j, 1, m, j) == m*(m + 1)/2", Holds);
    decided("sum(j, 0, m, y) == (m + 1)*y", Holds);
    decided(
        "sum(j, 0, m, sum(l, 0, j, l)) == m*(m + 1)*(m + 2)/6",
        Holds,
    );
    decided("sum(j, 2, m, 1) == m - 1", Holds);
    decided("sum(j, 3, m, 1) == m - 2", False);
}

#[test]
fn an_inner_sum_to_the_index_of_the_outer_one_is_swapped() {
    decided(
        "sum(j, 0, m, sum(l, 0, j, P[l])) == sum(j, 0, m, (m + 1 - j)*P[j])",
        Holds,
    );
    decided(
        "sum(j, 0, m, sum(l, 0, j, j*P[l])) == sum(j, 0, m, (m*(m + 1) - j*(j - 1))/2*P[j])",
        Holds,
    );
    decided(
        "sum(j, 1, m, sum(l, 0, j - 1, P[l])) == sum(j, 0, m - 1, (m - j)*P[j])",
        Holds,
    );
    decided(
        "sum(j, 0, m, sum(l, 0, j, P[l])) == sum(j, 0, m, (m - j)*P[j])",
        False,
    );
}

#[test]
fn products_telescope_or_say_that_they_do_not() {
    decided("product(j, 1, m, (j + 1)/j) == m + 1", Holds);
    decided(
        "product(j, 1, m, (2*j - 1)/(2*j + 1)) == 1/(2*m + 1)",
        Holds,
    );
    decided("product(j, 1, 3, y + j) == y^3 + 6*y^2 + 11*y + 6", Holds);
    decided("product(j, 1, m, (j + 1)/j) == m", False);
    refused("product(j, 1, m, j) == factorial(m)", "does not telescope");
    // The factors are not defined, or zero, at the lower end: the ends alone would say something else.
    refused("product(j, 0, m, (j + 1)/j) == 0", "does not telescope");
    refused("product(j, 1, m, (j - 1)/j) == 0", "does not telescope");
}

#[test]
fn a_family_by_a_formula_in_its_index_is_its_formula() {
    decided(
        "sum(j, 0, m, B[j,m](x)*Q[j]) == 2*sum(j, 0, m, B[j,m](x)*P[j])",
        Holds,
    );
    decided("Q[m - 1] == 2*P[m - 1] and R[2, m] == 2*P[m]", Holds);
    let round = "states = 'Q(1) == P[1]'";
    let paper = common::paper("binders", SHARED, &[round]);
    assert!(torse_verdicts::engine::decide_claim("binders", &paper.claims[0]).is_err());
}

#[test]
fn a_basis_without_a_step_is_a_list_of_functions() {
    decided("T[0,1](x) + T[1,1](x) == 1 and nonnegative(T)", Holds);
    for states in ["T[0,2](x) == 0", "T[0,m](x) == 0", "independent(T)"] {
        let lines = format!("states = '{states}'");
        let paper = common::paper("binders", SHARED, &[&lines]);
        let error = torse_verdicts::engine::decide_claim("binders", &paper.claims[0]);
        assert!(error.is_err(), "{states}");
    }
}
