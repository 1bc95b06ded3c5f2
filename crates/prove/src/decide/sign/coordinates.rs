//! The domain of a polynomial in coordinates that start at zero.
//!
//! A bounded symbol is v = a + (b - a) t with t in `[0, 1]`, a symbol with one bound v = a + t or b - t
//! with t >= 0. Sine and cosine of an angle become rational functions of the tangent of half the angle, or of half its
//! distance from a multiple of a quarter turn ([`Half`]), and the polynomial is multiplied by the positive
//! denominator: the same sign. Angles of one variable are written in the finest of their parts first. A variable that
//! also stands outside keeps its own range: the box is larger than the domain, which proves more than is asked.

use crate::decide::angle::Half;
use crate::decide::domain::Domain;
use crate::decide::interval::{Bound, Interval};
use crate::decide::value::{plain_angle, plain_symbol, quotient};
use std::sync::Arc;
use torse_algebra::rational::integer;
use torse_algebra::{Angle, Finest, Fraction, Polynomial, Rational, Symbol};
use torse_certificate::sign::{Coordinate, End};

/// A coordinate t in `[0, 1]`, and whether its ends belong to the domain.
#[derive(Debug, Clone)]
pub struct Side {
    /// The symbol, which now stands for t.
    pub symbol: Symbol,
    /// Whether t = 0 belongs to the domain.
    pub lower_closed: bool,
    /// Whether t = 1 does.
    pub upper_closed: bool,
}

/// The coordinates of a domain.
#[derive(Debug, Clone, Default)]
pub struct Coordinates {
    /// The bounded ones.
    pub sides: Vec<Side>,
    /// The unbounded ones with an open end, which are never zero.
    pub open_rays: Vec<Symbol>,
    /// The symbols that stand for tangents, each with the variable and the angle.
    pub tangents: Vec<(Symbol, Arc<str>, Angle)>,
    /// What each symbol is, as part of a proof, in the order in which they are put in.
    pub written: Vec<Coordinate<Polynomial>>,
}

/// A part of the box: lower and upper ends of the bounded coordinates.
pub type Region = Vec<(Rational, Rational)>;

impl Coordinates {
    /// Polynomials in the coordinates of their common domain, each with the sign of the given one; `None`
    /// if some symbol has no bound.
    #[must_use]
    pub fn new(
        polynomials: &[&Polynomial],
        domain: &Domain<'_>,
    ) -> Option<(Vec<Polynomial>, Self)> {
        let finest = Finest::new(polynomials.iter().flat_map(|p| p.symbols()));
        let mut moved: Vec<Polynomial> = polynomials
            .iter()
            .map(|p| p.substituted(|symbol| finest.value(symbol)))
            .collect();
        let mut intervals: Vec<(Symbol, Interval)> = vec![];
        let mut tangents: Vec<(Symbol, Arc<str>, Angle)> = vec![];
        let mut written = vec![];
        let mut symbols: Vec<Symbol> = moved.iter().flat_map(|p| p.symbols().to_vec()).collect();
        symbols.sort();
        symbols.dedup();
        for symbol in &symbols {
            let (Symbol::Cos(name, angle) | Symbol::Sin(name, angle)) = symbol else {
                continue;
            };
            if tangents.iter().any(|(_, n, a)| n == name && a == angle) {
                continue;
            }
            let Some(half) = domain.half(name, *angle) else {
                continue;
            };
            // No text can write the sign.
            let tangent = Symbol::named(&format!("{name}\u{bd}{}", tangents.len()));
            for polynomial in &mut moved {
                *polynomial = in_half_angle(polynomial, name, *angle, &half, &tangent)?;
            }
            written.push(Coordinate::Tangent {
                symbol: plain_symbol(&tangent),
                variable: name.to_string(),
                angle: plain_angle(*angle),
                from: i64::try_from(&half.from).ok()?,
            });
            intervals.push((tangent.clone(), half.tangent));
            tangents.push((tangent, name.clone(), *angle));
        }
        for symbol in moved.iter().flat_map(|p| p.symbols().to_vec()) {
            let number = symbol.is_number();
            if !number && intervals.iter().all(|(known, _)| *known != symbol) {
                let interval = domain.interval(&symbol);
                intervals.push((symbol, interval));
            }
        }
        let mut coordinates = Self {
            sides: vec![],
            open_rays: vec![],
            tangents,
            written,
        };
        for (symbol, interval) in intervals {
            if interval.lower.is_none() && interval.upper.is_none() {
                // A symbol without bounds that stands in even powers alone: its square is any number t >= 0.
                for polynomial in &mut moved {
                    *polynomial = in_squares(polynomial, &symbol)?;
                }
                let symbol = plain_symbol(&symbol);
                coordinates.written.push(Coordinate::Squared { symbol });
                continue;
            }
            let value = coordinates.add(&symbol, &interval)?;
            for polynomial in &mut moved {
                let there = Fraction::from(polynomial.clone())
                    .substituted(|s| (*s == symbol).then(|| value.clone()))
                    .ok()?;
                *polynomial = there.as_polynomial()?.clone();
            }
        }
        Some((moved, coordinates))
    }

    /// The symbol by its coordinate.
    fn add(&mut self, symbol: &Symbol, interval: &Interval) -> Option<Fraction> {
        let t = Fraction::symbol(symbol.clone());
        let own = plain_symbol(symbol);
        let end = |bound: &Bound| End {
            value: quotient(&bound.value),
            closed: bound.closed,
        };
        let mut ray = |bound: &Bound, up: bool| {
            if !bound.closed {
                self.open_rays.push(symbol.clone());
            }
            let end = end(bound);
            let symbol = own.clone();
            self.written.push(Coordinate::Ray { symbol, end, up });
        };
        Some(match (interval.lower.clone(), interval.upper.clone()) {
            (Some(a), Some(b)) => {
                self.sides.push(Side {
                    symbol: symbol.clone(),
                    lower_closed: a.closed,
                    upper_closed: b.closed,
                });
                self.written.push(Coordinate::Side {
                    symbol: own.clone(),
                    lower: end(&a),
                    upper: end(&b),
                });
                a.value.clone() + t * (b.value - a.value)
            }
            (Some(a), None) => {
                ray(&a, true);
                a.value + t
            }
            (None, Some(b)) => {
                ray(&b, false);
                b.value - t
            }
            (None, None) => return None,
        })
    }

    /// The whole box.
    #[must_use]
    pub fn whole(&self) -> Region {
        vec![(integer(0), integer(1)); self.sides.len()]
    }

    /// Whether a product of unbounded coordinates is positive everywhere: none of them is ever zero.
    #[must_use]
    pub fn excludes_zero(&self, ray: &Polynomial) -> bool {
        let mut symbols = ray.symbols().iter();
        symbols.all(|symbol| self.open_rays.contains(symbol))
    }

    /// Which ends of a region belong to the domain, side by side; those inside the box do.
    #[must_use]
    pub fn closed_ends(&self, region: &Region) -> Vec<(bool, bool)> {
        let ends = self.sides.iter().zip(region);
        ends.map(|(side, (low, high))| {
            let inside = (*low != integer(0), *high != integer(1));
            (side.lower_closed || inside.0, side.upper_closed || inside.1)
        })
        .collect()
    }
}

/// The polynomial with t for the square of the symbol, which then stands for t; `None` if an odd power occurs.
fn in_squares(polynomial: &Polynomial, symbol: &Symbol) -> Option<Polynomial> {
    let t = Polynomial::symbol(symbol.clone());
    let mut result = Polynomial::zero();
    for (exponent, coefficient) in polynomial.coefficients_in(symbol).into_iter().enumerate() {
        if coefficient.is_zero() {
            continue;
        }
        if exponent % 2 == 1 {
            return None;
        }
        let power = t.power(u32::try_from(exponent / 2).ok()?);
        result = &result + &(&coefficient * &power);
    }
    Some(result)
}

/// The numerator of the polynomial with sine and cosine of one angle written in the tangent of half of it.
fn in_half_angle(
    polynomial: &Polynomial,
    name: &Arc<str>,
    angle: Angle,
    half: &Half,
    tangent: &Symbol,
) -> Option<Polynomial> {
    let (sine, cosine) = half.sine_cosine(&Fraction::symbol(tangent.clone()))?;
    let moved = Fraction::from(polynomial.clone())
        .substituted(|s| match s {
            Symbol::Sin(n, a) if n == name && *a == angle => Some(sine.clone()),
            Symbol::Cos(n, a) if n == name && *a == angle => Some(cosine.clone()),
            _ => None,
        })
        .ok()?;
    Some(moved.numerator().clone())
}
