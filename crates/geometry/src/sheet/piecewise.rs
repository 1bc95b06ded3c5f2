//! Curves of several pieces, and what two of them have in common.

use super::{Point, Rail};
use crate::basis::BasisShape;
use crate::coordinate::Coordinate;
use crate::curve::{AffineMap, Bezier, EllipticHelix, Spline};
use crate::error::{GeometryError, Place, Result};
use crate::vector::{norm, sub};
use std::cmp::Ordering;
use torse_algebra::Rational;

/// A curve in space over [0, 1] that consists of pieces: a spline, a polygon, arcs in a row.
///
/// Invariants: one piece at least; breaks rise from 0 to 1, one more than pieces; piece `i` runs from break `i` to
/// break `i + 1`. Pieces of splines are exact; whether pieces meet is what [`PiecewiseRail::gap`] tells.
///
/// ```
/// use torse_geometry::curve::{EndCondition, Spacing, interpolate};
/// use torse_geometry::prelude::*;
/// let points = [[0.0, 0.0, 0.0], [3.0, 4.0, 0.0], [6.0, 4.0, 2.0], [9.0, 0.0, 2.0]];
/// let spline = interpolate(&points, Spacing::Chord, [EndCondition::Natural; 2])?.spline;
/// let rail = PiecewiseRail::spline(&spline)?;
/// assert_eq!((rail.count(), rail.gap()?), (3, 0.0));
/// assert_eq!(rail.point(1.0)?, [9.0, 0.0, 2.0]);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct PiecewiseRail {
    pieces: Vec<Piece>,
    breaks: Vec<Rational>,
}

/// A piece: exact where it can be cut exactly.
#[derive(Debug, Clone, PartialEq)]
enum Piece {
    Exact(Bezier),
    Rail(Rail),
}

impl Piece {
    fn rail(&self) -> Result<Rail> {
        match self {
            Self::Exact(bezier) => Rail::try_from(bezier),
            Self::Rail(rail) => Ok(rail.clone()),
        }
    }

    /// Returns the parts before and after a share of the piece.
    fn split(&self, x: &Rational) -> Result<[Self; 2]> {
        Ok(match self {
            Self::Exact(bezier) => bezier.split(x)?.map(Self::Exact),
            Self::Rail(rail) => rail.split(x.approximate())?.map(Self::Rail),
        })
    }

    fn reversed(&self) -> Result<Self> {
        self.rail().map(|rail| Self::Rail(rail.reversed()))
    }
}

/// The curve on f64: each control point and weight is rounded once, and the exact ones are kept.
impl TryFrom<&Bezier> for Rail {
    type Error = GeometryError;

    fn try_from(bezier: &Bezier) -> Result<Self> {
        Self::rounded(
            BasisShape::Bernstein,
            bezier.homogeneous(),
            bezier.is_weighted(),
        )
    }
}

impl From<Rail> for PiecewiseRail {
    fn from(rail: Rail) -> Self {
        Self {
            pieces: vec![Piece::Rail(rail)],
            breaks: vec![Rational::default(), Rational::from_integer(1.into())],
        }
    }
}

impl From<EllipticHelix> for PiecewiseRail {
    fn from(curve: EllipticHelix) -> Self {
        Rail::from(curve).into()
    }
}

impl PiecewiseRail {
    /// Returns the pieces of a spline, with its knots as breaks.
    ///
    /// # Errors
    /// As [`Spline::pieces`].
    pub fn spline(spline: &Spline) -> Result<Self> {
        let pieces = spline.pieces()?.into_iter().map(Piece::Exact).collect();
        Ok(Self {
            pieces,
            breaks: spline.breaks(),
        })
    }

    /// Curves one after the other, each with a share of the parameter that goes with its length.
    ///
    /// The lengths are measured, rounded to f64 and are the definition from then on.
    ///
    /// # Errors
    /// [`GeometryError::TooFew`] without a curve, [`GeometryError::Degenerate`] for one without length.
    pub fn joined(curves: &[Self]) -> Result<Self> {
        let mut pieces = Vec::new();
        let mut ends = vec![Rational::default()];
        let mut start = Rational::default();
        for (index, curve) in curves.iter().enumerate() {
            let length = curve.length(1e-6)?;
            if !(length > 0.0 && length.is_finite()) {
                return Err(GeometryError::Degenerate {
                    what: "a curve without length in a row of curves",
                    at: Place::Index(index),
                });
            }
            let width = crate::exact(length);
            pieces.extend(curve.pieces.iter().cloned());
            let inside = curve.breaks.iter().skip(1);
            ends.extend(inside.map(|x| start.clone() + x.clone() * width.clone()));
            start += width;
        }
        if pieces.is_empty() {
            return Err(GeometryError::TooFew {
                what: "curves in a row",
                needed: 1,
                given: 0,
            });
        }
        let breaks = ends.into_iter().map(|x| x / start.clone()).collect();
        Ok(Self { pieces, breaks })
    }

    /// Returns how many pieces there are.
    #[must_use]
    pub fn count(&self) -> usize {
        self.pieces.len()
    }

    /// Returns the places between pieces, from 0 to 1.
    #[must_use]
    pub fn breaks(&self) -> &[Rational] {
        &self.breaks
    }

    /// Returns the pieces on f64, in order.
    ///
    /// # Errors
    /// What does not fit f64.
    pub fn rails(&self) -> Result<Vec<Rail>> {
        self.pieces.iter().map(Piece::rail).collect()
    }

    /// Returns the only piece; `None` of a curve of several.
    ///
    /// # Errors
    /// As [`PiecewiseRail::rails`].
    pub fn single(&self) -> Result<Option<Rail>> {
        match self.pieces.as_slice() {
            [piece] => piece.rail().map(Some),
            _ => Ok(None),
        }
    }

    /// Returns the piece at a parameter, and its own parameter there; the later one at a break.
    #[must_use]
    pub fn locate(&self, x: f64) -> (usize, f64) {
        let at = |k: usize| self.breaks.get(k).map_or(1.0, Coordinate::approximate);
        let inner = self.pieces.len().saturating_sub(1);
        let piece = (1..=inner).take_while(|&k| at(k) <= x).count();
        let (from, to) = (at(piece), at(piece + 1));
        (piece, ((x - from) / (to - from)).clamp(0.0, 1.0))
    }

    /// Returns the point at `x`.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] outside of [0, 1], and as [`Rail::point`].
    pub fn point(&self, x: f64) -> Result<Point> {
        if !(0.0..=1.0).contains(&x) {
            return Err(GeometryError::OutOfRange {
                name: "parameter of a curve",
                value: x,
                range: "[0, 1]",
            });
        }
        let (piece, share) = self.locate(x);
        match self.pieces.get(piece) {
            Some(piece) => piece.rail()?.point(share),
            None => Err(GeometryError::TooFew {
                what: "pieces of a curve",
                needed: 1,
                given: 0,
            }),
        }
    }

    /// Returns the length, with an error estimated to be at most `accuracy` a piece.
    ///
    /// # Errors
    /// As [`Rail::length`].
    pub fn length(&self, accuracy: f64) -> Result<f64> {
        let each = self
            .pieces
            .iter()
            .map(|piece| piece.rail()?.length(accuracy));
        each.sum()
    }

    /// Returns the largest distance of the end of a piece from the start of the next.
    ///
    /// # Errors
    /// As [`PiecewiseRail::rails`].
    pub fn gap(&self) -> Result<f64> {
        let rails = self.rails()?;
        let mut gap = 0.0_f64;
        for pair in rails.windows(2) {
            gap = gap.max(norm(&sub(&pair[0].point(1.0)?, &pair[1].point(0.0)?)));
        }
        Ok(gap)
    }

    /// Returns the same curve traversed backwards.
    ///
    /// # Errors
    /// As [`PiecewiseRail::rails`].
    pub fn reversed(&self) -> Result<Self> {
        let one = Rational::from_integer(1.into());
        Ok(Self {
            pieces: self
                .pieces
                .iter()
                .rev()
                .map(Piece::reversed)
                .collect::<Result<_>>()?,
            breaks: self
                .breaks
                .iter()
                .rev()
                .map(|x| one.clone() - x.clone())
                .collect(),
        })
    }

    /// Returns the image under an affine map: exact where there are weights or what f64 does not hold, else each control
    /// point is rounded once.
    ///
    /// # Errors
    /// As [`PiecewiseRail::rails`].
    pub fn mapped(&self, map: &AffineMap<f64>) -> Result<Self> {
        self.changed(|rail| Ok(rail.mapped(map)))
    }

    /// Returns the curve whose pieces are made from those of this one.
    ///
    /// # Errors
    /// As [`PiecewiseRail::rails`], and what `change` refuses.
    pub fn changed(&self, change: impl Fn(&Rail) -> Result<Rail>) -> Result<Self> {
        let image = |piece: &Piece| Ok(Piece::Rail(change(&piece.rail()?)?));
        Ok(Self {
            pieces: self.pieces.iter().map(image).collect::<Result<_>>()?,
            breaks: self.breaks.clone(),
        })
    }

    /// Returns the same curve, cut at these places as well; pieces of splines are cut exactly.
    ///
    /// # Errors
    /// As [`Rail::split`]: [`GeometryError::Degenerate`] where a curve with shape parameters would be cut.
    ///
    /// ```
    /// use torse_algebra::rational::ratio;
    /// use torse_geometry::prelude::*;
    /// let rail = PiecewiseRail::from(Rail::bezier(&[[0.0; 3], [2.0, 2.0, 0.0], [4.0, 0.0, 0.0]])?);
    /// let cut = rail.refined(&[ratio(1, 2).unwrap(), ratio(3, 4).unwrap()])?;
    /// assert_eq!(cut.count(), 3);
    /// assert_eq!(cut.rails()?[0].point(1.0)?, [2.0, 1.0, 0.0]);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn refined(&self, places: &[Rational]) -> Result<Self> {
        let mut places: Vec<&Rational> = places.iter().collect();
        places.sort();
        let (mut pieces, mut breaks) = (Vec::new(), vec![Rational::default()]);
        for (piece, ends) in self.pieces.iter().zip(self.breaks.windows(2)) {
            let (mut rest, mut from) = (piece.clone(), ends[0].clone());
            let to = &ends[1];
            for place in &places {
                let place: &Rational = place;
                if *place <= from || place >= to {
                    continue;
                }
                let share = (place.clone() - from.clone()) / (to.clone() - from);
                let [before, after] = rest.split(&share)?;
                pieces.push(before);
                breaks.push(place.clone());
                (rest, from) = (after, place.clone());
            }
            pieces.push(rest);
            breaks.push(to.clone());
        }
        Ok(Self { pieces, breaks })
    }

    /// Returns the part from `from` to `to`, with a parameter of its own in [0, 1].
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] unless `0 <= from < to <= 1`, and as [`PiecewiseRail::refined`].
    pub fn part(&self, from: &Rational, to: &Rational) -> Result<Self> {
        let (zero, one) = (Rational::default(), Rational::from_integer(1.into()));
        if *from < zero || *to > one || from.cmp(to) != Ordering::Less {
            return Err(GeometryError::OutOfRange {
                name: "start of a part",
                value: from.approximate(),
                range: "0 <= from < to <= 1",
            });
        }
        let cut = self.refined(&[from.clone(), to.clone()])?;
        let inside = |ends: &[Rational]| ends[0] >= *from && ends[1] <= *to;
        let kept = cut.pieces.into_iter().zip(cut.breaks.windows(2));
        let kept = kept.filter(|(_, ends)| inside(ends));
        let (pieces, ends): (Vec<Piece>, Vec<Rational>) =
            kept.map(|(piece, ends)| (piece, ends[1].clone())).unzip();
        let width = to.clone() - from.clone();
        let shares = ends.into_iter().map(|x| (x - from.clone()) / width.clone());
        Ok(Self {
            pieces,
            breaks: std::iter::once(zero).chain(shares).collect(),
        })
    }

    /// Returns both curves cut wherever one of them has a break: as many pieces each, at equal parameters.
    ///
    /// # Errors
    /// As [`PiecewiseRail::refined`].
    pub fn common_refinement(&self, other: &Self) -> Result<[Self; 2]> {
        Ok([self.refined(&other.breaks)?, other.refined(&self.breaks)?])
    }
}
