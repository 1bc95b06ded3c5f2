//! Closed contours along which plane sheets are cut, and not along their rails and end rulings.

use super::placement::Placement;
use super::segment::Segment;
use super::source::PatternEvidence;

/// A closed contour on a pattern, and how well it is known.
///
/// Invariant once it is part of a pattern: counterclockwise, simple, within the box of the sheet.
#[derive(Debug, Clone, PartialEq)]
pub struct PatternContour {
    /// Its lines and arcs of half a circle at most, each from where the one before ends.
    pub segments: Vec<Segment>,
    /// No point of it is farther from the exact one, nor the other way round: a length.
    pub distance: f64,
    /// How far its length is from that of the exact one.
    pub length_error: f64,
    /// How far the area inside is from that of the exact one.
    pub area_error: f64,
    /// Whether these bounds are proved.
    pub evidence: PatternEvidence,
}

impl PatternContour {
    /// The contour moved; counterclockwise also where it is turned over.
    pub(super) fn placed(&self, placement: &Placement) -> Self {
        let moved = self.segments.iter().map(|s| placement.segment(s));
        let mut segments: Vec<Segment> = moved.collect();
        if placement.is_mirrored() {
            segments = segments.iter().rev().map(Segment::reversed).collect();
        }
        Self {
            segments,
            ..self.clone()
        }
    }
}
