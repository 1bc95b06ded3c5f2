//! Several patches on one sheet: neighbours attached along a common ruling, or parts side by side.

use super::error::positive;
use super::error::{PatternError, PatternResult};
use super::flat::FlatPattern;
use super::piece::Piece;
use super::placement::Placement;
use crate::vector::{norm, sub};

impl FlatPattern {
    /// Attaches the pattern of a neighbour: an end ruling of `next` coincides in space with one of this chain, within
    /// `within` (a length). It is moved, and turned over where the two patches see different sides of the sheet, so
    /// that both lie on different sides of the common ruling. Where several ends coincide, the end of
    /// this chain and the start of `next` come first.
    ///
    /// # Errors
    /// [`PatternError::OutOfRange`] unless `within > 0`; [`PatternError::NoCommonRuling`], also of a sheet that is cut along a
    /// contour and has no end rulings;
    /// [`PatternError::CrossesItself`] when the patterns overlap: cut the chain elsewhere.
    ///
    /// ```
    /// use torse_geometry::pattern::unroll;
    /// use torse_geometry::{Bernstein, Curve, RuledSurface};
    /// // Two sides of a box and the edge between them.
    /// let rail = |points: [[f64; 3]; 2]| Curve::new(Bernstein, points.to_vec());
    /// let first = RuledSurface::new(rail([[0.0, 0.0, 0.0], [4.0, 0.0, 0.0]])?, rail([[0.0, 0.0, 3.0], [4.0, 0.0, 3.0]])?);
    /// let second = RuledSurface::new(rail([[4.0, 0.0, 0.0], [4.0, 2.0, 0.0]])?, rail([[4.0, 0.0, 3.0], [4.0, 2.0, 3.0]])?);
    /// let chain = unroll(&first, 3, 1e-6)?.append(&unroll(&second, 3, 1e-6)?, 1e-9)?;
    /// assert!((chain.outline().area() - 18.0).abs() < 1e-12);
    /// // The fold is a right angle.
    /// assert!((chain.rulings()[2].bend.abs() - std::f64::consts::FRAC_PI_2).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn append(&self, next: &Self, within: f64) -> PatternResult<Self> {
        positive("distance of end rulings", within)?;
        let mut nearest = f64::INFINITY;
        if self.contour.is_some() || next.contour.is_some() {
            let (distance, limit) = (nearest, within);
            return Err(PatternError::NoCommonRuling { distance, limit });
        }
        for (turn_self, turn_next) in [(false, false), (true, false), (false, true), (true, true)] {
            let mut pieces = passed(&self.pieces, turn_self);
            let added = passed(&next.pieces, turn_next);
            let (Some(last), Some(first)) = (pieces.last(), added.first()) else {
                continue;
            };
            let (here, there) = (EndRuling::new(last, true), EndRuling::new(first, false));
            let (gap, crossed) = here.gap(&there);
            nearest = nearest.min(gap);
            if gap > within {
                continue;
            }
            let from = if crossed {
                [there.flat[1], there.flat[0]]
            } else {
                there.flat
            };
            let Some(placement) = Placement::taking(from, here.flat, crossed) else {
                return Err(PatternError::NoRuling { x: last.end(true) });
            };
            let angle = last.inherited[1]
                + last.development.angle_error
                + 2.0 * (last.development.error + first.development.error) / here.length();
            let size: f64 = added.iter().map(|p| p.development.size).sum();
            let point = last.inherited[0]
                + last.development.error
                + first.development.error
                + gap
                + angle * size;
            let chosen = last.moved_by_choice
                + last.development.ambiguity * (1.0 + 2.0 * size / here.length());
            let moved = |piece: Piece| {
                let mut piece = piece.moved(&placement, [point, angle]);
                piece.moved_by_choice += chosen;
                piece
            };
            pieces.extend(added.into_iter().map(moved));
            let tolerance = self.tolerance.max(next.tolerance);
            let developable = self.developable.min(next.developable);
            return Self::from_pieces(pieces, developable, tolerance);
        }
        Err(PatternError::NoCommonRuling {
            distance: nearest,
            limit: within,
        })
    }
}

/// The pieces of a chain in the order in which it is passed, from the other end if `turned`.
fn passed(pieces: &[Piece], turned: bool) -> Vec<Piece> {
    if !turned {
        return pieces.to_vec();
    }
    pieces.iter().rev().map(Piece::turned).collect()
}

/// A free end of a chain: its ends from left to right, in space and flat.
struct EndRuling {
    space: [[f64; 3]; 2],
    flat: [[f64; 2]; 2],
}

impl EndRuling {
    fn new(piece: &Piece, last: bool) -> Self {
        let at = piece.development.at(piece.end(last));
        let sides = [piece.left(), 1 - piece.left()];
        Self {
            space: sides.map(|side| at.space[side]),
            flat: sides.map(|side| piece.placement.point(at.rails[side])),
        }
    }

    fn length(&self) -> f64 {
        norm(&sub(&self.flat[1], &self.flat[0]))
    }

    /// The larger distance of the ends, and whether left meets right.
    fn gap(&self, other: &Self) -> (f64, bool) {
        let far = |i: usize, j: usize| {
            let first = norm(&sub(&self.space[0], &other.space[i]));
            first.max(norm(&sub(&self.space[1], &other.space[j])))
        };
        let (straight, crossed) = (far(0, 1), far(1, 0));
        if crossed < straight {
            (crossed, true)
        } else {
            (straight, false)
        }
    }
}

/// Lays patterns out in a row along the first axis, each with its lowest point on the axis, `gap` apart (a length):
/// their boxes do not overlap.
///
/// # Errors
/// [`PatternError::OutOfRange`] unless `gap > 0`.
///
/// ```
/// use torse_geometry::pattern::{side_by_side, unroll};
/// use torse_geometry::{RuledSurface, curve::ellipse_arc};
/// let ring = |z: f64| ellipse_arc(&[0.0, 0.0, z], &[2.0, 0.0, z], &[0.0, 2.0, z]);
/// let flat = unroll(&RuledSurface::new(ring(0.0)?, ring(3.0)?), 17, 1e-6)?;
/// let row = side_by_side(&[flat.clone(), flat], 5.0)?;
/// let [[left, low], _] = row[1].outline().bounds();
/// assert!((left - 8.0).abs() < 1e-12 && low.abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn side_by_side(patterns: &[FlatPattern], gap: f64) -> PatternResult<Vec<FlatPattern>> {
    positive("gap", gap)?;
    let mut left = 0.0;
    let mut row = Vec::with_capacity(patterns.len());
    for pattern in patterns {
        let [low, high] = pattern.outline().bounds();
        let shift = [left - low[0], -low[1]];
        left += high[0] - low[0] + gap;
        row.push(pattern.placed(&Placement::shifted(shift)));
    }
    Ok(row)
}
