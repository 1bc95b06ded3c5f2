//! Allowances: what is cut beyond the edges of a part, so that it can be sewn, welded or glued there.

use super::FlatPiece;
use super::blank::Blank;
use crate::design::Design;
use crate::polygon::chord_points;
use crate::position::position;
use crate::seams::PatchEdge;
use torse_geometry::pattern::Segment;

/// Points of an edge that stand for an arc of it.
const ARC_POINTS: u32 = 8;

/// Returns the allowance of each segment of the outline of a blank: that of the edge on which its middle lies. `None`
/// where no edge has one.
pub(super) fn allowances(design: &Design, piece: &FlatPiece, blank: &Blank) -> Option<Vec<f64>> {
    let edges = edges(design, piece, blank);
    if edges.iter().all(|(_, by)| *by == 0.0) {
        return None;
    }
    let of = |segment: &Segment| {
        let middle = segment.point(0.5);
        let near = edges
            .iter()
            .min_by(|(a, _), (b, _)| distance(a, middle).total_cmp(&distance(b, middle)));
        near.map_or(0.0, |(_, by)| *by)
    };
    Some(blank.outline.iter().map(of).collect())
}

/// Returns the edges of the patches of a piece on its blank as polygons, with their allowances.
fn edges(
    design: &Design,
    FlatPiece { piece, flat }: &FlatPiece,
    blank: &Blank,
) -> Vec<(Vec<[f64; 2]>, f64)> {
    let patches = piece.patches.iter();
    let patches = patches.filter_map(|index| design.patches.get(*index));
    let placed: Vec<_> = patches
        .filter_map(|patch| Some((position(flat, patch)?, patch)))
        .collect();
    let last = flat.pieces().saturating_sub(1);
    let mut edges = Vec::new();
    for (place, patch) in placed {
        let on = |points: Vec<[f64; 2]>| -> Vec<[f64; 2]> {
            let points = points.into_iter();
            points.filter_map(|p| blank.place(place, p, 0.0)).collect()
        };
        let allowance = |edge: PatchEdge| {
            let own = patch.allowances.iter().find(|(known, _)| *known == edge);
            own.map_or(design.allowance, |(_, by)| *by)
        };
        for (side, edge) in [PatchEdge::First, PatchEdge::Second]
            .into_iter()
            .enumerate()
        {
            let rail = flat.rail(place, side).unwrap_or_default();
            let points = rail
                .iter()
                .flat_map(|segment| chord_points(segment, ARC_POINTS).chain([segment.to]));
            edges.push((on(points.collect()), allowance(edge)));
        }
        let backward = flat.is_backward(place).unwrap_or_default();
        let [start, end] = flat.end_rulings(place).unwrap_or_default();
        let names = if backward {
            [PatchEdge::End, PatchEdge::Start]
        } else {
            [PatchEdge::Start, PatchEdge::End]
        };
        // Where patches are attached there is no edge.
        if place == 0 {
            edges.push((on(start.to_vec()), allowance(names[0])));
        }
        if place == last {
            edges.push((on(end.to_vec()), allowance(names[1])));
        }
    }
    edges
}

/// Returns the distance of a point from a polygon; infinite from none.
fn distance(polygon: &[[f64; 2]], point: [f64; 2]) -> f64 {
    let sides = polygon
        .windows(2)
        .map(|side| Segment::line(side[0], side[1]));
    sides
        .map(|side| side.distance(point))
        .fold(f64::INFINITY, f64::min)
}
