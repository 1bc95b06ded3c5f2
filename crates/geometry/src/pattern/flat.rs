//! The flat pattern of a patch or of a chain of patches.

use super::contour::PatternContour;
use super::crossing::crossing;
use super::error::{PatternError, PatternResult};
use super::flattening::Flattening;
use super::outline::PatternOutline;
use super::panel::At;
use super::piece::Piece;
use super::placement::Placement;
use super::segment::Segment;
use super::source::PatternEvidence;
use crate::parallel::prelude::*;
use crate::vector::{cross, dot};

/// A ruling of a flat pattern.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FlatRuling {
    /// The patch of the chain that it belongs to.
    pub piece: usize,
    /// Its parameter there, in [0, 1].
    pub x: f64,
    /// Its ends on the first and on the second rail.
    pub ends: [[f64; 2]; 2],
    /// The angle in radians by which the sheet is folded here when it is bent along the rulings of the pattern and
    /// is flat in between: between the tangent planes halfway to the rulings before and after. Positive where both
    /// sides rise towards the viewer. Zero for the first and the last ruling.
    pub bend: f64,
    /// The smallest radius of the bent sheet along the ruling; infinite where it is flat.
    pub radius: f64,
    /// Where the line of the ruling meets the edge of regression, outside the patch; `None` where it is parallel to
    /// its neighbours.
    pub regression: Option<[f64; 2]>,
}

/// Ends of a ruling nearer to each other than this share of their distance from the origin are one point.
const ONE_POINT: f64 = 1e-12;

impl FlatRuling {
    /// Whether it is a point: the tip in which a gore or the head of a sail ends.
    #[must_use]
    pub fn is_point(&self) -> bool {
        let size = self
            .ends
            .iter()
            .flatten()
            .fold(0.0_f64, |m, c| m.max(c.abs()));
        let [from, to] = self.ends;
        libm::hypot(to[0] - from[0], to[1] - from[1]) <= ONE_POINT * size
    }
}

/// Bounds for the errors of a flat pattern, against the exact development. Of a patch that is not exactly developable
/// against the development that it is ([`FlatPattern::flattening`]): how far that may be from others is the
/// `ambiguity`. They are proved or measured, as [`FlatPattern::evidence`] says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PatternErrors {
    /// The largest distance of the cut outline from the exact one, both ways.
    pub outline: f64,
    /// The largest error of a flat point: ends of rulings, marks.
    pub point: f64,
    /// The largest error of the angle between two flat rulings, in radians.
    pub angle: f64,
    /// The error of the length of the cut outline.
    pub length: f64,
    /// The error of the area inside the cut outline.
    pub area: f64,
    /// Every other development with a strain of at most `1 - cos(twist)`, as each of [`Flattening`] has, lies within
    /// this of the exact outline of this one, after a motion. Zero for exactly developable patches.
    pub ambiguity: f64,
}

/// A flat pattern: what is cut and where it is bent. It is made by [`unroll`](super::unroll) or
/// [`Unrolling`](super::Unrolling), moved by [`FlatPattern::placed`], and grows by
/// [`FlatPattern::append`].
#[derive(Debug, Clone, PartialEq)]
pub struct FlatPattern {
    pub(super) pieces: Vec<Piece>,
    /// What is cut in place of rails and end rulings, of one plane patch.
    pub(super) contour: Option<PatternContour>,
    outline: PatternOutline,
    rulings: Vec<FlatRuling>,
    errors: PatternErrors,
    /// The strain up to which it counts as developable.
    pub(super) developable: f64,
    pub(super) tolerance: f64,
}

impl FlatPattern {
    /// The pattern of these pieces, whose outline must not meet itself.
    ///
    /// # Errors
    /// [`PatternError::CrossesItself`].
    pub(super) fn from_pieces(
        pieces: Vec<Piece>,
        developable: f64,
        tolerance: f64,
    ) -> PatternResult<Self> {
        let look = |outline: &PatternOutline| crossing(outline.segments(), 0.25 * tolerance);
        match Self::seen(pieces, developable, tolerance, look) {
            (_, Some((segments, at))) => Err(PatternError::CrossesItself { at, segments }),
            (flat, None) => Ok(flat),
        }
    }

    /// The pattern of these pieces, and what is found of its outline. The rulings know nothing of the outline: they are
    /// made beside it.
    fn seen<T: Send>(
        pieces: Vec<Piece>,
        developable: f64,
        tolerance: f64,
        look: impl FnOnce(&PatternOutline) -> T + Send,
    ) -> (Self, T) {
        let bounded = || {
            let (outline, snapped) = outline(&pieces);
            let errors = errors(&pieces, &outline, snapped);
            (look(&outline), outline, errors)
        };
        let (rulings, (found, outline, errors)) =
            crate::parallel::join(|| rulings(&pieces), bounded);
        let flat = Self {
            pieces,
            contour: None,
            outline,
            rulings,
            errors,
            developable,
            tolerance,
        };
        (flat, found)
    }

    /// The pattern of one plane patch, cut along this contour.
    pub(super) fn with_contour(self, contour: PatternContour) -> Self {
        let outline = PatternOutline::new(contour.segments.clone());
        let (PatternErrors { point, .. }, cut) = (self.errors, outline.length());
        #[allow(clippy::cast_precision_loss)]
        let ends = contour.segments.len() as f64;
        let rounding = 16.0 * f64::EPSILON * cut;
        let errors = PatternErrors {
            outline: point + contour.distance,
            // Both ends of a segment are off by so much, and an arc is up to twice as long as its chord.
            length: contour.length_error + 4.0 * ends * point + rounding,
            area: contour.area_error + 2.0 * cut * point + cut * rounding,
            ..self.errors
        };
        Self {
            contour: Some(contour),
            outline,
            rulings: Vec::new(),
            errors,
            ..self
        }
    }

    /// The closed outline: along the rails, across at the first and the last ruling. It is simple: it does not meet
    /// itself.
    #[must_use]
    pub fn outline(&self) -> &PatternOutline {
        &self.outline
    }

    /// The rulings in the order of the chain. At a joint the end of one patch stands for both.
    #[must_use]
    pub fn rulings(&self) -> &[FlatRuling] {
        &self.rulings
    }

    /// Bounds for the errors.
    #[must_use]
    pub fn errors(&self) -> PatternErrors {
        self.errors
    }

    /// The tolerance that was asked for.
    #[must_use]
    pub fn tolerance(&self) -> f64 {
        self.tolerance
    }

    /// The largest share of its length by which a line on the patch is stretched or shortened in the plane: zero for
    /// what is exactly developable.
    #[must_use]
    pub fn strain(&self) -> f64 {
        let each = self.pieces.iter().map(|p| p.development.strain);
        each.fold(0.0, f64::max)
    }

    /// Which development it is, where a patch is not exactly developable.
    #[must_use]
    pub fn flattening(&self) -> Option<Flattening> {
        let inexact = self.pieces.iter().find(|p| !p.development.exact);
        inexact.map(|p| p.development.flattening)
    }

    /// Whether the bounds are proved.
    #[must_use]
    pub fn evidence(&self) -> PatternEvidence {
        let each = self.pieces.iter().map(|p| p.development.evidence);
        let contour = self.contour.iter().map(|contour| contour.evidence);
        each.chain(contour)
            .min()
            .unwrap_or(PatternEvidence::Measured)
    }

    /// By how much the flat edges of a patch of the chain are shorter than its edges in space, at most: zero for what
    /// is exactly developable, and for edges that the development keeps.
    #[must_use]
    pub fn shortened(&self, piece: usize) -> Option<[f64; 2]> {
        self.pieces.get(piece).map(|p| p.development.shortened)
    }

    /// The pattern of patches that lie elsewhere in space.
    pub(crate) fn moved_in_space(self, by: [f64; 3]) -> Self {
        let pieces = self.pieces.into_iter().map(|p| p.moved_in_space(by));
        Self {
            pieces: pieces.collect(),
            ..self
        }
    }

    /// Whether a patch that is not developable was flattened by allowing strain.
    #[must_use]
    pub fn is_strained(&self) -> bool {
        self.strain() > self.developable
    }

    /// The area of the development, by integration over the patch and not from the outline; of a sheet that is cut along a
    /// contour, that inside of the contour.
    #[must_use]
    pub fn area(&self) -> f64 {
        if self.contour.is_some() {
            return self.outline.area();
        }
        self.pieces.iter().map(|p| p.development.area).sum()
    }

    /// The lengths of both rails of a patch of the chain, by integration and not from the outline.
    #[must_use]
    pub fn rail_lengths(&self, piece: usize) -> Option<[f64; 2]> {
        self.pieces.get(piece).map(|p| p.development.lengths)
    }

    /// How many patches the chain has.
    #[must_use]
    pub fn pieces(&self) -> usize {
        self.pieces.len()
    }

    /// The smallest radius of the bent sheet on the rulings of the pattern, to be compared with the thickness
    /// ([`is_bendable`](super::is_bendable)).
    #[must_use]
    pub fn smallest_radius(&self) -> f64 {
        let each = self.rulings.iter().map(|r| r.radius);
        each.fold(f64::INFINITY, f64::min)
    }

    /// The edge of regression near the pattern, as far as rulings show it: a chain of different points for each run of
    /// rulings of a patch that meet it within `reach` (a length) of the sheet.
    #[must_use]
    pub fn regression(&self, reach: f64) -> Vec<Vec<[f64; 2]>> {
        let near = |r: &FlatRuling| {
            let point = r.regression?;
            let away = r
                .ends
                .map(|e| libm::hypot(e[0] - point[0], e[1] - point[1]));
            (away[0].min(away[1]) <= reach).then_some(point)
        };
        // An apex is one point, however many rulings meet in it.
        let size = self.pieces.iter().map(|p| p.development.size);
        let same = 1e-9 * size.fold(0.0, f64::max);
        let mut chains = Vec::new();
        let mut chain: Vec<[f64; 2]> = Vec::new();
        let mut piece = 0;
        for ruling in &self.rulings {
            if ruling.piece != piece {
                // The next patch has an edge of its own.
                chains.push(std::mem::take(&mut chain));
                piece = ruling.piece;
            }
            match (near(ruling), chain.last()) {
                (Some(point), Some(last))
                    if libm::hypot(point[0] - last[0], point[1] - last[1]) <= same => {}
                (Some(point), _) => chain.push(point),
                (None, _) => chains.push(std::mem::take(&mut chain)),
            }
        }
        chains.push(chain);
        chains.retain(|c| !c.is_empty());
        chains
    }

    /// The pattern moved, turned, or turned over; bends change their sign when it is turned over.
    ///
    /// ```
    /// use torse_geometry::pattern::{Placement, unroll};
    /// use torse_geometry::{RuledSurface, curve::ellipse_arc};
    /// let ring = |z: f64| ellipse_arc(&[0.0, 0.0, z], &[2.0, 0.0, z], &[0.0, 2.0, z]);
    /// let flat = unroll(&RuledSurface::new(ring(0.0)?, ring(3.0)?), 17, 1e-6)?;
    /// let over = flat.placed(&Placement::mirrored().then(&Placement::shifted([0.0, 10.0])));
    /// assert_eq!(over.rulings()[3].bend, -flat.rulings()[3].bend);
    /// assert!((over.outline().area() - flat.outline().area()).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn placed(&self, placement: &Placement) -> Self {
        let place = |piece: &Piece| piece.clone().moved(placement, [0.0; 2]);
        let pieces = self.pieces.iter().map(place).collect();
        let placed = Self::seen(pieces, self.developable, self.tolerance, |_| ()).0;
        match &self.contour {
            Some(contour) => placed.with_contour(contour.placed(placement)),
            None => placed,
        }
    }
}

/// Rulings that a thread takes at a time.
const SHARE: usize = 128;

fn rulings(pieces: &[Piece]) -> Vec<FlatRuling> {
    let mut list = Vec::new();
    for (index, piece) in pieces.iter().enumerate() {
        let stations = piece.stations();
        let halfway = piece.halfway();
        // The facet behind the last ruling is the first one of the next piece.
        let next = pieces.get(index + 1).and_then(|next| {
            let xs = next.halfway();
            next.seen(xs.get(..1)?).pop()
        });
        // The first ruling of a later piece is the last one of the piece before.
        let first = usize::from(index > 0);
        let stations = stations.get(first..).unwrap_or_default();
        let start = list.len();
        list.resize(start + stations.len(), BLANK);
        let room = list.get_mut(start..).unwrap_or_default();
        let shares = stations
            .par_chunks(SHARE)
            .zip(room.par_chunks_mut(SHARE))
            .enumerate();
        shares.for_each(|(share, (xs, slots))| {
            let number = first + share * SHARE;
            // The facets on both sides of each ruling, as the viewer sees them.
            let from = number.saturating_sub(1);
            let to = halfway.len().min(number + xs.len());
            let mut facets = piece.seen(halfway.get(from..to).unwrap_or_default());
            facets.extend(next.filter(|_| to < number + xs.len()));
            let facet = |number: usize| facets.get(number.checked_sub(from)?);
            let each = (number..).zip(xs).zip(piece.development.at_each(xs));
            for (slot, ((number, x), at)) in slots.iter_mut().zip(each) {
                let before = number.checked_sub(1).and_then(facet);
                let bend = match (before, facet(number)) {
                    (Some(m), Some(n)) => fold_angle(m, n, &piece.axis(&at)),
                    _ => 0.0,
                };
                *slot = FlatRuling {
                    piece: index,
                    x: *x,
                    ends: at.rails.map(|p| piece.placement.point(p)),
                    bend,
                    radius: at.radius(),
                    regression: at.regression().map(|p| piece.placement.point(p)),
                };
            }
        });
    }
    list
}

/// What stands in the place of a ruling until it is known.
const BLANK: FlatRuling = FlatRuling {
    piece: 0,
    x: 0.0,
    ends: [[0.0; 2]; 2],
    bend: 0.0,
    radius: f64::INFINITY,
    regression: None,
};

/// Angles below this are rounding of the normals: the sheet is flat there.
const FLAT: f64 = 1e-13;

/// The angle from one normal to the next about an axis.
pub(super) fn fold_angle(m: &[f64; 3], n: &[f64; 3], axis: &[f64; 3]) -> f64 {
    let length = super::frame::norm(axis);
    let angle = libm::atan2(dot(&cross(m, n), axis) / length, dot(m, n));
    if angle.abs() < FLAT { 0.0 } else { angle }
}

impl At {
    /// The smallest radius of curvature along the ruling.
    fn radius(&self) -> f64 {
        let across = self.across[0].min(self.across[1]).max(0.0);
        let flat = 1e-9 * (self.across[0] + self.across[1]) / self.length;
        if self.bending.abs() <= flat {
            f64::INFINITY
        } else {
            across / self.bending.abs()
        }
    }

    /// The flat point of the edge of regression.
    fn regression(&self) -> Option<[f64; 2]> {
        let [a, b] = self.across;
        let v = a / (a - b);
        let parallel = (a - b).abs() <= 1e-9 * (a + b).abs();
        let [p, q] = self.rails;
        let point = [p[0] + v * (q[0] - p[0]), p[1] + v * (q[1] - p[1])];
        (!parallel && v.is_finite()).then_some(point)
    }
}

/// The closed outline, and the largest distance by which ends were moved to meet.
fn outline(pieces: &[Piece]) -> (PatternOutline, f64) {
    let mut segments: Vec<Segment> = Vec::new();
    for piece in pieces {
        segments.extend(piece.rail(1 - piece.left()));
    }
    let across = |piece: &Piece, last: bool| {
        let at = piece.development.at(piece.end(last));
        let ends =
            [piece.left(), 1 - piece.left()].map(|side| piece.placement.point(at.rails[side]));
        Segment::line(ends[0], ends[1])
    };
    if let Some(last) = pieces.last() {
        segments.push(across(last, true).reversed());
    }
    for piece in pieces.iter().rev() {
        let rail = piece.rail(piece.left());
        segments.extend(rail.iter().rev().map(Segment::reversed));
    }
    if let Some(first) = pieces.first() {
        segments.push(across(first, false));
    }
    // Ends that belong together differ by rounding, or at joints by the difference of the patches.
    let mut snapped = 0.0_f64;
    let count = segments.len();
    for i in 0..count {
        let start = segments[(i + 1) % count].from;
        let end = segments[i].to;
        snapped = snapped.max(libm::hypot(start[0] - end[0], start[1] - end[1]));
        segments[i].to = start;
    }
    let size = pieces.iter().map(|p| p.development.size);
    let (segments, dropped) =
        without_points(segments, 64.0 * f64::EPSILON * size.fold(0.0, f64::max));
    (PatternOutline::new(segments), snapped.max(dropped))
}

/// The closed chain without segments that are points up to rounding (a rail that is an apex), so that neighbours share
/// their ends; and the largest distance by which an end was moved.
fn without_points(segments: Vec<Segment>, rounding: f64) -> (Vec<Segment>, f64) {
    let mut kept: Vec<Segment> = Vec::with_capacity(segments.len());
    let mut moved = 0.0_f64;
    for segment in segments {
        let from = kept.last().map_or(segment.from, |last| last.to);
        let length = libm::hypot(segment.to[0] - from[0], segment.to[1] - from[1]);
        if length > rounding {
            kept.push(Segment { from, ..segment });
        } else {
            // The next one starts where the last one ends.
            moved = moved.max(length);
        }
    }
    if let (Some(first), Some(last)) = (kept.first().copied(), kept.last_mut()) {
        moved = moved.max(libm::hypot(
            first.from[0] - last.to[0],
            first.from[1] - last.to[1],
        ));
        last.to = first.from;
    }
    (kept, moved)
}

fn errors(pieces: &[Piece], outline: &PatternOutline, snapped: f64) -> PatternErrors {
    let largest = |f: &dyn Fn(&Piece) -> f64| pieces.iter().map(f).fold(0.0, f64::max);
    let rounding = 8.0 * f64::EPSILON * largest(&|p| p.development.size);
    let point = largest(&|p| p.development.error + p.inherited[0]) + rounding;
    let fitted = largest(&|p| p.fitted);
    let angle = 2.0 * largest(&|p| p.development.angle_error + p.inherited[1]);
    let exact: f64 = pieces
        .iter()
        .map(|p| p.development.lengths.iter().sum::<f64>())
        .sum();
    let across = |piece: Option<&Piece>, last: bool| {
        piece.map_or(0.0, |p| p.development.at(p.end(last)).length)
    };
    let exact = exact + across(pieces.first(), false) + across(pieces.last(), true);
    let area: f64 = pieces.iter().map(|p| p.development.area).sum();
    let quadrature = |k: usize| {
        pieces
            .iter()
            .map(|p| p.development.quadrature[k])
            .sum::<f64>()
    };
    let cut = outline.length();
    PatternErrors {
        outline: point + fitted + snapped,
        point: point + snapped,
        angle,
        length: (cut - exact).abs() + quadrature(0) + 16.0 * f64::EPSILON * cut,
        area: (outline.area() - area).abs() + quadrature(1) + cut * rounding,
        ambiguity: largest(&|p| p.development.ambiguity + p.moved_by_choice),
    }
}
