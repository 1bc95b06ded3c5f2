//! Surfaces as CAD systems hold them: B-splines, rational or not, each with the distance from its original
//! that is proved.

mod approximate;
mod exact;
mod hermite;
mod homogeneous;
mod model;
mod patch;
mod sheet;

pub use approximate::{ConvexBasis, approximate, approximate_tensor};
pub use exact::{BezierForm, ExactForm, HomogeneousRail, PolynomialBasis, convert};
pub use model::CadModel;
pub(crate) use model::Face;
pub(crate) use patch::BsplineCurve;
pub use patch::{BsplinePatch, Knots};

/// B-spline patches that together are a surface, within a proved distance.
#[derive(Debug, Clone, PartialEq)]
pub struct Converted {
    /// The patches, from `u = 0` to `u = 1`.
    pub patches: Vec<BsplinePatch>,
    /// No point of the patches is farther from the surface than this, and no point of the surface farther
    /// from the patches, in millimetres: a bound that is proved, not an estimate. Of an
    /// [exact form](ExactForm) it is the rounding of the control points and weights to doubles.
    pub error: f64,
}

impl Converted {
    /// The same patches, declared developable: for surfaces that were measured or proved to be so.
    #[must_use]
    pub fn declared_developable(self) -> Self {
        let patches = self.patches.into_iter();
        Self {
            patches: patches.map(BsplinePatch::declared_developable).collect(),
            ..self
        }
    }
}

/// A bound for `value`, which f64 arithmetic of a few dozen operations on nonnegative numbers gave.
fn rounded_up(value: f64) -> f64 {
    // Each operation is off by at most 2^-53 of its result, or by the least positive number.
    value * (1.0 + 1e-13) + 1e-300
}

/// A bound for the length of the vector whose coordinates are at most these in size.
fn length_bound(sizes: [f64; 3]) -> f64 {
    let largest = sizes.into_iter().fold(0.0_f64, f64::max);
    if largest == 0.0 || !largest.is_finite() {
        return largest;
    }
    let square: f64 = sizes.iter().map(|x| (x / largest) * (x / largest)).sum();
    rounded_up(largest * square.sqrt())
}
