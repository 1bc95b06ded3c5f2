//! Formulas of the three papers as code.

use crate::formula::parse;
use crate::notation::{rust, sympy};

fn codes(formula: &str, expected_rust: &str, expected_sympy: &str) {
    let expr = parse(formula).unwrap();
    assert_eq!(rust(&expr), expected_rust);
    assert_eq!(sympy(&expr), expected_sympy);
}

/// gbt-developable eq. (3.11), third line, as printed.
const SECOND_DERIVATIVE: &str = "D(H, x, 2)(0) == 1/4*(4*(k - 2)*(k - 3 + pi*(1 + mu))*(Q[0] - 2*Q[1] + Q[2]) + 2*pi^2*mu*(Q[0] - Q[1]) - pi^2*(1 - nu)*(Q[1] - Q[2]))";

#[test]
fn code_keeps_integers_apart_in_rust_and_stays_exact_in_sympy() {
    codes(
        SECOND_DERIVATIVE,
        "H_d2(0.0) == 1.0 / 4.0 * (4.0 * (k - 2.0) * (k - 3.0 + std::f64::consts::PI * (1.0 + mu)) * (Q[0] - 2.0 * Q[1] + Q[2]) + 2.0 * std::f64::consts::PI.powi(2) * mu * (Q[0] - Q[1]) - std::f64::consts::PI.powi(2) * (1.0 - nu) * (Q[1] - Q[2]))",
        "Eq(diff(H(x), x, 2).subs(x, 0), Rational(1, 4)*(4*(k - 2)*(k - 3 + pi*(1 + mu))*(Q[0] - 2*Q[1] + Q[2]) + 2*pi**2*mu*(Q[0] - Q[1]) - pi**2*(1 - nu)*(Q[1] - Q[2])))",
    );
    codes(
        "sum(i, 0, k - 2, binom(k, i)*x^i*2^k*f[i,k](x)*R[i+1,1])/k",
        "(0..=k - 2).map(|i| binom(k, i) * x.powi(i) * 2.0_f64.powi(k) * f(i, k, x) * R[(i + 1) as usize][1]).sum::<f64>() / f64::from(k)",
        "Sum(binomial(k, i)*x**i*sympify(2)**k*f(i, k, x)*R[i + 1, 1], (i, 0, k - 2))/k",
    );
    codes(
        "0 <= lambda < 0.50 implies not det([[1, 2], [3, x]]) == -1/3 or D(g[i,k], x)(1) > D(x*y, x)",
        "!(0.0 <= lambda && lambda < 0.50) || !(det([[1.0, 2.0], [3.0, x]]) == -1.0 / 3.0) || g_d1(i, k, 1.0) > derivative(x * y, x, 1)",
        "Implies(And(Le(0, lambda_), Lt(lambda_, Rational('0.50'))), Or(Not(Eq(Matrix([[1, 2], [3, x]]).det(), Rational(-1, 3))), Gt(diff(g(i, k, x), x).subs(x, 1), diff(x*y, x))))",
    );
    codes(
        "norm(cross(a, b))/sqrt(2) + sin(2*x)^(k/2) - (1 + 2)/3",
        "norm(cross(a, b)) / 2.0_f64.sqrt() + (2.0 * x).sin().powf(k / 2.0) - (1.0 + 2.0) / 3.0",
        "a.cross(b).norm()/sqrt(2) + sin(2*x)**(k/2) - sympify(1 + 2)/3",
    );
}
