//! Developable surfaces: patches of enveloped surfaces, tangent surfaces, Hermite cones, certificates
//! and flat patterns.

mod bounds;
mod certificate;
mod enclosure;
mod hermite;
mod linear;
mod oblique;
mod patch;
mod proof;
mod unroll;

pub use certificate::{Certificate, Worst, certify};
pub use enclosure::{Enclosed, EnclosedCertificate, enclose};
pub use hermite::{HermiteCone, QuarticData, QuinticData, cone_system};
pub use linear::solve;
pub use oblique::{oblique_image, oblique_image_as_printed};
pub use patch::{Bounds, EnvelopingPatch, TangentPatch};
pub use proof::{Developability, Regularity, prove_developable, prove_regular, twist_determinant};
pub use unroll::{FlatPattern, unroll};
