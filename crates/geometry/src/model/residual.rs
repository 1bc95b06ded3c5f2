//! What cannot be computed by sums and products: interpolated, then proved by a residual.
//!
//! | wanted | taken | proved by |
//! |---|---|---|
//! | `y = f/g` | interpolant | `abs(y - f/g) <= max abs(y g - f) / min abs(g)` |
//! | `y = sqrt(g)` | interpolant | `abs(y - sqrt(g)) <= max abs(y^2 - g) / (min y + sqrt(min g))` |
//! | `z = exp(i theta)` | interpolant | `abs(z - exp(i theta)) <= width * max abs(z' - i theta' z)`, where both start alike |

use super::{ChebyshevModel, rounding, up};
use crate::chebyshev::NODES;
use std::f64::consts::PI;

/// Angles beyond so many quarter turns have no sine here: their rounding grows with them.
const MOST_TURNS: f64 = 8.0;

impl ChebyshevModel {
    /// `self/divisor`; `None` where the divisor may vanish.
    #[must_use]
    pub fn quotient(&self, divisor: &Self) -> Option<Self> {
        let least = divisor.least();
        if least.is_nan() || least <= 0.0 || !self.largest().is_finite() {
            return None;
        }
        if self.is_exact_zero() {
            return Some(*self);
        }
        if divisor.degree == 0 && divisor.radius == 0.0 {
            let value = divisor.coefficients[0];
            if value.abs() == 1.0 {
                return Some(self.scaled_by(value));
            }
            let quotient = self.scaled_by(1.0 / value);
            // The reciprocal is rounded too.
            return Some(quotient.widened(2.0 * f64::EPSILON * quotient.size()));
        }
        let (f, g) = (self.at_nodes(), divisor.at_nodes());
        let y = Self::through(&std::array::from_fn(|k| f[k] / g[k]));
        let residual = (y * *divisor - *self).largest();
        let radius = up(residual / least);
        radius.is_finite().then(|| y.widened(radius))
    }

    /// The square root; `None` where the model may not be positive.
    #[must_use]
    pub fn root(&self) -> Option<Self> {
        let [low, _] = self.range();
        if low.is_nan() || low <= 0.0 {
            return None;
        }
        let y = Self::through(&self.at_nodes().map(f64::sqrt));
        let residual = (y * y - *self).largest();
        let [least, _] = y.range();
        // The root of the lower bound, rounded down.
        let below = least.max(0.0) + low.sqrt() * (1.0 - 4.0 * f64::EPSILON);
        let radius = up(residual / below);
        radius.is_finite().then(|| y.widened(radius))
    }

    /// `[cos(theta), sin(theta)]` for the angle `theta` that starts from zero at the left end of an interval of this
    /// half width and grows as the polynomial of `turn`. The radius of `turn` is not counted.
    pub(crate) fn direction(turn: &Self, half: f64) -> Option<[Self; 2]> {
        let turn = turn.polynomial();
        let theta = turn.integral(half);
        let angles = theta.at_nodes();
        // Exactly the start.
        let start = angles[0];
        let mut values = [[0.0; NODES]; 2];
        for (k, angle) in angles.into_iter().enumerate() {
            let (s, c) = libm::sincos(angle - start);
            (values[0][k], values[1][k]) = (c, s);
        }
        let [c, s] = values.each_ref().map(Self::through);
        let off = [
            (c.slope_of_polynomial(half) + turn * s).largest(),
            (s.slope_of_polynomial(half) - turn * c).largest(),
        ];
        let at_start = [c.at(-1.0) - 1.0, s.at(-1.0)];
        let started =
            libm::hypot(at_start[0], at_start[1]) + 32.0 * f64::EPSILON * (c.size() + s.size());
        let radius = up(started + 2.0 * half * (off[0] + off[1]));
        radius
            .is_finite()
            .then(|| [c, s].map(|f| f.widened(radius)))
    }

    /// The sine and the cosine of this many quarter turns, of a polynomial of any degree: its derivative turns a unit
    /// vector from the angle at the left end on.
    pub(super) fn turn_of_any_degree(&self) -> Option<(Self, Self)> {
        let start = self.polynomial().at(-1.0);
        if start.is_nan() || start.abs() > MOST_TURNS {
            return None;
        }
        let quarter = Self::exact(0.5 * PI).widened(f64::EPSILON);
        let turn = self.slope_of_polynomial(1.0) * quarter;
        let [c, s] = Self::direction(&turn, 1.0)?;
        let angle = 0.5 * PI * start;
        let (sine, cosine) = libm::sincos(angle);
        // The angle at the left end, what the polynomial of the derivative misses over the whole width, and the radius.
        let begun =
            2.0 * rounding(NODES + 2) * self.size() + 4.0 * f64::EPSILON * (1.0 + angle.abs());
        let off = up(begun + 2.0 * turn.radius + 0.5 * PI * self.radius);
        let [sine, cosine] = [sine, cosine].map(|value| Self::exact(value).widened(f64::EPSILON));
        off.is_finite().then(|| {
            (
                (s * cosine + c * sine).widened(off),
                (c * cosine - s * sine).widened(off),
            )
        })
    }
}
