//! Formulas of the three papers, in every notation.

use crate::formula::parse;
use crate::notation::{latex, rust, sympy, text, typst};

/// Writes `formula` in two notations and compares.
fn sets(formula: &str, expected_typst: &str, expected_latex: &str) {
    let expr = parse(formula).unwrap();
    assert_eq!(text(&expr), formula);
    assert_eq!(typst(&expr), expected_typst);
    assert_eq!(latex(&expr), expected_latex);
}

fn codes(formula: &str, expected_rust: &str, expected_sympy: &str) {
    let expr = parse(formula).unwrap();
    assert_eq!(rust(&expr), expected_rust);
    assert_eq!(sympy(&expr), expected_sympy);
}

/// gbt-developable eq. (3.11), third line, as printed.
const SECOND_DERIVATIVE: &str = "D(H, x, 2)(0) == 1/4*(4*(k - 2)*(k - 3 + pi*(1 + mu))*(Q[0] - 2*Q[1] + Q[2]) + 2*pi^2*mu*(Q[0] - Q[1]) - pi^2*(1 - nu)*(Q[1] - Q[2]))";

#[test]
fn the_second_derivative_at_the_start_is_set_as_printed() {
    sets(
        SECOND_DERIVATIVE,
        "H'' (0) = frac(1, 4) (4 (k - 2) (k - 3 + pi (1 + mu)) (Q_0 - 2 Q_1 + Q_2) + 2 pi^2 mu (Q_0 - Q_1) - pi^2 (1 - nu) (Q_1 - Q_2))",
        r"H'' (0) = \frac{1}{4} (4 (k - 2) (k - 3 + \pi (1 + \mu)) (Q_0 - 2 Q_1 + Q_2) + 2 \pi^2 \mu (Q_0 - Q_1) - \pi^2 (1 - \nu) (Q_1 - Q_2))",
    );
}

#[test]
fn theorem_3_is_set_with_two_indices() {
    sets(
        "Q[2,2] == Q[k,1] + 1/(c_l + pi^2*(1 - nu2))*(Q[k,1] - 2*Q[k-1,1])",
        "Q_(2, 2) = Q_(k, 1) + frac(1, c_l + pi^2 (1 - nu_2)) (Q_(k, 1) - 2 Q_(k - 1, 1))",
        r"Q_{2, 2} = Q_{k, 1} + \frac{1}{c_l + \pi^2 (1 - \nu_2)} (Q_{k, 1} - 2 Q_{k - 1, 1})",
    );
}

#[test]
fn the_second_segment_of_theorem_2_is_set_with_two_digits_below() {
    sets(
        "Q12 == Q[m] + 1/a1*(a2*(Q[m] - 2*Q[m-1] + Q[m-2]) + a3*(Q[m] - Q[m-1]))",
        "Q_12 = Q_m + frac(1, a_1) (a_2 (Q_m - 2 Q_(m - 1) + Q_(m - 2)) + a_3 (Q_m - Q_(m - 1)))",
        r"Q_{12} = Q_m + \frac{1}{a_1} (a_2 (Q_m - 2 Q_{m - 1} + Q_{m - 2}) + a_3 (Q_m - Q_{m - 1}))",
    );
}

#[test]
fn determinants_and_matrices_are_set() {
    sets(
        "det(A) == -2176*k^5 + 4336*k^4 - 2160*k^3",
        "det (A) = -2176 k^5 + 4336 k^4 - 2160 k^3",
        r"\det (A) = -2176 k^5 + 4336 k^4 - 2160 k^3",
    );
    sets(
        "det([[a, b], [c, d]])*inverse(M) == [[1, -1/2], [0, 2*3]]*transpose(A)*[x, y]",
        "mat(delim: \"|\", a, b; c, d) M^(-1) = mat(delim: \"(\", 1, -frac(1, 2); 0, 2 dot.op 3) A^(top) (x, y)",
        r"\begin{vmatrix} a & b \\ c & d \end{vmatrix} M^{-1} = \begin{pmatrix} 1 & -\frac{1}{2} \\ 0 & 2 \cdot 3 \end{pmatrix} A^{\top} (x, y)",
    );
}

#[test]
fn basis_functions_are_set_with_sums_and_tall_brackets() {
    sets(
        "H(x, mu, nu) == sum(i, 0, k, f[i,k](x)*Q[i])",
        "H (x, mu, nu) = sum_(i = 0)^k f_(i, k) (x) Q_i",
        r"H (x, \mu, \nu) = \sum_{i = 0}^k f_{i, k} (x) Q_i",
    );
    sets(
        "f[0,2](x) == (1 - sin(pi/2*x))*(1 - mu*sin(pi/2*x)^2)",
        "f_(0, 2) (x) = (1 - sin (frac(pi, 2) x)) (1 - mu sin^2 (frac(pi, 2) x))",
        r"f_{0, 2} (x) = \left( 1 - \sin \left( \frac{\pi}{2} x \right) \right) \left( 1 - \mu \sin^2 \left( \frac{\pi}{2} x \right) \right)",
    );
    sets(
        "sum(i, 0, k, a[i])*b + b*sum(i, 0, k, a[i] + 1)",
        "(sum_(i = 0)^k a_i) b + b sum_(i = 0)^k (a_i + 1)",
        r"\left( \sum_{i = 0}^k a_i \right) b + b \sum_{i = 0}^k (a_i + 1)",
    );
}

#[test]
fn derivatives_are_set_with_primes_bars_or_fractions() {
    sets(
        "D(g[i,k], x, 3)(1) + D(F, x, 4)(0) == D(F, x, n)",
        "g'''_(i, k) (1) + lr(frac(d^4 F, d x^4) |)_(x = 0) = frac(d^n F, d x^n)",
        r"g'''_{i, k} (1) + \left. \frac{d^4 F}{d x^4} \right|_{x = 0} = \frac{d^n F}{d x^n}",
    );
    sets(
        "dot(cross(D(S(u, v), u), D(S(u, v), v)), n) == D(D(x*y, x), y)",
        "(frac(partial S, partial u) (u, v) times frac(partial S, partial v) (u, v)) dot.op n = frac(partial, partial y) frac(d, d x) (x y)",
        r"\left( \frac{\partial S}{\partial u} (u, v) \times \frac{\partial S}{\partial v} (u, v) \right) \cdot n = \frac{\partial}{\partial y} \frac{d}{d x} (x y)",
    );
}

#[test]
fn statements_are_set_with_signs_of_logic() {
    sets(
        "-1 <= mu < 1 and k >= 2 implies not (x != 0 or x > 1)",
        "-1 <= mu < 1 thick and thick k >= 2 thick ==> thick not (x != 0 thick or thick x > 1)",
        r"-1 \le \mu < 1 \;\land\; k \ge 2 \implies \lnot (x \ne 0 \;\lor\; x > 1)",
    );
}

#[test]
fn names_are_set_as_letters_subscripts_and_words() {
    sets(
        "norm(p0_u - length*q)^2 == sqrt(2)/2*binom(k, i)*2^k*x_start*lambda''^2",
        "norm(p_(0, u) - \"length\" q)^2 = frac(sqrt(2), 2) binom(k, i) dot.op 2^k x_(\"start\") (lambda'')^2",
        r"\lVert p_{0, u} - \mathrm{length} \, q \rVert^2 = \frac{\sqrt{2}}{2} \binom{k}{i} \cdot 2^k \, x_{\mathrm{start}} \, (\lambda'')^2",
    );
    sets(
        "error(x) == 45.708*x - a/b - (-(c/d))",
        "op(\"error\") (x) = 45.708 x - frac(a, b) - (-frac(c, d))",
        r"\operatorname{error} (x) = 45.708 x - \frac{a}{b} - \left( -\frac{c}{d} \right)",
    );
}

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

#[test]
fn a_derivative_by_a_parameter_is_no_prime() {
    assert_eq!(
        latex(&parse("D(G, mu)(x)").unwrap()),
        r"\frac{\partial G}{\partial \mu} (x)"
    );
    assert_eq!(latex(&parse("D(G, x)(x)").unwrap()), "G' (x)");
}
