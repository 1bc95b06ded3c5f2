//! Developable surfaces: patches of enveloped surfaces, tangent surfaces, Hermite cones, certificates.

mod certificate;
mod connect;
mod enclosure;
mod ends;
mod extent;
mod forms;
mod hermite;
mod itself;
mod linear;
mod measures;
mod meeting;
mod oblique;
mod passage;
mod patch;
mod proof;
mod resolve;
mod strip;

pub use certificate::{PatchCertificate, Singularity, Worst, certify};
pub use connect::{
    BestRuling, Branch, BranchEnd, BranchReason, ConnectingPatch, Connections, NODE_RADIUS,
    ParameterBox, RailGap, connect,
};
pub(crate) use connect::{Landscape, Node, Step, StepKind, Way, all_branches, may_exist, ways};
pub use enclosure::{Enclosed, EnclosedCertificate, enclose, enclose_by_models};
pub(crate) use ends::regular_end;
pub(crate) use extent::Extent;
pub use forms::RulingForms;
pub use hermite::{HermiteCone, QuarticData, QuinticData, cone_system};
pub use itself::SelfIntersection;
pub(crate) use itself::self_intersection;
pub use linear::solve;
pub use oblique::{oblique_image, oblique_image_as_printed};
pub use passage::{PieceIntersection, SheetPiercing};
pub(crate) use passage::{piece_intersection, piercings};
pub(crate) use patch::unit_plane;
pub use patch::{EnvelopingPatch, PatchBounds, TangentPatch};
pub use proof::{Developability, Regularity, prove_developable, prove_regular, twist_determinant};
