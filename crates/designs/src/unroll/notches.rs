//! Notches on edges that meet: one at a third of the seam, two at two thirds, so that neither end can be taken for the
//! other.

use super::FlatPiece;
use super::blank::Blank;
use crate::design::Design;
use crate::error::DesignError;
use crate::inspect::{SeamPassage, passage};
use crate::polygon::{chord_points, is_within};
use crate::position::position;
use crate::seams::{EdgeName, PatchEdge};
use torse_geometry::pattern::{PatternPlace, Segment};

/// How long a notch is, in millimetres.
const LENGTH: f64 = 3.0;
/// How far the two of a pair are from each other, in millimetres.
const PAIR: f64 = 3.0;
/// Where notches are, as shares of the length of the edge, and how many.
const NOTCHES: [(f64, u32); 2] = [(1.0 / 3.0, 1), (2.0 / 3.0, 2)];
/// Chords that stand for an arc where it is asked which side of an edge is inside.
const ARC_POINTS: u32 = 16;

/// Returns the notches of a piece on its blank, each a line from the edge inwards.
///
/// # Errors
/// [`DesignError::Patch`] for an edge that the geometry refuses.
pub(super) fn notches(
    design: &Design,
    piece: &FlatPiece,
    blank: &Blank,
) -> Result<Vec<[[f64; 2]; 2]>, DesignError> {
    let outline: Vec<[f64; 2]> = blank
        .outline
        .iter()
        .flat_map(|segment| chord_points(segment, ARC_POINTS))
        .collect();
    let mut found = Vec::new();
    for seam in &design.seams {
        let second = passage(design, seam).map_err(|reason| DesignError::Patch {
            patch: seam.edges[1].text.clone(),
            reason,
        })?;
        let first = SeamPassage {
            backwards: false,
            offset: 0.0,
        };
        for (edge, way) in seam.edges.iter().zip([first, second]) {
            let Some(segments) = edge_on_pattern(design, piece, edge) else {
                continue;
            };
            let whole: f64 = segments.iter().map(|(_, segment)| segment.length()).sum();
            for (share, count) in NOTCHES {
                let share = way.share(share);
                for k in 0..count {
                    let aside = (f64::from(k) - 0.5 * f64::from(count - 1)) * PAIR;
                    let at = share * whole + aside;
                    // A closed edge goes on where it begins.
                    let at = if way.offset == 0.0 {
                        at
                    } else {
                        at.rem_euclid(whole)
                    };
                    found.extend(notch(&segments, at, blank, &outline));
                }
            }
        }
    }
    Ok(found)
}

/// Returns the segments of an edge on the pattern with their patches, from the point with the smaller parameter;
/// nothing where it is not all on this piece.
fn edge_on_pattern(
    design: &Design,
    FlatPiece { piece, flat }: &FlatPiece,
    edge: &EdgeName,
) -> Option<Vec<(usize, Segment)>> {
    let mut segments = Vec::new();
    for index in &edge.patches {
        if !piece.patches.contains(index) {
            return None;
        }
        let place = position(flat, design.patches.get(*index)?)?;
        let ruling = |x: f64| {
            let end = |v: f64| flat.flatten(PatternPlace { piece: place, x, v });
            Some(vec![Segment::line(end(0.0)?, end(1.0)?)])
        };
        let own = match edge.edge {
            PatchEdge::Start => ruling(0.0)?,
            PatchEdge::End => ruling(1.0)?,
            PatchEdge::First => flat.rail(place, 0)?,
            PatchEdge::Second => flat.rail(place, 1)?,
        };
        segments.extend(own.into_iter().map(|segment| (place, segment)));
    }
    Some(segments)
}

/// Returns the notch at a length along an edge.
fn notch(
    segments: &[(usize, Segment)],
    at: f64,
    blank: &Blank,
    outline: &[[f64; 2]],
) -> Option<[[f64; 2]; 2]> {
    let mut left = at;
    for (place, segment) in segments {
        let length = segment.length();
        if left > length {
            left -= length;
            continue;
        }
        let share = (left / length).clamp(0.0, 1.0);
        let on_blank = |share: f64| {
            let point = segment.point(share);
            let placed = blank.place(*place, point, 0.0);
            placed.or_else(|| blank.in_bend(*place, point))
        };
        let point = on_blank(share)?;
        let (a, b) = (
            on_blank((share - 0.01).max(0.0))?,
            on_blank((share + 0.01).min(1.0))?,
        );
        let [x, y] = [b[0] - a[0], b[1] - a[1]];
        let size = libm::hypot(x, y);
        let normal = [-y / size, x / size];
        let inner = |by: f64| [point[0] + by * normal[0], point[1] + by * normal[1]];
        let way = if is_within(outline, inner(0.01 * LENGTH)) {
            1.0
        } else {
            -1.0
        };
        return Some([point, inner(way * LENGTH)]);
    }
    None
}
