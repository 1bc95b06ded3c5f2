//! Rails, plane families and sheets over f64, to be used without the generic layer.
//!
//! ```
//! use torse_geometry::prelude::*;
//! ```
//!
//! brings all of it. Points are `[f64; 3]`, planes `[f64; 4]` (`p X + q Y + r Z = s`), parameters plain numbers in
//! [0, 1], lengths in the unit of the points, angles in radians; nothing is passed by reference that could be
//! copied. Tolerances belong to questions ("C2 within 1e-9"), never to objects.
//!
//! | you want | take |
//! |---|---|
//! | a space curve | [`Rail::bezier`], [`Rail::gbt`], [`Rail::hermite`], [`Rail::weighted`] |
//! | its box, its point nearest to another, its parts, a polygon | [`Rail::bounding_box`], [`Rail::nearest`], [`Rail::split`], [`Rail::polygon`] |
//! | a developable between two free curves | [`Sheet::between`]; with fans from end to end [`Sheet::panels`] |
//! | developable strips that cover a surface | [`StripCover`] |
//! | the envelope of planes | [`Planes`], [`Sheet::envelope`], [`Sheet::tangent`] |
//! | a Hermite patch between two planes | [`Sheet::hermite_cone`] |
//! | the next piece of a chain | [`Joint`], [`Planes::next`], [`Rail::next`] |
//! | to know whether it can be made | [`Sheet::certify`], [`Sheet::enclose`], [`Sheet::prove_regular`], [`Sheet::inspect`] |
//! | to know how smooth a joint is | [`Planes::joint_with`], [`Rail::joint_with`], [`Sheet::joint_with`] |
//! | where a curve lies on sheets, where rulings pierce them | [`SheetTracer`] |
//! | the flat pattern | [`Sheet::unroll`] |
//!
//! A developable between two free rails:
//!
//! ```
//! use torse_geometry::prelude::*;
//! let chine = Rail::bezier(&[[0.0, 0.0, 0.0], [2.0, 3.0, 0.0], [6.0, 0.0, 0.0]])?;
//! let deck = Rail::bezier(&[[0.5, 0.0, 2.0], [3.0, 2.0, 3.0], [6.0, -1.0, 2.0]])?;
//! let found = Sheet::between(&chine, &deck)?;
//! let plate = found.sheet.ok_or("no developable touches both rails")?;
//! let checked = plate.inspect(64)?;
//! assert!(checked.certificate.is_regular() && checked.certificate.is_developable_within(1e-7));
//! assert!(found.gaps.iter().all(|gap| gap.worst.twist > 0.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The envelope of planes, with bounds instead of estimates:
//!
//! ```
//! use torse_geometry::prelude::*;
//! let planes = Planes::gbt(0.5, 0.25, &[
//!     [7., -7., 5., 125.], [-7., -7., 5., 120.], [-7., 7., 5., 130.], [7., 7., 5., 125.],
//! ])?;
//! let sheet = Sheet::envelope(&planes, Cut::between([0., 0., 1., 0.], [0., 0., 1., 3.]))?;
//! let [bottom, top] = sheet.ruling(0.3)?;
//! assert!(bottom[2].abs() < 1e-12 && (top[2] - 3.0).abs() < 1e-12);
//! assert_eq!(sheet.prove_regular(MeasureBudget::default())?, Regularity::Regular);
//! # Ok::<(), torse_geometry::GeometryError>(())
//! ```
//!
//! A Hermite patch between two planes (of [`HermiteCone`](crate::HermiteCone)):
//!
//! ```
//! use torse_geometry::HermiteCone;
//! use torse_geometry::prelude::*;
//! let q = [[-20., 60., 45.], [-20., -50., 45.], [0., -30., 60.], [0., -50., -60.]];
//! let cone = HermiteCone::cubic([170., 0., 45.], 2.0, q)?;
//! let sheet = Sheet::hermite_cone(&cone)?;
//! assert!(sheet.certify(64)?.is_developable_within(1e-7));
//! // Cut by an oblique plane instead: the image curve is a weighted one.
//! let oblique = Sheet::cut_hermite_cone(&cone, [20., -3., 0., 1000.])?;
//! assert!(oblique.certify(64)?.is_developable_within(1e-7));
//! # Ok::<(), torse_geometry::GeometryError>(())
//! ```
//!
//! A chain of joined patches:
//!
//! ```
//! use torse_geometry::prelude::*;
//! let first = Planes::gbt(0.5, 0.25, &[
//!     [7., -7., 5., 125.], [-7., -7., 5., 120.], [-7., 7., 5., 130.], [7., 7., 5., 125.],
//! ])?;
//! let second = first.next(BasisShape::gbt(0.0, 1.0)?, &Joint::parametric(2), &[[7., -7., 5., 125.]])?;
//! let third = second.next(BasisShape::Bernstein, &Joint::beta(&[1.5, 0.3])?, &[[9., 2., 5., 130.]])?;
//! let joint = second.joint_with(&third, 2)?;
//! assert_eq!((joint.order_within(1e-9), joint.parametric_order_within(1e-9)), (Some(2), Some(0)));
//! assert!((joint.betas[0] - 1.5).abs() < 1e-9);
//! # Ok::<(), torse_geometry::GeometryError>(())
//! ```
//!
//! A flat pattern:
//!
//! ```
//! use torse_geometry::prelude::*;
//! let arc = |r: f64, z: f64| Rail::ellipse_arc([0.0, 0.0, z], [r, 0.0, z], [0.0, r, z]);
//! let funnel = Sheet::ruled(arc(3.0, 0.0)?, arc(1.0, 4.0)?);
//! let checked = funnel.inspect(64)?;
//! // A quarter of a cone: a sector of an annulus.
//! assert!((checked.area - std::f64::consts::PI * 20.0_f64.sqrt()).abs() < 1e-9);
//! let flat = funnel.unroll(64, 1e-6)?;
//! assert!(flat.errors().outline <= 1e-6 && (flat.area() - checked.area).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod circular;
mod cut;
mod exact;
mod inspect;
mod measure_budget;
mod nearest;
mod origin;
mod panel;
mod passage;
mod pieces;
mod piecewise;
mod plane_triangles;
mod planes;
mod polygon;
mod rail;
mod rails;
mod split;
mod strips;
mod surface;
mod swept;
mod tipped;
mod trace;

pub use crate::basis::BasisShape;
pub use crate::developable::{
    BranchReason, EnclosedCertificate, PatchCertificate, PieceIntersection, RailGap, Regularity,
    SelfIntersection, SheetPiercing, Singularity, Worst,
};
pub use circular::CircularCylinder;
pub use cut::Cut;
pub use inspect::{Inspection, SheetJoint};
pub use measure_budget::MeasureBudget;
pub use nearest::Nearest;
pub use panel::{MAX_PANEL_SQUARES, Panel, PanelKind, PanelPiece, Panels};
pub use piecewise::PiecewiseRail;
pub use planes::{Joint, Planes};
pub use rail::{Rail, RailCurve};
pub use strips::{MAX_STRIPS, StripCover, StripDirection, StripError, SurfaceStrip};
pub use surface::{ConnectedSheets, Construction, Sheet};
pub use swept::{ConePatch, CylinderPatch, SweptEdge};
pub use trace::{PiercingReach, SheetArc, SheetTracer, TraceError};

/// A point or vector of space.
pub type Point = [f64; 3];
