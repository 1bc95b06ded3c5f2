//! Formulas of the three papers as they are set.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

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

/// The number of children of each element of these names, as the text of well-formed MathML tells.
fn children(mathml: &str, names: &[&str]) -> Vec<(String, usize)> {
    let mut open: Vec<(String, usize)> = vec![];
    let mut counted = vec![];
    for tag in mathml.split('<').skip(1) {
        let inner = tag.split('>').next().unwrap();
        if let Some(name) = inner.strip_prefix('/') {
            let (opened, count) = open.pop().unwrap();
            assert_eq!(opened, name, "{mathml}");
            if names.contains(&name) {
                counted.push((opened, count));
            }
            continue;
        }
        if let Some((_, count)) = open.last_mut() {
            *count += 1;
        }
        let name = inner.split(' ').next().unwrap();
        if !inner.ends_with('/') && name != "wbr" {
            open.push((name.to_owned(), 0));
        }
    }
    counted
}

#[test]
fn scripts_and_fractions_of_mathml_have_their_parts_and_no_others() {
    let more = [
        "sin(x)^2 + cos(2*x)^2 == 1",
        "1/sin(x)^2 == sqrt(exp(x))/tan(x)",
    ];
    let wanted = [
        ("msup", 2),
        ("msub", 2),
        ("msubsup", 3),
        ("mfrac", 2),
        ("munder", 2),
        ("munderover", 3),
        ("mover", 2),
    ];
    let names = wanted.map(|(name, _)| name);
    let mut seen = 0;
    for formula in FORMULAS.iter().chain(&more) {
        for piece in Mathematics::read(formula).unwrap().mathml {
            for (name, count) in children(&piece, &names) {
                let (_, wanted) = wanted.iter().find(|(known, _)| **known == name).unwrap();
                assert_eq!(count, *wanted, "{name} in {piece}");
                seen += 1;
            }
        }
    }
    assert!(seen > 50, "{seen}");
}
