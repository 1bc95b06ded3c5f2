//! Design files: from control data to a part that can be cut.
//!
//! A design is a TOML file with points, planes, curves, families of planes, patches and chains of them; the format is
//! described in `designs/README.md`. This room reads it and answers what the command asks; mathematics is that of
//! `torse-geometry`, files are those of `torse-exchange`.
//!
//! | you want | take |
//! |---|---|
//! | the design of a file, or everything that is wrong in it | [`load`], [`read`] |
//! | what is in a file of another program, and whether its faces are developable | [`listing::list`], [`audit::FaceAudit`] |
//! | to know whether it can be made | [`inspect::inspect`] |
//! | its flat pattern | [`unroll::unroll`], [`unroll::drawing`] |
//! | a sheet for the fitter, or parts in true size on pages | [`bench::bench_sheets`], [`bench::tiled_parts`] |
//! | a pattern file folded and compared with the design | [`fold::fold_back`] |
//! | any file | [`export::bytes`] |
//! | points, normals, curvatures | [`eval::eval`] |
//! | the developable of a figure that a page moves, for a CAD program | [`movable::step_of`] |
//! | a picture, or a page | [`draw::picture`], [`draw::page`] |
//!
//! ```
//! use torse_designs::unroll::{Demand, drawing, unroll};
//! let design = torse_designs::read("tube.toml", r#"
//!     [curves.rim]
//!     arc = { centre = [0, 0, 0], from = ["10*sqrt(2)", 0, 0], to = [0, "10*sqrt(2)", 0] }
//!     [patches.tube]
//!     cylinder = "rim"
//!     direction = [0, 0, 30]
//! "#)?;
//! let report = torse_designs::inspect::inspect(&design)?;
//! assert!(report.missed.is_empty());
//! let pieces = unroll(&design, &Demand::default())?;
//! let pattern = torse_exchange::dxf(&drawing(&design, &pieces)?)?;
//! let folded = torse_designs::fold::fold_text(&design, "tube.dxf", &pattern)?;
//! assert!(folded.missed.is_empty());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! All lengths are in millimetres once a file is read. The same file gives the same bytes everywhere.
#![warn(missing_docs)]

pub mod audit;
pub mod bench;
mod bending;
mod chords;
mod covers;
mod design;
pub mod draw;
mod error;
pub mod eval;
pub mod export;
mod faces;
mod file;
mod fit;
pub mod fold;
mod inside_radius;
pub mod inspect;
pub mod lines;
pub mod lint;
pub mod listing;
pub mod movable;
mod numbers;
pub mod openings;
mod plane_contour;
mod polygon;
mod position;
mod rounding;
mod seams;
mod segment_crossings;
mod simple_contour;
mod space_openings;
mod unit;
pub mod unroll;

pub use bending::{Bending, DesignedSurface, NeutralLine};
pub use covers::{CoveringStrip, SurfaceCover};
pub use design::{
    Chain, ChainLayout, Design, DesignPiece, DesignPoint, DesignView, LeftOut, Mark, MarkedOpening,
    Material, NamedCurve, ParameterSide, Patch, PatchEnds, Smoothness, Tolerances,
};
pub use error::{DesignError, Ending};
pub use file::{
    MAX_BYTES, MAX_CONTROLS, MAX_LINE, MAX_THINGS, keys, load, load_from, load_with_settings, read,
    read_with, read_with_settings,
};
pub use seams::{EdgeName, PatchEdge, Seam};
pub use unit::DesignUnit;
