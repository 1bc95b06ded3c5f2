//! The drawing of the pieces: patterns, marks, lettering, notes.

use super::lettering::{self, Drawn, Line};
use super::{FlatPiece, position};
use crate::design::{Design, Mark, Patch};
use crate::error::DesignError;
use torse_exchange::{Drawing, Layer, Text};
use torse_geometry::pattern::{FlatPattern, PatternError, Place};

/// The height of the letters of a name, as a share of the size of its piece.
const LETTERS: f64 = 0.025;
/// How far from the sheet the edge of regression is still shown, as a share of its size.
const REACH: f64 = 0.25;

/// Draws the pieces: what is cut, bent and marked, each with its name, and notes of how exact it is.
///
/// # Errors
/// [`DesignError::Mark`] for a hole or a circle that leaves the sheet, [`DesignError::Exchange`].
pub fn drawing(design: &Design, pieces: &[FlatPiece]) -> Result<Drawing, DesignError> {
    let mut drawing = Drawing::default();
    drawing.note(&format!("{}: {}", design.name, design.title))?;
    if let Some(metal) = design.metal {
        drawing.note(&format!(
            "middle surface of a sheet {} mm thick, K-factor {}",
            metal.sheet.thickness(),
            metal.sheet.k_factor()
        ))?;
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
        name(&mut drawing, before, &piece.name, flat, size)?;
    }
    Ok(drawing)
}

/// The name of a piece, clear of the rulings and of the paths and texts since these; a strained pattern says so beside it.
fn name(
    drawing: &mut Drawing,
    (paths, texts): (usize, usize),
    name: &str,
    flat: &FlatPattern,
    size: f64,
) -> Result<(), DesignError> {
    let content = if flat.is_strained() {
        format!("{name} (strained up to {:.1e})", flat.strain())
    } else {
        name.to_owned()
    };
    let marks = drawing.paths().iter().skip(paths);
    let texts = drawing.texts().iter().skip(texts);
    let drawn: Vec<Drawn> = marks
        .map(|path| path.polygon(0.02))
        .chain(texts.map(|text| {
            let (at, height, angle) = (text.at, text.height, text.angle);
            lettering::frame(&Line { at, height, angle }, text.content.chars().count())
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

fn marks(
    drawing: &mut Drawing,
    design: &Design,
    patch: &Patch,
    flat: &FlatPattern,
) -> Result<(), DesignError> {
    if patch.marks.is_empty() {
        return Ok(());
    }
    let failed = |reason: String| DesignError::Mark {
        patch: patch.name.clone(),
        reason,
    };
    let unrolled = |source: PatternError| failed(source.to_string());
    let piece = position(flat, patch).ok_or_else(|| failed("it has no pattern".to_owned()))?;
    let flatten = |[x, v]: [f64; 2]| {
        let point = flat.flatten(Place { piece, x, v });
        point.ok_or_else(|| failed(format!("[{x}, {v}] is outside the patch")))
    };
    // Beyond an edge of the sheet, which may be the edge of regression, there is no surface to carry a circle back to.
    let centre = |what: &str, place: [f64; 2], radius: f64| {
        let centre = flatten(place)?;
        let room = flat.outline().distance(centre);
        if room > radius {
            return Ok(centre);
        }
        let [u, v] = place;
        Err(failed(format!(
            "the {what} of radius {radius} mm at [{u}, {v}] leaves the sheet, which ends {room:.4} mm from there"
        )))
    };
    for mark in &patch.marks {
        match mark {
            Mark::Line(places) => {
                let mut points: Vec<[f64; 2]> = Vec::new();
                for pair in places.windows(2) {
                    let [a, b] = [pair[0], pair[1]];
                    let line = |t: f64| [0, 1].map(|i| a[i] + t * (b[i] - a[i]));
                    let part = flat.carry(piece, line, design.tolerances.outline);
                    let part = part.map_err(unrolled)?;
                    points.extend(part.iter().skip(usize::from(!points.is_empty())));
                }
                drawing.polyline(Layer::Marks, &points)?;
            }
            Mark::Hole(place, radius) => {
                drawing.circle(Layer::Outline, centre("hole", *place, *radius)?, *radius)?;
            }
            Mark::Circle(place, radius) => {
                drawing.circle(Layer::Marks, centre("circle", *place, *radius)?, *radius)?;
            }
            Mark::Text(place, content, height, angle) => {
                let (from, to) = (flatten([place[0], 0.0])?, flatten([place[0], 1.0])?);
                drawing.text(Text {
                    layer: Layer::Marks,
                    at: flatten(*place)?,
                    height: *height,
                    angle: libm::atan2(to[1] - from[1], to[0] - from[0]) + angle,
                    content: content.clone(),
                })?;
            }
        }
    }
    Ok(())
}
