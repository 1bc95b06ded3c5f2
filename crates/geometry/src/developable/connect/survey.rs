//! Where in the unit square the equation can have solutions: bisection with balls.
//!
//! On a cell `F` lies within `F(middle) + F_s ds + F_t dt`, the derivatives taken over the cell (mean value
//! form). A cell where that leaves zero out holds no solution. Where `F_s` and `F_t` have opposite signs on the
//! whole cell, its solutions are one strictly rising graph, or none: `F` is then largest in one of the corners
//! `(s1, t0)`, `(s0, t1)` and least in the other, so the signs there decide. Where the signs are equal the
//! graph falls, and no patch comes of it: its rulings would run against the one rail.

use super::equation::{Contact, Equation};
use crate::curve::SpaceCurve;
use std::cmp::Ordering;
use std::collections::BTreeMap;
use torse_algebra::rational::{Rational, to_f64};
use torse_algebra::{Ball, Integer};

/// A closed rectangle of parameters `[s0, s1] x [t0, t1]`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParameterBox {
    /// The parameters of the first curve.
    pub s: [f64; 2],
    /// The parameters of the second curve.
    pub t: [f64; 2],
}

/// What is known after the bisection.
#[derive(Debug, Clone, Default)]
pub(super) struct Survey {
    /// Cells with one strictly rising graph of solutions each.
    pub rising: Vec<ParameterBox>,
    /// Cells with falling solutions, or none.
    pub falling: Vec<ParameterBox>,
    /// Cells about which nothing was proved.
    pub open: Vec<ParameterBox>,
}

/// The finest cells have a side of `2^-MAX_DEPTH`.
const MAX_DEPTH: u32 = 9;
/// Cells looked at, at most.
const MAX_CELLS: usize = 40_000;

/// A dyadic interval `[index, index + 1] / 2^depth`, or its middle.
type Key = (u32, u32, bool);

/// Contacts of a curve over dyadic intervals, each computed once.
struct Cache<'a, C> {
    curve: &'a C,
    bits: usize,
    known: BTreeMap<Key, Option<Contact<Ball>>>,
}

impl<C: SpaceCurve<Ball>> Cache<'_, C> {
    fn at(&mut self, key: Key) -> Option<&Contact<Ball>> {
        let (curve, bits) = (self.curve, self.bits);
        let contact = self
            .known
            .entry(key)
            .or_insert_with(|| Contact::at(curve, &interval(key, bits)).ok());
        contact.as_ref()
    }
}

fn dyadic(numerator: u32, depth: u32) -> Rational {
    Rational::new(
        Integer::from(numerator),
        Integer::ONE << usize::try_from(depth).unwrap_or(0),
    )
}

fn interval((depth, index, middle): Key, bits: usize) -> Ball {
    if middle {
        Ball::from_rational(&dyadic(2 * index + 1, depth + 1), bits)
    } else {
        Ball::from_bounds(&dyadic(index, depth), &dyadic(index + 1, depth), bits)
    }
}

pub(super) fn survey<P: SpaceCurve<Ball>, Q: SpaceCurve<Ball>>(
    first: &P,
    second: &Q,
    bits: usize,
) -> Survey {
    let mut one = Cache {
        curve: first,
        bits,
        known: BTreeMap::new(),
    };
    let mut two = Cache {
        curve: second,
        bits,
        known: BTreeMap::new(),
    };
    let mut survey = Survey::default();
    let mut open = vec![(0_u32, 0_u32, 0_u32)];
    let mut visited = 0;
    while let Some((depth, i, j)) = open.pop() {
        visited += 1;
        let cell = || {
            let side = |n: u32| [n, n + 1].map(|n| to_f64(&dyadic(n, depth)));
            ParameterBox {
                s: side(i),
                t: side(j),
            }
        };
        let spent = depth >= MAX_DEPTH || visited >= MAX_CELLS;
        match classify(&mut one, &mut two, (depth, i, j)) {
            Kind::Empty => {}
            Kind::Rising => match corners(first, second, &cell(), bits) {
                Some(true) => survey.rising.push(cell()),
                Some(false) => {}
                None => survey.open.push(cell()),
            },
            Kind::Falling => survey.falling.push(cell()),
            Kind::Unknown if spent => survey.open.push(cell()),
            Kind::Unknown => {
                for (di, dj) in [(1, 1), (1, 0), (0, 1), (0, 0)] {
                    open.push((depth + 1, 2 * i + di, 2 * j + dj));
                }
            }
        }
    }
    survey
}

enum Kind {
    Empty,
    Rising,
    Falling,
    Unknown,
}

fn classify<P: SpaceCurve<Ball>, Q: SpaceCurve<Ball>>(
    one: &mut Cache<P>,
    two: &mut Cache<Q>,
    (depth, i, j): (u32, u32, u32),
) -> Kind {
    let bits = one.bits;
    let (Some(over_s), Some(over_t)) = (one.at((depth, i, false)), two.at((depth, j, false)))
    else {
        return Kind::Unknown;
    };
    let over = Equation::from_contacts(over_s, over_t);
    if over.value.sign().is_some_and(Ordering::is_ne) {
        return Kind::Empty;
    }
    let (Some(at_s), Some(at_t)) = (one.at((depth, i, true)), two.at((depth, j, true))) else {
        return Kind::Unknown;
    };
    let middle = Equation::from_contacts(at_s, at_t).value;
    let half = dyadic(1, depth + 1);
    let reach = Ball::from_bounds(&-half.clone(), &half, bits);
    let form = middle + over.by_s.clone() * reach.clone() + over.by_t.clone() * reach;
    if form.sign().is_some_and(Ordering::is_ne) {
        return Kind::Empty;
    }
    match (over.by_s.sign(), over.by_t.sign()) {
        (Some(Ordering::Greater), Some(Ordering::Less))
        | (Some(Ordering::Less), Some(Ordering::Greater)) => Kind::Rising,
        (Some(Ordering::Greater), Some(Ordering::Greater))
        | (Some(Ordering::Less), Some(Ordering::Less)) => Kind::Falling,
        _ => Kind::Unknown,
    }
}

/// Whether a rising cell holds a solution: by the signs of `F` in the corners `(s1, t0)` and `(s0, t1)`.
pub(super) fn corners<P: SpaceCurve<Ball>, Q: SpaceCurve<Ball>>(
    first: &P,
    second: &Q,
    cell: &ParameterBox,
    bits: usize,
) -> Option<bool> {
    let ball = |x: f64| crate::exact_ball(x, bits);
    let sign = |s: f64, t: f64| {
        let equation = Equation::at((first, second), &ball(s), &ball(t)).ok()?;
        equation.value.sign()
    };
    let (right, left) = (sign(cell.s[1], cell.t[0])?, sign(cell.s[0], cell.t[1])?);
    Some(right != left || right == Ordering::Equal)
}

/// Whether the solutions in a box are proved to be one strictly rising graph.
pub(super) fn rises<P: SpaceCurve<Ball>, Q: SpaceCurve<Ball>>(
    first: &P,
    second: &Q,
    cell: &ParameterBox,
    bits: usize,
) -> bool {
    let over =
        |[from, to]: [f64; 2]| Ball::from_bounds(&crate::exact(from), &crate::exact(to), bits);
    let Ok(equation) = Equation::at((first, second), &over(cell.s), &over(cell.t)) else {
        return false;
    };
    matches!(
        (equation.by_s.sign(), equation.by_t.sign()),
        (Some(Ordering::Greater), Some(Ordering::Less))
            | (Some(Ordering::Less), Some(Ordering::Greater))
    )
}
