//! The four quantities of a certificate as functions of one ruling, with bounds for balls.
//!
//! With rails `P, Q`, ruling `R = Q - P` and normals `N0 = P' x R`, `N1 = Q' x R` at its ends, five functions
//! of `x` say everything:
//!
//! ```text
//! D = det(P', Q', R),   a = |N0|^2,   b = |N1|^2,   h = N0 . N1,   r = |R|^2
//!
//! normalised determinant   |D| / (|P'| |Q'| |R|)
//! twist                    tan = |N0 x N1| / |h| = sqrt(r) |D| / |h|
//! least |N(v)|^2           max(min(a, h, b), r D^2/(a + b - 2h)),   N(v) = (1 - v) N0 + v N1
//! Gaussian curvature       |K| = D^2 / |N|^4, largest where |N| is least
//! clearance                sqrt(r) (h - min(a, b)) / (a + b - 2h)
//! ```
//!
//! `|N(v)|^2` is the quadratic with the Bernstein coefficients `a, h, b`, which lies above the least of them;
//! its free minimum is `(a b - h^2)/(a + b - 2h)`, and `a b - h^2 = r D^2`. One of the two is attained. With
//! `m = min(sqrt a, sqrt b)`, `e = |sqrt a - sqrt b| = |a - b|/(sqrt a + sqrt b)` and `d = sqrt(a b) - h = r D^2/(sqrt(a b) + h)` the clearance is
//! `sqrt(r) (m e - d)/(e^2 + 2d)`: no cancellation, rising in `m`, falling in `d` and with one summit in `e`,
//! so its bounds are at the ends.

use crate::coordinate::{Coordinate, is_zero};
use crate::surface::Rails;
use crate::vector::{cross, det, dot, sub};
use std::cmp::Ordering;
use torse_algebra::{Ball, Jet, Rational, Scalar, rational::integer};

/// Determinant, twist, Gaussian curvature, and the clearance with its sign changed: all to be maximised.
pub(super) const QUANTITIES: usize = 4;
pub(super) const CLEARANCE: usize = 3;

/// Bounds `[low, high]` of each quantity.
pub(super) type Bounds = [[f64; 2]; QUANTITIES];

/// What holds of any patch, and of any developable.
pub(super) fn trivial(developable: bool) -> Bounds {
    let most = if developable { 0.0 } else { 1.0 };
    [
        [0.0, most],
        [0.0, most * std::f64::consts::FRAC_PI_2],
        [0.0, f64::INFINITY],
        [f64::NEG_INFINITY, f64::INFINITY],
    ]
}

/// The order of the Taylor form.
pub(super) const ORDER: usize = 6;

/// The functions of the module's head, with `|P'|^2` and `|Q'|^2`.
pub(super) struct Functions<T> {
    determinant: T,
    h: T,
    a: T,
    b: T,
    /// `a - b`: of its own, because the ranges of `a` and `b` forget that both grow together.
    change: T,
    ruling: T,
    slopes: [T; 2],
}

impl Functions<Jet<Ball>> {
    /// The Taylor series to this order at (or, of a wide ball, over) `x`.
    pub(super) fn of(patch: &impl Rails<Ball>, x: &Ball, order: usize) -> Option<Self> {
        let [p, q] = patch.rail_jets(x, order + 1).ok()?;
        let (dp, dq) = (slope(&p)?, slope(&q)?);
        let r = sub(&q, &p);
        let (n0, n1) = (cross(&dp, &r), cross(&dq, &r));
        let determinant = if patch.is_developable_by_construction() {
            dp[0].constant_like(x.zero())
        } else {
            det(&dp, &dq, &r)
        };
        let (a, b) = (dot(&n0, &n0), dot(&n1, &n1));
        Some(Self {
            determinant,
            h: dot(&n0, &n1),
            change: a.clone() - b.clone(),
            a,
            b,
            ruling: dot(&r, &r),
            slopes: [dot(&dp, &dp), dot(&dq, &dq)],
        })
    }

    /// The ranges over the interval of half width `reach` about the point of `self`.
    pub(super) fn taylor(&self, over: &Self, reach: &Ball) -> Functions<Ball> {
        let form = |at: &Jet<Ball>, over: &Jet<Ball>| {
            let coefficients = at.coefficients().iter().take(ORDER);
            let last = over.coefficients().get(ORDER);
            coefficients
                .chain(last)
                .zip(0..)
                .map(|(c, n)| c.clone() * reach.powi(n))
                .reduce(|sum, term| sum + term)
                .unwrap_or_else(|| over.value().clone())
        };
        Functions {
            determinant: form(&self.determinant, &over.determinant),
            h: form(&self.h, &over.h),
            a: form(&self.a, &over.a),
            b: form(&self.b, &over.b),
            change: form(&self.change, &over.change),
            ruling: form(&self.ruling, &over.ruling),
            slopes: [0, 1].map(|i| form(&self.slopes[i], &over.slopes[i])),
        }
    }

    pub(super) fn map(&self, f: impl Fn(&Jet<Ball>) -> Ball) -> Functions<Ball> {
        Functions {
            determinant: f(&self.determinant),
            h: f(&self.h),
            a: f(&self.a),
            b: f(&self.b),
            change: f(&self.change),
            ruling: f(&self.ruling),
            slopes: self.slopes.each_ref().map(f),
        }
    }
}

fn slope(curve: &[Jet<Ball>; 3]) -> Option<[Jet<Ball>; 3]> {
    let [x, y, z] = curve.each_ref().map(Jet::differentiated);
    Some([x?, y?, z?])
}

impl Functions<Ball> {
    /// Bounds of the four quantities; `None` where squares come out negative, which does not happen.
    pub(super) fn bounds(&self) -> Option<Bounds> {
        let [a, b, r] = [&self.a, &self.b, &self.ruling].map(nonnegative);
        let d = self.determinant.abs();
        let turned = r.sqrt().ok()? * d.clone();
        Some([
            self.determinant_bounds(&d, &r),
            angle_bounds(&turned, &self.h.abs()),
            curvature_bounds(&d, &least_normal([&a, &self.h, &b], &turned)),
            negated(self.clearance_bounds([&a, &b], &r, &turned)?),
        ])
    }

    fn determinant_bounds(&self, d: &Ball, r: &Ball) -> [f64; 2] {
        let [p, q] = self.slopes.each_ref().map(nonnegative);
        if is_zero(d) {
            return [0.0, 0.0];
        }
        let square = (d.clone() * d.clone()).divided_by(&(p * q * r.clone()));
        match square.and_then(|s| nonnegative(&s).sqrt()) {
            Ok(ratio) => {
                let (low, high) = ratio.to_f64_bounds();
                [low.min(1.0), high.min(1.0)]
            }
            Err(_) => [0.0, 1.0],
        }
    }

    /// `sqrt(r) (m e - d)/(e^2 + 2 d)`, see the module.
    fn clearance_bounds(&self, [a, b]: [&Ball; 2], r: &Ball, turned: &Ball) -> Option<[f64; 2]> {
        let h = &self.h;
        let (root_a, root_b, length) = (a.sqrt().ok()?, b.sqrt().ok()?, r.sqrt().ok()?);
        // Inside, the place is at most half a ruling from both ends.
        let deepest = -0.5 * length.to_f64_bounds().1;
        match h.sign() {
            Some(Ordering::Greater) => {}
            Some(Ordering::Less) => {
                let below = a.clone() + b.clone() - (h.clone() + h.clone());
                let ratio = (h.clone() - minimum(a, b)).divided_by(&below).ok()?;
                let (low, high) = (ratio * length).to_f64_bounds();
                return Some([low.max(deepest), high]);
            }
            _ => return Some([deepest, f64::INFINITY]),
        }
        let m = minimum(&root_a, &root_b);
        let e = self
            .change
            .abs()
            .divided_by(&(root_a.clone() + root_b.clone()))
            .ok()?;
        let defect = (turned.clone() * turned.clone())
            .divided_by(&(root_a * root_b + h.clone()))
            .map(|d| nonnegative(&d))
            .ok()?;
        let bits = m.bits();
        let point = |value: &Rational| Ball::from_rational(value, bits);
        let ratio = |m: Ball, e: Ball, d: Ball| {
            let below = e.clone() * e.clone() + d.clone() + d.clone();
            (m * e - d).divided_by(&below)
        };
        let mut low = f64::INFINITY;
        for end in [e.lower(), e.upper()] {
            // Where e and d are zero the rulings are parallel: they meet nowhere.
            if let Ok(value) = ratio(point(&m.lower()), point(&end), point(&defect.upper())) {
                low = low.min((value * length.clone()).to_f64_bounds().0);
            } else if !is_zero(&point(&end)) || !is_zero(&point(&defect.upper())) {
                return Some([deepest, f64::INFINITY]);
            }
        }
        let high = match ratio(m, e, defect) {
            Ok(value) => (value * length).to_f64_bounds().1,
            Err(_) => f64::INFINITY,
        };
        Some([low, high])
    }
}

/// The angle with this sine and cosine, both up to a common factor and not negative.
fn angle_bounds(sine: &Ball, cosine: &Ball) -> [f64; 2] {
    let ((s_low, s_high), (c_low, c_high)) = (sine.to_f64_bounds(), cosine.to_f64_bounds());
    // The arc tangent of the library is good to one unit in the last place; two are allowed for.
    let low = s_low.max(0.0).atan2(c_high).next_down().next_down();
    let high = s_high.max(0.0).atan2(c_low.max(0.0));
    let high = if high > 0.0 {
        high.next_up().next_up()
    } else {
        0.0
    };
    [low.max(0.0), high]
}

/// The least `|N(v)|^2` on the ruling: `max(min(a, h, b), |N0 x N1|^2/(a + b - 2h))`.
fn least_normal([a, h, b]: [&Ball; 3], turned: &Ball) -> Ball {
    let least_coefficient = minimum(&minimum(a, h), b);
    let bend = a.clone() + b.clone() - (h.clone() + h.clone());
    match (turned.clone() * turned.clone()).divided_by(&bend) {
        Ok(free) => maximum(&least_coefficient, &nonnegative(&free)),
        // The true value is not below the coefficient, nor above the ends.
        Err(_) => least_coefficient.hull(&minimum(a, b)),
    }
}

fn curvature_bounds(d: &Ball, normal_squared: &Ball) -> [f64; 2] {
    let quotient =
        (d.clone() * d.clone()).divided_by(&(normal_squared.clone() * normal_squared.clone()));
    match (normal_squared.sign(), quotient) {
        (Some(Ordering::Greater), Ok(curvature)) => {
            let (low, high) = curvature.to_f64_bounds();
            // Plus zero: no negative zero.
            [low.max(0.0), high + 0.0]
        }
        (Some(Ordering::Equal | Ordering::Less), _) => [f64::INFINITY, f64::INFINITY],
        _ => [0.0, f64::INFINITY],
    }
}

fn negated([low, high]: [f64; 2]) -> [f64; 2] {
    [-high, -low]
}

/// The part of a ball that is not negative, for squares that rounding pushed below zero.
fn nonnegative(ball: &Ball) -> Ball {
    let end = |end: Rational| end.max(integer(0));
    Ball::from_bounds(&end(ball.lower()), &end(ball.upper()), ball.bits())
}

fn minimum(a: &Ball, b: &Ball) -> Ball {
    let (low, high) = (a.lower().min(b.lower()), a.upper().min(b.upper()));
    Ball::from_bounds(&low, &high, a.bits())
}

fn maximum(a: &Ball, b: &Ball) -> Ball {
    let (low, high) = (a.lower().max(b.lower()), a.upper().max(b.upper()));
    Ball::from_bounds(&low, &high, a.bits())
}
