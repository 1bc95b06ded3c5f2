//! Properties of a whole basis.

use super::degree::BERNSTEIN;
use crate::random::Kind;
use crate::random::claim::{Claim, States, Truth};
use crate::random::number::Q;
use crate::random::polynomial::{Polynomial, SLOTS};
use crate::random::seed::Stream;

/// A claim of this kind.
pub fn claim(stream: &mut Stream) -> Claim {
    let (text, table, truth) = match stream.below(5) {
        0 | 1 => nonnegative(stream),
        2 => dependent(stream),
        _ => diminishing(stream),
    };
    Claim::new(Kind::Properties, States::Other(text), truth)
        .symbol("x", "{ in = '[0, 1]' }")
        .basis("g", table)
}

fn table(seeds: &[String], step: (&str, &str)) -> String {
    let quoted: Vec<String> = seeds.iter().map(|s| format!("'{s}'")).collect();
    format!(
        "variable = 'x'\ndegree = {}\nseeds = [{}]\nstep = ['{}', '{}']",
        seeds.len() - 1,
        quoted.join(", "),
        step.0,
        step.1
    )
}

/// Seeds from factors that are not negative on [0, 1]; or one of them less its value at a point, and more.
fn nonnegative(stream: &mut Stream) -> (String, String, Truth) {
    let x = Polynomial::variable(0);
    let rest = &Polynomial::number(Q::ONE) - &x;
    let mut seeds: Vec<Polynomial> = (0..=stream.below(3))
        .map(|_| {
            let mut seed = Polynomial::number(stream.positive());
            for _ in 0..stream.below(4) {
                seed = &seed * &stream.pick(&[x.clone(), rest.clone()]);
            }
            seed
        })
        .collect();
    let mut truth = Truth::Holds;
    if stream.once_in(2) {
        let wrong = stream.below(seeds.len());
        let q = Q::new(stream.integer(0, 6), 6);
        let mut point = [Q::ZERO; SLOTS];
        point[0] = q;
        let less = seeds[wrong].value(&point) + Q::new(1, stream.integer(2, 30));
        seeds[wrong] = &seeds[wrong] - &Polynomial::number(less);
        truth = Truth::Fails(format!("seed {wrong} at x = {q}"));
    }
    let texts: Vec<String> = seeds.iter().map(|s| s.text(stream, &["x"])).collect();
    let step = stream.pick(&[
        ("1 - x", "x"),
        ("x", "1 - x"),
        ("1", "x"),
        ("1 - x^2", "x^2"),
        ("2", "x*(1 - x)"),
    ]);
    ("nonnegative(g)".to_owned(), table(&texts, step), truth)
}

/// A seed that is a combination of the others.
fn dependent(stream: &mut Stream) -> (String, String, Truth) {
    let (p, q) = (
        Polynomial::some(stream, 1, 2, 2),
        Polynomial::some(stream, 1, 2, 2),
    );
    let sum = &p.times(stream.fraction()) + &q.times(stream.fraction());
    let mut seeds = [p, q, sum];
    stream.shuffle(&mut seeds);
    let texts: Vec<String> = seeds.iter().map(|s| s.text(stream, &["x"])).collect();
    let truth = Truth::Fails("at the degree of the seeds".to_owned());
    (
        "independent(g)".to_owned(),
        table(&texts, ("1 - x", "x")),
        truth,
    )
}

/// The Bernstein functions of a monotone quotient, and families that are not monotone or do not sum to one.
fn diminishing(stream: &mut Stream) -> (String, String, Truth) {
    let holds = [
        ("1 - x", "x"),
        ("x", "1 - x"),
        ("1 - x^2", "x^2"),
        ("1 - x^3", "x^3"),
        ("1 - x/2", "x/2"),
        ("1 - 3*x^2 + 2*x^3", "3*x^2 - 2*x^3"),
    ];
    let k = stream.integer(2, 9);
    let scaled = (format!("{k}*(1 - x)"), format!("{k}*x"));
    let text = "variation_diminishing(g)".to_owned();
    let one = ["1".to_owned()];
    match stream.below(7) {
        0 | 1 => (text, table(&one, stream.pick(&holds)), Truth::Holds),
        // Two functions, of which the second has the slope 1 + c (1 - 6 x + 6 x^2), at least 1 - c/2 and 1 + c: at degree one the
        // question is whether it rises.
        5 | 6 => {
            let c = stream.integer(-2, 6);
            let last = format!("x + ({c})*x*(1 - x)*(1 - 2*x)");
            let seeds = [format!("1 - ({last})"), last];
            let truth = match c {
                -1..=2 => Truth::Holds,
                _ => Truth::Fails(format!(
                    "the slope is {} or {}",
                    1 + c,
                    1.0 - c as f64 / 2.0
                )),
            };
            let text = "variation_diminishing(g, 1, 1)".to_owned();
            (text, table(&seeds, ("1 - x", "x")), truth)
        }
        2 => (text, BERNSTEIN.to_owned(), Truth::Holds),
        3 => {
            let truth =
                Truth::Fails("P[0] = 0, P[1] = 1: x (1 - x) has a line crossed twice".to_owned());
            let step = ("1 - 4*x*(1 - x)", "4*x*(1 - x)");
            (text, table(&one, step), truth)
        }
        _ => {
            let truth = Truth::Fails("all P = 1: the curve leaves the polygon".to_owned());
            let growing = table(&one, ("1", "x"));
            let doubled = table(&one, (&scaled.0, &scaled.1));
            match stream.once_in(2) {
                true => (text, growing, truth),
                false => (
                    text,
                    doubled,
                    Truth::Fails("P = (1, 0) at degree 1".to_owned()),
                ),
            }
        }
    }
}
