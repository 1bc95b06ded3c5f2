//! Points at which a sign is seen to be wrong, so that no search for its proof begins.
//!
//! Most polynomials that are asked for a sign have none, and a search finds that out by halving boxes until its budget
//! is spent. A few points of the box tell the same in doubles. Nothing is decided here: a point only saves a search
//! that could not have succeeded, and where rounding might mislead, by a margin, it saves nothing.

use super::coordinates::Coordinates;
use torse_algebra::rational::to_f64;
use torse_algebra::{Polynomial, Symbol};

/// Points inside the box that are looked at, besides its corners.
const INSIDE: u32 = 24;
/// Boxes of more sides than this are not looked at in their corners.
const MAX_SIDES: usize = 4;
/// A value smaller than this part of the sum of the sizes of its terms may be rounded away.
const MARGIN: f64 = 1e-9;

/// A polynomial in doubles.
struct Rounded {
    terms: Vec<(f64, Vec<(usize, i32)>)>,
}

impl Rounded {
    fn new(polynomial: &Polynomial, symbols: &[Symbol]) -> Self {
        let term = |term: torse_algebra::polynomial::Term<'_>| {
            let mut coefficient = to_f64(&term.coefficient);
            let mut powers = vec![];
            for (symbol, exponent) in term.powers {
                let exponent = i32::from(exponent);
                match symbol {
                    Symbol::Pi => coefficient *= std::f64::consts::PI.powi(exponent),
                    Symbol::Root(n) => coefficient *= f64::from(*n).sqrt().powi(exponent),
                    Symbol::Log(n) => coefficient *= libm::log(f64::from(*n)).powi(exponent),
                    Symbol::Arc(above, below) => {
                        let tangent = f64::from(*above) / f64::from(*below);
                        coefficient *= libm::atan(tangent).powi(exponent);
                    }
                    Symbol::Exp(e) if symbol.is_number() => {
                        coefficient *= libm::exp(f64::from(e.parts()).recip()).powi(exponent);
                    }
                    _ => powers.extend(
                        symbols
                            .binary_search(symbol)
                            .ok()
                            .map(|place| (place, exponent)),
                    ),
                }
            }
            (coefficient, powers)
        };
        Self {
            terms: polynomial.terms().map(term).collect(),
        }
    }

    /// Whether the value is negative, and not by rounding.
    fn is_negative(&self, point: &[f64]) -> bool {
        let (mut value, mut size) = (0.0, 0.0);
        for (coefficient, powers) in &self.terms {
            let term = powers.iter().fold(*coefficient, |product, (place, power)| {
                product * point.get(*place).map_or(f64::NAN, |x| x.powi(*power))
            });
            value += term;
            size += term.abs();
        }
        value < -MARGIN * size
    }
}

/// Whether the polynomial is negative at a point of the box at which every bound is negative: then it has no proof of
/// being zero or more there.
pub(super) fn refute<'p>(
    polynomial: &Polynomial,
    bounds: impl Iterator<Item = &'p Polynomial>,
    coordinates: &Coordinates,
) -> bool {
    let bounds: Vec<&Polynomial> = bounds.collect();
    let mut symbols: Vec<Symbol> = std::iter::once(&polynomial)
        .chain(&bounds)
        .flat_map(|p| p.symbols().to_vec())
        .collect();
    symbols.sort();
    symbols.dedup();
    let bounded: Vec<bool> = symbols
        .iter()
        .map(|symbol| coordinates.sides.iter().any(|side| side.symbol == *symbol))
        .collect();
    let target = Rounded::new(polynomial, &symbols);
    let bounds: Vec<Rounded> = bounds.iter().map(|p| Rounded::new(p, &symbols)).collect();
    let corners = match bounded.len() {
        sides @ ..=MAX_SIDES => 1_u32 << sides,
        _ => 0,
    };
    let corner = |number: u32| {
        let end = |side: usize| f64::from(number >> side & 1);
        (0..bounded.len()).map(end).collect()
    };
    let inside = |number: u32| {
        let place = |(side, bounded): (usize, &bool)| {
            let share = spread(number, side);
            if *bounded {
                share
            } else {
                share / (1.0 - share)
            }
        };
        bounded.iter().enumerate().map(place).collect()
    };
    let mut points = (0..corners).map(corner).chain((1..=INSIDE).map(inside));
    points.any(|point: Vec<f64>| {
        target.is_negative(&point) && bounds.iter().all(|bound| bound.is_negative(&point))
    })
}

/// Numbers between 0 and 1 that fill the box evenly: multiples of roots of primes, without their integers (Richtmyer 1951).
fn spread(number: u32, side: usize) -> f64 {
    const PRIMES: [f64; 8] = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0];
    let root = PRIMES.get(side % PRIMES.len()).map_or(0.5, |p| p.sqrt());
    (f64::from(number) * root * (1.0 + (side / PRIMES.len()) as f64)).fract()
}
