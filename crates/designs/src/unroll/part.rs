//! Parts: what is cut of each piece, and the files of a purpose.

use super::allowance::allowances;
use super::blank::{Blank, Rolled, SharpFold, ToolBend, blank};
use super::contour::{bounds, simplified, to_smallest_box, turned_to, vertices_of};
use super::marks::{FlatMark, flat_marks};
use super::notches::notches;
use super::offset::moved_outwards;
use super::{FlatPiece, drawing};
use crate::design::Design;
use crate::error::DesignError;
use crate::numbers::{at_most, without_trailing_zeros};
use crate::openings::{Opening, OpeningShape, openings};
use crate::position::position;
use std::f64::consts::{FRAC_1_SQRT_2, PI, SQRT_2};
use torse_exchange::{BendLine, Drawing, Layer};
use torse_geometry::pattern::{PatternEvidence, Placement, Segment};

/// What a pattern file is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// To be cut: one file a part, closed contours and nothing else.
    Cut,
    /// To be cut and bent: the bend lines of tools too.
    Bend,
    /// To be cut and sewn, welded or glued: the notches of seams too.
    Sew,
    /// To be folded back and compared: all pieces in one file, with every ruling and its angle.
    Fold,
}

impl Purpose {
    /// All with their names.
    pub const ALL: [(&'static str, Self); 4] = [
        ("cut", Self::Cut),
        ("bend", Self::Bend),
        ("sew", Self::Sew),
        ("fold", Self::Fold),
    ];
}

/// How parts lie on the sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grain {
    /// The line from the middle of the first ruling to that of the last runs along the drawing, and with it the grain.
    Along,
    /// It runs across the drawing.
    Across,
}

impl Grain {
    /// Both with their names on the command line.
    pub const ALL: [(&'static str, Self); 2] = [("along", Self::Along), ("across", Self::Across)];
}

/// How parts are cut.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CutOptions {
    /// The width of the cut in millimetres: outlines are moved outwards by half of it, openings inwards.
    pub kerf: f64,
    /// How parts lie; turned to their smallest boxes where nothing is said.
    pub grain: Option<Grain>,
}

/// The widest cut, in millimetres.
const MAX_KERF: f64 = 20.0;
/// Stroke width of cut lines in SVG, in millimetres: the widest that cutting services accept for a cut.
const HAIRLINE: f64 = 0.01;
/// Coordinates of parts are whole multiples of a millimetre over this: files have no digits that mean nothing.
const STEPS: f64 = 1e9;
/// What counts as nothing beside the size of a part when vertices are left out.
const ROUNDING: f64 = 1e-12;

/// What is drawn on a part and not cut.
#[derive(Debug, Clone, PartialEq)]
pub enum PartMark {
    /// A polygon.
    Line(Vec<[f64; 2]>),
    /// A circle: its centre and radius.
    Circle([f64; 2], f64),
    /// Lettering: the start of its base line, its height, its direction in radians, what it says.
    Text([f64; 2], f64, f64, String),
}

/// Returns in words by how much lines are moved for a kerf; nothing where there is none.
pub(super) fn kerf_words(kerf: f64) -> Option<String> {
    (kerf > 0.0).then(|| {
        let half = without_trailing_zeros(&format!("{:.9}", 0.5 * kerf));
        format!("line moved outward by {half} mm, half the kerf, of openings inward")
    })
}

/// A part to be cut.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// The chain or the patch.
    pub name: String,
    /// The closed outline, counterclockwise, in its smallest box from the origin; with its allowances.
    pub outline: Vec<Segment>,
    /// The outline without allowances, along which it is sewn, welded or glued, where it has some.
    pub seam_line: Option<Vec<Segment>>,
    /// The openings.
    pub openings: Vec<Opening>,
    /// What the file marks on it.
    pub marks: Vec<PartMark>,
    /// The bends that tools make.
    pub bends: Vec<ToolBend>,
    /// The edges without a bend radius.
    pub sharp: Vec<SharpFold>,
    /// The patches that are rolled.
    pub rolled: Vec<Rolled>,
    /// The notches of its seams: lines from the edge that is cut inwards.
    pub notches: Vec<[[f64; 2]; 2]>,
    /// Width and height of the box.
    pub size: [f64; 2],
    /// The width of the cut in millimetres: the outline is moved outward by half of it, the openings inward; the seam line
    /// is not.
    pub kerf: f64,
    /// No point of the outline, without allowances and before it was moved for the kerf, nor of an opening is farther from
    /// that of the exact part.
    pub error: f64,
    /// Whether that is proved; it is measured otherwise.
    pub proved: bool,
    /// What whoever opens the file should know: what it is, of which sheet, and how exact.
    pub notes: Vec<String>,
    /// The motion from the pattern, before its bends were given their lengths, to the part.
    pub placement: Placement,
}

impl Part {
    /// Returns in words by how much its lines are moved for the kerf; nothing where they are not.
    #[must_use]
    pub fn kerf_words(&self) -> Option<String> {
        kerf_words(self.kerf)
    }

    /// Returns the area, without the openings.
    #[must_use]
    pub fn area(&self) -> f64 {
        let open = self.openings.iter().map(|opening| opening.shape.area());
        self.outline.iter().map(Segment::area).sum::<f64>() - open.sum::<f64>()
    }

    /// Returns the length of the cut, around the openings too.
    #[must_use]
    pub fn cut_length(&self) -> f64 {
        let around = self.openings.iter().map(|opening| opening.shape.length());
        self.outline.iter().map(Segment::length).sum::<f64>() + around.sum::<f64>()
    }

    /// Returns how many marks of the part its drawing for a purpose does not have: a cut has none, and no drawing of
    /// one part has letters.
    #[must_use]
    pub fn marks_left_out(&self, purpose: Purpose) -> usize {
        let is_left_out = |mark: &&PartMark| match purpose {
            Purpose::Cut => true,
            Purpose::Bend | Purpose::Sew => matches!(mark, PartMark::Text(..)),
            Purpose::Fold => false,
        };
        self.marks.iter().filter(is_left_out).count()
    }

    /// Returns the drawing of the part: contours alone, for [`Purpose::Bend`] the bend lines too, for [`Purpose::Sew`]
    /// the notches, and for both the marks that are lines and circles.
    ///
    /// # Errors
    /// [`DesignError::Exchange`].
    pub fn drawing(&self, purpose: Purpose) -> Result<Drawing, DesignError> {
        let mut drawing = Drawing::default();
        drawing.set_stroke_width(HAIRLINE)?;
        for note in &self.notes {
            drawing.note(note)?;
        }
        drawing.path(Layer::Outline, &vertices_of(&self.outline), true)?;
        for opening in &self.openings {
            match &opening.shape {
                OpeningShape::Round(centre, radius) => {
                    drawing.circle(Layer::Outline, *centre, *radius)?;
                }
                OpeningShape::Contour(segments) => {
                    drawing.path(Layer::Outline, &vertices_of(segments), true)?;
                }
            }
        }
        if matches!(purpose, Purpose::Bend | Purpose::Sew) {
            for mark in &self.marks {
                match mark {
                    PartMark::Line(points) => drawing.polyline(Layer::Marks, points)?,
                    PartMark::Circle(centre, radius) => {
                        drawing.circle(Layer::Marks, *centre, *radius)?;
                    }
                    // Letters are for paper: programs that cut and bend take none.
                    PartMark::Text(..) => {}
                }
            }
        }
        if purpose == Purpose::Bend {
            for bend in &self.bends {
                let [from, to] = bend.line;
                let line = BendLine {
                    angle: bend.angle,
                    inside_radius: Some(bend.inside_radius),
                };
                drawing.bend_line(from, to, line)?;
            }
            for fold in &self.sharp {
                let [from, to] = fold.line;
                drawing.bend(from, to, fold.angle)?;
            }
        }
        if purpose == Purpose::Sew {
            if let Some(seam_line) = &self.seam_line {
                drawing.path(Layer::Marks, &vertices_of(seam_line), true)?;
            }
            for [from, to] in &self.notches {
                drawing.line(Layer::Marks, *from, *to)?;
            }
        }
        Ok(drawing)
    }
}

/// Returns the parts of these pieces, each in its smallest box.
///
/// # Errors
/// As [`drawing`] and [`blank`].
///
/// ```
/// use torse_designs::unroll::{Demand, parts, unroll};
/// // Two legs of 40 and 25 mm to the corner, on the middle of the sheet, bent over an inside radius of 2 mm.
/// let design = torse_designs::read("angle.toml", r#"
///     [sheet]
///     thickness = 1.5
///     k-factor = 0.42
///     [curves]
///     a = { bezier = [[0, 0, 0], [40, 0, 0]] }
///     b = { bezier = [[0, 60, 0], [40, 60, 0]] }
///     c = { bezier = [[40, 0, 0], [40, 0, 25]] }
///     d = { bezier = [[40, 60, 0], [40, 60, 25]] }
///     [patches]
///     base = { ruled = ["a", "b"] }
///     wall = { ruled = ["c", "d"] }
///     [chains.angle]
///     patches = ["base", "wall"]
///     radius = 2
/// "#)?;
/// let parts = parts(&design, &unroll(&design, &Demand::default())?)?;
/// // 65 - 2 * 2.75 + (2 + 0.42 * 1.5) pi/2
/// assert!((parts[0].size[0] - 63.631194).abs() < 1e-6 && (parts[0].size[1] - 60.0).abs() < 1e-12);
/// assert!((parts[0].bends[0].angle.to_degrees().abs() - 90.0).abs() < 1e-12);
/// # Ok::<(), torse_designs::DesignError>(())
/// ```
pub fn parts(design: &Design, pieces: &[FlatPiece]) -> Result<Vec<Part>, DesignError> {
    parts_with(design, pieces, CutOptions::default())
}

/// Returns the parts of these pieces, cut and laid in this way.
///
/// # Errors
/// As [`parts`], [`DesignError::OutOfRange`] for a kerf that makes no sense, and [`DesignError::Blank`] where an
/// allowance, or a kerf, does not fit.
pub fn parts_with(
    design: &Design,
    pieces: &[FlatPiece],
    making: CutOptions,
) -> Result<Vec<Part>, DesignError> {
    if !(0.0..=MAX_KERF).contains(&making.kerf) {
        return Err(DesignError::OutOfRange {
            name: "kerf",
            value: making.kerf,
            range: "[0, 20]",
        });
    }
    let all = pieces.iter();
    all.map(|piece| part(design, piece, making)).collect()
}

/// What is cut: the outline of a blank with its allowances and half of the kerf, and, of a part with allowances, how
/// wide they are on each segment of the blank.
type CutOutline = (Vec<Segment>, Option<Vec<f64>>);

fn cut_outline(
    design: &Design,
    piece: &FlatPiece,
    blank: &Blank,
    making: CutOptions,
) -> Result<CutOutline, DesignError> {
    let allowances = allowances(design, piece, blank);
    if allowances.is_none() && making.kerf == 0.0 {
        return Ok((blank.outline.clone(), None));
    }
    let half = 0.5 * making.kerf;
    let distances: Vec<f64> = match &allowances {
        Some(all) => all.iter().map(|by| by + half).collect(),
        None => vec![half; blank.outline.len()],
    };
    let moved = moved_outwards(&blank.outline, &distances);
    let what = match &allowances {
        Some(_) => "allowance",
        None => "kerf",
    };
    let moved = moved.map_err(|reason| DesignError::Blank {
        piece: piece.piece.name.clone(),
        reason: format!("its {what} does not fit: {reason}"),
    })?;
    Ok((moved, allowances))
}

/// Returns the notch of a seam: where there is an allowance, from the edge that is cut inwards, and no farther than the
/// seam line.
fn into_allowance(
    [from, to]: [[f64; 2]; 2],
    outline: &[Segment],
    allowances: &[f64],
) -> [[f64; 2]; 2] {
    let near = outline
        .iter()
        .zip(allowances)
        .min_by(|(a, _), (b, _)| a.distance(from).total_cmp(&b.distance(from)));
    let by = near.map_or(0.0, |(_, by)| *by);
    if by == 0.0 {
        return [from, to];
    }
    let length = libm::hypot(to[0] - from[0], to[1] - from[1]);
    let outwards = |by: f64| [0, 1].map(|i| from[i] - by / length * (to[i] - from[i]));
    [outwards(by), outwards((by - length).max(0.0))]
}

fn part(design: &Design, piece: &FlatPiece, making: CutOptions) -> Result<Part, DesignError> {
    // Marks that leave the sheet or overlap are refused as in every drawing.
    drawing(design, std::slice::from_ref(piece))?;
    let blank = blank(design, piece)?;
    if is_closed_ring(design, piece, &blank) {
        return Err(DesignError::Blank {
            piece: piece.piece.name.clone(),
            reason: "its first ruling and its last lie on one another in the plane: it is a closed flat ring, and its outline \
                     would be cut through there; make it of two parts, each half of the way around"
                .to_owned(),
        });
    }
    let size = blank.outline.iter().map(Segment::length).sum::<f64>();
    // What the tolerance leaves, where the pattern is better than that; rounding in any case.
    let room = (0.5 * (design.tolerances.outline - blank.error)).max(ROUNDING * size);
    let (cut, allowances) = cut_outline(design, piece, &blank, making)?;
    let (outline, mut off) = simplified(&cut, room);
    let seam_line = allowances.is_some().then(|| {
        let (seam_line, more) = simplified(&blank.outline, room);
        off = off.max(more);
        seam_line
    });
    let placement = match making.grain {
        None => to_smallest_box(&outline),
        Some(grain) => turned_to(&outline, direction(piece, &blank, grain)),
    };
    let openings = openings_on_blank(design, piece, &blank, 0.5 * making.kerf)?;
    let marks = part_marks(design, piece, &blank, &placement)?;
    let notches = notches(design, piece, &blank)?.into_iter();
    let notches = notches.map(|notch| match &allowances {
        Some(allowances) => into_allowance(notch, &blank.outline, allowances),
        None => notch,
    });
    let point = |at: [f64; 2]| placement.point(at).map(on_grid);
    let place = |ends: [[f64; 2]; 2]| ends.map(point);
    let [low, high] = bounds(&outline, &placement);
    let moved = outline.iter().map(moved_on_grid).fold(0.0_f64, f64::max);
    let open = openings
        .iter()
        .fold(0.0_f64, |m, opening| m.max(opening.error));
    let error = (blank.error + off).max(open) + moved;
    let proved = piece.flat.evidence() == PatternEvidence::Proved
        && openings.iter().all(|opening| opening.proved);
    let mut notes = vec![format!("{}: {}", design.name, design.title)];
    if let Some(metal) = design.metal {
        notes.push(format!("a sheet {} mm thick", metal.sheet.thickness()));
    }
    notes.push(format!(
        "part {}, outline{} within {} mm of the exact part{}",
        piece.piece.name,
        match (allowances.is_some(), making.kerf > 0.0) {
            (true, false) => " without its allowances",
            (false, true) => " before it was moved for the kerf",
            (true, true) => " without its allowances and before it was moved for the kerf",
            (false, false) => "",
        },
        at_most(error),
        if proved { "" } else { ", measured, not proved" }
    ));
    notes.extend(kerf_words(making.kerf));
    if piece.flat.is_strained() {
        notes.push(format!(
            "not developable: lines are strained by up to {} of their length",
            at_most(piece.flat.strain())
        ));
    }
    let placed = |contour: &[Segment]| -> Vec<Segment> {
        let moved = contour.iter().map(|segment| placement.segment(segment));
        moved
            .map(|placed| Segment {
                from: placed.from.map(on_grid),
                to: placed.to.map(on_grid),
                ..placed
            })
            .collect()
    };
    Ok(Part {
        name: piece.piece.name.clone(),
        outline: placed(&outline),
        seam_line: seam_line.map(|seam_line| placed(&seam_line)),
        openings: openings
            .into_iter()
            .map(|opening| Opening {
                finished: opening.finished.map(|hole| hole.placed(&placement)),
                shape: match &opening.shape {
                    OpeningShape::Round(centre, radius) => {
                        OpeningShape::Round(point(*centre), *radius)
                    }
                    OpeningShape::Contour(segments) => OpeningShape::Contour(placed(segments)),
                },
                ..opening
            })
            .collect(),
        marks,
        bends: blank
            .bends
            .into_iter()
            .map(|bend| ToolBend {
                line: place(bend.line),
                ..bend
            })
            .collect(),
        sharp: blank
            .sharp
            .into_iter()
            .map(|fold| SharpFold {
                line: place(fold.line),
                ..fold
            })
            .collect(),
        rolled: blank.rolled,
        notches: notches.map(place).collect(),
        size: [high[0] - low[0], high[1] - low[1]].map(on_grid),
        kerf: making.kerf,
        error,
        proved,
        notes,
        placement,
    })
}

/// Returns whether the pattern comes back to where it began, so that its outline has a slit along the first ruling.
fn is_closed_ring(design: &Design, piece: &FlatPiece, blank: &Blank) -> bool {
    let flat = &piece.flat;
    let last = flat.pieces().saturating_sub(1);
    let ruling = |place: usize, end: usize| {
        let ruling = flat.end_rulings(place)?[end];
        let ends = ruling.map(|point| blank.place(place, point, 0.0));
        Some([ends[0]?, ends[1]?])
    };
    let (Some(first), Some(end)) = (ruling(0, 0), ruling(last, 1)) else {
        return false;
    };
    let apart = |[x, y]: [f64; 2], [z, w]: [f64; 2]| libm::hypot(z - x, w - y);
    let within = design.tolerances.outline;
    apart(first[0], first[1]) > within && (0..2).all(|i| apart(first[i], end[i]) <= within)
}

/// Returns the direction of the first axis of a drawing on the blank, in radians, for this grain.
fn direction(piece: &FlatPiece, blank: &Blank, grain: Grain) -> f64 {
    let flat = &piece.flat;
    let last = flat.pieces().saturating_sub(1);
    let middle = |place: usize, end: usize| {
        let ruling = flat.end_rulings(place).unwrap_or_default()[end];
        let [p, q] = ruling.map(|p| blank.place(place, p, 0.0).unwrap_or(p));
        [0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])]
    };
    let (from, to) = (middle(0, 0), middle(last, 1));
    let along = libm::atan2(to[1] - from[1], to[0] - from[0]);
    match grain {
        Grain::Along => along,
        Grain::Across => along - 0.5 * PI,
    }
}

/// Returns how far the points of a segment move at most whose ends are moved to the grid: its ends by half a diagonal
/// of a cell, and a point at `w` between them, the start being 0 and the end 1 of the complex plane, by `|1 - w| + |w|`
/// times as much: by at most two diameters for each chord.
fn moved_on_grid(segment: &Segment) -> f64 {
    let bulge = segment.bulge.abs();
    let factor = if bulge <= 1.0 {
        SQRT_2
    } else {
        (1.0 + bulge * bulge) / bulge
    };
    FRAC_1_SQRT_2 / STEPS * factor
}

/// Returns the nearest point of the grid of [`STEPS`].
fn on_grid(length: f64) -> f64 {
    // Divided: the nearest double to the decimal, whose shortest form is short.
    (length * STEPS).round() / STEPS
}

/// Returns the marks of a piece, where they lie on the part.
fn part_marks(
    design: &Design,
    FlatPiece { piece, flat }: &FlatPiece,
    blank: &Blank,
    placement: &Placement,
) -> Result<Vec<PartMark>, DesignError> {
    let turn = {
        let [from, to] = [[0.0, 0.0], [1.0, 0.0]].map(|p| placement.point(p));
        libm::atan2(to[1] - from[1], to[0] - from[0])
    };
    let mut found = Vec::new();
    let patches = piece.patches.iter();
    for patch in patches.filter_map(|index| design.patches.get(*index)) {
        let Some(place) = position(flat, patch) else {
            continue;
        };
        let on_part = |point: [f64; 2], room: f64| {
            let on_blank = blank.place(place, point, room);
            let on_blank = on_blank.ok_or_else(|| DesignError::Mark {
                patch: patch.name.clone(),
                reason: "a mark lies where a bend takes up the sheet".to_owned(),
            });
            Ok::<_, DesignError>(on_grid_point(placement.point(on_blank?)))
        };
        for mark in flat_marks(design, patch, flat)? {
            found.push(match mark {
                FlatMark::Hole(..) | FlatMark::Opening => continue,
                FlatMark::Line(points) => {
                    let points = points.into_iter().map(|point| on_part(point, 0.0));
                    PartMark::Line(points.collect::<Result<_, _>>()?)
                }
                FlatMark::Circle(centre, radius) => {
                    PartMark::Circle(on_part(centre, radius)?, radius)
                }
                FlatMark::Text(line, content) => PartMark::Text(
                    on_part(line.at, 0.0)?,
                    line.height,
                    line.angle + turn,
                    content,
                ),
            });
        }
    }
    Ok(found)
}

fn on_grid_point(point: [f64; 2]) -> [f64; 2] {
    point.map(on_grid)
}

/// Lengths that differ by less, as a share, are equal.
const SAME_LENGTH: f64 = 1e-9;

/// Returns the openings of a piece on its blank, smaller by half of the kerf.
fn openings_on_blank(
    design: &Design,
    piece: &FlatPiece,
    blank: &Blank,
    half_kerf: f64,
) -> Result<Vec<Opening>, DesignError> {
    let refused = |reason: String| DesignError::Blank {
        piece: piece.piece.name.clone(),
        reason,
    };
    let mut found = Vec::new();
    for opening in openings(design, &piece.piece, &piece.flat)? {
        let shape = on_blank(piece, blank, &opening);
        let shape = shape.ok_or_else(|| refused(format!("{} lies in a bend", opening.name)))?;
        let finished = (half_kerf > 0.0).then(|| shape.clone());
        let shape = match shape {
            OpeningShape::Round(_, radius) if radius <= half_kerf => {
                let reason = format!("an opening of radius {radius} mm is narrower than the kerf");
                return Err(refused(reason));
            }
            OpeningShape::Round(centre, radius) => OpeningShape::Round(centre, radius - half_kerf),
            OpeningShape::Contour(segments) if half_kerf > 0.0 => {
                // Clockwise the opening is on the right.
                let turned: Vec<Segment> = segments.iter().rev().map(Segment::reversed).collect();
                let distances = vec![half_kerf; turned.len()];
                let moved = moved_outwards(&turned, &distances);
                let moved = moved.map_err(|reason| {
                    refused(format!("the kerf does not fit {}: {reason}", opening.name))
                })?;
                OpeningShape::Contour(moved.iter().rev().map(Segment::reversed).collect())
            }
            contour @ OpeningShape::Contour(_) => contour,
        };
        found.push(Opening {
            shape,
            finished,
            ..opening
        });
    }
    Ok(found)
}

/// Returns an opening on the blank; `None` where a bend takes a part of it.
fn on_blank(piece: &FlatPiece, blank: &Blank, opening: &Opening) -> Option<OpeningShape> {
    match &opening.shape {
        OpeningShape::Round(centre, radius) => {
            let centre = blank.place(opening.patch, *centre, *radius)?;
            Some(OpeningShape::Round(centre, *radius))
        }
        OpeningShape::Contour(segments) if blank.bends.is_empty() => {
            Some(OpeningShape::Contour(segments.clone()))
        }
        OpeningShape::Contour(segments) => {
            let place = |point: [f64; 2], room: f64| {
                let at = piece.flat.locate(point)?;
                blank.place(at.piece, point, room)
            };
            let moved = segments.iter().map(|segment| {
                let room = segment.sagitta();
                let moved = Segment {
                    from: place(segment.from, room)?,
                    to: place(segment.to, room)?,
                    bulge: segment.bulge,
                };
                let length = segment.chord_length();
                let same = (moved.chord_length() - length).abs() <= SAME_LENGTH * (1.0 + length);
                same.then_some(moved)
            });
            moved.collect::<Option<_>>().map(OpeningShape::Contour)
        }
    }
}
