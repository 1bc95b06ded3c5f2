//! Assumptions with fractional coefficients: combinations of them are true, and a form that is negative at a point which
//! satisfies them all is not.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::domain::at;
use crate::random::number::Q;
use crate::random::polynomial::{Polynomial, SLOTS};
use crate::random::seed::Stream;

const NAMES: [&str; 3] = ["a", "b", "c"];

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    match stream.below(10) {
        0..6 => linear(stream),
        6 => square(stream),
        7 => simplex(stream),
        8 => product(stream),
        _ => contradiction(stream),
    }
}

fn reals(claim: Claim, names: &[&str]) -> Claim {
    names
        .iter()
        .fold(claim, |claim, name| claim.symbol(name, "{}"))
}

/// A form `f` said to be positive (or not negative), its terms on both sides and times a positive number.
fn said(
    stream: &mut Stream,
    f: &Polynomial,
    strict: bool,
    names: &[&str],
) -> (String, &'static str, String) {
    let f = f.times(stream.positive());
    let moved = match stream.below(3) {
        0 => Polynomial::default(),
        1 => Polynomial::number(stream.fraction()),
        _ => Polynomial::variable(stream.below(names.len())).times(stream.fraction()),
    };
    let (left, right) = ((&f + &moved).text(stream, names), moved.text(stream, names));
    match (stream.once_in(2), strict) {
        (true, true) => (left, ">", right),
        (true, false) => (left, ">=", right),
        (false, true) => (right, "<", left),
        (false, false) => (right, "<=", left),
    }
}

fn form(stream: &mut Stream, slots: usize) -> Polynomial {
    let mut form = Polynomial::number(stream.fraction());
    for slot in 0..slots {
        form = &form + &Polynomial::variable(slot).times(stream.fraction());
    }
    form
}

fn linear(stream: &mut Stream) -> Claim {
    let slots = 1 + stream.below(3);
    let names = &NAMES[..slots];
    let mut point = [Q::ZERO; SLOTS];
    for value in point.iter_mut().take(slots) {
        *value = stream.fraction();
    }
    let strict = stream.once_in(2);
    let mut hypotheses: Vec<Polynomial> = vec![];
    for _ in 0..=stream.below(2) {
        let mut hypothesis = form(stream, slots);
        if hypothesis.value(&point) <= Q::ZERO {
            let more = Q::new(stream.integer(1, 9), 4) - hypothesis.value(&point);
            hypothesis = &hypothesis + &Polynomial::number(more);
        }
        hypotheses.push(hypothesis);
    }
    let (conclusion, truth) = if stream.once_in(2) {
        let mut sum = Polynomial::default();
        for hypothesis in &hypotheses {
            sum = &sum + &hypothesis.times(stream.positive());
        }
        if stream.once_in(2) {
            sum = &sum + &Polynomial::number(stream.positive());
        }
        (sum, Truth::Holds)
    } else {
        // Near to a combination, often with the wrong sign.
        let mut sum = match stream.once_in(2) {
            true => hypotheses[0].times(-stream.positive()),
            false => form(stream, slots),
        };
        let value = sum.value(&point);
        if value >= Q::ZERO {
            sum = &sum - &Polynomial::number(value + Q::new(1, stream.integer(1, 4)));
        }
        (sum, Truth::Fails(at(names, &point)))
    };
    let (left, relation, right) = said(stream, &conclusion, strict, names);
    let claim = Claim::new(
        Kind::Assumptions,
        States::Compare(left, relation, right),
        truth,
    );
    let mut claim = reals(claim, names);
    for hypothesis in &hypotheses {
        let (left, relation, right) = said(stream, hypothesis, strict, names);
        claim.assume.push(format!("{left} {relation} {right}"));
    }
    claim
}

/// A symbol with a range that is said to be a square: the square stays in the range.
fn square(stream: &mut Stream) -> Claim {
    let bound = stream.positive();
    let (shift, k) = (stream.fraction(), stream.positive());
    // x in [shift - 1, shift + k bound^2], x == k y^2 + shift, so that y^2 <= bound^2.
    let top = shift + k * bound * bound;
    let less = match stream.once_in(2) {
        true => Q::new(1, stream.integer(2, 5)) * bound,
        false => Q::ZERO,
    };
    let truth = match less == Q::ZERO {
        true => Truth::Holds,
        false => Truth::Fails(at(&["y", "x"], &[bound, top])),
    };
    let states = match stream.once_in(2) {
        true => States::Compare("y".to_owned(), "<=", format!("{}", bound - less)),
        false => States::Compare("-y".to_owned(), ">=", format!("{}", less - bound)),
    };
    Claim::new(Kind::Assumptions, states, truth)
        .symbol("x", format!("{{ in = '[{}, {top}]' }}", shift - Q::ONE))
        .symbol("y", "{}")
        .assuming(format!("x == {k}*y^2 + ({shift})"))
}

/// Barycentric coordinates.
fn simplex(stream: &mut Stream) -> Claim {
    let (a, b) = (stream.positive(), stream.positive());
    let (most, least) = (a.max(b), a.min(b));
    let (right, relation, truth) = match stream.below(4) {
        0 => (most, "<=", Truth::Holds),
        1 => (Q::ZERO, ">=", Truth::Holds),
        2 => (
            most * Q::new(3, 4),
            "<=",
            Truth::Fails("u = 1 or v = 1, the others 0".to_owned()),
        ),
        _ => (least, ">=", Truth::Fails("w = 1, u = v = 0".to_owned())),
    };
    let states = States::Compare(format!("({a})*u + ({b})*v"), relation, right.to_string());
    let claim = Claim::new(Kind::Assumptions, states, truth);
    let unit = "{ in = '[0, 1]' }";
    let ray = "{ in = '[0, inf)' }";
    let claim = claim.symbol("u", stream.pick(&[unit, ray]));
    let claim = claim.symbol("v", stream.pick(&[unit, ray]));
    let claim = claim.symbol("w", stream.pick(&[unit, ray]));
    claim.assuming(stream.pick(&["w == 1 - u - v", "u + v + w == 1", "1 - w == u + v"]))
}

/// Equations whose solution divides.
fn product(stream: &mut Stream) -> Claim {
    let k = stream.fraction();
    let (assume, states, truth) = match stream.below(8) {
        0 => (
            format!("a*b == {k}"),
            States::Compare("b".to_owned(), "!=", "0".to_owned()),
            Truth::Holds,
        ),
        1 => (
            format!("a*b == {k}"),
            States::Compare("a*b^2".to_owned(), "==", format!("({k})*b")),
            Truth::Holds,
        ),
        2 => (
            format!("a*b == {k}"),
            States::Compare("a".to_owned(), "==", k.to_string()),
            Truth::Fails(format!("a = {}, b = 1/2", k * Q::int(2))),
        ),
        3 => (
            format!("a*b == ({k})*b"),
            States::Compare("b*a^2".to_owned(), "==", format!("({})*b", k * k)),
            Truth::Holds,
        ),
        4 => (
            format!("a*b == ({k})*b"),
            States::Compare("b*a".to_owned(), "==", format!("({})*b", k * Q::int(2))),
            Truth::Fails(format!("a = {k}, b = 1")),
        ),
        5 => (
            format!("a == ({k})*b + a*b"),
            States::Compare("a*(1 - b)".to_owned(), "==", format!("({k})*b")),
            Truth::Holds,
        ),
        6 => (
            format!("D(a^2, a) == 2*a + b - ({k})"),
            States::Compare("b".to_owned(), "==", k.to_string()),
            Truth::Holds,
        ),
        _ => (
            format!("a == ({k})*b"),
            States::Compare("D(a*b, b)".to_owned(), "==", format!("2*({k})*b")),
            Truth::Fails("b = 1: the partial derivative is a".to_owned()),
        ),
    };
    let claim = Claim::new(Kind::Assumptions, states, truth);
    reals(claim, &["a", "b"]).assuming(assume)
}

/// Hypotheses without a point.
fn contradiction(stream: &mut Stream) -> Claim {
    let hypothesis = form(stream, 2);
    let names = &NAMES[..2];
    let more = Polynomial::number(stream.positive());
    let states = States::Compare("a".to_owned(), ">", "b".to_owned());
    let claim = Claim::new(Kind::Assumptions, states, Truth::Vacuous);
    match stream.below(3) {
        0 => {
            let opposite = &(-&hypothesis) - &more;
            let (l, r, m) = said(stream, &hypothesis, true, names);
            let (n, s, p) = said(stream, &opposite, false, names);
            reals(claim, names)
                .assuming(format!("{l} {r} {m}"))
                .assuming(format!("{n} {s} {p}"))
        }
        1 => {
            let above = Q::ONE + stream.positive();
            reals(claim, names)
                .symbol("x", "{ in = '[0, 1]' }")
                .assuming(format!("x == {above} + a^2"))
        }
        _ => {
            let text = hypothesis.text(stream, names);
            reals(claim, names).assuming(format!("{text} == {text} + 1"))
        }
    }
}
