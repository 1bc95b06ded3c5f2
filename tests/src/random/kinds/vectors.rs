//! Vectors and matrices: the classical identities with random factors.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::seed::Stream;

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    match stream.below(5) {
        0 | 1 => identity(stream),
        2 => bilinear(stream),
        3 => numbers(stream),
        _ => matrices(stream),
    }
}

const POINT: &str = "p = [1, 0, 0], q = [0, 1, 0], r = [1, 2, 1]";

fn with_vectors(states: States, truth: Truth) -> Claim {
    ["p", "q", "r"]
        .iter()
        .fold(Claim::new(Kind::Vectors, states, truth), |claim, name| {
            claim.symbol(name, "{ vector = 3 }")
        })
}

/// `k left == k' right` for a classical identity whose sides do not vanish at [`POINT`].
fn identity(stream: &mut Stream) -> Claim {
    let (left, right) = stream.pick(&[
        ("det([p, q, r])", "dot(p, cross(q, r))"),
        ("cross(p, q)", "-cross(q, p)"),
        ("cross(p, cross(q, r))", "(dot(p, r)*q - dot(p, q)*r)"),
        (
            "dot(cross(p, q), cross(r, q))",
            "(dot(p, r)*dot(q, q) - dot(p, q)*dot(q, r))",
        ),
        (
            "dot(cross(p, q), cross(p, q))",
            "(dot(p, p)*dot(q, q) - dot(p, q)^2)",
        ),
        ("dot(p + q, p + q)", "(dot(p, p) + 2*dot(p, q) + dot(q, q))"),
        ("det([p, q, r])", "-det([q, p, r])"),
        ("det([p, q, r])^2", "det([p, q, r]*transpose([p, q, r]))"),
        (
            "cross(p, q)",
            "[p[2]*q[3] - p[3]*q[2], p[3]*q[1] - p[1]*q[3], p[1]*q[2] - p[2]*q[1]]",
        ),
        ("cross(cross(p, q), cross(q, r))", "(det([p, q, r])*q)"),
    ]);
    let k = stream.fraction();
    let mut other = k;
    while stream.once_in(2) && other == k {
        other = stream.fraction();
    }
    let truth = match other == k {
        true => Truth::Holds,
        false => Truth::Fails(POINT.to_owned()),
    };
    let states = States::Compare(format!("({k})*{left}"), "==", format!("({other})*{right}"));
    with_vectors(states, truth)
}

/// Random combinations in a product that is linear in both.
fn bilinear(stream: &mut Stream) -> Claim {
    let [a, b, c, d] = [(); 4].map(|()| stream.nonzero(5));
    let slip = if stream.once_in(2) {
        stream.nonzero(3)
    } else {
        0
    };
    let truth = match slip {
        0 => Truth::Holds,
        _ => Truth::Fails(POINT.to_owned()),
    };
    let (left, right) = match stream.below(3) {
        0 => (
            format!("cross(({a})*p + ({b})*q, ({c})*p + ({d})*q)"),
            format!("({})*cross(p, q)", a * d - b * c + slip),
        ),
        1 => (
            format!("dot(({a})*p + ({b})*q, ({c})*p + ({d})*q)"),
            format!(
                "({})*dot(p, p) + ({})*dot(q, p) + ({})*dot(q, q)",
                a * c + slip,
                a * d + b * c,
                b * d
            ),
        ),
        _ => (
            format!("det([({a})*p + ({b})*q, ({c})*p + ({d})*q, r + ({b})*p])"),
            format!("({})*det([p, q, r])", a * d - b * c + slip),
        ),
    };
    with_vectors(States::Compare(left, "==", right), truth)
}

/// Vectors of numbers, and lengths.
fn numbers(stream: &mut Stream) -> Claim {
    let [a, b, c, d, e, f] = [(); 6].map(|()| stream.integer(-6, 6));
    let slip = if stream.once_in(2) {
        stream.nonzero(4)
    } else {
        0
    };
    let truth = match slip {
        0 => Truth::Holds,
        _ => Truth::Fails("everywhere".to_owned()),
    };
    let (left, right) = match stream.below(3) {
        0 => (
            format!("dot([{a}, {b}, {c}], [{d}, {e}, {f}])"),
            format!("{}", a * d + b * e + c * f + slip),
        ),
        1 => (
            format!("cross([{a}, {b}, {c}], [{d}, {e}, {f}])"),
            format!(
                "[{}, {}, {}]",
                b * f - c * e,
                c * d - a * f + slip,
                a * e - b * d
            ),
        ),
        _ => (
            format!("norm([{a}, {b}, {c}])^2"),
            format!("{}", a * a + b * b + c * c + slip),
        ),
    };
    let claim = Claim::new(Kind::Vectors, States::Compare(left, "==", right), truth);
    claim.symbol("p", "{ vector = 3 }")
}

/// Two by two matrices of a symbol and numbers.
fn matrices(stream: &mut Stream) -> Claim {
    let [a, b, c] = [(); 3].map(|()| stream.nonzero(5));
    let slip = if stream.once_in(2) {
        stream.nonzero(3)
    } else {
        0
    };
    let fails = |truth| match slip {
        0 => truth,
        _ => Truth::Fails("almost everywhere".to_owned()),
    };
    let matrix = format!("[[y, {a}], [{b}, {c}]]");
    // det = c y - a b, which vanishes at y = a b/c.
    let (left, right, truth) = match stream.below(4) {
        0 => (
            format!("det({matrix})"),
            format!("{}*y - {}", c + slip, a * b),
            fails(Truth::Holds),
        ),
        1 => (
            format!("inverse({matrix})*{matrix}"),
            format!("[[1, 0], [{slip}, 1]]"),
            fails(Truth::Conditional),
        ),
        2 => (
            format!("solve({matrix}, [{}*y + {}, {}])", 2, 3 * a, 2 * b + 3 * c),
            format!("[2, {}]", 3 + slip),
            fails(Truth::Conditional),
        ),
        _ => (
            format!("transpose({matrix})*[1, y]"),
            format!("[y + {b}*y, {} + {c}*y]", a + slip),
            fails(Truth::Holds),
        ),
    };
    let right = right.replace("- -", "+ ").replace("+ -", "- ");
    let states = States::Compare(left, "==", right);
    Claim::new(Kind::Vectors, states, truth).symbol("y", "{}")
}
