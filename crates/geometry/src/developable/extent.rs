//! The size of a patch, so that its numbers can be brought near one.

use crate::coordinate::Coordinate;
use crate::surface::Rails;

/// The longest ruling and the greatest speed of a rail, in powers of two.
///
/// The products of a certificate are of degree up to eight in the coordinates: of a part of a size of
/// `1e-60` they would vanish, of `1e60` they would leave the range of f64. So lengths are measured in units of
/// `2^length` and speeds in units of `2^speed`; both are exact changes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extent {
    /// `2^length` is not above the longest sampled ruling, and `2^(length + 1)` not far below.
    pub length: i32,
    /// The same of the derivatives of the rails.
    pub speed: i32,
}

impl Extent {
    /// Lengths and speeds as they are.
    pub(super) const ONE: Self = Self {
        length: 0,
        speed: 0,
    };

    /// The extent of a patch on nine rulings at equal steps, of which those that do not exist are left out;
    /// `number` makes the parameters. `None` when all have length zero or both rails stand still.
    pub(crate) fn measure<S: Coordinate, R: Rails<S> + ?Sized>(
        patch: &R,
        number: impl Fn(f64) -> S,
    ) -> Option<Self> {
        let (mut length, mut speed) = (0.0_f64, 0.0_f64);
        let farthest = |size: f64, c: S| size.max(c.approximate().abs());
        for x in (0..=8).map(|n| f64::from(n) / 8.0) {
            let Ok([p, q]) = patch.rail_jets(&number(x), 1) else {
                continue;
            };
            for (p, q) in p.iter().zip(&q) {
                length = farthest(length, q.value().clone() - p.value().clone());
                let slopes = [p, q]
                    .into_iter()
                    .filter_map(|jet| jet.coefficients().get(1));
                speed = slopes.cloned().fold(speed, farthest);
            }
        }
        Some(Self {
            length: length.min(f64::MAX).exponent()?,
            speed: speed.min(f64::MAX).exponent()?,
        })
    }

    /// A length in the units of the patch.
    pub(super) fn length(&self, reduced: f64) -> f64 {
        reduced.times_two_to(self.length)
    }

    /// A Gaussian curvature in the units of the patch.
    pub(super) fn curvature(&self, reduced: f64) -> f64 {
        reduced
            .times_two_to(-self.length)
            .times_two_to(-self.length)
    }
}
