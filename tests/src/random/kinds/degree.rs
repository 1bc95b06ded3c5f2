//! Bases and sums of symbolic degree.
//!
//! The functions of a family with seeds s_0, ..., s_d and the step a, b are the coefficients of
//! `(a + b E)^(m-d) (s_0 + ... + s_d E^d)`; with `a + b = 1`, `a(0) = 1`, `b(1) = 1` what is needed follows from the product
//! rule.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::number::Q;
use crate::random::polynomial::Polynomial;
use crate::random::seed::Stream;

/// The Bernstein polynomials.
pub const BERNSTEIN: &str = "variable = 'x'\ndegree = 0\nseeds = ['1']\nstep = ['1 - x', 'x']";

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    match stream.below(4) {
        0 | 1 => bernstein(stream),
        2 => seeds(stream),
        _ => edges(stream),
    }
}

fn declared(claim: Claim, least: &str) -> Claim {
    claim
        .symbol("x", "{ in = '[0, 1]' }")
        .symbol("m", format!("{{ integer = '{least}' }}"))
        .symbol("P", "{ family = 1, indices = ['0..m'] }")
}

const CURVE: &str = "sum(i, 0, m, B[i,m](x)*P[i])";

/// `k left == l right` for classical identities of Bernstein polynomials.
fn bernstein(stream: &mut Stream) -> Claim {
    let (left, right) = stream.pick(&[
        ("sum(i, 0, m, B[i,m](x))", "1"),
        ("sum(i, 0, m, i*B[i,m](x))", "m*x"),
        ("sum(i, 0, m, i/m*B[i,m](x))", "x"),
        ("C'(x)", "m*sum(i, 0, m-1, B[i,m-1](x)*(P[i+1] - P[i]))"),
        (
            "C''(x)",
            "m*(m-1)*sum(i, 0, m-2, B[i,m-2](x)*(P[i+2] - 2*P[i+1] + P[i]))",
        ),
        (
            "C(x)",
            "sum(i, 0, m-1, B[i,m-1](x)*((1 - x)*P[i] + x*P[i+1]))",
        ),
        ("C(0)", "P[0]"),
        ("C(1)", "P[m]"),
        ("C'(0)", "m*(P[1] - P[0])"),
        ("C'(1)", "m*(P[m] - P[m-1])"),
        ("C''(0)", "m*(m-1)*(P[2] - 2*P[1] + P[0])"),
        ("C''(1)", "m*(m-1)*(P[m] - 2*P[m-1] + P[m-2])"),
        ("C(x)", "sum(i, 0, m, B[m-i,m](x)*P[m-i])"),
        ("C(1 - x)", "sum(i, 0, m, B[i,m](x)*P[m-i])"),
        ("sum(i, 0, m, binom(m, i)*(1 - x)^(m - i)*x^i*P[i])", "C(x)"),
        ("V(0)", "m*(P[1] - P[0])"),
        ("C(x)/sum(i, 0, m, B[i,m](x))", "C(x)"),
    ]);
    let k = stream.fraction();
    let (right, truth) = match stream.below(6) {
        0..3 => (right.to_owned(), Truth::Holds),
        3 => (
            format!("(m + 1)*({right})"),
            Truth::Fails("m = 3, all P[i] = x = 1 or P[i] = i^2".to_owned()),
        ),
        4 => (
            format!("(-1)*({right})"),
            Truth::Fails("m = 3, P[i] = 1 + i^2".to_owned()),
        ),
        _ => (
            format!("({right}) + {}*x", stream.positive()),
            Truth::Fails("x = 1".to_owned()),
        ),
    };
    let states = States::Compare(format!("({k})*{left}"), "==", format!("({k})*({right})"));
    let claim = Claim::new(Kind::Degree, states, truth)
        .letting("C(x)", CURVE)
        .letting("V(x)", format!("D({CURVE}, x)"))
        .basis("B", BERNSTEIN);
    declared(claim, ">= 3")
}

/// A family with random seeds: its sum, its ends, its slope at an end.
fn seeds(stream: &mut Stream) -> Claim {
    let names = ["x"];
    let count = 2 + stream.below(2);
    let seeds: Vec<Polynomial> = (0..count)
        .map(|_| Polynomial::some(stream, 1, 3, 2))
        .collect();
    let d = count - 1;
    let step = stream.pick(&[("1 - x", "x", 1), ("1 - x^2", "x^2", 0)]);
    let lines: Vec<String> = seeds
        .iter()
        .map(|s| format!("'{}'", s.text(stream, &names)))
        .collect();
    let table = format!(
        "variable = 'x'\ndegree = {d}\nseeds = [{}]\nstep = ['{}', '{}']",
        lines.join(", "),
        step.0,
        step.1
    );
    let end = |p: &Polynomial, x: i128| p.value(&[Q::int(x); 4]);
    let point = |list: Vec<(Q, String)>| {
        let terms: Vec<String> = list.iter().map(|(q, p)| format!("({q})*{p}")).collect();
        terms.join(" + ")
    };
    let curve = "sum(i, 0, m, g[i,m](x)*P[i])";
    let (left, right) = match stream.below(4) {
        0 => {
            let sum = seeds.iter().fold(Polynomial::default(), |a, b| &a + b);
            ("sum(i, 0, m, g[i,m](x))", sum.text(stream, &names))
        }
        1 => {
            let list = seeds.iter().enumerate();
            let list = list.map(|(i, s)| (end(s, 0), format!("P[{i}]"))).collect();
            ("G(0)", point(list))
        }
        2 => {
            let list = seeds.iter().enumerate();
            let list = list
                .map(|(i, s)| (end(s, 1), format!("P[m-{}]", d - i)))
                .collect();
            ("G(1)", point(list))
        }
        _ => {
            // (m - d) b'(0) (E - 1) sum s_i(0) E^i + sum s_i'(0) E^i
            let slope = seeds.iter().map(|s| s.derivative(0)).collect::<Vec<_>>();
            let list = slope.iter().enumerate();
            let list = list.map(|(i, s)| (end(s, 0), format!("P[{i}]"))).collect();
            let differences: Vec<(Q, String)> = seeds
                .iter()
                .enumerate()
                .map(|(i, s)| {
                    (
                        end(s, 0) * Q::int(step.2),
                        format!("(P[{}] - P[{i}])", i + 1),
                    )
                })
                .collect();
            (
                "G'(0)",
                format!("(m - {d})*({}) + {}", point(differences), point(list)),
            )
        }
    };
    let (right, truth) = match stream.once_in(2) {
        false => (right, Truth::Holds),
        true => (
            format!("{right} + {}*P[0]", stream.fraction()),
            Truth::Fails("P[0] large".to_owned()),
        ),
    };
    let states = States::Compare(left.to_owned(), "==", right);
    let claim = Claim::new(Kind::Degree, states, truth)
        .letting("G(x)", curve)
        .basis("g", table);
    declared(claim, ">= 4")
}

/// Degrees below the seeds, indices in arguments, replaced degrees: where rules for all degrees end.
fn edges(stream: &mut Stream) -> Claim {
    let less = stream.integer(1, 4);
    let least = stream.integer(1, 4);
    let k = stream.positive();
    let sum = format!("({k})*sum(i, 0, m-{less}, B[i,m-{less}](x))");
    let empty = match least < less {
        true => Truth::Fails(format!("m = {least}, an empty sum")),
        false => Truth::Holds,
    };
    let (left, right, truth, range) = match stream.below(6) {
        0 | 1 => (sum, format!("{k}"), empty, format!(">= {least}")),
        2 => (
            sum,
            format!("{k}"),
            empty,
            format!("{least}..{}", least + 3),
        ),
        3 => (
            format!("sum(i, 0, m, B[i,m](i*x/{less}))"),
            "1".to_owned(),
            Truth::Fails("m = 2, x = 1/3".to_owned()),
            format!(">= {}", least.min(2)),
        ),
        4 => {
            let value = 4 + less;
            let (right, truth) = match stream.once_in(2) {
                true => (format!("{value}*P[{value}]"), Truth::Holds),
                false => (
                    format!("{value}*P[m]"),
                    Truth::Fails(format!("m = {}", value + 1)),
                ),
            };
            (
                format!("at(m*P[m], m, {value})"),
                right,
                truth,
                format!(">= {value}"),
            )
        }
        _ => (
            "sum(i, 0, m, B[i,m](x)*P[m-i])".to_owned(),
            CURVE.to_owned(),
            Truth::Fails("m = 1, x = 0, P[0] = 0, P[1] = 1".to_owned()),
            format!(">= {least}"),
        ),
    };
    let states = States::Compare(left, "==", right);
    let claim = Claim::new(Kind::Degree, states, truth).basis("B", BERNSTEIN);
    declared(claim, &range)
}
