//! What an opening of a pattern or a part is.

use crate::chords::{Chord, chords_within};
use std::f64::consts::PI;
use torse_geometry::pattern::{Placement, Segment};

/// The shape of an opening in the plane.
///
/// Invariant: a contour is closed, counterclockwise, simple, and has two segments at least.
#[derive(Debug, Clone, PartialEq)]
pub enum OpeningShape {
    /// A circle: its centre and radius.
    Round([f64; 2], f64),
    /// Lines and arcs.
    Contour(Vec<Segment>),
}

/// An opening of a pattern or a part.
#[derive(Debug, Clone, PartialEq)]
pub struct Opening {
    /// Its shape.
    pub shape: OpeningShape,
    /// What it is, in words.
    pub name: String,
    /// No point of it is farther from that of the exact part.
    pub error: f64,
    /// Whether that is proved; measured otherwise.
    pub proved: bool,
    /// The shape of the hole in the finished part, where that of the cut is smaller by the kerf.
    pub(crate) finished: Option<OpeningShape>,
    /// The patch of the pattern that it is marked on.
    pub(crate) patch: usize,
}

impl OpeningShape {
    /// Returns the area.
    #[must_use]
    pub fn area(&self) -> f64 {
        match self {
            Self::Round(_, radius) => PI * radius * radius,
            Self::Contour(segments) => segments.iter().map(Segment::area).sum(),
        }
    }

    /// Returns the length around it.
    #[must_use]
    pub fn length(&self) -> f64 {
        match self {
            Self::Round(_, radius) => 2.0 * PI * radius,
            Self::Contour(segments) => segments.iter().map(Segment::length).sum(),
        }
    }

    /// Returns its contour; of a circle two halves.
    #[must_use]
    pub fn contour(&self) -> Vec<Segment> {
        match self {
            Self::Round([x, y], radius) => {
                let ends = [[x + radius, *y], [x - radius, *y]];
                let half = |from, to| Segment {
                    from,
                    to,
                    bulge: 1.0,
                };
                vec![half(ends[0], ends[1]), half(ends[1], ends[0])]
            }
            Self::Contour(segments) => segments.clone(),
        }
    }

    /// Returns the lower left and the upper right corner of the box around it.
    #[must_use]
    pub fn bounds(&self) -> [[f64; 2]; 2] {
        let start = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        self.contour().iter().fold(start, |[low, high], segment| {
            let [a, b] = segment.bounds();
            [
                [low[0].min(a[0]), low[1].min(a[1])],
                [high[0].max(b[0]), high[1].max(b[1])],
            ]
        })
    }

    /// Returns the centre of a circle, or the middle of the box around another shape.
    #[must_use]
    pub fn middle(&self) -> [f64; 2] {
        match self {
            Self::Round(centre, _) => *centre,
            Self::Contour(_) => {
                let [low, high] = self.bounds();
                [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])]
            }
        }
    }

    /// Returns the shape moved.
    #[must_use]
    pub fn placed(&self, placement: &Placement) -> Self {
        match self {
            Self::Round(centre, radius) => Self::Round(placement.point(*centre), *radius),
            Self::Contour(segments) => {
                let moved = segments.iter().map(|segment| placement.segment(segment));
                Self::Contour(moved.collect())
            }
        }
    }

    /// Returns its chords, no farther than `within` from it.
    pub(crate) fn chords(&self, within: f64) -> Vec<Chord> {
        chords_within(&self.contour(), within)
    }
}
