//! Total positivity by Wronskians: what is true is shown, and what is not is not.

use std::sync::Arc;
use torse_numbers::Rational;
use torse_numbers::rational::{integer, ratio};
use torse_proof::symbol::{Angle, Unit};
use torse_proof::wronskian::cell::Front;
use torse_proof::wronskian::{Cell, Operator, Seeds};
use torse_proof::{Polynomial, Symbol};

fn one() -> Polynomial {
    Polynomial::one()
}

fn named(name: &str) -> Polynomial {
    Polynomial::symbol(Symbol::named(name))
}

fn turn() -> [Polynomial; 2] {
    let angle = Angle {
        unit: Unit::QuarterTurn,
        parts: 1,
    };
    let x = || Arc::from("x");
    [
        Polynomial::symbol(Symbol::Sine(x(), angle)),
        Polynomial::symbol(Symbol::Cosine(x(), angle)),
    ]
}

/// `(1 - sin)(1 - mu sin)`, the rest, `(1 - cos)(1 - nu cos)`.
fn quadratic() -> Vec<Polynomial> {
    let seed = |t: &Polynomial, shape: &str| {
        let first = one().minus(t);
        first.times(&one().minus(&named(shape).times(t)))
    };
    let [sine, cosine] = turn();
    let (first, last) = (seed(&sine, "mu"), seed(&cosine, "nu"));
    let middle = one().minus(&first).minus(&last);
    vec![first, middle, last]
}

fn unit(_: &str) -> Option<(Rational, Rational)> {
    Some((integer(-1), integer(1)))
}

fn operator(seeds: &[Polynomial]) -> Operator {
    Operator::new(Seeds::new(seeds, "x", &unit).unwrap()).unwrap()
}

fn cells(count: i64, nodes: u16, radius: i64) -> Vec<Cell> {
    let cell = |n: i64| Cell {
        until: ratio(n, 2 * count).unwrap(),
        nodes,
        radius: integer(radius),
    };
    (1..=count).map(cell).collect()
}

#[test]
#[ignore]
fn explore() {
    let operator = operator(&quadratic());
    for (degree, count, nodes, radius) in [(2,1,16,1), (2, 1, 20, 2), (2, 1, 24, 1), (3, 1, 20, 2), (4,1,24,2), (5, 1, 28, 2),(5, 1, 32, 2),  (6, 1, 36, 2), (7,1,40,2), (8,1,44,2),(9,1,48,2), (9,1,52,2),(10,1,56,2), (10,1,60,2)] {
        let start = std::time::Instant::now();
        let vanishing = if degree == 2 {
            vec![2]
        } else {
            vec![]
        };
        let front = Front::new(&operator, degree, &vanishing);
        let front = match front { Ok(f) => f, Err(e) => { println!("{degree} {e}"); continue; } };
        let t0 = start.elapsed();
        let found = front.check(&cells(count, nodes, radius));
        println!("{degree} {count} {nodes} {radius}: {found:?} {t0:?} {:?}", start.elapsed());
    }
}
