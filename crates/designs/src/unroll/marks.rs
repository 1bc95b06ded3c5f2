//! Where the marks of a patch lie on its pattern.

use super::lettering::{self, LetteringPlace};
use crate::design::{Design, Mark, Patch};
use crate::error::DesignError;
use crate::polygon::is_within;
use crate::position::position;
use torse_geometry::pattern::{FlatPattern, PatternError, PatternPlace};

/// A mark on the pattern.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum FlatMark {
    /// A line, drawn and not cut.
    Line(Vec<[f64; 2]>),
    /// A hole: its centre and radius.
    Hole([f64; 2], f64),
    /// A circle, drawn and not cut: its centre and radius.
    Circle([f64; 2], f64),
    /// Lettering.
    Text(LetteringPlace, String),
    /// An opening of any shape, which is cut with the round ones.
    Opening,
}

/// Lays the marks of a patch on its pattern, in the order of the file.
///
/// # Errors
/// [`DesignError::Mark`] for a hole, a circle or lettering that leaves the sheet.
pub(super) fn flat_marks(
    design: &Design,
    patch: &Patch,
    flat: &FlatPattern,
) -> Result<Vec<FlatMark>, DesignError> {
    if patch.marks.is_empty() {
        return Ok(vec![]);
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
    let mut found = Vec::with_capacity(patch.marks.len());
    for mark in &patch.marks {
        found.push(match mark {
            Mark::Line(places) => {
                let mut points: Vec<[f64; 2]> = Vec::new();
                for pair in places.windows(2) {
                    let [a, b] = [pair[0], pair[1]];
                    let line = |t: f64| [0, 1].map(|i| a[i] + t * (b[i] - a[i]));
                    let part = flat.carry(piece, line, design.tolerances.outline);
                    let part = part.map_err(unrolled)?;
                    points.extend(part.iter().skip(usize::from(!points.is_empty())));
                }
                FlatMark::Line(points)
            }
            Mark::Opening(_) => FlatMark::Opening,
            Mark::Hole(place, radius) => FlatMark::Hole(centre("hole", *place, *radius)?, *radius),
            Mark::Circle(place, radius) => {
                FlatMark::Circle(centre("circle", *place, *radius)?, *radius)
            }
            Mark::Text(place, content, height, angle) => {
                let (from, to) = (flatten([place[0], 0.0])?, flatten([place[0], 1.0])?);
                let line = LetteringPlace {
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
                FlatMark::Text(line, content.clone())
            }
        });
    }
    Ok(found)
}

/// Points on each side of a frame, and of each segment of an outline, that are looked at.
const FRAME_POINTS: u32 = 16;

/// Returns how far a closed frame reaches beyond the outline of a pattern, as its points show.
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
