//! A property of a basis is about all values of the variable of the basis, whatever else a statement says of the symbol of that
//! name, and where its functions have no value it has none.

use crate::common::outcomes;
use torse_syntax::taxonomy::Verdict::{self, Conditional, False, Holds, Misprint, Undecided};

/// The verdicts, none of which is an internal contradiction.
fn verdicts(declarations: &str, states: &[&str]) -> Vec<Verdict> {
    let states: Vec<String> = states.iter().map(|s| format!("states = '{s}'")).collect();
    let lines: Vec<&str> = states.iter().map(String::as_str).collect();
    lined(declarations, &lines)
}

fn lined(declarations: &str, lines: &[&str]) -> Vec<Verdict> {
    let found = outcomes("properties", declarations, lines);
    for outcome in &found {
        assert_eq!(outcome.contradiction(), None, "{outcome:#?}");
    }
    found.iter().map(|outcome| outcome.verdict()).collect()
}

/// Lists with a function that is negative near 3/10, near s, and where r is negative.
const LISTS: &str = r#"
[symbols]
x = { in = "[0, 1]" }
s = { in = "[-2, 2]" }
r = { in = "[-1/1000000, 1]" }

[basis.H]
variable = "x"
degree = 1
seeds = ['(x - 3/10)^2 - 1/1000000', '1']

[basis.L]
variable = "x"
parameters = ["s"]
degree = 1
seeds = ['(x - s)*(x - s - 1/1000)', '1']

[basis.Q]
variable = "x"
parameters = ["r"]
degree = 1
seeds = ['(x - 3/10)^2 + r', '1']

[basis.R]
variable = "x"
parameters = ["r"]
degree = 1
seeds = ['x^2 + r', '1']

[basis.U]
variable = "x"
parameters = ["s"]
degree = 1
seeds = ['1', 's*x^2']
"#;

#[test]
fn a_property_of_a_list_is_not_about_the_points_value_of_its_variable() {
    let undecided = [
        "states = 'x >= 2/5 implies nonnegative(H)'",
        "assume = ['x == 1/2']\nstates = 'nonnegative(H)'",
        "states = 'nonnegative(H) or x < 2/5'",
        "states = 'at(nonnegative(L), s, x)'",
        "states = 's == x implies nonnegative(L)'",
        "states = '(x == 1/2 implies nonnegative(H)) and x >= 0'",
        "states = 'fails(nonnegative(Q) implies r >= 0)'",
        "states = 'nonnegative(Q) implies r >= 0'",
        "assume = ['nonnegative(Q)']\nstates = 'r >= 0'",
        "states = 'nonnegative(U) implies s >= 0'",
    ];
    assert_eq!(lined(LISTS, &undecided), [Undecided; 10]);
}

#[test]
fn a_property_of_a_list_is_decided_where_nothing_else_chooses_its_variable() {
    let states = [
        "states = 'nonnegative(H)'",
        "assume = ['r >= 0']\nstates = 'nonnegative(R)'",
        "states = 'r < 0 or nonnegative(R)'",
        "states = 'r >= 0 implies nonnegative(R)'",
        "states = 'r >= -1/2000000 implies nonnegative(R)'",
        "states = 'x >= 0 and fails(nonnegative(U))'",
    ];
    let found = lined(LISTS, &states);
    let refuted = |verdict: &Verdict| matches!(verdict, False | Misprint);
    assert!(refuted(&found[0]) && refuted(&found[4]), "{found:?}");
    assert_eq!(
        [&found[1..4], &found[5..]].concat(),
        [Holds; 4],
        "{found:?}"
    );
}

#[test]
fn nothing_else_of_a_claim_chooses_the_variable_of_a_list() {
    let declarations = r#"
[symbols]
x = { in = "[0, 1]" }
s = { in = "[-2, 2]" }
v = { in = "[0, x]" }
q = { in = "[x, 1]" }
w = { in = "[2/5, 2*v]" }
j = { integer = "0..3" }
i = { integer = "0..j" }

[define]
c = 'x'
e = 'v + 1'

[basis.L]
variable = "x"
degree = 0
seeds = ['(x - 3/10)^2 - 1/1000000']

[basis.S]
variable = "x"
parameters = ["s"]
degree = 0
seeds = ['(x - s)*(x - s - 1/1000)']

[basis.Q]
variable = "x"
parameters = ["q"]
degree = 0
seeds = ['q - x']

[basis.C]
variable = "x"
parameters = ["c"]
degree = 0
seeds = ['(x - c)*(x - c - 1/1000)']

[basis.J]
variable = "j"
degree = 0
seeds = ['(j - 1)^2*1000000 - 1']
"#;
    let undecided = [
        "assume = ['v == 1/2']\nstates = 'nonnegative(L)'",
        "assume = ['e == 3/2']\nstates = 'nonnegative(L)'",
        "assume = ['w == 1']\nstates = 'nonnegative(L)'",
        "states = 'v >= 2/5 implies nonnegative(L)'",
        "states = 'nonnegative(L) or q > 1/5'",
        "states = 'nonnegative(L) and w > 0'",
        "states = 'nonnegative(L) and sqrt(v - 2/5) >= 0'",
        "states = 'fails(v >= 2/5 implies nonnegative(L))'",
        "states = 'nonnegative(Q)'",
        "states = 'i >= 2 implies nonnegative(J)'",
        "assume = ['i >= 2']\nstates = 'nonnegative(J)'",
        "states = 'sqrt(x - 2/5) >= 0 and nonnegative(L)'",
        "states = 'log(x - 2/5) < 5 and nonnegative(L)'",
        "states = 'nonnegative(S) and sqrt(s - x) >= 0'",
        "states = 's <= 2 implies nonnegative(L) and 0*sqrt(x - 2/5) == 0'",
        "states = 'nonnegative(L) and x/(x - 2/5) == x/(x - 2/5)'",
        "states = 'fails(nonnegative(L) and sqrt(x - 2/5) >= 0)'",
        "states = 'nonnegative(C)'",
        "states = 'fails(nonnegative(C))'",
    ];
    assert_eq!(lined(declarations, &undecided), [Undecided; 19]);
    let refuted = lined(
        declarations,
        &[
            "states = 'nonnegative(L)'",
            "states = 'x^2 + sin(x) >= 0 and nonnegative(L)'",
        ],
    );
    assert!(
        refuted.iter().all(|v| matches!(v, False | Misprint)),
        "{refuted:?}"
    );
}

#[test]
fn the_variable_of_a_basis_and_the_symbol_of_its_name_are_two_things() {
    let declarations = r#"
[symbols]
x = { in = "[0, 1]" }

[define]
c = 'x'

[basis.CS]
variable = "x"
degree = 0
seeds = ['1']
step = ['(x - c)*(x - c - 1/1000)', '1']

[basis.W4]
variable = "x"
degree = 0
seeds = ['1']
step = ['1/2 - (x - 2001/4000*(x-c)^2)/4', '1/2 + (x - 2001/4000*(x-c)^2)/4']

[basis.I1]
variable = "x"
degree = 1
seeds = ['c - x', '1']
step = ['1 - x', 'x']
"#;
    let states = [
        "nonnegative(CS)",
        "variation_diminishing(W4)",
        "nonnegative(I1)",
        "CS[0,1](1/2) == (1/2 - x)*(1/2 - x - 1/1000)",
    ];
    let found = verdicts(declarations, &states);
    assert_eq!(found, [Undecided, Undecided, Undecided, Holds]);
}

#[test]
fn the_variable_of_a_property_is_a_real_symbol() {
    let declarations = r#"
[symbols]
y = {}
n = { integer = "0..5" }

[define]
x = 'y^2'

[basis.L]
variable = "x"
degree = 0
seeds = ['x + 5']

[basis.A]
variable = "x"
degree = 0
seeds = ['x + 5']
step = ['1', 'x']

[basis.N]
variable = "n"
degree = 0
seeds = ['n']

[basis.M]
variable = "n"
degree = 1
seeds = ['n - 1', '1/n']
"#;
    let states = [
        "nonnegative(L)",
        "nonnegative(A)",
        "nonnegative(N)",
        "nonnegative(M)",
    ];
    assert_eq!(verdicts(declarations, &states), [Undecided; 4]);
    let real = r#"
[symbols]
x = { in = "[0, 1]" }
c = { in = "[-1, 1]" }

[basis.D]
variable = "x"
degree = 1
seeds = ['1 - x', 'x/x']
"#;
    let states = ["nonnegative(D)", "x >= 0 and nonnegative(D)"];
    assert_eq!(verdicts(real, &states), [Undecided; 2]);
}

#[test]
fn functions_without_a_value_have_no_property() {
    let declarations = r#"
[symbols]
x = { in = "[0, 1]" }
s = { in = "[1, 2]" }

[basis.A]
variable = "x"
degree = 0
seeds = ['1']
step = ['1 - x^2/x', 'x^2/x']

[basis.B]
variable = "x"
degree = 0
seeds = ['x/x']
step = ['1 - x', 'x']

[basis.C]
variable = "x"
parameters = ["s"]
degree = 0
seeds = ['s/s']
step = ['1 - x', 'x']
"#;
    let states = [
        "variation_diminishing(A)",
        "variation_diminishing(A, 1, 2)",
        "nonnegative(A)",
        "independent(A)",
        "variation_diminishing(B)",
        "variation_diminishing(C)",
    ];
    let found = verdicts(declarations, &states);
    assert_eq!(found[..5], [Undecided; 5]);
    assert_eq!(found[5], Holds);
}

#[test]
fn a_sum_of_symbolic_degree_has_a_value_where_the_step_has_one() {
    let declarations = r#"
[symbols]
x = { in = "[0, 1]" }
s = { in = "[-2, 2]" }
m = { integer = ">= 1" }
l = { integer = "1..3" }

[basis.MS]
variable = "x"
parameters = ["s"]
degree = 0
seeds = ['1']
step = ['1 - x/s', 'x/s']

[basis.MT]
variable = "x"
degree = 0
seeds = ['1']
step = ['1 - tan(pi/2*x)', 'tan(pi/2*x)']

[basis.M6]
variable = "x"
degree = 0
seeds = ['1']
step = ['1 - x^2/x', 'x^2/x']
"#;
    let states = [
        "sum(i,0,m,MS[i,m](x)) == 1",
        "sum(i,0,l,MS[i,l](x)) == 1",
        "sum(i,0,m,MT[i,m](x)) == 1",
        "M6[m,m](x) == x^m",
        "M6[0,m](x) == (1-x)^m",
        "D(sum(i,0,m,MS[i,m](x)),x) == 0",
        "sum(i,0,2,MS[i,2](x)) == 1",
    ];
    assert_eq!(verdicts(declarations, &states), [Conditional; 7]);
}

#[test]
fn what_is_zero_or_a_power_with_the_exponent_zero_has_a_value_where_its_parts_have_one() {
    let declarations = r#"
[symbols]
c = { in = "(-inf, inf)" }
y = { in = "(-inf, inf)" }
x = { in = "[0, 1]" }
m = { integer = ">= 0" }
n = { integer = ">= 1" }
P = { family = "any", indices = ["0..m"] }

[basis.St]
variable = "x"
degree = 0
seeds = ['1']
step = ['(1 - x)/c', 'x/c']
"#;
    let states = [
        "0*sum(i, 0, m, St[i,m](x)) == 0",
        "sum(i, 0, m, 0*St[i,m](x)) == 0",
        "sum(i, 0, m, St[i,m](x)*(P[i] - P[i])) == 0",
        "sum(i, 0, m + 1, 0*St[i,m+1](x)) == 0",
        "D(sum(i, 0, m, St[i,m](x)), y) == 0",
        "D(0*St[0,m](x), x) == 0",
        "sum(i, 0, m, 0*St[i,m](x))^0 == 1",
        "St[0,n](x)^0 == 1",
        "sum(i, 0, m, St[i,m](x)*sum(j, 0, m, 0*P[j])) == 0",
        "0*(1/c)^n == 0",
    ];
    assert_eq!(verdicts(declarations, &states), [Conditional; 10]);
}

#[test]
fn functions_with_a_sum_below_zero_diminish_no_variation() {
    let declarations = r#"
[symbols]
x = { in = "[0, 1]" }

[basis.N2]
variable = "x"
degree = 0
seeds = ['-1']
step = ['1 - x', 'x']

[basis.N6]
variable = "x"
degree = 0
seeds = ['1']
step = ['x - 1', '-x']
"#;
    let states = ["variation_diminishing(N2)", "variation_diminishing(N6)"];
    assert_eq!(verdicts(declarations, &states), [False; 2]);
}

#[test]
fn the_functions_of_one_degree_have_values_together() {
    let declarations = r#"
[symbols]
x = {}
l = { integer = "1..3" }

[basis.S]
variable = "x"
degree = 1
seeds = ['1/x', '1 - x']
step = ['1', '0']

[basis.F]
variable = "x"
degree = 1
seeds = ['x', '1 - x']
step = ['1 - 1/(x - 2)', '1/(x - 2)']

[basis.W]
variable = "x"
degree = 1
seeds = ['x', '1 - x']
step = ['1 - x', 'x']
"#;
    // Where one seed or one factor divides by zero no function has a value, those outside of the range neither.
    let conditional = [
        "S[1,1](x) == 1 - x",
        "S[4,3](x) == 0",
        "F[0,2](x) == x - x/(x - 2)",
        "F[4,3](x) == 0",
        "F[-1,3](x) == 0",
        "F[l + 1,l](x) == 0",
    ];
    assert_eq!(verdicts(declarations, &conditional), [Conditional; 6]);
    // No step is taken, or nothing is divided by.
    let holds = ["F[1,1](x) == 1 - x", "F[2,1](x) == 0", "W[4,3](x) == 0"];
    assert_eq!(verdicts(declarations, &holds), [Holds; 3]);
}
