//! The drawing of the pieces: patterns, marks, lettering, notes.

use super::lettering::{self, Drawn, Line};
use super::{FlatPiece, position};
use crate::design::{Design, Mark, Patch};
use crate::error::DesignError;
use crate::polygon::is_within;
use torse_exchange::{Drawing, Layer, Text};
use torse_geometry::pattern::{FlatPattern, PatternError, PatternPlace};

/// The height of the letters of a name, as a share of the size of its piece.
const LETTERS: f64 = 0.025;
/// How far from the sheet the edge of regression is still shown, as a share of its size.
const REACH: f64 = 0.25;

/// What whoever takes the pattern of a design that tools bend should know: it is not what is cut. `None` where no bend has
/// an allowance, so that patterns are blanks.
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
/// [`DesignError::Mark`] for a hole, a circle or lettering that leaves the sheet and for holes that overlap,
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
        let mut holes = Vec::new();
        for index in &piece.patches {
            if let Some(patch) = design.patches.get(*index) {
                marks(&mut drawing, design, patch, flat, &mut holes)?;
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
    holes: &mut Vec<([f64; 2], f64)>,
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
        let point = flat.flatten(PatternPlace { piece, x, v });
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
                let at = centre("hole", *place, *radius)?;
                let apart = |(other, own): &([f64; 2], f64)| {
                    libm::hypot(other[0] - at[0], other[1] - at[1]) - own - radius
                };
                let nearest = holes.iter().map(apart).fold(f64::INFINITY, f64::min);
                if nearest <= 0.0 {
                    let [u, v] = place;
                    return Err(failed(format!(
                        "the hole of radius {radius} mm at [{u}, {v}] overlaps another by {:.4} mm",
                        -nearest
                    )));
                }
                holes.push((at, *radius));
                drawing.circle(Layer::Outline, at, *radius)?;
            }
            Mark::Circle(place, radius) => {
                drawing.circle(Layer::Marks, centre("circle", *place, *radius)?, *radius)?;
            }
            Mark::Text(place, content, height, angle) => {
                let (from, to) = (flatten([place[0], 0.0])?, flatten([place[0], 1.0])?);
                let line = Line {
                    at: flatten(*place)?,
                    height: *height,
                    angle: libm::atan2(to[1] - from[1], to[0] - from[0]) + angle,
                };
                let frame = lettering::frame(&line, content.chars().count());
                let beside = beside(flat, &frame);
                if beside > design.tolerances.outline {
                    let [u, v] = place;
                    return Err(failed(format!(
                        "the text {content:?} at [{u}, {v}] leaves the sheet by {beside:.4} mm"
                    )));
                }
                drawing.text(Text {
                    layer: Layer::Marks,
                    at: line.at,
                    height: line.height,
                    angle: line.angle,
                    content: content.clone(),
                })?;
            }
        }
    }
    Ok(())
}

/// Points on each side of a frame, and of each segment of an outline, that are looked at.
const FRAME_POINTS: u32 = 16;

/// How far a closed frame reaches beyond the outline of a pattern, as its points show.
fn beside(flat: &FlatPattern, frame: &[[f64; 2]]) -> f64 {
    let share = |k: u32| f64::from(k) / f64::from(FRAME_POINTS);
    let outline: Vec<[f64; 2]> = flat
        .outline()
        .segments()
        .iter()
        .flat_map(|segment| (0..FRAME_POINTS).map(|k| segment.point(share(k))))
        .collect();
    let sides = frame.windows(2).flat_map(|side| {
        let (a, b) = (side[0], side[1]);
        (0..FRAME_POINTS).map(move |k| [0, 1].map(|i| a[i] + share(k) * (b[i] - a[i])))
    });
    sides
        .filter(|point| !is_within(&outline, *point))
        .map(|point| flat.outline().distance(point))
        .fold(0.0, f64::max)
}
