//! Quotients: what cancels, partial fractions, divisors that vanish somewhere and divisors that do not.

use super::declared;
use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::domain::Domain;
use crate::random::number::Q;
use crate::random::polynomial::Polynomial;
use crate::random::seed::Stream;

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    match stream.below(4) {
        0 => cancelled(stream),
        1 => partial(stream),
        2 => nowhere(stream),
        _ => nested(stream),
    }
}

/// `p q/q == p`, where q vanishes at a point of the real line.
fn cancelled(stream: &mut Stream) -> Claim {
    let names = ["x", "y"];
    let p = Polynomial::some(stream, 2, 3, 2);
    let a = stream.fraction();
    let q = &Polynomial::some(stream, 2, 2, 1) + &Polynomial::variable(0).times(Q::new(97, 13));
    let q = &q + &Polynomial::number(a);
    let left = format!(
        "({})/({})",
        (&p * &q).text(stream, &names),
        q.text(stream, &names)
    );
    let mut right = p.clone();
    let mut truth = Truth::Conditional;
    if stream.once_in(2) {
        right = p.slipped(stream);
        truth = Truth::Fails("almost everywhere".to_owned());
    }
    let states = States::Compare(left, "==", right.text(stream, &names));
    Claim::new(Kind::Division, states, truth)
        .symbol("x", "{}")
        .symbol("y", "{}")
}

/// `1/(x - a) - 1/(x - b) == (a - b)/((x - a)(x - b))`, with both poles inside, one, or none.
fn partial(stream: &mut Stream) -> Claim {
    let (a, b) = (stream.integer(-6, 6), stream.integer(-6, 6));
    let (left, right, above) = (format!("1/(x - ({a}))"), format!("1/(x - ({b}))"), a - b);
    let above = above
        + if stream.once_in(2) {
            stream.nonzero(3)
        } else {
            0
        };
    let pole = |q: i128| (-2..=3).contains(&q);
    let truth = match (above == a - b, pole(a) || pole(b)) {
        (false, _) => Truth::Fails("at every point that is no pole".to_owned()),
        (true, true) => Truth::Conditional,
        (true, false) => Truth::Holds,
    };
    let states = States::Compare(
        format!("{left} - {right}"),
        "==",
        format!("({above})/((x - ({a}))*(x - ({b})))"),
    );
    Claim::new(Kind::Division, states, truth).symbol("x", "{ in = '[-2, 3]' }")
}

/// A divisor without zeros: no condition.
fn nowhere(stream: &mut Stream) -> Claim {
    let (divisor, declaration) = stream.pick(&[
        ("x^2 + 1", "{}"),
        ("x^2 + x + 1", "{}"),
        ("2*x + 1", "{ in = '[0, 1]' }"),
        ("3 - 2*x", "{ in = '[0, 1]' }"),
        ("2*x - 3", "{ integer = '>= 1' }"),
        ("3*x + 2", "{ integer = '-4..4' }"),
        ("x", "{ in = '(0, 1]' }"),
        ("1 - cos(x)", "{ in = '(0, pi)' }"),
        ("sin(x)", "{ in = '(0, pi)' }"),
        ("2 + cos(x)", "{}"),
    ]);
    let (a, b) = (stream.fraction(), stream.fraction());
    let (wrong, truth) = match stream.once_in(2) {
        true => (stream.fraction(), Truth::Fails("everywhere".to_owned())),
        false => (Q::ZERO, Truth::Holds),
    };
    let sum = b + wrong;
    let left = format!("(({a})*({divisor}) + ({b}))/({divisor})");
    let states = States::Compare(left, "==", format!("({a}) + ({sum})/({divisor})"));
    Claim::new(Kind::Division, states, truth).symbol("x", declaration)
}

/// `(p/q)/(r/q) == p/r` and the like, linear factors apart.
fn nested(stream: &mut Stream) -> Claim {
    let names = ["x", "y"];
    let domains = [Domain::some(stream), Domain::some(stream)];
    let linear = |stream: &mut Stream| {
        let x = Polynomial::variable(0).times(stream.fraction());
        &x + &Polynomial::number(stream.fraction())
    };
    let (p, q) = (linear(stream), linear(stream));
    let r = &Polynomial::variable(1).power(2) + &Polynomial::number(stream.positive());
    let slip = stream.once_in(2);
    let shown = if slip { p.slipped(stream) } else { p.clone() };
    let text = |stream: &mut Stream, q: &Polynomial| format!("({})", q.text(stream, &names));
    let (tp, tq, tr) = (text(stream, &p), text(stream, &q), text(stream, &r));
    let left = match stream.below(3) {
        0 => format!("({tp}/{tq})/({tr}/{tq})"),
        1 => format!("({tp}*{tq}^2/{tr})/{tq}^2"),
        _ => format!("({tp} + {tq})/{tr} - {tq}/{tr}"),
    };
    let vanishes = left.contains(&format!("/{tq}")) && zero_inside(&q, &domains[0]);
    let truth = match (slip, vanishes) {
        (true, _) => Truth::Fails("almost everywhere".to_owned()),
        (false, true) => Truth::Conditional,
        (false, false) => Truth::Holds,
    };
    let right = format!("{}/{tr}", text(stream, &shown));
    let claim = Claim::new(Kind::Division, States::Compare(left, "==", right), truth);
    declared(claim, &names, &domains)
}

/// Whether a linear polynomial in the first slot has its zero in the interval.
fn zero_inside(q: &Polynomial, domain: &Domain) -> bool {
    let origin = [Q::ZERO, Q::ONE, Q::ONE, Q::ONE];
    let slope = q.derivative(0).value(&origin);
    let zero = (-q.value(&origin)).over(slope);
    match domain.declaration {
        "{}" => true,
        "{ in = '[0, 1]' }" => Q::ZERO <= zero && zero <= Q::ONE,
        "{ in = '(0, 1)' }" => Q::ZERO < zero && zero < Q::ONE,
        "{ in = '[2, inf)' }" => zero >= Q::int(2),
        "{ in = '(-1, 3/2]' }" => Q::int(-1) < zero && zero <= Q::new(3, 2),
        _ => zero < Q::new(-1, 2),
    }
}
