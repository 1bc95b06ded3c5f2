//! What cannot be computed by sums and products: interpolated, then proved by a residual.
//!
//! | wanted | taken | proved by |
//! |---|---|---|
//! | `y = f/g` | interpolant | `abs(y - f/g) <= max abs(y g - f) / min abs(g)` |
//! | `y = sqrt(g)` | interpolant | `abs(y - sqrt(g)) <= max abs(y^2 - g) / (min y + sqrt(min g))` |

use super::{Model, up};

impl Model {
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
}
