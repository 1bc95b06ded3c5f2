//! The index as a factor: `i [E^i] F = [E^i] (E d/dE F)`, so that a polynomial in the index in front of a
//! coefficient is a sum of series again.

use super::Series;
use std::collections::BTreeMap;
use torse_algebra::{Fraction, Polynomial, Symbol};

/// The highest power of the index that is carried.
const MAX_EXPONENT: u16 = 4;

/// A part of a factor: `free * index^exponent * points`.
pub struct Part {
    /// Free of the index.
    pub free: Fraction,
    /// The power of the index.
    pub exponent: u16,
    /// A product of points at the index.
    pub points: Fraction,
}

/// Writes a factor as a sum of parts, if it is a polynomial in the index and the points at it.
pub fn split(factor: &Fraction, index: &str) -> Option<Vec<Part>> {
    let depends = |p: &Polynomial| p.symbols().iter().any(|s| s.depends_on(index));
    if factor.denominator_factors().any(|(p, _)| depends(p)) {
        return None;
    }
    let mut groups: BTreeMap<(Polynomial, u16), Polynomial> = BTreeMap::new();
    for term in factor.numerator().terms() {
        let mut free = Polynomial::constant(&term.coefficient);
        let (mut points, mut degree) = (Polynomial::integer(1), 0);
        for (symbol, exponent) in term.powers {
            let power = || Polynomial::symbol(symbol.clone()).power(u32::from(exponent));
            match symbol {
                Symbol::Indexed(..) if symbol.depends_on(index) => points = &points * &power(),
                Symbol::Named(name) if **name == *index => degree = exponent,
                _ if symbol.depends_on(index) => return None,
                _ => free = &free * &power(),
            }
        }
        if degree > MAX_EXPONENT {
            return None;
        }
        let slot = groups
            .entry((points, degree))
            .or_insert_with(Polynomial::zero);
        *slot = &*slot + &free;
    }
    let denominator: Fraction = factor.denominator().into();
    groups
        .into_iter()
        .map(|((points, exponent), free)| {
            let free = Fraction::from(free).over(&denominator).ok()?;
            Some(Part {
                free: free.under(factor.conditions()),
                exponent,
                points: points.into(),
            })
        })
        .collect()
}

impl Series {
    /// The same with every coefficient of one axis multiplied with a power of (its power of E less
    /// `offset`).
    pub(in crate::evaluate) fn weighted(
        &self,
        position: usize,
        offset: i64,
        exponent: u16,
    ) -> Vec<Self> {
        let once = |series: &Self| {
            let axis = series.axes.get(position);
            let mut parts: Vec<Self> = axis
                .into_iter()
                .flat_map(super::Axis::weighted)
                .map(|axis| series.with_axis(position, axis))
                .collect();
            parts.push(Self {
                factor: series.factor.clone() * Fraction::integer(-offset),
                ..series.clone()
            });
            parts.retain(|part| !part.is_trivial());
            parts
        };
        (0..exponent).fold(vec![self.clone()], |all, _| {
            all.iter().flat_map(once).collect()
        })
    }
}
