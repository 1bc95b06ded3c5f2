//! Flat patterns: unrolling developables, joining, marking and folding what was unrolled.
//!
//! A developable surface is isometric to a part of the plane, and its rulings stay straight. [`unroll`] turns
//! a patch into a [`FlatPattern`]: the outline to be cut, as lines and circular arcs, the rulings with the angle
//! by which the sheet is bent there, and the map between sheet and space. What it promises is
//! about the *cut*: [`PatternErrors::outline`] bounds the distance between the outline that a machine follows and
//! the exact one, not only errors at vertices.
//!
//! A patch that has no flat pattern is refused with numbers, [`PatternError`]: it is not developable, its edge
//! of regression runs inside, its outline would cross itself.

mod bending;
mod bent;
mod chain;
mod contour;
mod crossing;
mod development;
mod edges;
mod error;
mod fit;
mod flat;
mod flattening;
mod fold;
mod frame;
mod interval;
mod lift;
mod outline;
mod panel;
mod piece;
mod placement;
mod segment;
mod source;
mod trimmed;
mod unroll;

pub use bending::{Bend, BendingSheet, bends, is_bendable};
pub use bent::BentSheet;
pub use chain::side_by_side;
pub use contour::PatternContour;
pub use error::{PatternError, PatternResult};
pub use flat::{FlatPattern, FlatRuling, PatternErrors};
pub use flattening::Flattening;
pub use fold::{deviation, fold};
pub use lift::PatternPlace;
pub use outline::PatternOutline;
pub use placement::Placement;
pub use segment::Segment;
pub use source::PatternEvidence;
pub use unroll::{DEVELOPABLE_STRAIN, MAX_RULINGS, Unrolling, unroll};
