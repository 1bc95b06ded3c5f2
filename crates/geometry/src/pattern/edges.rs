//! The edges of the patches of a pattern, one by one: what another part is made from.

use super::flat::{FlatPattern, fold_angle};
use super::segment::Segment;

impl FlatPattern {
    /// A rail of a patch of the chain on the sheet, first (0) or second (1), from `x = 0` to `x = 1`. A rail that is a
    /// point has no segments. `None` for a patch or a rail that is not there.
    ///
    /// ```
    /// use torse_geometry::pattern::{Segment, unroll};
    /// use torse_geometry::{RuledSurface, curve::ellipse_arc};
    /// let ring = |r: f64, z: f64| ellipse_arc(&[0.0, 0.0, z], &[r, 0.0, z], &[0.0, r, z]);
    /// let flat = unroll(&RuledSurface::new(ring(3.0, 0.0)?, ring(2.0, 4.0)?), 17, 1e-6)?;
    /// let length = |side: usize| -> f64 { flat.rail(0, side).unwrap_or_default().iter().map(Segment::length).sum() };
    /// assert!((length(0) - 1.5 * std::f64::consts::PI).abs() < 1e-6);
    /// assert!((length(1) - std::f64::consts::PI).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn rail(&self, piece: usize, side: usize) -> Option<Vec<Segment>> {
        let piece = self.pieces.get(piece)?;
        let rail = (side < 2).then(|| piece.rail(side))?;
        Some(if piece.backward {
            rail.iter().rev().map(Segment::reversed).collect()
        } else {
            rail
        })
    }

    /// The rails of a patch of the chain in the order of the chain: to the left of one who follows it, and to the
    /// right.
    #[must_use]
    pub fn sides(&self, piece: usize) -> Option<[Vec<Segment>; 2]> {
        let piece = self.pieces.get(piece)?;
        Some([piece.rail(piece.left()), piece.rail(1 - piece.left())])
    }

    /// The first and the last ruling of a patch that the chain passes, each from left to right.
    #[must_use]
    pub fn end_rulings(&self, piece: usize) -> Option<[[[f64; 2]; 2]; 2]> {
        let piece = self.pieces.get(piece)?;
        let sides = [piece.left(), 1 - piece.left()];
        Some([false, true].map(|last| {
            let at = piece.development.at(piece.end(last));
            sides.map(|side| piece.placement.point(at.rails[side]))
        }))
    }

    /// The angle in radians between the tangent planes of a patch and the next one where they meet, positive where both
    /// sides rise towards the viewer: zero for a smooth joint, however the patches are curved.
    #[must_use]
    pub fn edge_angle(&self, piece: usize) -> Option<f64> {
        let (piece, next) = (self.pieces.get(piece)?, self.pieces.get(piece + 1)?);
        let last = piece.end(true);
        let normals = [
            piece.seen(&[last]).pop()?,
            next.seen(&[next.end(false)]).pop()?,
        ];
        let axis = piece.axis(&piece.development.at(last));
        Some(fold_angle(&normals[0], &normals[1], &axis))
    }

    /// Whether the chain passes a patch from `x = 1` to `x = 0`.
    #[must_use]
    pub fn is_backward(&self, piece: usize) -> Option<bool> {
        self.pieces.get(piece).map(|piece| piece.backward)
    }
}
