//! Points of the line at which a comparison fails: simple numbers between real roots, or these where they are rational or quadratic.

use super::line::{Limit, Made, Origin, bounds, is_inside, made, variable};
use crate::decide::candidates::simplest_between;
use crate::decide::domain::Domain;
use crate::decide::order::truth;
use crate::decide::value::plain;
use crate::decide::witness::Point;
use crate::decide::witness_search;
use std::cmp::Ordering;
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Polynomial, Rational, Scalar as _, Symbol};
use torse_certificate::Polynomial as Plain;
use torse_certificate::line::{self as written, Span};
use torse_certificate::number::order;
use torse_syntax::formula::Relation;

/// A point of the domain at which a difference of one variable compares with zero as wanted: a simple number between the roots
/// at hand, or one of these, where it is rational or quadratic.
pub(super) fn find(
    difference: &Fraction,
    also: &[&Fraction],
    domain: &Domain<'_>,
    wanted: Relation,
) -> Option<Point> {
    let product = difference.numerator() * &difference.denominator();
    let variable = variable(&product, domain)?;
    let divisors = also
        .iter()
        .flat_map(|f| f.conditions())
        .chain(difference.conditions());
    let divisors: Vec<Polynomial> = divisors.chain(&domain.divisors).cloned().collect();
    let mut bounds = bounds(&variable, domain, &divisors)?;
    bounds.push(Limit {
        above: product.clone(),
        below: Polynomial::integer(1),
        relation: wanted,
        is: Origin::Divisor,
    });
    let Made { line, relations } = made(&product, &variable, bounds)?;
    let plain_line = line.map(&plain);
    let places = places(&plain_line)?;
    let cells = plain_line.cells().ok()?;
    for (cell, place) in cells.iter().zip(places) {
        if !is_inside(&relations, cell)? {
            continue;
        }
        let value = match place {
            Place::At(value) => Fraction::from(value),
            Place::Root { factor, from, to } => {
                match exact_root(line.factors.get(factor)?, variable.symbol(), &from, &to) {
                    Some(value) => value,
                    None => continue,
                }
            }
        };
        let first = (&variable, &value);
        if let Some(point) = witness_search::near(difference, also, domain, wanted, first) {
            return Some(point);
        }
    }
    None
}

/// A point of a cell.
enum Place {
    /// This number.
    At(Rational),
    /// The root of this factor between two numbers.
    Root {
        factor: usize,
        from: Rational,
        to: Rational,
    },
}

/// How often a piece is halved about a root.
const MAX_HALVINGS: usize = 60;

/// A point of each cell, as far as it is rational or a root.
fn places(line: &written::Line<Plain>) -> Option<Vec<Place>> {
    let factors: Vec<Vec<Plain>> = line
        .factors
        .iter()
        .map(|factor| written::coefficients(factor, &line.variable))
        .collect::<Option<_>>()?;
    let mut found = vec![];
    let mut cuts = line.cuts.iter();
    for span in Span::between(&line.cuts) {
        let changes: Vec<written::Changes> = factors
            .iter()
            .map(|factor| span.changes(factor))
            .collect::<Option<_>>()?;
        match changes.iter().position(|own| own.count > 0) {
            None => found.push(Place::At(inner(&span)?)),
            Some(factor) => {
                let (coefficients, own) = (factors.get(factor)?, changes.get(factor)?);
                found.extend(about_root(coefficients, *own, &span, factor)?);
            }
        }
        found.extend(cuts.next().cloned().map(Place::At));
    }
    Some(found)
}

/// A simple number of a piece.
fn inner(span: &Span) -> Option<Rational> {
    match span {
        Span::Below(to) => Some((to - integer(1)).floor()),
        Span::Above(from) => Some((from + integer(1)).ceil()),
        Span::Between(from, to) => simplest_between(from, to),
    }
}

/// Numbers left and right of the one root of a factor on a piece, and the root between.
fn about_root(
    coefficients: &[Plain],
    changes: written::Changes,
    span: &Span,
    factor: usize,
) -> Option<[Place; 3]> {
    let sign = |x: &Rational| order(&written::value_at(coefficients, x));
    // Ends of the piece where it has none: far enough to be beyond the root.
    let far = |start: &Rational, direction: i64, beyond: Ordering| {
        let mut step = integer(direction);
        for _ in 0..MAX_HALVINGS {
            let x = start + &step;
            if sign(&x)? == beyond {
                return Some(x);
            }
            step *= integer(2);
        }
        None
    };
    let (mut from, mut to) = match span {
        Span::Below(to) => (far(to, -1, changes.left)?, to.clone()),
        Span::Above(from) => (from.clone(), far(from, 1, changes.right)?),
        Span::Between(from, to) => (from.clone(), to.clone()),
    };
    let (first, last) = (from.clone(), to.clone());
    let has_left = matches!(span, Span::Below(_));
    let has_right = matches!(span, Span::Above(_));
    let mut left = has_left.then(|| from.clone());
    let mut right = has_right.then(|| to.clone());
    for _ in 0..MAX_HALVINGS {
        let middle = simplest_between(&from, &to)?;
        let half = (&from + &to) / integer(2);
        for x in [middle, half] {
            if x <= from || x >= to {
                continue;
            }
            let own = sign(&x)?;
            if own == changes.left {
                left.get_or_insert_with(|| x.clone());
                from = x;
            } else if own == changes.right {
                right.get_or_insert_with(|| x.clone());
                to = x;
            } else {
                let left = left.or_else(|| simplest_between(&first, &x))?;
                let right = right.or_else(|| simplest_between(&x, &last))?;
                return Some([Place::At(left), Place::At(x), Place::At(right)]);
            }
        }
        if left.is_some() && right.is_some() && &to - &from < integer(1) / integer(1 << 20) {
            break;
        }
    }
    Some([
        Place::At(left?),
        Place::Root { factor, from, to },
        Place::At(right?),
    ])
}

/// The root of a quadratic polynomial with rational coefficients between two numbers.
fn exact_root(
    factor: &Polynomial,
    variable: &Symbol,
    from: &Rational,
    to: &Rational,
) -> Option<Fraction> {
    let coefficients = factor.coefficients_in(variable);
    let [constant, linear, square] = coefficients.as_slice() else {
        return None;
    };
    let (c, b, a) = (
        constant.as_constant()?,
        linear.as_constant()?,
        square.as_constant()?,
    );
    let discriminant = &b * &b - integer(4) * &a * &c;
    let root = Fraction::from(Polynomial::square_root(&discriminant).ok()?);
    let scale = (integer(2) * &a).recip();
    let both = [root.clone(), -root];
    let mut both = both
        .into_iter()
        .map(|root| (root - Fraction::from(b.clone())).scaled(&scale));
    both.find(|value| {
        let above = value.clone() - Fraction::from(from.clone());
        let below = value.clone() - Fraction::from(to.clone());
        truth(&above, Relation::Greater) == Some(true)
            && truth(&below, Relation::Less) == Some(true)
    })
}
