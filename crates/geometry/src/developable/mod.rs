//! Developable surfaces: patches of enveloped surfaces, tangent surfaces, Hermite cones, certificates
//! and flat patterns.

mod hermite;
mod linear;
mod oblique;
mod patch;

pub use hermite::{HermiteCone, QuarticData, QuinticData};
pub use linear::solve;
pub use oblique::{oblique_image, oblique_image_as_printed};
pub use patch::{Bounds, EnvelopingPatch, TangentPatch};
