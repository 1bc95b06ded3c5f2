//! Sums with symbolic degrees: products, sums that run backwards, the index as a factor.

use crate::common;

use torse_prove::evidence::Evidence;
use torse_syntax::taxonomy::Verdict;

const CURVES: &str = r#"
[symbols]
x = { in = "[0, 1]" }
y = { in = "[0, 1]" }
mu = { in = "[-1, 1]" }
m = { integer = ">= 2" }
n = { integer = ">= 2" }
i = { integer = "0..m" }
P = { family = 1, indices = ["0..m"] }
R = { family = 1, indices = ["0..n"] }
G = { family = "any", indices = ["0..m", "0..n"] }
[basis.B]
variable = "x"
degree = 0
seeds = ['1']
step = ['1 - x', 'x']
[basis.f]
variable = "x"
parameters = ["mu"]
degree = 2
seeds = ['(1 - sin(pi/2*x))*(1 - mu*sin(pi/2*x))', '1 - (1 - sin(pi/2*x))*(1 - mu*sin(pi/2*x)) - (1 - cos(pi/2*x))^2', '(1 - cos(pi/2*x))^2']
step = ['1 - x', 'x']
[define]
"C(x)" = 'sum(i, 0, m, f[i,m](x)*P[i])'
"S(y)" = 'sum(j, 0, n, B[j,n](y)*R[j])'
"T(x, y)" = 'sum(i, 0, m, sum(j, 0, n, f[i,m](x)*B[j,n](y)*G[i,j]))'
"#;

fn all_hold_by_induction(name: &str, statements: &[&str]) {
    let found = common::stated(name, CURVES, statements);
    for (outcome, statement) in found.iter().zip(statements) {
        let found = (outcome.verdict(), outcome.evidence());
        assert_eq!(
            found,
            (Verdict::Holds, Some(Evidence::Induction)),
            "{statement}: {outcome:?}"
        );
    }
}

#[test]
fn products_of_two_sums_cancel_for_all_degrees_in_any_order() {
    all_hold_by_induction(
        "products",
        &[
            "C(x)*S(y) == S(y)*C(x)",
            "T(x, y) == sum(j, 0, n, B[j,n](y)*sum(i, 0, m, f[i,m](x)*G[i,j]))",
            "D(C(x)*S(x), x) == C'(x)*S(x) + C(x)*S'(x)",
            "(1 - C(x))*(1 + S(y)) == 1 - C(x) + S(y) - C(x)*S(y)",
            "at(T(x, y), x, 0) == sum(j, 0, n, B[j,n](y)*G[0,j])",
            "at(D(T(x, y), y), y, 1) == n*sum(i, 0, m, f[i,m](x)*(G[i,n] - G[i,n-1]))",
            "C(x)*sum(j, 0, n, B[j,n](y)) == C(x)",
        ],
    );
}

#[test]
fn sums_that_run_backwards_are_read_from_the_other_end() {
    all_hold_by_induction(
        "backwards",
        &[
            "sum(j, 0, n, B[j,n](x)*R[n-j]) == S(1 - x)",
            "sum(j, 0, n, B[n-j,n](x)*R[j]) == S(1 - x)",
            "sum(j, 0, n, B[n-j,n](x)*R[n-j]) == S(x)",
            "sum(i, 0, m, f[i,m](x, 1)*P[m-i]) == sum(i, 0, m, f[i,m](1 - x, 1)*P[i])",
            "sum(i, 0, m, f[m-i,m](x)*P[m-i]) == C(x)",
            "sum(i, 0, m, i*f[m-i,m](x)*P[m-i]) == sum(i, 0, m, (m - i)*f[i,m](x)*P[i])",
        ],
    );
}

#[test]
fn the_index_as_a_factor_is_a_derivation() {
    all_hold_by_induction(
        "weights",
        &[
            "sum(j, 0, n, j*B[j,n](x)) == n*x",
            "sum(j, 0, n, j^2*B[j,n](x)) == n*(n - 1)*x^2 + n*x",
            "sum(j, 0, n, j*(j - 1)*(j - 2)*B[j,n](x)) == n*(n - 1)*(n - 2)*x^3",
            "i*B[i,m](x) == m*x*B[i-1,m-1](x)",
            "x*(1 - x)*D(B[i,m](x), x) == (i - m*x)*B[i,m](x)",
        ],
    );
}

#[test]
fn wrong_equations_between_products_are_refuted_at_small_degrees() {
    let wrong = [
        "C(x)*S(y) == C(x)*S(x)",
        "sum(j, 0, n, B[j,n](x)*R[n-j]) == S(x)",
        "sum(j, 0, n, j^2*B[j,n](x)) == n^2*x^2",
        "T(x, y) == T(y, x)",
        "i*B[i,m](x) == m*x*B[i,m-1](x)",
    ];
    for outcome in common::stated("wrong-products", CURVES, &wrong) {
        assert_eq!(outcome.verdict(), Verdict::False, "{outcome:?}");
    }
}
