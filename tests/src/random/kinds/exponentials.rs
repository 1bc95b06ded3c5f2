//! Exponentials and hyperbolic functions of parts and multiples of one exponent: powers of `cosh + sinh`, products as
//! sums, tangents, derivatives, bounds on intervals, and order by ordered exponents.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::number::Q;
use crate::random::polynomial::{Polynomial, SLOTS};
use crate::random::seed::Stream;

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    match stream.below(7) {
        0 | 1 => power(stream),
        2 => product(stream),
        3 => tangent(stream),
        4 => rate(stream),
        5 => bound(stream),
        _ => order(stream),
    }
}

/// A multiple of a formula.
fn times(q: Q, whole: &str) -> String {
    match (q.above, q.below) {
        (1, 1) => whole.to_owned(),
        (above, 1) => format!("{above}*{whole}"),
        (1, below) => format!("{whole}/{below}"),
        (above, below) => format!("{above}*{whole}/{below}"),
    }
}

/// A part of the exponent: `1/2`, `3/4` and so on.
fn part(stream: &mut Stream) -> Q {
    Q::new(stream.integer(1, 4), stream.integer(1, 4))
}

/// The exponent: a variable, or a parameter times one.
fn exponent(stream: &mut Stream) -> &'static str {
    stream.pick(&["v", "v", "s*v"])
}

/// With its symbols.
fn declared(stream: &mut Stream, claim: Claim) -> Claim {
    let domain = stream.pick(&["{}", "{ in = '[0, inf)' }", "{ in = '[-1, 2]' }"]);
    claim.symbol("v", domain).symbol("s", "{}")
}

/// `sinh(n a)` or `cosh(n a)` by the powers of `cosh a + sinh a`.
fn power(stream: &mut Stream) -> Claim {
    let (unit, exponent) = (part(stream), exponent(stream));
    let multiple = stream.integer(2, 4);
    let (sine, cosine) = (Polynomial::variable(0), Polynomial::variable(1));
    let (mut even, mut odd) = (Polynomial::number(Q::ONE), Polynomial::default());
    for _ in 0..multiple {
        let next = &(&even * &cosine) + &(&odd * &sine);
        odd = &(&even * &sine) + &(&odd * &cosine);
        even = next;
    }
    let (function, form) = match stream.once_in(2) {
        true => ("sinh", odd),
        false => ("cosh", even),
    };
    let (mut truth, mut printed) = (Truth::Holds, form.clone());
    if stream.once_in(2) {
        printed = form.slipped(stream);
        let difference = &form - &printed;
        // Rational points of the hyperbola: (2u/(1 - u^2), (1 + u^2)/(1 - u^2)) with small u.
        let vanishes = (2..14).all(|d| {
            let u = Q::new(1, d);
            let below = Q::ONE - u * u;
            let mut point = [Q::ONE; SLOTS];
            point[0] = (Q::int(2) * u).over(below);
            point[1] = (Q::ONE + u * u).over(below);
            difference.value(&point) == Q::ZERO
        });
        if !vanishes {
            truth = Truth::Fails("almost everywhere".to_owned());
        }
    }
    let names = ["sinh", "cosh"].map(|f| format!("{f}({})", times(unit, exponent)));
    let names = [names[0].as_str(), names[1].as_str()];
    let left = format!("{function}({})", times(unit * Q::int(multiple), exponent));
    let states = States::Compare(left, "==", printed.text(stream, &names));
    declared(stream, Claim::new(Kind::Exponentials, states, truth))
}

/// Products of two parts as sums.
fn product(stream: &mut Stream) -> Claim {
    let exponent = exponent(stream);
    let small = part(stream);
    let large = small + part(stream);
    let [sum, difference] = [large + small, large - small].map(|q| times(q, exponent));
    let [large, small] = [large, small].map(|q| times(q, exponent));
    let (left, first, sign) = match stream.below(3) {
        0 => (["sinh", "cosh"], "sinh", "+"),
        1 => (["cosh", "cosh"], "cosh", "+"),
        _ => (["sinh", "sinh"], "cosh", "-"),
    };
    let (mut truth, mut sign, mut half) = (Truth::Holds, sign, "2");
    if stream.once_in(2) {
        truth = Truth::Fails("almost everywhere".to_owned());
        match stream.once_in(2) {
            true => half = "3",
            false => sign = if sign == "+" { "-" } else { "+" },
        }
    }
    let states = States::Compare(
        format!("{}({large})*{}({small})", left[0], left[1]),
        "==",
        format!("({first}({sum}) {sign} {first}({difference}))/{half}"),
    );
    declared(stream, Claim::new(Kind::Exponentials, states, truth))
}

/// The tangent of the half, which is defined everywhere.
fn tangent(stream: &mut Stream) -> Claim {
    let (half, exponent) = (part(stream), exponent(stream));
    let (mut truth, mut above) = (Truth::Holds, "sinh");
    if stream.once_in(2) {
        truth = Truth::Fails("almost everywhere".to_owned());
        above = "cosh";
    }
    let whole = times(half * Q::int(2), exponent);
    let states = States::Compare(
        format!("tanh({})", times(half, exponent)),
        "==",
        format!("{above}({whole})/(1 + cosh({whole}))"),
    );
    declared(stream, Claim::new(Kind::Exponentials, states, truth))
}

/// The derivative of an exponential or hyperbolic function of a part, by the variable.
fn rate(stream: &mut Stream) -> Claim {
    let (part, exponent) = (part(stream), exponent(stream));
    let argument = times(part, exponent);
    let factor = match exponent {
        "v" => part.to_string(),
        _ => format!("{part}*s"),
    };
    let (function, derived) = stream.pick(&[("exp", "exp"), ("sinh", "cosh"), ("cosh", "sinh")]);
    let (mut truth, mut sign) = (Truth::Holds, "");
    if stream.once_in(2) {
        truth = Truth::Fails("almost everywhere".to_owned());
        sign = "-";
    }
    let states = States::Compare(
        format!("D({function}({argument}), v)"),
        "==",
        format!("{sign}{factor}*{derived}({argument})"),
    );
    declared(stream, Claim::new(Kind::Exponentials, states, truth))
}

/// Between its values at the ends; beyond one of them where the interval is longer.
fn bound(stream: &mut Stream) -> Claim {
    let part = part(stream);
    let low = Q::new(stream.integer(-4, 2), 2);
    let high = low + Q::new(stream.integer(1, 4), 2);
    let slip = stream.once_in(2);
    let reach = if slip { high + Q::new(1, 2) } else { high };
    let power = |q: Q| format!("exp({})", part * q);
    let argument = times(part, "v");
    let (states, truth) = match stream.once_in(2) {
        true => (
            States::Compare(format!("exp({argument})"), "<=", power(high)),
            "at the upper end",
        ),
        // The exponential of the negative is largest at the lower end.
        false => (
            States::Compare(format!("exp(-{argument})"), ">=", power(-high)),
            "at the upper end",
        ),
    };
    let truth = match slip {
        true => Truth::Fails(truth.to_owned()),
        false => Truth::Holds,
    };
    let domain = format!("{{ in = '[{low}, {reach}]' }}");
    Claim::new(Kind::Exponentials, states, truth).symbol("v", domain)
}

/// What increases is ordered as its exponents are.
fn order(stream: &mut Stream) -> Claim {
    let part = part(stream);
    let slip = stream.once_in(2);
    let (small, large) = if slip { ("w", "v") } else { ("v", "w") };
    let truth = match slip {
        true => Truth::Fails("wherever v < w".to_owned()),
        false => Truth::Holds,
    };
    let states = match stream.below(3) {
        0 => States::Compare(
            format!("exp({})", times(part, large)),
            ">=",
            format!("exp({})", times(part, small)),
        ),
        1 => States::Compare(
            format!("sinh({} - {})", times(part, large), times(part, small)),
            ">=",
            "0".to_owned(),
        ),
        _ => States::Compare(
            format!("cosh({})", times(part, large)),
            ">=",
            format!("cosh({})", times(part, small)),
        ),
    };
    Claim::new(Kind::Exponentials, states, truth)
        .symbol("v", "{ in = '[0, inf)' }")
        .symbol("w", "{ in = '[0, inf)' }")
        .assuming("v <= w")
}
