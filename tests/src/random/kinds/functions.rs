//! Arbitrary smooth functions: total derivatives, the chain rule, definitions, values at numbers, vectors, and values that are
//! assumed at one place. A function at a place is as free as a symbol, so a polynomial in some of its derivatives there
//! is zero for all functions only if it is the zero polynomial.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::domain::{Domain, where_not_zero};
use crate::random::number::Q;
use crate::random::polynomial::{Formula, Polynomial};
use crate::random::seed::Stream;

/// What a formula is, and in which names.
struct Reading<'a> {
    left: String,
    right: Polynomial,
    names: [&'a str; 4],
}

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    let made = match stream.below(8) {
        0 => total(stream, 1),
        1 => total(stream, 2),
        2 => defined(stream),
        3 => chain(stream),
        4 => placed(stream),
        5 => vectors(stream),
        6 => independent(stream),
        _ => assumed(stream),
    };
    made.symbol("f", "{ function = 1 }")
}

/// `left == right`, slipped half of the time.
fn equation(stream: &mut Stream, reading: &Reading<'_>) -> Claim {
    let (mut truth, mut printed) = (Truth::Holds, reading.right.clone());
    if stream.once_in(2) {
        printed = reading.right.slipped(stream);
        let difference = &reading.right - &printed;
        truth = Truth::Fails(where_not_zero(&difference, &reading.names, &[]));
    }
    let right = printed.text(stream, &reading.names);
    let states = States::Compare(reading.left.clone(), "==", right);
    Claim::new(Kind::Functions, states, truth)
}

/// The derivative by u of a polynomial in u, f, f' and f''.
fn rate(p: &Polynomial) -> Polynomial {
    let moved = |slot: usize| &p.derivative(slot) * &Polynomial::variable(slot + 1);
    &p.derivative(0) + &(&moved(1) + &moved(2))
}

const JETS: [&str; 4] = ["u", "f(u)", "f'(u)", "f''(u)"];

/// A total derivative of this order, in one of several ways to write it.
fn total(stream: &mut Stream, order: usize) -> Claim {
    // So many slots that no third derivative occurs.
    let slots = if order == 1 { 3 } else { 2 };
    let formula = Formula::some(stream, &JETS[..slots], 1);
    let right = (0..order).fold(formula.value, |p, _| rate(&p));
    let text = formula.text;
    let left = match (order, stream.below(3)) {
        (1, 0) => format!("at(D({text}, u), u, u)"),
        (1, _) => format!("D({text}, u)"),
        (_, 0) => format!("D(D({text}, u), u)"),
        (_, _) => format!("D({text}, u, 2)"),
    };
    let names = JETS;
    equation(stream, &Reading { left, right, names }).symbol("u", "{}")
}

/// The same of a function that is defined by f, called with u or differentiated by it.
fn defined(stream: &mut Stream) -> Claim {
    let names = ["x", "f(x)", "f'(x)"];
    let formula = Formula::some(stream, &names, 1);
    let right = rate(&formula.value);
    let left = stream.pick(&["F'(u)", "D(F)(u)", "D(F(u), u)", "D(F, x)(u)"]);
    let names = JETS;
    let left = left.to_owned();
    let claim = equation(stream, &Reading { left, right, names });
    claim.letting("F(x)", formula.text).symbol("u", "{}")
}

/// A polynomial in f at another function.
fn chain(stream: &mut Stream) -> Claim {
    let outer = Polynomial::some(stream, 1, 3, 3);
    let text = outer.text(stream, &["f(g(u))"]);
    let names = ["f(g(u))", "f'(g(u))", "g'(u)", "0"];
    let slope = &Polynomial::variable(1) * &Polynomial::variable(2);
    let reading = Reading {
        left: format!("D({text}, u)"),
        right: &outer.derivative(0) * &slope,
        names,
    };
    let claim = equation(stream, &reading);
    claim.symbol("u", "{}").symbol("g", "{ function = 1 }")
}

/// A total derivative at a number.
fn placed(stream: &mut Stream) -> Claim {
    let place = stream.positive();
    let formula = Formula::some(stream, &JETS[..3], 1);
    let names = [0, 1, 2].map(|primes| format!("f{}({place})", "'".repeat(primes)));
    let right = rate(&formula.value).with(0, &Polynomial::number(place));
    let reading = Reading {
        left: format!("at(D({}, u), u, {place})", formula.text),
        right,
        names: ["0", &names[0], &names[1], &names[2]],
    };
    equation(stream, &reading).symbol("u", "{}")
}

/// A total derivative of a scalar product.
fn vectors(stream: &mut Stream) -> Claim {
    let outer = Polynomial::some(stream, 2, 3, 2);
    let text = outer.text(stream, &["u", "dot(c(u), c(u))"]);
    let slope = Polynomial::variable(2).times(Q::int(2));
    let reading = Reading {
        left: format!("D({text}, u)"),
        right: &outer.derivative(0) + &(&outer.derivative(1) * &slope),
        names: ["u", "dot(c(u), c(u))", "dot(c(u), c'(u))", "0"],
    };
    let claim = equation(stream, &reading);
    claim.symbol("u", "{}").symbol("c", "{ function = 3 }")
}

/// Values and slopes at two places, which have nothing to do with one another.
fn independent(stream: &mut Stream) -> Claim {
    let names = ["f(0)", "f'(0)", "f(1)", "f'(1)"];
    let formula = Formula::some(stream, &names, 1);
    let reading = Reading {
        left: formula.text,
        right: formula.value,
        names,
    };
    equation(stream, &reading)
}

/// A value that is assumed at u is assumed nowhere else: the slope stays free.
fn assumed(stream: &mut Stream) -> Claim {
    let p = Polynomial::some(stream, 2, 3, 2);
    let text = p.text(stream, &JETS);
    let value = stream.fraction();
    let right = rate(&p).with(1, &Polynomial::number(value));
    let reading = Reading {
        left: format!("D({text}, u)"),
        right: right.clone(),
        names: JETS,
    };
    let careless = p.with(1, &Polynomial::number(value)).derivative(0);
    let claim = match careless != right && stream.once_in(3) {
        // As if the value were assumed at all places.
        true => {
            let difference = &right - &careless;
            let truth = Truth::Fails(where_not_zero(&difference, &JETS, &[] as &[Domain]));
            let careless = careless.text(stream, &JETS);
            let states = States::Compare(reading.left, "==", careless);
            Claim::new(Kind::Functions, states, truth)
        }
        false => equation(stream, &reading),
    };
    claim.symbol("u", "{}").assuming(format!("f(u) == {value}"))
}
