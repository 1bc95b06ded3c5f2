//! The domain of a polynomial in coordinates that start at zero.
//!
//! A bounded symbol is v = a + (b - a) t with t in `[0, 1]`, a symbol with one bound v = a + t or b - t
//! with t >= 0. Sine and cosine of a quarter turn become rational functions of the tangent t of half the
//! angle, s = 2t/(1 + t^2), c = (1 - t^2)/(1 + t^2), and the polynomial is multiplied by the positive
//! denominator: the same sign, with t in `[0, 1]` for a variable of `[0, 1]`, and likewise for angles in radians from
//! 0 to pi/2, or to pi with t >= 0. A variable that also stands
//! outside keeps its own range: the box is larger than the domain, which proves more than is asked.

use crate::decide::domain::Domain;
use crate::decide::interval::{Bound, Interval};
use torse_algebra::rational::integer;
use torse_algebra::{Fraction, Polynomial, Rational, Scalar as _, Symbol};

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
    /// Whether every unbounded one has an open end, so that it is never zero.
    pub rays_open: bool,
}

/// A part of the box: lower and upper ends of the bounded coordinates.
pub type Region = Vec<(Rational, Rational)>;

impl Coordinates {
    /// Polynomials in the coordinates of their common domain, each with the sign of the given one; `None`
    /// if some symbol has no bound.
    #[must_use]
    pub fn of(polynomials: &[&Polynomial], domain: &Domain<'_>) -> Option<(Vec<Polynomial>, Self)> {
        let mut moved: Vec<Polynomial> = polynomials.iter().map(|p| (*p).clone()).collect();
        let mut intervals: Vec<(Symbol, Interval)> = vec![];
        let mut symbols: Vec<Symbol> = polynomials
            .iter()
            .flat_map(|p| p.symbols().to_vec())
            .collect();
        symbols.sort();
        symbols.dedup();
        for symbol in &symbols {
            let (Symbol::Cos(name, _) | Symbol::Sin(name, _)) = symbol else {
                continue;
            };
            let half = Symbol::named(&format!("{name}\u{bd}"));
            if intervals.iter().any(|(known, _)| *known == half) {
                continue;
            }
            let Some(tangent) = domain.half_tangent(symbol) else {
                continue;
            };
            for polynomial in &mut moved {
                *polynomial = in_half_angle(polynomial, symbol, &half)?;
            }
            intervals.push((half, tangent));
        }
        for symbol in moved.iter().flat_map(|p| p.symbols().to_vec()) {
            let number = matches!(symbol, Symbol::Pi | Symbol::Root(_));
            if !number && intervals.iter().all(|(known, _)| *known != symbol) {
                let interval = domain.interval(&symbol);
                intervals.push((symbol, interval));
            }
        }
        let mut coordinates = Self {
            sides: vec![],
            rays_open: true,
        };
        for (symbol, interval) in intervals {
            if interval.lower.is_none() && interval.upper.is_none() {
                // A symbol without bounds that stands in even powers alone: its square is any number t >= 0.
                for polynomial in &mut moved {
                    *polynomial = in_squares(polynomial, &symbol)?;
                }
                coordinates.rays_open = false;
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
        let mut ray = |bound: &Bound| self.rays_open &= !bound.closed;
        Some(match (interval.lower.clone(), interval.upper.clone()) {
            (Some(a), Some(b)) => {
                self.sides.push(Side {
                    symbol: symbol.clone(),
                    lower_closed: a.closed,
                    upper_closed: b.closed,
                });
                a.value.clone() + t * (b.value - a.value)
            }
            (Some(a), None) => {
                ray(&a);
                a.value + t
            }
            (None, Some(b)) => {
                ray(&b);
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

/// The numerator of the polynomial with sine and cosine of one angle written in the tangent of its half.
fn in_half_angle(polynomial: &Polynomial, angle: &Symbol, half: &Symbol) -> Option<Polynomial> {
    let (Symbol::Cos(name, kind) | Symbol::Sin(name, kind)) = angle else {
        return None;
    };
    let t = Fraction::symbol(half.clone());
    let one = Fraction::integer(1);
    let below = one.clone() + t.clone() * t.clone();
    let sine = t.scaled(&integer(2)).over(&below).ok()?;
    let cosine = (one - t.clone() * t).over(&below).ok()?;
    let moved = Fraction::from(polynomial.clone())
        .substituted(|s| match s {
            Symbol::Sin(n, k) if n == name && k == kind => Some(sine.clone()),
            Symbol::Cos(n, k) if n == name && k == kind => Some(cosine.clone()),
            _ => None,
        })
        .ok()?;
    Some(moved.numerator().clone())
}
