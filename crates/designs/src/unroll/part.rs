//! Parts: what is cut of each piece, and the files of a purpose.

use super::blank::{Rolled, SharpFold, ToolBend, blank};
use super::contour::{bounds, simplified, to_smallest_box};
use super::notches::notches;
use super::{FlatPiece, drawing, position};
use crate::design::{Design, Mark};
use crate::error::DesignError;
use crate::inspect::at_most;
use std::f64::consts::{FRAC_1_SQRT_2, PI, SQRT_2};
use torse_exchange::{BendLine, Drawing, Layer, Vertex};
use torse_geometry::pattern::{PatternPlace, Placement, Segment};

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

/// The strokes of a cut in drawings for the eye's programs, in millimetres: bureaus take at most this for a cut.
const HAIRLINE: f64 = 0.01;
/// Coordinates of parts are whole multiples of a millimetre over this: files have no digits that mean nothing.
const STEPS: f64 = 1e9;
/// What counts as nothing beside the size of a part when vertices are left out.
const ROUNDING: f64 = 1e-12;

/// A part to be cut.
#[derive(Debug, Clone, PartialEq)]
pub struct Part {
    /// The chain or the patch.
    pub name: String,
    /// The closed outline, counterclockwise, in its smallest box from the origin.
    pub outline: Vec<Segment>,
    /// The round openings: centre and radius.
    pub openings: Vec<([f64; 2], f64)>,
    /// The bends that tools make.
    pub bends: Vec<ToolBend>,
    /// The edges without a bend radius.
    pub sharp: Vec<SharpFold>,
    /// The patches that are rolled.
    pub rolled: Vec<Rolled>,
    /// The notches of its seams: lines from the edge inwards.
    pub notches: Vec<[[f64; 2]; 2]>,
    /// Width and height of the box.
    pub size: [f64; 2],
    /// No point of the outline is farther from that of the exact part.
    pub error: f64,
    /// What whoever opens the file should know: what it is, of which sheet, and how exact.
    pub notes: Vec<String>,
    /// The motion from the pattern, before its bends were given their lengths, to the part.
    pub placement: Placement,
}

impl Part {
    /// The area, without the openings.
    #[must_use]
    pub fn area(&self) -> f64 {
        let open = self.openings.iter().map(|(_, radius)| PI * radius * radius);
        self.outline.iter().map(Segment::area).sum::<f64>() - open.sum::<f64>()
    }

    /// The length of the cut, around the openings too.
    #[must_use]
    pub fn cut_length(&self) -> f64 {
        let around = self.openings.iter().map(|(_, radius)| 2.0 * PI * radius);
        self.outline.iter().map(Segment::length).sum::<f64>() + around.sum::<f64>()
    }

    /// The drawing of the part: contours alone, and for [`Purpose::Bend`] the bend lines.
    ///
    /// # Errors
    /// [`DesignError::Exchange`].
    pub fn drawing(&self, purpose: Purpose) -> Result<Drawing, DesignError> {
        let mut drawing = Drawing::default();
        drawing.set_stroke_width(HAIRLINE)?;
        for note in &self.notes {
            drawing.note(note)?;
        }
        let vertices: Vec<Vertex> = self
            .outline
            .iter()
            .map(|segment| Vertex {
                point: segment.from,
                bulge: segment.bulge,
            })
            .collect();
        drawing.path(Layer::Outline, &vertices, true)?;
        for (centre, radius) in &self.openings {
            drawing.circle(Layer::Outline, *centre, *radius)?;
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
            for [from, to] in &self.notches {
                drawing.line(Layer::Marks, *from, *to)?;
            }
        }
        Ok(drawing)
    }
}

/// The parts of these pieces, each in its smallest box.
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
    pieces.iter().map(|piece| part(design, piece)).collect()
}

fn part(design: &Design, piece: &FlatPiece) -> Result<Part, DesignError> {
    // Marks that leave the sheet or overlap are refused as in every drawing.
    drawing(design, std::slice::from_ref(piece))?;
    let blank = blank(design, piece)?;
    let size = blank.outline.iter().map(Segment::length).sum::<f64>();
    // What the tolerance leaves, where the pattern is better than that; rounding in any case.
    let room = (0.5 * (design.tolerances.outline - blank.error)).max(ROUNDING * size);
    let (outline, off) = simplified(&blank.outline, room);
    let placement = to_smallest_box(&outline);
    let openings = openings(design, piece, |patch, centre, radius| {
        blank.place(patch, centre, radius)
    })?;
    let notches = notches(design, piece, &blank)?;
    let point = |at: [f64; 2]| placement.point(at).map(on_grid);
    let place = |ends: [[f64; 2]; 2]| ends.map(point);
    let [low, high] = bounds(&outline, &placement);
    let moved = outline.iter().map(moved_on_grid).fold(0.0_f64, f64::max);
    let error = blank.error + off + moved;
    let mut notes = vec![format!("{}: {}", design.name, design.title)];
    if let Some(metal) = design.metal {
        notes.push(format!("a sheet {} mm thick", metal.sheet.thickness()));
    }
    notes.push(format!(
        "part {}, outline within {} mm of the exact part",
        piece.piece.name,
        at_most(error)
    ));
    if piece.flat.is_strained() {
        notes.push(format!(
            "not developable: lines are strained by up to {} of their length",
            at_most(piece.flat.strain())
        ));
    }
    Ok(Part {
        name: piece.piece.name.clone(),
        outline: outline
            .iter()
            .map(|segment| {
                let placed = placement.segment(segment);
                Segment {
                    from: placed.from.map(on_grid),
                    to: placed.to.map(on_grid),
                    ..placed
                }
            })
            .collect(),
        openings: openings
            .into_iter()
            .map(|(centre, radius)| (point(centre), radius))
            .collect(),
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
        notches: notches.into_iter().map(place).collect(),
        size: [high[0] - low[0], high[1] - low[1]].map(on_grid),
        error,
        notes,
        placement,
    })
}

/// How far the points of a segment move at most whose ends are moved to the grid: its ends by half a diagonal of a cell,
/// and a point at `w` between them, the start being 0 and the end 1 of the complex plane, by `|1 - w| + |w|` times as
/// much: by at most two diameters for each chord.
fn moved_on_grid(segment: &Segment) -> f64 {
    let bulge = segment.bulge.abs();
    let factor = if bulge <= 1.0 {
        SQRT_2
    } else {
        (1.0 + bulge * bulge) / bulge
    };
    FRAC_1_SQRT_2 / STEPS * factor
}

/// The nearest point of the grid of [`STEPS`].
fn on_grid(length: f64) -> f64 {
    // Divided: the nearest double to the decimal, whose shortest form is short.
    (length * STEPS).round() / STEPS
}

/// The openings of a piece, on its blank.
fn openings(
    design: &Design,
    FlatPiece { piece, flat }: &FlatPiece,
    place: impl Fn(usize, [f64; 2], f64) -> Option<[f64; 2]>,
) -> Result<Vec<([f64; 2], f64)>, DesignError> {
    let mut found = Vec::new();
    let patches = piece.patches.iter();
    for patch in patches.filter_map(|index| design.patches.get(*index)) {
        for mark in &patch.marks {
            let Mark::Hole([x, v], radius) = mark else {
                continue;
            };
            let on_pattern = position(flat, patch).and_then(|piece| {
                let at = PatternPlace {
                    piece,
                    x: *x,
                    v: *v,
                };
                Some((piece, flat.flatten(at)?))
            });
            let centre = on_pattern.and_then(|(piece, at)| place(piece, at, *radius));
            let Some(centre) = centre else {
                return Err(DesignError::Mark {
                    patch: patch.name.clone(),
                    reason: format!("the hole of radius {radius} mm at [{x}, {v}] lies in a bend"),
                });
            };
            found.push((centre, *radius));
        }
    }
    Ok(found)
}
