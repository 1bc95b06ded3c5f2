//! Products and their expansions, also in sines and cosines, binomial sums and applied functions.

use super::{declared, equation};
use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::domain::Domain;
use crate::random::number::Q;
use crate::random::polynomial::{Formula, Polynomial};
use crate::random::seed::Stream;

const NAMES: [&str; 3] = ["x", "y", "z"];

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    match stream.below(6) {
        0..3 => expanded(stream),
        3 => applied(stream),
        4 => circle(stream),
        _ => binomial(stream),
    }
}

fn domains(stream: &mut Stream) -> Vec<Domain> {
    NAMES.iter().map(|_| Domain::some(stream)).collect()
}

fn expanded(stream: &mut Stream) -> Claim {
    let slots = 1 + stream.below(3);
    let depth = 1 + stream.below(2);
    let formula = Formula::some(stream, &NAMES[..slots], depth);
    let domains = domains(stream);
    let known = (&NAMES[..slots], &domains[..slots]);
    equation(
        stream,
        Kind::Polynomial,
        known,
        &formula.text,
        &formula.value,
    )
}

/// `F(q)` for a polynomial F of a parameter that hides a symbol.
fn applied(stream: &mut Stream) -> Claim {
    let body = Polynomial::some(stream, 2, 3, 2);
    let inner = Polynomial::some(stream, 2, 2, 1);
    let domains = domains(stream);
    let value = body.with(0, &inner);
    let call = format!("F({})", inner.text(stream, &["x", "y"]));
    let text = body.text(stream, &["x", "y"]);
    let known = (&NAMES[..2], &domains[..2]);
    equation(stream, Kind::Polynomial, known, &call, &value).letting("F(x)", text)
}

/// `p + q (sin^2 + cos^2 - 1) == p`.
fn circle(stream: &mut Stream) -> Claim {
    let names = ["sin(pi/2*x)", "cos(pi/2*x)"];
    let p = Polynomial::some(stream, 2, 3, 2);
    let q = Polynomial::some(stream, 2, 2, 1);
    let unit = &(&Polynomial::variable(0).power(2) + &Polynomial::variable(1).power(2))
        - &Polynomial::number(Q::ONE);
    let left = (&p + &(&q * &unit)).text(stream, &names);
    let mut truth = Truth::Holds;
    let mut right = p.text(stream, &names);
    if stream.once_in(2) {
        let more = stream.fraction();
        right = format!("{right} + {more}*sin(pi/2*x)");
        truth = Truth::Fails("x = 1".to_owned());
    }
    let claim = Claim::new(Kind::Polynomial, States::Compare(left, "==", right), truth);
    claim.symbol("x", "{ in = '[0, 1]' }")
}

/// The binomial theorem with numbers.
fn binomial(stream: &mut Stream) -> Claim {
    let degree = stream.below(5) + 1;
    let power = u32::try_from(degree).unwrap_or(1);
    let (a, b) = (stream.fraction(), stream.fraction());
    let left =
        format!("sum(k, 0, {degree}, binom({degree}, k)*(({a})*x)^({degree} - k)*(({b})*y)^k)");
    let value =
        (&Polynomial::variable(0).times(a) + &Polynomial::variable(1).times(b)).power(power);
    let domains = domains(stream);
    if stream.once_in(3) {
        let states = States::Compare(left, "==", format!("(({a})*x + ({b})*y)^{degree}"));
        let claim = Claim::new(Kind::Polynomial, states, Truth::Holds);
        return declared(claim, &NAMES[..2], &domains[..2]);
    }
    equation(
        stream,
        Kind::Polynomial,
        (&NAMES[..2], &domains[..2]),
        &left,
        &value,
    )
}
