//! The part of an envelope that is a sheet.

use crate::developable::PatchBounds;
use crate::planes::Plane;

/// What part of each ruling of an envelope belongs to a sheet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut(pub(super) PatchBounds<f64>);

impl Cut {
    /// Returns the part between two planes.
    #[must_use]
    pub fn between(first: Plane<f64>, second: Plane<f64>) -> Self {
        Self(PatchBounds::Planes([first, second]))
    }

    /// Returns a range of the ruling parameter of gbt-developable eq. (3.7), in units of `a x a'`.
    #[must_use]
    pub fn range(from: f64, to: f64) -> Self {
        Self(PatchBounds::Range([from, to]))
    }
}
