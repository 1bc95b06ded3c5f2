//! Derivatives and `at`: of names that are free, bound by a function, bound by a sum, or assumed to have a value. The
//! slips are the readings that a careless engine takes: the value is put in too early, or the wrong name is bound.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::domain::{Domain, where_not_zero};
use crate::random::number::Q;
use crate::random::polynomial::Polynomial;
use crate::random::seed::Stream;

const NAMES: [&str; 2] = ["x", "y"];

/// What is written, what it is, and what a careless reading makes of it.
struct Reading {
    left: String,
    right: Polynomial,
    careless: Polynomial,
    lets: Vec<(String, String)>,
    assume: Option<String>,
}

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    let domains = [Domain::some(stream), Domain::some(stream)];
    if stream.once_in(8) {
        return circle(stream);
    }
    let reading = reading(stream, &domains);
    let mut truth = Truth::Holds;
    let mut right = reading.right.clone();
    if stream.once_in(2) {
        right = match reading.careless == reading.right || stream.once_in(3) {
            true => reading.right.slipped(stream),
            false => reading.careless.clone(),
        };
        let difference = &right - &reading.right;
        truth = Truth::Fails(match &reading.assume {
            None => where_not_zero(&difference, &NAMES, &domains),
            Some(value) => format!("{value}, y almost anywhere"),
        });
        if let Some(value) = &reading.assume {
            // The point is on the line x = c: the slip must show there.
            let c: Vec<i128> = value
                .trim_start_matches("x == ")
                .split('/')
                .filter_map(|part| part.parse().ok())
                .collect();
            let c = match c.as_slice() {
                [above, below] => Q::new(*above, *below),
                [whole] => Q::int(*whole),
                _ => Q::ZERO,
            };
            if difference.with(0, &Polynomial::number(c)).is_zero() {
                right = reading.right.clone();
                truth = Truth::Holds;
            }
        }
    }
    let states = States::Compare(reading.left, "==", right.text(stream, &NAMES));
    let mut claim = Claim::new(Kind::Calculus, states, truth);
    claim.lets = reading.lets;
    if reading.assume.is_none() {
        claim = claim.wanting(&NAMES, &reading.right);
    }
    claim.assume.extend(reading.assume);
    let claim = claim.symbol("x", domains[0].declaration);
    claim.symbol("y", domains[1].declaration)
}

fn reading(stream: &mut Stream, domains: &[Domain]) -> Reading {
    let p = Polynomial::some(stream, 2, 3, 3);
    let text = p.text(stream, &NAMES);
    let c = stream.fraction();
    let constant = Polynomial::number(c);
    let (x, y) = (Polynomial::variable(0), Polynomial::variable(1));
    let plain = |left: String, right: Polynomial, careless: Polynomial| Reading {
        left,
        right,
        careless,
        lets: vec![],
        assume: None,
    };
    let with = |mut reading: Reading, head: &str, body: String| {
        reading.lets.push((head.to_owned(), body));
        reading
    };
    match stream.below(12) {
        // A derivative in a function that is called with a number.
        0 => with(
            plain(
                format!("V({c})"),
                p.derivative(0).with(0, &constant),
                Polynomial::default(),
            ),
            "V(x)",
            format!("D({text}, x)"),
        ),
        // `at` in a function that is called with another number.
        1 => {
            let other = stream.fraction();
            with(
                plain(
                    format!("G({other})"),
                    p.with(0, &constant),
                    p.with(0, &Polynomial::number(other)),
                ),
                "G(x)",
                format!("at({text}, x, {c})"),
            )
        }
        // An assumed value.
        2 => {
            let value = domains[0].point(stream);
            let mut reading = plain(
                format!("D({text}, x)"),
                p.derivative(0).with(0, &Polynomial::number(value)),
                Polynomial::default(),
            );
            reading.assume = Some(format!("x == {value}"));
            reading
        }
        // A derivative by a symbol that is also the argument.
        3 => with(
            plain(
                "D(F, y)(y)".to_owned(),
                p.derivative(1).with(0, &y),
                p.with(0, &y).derivative(1),
            ),
            "F(x)",
            text,
        ),
        // The total and the partial derivative.
        4 => plain(
            format!("D(at({text}, y, x), x)"),
            p.with(1, &x).derivative(0),
            p.derivative(0).with(1, &x),
        ),
        5 => plain(
            format!("at(D({text}, x), y, x)"),
            p.derivative(0).with(1, &x),
            p.with(1, &x).derivative(0),
        ),
        // A derivative at a point.
        6 => plain(
            format!("at(D({text}, x), x, {c})"),
            p.derivative(0).with(0, &constant),
            Polynomial::default(),
        ),
        // Primes, and parameters with the names of symbols in the other order.
        7 => with(
            plain(
                "F'(y, x)".to_owned(),
                swapped(&p.derivative(0)),
                p.derivative(0),
            ),
            "F(x, y)",
            text,
        ),
        8 => with(
            plain(
                format!("D(F, y)({c}, x)"),
                p.derivative(1).with(0, &constant).with(1, &x),
                p.derivative(0).with(0, &constant).with(1, &x),
            ),
            "F(x, y)",
            text,
        ),
        // The chain rule.
        9 => {
            let inner = Polynomial::some(stream, 1, 2, 2);
            let value = p.with(0, &inner).derivative(0);
            with(
                plain(
                    format!("D(F({}), x)", inner.text(stream, &NAMES)),
                    value,
                    p.derivative(0).with(0, &inner),
                ),
                "F(x)",
                text,
            )
        }
        // A sum whose index is what is differentiated by, or put in.
        10 => {
            let sum = (1..=3).fold(Polynomial::default(), |sum, k| {
                &sum + &p.with(0, &Polynomial::number(Q::int(k)))
            });
            plain(
                format!("sum(k, 1, 3, at({text}, x, k))"),
                sum,
                p.times(Q::int(3)),
            )
        }
        _ => {
            let second = p.derivative(0).derivative(0);
            plain(format!("D({text}, x, 2)"), second, p.derivative(0))
        }
    }
}

/// x and y exchanged.
fn swapped(p: &Polynomial) -> Polynomial {
    let (x, y, z) = (
        Polynomial::variable(0),
        Polynomial::variable(1),
        Polynomial::variable(2),
    );
    p.with(0, &z).with(1, &x).with(2, &y)
}

/// Derivatives of sine and cosine.
fn circle(stream: &mut Stream) -> Claim {
    let (a, b) = (stream.fraction(), stream.fraction());
    let slip = stream.once_in(2);
    let c = if slip { -b } else { b };
    let truth = match slip {
        true => Truth::Fails("x = 0".to_owned()),
        false => Truth::Holds,
    };
    let (left, right) = match stream.below(3) {
        0 => (
            format!("D(({a})*cos(pi/2*x) + ({b})*sin(pi/2*x), x)"),
            format!("pi/2*(({c})*cos(pi/2*x) - ({a})*sin(pi/2*x))"),
        ),
        1 => (
            format!("D(({a})*sin(x)^2 + ({b})*sin(x), x)"),
            format!("({c})*cos(x) + 2*({a})*sin(x)*cos(x)"),
        ),
        _ => (
            format!("at(D(({a})*x + ({b})*sin(pi/2*x), x), x, 0)"),
            format!("({a}) + pi/2*({c})"),
        ),
    };
    let claim = Claim::new(Kind::Calculus, States::Compare(left, "==", right), truth);
    claim.symbol("x", stream.pick(&["{}", "{ in = '[0, 1]' }"]))
}
