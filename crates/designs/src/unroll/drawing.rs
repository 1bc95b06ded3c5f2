//! The drawing of the pieces: patterns, marks, lettering, notes.

use super::FlatPiece;
use super::contour::vertices_of;
use super::lettering::{self, Drawn, LetteringPlace};
use super::marks::{FlatMark, flat_marks};
use crate::design::{Design, Patch};
use crate::error::DesignError;
use crate::numbers::at_most;
use crate::openings::{OpeningShape, openings};
use torse_exchange::{Drawing, Layer, Text};
use torse_geometry::pattern::FlatPattern;

/// The height of the letters of a name, as a share of the size of its piece.
const LETTERS: f64 = 0.025;
/// How far from the sheet the edge of regression is still shown, as a share of its size.
const REACH: f64 = 0.25;

/// Returns the note that a pattern is not the blank, for a design with bends over tools; `None` if there are none, so
/// that each pattern is its blank.
#[must_use]
pub fn development_note(design: &Design) -> Option<String> {
    design.has_tool_bends().then(|| {
        let surface = design.bending.surface.name();
        format!(
            "development of the designed {surface} surface; not the blank: bends have no allowance, see `unroll`"
        )
    })
}

/// Draws the pieces: what is cut, bent and marked, each with its name, and notes of how exact it is.
///
/// # Errors
/// [`DesignError::Mark`] for an opening, a circle or lettering that leaves the sheet and for openings that overlap,
/// [`DesignError::Exchange`].
pub fn drawing(design: &Design, pieces: &[FlatPiece]) -> Result<Drawing, DesignError> {
    let mut drawing = Drawing::default();
    drawing.note(&format!("{}: {}", design.name, design.title))?;
    if let Some(metal) = design.metal {
        drawing.note(&format!("a sheet {} mm thick", metal.sheet.thickness()))?;
    }
    if let Some(note) = development_note(design) {
        drawing.note(&note)?;
    }
    for FlatPiece { piece, flat } in pieces {
        let [low, high] = flat.outline().bounds();
        let size = (high[0] - low[0]).max(high[1] - low[1]);
        drawing.note(&format!("piece {}", piece.name))?;
        drawing.add_pattern(flat, REACH * size)?;
        let before = (drawing.paths().len(), drawing.texts().len());
        for index in &piece.patches {
            if let Some(patch) = design.patches.get(*index) {
                marks(&mut drawing, design, patch, flat)?;
            }
        }
        for opening in openings(design, piece, flat)? {
            if let OpeningShape::Contour(segments) = &opening.shape {
                drawing.path(Layer::Outline, &vertices_of(segments), true)?;
            }
        }
        name(&mut drawing, before, &piece.name, flat, size)?;
    }
    Ok(drawing)
}

/// Returns the name of a piece, clear of the rulings and of the paths and texts since these; a strained pattern says so
/// beside it.
fn name(
    drawing: &mut Drawing,
    (paths, texts): (usize, usize),
    name: &str,
    flat: &FlatPattern,
    size: f64,
) -> Result<(), DesignError> {
    let content = if flat.is_strained() {
        format!("{name} (strained up to {})", at_most(flat.strain()))
    } else {
        name.to_owned()
    };
    let marks = drawing.paths().iter().skip(paths);
    let texts = drawing.texts().iter().skip(texts);
    let drawn: Vec<Drawn> = marks
        .map(|path| path.polygon(0.02))
        .chain(texts.map(|text| {
            let (at, height, angle) = (text.at, text.height, text.angle);
            lettering::frame(
                &LetteringPlace { at, height, angle },
                text.content.chars().count(),
            )
        }))
        .collect();
    let rulings: Vec<_> = flat.rulings().iter().map(|ruling| ruling.ends).collect();
    let letters = content.chars().count();
    let wished = LETTERS * size;
    if let Some(line) = lettering::place(&rulings, letters, wished, &drawn) {
        drawing.text(Text {
            layer: Layer::Marks,
            at: line.at,
            height: line.height,
            angle: line.angle,
            content,
        })?;
    }
    Ok(())
}

/// Draws the marks of a patch, but for the openings that are not round.
fn marks(
    drawing: &mut Drawing,
    design: &Design,
    patch: &Patch,
    flat: &FlatPattern,
) -> Result<(), DesignError> {
    for mark in flat_marks(design, patch, flat)? {
        match mark {
            FlatMark::Line(points) => drawing.polyline(Layer::Marks, &points)?,
            FlatMark::Hole(at, radius) => drawing.circle(Layer::Outline, at, radius)?,
            FlatMark::Circle(at, radius) => drawing.circle(Layer::Marks, at, radius)?,
            FlatMark::Text(line, content) => drawing.text(Text {
                layer: Layer::Marks,
                at: line.at,
                height: line.height,
                angle: line.angle,
                content,
            })?,
            FlatMark::Opening => {}
        }
    }
    Ok(())
}
