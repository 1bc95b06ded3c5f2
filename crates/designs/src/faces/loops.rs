//! The loops of a face: which of them bound it, and which are openings.

use super::{FaceSheets, words};
use crate::design::{Mark, MarkedOpening, NamedCurve};
use torse_exchange::{FaceBorder, Imported, ImportedFace};
use torse_geometry::prelude::PiecewiseRail;

/// The most loops that bound a face.
const MAX_OUTER: usize = 2;
/// Lengths by which loops are put in order are off by no more, in millimetres.
const ACCURACY: f64 = 1e-3;

/// An edge of a face, and whether it is passed forward.
type FaceEdge = (usize, bool);

/// Returns the sheets of a face, or why it has none. If its loops all together do not bound it, the loop that the file names
/// does, with another one if need be; where it names none, the longest, or the two longest; where the surface bounds itself,
/// none. The others are openings: that they lie on the sheet and within its outline is found out where they are cut.
pub(super) fn sheets_with_openings(
    face: &ImportedFace,
    imported: &Imported,
    bounded: impl Fn(&ImportedFace) -> Result<FaceSheets, String>,
) -> Result<FaceSheets, String> {
    let whole = bounded(face);
    let count = face.loops.len();
    if face.border == FaceBorder::OwnOfSurface {
        let mut found = whole?;
        for (index, edges) in face.loops.iter().enumerate() {
            found
                .openings
                .push(opening(index, curve_of(edges, imported)?));
        }
        return Ok(found);
    }
    if whole.is_ok() || count < 2 {
        return whole;
    }
    let mut curves = Vec::with_capacity(count);
    for (index, edges) in face.loops.iter().enumerate() {
        let curve = curve_of(edges, imported)?;
        let length = curve.length(ACCURACY).map_err(words)?;
        curves.push((length, index, curve));
    }
    curves.sort_by(|a, b| b.0.total_cmp(&a.0));
    // The one that is named comes first, however long the others are.
    if let FaceBorder::Loop(named) = face.border {
        curves.sort_by_key(|(_, index, _)| *index != named);
    }
    for outer in 1..=MAX_OUTER.min(count - 1) {
        let (border, inner) = curves.split_at(outer);
        let loops = border.iter();
        let loops = loops.filter_map(|(_, index, _)| face.loops.get(*index).cloned());
        let face = ImportedFace {
            loops: loops.collect(),
            ..face.clone()
        };
        if let Ok(found) = bounded(&face) {
            let mut inner: Vec<_> = inner.iter().collect();
            inner.sort_by_key(|(_, index, _)| *index);
            let openings = inner
                .into_iter()
                .map(|(_, index, curve)| opening(*index, curve.clone()));
            return Ok(FaceSheets {
                openings: openings.collect(),
                ..found
            });
        }
    }
    whole
}

/// Returns a loop with its name, by its index.
pub(super) fn named(index: usize, curve: PiecewiseRail) -> NamedCurve {
    NamedCurve {
        name: format!("loop {}", index + 1),
        curve,
    }
}

/// Returns a loop as an opening.
pub(super) fn opening(index: usize, curve: PiecewiseRail) -> Mark {
    Mark::Opening(MarkedOpening::InSpace {
        curve: named(index, curve),
        along: None,
    })
}

/// Returns the edges of a loop as one curve.
pub(super) fn curve_of(edges: &[FaceEdge], imported: &Imported) -> Result<PiecewiseRail, String> {
    let mut curves = Vec::with_capacity(edges.len());
    for (edge, forward) in edges {
        let curve = imported.curves.get(*edge);
        let shape = &curve.ok_or("an edge is missing")?.shape;
        let rail = if *forward {
            shape.rail()
        } else {
            shape.reversed().rail()
        };
        curves.push(rail.map_err(words)?);
    }
    PiecewiseRail::joined(&curves).map_err(words)
}
