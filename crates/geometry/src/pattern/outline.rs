//! A closed outline of lines and arcs.

use super::error::PatternResult;
use super::segment::Segment;

/// A closed chain of lines and arcs, counterclockwise: what is cut.
#[derive(Debug, Clone, PartialEq)]
pub struct PatternOutline {
    segments: Vec<Segment>,
}

impl PatternOutline {
    /// The outline through these segments, each of which starts where the one before ends.
    pub(super) fn new(segments: Vec<Segment>) -> Self {
        Self { segments }
    }

    /// The segments in order; the last ends where the first starts.
    #[must_use]
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// The vertices with the bulge of the segment that starts there: a closed `LWPOLYLINE`.
    pub fn vertices(&self) -> impl Iterator<Item = ([f64; 2], f64)> {
        self.segments.iter().map(|s| (s.from, s.bulge))
    }

    /// The length of the cut.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.segments.iter().map(Segment::length).sum()
    }

    /// The area inside.
    #[must_use]
    pub fn area(&self) -> f64 {
        self.segments.iter().map(Segment::area).sum()
    }

    /// The lower left and the upper right corner of the least box with sides along the axes.
    #[must_use]
    pub fn bounds(&self) -> [[f64; 2]; 2] {
        let start = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        self.segments.iter().fold(start, |[low, high], s| {
            let [a, b] = s.bounds();
            [
                [low[0].min(a[0]), low[1].min(a[1])],
                [high[0].max(b[0]), high[1].max(b[1])],
            ]
        })
    }

    /// The distance of a point from the outline.
    #[must_use]
    pub fn distance(&self, point: [f64; 2]) -> f64 {
        let each = self.segments.iter().map(|s| s.distance(point));
        each.fold(f64::INFINITY, f64::min)
    }

    /// A closed polygon that deviates from the outline by at most `chord`, for formats without arcs. At most 4096
    /// sides stand for one arc, however small `chord` is.
    ///
    /// # Errors
    /// [`PatternError::OutOfRange`](super::PatternError::OutOfRange) unless `chord > 0`.
    pub fn polygon(&self, chord: f64) -> PatternResult<Vec<[f64; 2]>> {
        super::error::positive("chord tolerance", chord)?;
        let mut points = Vec::with_capacity(self.segments.len());
        for segment in &self.segments {
            // The sagitta of a part falls with the square of its share.
            let ratio = (segment.sagitta() / chord).sqrt();
            let parts = if ratio > 1.0 {
                // A little more: the sagitta of wide arcs falls slower at first.
                (1.2 * ratio).ceil().min(4096.0)
            } else {
                1.0
            };
            let mut k = 0.0;
            while k < parts {
                points.push(segment.point(k / parts));
                k += 1.0;
            }
        }
        Ok(points)
    }
}
