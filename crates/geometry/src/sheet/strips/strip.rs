//! A strip of a cover, and why there is none.

use crate::basis::BasisShape;
use crate::error::GeometryError;
use crate::sheet::{Panel, Point};
use crate::surface::TensorSurface;

/// A tensor product on f64 with any bases.
pub(super) type Tensor<S = f64> = TensorSurface<BasisShape<S>, BasisShape<S>, S>;

/// The parameter that grows along the edges of strips.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StripDirection {
    /// Edges are curves of constant `v`.
    U,
    /// Edges are curves of constant `u`.
    V,
}

/// Why a surface is not covered by strips.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum StripError {
    /// The curves have no normal curvature at a place: rulings would run along them.
    #[error(
        "no strips along asymptotic curves: at u = {:.6}, v = {:.6} the normal curvature of the curve vanishes, and the curves beside it have no rulings across",
        at[0], at[1]
    )]
    Asymptotic {
        /// The parameters of the place, found by samples.
        at: [f64; 2],
        /// The point.
        point: Point,
    },
    /// There is no whole panel between two neighbouring curves, or none was found.
    #[error("no whole panel between the curves at {} and {} was found{}", range[0], range[1], if *proved { ": proved that there is none" } else { "" })]
    NoPanel {
        /// The parameters of the curves.
        range: [f64; 2],
        /// Whether it is proved that there is none.
        proved: bool,
    },
    /// A panel was found, but its distance was not bounded.
    #[error("the distance of the strip between the curves at {} and {} was not bounded", range[0], range[1])]
    Unbounded {
        /// The parameters of the curves.
        range: [f64; 2],
    },
    /// So many strips and numbers of strips as are tried do not come as near as demanded.
    #[error("{count} strips come within {distance}, not within {within}")]
    TooFar {
        /// The number of strips.
        count: usize,
        /// How near they come.
        distance: f64,
        /// What is demanded.
        within: f64,
    },
    /// All curves meet in a point, and the panels that begin in it were not found.
    #[error(
        "all edges of strips meet in the point ({}, {}, {}), and no panel that begins or ends in a point was found",
        point[0], point[1], point[2]
    )]
    Tip {
        /// The parameter along the curves, 0 or 1.
        at: f64,
        /// The point.
        point: Point,
    },
    /// A place fails however narrow strips are.
    #[error(
        "strips fail at the curves from {} to {} however narrow they are: of the strip there, half as wide three times, {reason}; wider and narrower ones were not searched to the end",
        range[0], range[1]
    )]
    Narrow {
        /// The parameters of the narrowest strip that was tried.
        range: [f64; 2],
        /// Why it fails.
        reason: Box<Self>,
    },
    /// The work that a search may take is done.
    #[error(
        "no strips within {within} were found: the search, not to its end, took as much work as it may, at {count} strips{}",
        last.as_ref().map_or_else(String::new, |last| format!("; before, {last}"))
    )]
    Spent {
        /// The number of strips that was tried last.
        count: usize,
        /// What is demanded.
        within: f64,
        /// How the number before failed.
        last: Option<Box<Self>>,
    },
    /// What the surface, the curves or the panels refuse.
    #[error(transparent)]
    Geometry(#[from] GeometryError),
}

impl StripError {
    /// Returns the parameters of the curves of the strip that fails, where one does.
    #[must_use]
    pub fn range(&self) -> Option<[f64; 2]> {
        match self {
            Self::NoPanel { range, .. }
            | Self::Unbounded { range }
            | Self::Narrow { range, .. } => Some(*range),
            _ => None,
        }
    }
}

/// A strip of a cover.
#[derive(Debug, Clone, PartialEq)]
pub struct SurfaceStrip {
    /// The constant parameters of its first and second edge.
    pub range: [f64; 2],
    /// Its developable pieces from the start of both edges to their ends.
    pub panel: Panel,
    /// A proved bound: no point of the strip is farther from the part of the surface between its edges, and no point of
    /// that part is farther from the strip.
    pub distance: f64,
}
