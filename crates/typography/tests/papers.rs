//! Formulas of the three papers as they are set.

use torse_syntax::formula::parse;
use torse_typography::{Mathematics, latex, typst};

/// gbt-developable eq. (3.11) and Theorems 2 and 3, gbt-surfaces, determinants of hermite-developable; every construct
/// of the language.
const FORMULAS: [&str; 15] = [
    "D(H, x, 2)(0) == 1/4*(4*(k - 2)*(k - 3 + pi*(1 + mu))*(Q[0] - 2*Q[1] + Q[2]) + 2*pi^2*mu*(Q[0] - Q[1]) - pi^2*(1 - nu)*(Q[1] - Q[2]))",
    "Q[2,2] == Q[k,1] + 1/(c_l + pi^2*(1 - nu2))*(Q[k,1] - 2*Q[k-1,1])",
    "Q12 == Q[m] + 1/a1*(a2*(Q[m] - 2*Q[m-1] + Q[m-2]) + a3*(Q[m] - Q[m-1]))",
    "det(A) == -2176*k^5 + 4336*k^4 - 2160*k^3",
    "det([[a, b], [c, d]])*inverse(M) == [[1, -1/2], [0, 2*3]]*transpose(A)*[x, y]",
    "H(x, mu, nu) == sum(i, 0, k, f[i,k](x)*Q[i])",
    "f[0,2](x) == (1 - sin(pi/2*x))*(1 - mu*sin(pi/2*x)^2)",
    "sum(i, 0, k, a[i])*b + b*sum(i, 0, k, a[i] + 1)",
    "D(g[i,k], x, 3)(1) + D(F, x, 4)(0) == D(F, x, n)",
    "dot(cross(D(S(u, v), u), D(S(u, v), v)), n) == D(D(x*y, x), y)",
    "-1 <= mu < 1 and k >= 2 implies not (x != 0 or x > 1)",
    "norm(p0_u - length*q)^2 == sqrt(2)/2*binom(k, i)*2^k*x_start*lambda''^2",
    "error(x) == 45.708*x - a/b - (-(c/d))",
    "D(G, mu)(x)",
    "D(G, x)(x)",
];

#[test]
fn formulas_are_set_as_papers_print_them() {
    let set = |formula: &str| {
        let tree = parse(formula).unwrap();
        let text = Mathematics::read(formula).unwrap().text;
        format!(
            "{formula}\n  {text}\n  {}\n  {}\n",
            typst(&tree),
            latex(&tree)
        )
    };
    insta::assert_snapshot!(FORMULAS.map(set).join("\n"));
}
