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
/// Distances that differ by no more, as a share of the length around, are equal.
const SAME: f64 = 1e-9;

/// Returns the allowance of each segment of the outline of a blank: that of the edge on which its middle lies. `None`
/// where no edge has one.
pub(super) fn allowances(design: &Design, piece: &FlatPiece, blank: &Blank) -> Option<Vec<f64>> {
    let edges = edges(design, piece, blank);
    if edges.iter().all(|(_, by)| *by == 0.0) {
        return None;
    }
    let size: f64 = blank.outline.iter().map(Segment::length).sum();
    let allowance = |segment: &Segment| {
        let middle = segment.point(0.5);
        let away = edges.iter().map(|(edge, by)| (distance(edge, middle), *by));
        let least = away
            .clone()
            .map(|(off, _)| off)
            .fold(f64::INFINITY, f64::min);
        // The strip of a bend lies between two edges: the wider allowance is that of both.
        let near = away.filter(|(off, _)| *off <= least + SAME * size);
        near.map(|(_, by)| by).fold(0.0, f64::max)
    };
    Some(blank.outline.iter().map(allowance).collect())
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
        // Up to where bends take the patch; points of a bend have a place too.
        let on = |chain: &[Segment]| -> Vec<[f64; 2]> {
            let kept = blank.kept(place, chain);
            let points = kept
                .iter()
                .flat_map(|segment| chord_points(segment, ARC_POINTS).chain([segment.to]));
            points.filter_map(|p| blank.moved(place, p)).collect()
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
            edges.push((on(&rail), allowance(edge)));
        }
        let backward = flat.is_backward(place).unwrap_or_default();
        let [start, end] = flat.end_rulings(place).unwrap_or_default();
        let names = if backward {
            [PatchEdge::End, PatchEdge::Start]
        } else {
            [PatchEdge::Start, PatchEdge::End]
        };
        let ruling = |ends: [[f64; 2]; 2]| -> Vec<[f64; 2]> {
            let ends = ends.into_iter();
            ends.filter_map(|p| blank.moved(place, p)).collect()
        };
        // Where patches are attached there is no edge.
        if place == 0 {
            edges.push((ruling(start), allowance(names[0])));
        }
        if place == last {
            edges.push((ruling(end), allowance(names[1])));
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
