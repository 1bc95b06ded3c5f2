//! Openings beside bends: what is cut too near to a bend line is pulled out of shape when it is bent.

use super::blank::ToolBend;
use crate::chords::clearance;
use crate::openings::{Opening, OpeningShape};
use serde::Serialize;
use torse_geometry::pattern::Segment;

/// From the bend line to the edge of an opening there should be so many thicknesses and the inside radius: a rule of thumb
/// that many shops print, some with 2, some with 3 thicknesses.
const THICKNESSES: f64 = 2.5;
/// Chords that stand for an opening are no farther from it, in millimetres.
const CHORD: f64 = 1e-3;

/// An opening that is nearer to a bend than is good for it; lengths in millimetres.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct BesideBend {
    /// The opening.
    pub opening: String,
    /// The bend.
    pub bend: String,
    /// How far its edge is from the bend line.
    pub distance: f64,
    /// How far it should be.
    pub wanted: f64,
}

impl BesideBend {
    /// Returns what is wrong with it in words.
    #[must_use]
    pub fn words(&self) -> String {
        format!(
            "{} is {:.3} mm from the line of bend {}, which may pull it out of shape: {:.3} mm are usual",
            self.opening, self.distance, self.bend, self.wanted
        )
    }
}

/// Returns the openings of a part that are too near to its bends, each with each.
pub(crate) fn beside_bends(
    thickness: f64,
    openings: &[Opening],
    bends: &[ToolBend],
) -> Vec<BesideBend> {
    let mut found = Vec::new();
    for opening in openings {
        for bend in bends {
            let wanted = THICKNESSES * thickness + bend.inside_radius;
            // That of the hole in the sheet, wherever the line of the cut is.
            let hole = opening.finished.as_ref().unwrap_or(&opening.shape);
            let distance = distance(hole, bend.line);
            if distance < wanted {
                found.push(BesideBend {
                    opening: opening.name.clone(),
                    bend: bend.name.clone(),
                    distance,
                    wanted,
                });
            }
        }
    }
    found
}

/// Returns the distance of an opening from a bend line.
fn distance(shape: &OpeningShape, [from, to]: [[f64; 2]; 2]) -> f64 {
    match shape {
        OpeningShape::Round(centre, radius) => Segment::line(from, to).distance(*centre) - radius,
        OpeningShape::Contour(_) => clearance(&shape.chords(CHORD), &[[from, to]]).0,
    }
}
