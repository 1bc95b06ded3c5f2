//! Integrals: of derivatives that the generator takes by itself, so that the integral is a difference of known values.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::seed::Stream;

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    match stream.below(3) {
        0 => polynomial(stream),
        1 => wave(stream, ""),
        _ => {
            let rate = stream.pick(&["2", "1", "-1", "1/2"]);
            wave(stream, rate)
        }
    }
}

fn declared(claim: Claim) -> Claim {
    claim
        .symbol("x", "{ in = '[0, 2]' }")
        .symbol("y", "{ in = '[0, 1]' }")
        .symbol("t", "{}")
}

/// `integral(f, t, a, b) == F(b) - F(a)`, with a slip half of the time: the factor before the right side is another one.
fn stated(stream: &mut Stream, integrand: &str, ends: [&str; 2], value: &str, slip: &str) -> Claim {
    let (right, truth) = match stream.once_in(2) {
        true => (value.to_owned(), Truth::Holds),
        false => {
            let right = format!("({value}) + {}*({slip})", stream.positive());
            (right, Truth::Fails("almost everywhere".to_owned()))
        }
    };
    let [low, high] = ends;
    let left = format!("integral({integrand}, t, {low}, {high})");
    declared(Claim::new(
        Kind::Integrals,
        States::Compare(left, "==", right),
        truth,
    ))
}

/// Of a polynomial in t whose coefficients are powers of x.
fn polynomial(stream: &mut Stream) -> Claim {
    let terms = 1 + stream.below(3);
    let (mut integrand, mut whole) = (vec![], vec![]);
    for _ in 0..terms {
        let (n, e) = (stream.integer(1, 5), stream.integer(0, 2));
        let c = stream.fraction();
        integrand.push(format!("{n}*({c})*x^{e}*t^{}", n - 1));
        whole.push((c, e, n));
    }
    let at = |place: &str| {
        let terms: Vec<String> = whole
            .iter()
            .map(|(c, e, n)| format!("({c})*x^{e}*({place})^{n}"))
            .collect();
        terms.join(" + ")
    };
    let [low, high] = stream.pick(&[["0", "1"], ["0", "y"], ["y", "x"], ["-1", "y"], ["x", "0"]]);
    let value = format!("{} - ({})", at(high), at(low));
    stated(
        stream,
        &integrand.join(" + "),
        [low, high],
        &value,
        "(x + 1)",
    )
}

/// Of the derivative of `t^j sin(n t)^a cos(n t)^b exp(k t)`, from 0 on.
fn wave(stream: &mut Stream, rate: &str) -> Claim {
    let n = stream.pick(&["1", "2", "1/2"]);
    let (j, a, b) = match rate {
        "" => (
            stream.integer(0, 2),
            stream.integer(0, 2),
            stream.integer(0, 2),
        ),
        _ => (
            stream.integer(0, 1),
            stream.integer(0, 1),
            stream.integer(0, 1),
        ),
    };
    let (s, c) = (format!("sin({n}*t)"), format!("cos({n}*t)"));
    let e = match rate {
        "" => "1".to_owned(),
        rate => format!("exp({rate}*t)"),
    };
    let mut parts = vec![];
    if j > 0 {
        parts.push(format!("{j}*t^{}*{s}^{a}*{c}^{b}*{e}", j - 1));
    }
    if a > 0 {
        let (up, down) = (b + 1, a - 1);
        parts.push(format!("{a}*({n})*t^{j}*{s}^{down}*{c}^{up}*{e}"));
    }
    if b > 0 {
        let (up, down) = (a + 1, b - 1);
        parts.push(format!("(-{b})*({n})*t^{j}*{s}^{up}*{c}^{down}*{e}"));
    }
    if !rate.is_empty() {
        parts.push(format!("({rate})*t^{j}*{s}^{a}*{c}^{b}*{e}"));
    }
    if parts.is_empty() {
        parts.push("0*t".to_owned());
    }
    let whole = |place: &str| {
        let put = |text: &str| text.replace("*t)", &format!("*({place}))"));
        format!("({place})^{j}*{}^{a}*{}^{b}*{}", put(&s), put(&c), put(&e))
    };
    // At 0 a sine is 0, and everything else 1.
    let first = match (j, a) {
        (0, 0) => "1",
        _ => "0",
    };
    let high = stream.pick(&["y", "x", "2*y"]);
    let value = format!("{} - {first}", whole(high));
    // At 0 all of it is exact.
    stated(stream, &parts.join(" + "), ["0", high], &value, "1")
}
