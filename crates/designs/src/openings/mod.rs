//! Openings of patterns: round holes, and closed curves of any shape, as lines and arcs.
//!
//! A curve is first a polygon on the pattern whose distance from the exact curve is bounded: by the second derivative on the
//! sheet, and, where the curve is the solution of equations, by an interval test (`torse_geometry::prelude::SheetTracer`).
//! The polygon then becomes lines and arcs, whose distance from it is added.

mod limits;
mod shape;
mod traced;

pub use shape::{Opening, OpeningShape};

use crate::design::{Design, DesignPiece, Mark, MarkedOpening, NamedCurve, Patch};
use crate::error::DesignError;
use crate::fit::fitted;
use crate::plane_contour::{PlaneFrame, on_pattern};
use crate::position::position;
use crate::simple_contour::{goes_around_once, self_contact};

use torse_geometry::pattern::{FlatPattern, PatternEvidence, PatternPlace, Segment};
use traced::{FinePolygon, polygons};

/// The part of the tolerance of an outline that lines and arcs may take.
const FITTED: f64 = 0.25;

/// Returns the openings of a piece on its pattern, in the order of the file.
///
/// # Errors
/// [`DesignError::Mark`] for an opening that leaves the sheet, crosses itself, meets another, or is not found: each with
/// its place.
///
/// ```
/// use torse_designs::openings::openings;
/// use torse_designs::unroll::{Demand, unroll};
/// // A slot along the rulings of a quarter of a pipe.
/// let design = torse_designs::read("pipe.toml", r#"
///     [curves]
///     rim = { arc = { centre = [0, 0, 0], from = [50, 0, 0], to = [0, 50, 0] } }
///     slot = { polyline = [[-10, -2, 0], [10, -2, 0], [10, 2, 0], [-10, 2, 0], [-10, -2, 0]] }
///     [patches.pipe]
///     cylinder = "rim"
///     direction = [0, 0, 90]
///     marks = [{ opening = "slot", at = [0.5, 0.5] }]
/// "#)?;
/// let pieces = unroll(&design, &Demand::default())?;
/// let found = openings(&design, &pieces[0].piece, &pieces[0].flat)?;
/// assert!((found[0].shape.area() - 80.0).abs() < 1e-9 && (found[0].shape.length() - 48.0).abs() < 1e-9);
/// # Ok::<(), torse_designs::DesignError>(())
/// ```
pub fn openings(
    design: &Design,
    piece: &DesignPiece,
    flat: &FlatPattern,
) -> Result<Vec<Opening>, DesignError> {
    let mut found: Vec<Opening> = Vec::new();
    let patches = piece.patches.iter().enumerate();
    for (number, index) in patches {
        let Some(patch) = design.patches.get(*index) else {
            continue;
        };
        let marked = MarkedPatch {
            design,
            piece,
            flat,
            patch,
            number,
        };
        for mark in &patch.marks {
            let own = match mark {
                Mark::Hole(at, radius) => vec![marked.round(*at, *radius)?],
                Mark::Opening(opening) => marked.shaped(opening)?,
                _ => continue,
            };
            for opening in own {
                marked.check(&opening, &found)?;
                found.push(opening);
            }
        }
    }
    Ok(found)
}

/// A patch with an opening, and the pattern of its piece.
#[derive(Clone, Copy)]
struct MarkedPatch<'a> {
    design: &'a Design,
    piece: &'a DesignPiece,
    flat: &'a FlatPattern,
    patch: &'a Patch,
    /// Its place in the piece.
    number: usize,
}

impl MarkedPatch<'_> {
    fn failed(&self, reason: impl std::fmt::Display) -> DesignError {
        DesignError::Mark {
            patch: self.patch.name.clone(),
            reason: reason.to_string(),
        }
    }

    fn round(&self, [u, v]: [f64; 2], radius: f64) -> Result<Opening, DesignError> {
        let flat = self.flat;
        let place = position(flat, self.patch).map(|piece| PatternPlace { piece, x: u, v });
        let centre = place.and_then(|place| flat.flatten(place));
        let centre =
            centre.ok_or_else(|| self.failed(format!("[{u}, {v}] is outside the patch")))?;
        Ok(Opening {
            shape: OpeningShape::Round(centre, radius),
            name: format!("the hole of radius {radius} mm at [{u}, {v}]"),
            error: flat.errors().point,
            proved: flat.evidence() == PatternEvidence::Proved,
            finished: None,
            patch: place.map_or(0, |place| place.piece),
        })
    }

    /// Returns what an entry opens: one opening, of what passes through twice, two.
    fn shaped(&self, opening: &MarkedOpening) -> Result<Vec<Opening>, DesignError> {
        let name = match opening {
            MarkedOpening::OnSheet {
                curve, at: [u, v], ..
            } => format!("the opening `{}` at [{u}, {v}]", curve.name),
            MarkedOpening::OnParameters(_) => "the opening by its corners".to_owned(),
            MarkedOpening::InSpace { curve, .. } => format!("the opening `{}`", curve.name),
            MarkedOpening::Passed { name, .. } => {
                format!("the opening through which `{name}` passes")
            }
        };
        if let MarkedOpening::InSpace { curve, along: None } = opening
            && let Some(frame) = PlaneFrame::of_sheet(&self.patch.sheet)
            && self.piece.patches.len() == 1
        {
            return Ok(vec![self.in_plane(&frame, curve, &name)?]);
        }
        let polygons = polygons(self, opening)
            .map_err(|reason| self.failed(format!("{name} cannot be cut: {reason}")))?;
        let contours = polygons
            .into_iter()
            .map(|polygon| self.contour(polygon, &name));
        contours.collect()
    }

    /// Returns the opening in a plane patch: lines and arcs are what they are.
    fn in_plane(
        &self,
        frame: &PlaneFrame,
        curve: &NamedCurve,
        name: &str,
    ) -> Result<Opening, DesignError> {
        let limits = &self.design.tolerances;
        let contour = frame.contour(&curve.curve, limits.outline, limits.gap);
        let contour = contour
            .and_then(|contour| on_pattern(self.flat, &contour))
            .map_err(|reason| self.failed(format!("{name} cannot be cut: {reason}")))?;
        self.check_simple(&contour.segments, 2.0 * contour.distance, name)?;
        Ok(Opening {
            shape: OpeningShape::Contour(contour.segments),
            name: name.to_owned(),
            error: contour.distance + self.flat.errors().point,
            // The distance is a bound also where the length is measured.
            proved: self.flat.evidence() == PatternEvidence::Proved,
            finished: None,
            patch: 0,
        })
    }

    /// Refuses a contour that comes within a distance of itself, or goes around twice.
    fn check_simple(
        &self,
        contour: &[Segment],
        within: f64,
        name: &str,
    ) -> Result<(), DesignError> {
        if let Some(at) = self_contact(contour, within) {
            let place = self.place(at);
            return Err(self.failed(format!(
                "{name} crosses itself at {place}, or touches itself there"
            )));
        }
        if !goes_around_once(contour) {
            return Err(self.failed(format!("{name} goes around more than once")));
        }
        Ok(())
    }

    /// Returns the opening of a fine polygon.
    fn contour(&self, polygon: FinePolygon, name: &str) -> Result<Opening, DesignError> {
        let within = self.design.tolerances.outline;
        let FinePolygon {
            mut points,
            mut corners,
            distance,
        } = polygon;
        let area: f64 = sides(&points).map(|side| side.area()).sum();
        if area < 0.0 {
            // Counterclockwise, with the same first corner.
            let last = points.len();
            points.reverse();
            points.rotate_right(1);
            corners = corners.iter().map(|k| (last - k) % last).collect();
            corners.sort_unstable();
        }
        let (segments, off) = fitted(&points, &corners, FITTED * within);
        if segments.len() < 2 || area == 0.0 {
            return Err(self.failed(format!("{name} has no area")));
        }
        // Both sides may be off by what the polygon and its lines and arcs are.
        self.check_simple(&segments, 2.0 * (distance + off), name)?;
        Ok(Opening {
            shape: OpeningShape::Contour(segments),
            name: name.to_owned(),
            error: self.flat.errors().point + distance + off,
            // Of sheets that are only nearly developable, the second derivative in space is no bound for that on the pattern.
            proved: self.flat.evidence() == PatternEvidence::Proved
                && self.flat.flattening().is_none(),
            finished: None,
            patch: position(self.flat, self.patch).unwrap_or(0),
        })
    }
}

/// Returns the sides of a closed polygon.
fn sides(points: &[[f64; 2]]) -> impl Iterator<Item = Segment> {
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|(a, b)| Segment::line(*a, *b))
}
