//! The sheet on its way between pattern and patch: bent along its rulings by a share of every bend.
//!
//! A sheet bends isometrically when its facets, the parts between neighbouring rulings, move rigidly: each turns
//! against the one before about the ruling between them. With `t` times the angles of the finished sheet this is flat
//! for `t = 0`, the polyhedron of [`fold`](super::fold()) for `t = 1`, and in between a developable with the same
//! pattern: no line changes its length, at no share. (Points that are blended between pattern and patch would stretch
//! the sheet on their way.)

use super::error::{PatternError, PatternResult};
use super::flat::FlatPattern;
use super::fold::{RigidMotion, best_motion, facet_motions, on_sheet};

/// A sheet that is bent, made by [`FlatPattern::bent`]. Its facets are plane, and it is isometric to the pattern.
#[derive(Debug, Clone, PartialEq)]
pub struct BentSheet {
    /// The rulings on the sheet.
    flat: Vec<[[f64; 2]; 2]>,
    /// The facet before each ruling; the first facet twice.
    motions: Vec<RigidMotion>,
}

impl FlatPattern {
    /// Bends the sheet along its rulings by this share of every bend: flat for 0, bent as the patch is for 1, to within
    /// [`FlatPattern::fold_deviation`]; other shares go on beyond both.
    ///
    /// The facet in the middle stays where it is for the share 1, near the patch: the sheet is seen to unroll in its
    /// place.
    ///
    /// # Errors
    /// As [`fold`](super::fold()); [`PatternError::OutOfRange`] for a share that is not finite.
    ///
    /// ```
    /// use torse_geometry::pattern::unroll;
    /// use torse_geometry::{RuledSurface, curve::ellipse_arc};
    /// // A quarter of a cylinder of radius 2, half unrolled: an eighth of one of radius 4.
    /// let ring = |z: f64| ellipse_arc(&[0.0, 0.0, z], &[2.0, 0.0, z], &[0.0, 2.0, z]);
    /// let flat = unroll(&RuledSurface::new(ring(0.0)?, ring(3.0)?), 129, 1e-6)?;
    /// let half = flat.bent(0.5)?.rulings();
    /// let apart = |a: usize, b: usize| {
    ///     let [p, q] = [half[a][0], half[b][0]];
    ///     ((p[0] - q[0]).powi(2) + (p[1] - q[1]).powi(2) + (p[2] - q[2]).powi(2)).sqrt()
    /// };
    /// assert!((apart(0, 128) - 8.0 * (std::f64::consts::PI / 8.0).sin()).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn bent(&self, share: f64) -> PatternResult<BentSheet> {
        if !share.is_finite() {
            let (name, range) = ("share of the bends", "(-infinity, infinity)");
            return Err(PatternError::OutOfRange {
                name,
                value: share,
                range,
            });
        }
        let flat: Vec<[[f64; 2]; 2]> = self.rulings().iter().map(|r| r.ends).collect();
        let motions = |share: f64| {
            let angles: Vec<f64> = self.rulings().iter().map(|r| share * r.bend).collect();
            facet_motions(&flat, &angles)
        };
        let whole = BentSheet {
            motions: motions(1.0)?,
            flat: flat.clone(),
        };
        let folded: Vec<[f64; 3]> = whole.rulings().into_iter().flatten().collect();
        let patch: Vec<[f64; 3]> = self.rulings_in_space().into_iter().flatten().collect();
        let onto = best_motion(&folded, &patch).unwrap_or(RigidMotion::IDENTITY);
        let part = motions(share)?;
        let middle = flat.len() / 2;
        let place = match (whole.motions.get(middle), part.get(middle)) {
            (Some(there), Some(here)) => onto.after(there).after(&here.inverse()),
            _ => onto,
        };
        Ok(BentSheet {
            motions: part.iter().map(|motion| place.after(motion)).collect(),
            flat,
        })
    }
}

impl BentSheet {
    /// Returns the ends in space of the rulings, in the order of [`FlatPattern::rulings`].
    #[must_use]
    pub fn rulings(&self) -> Vec<[[f64; 3]; 2]> {
        let each = self.flat.iter().zip(&self.motions);
        each.map(|(ruling, motion)| ruling.map(|end| motion.point(&on_sheet(end))))
            .collect()
    }

    /// Returns the unit normals of the facets on the side of the viewer of the pattern: of the facet between the first
    /// and the second ruling, and so on.
    #[must_use]
    pub fn normals(&self) -> Vec<[f64; 3]> {
        let facets = self.motions.iter().skip(1);
        facets.map(RigidMotion::normal).collect()
    }

    /// Returns where a point of the pattern lies on the bent sheet; `None` beside its facets. Where an edge of the
    /// pattern is curved, a little of the sheet lies beside them.
    #[must_use]
    pub fn point(&self, flat: [f64; 2]) -> Option<[f64; 3]> {
        let facets = self.flat.windows(2).zip(self.motions.iter().skip(1));
        let (_, motion) = facets
            .into_iter()
            .find(|(facet, _)| matches!(facet, [a, b] if holds(a, b, flat)))?;
        Some(motion.point(&on_sheet(flat)))
    }

    /// Returns where the point at a share of a ruling's line lies, which may be beyond its ends: so far from the first
    /// end towards the second. `None` where there is no such ruling.
    #[must_use]
    pub fn on_ruling(&self, ruling: usize, share: f64) -> Option<[f64; 3]> {
        let [[a, b], [c, d]] = *self.flat.get(ruling)?;
        let at = [a + share * (c - a), b + share * (d - b)];
        Some(self.motions.get(ruling)?.point(&on_sheet(at)))
    }
}

/// Whether a point lies in the convex facet between two rulings.
fn holds(first: &[[f64; 2]; 2], second: &[[f64; 2]; 2], p: [f64; 2]) -> bool {
    let corners = [first[0], first[1], second[1], second[0]];
    let next = corners.iter().cycle().skip(1);
    let sides = corners.iter().zip(next).map(|(a, b)| {
        let [side, away] = [[b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]];
        side[0] * away[1] - side[1] * away[0]
    });
    let sides: Vec<f64> = sides.collect();
    sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0)
}
