//! Patterns of plane sheets that are cut along a closed contour of their own.

use super::contour::PatternContour;
use super::crossing::crossing;
use super::error::{PatternError, PatternResult};
use super::flat::FlatPattern;
use super::segment::Segment;

impl FlatPattern {
    /// The pattern of the same plane sheet, cut along a closed contour on it. It has no rulings: it is not bent.
    ///
    /// # Errors
    /// [`PatternError::Count`] for a pattern of several patches, [`PatternError::OutOfRange`] for one that is bent and for
    /// a contour that is not closed, not counterclockwise, has wider arcs, or leaves the box of the sheet; [`PatternError::CrossesItself`].
    ///
    /// ```
    /// use torse_geometry::pattern::{PatternContour, PatternEvidence, Segment, unroll};
    /// use torse_geometry::{Bernstein, Curve, RuledSurface};
    /// let rail = |y: f64| Curve::new(Bernstein, vec![[0.0, y, 0.0], [4.0, y, 0.0]]);
    /// let plate = unroll(&RuledSurface::new(rail(0.0)?, rail(3.0)?), 17, 1e-6)?;
    /// // A disc of radius one about the middle.
    /// let half = |from, to| Segment { from, to, bulge: 1.0 };
    /// let disc = PatternContour {
    ///     segments: vec![half([0.5, 2.0], [2.5, 2.0]), half([2.5, 2.0], [0.5, 2.0])],
    ///     distance: 0.0,
    ///     length_error: 0.0,
    ///     area_error: 0.0,
    ///     evidence: PatternEvidence::Proved,
    /// };
    /// let flat = plate.cut_to(disc)?;
    /// assert!((flat.area() - std::f64::consts::PI).abs() < 1e-12);
    /// assert!(flat.rulings().is_empty() && flat.errors().outline < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn cut_to(self, contour: PatternContour) -> PatternResult<Self> {
        let refused = |name, value, range| Err(PatternError::OutOfRange { name, value, range });
        if self.pieces.len() != 1 {
            return Err(PatternError::Count {
                what: "patches of a sheet that is cut along a contour",
                given: self.pieces.len(),
                needed: 1,
            });
        }
        let bent = self.rulings().iter().map(|ruling| ruling.bend.abs());
        let bent = bent.fold(0.0, f64::max);
        if bent > 0.0 {
            return refused("bend of a sheet that is cut along a contour", bent, "0");
        }
        let next = contour.segments.iter().cycle().skip(1);
        let open = contour
            .segments
            .iter()
            .zip(next)
            .map(|(a, b)| libm::hypot(b.from[0] - a.to[0], b.from[1] - a.to[1]));
        // A sum, so that NaN stays one.
        let gap: f64 = open.sum();
        if gap != 0.0 {
            return refused("gap of a contour", gap, "0");
        }
        let bulges = contour.segments.iter().map(|segment| segment.bulge.abs());
        let bulge = bulges.fold(0.0, f64::max);
        if bulge > 1.0 {
            return refused("bulge of a contour", bulge, "[-1, 1]");
        }
        let area: f64 = contour.segments.iter().map(Segment::area).sum();
        if area.is_nan() || area <= 0.0 {
            return refused("area in a contour", area, "(0, infinity)");
        }
        let [low, high] = self.outline().bounds();
        let beyond = contour.segments.iter().flat_map(|segment| {
            let [a, b] = segment.bounds();
            [low[0] - a[0], low[1] - a[1], b[0] - high[0], b[1] - high[1]]
        });
        let beyond = beyond.fold(0.0, f64::max);
        if beyond > 0.0 {
            return refused("reach of a contour beyond its sheet", beyond, "0");
        }
        if let Some((segments, at)) = crossing(&contour.segments, 0.25 * self.tolerance) {
            return Err(PatternError::CrossesItself { at, segments });
        }
        Ok(self.with_contour(contour))
    }
}
