//! Total positivity by Wronskians: what is true is shown, and what is not is not.

#![allow(clippy::unwrap_used, reason = "helpers of tests")]

use std::sync::Arc;
use torse_certificate::symbol::{Angle, Unit};
use torse_certificate::wronskian::cell::Front;
use torse_certificate::wronskian::{Cell, Operator, Seeds, Unfit};
use torse_certificate::{Polynomial, Symbol};
use torse_numbers::Rational;
use torse_numbers::rational::{integer, ratio};

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

fn seeds(functions: &[Polynomial]) -> Seeds {
    Seeds::new(functions, "x", &unit).unwrap()
}

/// Equal cells from 0 to 1/2.
fn cells(count: i64, nodes: u16, radius: i64) -> Vec<Cell> {
    let cell = |n: i64| Cell {
        until: ratio(n, 2 * count).unwrap(),
        nodes,
        radius: integer(radius),
    };
    (1..=count).map(cell).collect()
}

/// Whether cells show the determinants of a degree to be positive.
fn shown(functions: &[Polynomial], degree: u8, exact: &[u8], cells: &[Cell]) -> Result<(), Unfit> {
    let operator = Operator::new(seeds(functions))?;
    Front::new(&operator, degree, exact)?.check(cells)
}

#[test]
fn one_cell_is_enough_at_small_degrees_and_so_are_two() {
    for degree in 3..=5 {
        for count in [1, 2] {
            let cells = cells(count, 36, 2);
            assert_eq!(shown(&quadratic(), degree, &[], &cells), Ok(()), "{degree}");
        }
    }
}

/// At degree 2 a coefficient of the second determinant is zero: that of both parameters at their lower ends.
#[test]
fn a_coefficient_that_is_zero_needs_the_determinant_multiplied_out() {
    let cells = cells(1, 20, 2);
    let found = shown(&quadratic(), 2, &[], &cells);
    assert!(
        matches!(found, Err(Unfit::Sign { rank: 2, .. })),
        "{found:?}"
    );
    assert_eq!(shown(&quadratic(), 2, &[2], &cells), Ok(()));
    assert_eq!(shown(&quadratic(), 2, &[0], &cells), Err(Unfit::Rank(0)));
    assert_eq!(shown(&quadratic(), 2, &[3], &cells), Err(Unfit::Rank(3)));
}

#[test]
fn too_few_places_show_nothing() {
    let found = shown(&quadratic(), 5, &[], &cells(1, 12, 2));
    assert!(matches!(found, Err(Unfit::Sign { .. })), "{found:?}");
}

#[test]
fn cells_have_to_fill_the_half_and_discs_to_hold_them() {
    let mut early = cells(1, 20, 2);
    early[0].until = ratio(1, 4).unwrap();
    let mut back = cells(2, 20, 2);
    back[0].until = ratio(3, 4).unwrap();
    let mut tight = cells(1, 20, 2);
    tight[0].radius = ratio(1, 4).unwrap();
    for wrong in [vec![], early, back, tight, cells(1, 1, 2), cells(1, 20, 9)] {
        let found = shown(&quadratic(), 3, &[], &wrong);
        assert!(found.is_err(), "{wrong:?}");
    }
}

/// With the parameters exchanged the family run backwards is the family itself.
#[test]
fn the_symmetry_is_found() {
    let own = seeds(&quadratic());
    let exchange = own.symmetry().unwrap();
    assert!(exchange.swapped && exchange.turned == [false, false]);
    assert_eq!(own.exchanged(exchange), own.mirrored());
    assert_eq!(own.mirrored().mirrored(), own);
}

/// The first function of degree one rises again: its negative slope is the first determinant.
#[test]
fn what_is_not_totally_positive_is_not_shown() {
    let x = named("x");
    let bump = x.times(&one().minus(&x));
    let bump = bump.times(&one().minus(&x.scaled(&integer(2))));
    let last = x.plus(&bump.scaled(&integer(6)));
    let functions = vec![one().minus(&last), last];
    for degree in 1..=3 {
        for count in [1, 4] {
            let found = shown(&functions, degree, &[], &cells(count, 24, 2));
            assert!(matches!(found, Err(Unfit::Sign { .. })), "{found:?}");
        }
    }
}

/// A function that does not vanish at the end to the order of its index: the theorem says nothing.
#[test]
fn orders_at_the_ends_are_seen_to() {
    let [sine, _] = turn();
    let functions = vec![one().minus(&sine), sine.minus(&named("x")), named("x")];
    let found = shown(&functions, 3, &[], &cells(1, 24, 2));
    assert!(matches!(found, Err(Unfit::Order(_))), "{found:?}");
}
