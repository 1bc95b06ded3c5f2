//! The report of an inspection, as data.

use super::contact::{PieceReport, Piercing, SelfContact};
use super::joint::JointReport;
use super::seams::SeamReport;
use super::surface::SurfaceReport;
use crate::covers::SurfaceCover;
use serde::Serialize;

/// What was measured.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct DesignReport {
    /// The name of the design.
    pub design: String,
    /// Its title.
    pub title: String,
    /// The unit of all lengths.
    pub unit: &'static str,
    /// The patches in the order of the file.
    pub patches: Vec<PatchReport>,
    /// The pieces of several patches that are attached; not in JSON where there is none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub pieces: Vec<PieceReport>,
    /// Two pieces each that are proved to pass through each other; not in JSON where there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub piercings: Vec<Piercing>,
    /// The joints, chain by chain.
    pub joints: Vec<JointReport>,
    /// The seams in the order of the file.
    pub seams: Vec<SeamReport>,
    /// What is demanded and missed, in words; empty when the design is as wanted.
    pub missed: Vec<String>,
    /// The surfaces in the order of the file.
    pub surfaces: Vec<SurfaceReport>,
    /// The surfaces that strips cover, in the order of the file; not in JSON where there is none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub covers: Vec<SurfaceCover>,
    /// The files that curves were taken from, with their units, in words.
    pub notes: Vec<String>,
}

/// Whether something is so, and how that is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Assurance {
    /// By the way it is made.
    ByConstruction,
    /// Proved for the exact control data: of a developable, that it is one exactly.
    Proved,
    /// Proved within the tolerance: how far it may be from it is told beside.
    Within,
    /// Measured; neither proved nor disproved.
    Measured,
    /// It is not so.
    No,
}

impl Assurance {
    /// Returns whether it is so, as far as known.
    #[must_use]
    pub fn holds(self) -> bool {
        self != Self::No
    }

    /// In a word or two.
    #[must_use]
    pub fn words(self) -> &'static str {
        match self {
            Self::ByConstruction => "by construction",
            Self::Proved => "proved",
            Self::Within => "within",
            Self::Measured => "measured",
            Self::No => "no",
        }
    }
}

/// Bounds of a number; `null` in JSON for an end that is infinite.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[non_exhaustive]
pub struct ValueBounds {
    /// It is at least this.
    pub low: Option<f64>,
    /// It is at most this.
    pub high: Option<f64>,
}

impl ValueBounds {
    pub(super) fn new(low: f64, high: f64) -> Self {
        let finite = |end: f64| end.is_finite().then_some(end);
        let (low, high) = (finite(low), finite(high));
        Self { low, high }
    }
}

/// What was measured of a patch.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PatchReport {
    /// Its name.
    pub name: String,
    /// How it is made.
    pub kind: &'static str,
    /// Whether its tangent plane stays the same along every ruling, within the tolerance.
    pub developable: Assurance,
    /// Whether its normal vanishes nowhere, but at an apex.
    pub regular: Assurance,
    /// Why it is not regular.
    pub singularity: Option<String>,
    /// The rails that are a point: 1, 2.
    pub apexes: Vec<usize>,
    /// The largest angle between the tangent planes at the ends of a ruling, in degrees: bounds.
    pub twist: ValueBounds,
    /// The same, measured, and the parameter of the ruling.
    pub twist_measured: [f64; 2],
    /// The smallest distance of the patch from the edge of regression, or where rulings come closest: bounds, and
    /// `null` where rulings do not meet. Negative inside.
    pub clearance: Option<ValueBounds>,
    /// The shortest and the longest ruling.
    pub rulings: [f64; 2],
    /// The largest Gaussian curvature in size, for one over square millimetres; `null` when it is unbounded.
    pub gaussian: Option<f64>,
    /// The smallest radius of bending; `null` for a flat patch.
    pub radius: Option<f64>,
    /// The inside radius of the bent sheet as a multiple of its thickness; `null` where no thickness is given or the
    /// patch is flat.
    pub inside_radius: Option<f64>,
    /// The area; `null` where it has none: the patch runs off to infinity.
    pub area: Option<f64>,
    /// Whether it passes through itself in space.
    pub space: SelfContact,
    /// What else is worth knowing.
    pub notes: Vec<String>,
}
