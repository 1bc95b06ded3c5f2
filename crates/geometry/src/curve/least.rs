//! The least value of a function along a curve, between bounds.
//!
//! Branch and bound on balls: over an interval of half width `w` about its middle `m` a function is its Taylor
//! polynomial at `m` with the last coefficient taken over the interval (Lagrange), whose excess falls with `w^ORDER`.
//! The interval with the lowest bound is halved until that bound is near a value that is attained.

use super::SpaceCurve;
use crate::dyadic::middle_of;
use crate::error::{GeometryError, Result};
use torse_algebra::rational::{Rational, integer, to_f64};
use torse_algebra::{Ball, Jet};

/// The order of the Taylor form.
const ORDER: usize = 4;
/// The most intervals.
const MAX_CELLS: usize = 1 << 12;

/// A least value `low <= least <= high`, and a parameter at which the value is not above `high`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Least {
    pub(crate) low: f64,
    pub(crate) high: f64,
    pub(crate) x: f64,
}

/// The least `value` of the points of a curve over [0, 1], as soon as the difference of its bounds, each as `measured`,
/// is not above `accuracy`. What is measured has to grow with the value.
///
/// # Errors
/// [`GeometryError::NotConverged`] where they do not come so close, and what the curve refuses.
pub(crate) fn least(
    curve: &impl SpaceCurve<Ball>,
    bits: usize,
    value: impl Fn(&[Jet<Ball>; 3]) -> Jet<Ball>,
    measured: impl Fn(f64) -> f64,
    accuracy: f64,
) -> Result<Least> {
    let at = |x: &Rational| -> Result<(f64, f64)> {
        let jets = curve.space_jet(&Ball::from_rational(x, bits), 0)?;
        let (_, high) = value(&jets).value().to_f64_bounds();
        Ok((high, to_f64(x)))
    };
    let lower = |a: (f64, f64), b: (f64, f64)| if b.0 < a.0 { b } else { a };
    let range = |from: &Rational, to: &Rational| -> Result<f64> {
        let middle = middle_of(from, to);
        let half = to.clone() - middle.clone();
        let reach = Ball::from_bounds(&-half.clone(), &half, bits);
        let at_middle = value(&curve.space_jet(&Ball::from_rational(&middle, bits), ORDER)?);
        let over = value(&curve.space_jet(&Ball::from_bounds(from, to, bits), ORDER)?);
        let coefficients = at_middle.coefficients().iter().take(ORDER);
        let last = over.coefficients().get(ORDER);
        let terms = coefficients.chain(last).zip(0..);
        let sum = terms.fold(None, |sum: Option<Ball>, (c, n)| {
            let term = c.clone() * reach.powi(n);
            Some(sum.map_or(term.clone(), |sum| sum + term))
        });
        // Of a function that is as good as constant the plain range is tighter.
        let plain = over.value().to_f64_bounds().0;
        Ok(sum.map_or(plain, |sum| plain.max(sum.to_f64_bounds().0)))
    };
    // Where an interval is too wide for an enclosure, of weights for instance, nothing is known before it is halved.
    let low_over = |from: &Rational, to: &Rational| range(from, to).unwrap_or(f64::NEG_INFINITY);
    let (zero, one) = (integer(0), integer(1));
    let mut attained = lower(at(&zero)?, at(&one)?);
    let mut open = vec![(low_over(&zero, &one), zero, one)];
    loop {
        let lowest = open.iter().map(|(low, ..)| *low).enumerate();
        let Some((index, low)) = lowest.min_by(|a, b| a.1.total_cmp(&b.1)) else {
            return Err(GeometryError::TooFew {
                what: "intervals",
                needed: 1,
                given: 0,
            });
        };
        let (high, x) = attained;
        let apart = measured(high) - measured(low);
        if apart <= accuracy {
            return Ok(Least { low, high, x });
        }
        if open.len() >= MAX_CELLS {
            return Err(GeometryError::NotConverged {
                what: "least value along a curve",
                reached: apart,
                demanded: accuracy,
            });
        }
        let (_, from, to) = open.swap_remove(index);
        let middle = middle_of(&from, &to);
        attained = lower(attained, at(&middle)?);
        open.push((low_over(&from, &middle), from, middle.clone()));
        open.push((low_over(&middle, &to), middle, to));
    }
}
