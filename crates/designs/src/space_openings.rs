//! Openings in space, and borders of plane patches: the part of each that lies on a patch, for meshes, CAD files and pictures.

use crate::design::{Design, Mark, Patch};
use crate::error::DesignError;
use crate::openings::{Opening, OpeningShape, openings};
use crate::polygon::is_within;
use crate::position::position;
use crate::unroll::{Demand, drawing, unroll};
use torse_geometry::pattern::{FlatPattern, PatternPlace, Segment};
use torse_geometry::prelude::{Point, Sheet};
use torse_geometry::vector::{dot, norm, scale, sub};

/// Which side of a closed curve on a patch is open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OpenSide {
    /// What is inside of it: an opening.
    Inside,
    /// What is outside of it: the border of the patch.
    Outside,
}

/// The part of an opening that lies on a patch, or its border.
#[derive(Debug, Clone)]
pub struct SpaceOpening {
    /// The index of the patch.
    pub patch: usize,
    /// Which side is open.
    pub open: OpenSide,
    /// Polygons of places `[u, v]` that bound what is open: one that is closed, or several that begin and end on the first or
    /// the last ruling.
    pub borders: Vec<Vec<[f64; 2]>>,
    /// The smooth parts of its border as places `[u, v]` at steps of equal length, ends included; none where it goes on beyond
    /// the patch.
    runs: Vec<Vec<[f64; 2]>>,
    name: String,
}

/// Places no farther from the border of an opening than this share of its size are not told from it.
const NEAR_BORDER: f64 = 0.01;
/// Points of the curve around an opening, about so many.
const AROUND: f64 = 64.0;
/// The least steps of a smooth part of a curve.
const LEAST_STEPS: f64 = 8.0;
/// Segments whose directions differ by more, in radians, meet in a corner.
const CORNER: f64 = 0.1;
/// Halvings that find where an opening goes over to the next patch.
const HALVINGS: u32 = 50;
/// The most times a chord is halved to find the patches that it runs over.
const MAX_DEPTH: u32 = 24;

/// Returns the openings of all patches: those that are marked on them, and what of the openings of a neighbour reaches
/// onto them; and the borders of patches that have one of their own.
///
/// # Errors
/// As [`unroll`] and [`drawing`]: openings that leave the sheet, or overlap, are refused.
pub fn openings_in_space(design: &Design) -> Result<Vec<SpaceOpening>, DesignError> {
    let mut all = Vec::new();
    for piece in design.pieces() {
        let patches: Vec<(usize, &Patch)> = piece
            .patches
            .iter()
            .filter_map(|index| Some((*index, design.patches.get(*index)?)))
            .collect();
        if !patches
            .iter()
            .any(|(_, patch)| patch.border.is_some() || patch.marks.iter().any(Mark::is_opening))
        {
            continue;
        }
        let demand = Demand {
            only: Some(piece.name.clone()),
            allow_strain: 0.5,
            ..Demand::default()
        };
        let pieces = unroll(design, &demand)?;
        // What cannot be cut is refused here as there.
        drawing(design, &pieces)?;
        let Some(flat) = pieces.first().map(|piece| &piece.flat) else {
            continue;
        };
        let numbers: Vec<(usize, usize)> = patches
            .iter()
            .filter_map(|(index, patch)| Some((position(flat, patch)?, *index)))
            .collect();
        let border = patches
            .first()
            .and_then(|(_, patch)| patch.border.as_ref())
            .map(|border| Opening {
                shape: OpeningShape::Contour(flat.outline().segments().to_vec()),
                name: border.name.clone(),
                error: flat.errors().outline,
                proved: false,
                finished: None,
                patch: 0,
            });
        let found = openings(design, &piece, flat)?.into_iter();
        let found = found.map(|opening| (OpenSide::Inside, opening));
        let all_curves = found.chain(border.map(|border| (OpenSide::Outside, border)));
        for (open, opening) in all_curves {
            let lost = || DesignError::Mark {
                patch: piece.name.clone(),
                reason: format!("{} is not found in space", opening.name),
            };
            let lifted = Lifted::new(flat, &opening, design.tolerances.surface).ok_or_else(lost)?;
            for (place, patch) in &numbers {
                let borders = lifted.borders(*place);
                if borders.is_empty() {
                    continue;
                }
                let runs = if lifted.is_on(*place) {
                    lifted.runs(&opening).ok_or_else(lost)?
                } else {
                    Vec::new()
                };
                all.push(SpaceOpening {
                    patch: *patch,
                    open,
                    borders,
                    runs,
                    name: opening.name.clone(),
                });
            }
        }
    }
    Ok(all)
}

impl SpaceOpening {
    /// Returns polygons of places that bound what is open: for a border the rails too, beyond which nothing is.
    #[must_use]
    pub fn bounds(&self) -> Vec<Vec<[f64; 2]>> {
        let mut bounds = self.borders.clone();
        if self.open == OpenSide::Outside {
            bounds.extend([0.0, 1.0].map(|v| vec![[0.0, v], [1.0, v]]));
        }
        bounds
    }

    /// Returns whether a place of the patch lies in what is open, or no farther from its border than a hundredth of the size of
    /// that: nothing is known of the sheet there.
    #[must_use]
    pub fn reaches(&self, sheet: &Sheet, place: [f64; 2]) -> bool {
        // The parts of one closed curve, which goes on along the first or the last ruling.
        let whole: Vec<[f64; 2]> = self.borders.iter().flatten().copied().collect();
        if is_within(&whole, place) == (self.open == OpenSide::Inside) {
            return true;
        }
        let in_space = |[u, v]: &[f64; 2]| sheet.point(*u, *v).ok();
        let Some(point) = in_space(&place) else {
            return true;
        };
        let borders: Vec<Vec<Point>> = self
            .borders
            .iter()
            .map(|border| border.iter().filter_map(in_space).collect())
            .collect();
        let corners: Vec<&Point> = borders.iter().flatten().collect();
        let size = (0..3).map(|axis| {
            let all = corners.iter().map(|corner| corner[axis]);
            let [low, high] = all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], c| {
                [low.min(c), high.max(c)]
            });
            high - low
        });
        let size = size.fold(0.0, f64::max);
        let mut sides = borders.iter().flat_map(|border| border.windows(2));
        let is_near = |side: &[Point]| {
            let [from, to] = side else { return false };
            let (way, arm) = (sub(to, from), sub(&point, from));
            let share = dot(&arm, &way) / dot(&way, &way).max(f64::MIN_POSITIVE);
            norm(&sub(&arm, &scale(&share.clamp(0.0, 1.0), &way))) <= NEAR_BORDER * size
        };
        sides.any(is_near)
    }

    /// Returns whether it goes on beyond the patch.
    #[must_use]
    pub fn is_clipped(&self) -> bool {
        self.runs.is_empty()
    }

    /// Returns the smooth parts of its border in space, run so that the patch is on the left as seen from the side to which the
    /// parameters turn against the clock.
    ///
    /// # Errors
    /// [`DesignError::Mark`] where a point is not found on the patch.
    pub fn around(&self, sheet: &Sheet) -> Result<Vec<Vec<Point>>, DesignError> {
        let all = self.runs.iter().flatten();
        let next = self.runs.iter().flatten().skip(1);
        let start = self.runs.iter().flatten().take(1);
        let turned: f64 = all
            .zip(next.chain(start))
            .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
            .sum();
        let mut runs = self.runs.clone();
        if (turned > 0.0) == (self.open == OpenSide::Inside) {
            runs.reverse();
            for run in &mut runs {
                run.reverse();
            }
        }
        let lifted = runs.into_iter().map(|run| {
            let points = run.into_iter().map(|[u, v]| sheet.point(u, v));
            points.collect::<Result<Vec<Point>, _>>()
        });
        lifted
            .collect::<Result<_, _>>()
            .map_err(|reason| DesignError::Mark {
                patch: self.patch.to_string(),
                reason: format!("{} is not found in space: {reason}", self.name),
            })
    }
}

/// A fine polygon around an opening, with the place of each corner.
struct Lifted<'a> {
    flat: &'a FlatPattern,
    /// Where it goes from one patch to the next both places stand.
    places: Vec<PatternPlace>,
}

impl<'a> Lifted<'a> {
    fn new(flat: &'a FlatPattern, opening: &Opening, within: f64) -> Option<Self> {
        let mut places: Vec<PatternPlace> = Vec::new();
        for [from, to] in opening.shape.chords(0.5 * within) {
            let (a, b) = (flat.locate(from)?, flat.locate(to)?);
            places.push(a);
            let mut lifted = Self {
                flat,
                places: Vec::new(),
            };
            lifted.cross([from, to], [a, b], 0)?;
            places.append(&mut lifted.places);
        }
        Some(Self { flat, places })
    }

    /// Adds the places at which a chord goes from patch to patch.
    fn cross(&mut self, ends: [[f64; 2]; 2], [a, b]: [PatternPlace; 2], depth: u32) -> Option<()> {
        if a.piece == b.piece {
            return Some(());
        }
        let at = |share: f64| [0, 1].map(|i| ends[0][i] + share * (ends[1][i] - ends[0][i]));
        if a.piece.abs_diff(b.piece) > 1 && depth < MAX_DEPTH {
            let middle = at(0.5);
            let place = self.flat.locate(middle)?;
            self.cross([ends[0], middle], [a, place], depth + 1)?;
            return self.cross([middle, ends[1]], [place, b], depth + 1);
        }
        let (mut low, mut high, mut before, mut after) = (0.0, 1.0, a, b);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            let place = self.flat.locate(at(middle))?;
            if place.piece == a.piece {
                (low, before) = (middle, place);
            } else {
                (high, after) = (middle, place);
            }
        }
        // Exactly on the ruling that both share.
        for place in [before, after] {
            let x = if place.x < 0.5 { 0.0 } else { 1.0 };
            self.places.push(PatternPlace { x, ..place });
        }
        Some(())
    }

    /// Returns whether all of it is on this patch.
    fn is_on(&self, piece: usize) -> bool {
        self.places.iter().all(|place| place.piece == piece)
    }

    /// Returns the polygons on a patch.
    fn borders(&self, piece: usize) -> Vec<Vec<[f64; 2]>> {
        let count = self.places.len();
        let is_here = |k: usize| self.places.get(k % count).is_some_and(|p| p.piece == piece);
        let at = |k: usize| self.places.get(k % count).map(|p| [p.x, p.v]);
        let Some(first) = (0..count).find(|k| is_here(*k) && !is_here(k + count - 1)) else {
            // All of it, or nothing.
            let all = (0..=count).filter_map(at).collect();
            return if is_here(0) { vec![all] } else { Vec::new() };
        };
        let mut borders: Vec<Vec<[f64; 2]>> = Vec::new();
        for k in first..first + count {
            if !is_here(k) {
                continue;
            }
            if !is_here(k + count - 1) {
                borders.push(Vec::new());
            }
            if let Some(border) = borders.last_mut() {
                border.extend(at(k));
            }
        }
        borders
    }

    /// Returns the smooth parts of the border.
    fn runs(&self, opening: &Opening) -> Option<Vec<Vec<[f64; 2]>>> {
        let contour = opening.shape.contour();
        let whole: f64 = contour.iter().map(Segment::length).sum();
        let smooth = smooth_parts(&contour);
        let mut runs = Vec::with_capacity(smooth.len());
        for part in smooth {
            let length: f64 = part.iter().map(Segment::length).sum();
            let steps = (AROUND * length / whole).ceil().max(LEAST_STEPS);
            let mut run = Vec::new();
            let mut k = 0.0;
            while k <= steps {
                let point = along(&part, k / steps * length)?;
                let place = self.flat.locate(point)?;
                run.push([place.x, place.v]);
                k += 1.0;
            }
            runs.push(run);
        }
        Some(runs)
    }
}

/// Returns the parts of a closed contour between its corners.
fn smooth_parts(contour: &[Segment]) -> Vec<Vec<Segment>> {
    let direction = |segment: &Segment, at_end: bool| {
        let way = [0, 1].map(|i| segment.to[i] - segment.from[i]);
        let half = 0.5 * segment.angle();
        libm::atan2(way[1], way[0]) + if at_end { half } else { -half }
    };
    let count = contour.len();
    let turns = |k: usize| {
        let pair = [contour.get((k + count - 1) % count), contour.get(k % count)];
        let [Some(before), Some(after)] = pair else {
            return false;
        };
        let turn = direction(after, false) - direction(before, true);
        let turn = libm::remainder(turn, 2.0 * std::f64::consts::PI);
        turn.abs() > CORNER
    };
    let first = (0..count).find(|k| turns(*k)).unwrap_or(0);
    let mut parts: Vec<Vec<Segment>> = Vec::new();
    for k in first..first + count {
        if parts.is_empty() || turns(k) {
            parts.push(Vec::new());
        }
        if let Some(part) = parts.last_mut() {
            part.extend(contour.get(k % count));
        }
    }
    parts
}

/// Returns the point at a length along segments in a row.
fn along(part: &[Segment], mut length: f64) -> Option<[f64; 2]> {
    for segment in part {
        let own = segment.length();
        if length <= own {
            return Some(segment.point(length / own));
        }
        length -= own;
    }
    part.last().map(|last| last.to)
}
