//! Linear equations, their unknowns, and what follows for all unknowns that satisfy them.

use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::number::Q;
use crate::random::polynomial::Polynomial;
use crate::random::seed::Stream;

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    match stream.below(4) {
        0 | 1 => two(stream),
        2 => symbolic(stream),
        _ => ranged(stream),
    }
}

/// Two equations with numbers, right sides in x and y: r and s are made up first.
fn two(stream: &mut Stream) -> Claim {
    let names = ["x", "y"];
    let (r, s) = (
        Polynomial::some(stream, 2, 2, 1),
        Polynomial::some(stream, 2, 2, 1),
    );
    let (a, b, c, d) = loop {
        let [a, b, c, d] = [(); 4].map(|()| stream.fraction());
        if a * d - b * c != Q::ZERO {
            break (a, b, c, d);
        }
    };
    let given = [(a, b), (c, d)].map(|(a, b)| {
        let right = &r.times(a) + &s.times(b);
        format!("({a})*r + ({b})*s == {}", right.text(stream, &names))
    });
    let (e, f) = (stream.fraction(), stream.fraction());
    let value = &r.times(e) + &s.times(f);
    let slip = stream.once_in(2);
    let shown = if slip {
        value.slipped(stream)
    } else {
        value.clone()
    };
    let truth = match slip {
        true => Truth::Fails("almost everywhere".to_owned()),
        false => Truth::Holds,
    };
    let states = States::Compare(
        format!("({e})*r + ({f})*s"),
        "==",
        shown.text(stream, &names),
    );
    let mut claim = Claim::new(Kind::Given, states, truth).wanting(&names, &value);
    claim.given = given.to_vec();
    claim.unknowns = vec!["r".to_owned(), "s".to_owned()];
    ["x", "y", "r", "s"]
        .iter()
        .fold(claim, |claim, name| claim.symbol(name, "{}"))
}

/// Coefficients that are symbols: Cramer's rule, with and without the quotient.
fn symbolic(stream: &mut Stream) -> Claim {
    let k = stream.fraction();
    let slip = stream.once_in(2);
    let l = if slip { -k } else { k };
    let fails = |truth| match slip {
        true => Truth::Fails("a = d = 1, b = c = 0, e = f = 1".to_owned()),
        false => truth,
    };
    let (given, unknowns, left, right, truth): (&[&str], &[&str], _, _, _) = match stream.below(4) {
        0 => (
            &["a*r + b == f"],
            &["r"],
            format!("({k})*r"),
            format!("({l})*(f - b)/a"),
            fails(Truth::Conditional),
        ),
        1 => (
            &["a*r + b*s == e", "c*r + d*s == f"],
            &["r", "s"],
            format!("({k})*s"),
            format!("({l})*(a*f - c*e)/(a*d - b*c)"),
            fails(Truth::Conditional),
        ),
        2 => (
            &["a*r + b*s == e", "c*r + d*s == f"],
            &["r", "s"],
            format!("({k})*s*(a*d - b*c)"),
            format!("({l})*(a*f - c*e)"),
            fails(Truth::Holds),
        ),
        _ => (
            &["r + b*s == e", "s == f + c"],
            &["r", "s"],
            format!("({k})*r"),
            format!("({l})*(e - b*(f + c))"),
            fails(Truth::Holds),
        ),
    };
    let mut claim = Claim::new(Kind::Given, States::Compare(left, "==", right), truth);
    claim.given = given.iter().map(|s| (*s).to_owned()).collect();
    claim.unknowns = unknowns.iter().map(|s| (*s).to_owned()).collect();
    ["a", "b", "c", "d", "e", "f", "r", "s"]
        .iter()
        .fold(claim, |claim, name| claim.symbol(name, "{}"))
}

/// An unknown with a range: `a u + b v + w == c` with w >= 0 bounds `a u + b v` by c.
fn ranged(stream: &mut Stream) -> Claim {
    let (a, b) = (stream.positive(), stream.positive());
    let c = a + b;
    let k = stream.positive();
    let less = if stream.once_in(2) {
        Q::new(1, stream.integer(2, 5)) * c
    } else {
        Q::ZERO
    };
    let truth = match less == Q::ZERO {
        true => Truth::Holds,
        false => Truth::Fails("u = 1, v = 1, w = 0".to_owned()),
    };
    let (left, right) = (
        format!("({})*u + ({})*v", k * a, k * b),
        format!("{}", k * (c - less)),
    );
    let states = match stream.once_in(2) {
        true => States::Compare(left, "<=", right),
        false => States::Compare(right, ">=", left),
    };
    let mut claim = Claim::new(Kind::Given, states, truth);
    claim.given = vec![format!("({a})*u + ({b})*v + w == {c}")];
    claim.unknowns = vec!["w".to_owned()];
    let claim = claim.symbol("u", "{}").symbol("v", "{}");
    claim.symbol("w", "{ in = '[0, inf)' }")
}
