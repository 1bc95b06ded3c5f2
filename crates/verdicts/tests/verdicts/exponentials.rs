//! Exponentials and hyperbolic functions: identities, signs by ordered exponents, numbers made of e and pi, and steps of a
//! basis that depend on the index.

use crate::common;

use torse_syntax::taxonomy::Verdict::{self, Conditional, False, Holds, Undecided, Vacuous};

const SHARED: &str = r#"
[symbols]
y = {}
z = {}
u = { in = "[0, 1]" }
t = { in = "[0, inf)" }
a = { in = "(0, inf)" }
k = { family = 1, indices = ["0..5"] }
m = { integer = ">= 1" }

[basis.N]
variable = "y"
degree = 0
seeds = ['1']
index = "i"
order = "n"
step = ['(k[i+3] - y)/(k[i+3] - k[i+3-n])', '(y - k[i+2-n])/(k[i+2] - k[i+2-n])']
"#;

#[track_caller]
fn verdict(lines: &str, wanted: Verdict) {
    let found = common::outcomes("exponentials", SHARED, &[lines]);
    let found = found.first().expect("one claim");
    assert_eq!(found.contradiction(), None, "{lines}");
    assert_eq!(found.verdict(), wanted, "{lines}: {found:#?}");
}

#[track_caller]
fn states(statement: &str, wanted: Verdict) {
    verdict(&format!("states = \"{statement}\""), wanted);
}

#[test]
fn parts_and_products_in_one_exponent_are_one_algebra() {
    states("exp(y/2)*exp(y/3) == exp(5*y/6)", Holds);
    states("exp(y*z)*exp(-y*z/2) == exp(y*z/2)", Holds);
    states("exp(y)*exp(z) == exp(y*z)", False);
    states("cosh(2*y) == 1 + 2*sinh(y)^2", Holds);
    states("at(exp(y*z), y, z) == exp(z^2)", Holds);
    states("1/exp(y) == exp(-y)", Holds);
    states("(exp(y) - 1)/(exp(y) - 1) == 1", Conditional);
    states("exp(t)/cosh(t) == 1 + tanh(t)", Holds);
}

#[test]
fn exponentials_have_the_range_and_the_order_of_their_exponents() {
    states("exp(y) > 0", Holds);
    states("exp(-t) <= 1", Holds);
    states("exp(-t) < 1", False);
    states("exp(u) <= exp(1)", Holds);
    states("exp(u) < exp(1)", False);
    states("exp(u) <= 2.718", False);
    states("exp(u) <= 2.719", Holds);
    states("exp(a*u) <= exp(a)", Holds);
    states("sinh(a*(1 - u)) >= 0", Holds);
    states("exp(-y^2) > 0 and exp(-y^2) <= 1", Holds);
    verdict(
        "assume = ['t <= a']\nstates = 'sinh(a - t)*sinh(t) >= 0'",
        Holds,
    );
    verdict("assume = ['t <= 2*a']\nstates = 'sinh(a - t) >= 0'", False);
    verdict("assume = ['y < z']\nstates = 'exp(y/2) < exp(z/2)'", Holds);
    verdict("assume = ['exp(t) < 1']\nstates = 'exp(t) == 0'", Vacuous);
}

#[test]
fn beside_its_own_exponent_an_exponential_is_above_its_partial_sums() {
    states("exp(y) >= 1 + y", Holds);
    states("exp(-y) >= 1 - y", Holds);
    states("exp(y) > 1 + y", False);
    // Those of odd degree everywhere, those of even degree where the exponent is positive.
    states("exp(y) >= 1 + y + y^2/2", False);
    states("exp(t) >= 1 + t + t^2/2", Holds);
    states("exp(a) > 1 + a + a^2/2", Holds);
    states("exp(t) > 1 + t + t^2/2", False);
    states("exp(y) >= 1 + y + y^2/2 + y^3/6", Holds);
    states("exp(t) >= 1 + t + t^2/2 + t^3/6 + t^4/24", Holds);
    states("exp(t/2) >= 1 + t/2 + t^2/8", Holds);
    states("exp(t/2) >= 1 + t/2 + t^2/7", False);
    states("exp(t) >= 1 + t + t^2", False);
    states("exp(-t) <= 1 - t + t^2/2", Holds);
    states("exp(-t) <= 1 - t", False);
    states("sinh(t) >= t + t^3/6", Holds);
    states("sinh(y) >= y", False);
}

#[test]
fn what_is_not_negative_at_zero_and_increases_from_there_is_not_negative() {
    states("tanh(t) <= t", Holds);
    states("tanh(y) <= y", False);
    states("sinh(t) <= t*cosh(t)", Holds);
    states("sinh(t) < t*cosh(t)", False);
    states("sinh(a) < a*cosh(a)", Holds);
    states("cosh(y) >= 1 + y^2/2", Holds);
    states("cosh(y) > 1 + y^2/2", False);
    states("log(1 + t) >= t - t^2/2", Holds);
    states("log(1 + t) <= t - t^2/2", False);
    // The value at zero, and the growth, do not follow from points beyond one.
    let beyond = |states: &str, wanted| {
        verdict(&format!("assume = ['y >= 1']\nstates = '{states}'"), wanted);
    };
    beyond("exp(y) >= 1 + 27/10*y", False);
    beyond("exp(y) >= 3*y", False);
    // A constraint between the variable and another one does not hold between zero and the variable.
    verdict(
        "assume = ['z <= t', '0 <= z']\nstates = 'exp(t)*z - exp(z)*t >= 0'",
        False,
    );
}

#[test]
fn numbers_of_e_and_pi_differ_where_an_enclosure_tells_them_apart() {
    states("exp(1) == 2.718281828459045", False);
    states("exp(1)*pi != 8", Holds);
    states("(exp(1) - pi)/(exp(1) - pi) == 1", Holds);
    states("exp(1/2)*exp(1/3) == exp(5/6)", Holds);
    states("exp(pi) > 0", Undecided);
    states("exp(sqrt(2)*y) > 0", Undecided);
}

#[test]
fn a_step_that_depends_on_the_index_needs_numbers_for_index_and_degree() {
    verdict(
        "assume = ['k[2] < k[3]']\nstates = 'N[0,1](y) + N[1,1](y) == 1'",
        Holds,
    );
    states("N[0,1](y) + N[1,1](y) == 1", Conditional);
    states("sum(i, 0, m, N[i,m](y)) == 1", Undecided);
    states("nonnegative(N)", Undecided);
}
