//! The pieces of a rail, numbered along it.

use super::{PiecewiseRail, Point, Rail};
use crate::developable::Node;
use crate::error::{GeometryError, Result, count};
use crate::vector::{cross, dot, norm, sub, unit};

/// Two neighbouring pieces of a rail make a corner if their tangents differ by more, in radians.
const SMOOTH: f64 = 1e-6;
/// Tangents of a straight piece differ by less, in radians.
const STRAIGHT: f64 = 1e-14;
/// Two points that count as one, as a share of the size of the rails.
const SAME_POINT: f64 = 1e-12;

/// The pieces of a rail.
pub(super) struct Pieces {
    pub(super) rails: Vec<Rail>,
    breaks: Vec<f64>,
    pub(super) closed: bool,
    /// Whether there is a corner at the start of each piece and, last, at the end.
    corners: Vec<bool>,
}

impl Pieces {
    pub(super) fn new(curve: &PiecewiseRail) -> Result<Self> {
        let rails = curve.rails()?;
        let breaks = curve
            .breaks()
            .iter()
            .map(crate::Coordinate::approximate)
            .collect();
        let ends = |rail: &Rail| -> Result<[(Point, Option<Point>); 2]> {
            let end = |x: f64| -> Result<_> { Ok((rail.point(x)?, unit(&rail.derivative(x)?))) };
            Ok([end(0.0)?, end(1.0)?])
        };
        let ends: Vec<_> = rails.iter().map(ends).collect::<Result<_>>()?;
        let missing = GeometryError::TooFew {
            what: "pieces of a curve",
            needed: 1,
            given: 0,
        };
        let (Some(first), Some(last)) = (ends.first(), ends.last()) else {
            return Err(missing);
        };
        let size = ends
            .iter()
            .flatten()
            .flat_map(|(point, _)| point.iter())
            .fold(0.0_f64, |m, c| m.max(c.abs()));
        let closed = norm(&sub(&first[0].0, &last[1].0)) <= SAME_POINT * size;
        let bent = |before: &Option<Point>, after: &Option<Point>| match (before, after) {
            (Some(a), Some(b)) => libm::atan2(norm(&cross(a, b)), dot(a, b)) > SMOOTH,
            _ => false,
        };
        let seam = closed && bent(&last[1].1, &first[0].1);
        let inner = ends
            .windows(2)
            .map(|pair| bent(&pair[0][1].1, &pair[1][0].1));
        let corners = std::iter::once(seam)
            .chain(inner)
            .chain(std::iter::once(seam))
            .collect();
        Ok(Self {
            rails,
            breaks,
            closed,
            corners,
        })
    }

    pub(super) fn count(&self) -> usize {
        self.rails.len()
    }

    /// Returns whether a piece is a straight line, as its derivatives at samples show.
    pub(super) fn is_straight(&self, piece: usize) -> bool {
        const SAMPLES: u32 = 8;
        let Some(rail) = self.rails.get(piece) else {
            return false;
        };
        let Ok(first) = rail.derivative(0.0) else {
            return false;
        };
        (1..=SAMPLES).all(|k| {
            let slope = rail.derivative(f64::from(k) / f64::from(SAMPLES));
            slope.is_ok_and(|slope| {
                let size = norm(&first) * norm(&slope);
                size > 0.0 && norm(&cross(&first, &slope)) <= STRAIGHT * size
            })
        })
    }

    /// Returns the piece over an interval of parameters that count pieces, and its own parameters.
    pub(super) fn on(&self, [from, to]: [f64; 2]) -> Option<(&Rail, [f64; 2])> {
        let turn = count(self.count());
        let middle = 0.5 * (from + to);
        let turns = if self.closed {
            (middle / turn).floor()
        } else {
            0.0
        };
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let index = (middle - turns * turn).floor() as usize;
        let index = index.min(self.count().checked_sub(1)?);
        let start = turns * turn + count(index);
        let rail = self.rails.get(index)?;
        Some((rail, [from, to].map(|x| (x - start).clamp(0.0, 1.0))))
    }

    /// Returns the parameter of the whole rail: of a closed one that is passed over its end, one turn more.
    pub(super) fn whole(&self, at: f64) -> f64 {
        let turn = count(self.count());
        let turns = (at / turn).floor();
        let rest = at - turns * turn;
        // The end of the last piece is 1 and not one turn.
        if rest == 0.0 {
            return turns;
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let index = rest.floor() as usize;
        let share = rest.fract();
        let at = |k: usize| self.breaks.get(k).copied().unwrap_or(1.0);
        turns + at(index) + share * (at(index + 1) - at(index))
    }

    /// Returns whether there is a corner at this whole number of pieces.
    pub(super) fn is_corner(&self, at: usize) -> bool {
        let count = self.count();
        let inside = if at == count { count } else { at % count };
        self.corners.get(inside).copied().unwrap_or(false)
    }
}

/// Returns where a cell or branch of a square lies.
pub(super) fn corner(square: [usize; 2]) -> Node {
    square.map(count)
}
