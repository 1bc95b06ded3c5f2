//! The search for points of the domain at which a statement fails: simple ones first, then, where hypotheses tie many symbols to
//! each other, those inside of what they leave.

use super::domain::Domain;
use super::inner_point;
use super::point_search::PointSearch;
use super::real_symbol::RealSymbol;
use super::witness::Point;
use torse_algebra::Fraction;
use torse_syntax::formula::Relation;

/// A point of the domain at which `wanted` holds for the fraction that is passed in, no divisor of it, of what is
/// `also` to be known there, or of the statement vanishes, and every constraint holds; with the values of eliminated symbols.
///
/// None where the index of a point is symbolic: two names may be one point then, which small instances tell apart.
#[must_use]
pub fn find(
    difference: &Fraction,
    also: &[&Fraction],
    domain: &Domain<'_>,
    wanted: Relation,
) -> Option<Point> {
    let search = PointSearch::new(difference, also, domain, wanted)?;
    let point = search.simple(None).or_else(|| inner_point::find(&search))?;
    search.finished(point)
}

/// The same, with this value of a symbol tried first, and simple points alone.
#[must_use]
pub fn near(
    difference: &Fraction,
    also: &[&Fraction],
    domain: &Domain<'_>,
    wanted: Relation,
    first: (&RealSymbol, &Fraction),
) -> Option<Point> {
    let search = PointSearch::new(difference, also, domain, wanted)?;
    search.finished(search.simple(Some(first))?)
}
