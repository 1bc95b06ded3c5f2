//! The attributes of a surface at one of its places.

use crate::space::vector::{V3, lerp};

/// A vertex of a surface in space, with the attributes that vary over the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Corner {
    pub at: V3,
    pub normal: V3,
    /// Parameters in 0..=1.
    pub uv: [f64; 2],
    pub value: f64,
}

impl Corner {
    pub(crate) fn lerp(&self, other: &Corner, t: f64) -> Corner {
        Corner {
            at: lerp(self.at, other.at, t),
            normal: lerp(self.normal, other.normal, t),
            uv: [0, 1].map(|k| self.uv[k] + t * (other.uv[k] - self.uv[k])),
            value: self.value + t * (other.value - self.value),
        }
    }
}
