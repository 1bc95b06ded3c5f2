//! Sheets that meet in space, as data of a report.

use serde::Serialize;
use torse_geometry::prelude::{SelfIntersection, Sheet};

/// Whether a patch passes through itself in space.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum SelfContact {
    /// It is proved that it does not.
    Free,
    /// These two places `[u, v]` are one point.
    Meets {
        /// The places.
        places: [[f64; 2]; 2],
        /// Whether that is proved.
        proved: bool,
    },
    /// Rulings of these two ranges of `u` may meet.
    Undecided {
        /// The ranges.
        ranges: [[f64; 2]; 2],
    },
    /// It was not asked: the patch is singular, or it is measured only.
    Unknown,
}

impl SelfContact {
    pub(super) fn inspect(sheet: &Sheet) -> Self {
        match sheet.self_intersection() {
            Ok(SelfIntersection::Free) => Self::Free,
            Ok(SelfIntersection::Found { places, proved, .. }) => Self::Meets { places, proved },
            Ok(SelfIntersection::Undecided { ranges }) => Self::Undecided { ranges },
            Err(_) => Self::Unknown,
        }
    }

    /// What is said of a patch of this name that passes through itself.
    pub(super) fn objection(&self, name: &str) -> Option<String> {
        let Self::Meets { places, proved } = self else {
            return None;
        };
        Some(format!(
            "{name} passes through itself in space: {}",
            one_point(["", ""], *places, *proved)
        ))
    }
}

/// A place no farther from the first or the last ruling, in the parameter, lies on it.
const END: f64 = 1e-9;

/// Two places that are one point, in words.
pub(super) fn one_point(names: [&str; 2], places: [[f64; 2]; 2], proved: bool) -> String {
    let [a, b] = [0, 1].map(|i| {
        let [u, v] = places[i];
        let name = names[i];
        let at = if name.is_empty() { "" } else { " at " };
        format!("{name}{at}u = {u:.7}, v = {v:.7}")
    });
    let proved = if proved { ", proved" } else { "" };
    format!("{a} and {b} are one point{proved}")
}

/// What is known of the patches of a piece in space, two at a time.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PieceSpace {
    /// It is proved that no two of them meet but where they are joined.
    Free,
    /// Places `[u, v]` of two of them are one point.
    Meets {
        /// The names of the patches.
        patches: [String; 2],
        /// The place on each.
        places: [[f64; 2]; 2],
        /// Whether that is proved.
        proved: bool,
    },
    /// Rulings of these ranges of `u` of two of them may meet.
    Undecided {
        /// The names of the patches.
        patches: [String; 2],
        /// The range of each.
        ranges: [[f64; 2]; 2],
    },
    /// It was not asked: a patch is singular.
    Unknown,
}

/// A piece of several patches.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PieceReport {
    /// The name of the chain or of the entry.
    pub name: String,
    /// The patches that are attached.
    pub patches: Vec<String>,
    /// Whether they pass through each other.
    pub space: PieceSpace,
}

impl PieceReport {
    /// What is said of a piece that passes through itself.
    pub(super) fn objection(&self) -> Option<String> {
        let PieceSpace::Meets {
            patches: [a, b],
            places,
            proved,
        } = &self.space
        else {
            return None;
        };
        // A patch that ends on another one does not go through it.
        let ends = places.iter().any(|[u, _]| u.min(1.0 - u) <= END);
        let does = if ends { "touches" } else { "passes through" };
        Some(format!(
            "{} {does} itself in space: {}",
            self.name,
            one_point([a, b], *places, *proved)
        ))
    }
}

/// Two pieces that pass through each other, which is proved.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct Piercing {
    /// The names of the pieces.
    pub pieces: [String; 2],
    /// A patch of each.
    pub patches: [String; 2],
    /// A place `[u, v]` of each: the same point, within a millionth.
    pub places: [[f64; 2]; 2],
}
