//! Derived formulas against classical ones, against the papers, and against derivatives of the curves
//! themselves in numbers.

use std::path::Path;
use std::sync::Arc;
use torse_algebra::{Affine, Fraction, Jet, Polynomial, Scalar, Symbol};
use torse_prove::evaluate::Evaluator;
use torse_syntax::derivation::declarations::Declarations;
use torse_syntax::derivation::load;
use torse_syntax::formula::{Expr, parse};
use torse_verdicts::derive::{
    Derivation, DeriveError, Geometric, Language, Shape, continuity, end_derivatives, geometric,
    print,
};

mod c3 {
    include!("../derived/c3.rs");
}
mod beta {
    include!("../derived/beta.rs");
}
mod ends {
    include!("../derived/ends.rs");
}

/// Bernstein `b` and GBT `g` with their symbols.
fn declarations() -> Arc<Declarations> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/papers");
    load(&folder).unwrap().remove(0).declarations
}

fn value(evaluator: &Evaluator<'_>, formula: &Expr) -> Fraction {
    let value = evaluator.evaluate(formula).unwrap();
    value
        .entries()
        .first()
        .and_then(|q| q.as_fraction())
        .unwrap()
        .clone()
}

/// The values of the results, abbreviations put in.
fn results(declarations: &Declarations, derivation: &Derivation) -> Vec<Fraction> {
    let abbreviations = derivation
        .lines
        .iter()
        .filter(|line| line.is_abbreviation());
    let mut declarations = declarations.clone();
    for line in abbreviations {
        declarations.declare_number(line.left.names().concat());
    }
    let mut evaluator = Evaluator::new(&declarations);
    let mut all = vec![];
    for line in &derivation.lines {
        let value = value(&evaluator, &line.right);
        if line.is_abbreviation() {
            evaluator.fix(line.left.names().concat(), value);
        } else {
            all.push(value);
        }
    }
    all
}

fn point(index: Affine) -> Fraction {
    Fraction::symbol(Symbol::indexed("R", vec![index]))
}

#[test]
fn end_derivatives_of_bernstein_curves_are_falling_factorials_times_differences() {
    let declarations = declarations();
    let derivation = end_derivatives(&declarations, "b", 5, Shape::default()).unwrap();
    let derived = results(&declarations, &derivation);
    let mut expected = vec![];
    for last in [false, true] {
        for n in 0..=5i64 {
            let falling = (0..n).fold(Polynomial::integer(1), |product, i| {
                &product * &(&Polynomial::named("k") - &Polynomial::integer(i))
            });
            // Delta^n R_0 = sum of (-1)^(n-i) binom(n, i) R_i, and backwards at the end.
            let mut binomial = 1;
            let mut sum = Fraction::zero();
            for i in 0..=n {
                let (index, sign) = if last {
                    (Affine::symbol("k") - Affine::number(i), i)
                } else {
                    (Affine::number(i), n - i)
                };
                let sign = if sign % 2 == 0 { 1 } else { -1 };
                sum = sum + Fraction::integer(sign * binomial) * point(index);
                binomial = binomial * (n - i) / (i + 1);
            }
            expected.push(Fraction::from(falling) * sum);
        }
    }
    assert_eq!(derived, expected);
}

#[test]
fn end_derivatives_of_gbt_curves_are_those_of_the_paper() {
    // gbt-developable eq. (3.11) and (3.12).
    let printed = [
        "R[0]",
        "1/2*(2*(k - 2) + pi*(1 + mu))*(R[1] - R[0])",
        "1/4*(4*(k - 2)*(k - 3 + pi*(1 + mu))*(R[0] - 2*R[1] + R[2]) + 2*pi^2*mu*(R[0] - R[1]) - pi^2*(1 - nu)*(R[1] - R[2]))",
        "R[k]",
        "1/2*(2*(k - 2) + pi*(1 + nu))*(R[k] - R[k-1])",
        "1/4*(4*(k - 2)*(k - 3 + pi*(1 + nu))*(R[k-2] - 2*R[k-1] + R[k]) + pi^2*(1 - mu)*(R[k-2] - R[k-1]) - 2*pi^2*nu*(R[k-1] - R[k]))",
    ];
    let declarations = declarations();
    let derived = results(
        &declarations,
        &end_derivatives(&declarations, "g", 2, Shape::default()).unwrap(),
    );
    let evaluator = Evaluator::new(&declarations);
    let printed: Vec<Fraction> = printed
        .iter()
        .map(|p| value(&evaluator, &parse(p).unwrap()))
        .collect();
    assert_eq!(derived, printed);
}

#[test]
fn the_code_that_is_compiled_here_is_the_code_that_is_printed() {
    let declarations = declarations();
    let c3 = continuity(&declarations, "g", 3, Shape::default()).unwrap();
    let beta = geometric(&declarations, "g", Geometric::Beta, Shape::default()).unwrap();
    let ends = end_derivatives(&declarations, "g", 3, Shape::default()).unwrap();
    assert_eq!(print(&c3, Language::Rust), include_str!("../derived/c3.rs"));
    assert_eq!(
        print(&beta, Language::Rust),
        include_str!("../derived/beta.rs")
    );
    assert_eq!(
        print(&ends, Language::Rust),
        include_str!("../derived/ends.rs")
    );
}

/// Derivatives 0 to 3 at x of a GBT curve, from the recursion of the basis in Taylor series.
fn derivatives(points: &[f64], mu: f64, nu: f64, x: f64) -> Vec<f64> {
    let x = Jet::variable(x, 3);
    let one = x.one_like();
    let number = |v: f64| x.constant_like(v);
    let (sine, cosine) = x.quarter_turn().unwrap();
    let first = (one.clone() - sine.clone()) * (one.clone() - number(mu) * sine);
    let last = (one.clone() - cosine.clone()) * (one.clone() - number(nu) * cosine);
    let mut row = vec![first.clone(), one.clone() - first - last.clone(), last];
    while row.len() < points.len() {
        let zero = number(0.0);
        let same = row.iter().chain(std::iter::once(&zero));
        let before = std::iter::once(&zero).chain(&row);
        row = same
            .zip(before)
            .map(|(a, b)| (one.clone() - x.clone()) * a.clone() + x.clone() * b.clone())
            .collect();
    }
    let terms = row.iter().zip(points).map(|(f, p)| f.clone() * number(*p));
    let curve = terms.reduce(|a, b| a + b).unwrap();
    (0..=3).map(|n| curve.derivative(n).unwrap()).collect()
}

/// Points without any pattern.
fn points(count: usize, seed: u32) -> Vec<f64> {
    let mut state = seed;
    let mut next = || {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(state >> 8) / f64::from(1 << 24)
    };
    (0..count).map(|_| next()).collect()
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * (1.0 + a.abs() + b.abs())
}

/// The last points of a curve, the very last first.
fn last<const N: usize>(points: &[f64]) -> [f64; N] {
    let reversed: Vec<f64> = points.iter().rev().copied().take(N).collect();
    reversed.try_into().unwrap()
}

/// Degrees m and n with points of the first curve.
fn cases() -> impl Iterator<Item = (u32, u32, Vec<f64>)> {
    (3..=6).flat_map(|m| (3..=6).map(move |n| (m, n, points(m as usize + 1, 17 * m + n))))
}

const SHAPE: [f64; 4] = [0.3, -0.7, 0.55, 0.2];

/// The second curve: the given next points, then others.
fn continued(next: &[f64], n: u32) -> Vec<f64> {
    let mut all = next.to_vec();
    all.extend(points(n as usize + 1 - next.len(), 99));
    all
}

#[test]
fn c3_joins_agree_in_all_derivatives_up_to_the_third() {
    let [mu, nu, mu1, nu1] = SHAPE;
    for (m, n, q) in cases() {
        let next = c3::next_points(f64::from(m), f64::from(n), mu, nu, mu1, nu1, last(&q));
        let before = derivatives(&q, mu, nu, 1.0);
        let after = derivatives(&continued(&next, n), mu1, nu1, 0.0);
        let equal = before.iter().zip(&after).all(|(a, b)| close(*a, *b));
        assert!(equal, "m = {m}, n = {n}: {before:?} {after:?}");
    }
}

#[test]
fn beta_joins_satisfy_the_beta_constraints() {
    let [mu, nu, mu1, nu1] = SHAPE;
    let (gamma, lambda) = (1.75, -0.4);
    for (m, n, q) in cases() {
        let (first, second) = (f64::from(m), f64::from(n));
        let next = beta::next_points(first, second, mu, nu, mu1, nu1, gamma, lambda, last(&q));
        let [f, f1, f2, _] = derivatives(&q, mu, nu, 1.0)[..] else {
            panic!("four derivatives")
        };
        let after = derivatives(&continued(&next, n), mu1, nu1, 0.0);
        let wanted = [f, gamma * f1, gamma * gamma * f2 + lambda * f1];
        assert!(
            wanted.iter().zip(&after).all(|(a, b)| close(*a, *b)),
            "m = {m}, n = {n}"
        );
    }
}

#[test]
fn end_derivatives_in_numbers_are_those_of_the_curve() {
    let [mu, nu, ..] = SHAPE;
    for (k, _, r) in cases() {
        let [a, b, c, d] = r[..4] else {
            panic!("four points")
        };
        let [e, f, g, h] = last(&r);
        let derived = ends::end_derivatives(f64::from(k), mu, nu, [a, b, c, d, e, f, g, h]);
        let mut curve = derivatives(&r, mu, nu, 0.0);
        curve.extend(derivatives(&r, mu, nu, 1.0));
        assert!(
            derived.iter().zip(&curve).all(|(a, b)| close(*a, *b)),
            "k = {k}"
        );
    }
}

#[test]
fn farin_boehm_joins_are_c2_joins_of_the_homogeneous_coordinates() {
    let declarations = declarations();
    let geometric = geometric(&declarations, "g", Geometric::FarinBoehm, Shape::default()).unwrap();
    assert_eq!(
        geometric.lines,
        continuity(&declarations, "g", 2, Shape::default())
            .unwrap()
            .lines
    );
}

#[test]
fn a_join_of_bernstein_curves_is_written_in_five_languages() {
    let declarations = declarations();
    let c1 = continuity(&declarations, "b", 1, Shape::default()).unwrap();
    let title = "C1 join of two curves of the family b, degrees m and n";
    assert_eq!(
        print(&c1, Language::Text),
        format!(
            "# {title}\nQ1[0] = Q[m]\nQ1[1] = Q[m] + m/n*(Q[m] - Q[m-1])\n# where m >= 1, n >= 1\n"
        )
    );
    assert_eq!(
        print(&c1, Language::Latex),
        format!(
            "% {title}\n\\begin{{align*}}\n  Q_{{1, 0}} &= Q_m \\\\\n  Q_{{1, 1}} &= Q_m + \\frac{{m}}{{n}} (Q_m - Q_{{m - 1}})\n\\end{{align*}}\nwhere $m \\ge 1$, $n \\ge 1$.\n"
        )
    );
    assert_eq!(
        print(&c1, Language::Typst),
        format!(
            "// {title}\n$\n  Q_(1 comma 0) &= Q_m \\\n  Q_(1 comma 1) &= Q_m + frac(m, n) (Q_m − Q_(m − 1))\n$\nwhere $m ≥ 1$, $n ≥ 1$.\n"
        )
    );
    let sympy = print(&c1, Language::Sympy);
    assert!(
        sympy.starts_with(&format!(
            "\"\"\"{title}.\"\"\"\n\nfrom sympy import Ge, symbols\n"
        )),
        "{sympy}"
    );
    assert!(
        sympy.contains("\nQ1_1 = Q_m + m/n*(Q_m - Q_m_1)\n"),
        "{sympy}"
    );
    let rust = print(&c1, Language::Rust);
    assert!(
        rust.contains("\n    let Q1_1 = Q_m + m / n * (Q_m - Q_m_1);\n"),
        "{rust}"
    );
}

#[test]
fn divisors_that_can_vanish_are_conditions() {
    let declarations = declarations();
    let c1 = continuity(&declarations, "g", 1, Shape::default()).unwrap();
    assert!(
        print(&c1, Language::Text)
            .ends_with("# where m >= 2, n >= 2, 2*(n - 2) + pi*(1 + mu1) != 0\n")
    );
}

#[test]
fn unknown_families_and_orders_are_refused() {
    let declarations = declarations();
    assert!(matches!(
        end_derivatives(&declarations, "h", 2, Shape::default()),
        Err(DeriveError::UnknownBasis { .. })
    ));
    assert!(matches!(
        end_derivatives(&declarations, "b", 0, Shape::default()),
        Err(DeriveError::Order { order: 0, .. })
    ));
    assert!(matches!(
        continuity(&declarations, "b", 4, Shape::default()),
        Err(DeriveError::Order { order: 4, most: 3 })
    ));
}

/// Of a worked example.
fn example(name: &str, basis: &str) -> Arc<Declarations> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../derivations");
    let papers = load(&folder).unwrap();
    let paper = papers.into_iter().find(|p| p.head.id == name).unwrap();
    let mut claims = paper.claims.iter();
    let claim = claims.find(|c| c.declarations.basis(basis).is_some());
    Arc::clone(&claim.unwrap().declarations)
}

fn text(derivation: &Derivation) -> Vec<String> {
    let lines = derivation.lines.iter();
    lines
        .map(|line| torse_syntax::notation::text(&line.formula()))
        .collect()
}

#[test]
fn a_uniform_spline_is_joined_by_taking_its_points_over() {
    let declarations = example("splines", "U");
    let cubic = Shape {
        degree: Some(3),
        rational: false,
    };
    let ends = end_derivatives(&declarations, "U", 2, cubic).unwrap();
    let ends = text(&ends);
    assert_eq!(ends[0], "G(0) == 1/6*(R[0] + 4*R[1] + R[2])");
    assert_eq!(ends[1], "G'(0) == 1/2*(R[2] - R[0])");
    let join = continuity(&declarations, "U", 2, cubic).unwrap();
    assert_eq!(
        text(&join),
        ["Q1[0] == Q[1]", "Q1[1] == Q[2]", "Q1[2] == Q[3]"]
    );
    assert!(join.conditions.is_empty() && join.degrees.is_empty());
    // Of lower order a point of the second curve is free.
    let join = continuity(&declarations, "U", 1, cubic).unwrap();
    assert!(
        join.points
            .iter()
            .any(|p| torse_syntax::notation::text(p) == "Q1[2]")
    );
    let open = continuity(&declarations, "U", 2, Shape::default());
    assert!(
        matches!(open, Err(DeriveError::NeedsDegree { .. })),
        "{open:?}"
    );
}

#[test]
fn a_number_as_degree_gives_what_the_symbol_gives() {
    let declarations = declarations();
    let cubic = Shape {
        degree: Some(3),
        rational: false,
    };
    let join = continuity(&declarations, "b", 2, cubic).unwrap();
    assert_eq!(
        text(&join),
        [
            "Q1[0] == Q[3]",
            "Q1[1] == 2*Q[3] - Q[2]",
            "Q1[2] == Q[1] + 4*(Q[3] - Q[2])",
        ]
    );
    let low = Shape {
        degree: Some(99),
        rational: false,
    };
    assert!(matches!(
        continuity(&declarations, "b", 2, low),
        Err(DeriveError::Degree { .. })
    ));
}

#[test]
fn a_rational_curve_has_the_classical_tangent_at_its_start() {
    let declarations = declarations();
    let rational = Shape {
        degree: None,
        rational: true,
    };
    let ends = end_derivatives(&declarations, "b", 1, rational).unwrap();
    let lines = text(&ends);
    assert_eq!(lines[0], "G(0) == R[0]");
    assert_eq!(lines[1], "G'(0) == -k*w[1]*(R[0] - R[1])/w[0]");
    let join = continuity(&declarations, "b", 1, rational).unwrap();
    let lines = text(&join);
    assert_eq!(lines[0], "Q1[0] == Q[m]");
    let names: Vec<String> = join
        .points
        .iter()
        .map(torse_syntax::notation::text)
        .collect();
    assert!(
        names.contains(&"w1[1]".to_owned()) && names.contains(&"w[m-1]".to_owned()),
        "{names:?}"
    );
    assert!(!join.conditions.is_empty());
}

#[test]
fn a_list_of_functions_has_its_own_degree() {
    let declarations = example("bezier", "T");
    let papers = load(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../derivations")).unwrap();
    let bezier = papers.iter().find(|p| p.head.id == "bezier").unwrap();
    let mut lists = bezier
        .claims
        .iter()
        .filter(|c| c.declarations.basis("T").is_some_and(|b| b.is_list));
    let list = &lists.next().unwrap().declarations;
    let ends = end_derivatives(list, "T", 1, Shape::default()).unwrap();
    assert_eq!(text(&ends)[1], "G'(0) == (v - 2)*(R[0] - R[1])");
    let cubic = Shape {
        degree: Some(3),
        rational: false,
    };
    assert!(matches!(
        end_derivatives(list, "T", 1, cubic),
        Err(DeriveError::OneDegree { degree: 2 })
    ));
    assert!(end_derivatives(&declarations, "T", 1, Shape::default()).is_ok());
}
