//! Quintic Hermite splines with a proved error.
//!
//! Let `p` be the quintic with the values and first two derivatives of `f` at both ends of an interval of half
//! width `w`. Along any unit vector `f - p` is a function with two threefold zeros, so (Rolle) it is
//! `f^(6)(s)/6! (x - a)^3 (x - b)^3` for some `s`, and `|(x - a)(x - b)| <= w^2`. Hence
//!
//! ```text
//! |f(x) - p(x)| <= w^6 sup |f^(6)/6!|,
//! ```
//!
//! where the supremum is bounded by the sixth Taylor coefficient of `f` on the ball that is the interval.
//! Neighbouring quintics share value, slope and second derivative: together they are a C2 spline with
//! threefold knots. Its control points are values of the blossom (polar form) at three times a break `t` and
//! twice its neighbours `x, y`,
//!
//! ```text
//! P = f(t) + f'(t) ((x - t) + (y - t))/5 + f''(t)/2 (x - t)(y - t)/10,
//! ```
//!
//! and since B-splines are nonnegative with sum one, rounding the control points moves no point farther than
//! it moves the worst of them.

use super::{length_bound, rounded_up};
use crate::error::{ExchangeError, Result};
use std::collections::HashMap;
use torse_algebra::rational::{Rational, integer, to_f64};
use torse_algebra::{Ball, Jet, Scalar};
use torse_geometry::exact;

/// Binary digits after the point in the proofs.
pub(super) const BITS: usize = 160;
/// The most pieces.
const MAX_PIECES: usize = 4096;
/// How often an interval is halved at most.
const MAX_DEPTH: u32 = 20;
/// How often an interval is halved to bound its sixth Taylor coefficient.
const FINER: u32 = 5;
/// The part of the tolerance that is for the shape; the rest is for rounding.
const SHARE: f64 = 0.999;

/// Several curves approximated on the same breaks.
pub(super) struct Splines {
    pub(super) breaks: Vec<f64>,
    /// The control points of each curve: three for each break.
    pub(super) points: Vec<Vec<[f64; 3]>>,
    /// No point of a curve is farther from that of the spline at the same parameter.
    pub(super) error: f64,
}

/// The Taylor series of several curves at (or, of a wide ball, over) a parameter.
pub(super) type Series<'a> =
    dyn Fn(&Ball, usize) -> torse_geometry::Result<Vec<[Jet<Ball>; 3]>> + 'a;

/// The splines of the curves within the tolerance.
///
/// # Errors
/// [`ExchangeError::NotReached`], and what the curves refuse at the ends.
pub(super) fn splines(series: &Series, tolerance: f64) -> Result<Splines> {
    if !(tolerance.is_finite() && tolerance > 0.0) {
        return Err(ExchangeError::OutOfRange {
            name: "tolerance",
            value: tolerance,
            range: "(0, inf)",
        });
    }
    // A curve that does not exist at an end says so itself.
    let first = series(&Ball::from_rational(&integer(0), BITS), 2)?;
    series(&Ball::from_rational(&integer(1), BITS), 2)?;

    let mut sixth = Sixth {
        series,
        known: HashMap::new(),
    };
    let mut breaks = vec![0.0];
    let mut error = 0.0_f64;
    // Ends are dyadic, so doubles hold them exactly.
    let mut open = vec![(0.0_f64, 1.0_f64, 0)];
    while let Some((from, to, depth)) = open.pop() {
        let sixth_power = (0.5 * (to - from)).powi(6);
        let limit = SHARE * tolerance / sixth_power;
        let bound = sixth.bound(from, to, limit, FINER.min(MAX_DEPTH - depth));
        if bound <= limit {
            error = error.max(rounded_up(bound * sixth_power));
            breaks.push(to);
            continue;
        }
        if depth == MAX_DEPTH || breaks.len() + open.len() >= MAX_PIECES {
            return Err(ExchangeError::NotReached {
                demanded: tolerance,
                from,
                to,
            });
        }
        let middle = 0.5 * (from + to);
        open.extend([(middle, to, depth + 1), (from, middle, depth + 1)]);
    }

    let mut points = vec![Vec::with_capacity(3 * breaks.len()); first.len()];
    let mut rounding = 0.0_f64;
    for (i, &t) in breaks.iter().enumerate() {
        let before = i.checked_sub(1).and_then(|i| breaks.get(i)).copied();
        let (before, after) = (before.unwrap_or(t), breaks.get(i + 1).copied().unwrap_or(t));
        let curves = series(&Ball::from_rational(&exact(t), BITS), 2)?;
        for (list, jets) in points.iter_mut().zip(&curves) {
            for [x, y] in [[before, before], [before, after], [after, after]] {
                let ball = jets.each_ref().map(|jet| blossom(jet, x - t, y - t));
                let (point, moved) = nearest(&ball);
                rounding = rounding.max(moved);
                list.push(point);
            }
        }
    }
    let error = rounded_up(error + rounding);
    // Not so for NaN either.
    if error <= tolerance {
        return Ok(Splines {
            breaks,
            points,
            error,
        });
    }
    Err(ExchangeError::NotReached {
        demanded: tolerance,
        from: 0.0,
        to: 1.0,
    })
}

/// The sixth Taylor coefficients of curves, bounded over intervals.
struct Sixth<'a> {
    series: &'a Series<'a>,
    /// Bounds on balls, by the ends of the interval: a piece that is refused leaves them to its halves.
    known: HashMap<[u64; 2], f64>,
}

impl Sixth<'_> {
    /// A bound for the interval that is at most `limit`, or infinity when none was found. The ball of a
    /// wide interval forgets that numerators and denominators move together, so the interval is halved
    /// up to `depth` times.
    fn bound(&mut self, from: f64, to: f64, limit: f64, depth: u32) -> f64 {
        let direct = self.direct(from, to);
        if direct <= limit {
            return direct;
        }
        let middle = 0.5 * (from + to);
        // What is above the limit at a point is so on every interval around it.
        if depth == 0 || self.direct(middle, middle) > limit {
            return f64::INFINITY;
        }
        let left = self.bound(from, middle, limit, depth - 1);
        if left.is_infinite() {
            return left;
        }
        left.max(self.bound(middle, to, limit, depth - 1))
    }

    /// The bound on the ball that is the interval, over all curves.
    fn direct(&mut self, from: f64, to: f64) -> f64 {
        let key = [from.to_bits(), to.to_bits()];
        if let Some(known) = self.known.get(&key) {
            return *known;
        }
        let interval = Ball::from_bounds(&exact(from), &exact(to), BITS);
        let size = |jet: &Jet<Ball>| jet.coefficients().get(6).map_or(f64::INFINITY, magnitude);
        let worst = |curves: Vec<[Jet<Ball>; 3]>| {
            let lengths = curves
                .iter()
                .map(|jets| length_bound(jets.each_ref().map(size)));
            lengths.fold(0.0, |worst: f64, length| {
                if length.is_nan() {
                    f64::INFINITY
                } else {
                    worst.max(length)
                }
            })
        };
        let bound = (self.series)(&interval, 6).map_or(f64::INFINITY, worst);
        self.known.insert(key, bound);
        bound
    }
}

/// The largest absolute value in a ball.
fn magnitude(ball: &Ball) -> f64 {
    let (low, high) = ball.to_f64_bounds();
    low.abs().max(high.abs())
}

/// The polar form of the quintic with this 2-jet, three arguments at its place and two at distances `x, y`.
fn blossom(jet: &Jet<Ball>, x: f64, y: f64) -> Ball {
    let (x, y) = (exact(x), exact(y));
    let part = |q: Rational, n: i64| q * Rational::new(1.into(), n.into());
    let factors = [integer(1), part(x.clone() + y.clone(), 5), part(x * y, 10)];
    let like = jet.value();
    let terms = jet.coefficients().iter().zip(factors);
    terms
        .map(|(c, factor)| c.clone() * like.constant(&factor))
        .reduce(|sum, term| sum + term)
        .unwrap_or_else(|| like.clone())
}

/// The doubles nearest to the middle of a point's ball, and how far they may be from the point.
fn nearest(ball: &[Ball; 3]) -> ([f64; 3], f64) {
    let point = ball.each_ref().map(|x| to_f64(&x.midpoint()) + 0.0);
    let off = |x: &Ball, value: f64| {
        let value = Ball::from_rational(&exact(value), BITS);
        magnitude(&(x.clone() - value))
    };
    let off = [0, 1, 2].map(|k| off(&ball[k], point[k]));
    (point, length_bound(off))
}
