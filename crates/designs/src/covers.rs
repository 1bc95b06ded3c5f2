//! Surfaces that are covered by strips, and how near these come.

use serde::Serialize;

/// A surface that is no developable, covered by strips that are.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SurfaceCover {
    /// The name of the entry under `[patches]`.
    pub name: String,
    /// The name of the surface.
    pub surface: String,
    /// The parameter that grows along the edges of the strips: `u` or `v`.
    pub along: &'static str,
    /// How far strips may be from the surface, in millimetres.
    pub within: f64,
    /// The strips in a row: neighbours share an edge.
    pub strips: Vec<CoveringStrip>,
    /// Whether one strip less was tried, and did not come as near.
    pub fewest: bool,
}

/// A strip of a cover.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct CoveringStrip {
    /// Its name.
    pub name: String,
    /// The indices of its patches in the design.
    pub patches: Vec<usize>,
    /// The constant parameters of its edges on the surface.
    pub range: [f64; 2],
    /// A proved bound, in millimetres, of the distance of each point of the strip from the surface between its edges,
    /// and of each point of that from the strip.
    pub distance: f64,
    /// The least and the greatest angle to the next strip, in degrees, measured; `None` for the last.
    pub fold: Option<[f64; 2]>,
}
