//! Symbolic powers, sums and products of symbolic length over no basis, families by a formula in their index.

use super::degree::BERNSTEIN;
use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::seed::Stream;

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    let (left, right, slip) = match stream.below(5) {
        0 => power(stream),
        1 => sum(stream),
        2 => product(stream),
        3 => swap(stream),
        _ => family(stream),
    };
    let (right, truth) = match stream.once_in(2) {
        true => (right, Truth::Holds),
        false => (
            slip,
            Truth::Fails("at small m and simple numbers".to_owned()),
        ),
    };
    let least = stream.pick(&["1", "2", "3"]);
    let (k, l) = (stream.fraction(), stream.positive());
    Claim::new(Kind::Powers, States::Compare(left, "==", right), truth)
        .symbol("x", "{ in = '[0, 1]' }")
        .symbol("y", "{}")
        .symbol("m", format!("{{ integer = '>= {least}' }}"))
        .symbol("j", "{ integer = '0..m' }")
        .symbol("l", "{ integer = '0..m' }")
        .symbol("P", "{ family = 1, indices = ['0..m+1'] }")
        .basis("B", BERNSTEIN)
        .letting("Q[j]", format!("({k})*P[j] + {l}*P[j+1]"))
        .letting("K", k.to_string())
        .letting("L", l.to_string())
}

type ConditionCheck = (String, String, String);

fn base(stream: &mut Stream) -> String {
    let k = stream.positive();
    stream.pick(&[
        "(1 - x)".to_owned(),
        "x".to_owned(),
        format!("(x + {k})"),
        "y".to_owned(),
        format!("({k}*x + y)"),
        format!("(y^2 + {k})"),
    ])
}

fn power(stream: &mut Stream) -> ConditionCheck {
    let b = base(stream);
    let (i, k) = (stream.integer(1, 3), stream.integer(0, 2));
    match stream.below(5) {
        0 => (
            format!("{b}^(m + {k})*{b}^{i}"),
            format!("{b}^(m + {})", k + i),
            format!("{b}^(m + {}) + {i}", k + i + 1),
        ),
        1 => {
            let c = stream.pick(&["x", "(1 - x)", "(x + 2)", "3"]);
            (
                format!("({b}*{c})^(m + {k})"),
                format!("{c}^(m + {k})*{b}^(m + {k})"),
                format!("{c}^(m + {k})*{b}^(m + {k}) + {i}*x"),
            )
        }
        2 => {
            let c = stream.pick(&["x", "(1 - x)", "(x + 2)", "(3*x + 1)"]);
            let rate = match c {
                "(1 - x)" => "(-1)",
                "(3*x + 1)" => "3",
                _ => "1",
            };
            (
                format!("D({c}^(m + {k}), x)"),
                format!("(m + {k})*{rate}*{c}^(m + {k} - 1)"),
                format!("(m + {})*{rate}*{c}^(m + {k} - 1)", k + i),
            )
        }
        3 => (
            format!("({b}^m)^2*{b}^{k}"),
            format!("{b}^(2*m + {k})"),
            format!("{b}^(2*m + {k}) - {i}"),
        ),
        _ => (
            format!("sum(i, 0, m, binom(m, i)*{b}^(m - i)*{i}^i)"),
            format!("({b} + {i})^m"),
            format!("({b} + {i})^m + {i}"),
        ),
    }
}

fn sum(stream: &mut Stream) -> ConditionCheck {
    let (a, b, c) = (stream.fraction(), stream.fraction(), stream.positive());
    let low = stream.integer(0, 1);
    let right = format!(
        "({a})*m*(m + 1)*(2*m + 1)/6 + ({b})*m*(m + 1)/2 + {c}*(m + {})",
        1 - low
    );
    (
        format!("sum(j, {low}, m, ({a})*j^2 + ({b})*j + {c})"),
        right.clone(),
        format!("{right} + {c}*m"),
    )
}

fn product(stream: &mut Stream) -> ConditionCheck {
    let k = stream.integer(1, 4);
    match stream.below(3) {
        0 => (
            format!("product(j, 1, m, (j + {k})/(j + {}))", k - 1),
            format!("(m + {k})/{k}"),
            format!("(m + {})/{k}", k + 1),
        ),
        1 => (
            format!("product(j, 1, m, (j + {k})/(j + {}))", k + 2),
            format!("{}*{}/((m + {})*(m + {}))", k + 1, k + 2, k + 1, k + 2),
            format!("{}*{}/((m + {})*(m + {k}))", k + 1, k + 2, k + 1),
        ),
        _ => (
            format!("product(j, 1, 3, y + {k}*j)"),
            format!("y^3 + {}*y^2 + {}*y + {}", 6 * k, 11 * k * k, 6 * k * k * k),
            format!(
                "y^3 + {}*y^2 + {}*y + {}",
                6 * k,
                11 * k * k,
                6 * k * k * k + 1
            ),
        ),
    }
}

fn swap(stream: &mut Stream) -> ConditionCheck {
    let (a, b) = (stream.positive(), stream.fraction());
    match stream.once_in(2) {
        true => (
            format!("sum(j, 0, m, sum(l, 0, j, ({a}*l + ({b}))*P[l]))"),
            format!("sum(j, 0, m, (m + 1 - j)*({a}*j + ({b}))*P[j])"),
            format!("sum(j, 0, m, (m + 1 - j)*({a}*j + ({b}) + 1)*P[j])"),
        ),
        false => (
            format!("sum(j, 0, m, sum(l, 0, j, {a}*j*P[l]))"),
            format!("sum(j, 0, m, {a}*(m*(m + 1)/2 - j*(j - 1)/2)*P[j])"),
            format!("sum(j, 0, m, {a}*(m*(m + 1)/2 - j*(j + 1)/2)*P[j])"),
        ),
    }
}

fn family(stream: &mut Stream) -> ConditionCheck {
    let n = stream.positive();
    (
        format!("{n}*sum(j, 0, m, B[j,m](x)*Q[j])"),
        format!("{n}*K*sum(j, 0, m, B[j,m](x)*P[j]) + {n}*L*sum(j, 0, m, B[j,m](x)*P[j+1])"),
        format!("{n}*K*sum(j, 0, m, B[j,m](x)*P[j]) + {n}*(L + 1)*sum(j, 0, m, B[j,m](x)*P[j+1])"),
    )
}
