//! Between the sheet and space: where marks, holes and curves go.
//!
//! A point of the sheet belongs to the ruling at `x` and the share `v` of it: in space `(1 - v) P(x) + v Q(x)`, flat
//! the same combination of the flat rails. The way back looks for the nearest ruling: samples on every interval of
//! the development, then golden-section search. At a point of the patch the distance falls
//! linearly to zero, so that the search finds it to rounding; on an edge of regression, which may be a border of
//! the patch, with the square, so that the ruling is found to half the digits and the point still to all.

use super::error::PatternResult;
use super::flat::FlatPattern;
use super::piece::Piece;

/// A place on a patch of a flat pattern: on the ruling at `x`, at the share `v` of the way from the first to the
/// second rail, both in [0, 1].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatternPlace {
    /// The patch of the chain.
    pub piece: usize,
    /// The parameter of the ruling.
    pub x: f64,
    /// The share of the ruling.
    pub v: f64,
}

/// Samples of an interval of the development.
const SAMPLES: u32 = 24;
/// Steps of the golden section: the bracket shrinks to rounding.
const STEPS: usize = 76;
/// The most points of a carried curve.
const MAX_POINTS: usize = 1 << 18;

impl FlatPattern {
    /// The flat image of a place; `None` unless it is on a patch of the pattern.
    ///
    /// ```
    /// use torse_geometry::pattern::{PatternPlace, unroll};
    /// use torse_geometry::{RuledSurface, curve::ellipse_arc};
    /// // A quarter of a cylinder; a hole halfway up at 30 degrees.
    /// let ring = |z: f64| ellipse_arc(&[0.0, 0.0, z], &[2.0, 0.0, z], &[0.0, 2.0, z]);
    /// let flat = unroll(&RuledSurface::new(ring(0.0)?, ring(3.0)?), 17, 1e-6)?;
    /// let hole = flat.flatten(PatternPlace { piece: 0, x: 1.0 / 3.0, v: 0.5 }).ok_or("outside")?;
    /// assert!((hole[0] - 1.5).abs() < 1e-12 && (hole[1] - std::f64::consts::PI / 3.0).abs() < 1e-12);
    /// // Back into space.
    /// let [x, y, z] = flat.lift(hole).ok_or("outside")?;
    /// assert!((x - 3_f64.sqrt()).abs() < 1e-12 && (y - 1.0).abs() < 1e-12 && (z - 1.5).abs() < 1e-12);
    /// assert_eq!(flat.lift([9.0, 9.0]), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn flatten(&self, place: PatternPlace) -> Option<[f64; 2]> {
        let piece = self.piece_of(place)?;
        let [p, q] = piece.development.at(place.x).rails;
        Some(piece.placement.point(between(&p, &q, place.v)))
    }

    /// The point of the patch in space; `None` unless the place is on a patch of the pattern.
    #[must_use]
    pub fn space(&self, place: PatternPlace) -> Option<[f64; 3]> {
        let piece = self.piece_of(place)?;
        let [p, q] = piece.development.at(place.x).space;
        Some(between(&p, &q, place.v))
    }

    /// The place of a point of the sheet; `None` outside the pattern, by more than the error of its points.
    #[must_use]
    pub fn locate(&self, point: [f64; 2]) -> Option<PatternPlace> {
        let slack = self.errors().outline.max(1e-9 * self.reach());
        self.nearest(slack, |piece| {
            let point = piece.placement.point_back(point);
            move |x: f64| {
                let [p, q] = piece.development.at(x).rails;
                to_segment(&p, &q, &point)
            }
        })
    }

    /// The point in space of a point of the sheet; `None` outside the pattern.
    #[must_use]
    pub fn lift(&self, point: [f64; 2]) -> Option<[f64; 3]> {
        self.space(self.locate(point)?)
    }

    /// The place nearest to a point in space; `None` when it is farther than `within` from the pattern.
    #[must_use]
    pub fn locate_in_space(&self, point: [f64; 3], within: f64) -> Option<PatternPlace> {
        self.nearest(within, |piece| {
            move |x: f64| {
                let [p, q] = piece.development.at(x).space;
                to_segment(&p, &q, &point)
            }
        })
    }

    /// Carries a curve on a patch, `t -> [x, v]` for `t` in [0, 1], to the sheet, as a polygon that deviates from its
    /// image by about `chord`: steps are halved while three points between leave the chord by more.
    ///
    /// # Errors
    /// [`PatternError::OutOfRange`](super::PatternError::OutOfRange) unless `chord > 0` and where the curve
    /// leaves the patch, [`PatternError::NotReached`](super::PatternError::NotReached) when the curve is not
    /// followed by 2^18 points.
    ///
    /// ```
    /// use torse_geometry::pattern::unroll;
    /// use torse_geometry::{RuledSurface, curve::ellipse_arc};
    /// let ring = |z: f64| ellipse_arc(&[0.0, 0.0, z], &[2.0, 0.0, z], &[0.0, 2.0, z]);
    /// let flat = unroll(&RuledSurface::new(ring(0.0)?, ring(3.0)?), 17, 1e-6)?;
    /// // The diagonal is a helix on the cylinder: straight in the plane.
    /// let marks = flat.carry(0, |t| [t, t], 1e-6)?;
    /// assert_eq!(marks.len(), 2);
    /// let round = flat.carry(0, |t| [0.5 + 0.1 * (6.28 * t).cos(), 0.5 + 0.1 * (6.28 * t).sin()], 1e-3)?;
    /// assert!(round.len() > 16);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn carry(
        &self,
        piece: usize,
        curve: impl Fn(f64) -> [f64; 2],
        chord: f64,
    ) -> PatternResult<Vec<[f64; 2]>> {
        super::error::positive("chord tolerance", chord)?;
        let at = |t: f64| {
            let [x, v] = curve(t);
            let outside = || super::PatternError::OutOfRange {
                name: "place on the patch",
                value: if (0.0..=1.0).contains(&x) { v } else { x },
                range: "[0, 1]",
            };
            self.flatten(PatternPlace { piece, x, v })
                .ok_or_else(outside)
        };
        let mut points = vec![at(0.0)?];
        // At least eight steps are looked at, so that a closed curve is not taken for a point.
        let mut open: Vec<(f64, f64)> = (0..8)
            .rev()
            .map(|k| (0.125 * f64::from(k), 0.125 * f64::from(k + 1)))
            .collect();
        while let Some((from, to)) = open.pop() {
            let (a, b) = (at(from)?, at(to)?);
            let mut off = 0.0_f64;
            for share in [0.25, 0.5, 0.75] {
                let between = at(from + share * (to - from))?;
                off = off.max(to_segment::<2>(&a, &b, &between).0);
            }
            if off <= chord {
                points.push(b);
            } else if points.len() + open.len() >= MAX_POINTS || to - from < 1e-12 {
                return Err(super::PatternError::NotReached {
                    reached: off,
                    demanded: chord,
                    x: from,
                });
            } else {
                let middle = 0.5 * (from + to);
                open.push((middle, to));
                open.push((from, middle));
            }
        }
        Ok(straightened(&points, chord))
    }

    fn piece_of(&self, place: PatternPlace) -> Option<&Piece> {
        let unit = 0.0..=1.0;
        let inside = unit.contains(&place.x) && unit.contains(&place.v);
        self.pieces.get(place.piece).filter(|_| inside)
    }

    fn reach(&self) -> f64 {
        let sizes = self.pieces.iter().map(|p| p.development.size);
        sizes.fold(0.0, f64::max)
    }

    /// The ruling with the least distance, if that is within `slack`, where `distance` makes the function of `x` of
    /// a patch.
    fn nearest<'a, F: Fn(f64) -> (f64, f64)>(
        &'a self,
        slack: f64,
        distance: impl Fn(&'a Piece) -> F,
    ) -> Option<PatternPlace> {
        let mut best: Option<(f64, PatternPlace)> = None;
        for (index, piece) in self.pieces.iter().enumerate() {
            let at = distance(piece);
            let xs = samples(piece);
            let values: Vec<f64> = xs.iter().map(|x| at(*x).0).collect();
            for (k, value) in values.iter().enumerate() {
                let near = |i: usize| values.get(i).copied().unwrap_or(f64::INFINITY);
                let before = if k == 0 { f64::INFINITY } else { near(k - 1) };
                if *value > before || *value > near(k + 1) {
                    continue;
                }
                let low = xs.get(k.saturating_sub(1)).copied().unwrap_or(0.0);
                let high = xs.get(k + 1).copied().unwrap_or(1.0);
                let x = golden(&at, low, high);
                let (off, v) = at(x);
                if off <= slack && best.is_none_or(|(least, _)| off < least) {
                    best = Some((off, PatternPlace { piece: index, x, v }));
                }
            }
        }
        best.map(|(_, place)| place)
    }
}

fn samples(piece: &Piece) -> Vec<f64> {
    let mut list = vec![0.0];
    for panel in piece.development.panels() {
        let [from, to] = panel.range();
        let step = |k: u32| from + (to - from) * f64::from(k) / f64::from(SAMPLES);
        list.extend((1..=SAMPLES).map(step));
    }
    list
}

/// The least value of the first component on an interval, ends included.
fn golden(f: &impl Fn(f64) -> (f64, f64), low: f64, high: f64) -> f64 {
    let ratio = 0.5 * (5.0_f64.sqrt() - 1.0);
    let (mut a, mut b) = (low, high);
    let (mut left, mut right) = (b - ratio * (b - a), a + ratio * (b - a));
    let (mut at_left, mut at_right) = (f(left).0, f(right).0);
    for _ in 0..STEPS {
        if at_left <= at_right {
            (b, right, at_right) = (right, left, at_left);
            left = b - ratio * (b - a);
            at_left = f(left).0;
        } else {
            (a, left, at_left) = (left, right, at_right);
            right = a + ratio * (b - a);
            at_right = f(right).0;
        }
    }
    let middle = 0.5 * (a + b);
    let better = |best: f64, x: f64| if f(x).0 < f(best).0 { x } else { best };
    better(better(middle, low), high)
}

fn between<const D: usize>(p: &[f64; D], q: &[f64; D], v: f64) -> [f64; D] {
    crate::vector::lerp(p, q, &v)
}

/// The distance of a point from a segment, and the share of its foot.
fn to_segment<const D: usize>(p: &[f64; D], q: &[f64; D], point: &[f64; D]) -> (f64, f64) {
    let along: [f64; D] = crate::vector::sub(q, p);
    let from: [f64; D] = crate::vector::sub(point, p);
    let product = |a: &[f64; D], b: &[f64; D]| a.iter().zip(b).map(|(x, y)| x * y).sum::<f64>();
    let square = product(&along, &along);
    let share = if square > 0.0 {
        (product(&from, &along) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    let foot = between(p, q, share);
    (
        crate::vector::norm(&crate::vector::sub(point, &foot)),
        share,
    )
}

/// Without the points between that a straight run does not need.
fn straightened(points: &[[f64; 2]], chord: f64) -> Vec<[f64; 2]> {
    let mut kept: Vec<[f64; 2]> = Vec::new();
    let mut run: Vec<[f64; 2]> = Vec::new();
    for point in points {
        if let Some(start) = kept.last() {
            let off = |p: &[f64; 2]| to_segment::<2>(start, point, p).0;
            // A tenth, so that what was below the chord stays about there.
            if run.iter().any(|p| off(p) > 0.1 * chord) {
                kept.extend(run.last().copied());
                run.clear();
            }
            run.push(*point);
        } else {
            kept.push(*point);
        }
    }
    kept.extend(run.last().copied());
    kept
}
