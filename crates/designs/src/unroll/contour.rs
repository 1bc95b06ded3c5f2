//! Contours as a cutter wants them: no vertex between two lines in one direction, one arc where several follow one
//! circle, and the part turned to its smallest box.

use crate::polygon::{chord_points, distance, hull};
use std::f64::consts::PI;
use torse_exchange::Vertex;
use torse_geometry::pattern::{Placement, Segment};

/// The most segments that become one.
const MAX_RUN: usize = 4096;
/// Arcs of more than a half circle stay divided: their bulges grow without bound.
const MAX_ARC_ANGLE: f64 = PI * (1.0 + 1e-9);
/// A box must be smaller by this share to be preferred to an earlier one.
const SMALLER: f64 = 1e-9;
/// The most directions of the sides of boxes that are looked at.
const MAX_DIRECTIONS: usize = 1024;
/// Points that stand for an arc when the directions of the sides of boxes are chosen.
const ARC_POINTS: u32 = 16;

/// Returns the vertices of a closed contour.
pub(super) fn vertices_of(outline: &[Segment]) -> Vec<Vertex> {
    let vertex = |segment: &Segment| Vertex {
        point: segment.from,
        bulge: segment.bulge,
    };
    outline.iter().map(vertex).collect()
}

/// Returns a closed contour with as few segments as lie within a distance of it, and how far they are from it at most:
/// a bound, not a sample.
pub(super) fn simplified(contour: &[Segment], within: f64) -> (Vec<Segment>, f64) {
    let count = contour.len();
    // A start that is a corner, so that no run is cut there.
    let corner = (0..count).find(|start| {
        let before = contour.get((start + count - 1) % count);
        let pair = [before, contour.get(*start)].map(|s| s.copied());
        matches!(pair, [Some(a), Some(b)] if joined(&[a, b], within).is_none())
    });
    let start = corner.unwrap_or(0);
    let all: Vec<Segment> = contour
        .iter()
        .cycle()
        .skip(start)
        .take(count)
        .copied()
        .collect();
    let (mut kept, mut off) = (Vec::with_capacity(count), 0.0_f64);
    let mut from = 0;
    while from < count {
        let (mut best, mut to) = (None, from + 1);
        while to < count && to - from < MAX_RUN {
            let run = all.get(from..=to).unwrap_or_default();
            let Some(found) = joined(run, within) else {
                break;
            };
            best = Some(found);
            to += 1;
        }
        match best {
            Some((segment, distance)) => {
                kept.push(segment);
                off = off.max(distance);
            }
            None => kept.extend(all.get(from)),
        }
        from = to;
    }
    (kept, off)
}

/// Returns one segment for a run of them, and a bound of its distance from them.
fn joined(run: &[Segment], within: f64) -> Option<(Segment, f64)> {
    let (first, last) = (run.first()?, run.last()?);
    if run.iter().all(Segment::is_line) {
        return line(run, Segment::line(first.from, last.to), within);
    }
    if run.iter().any(Segment::is_line) {
        return None;
    }
    let angle: f64 = run.iter().map(Segment::angle).sum();
    let same_way = run.iter().all(|segment| segment.bulge * first.bulge > 0.0);
    if !same_way || angle.abs() > MAX_ARC_ANGLE {
        return None;
    }
    let arc = Segment {
        from: first.from,
        to: last.to,
        bulge: libm::tan(0.25 * angle),
    };
    let (centre, radius) = arc.circle()?;
    let mut off = 0.0_f64;
    for segment in run {
        let (own, own_radius) = segment.circle()?;
        // Every point of the segment is within this of the other circle.
        off = off.max(distance(own, centre) + (own_radius - radius).abs());
    }
    (off <= within).then_some((arc, off))
}

/// Returns the line for a run of lines that goes forward along it.
fn line(run: &[Segment], whole: Segment, within: f64) -> Option<(Segment, f64)> {
    let [x, y] = [0, 1].map(|i| whole.to[i] - whole.from[i]);
    let length = libm::hypot(x, y);
    let (mut at, mut off) = (0.0_f64, 0.0_f64);
    for segment in run {
        let [dx, dy] = [0, 1].map(|i| segment.to[i] - whole.from[i]);
        let along = (dx * x + dy * y) / length;
        if along.is_nan() || along <= at {
            return None;
        }
        at = along;
        off = off.max(((dx * y - dy * x) / length).abs());
    }
    (off <= within).then_some((whole, off))
}

/// Returns the motion that turns a contour to its smallest box, the longer side along the first axis and the lower left
/// corner at the origin; no turn where no box is smaller than the present one.
pub(super) fn to_smallest_box(contour: &[Segment]) -> Placement {
    let points = contour
        .iter()
        .flat_map(|segment| chord_points(segment, ARC_POINTS));
    let hull = hull(points.collect());
    let sides = hull.iter().zip(hull.iter().cycle().skip(1));
    // Of a smooth outline every point is a corner: some directions are as good as all.
    let step = hull.len().div_ceil(MAX_DIRECTIONS).max(1);
    let directions = sides
        .step_by(step)
        .map(|(a, b)| libm::atan2(b[1] - a[1], b[0] - a[0]));
    let (mut best, mut least) = (Placement::default(), f64::INFINITY);
    for angle in std::iter::once(0.0).chain(directions) {
        let turn = Placement::turned(-angle);
        let [low, high] = bounds(contour, &turn);
        let area = (high[0] - low[0]) * (high[1] - low[1]);
        if area < least * (1.0 - SMALLER) {
            (best, least) = (turn, area);
        }
    }
    let [low, high] = bounds(contour, &best);
    if high[1] - low[1] > (high[0] - low[0]) * (1.0 + SMALLER) {
        best = best.then(&Placement::turned(0.5 * PI));
    }
    let [low, _] = bounds(contour, &best);
    best.then(&Placement::shifted(low.map(|c| -c)))
}

/// Returns the motion that turns a direction, in radians, to the first axis, and the lower left corner to the origin.
pub(super) fn turned_to(contour: &[Segment], direction: f64) -> Placement {
    let turn = Placement::turned(-direction);
    let [low, _] = bounds(contour, &turn);
    turn.then(&Placement::shifted(low.map(|c| -c)))
}

/// Returns the box around a contour that is moved.
pub(super) fn bounds(contour: &[Segment], placement: &Placement) -> [[f64; 2]; 2] {
    let start = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    contour.iter().fold(start, |[low, high], segment| {
        let [a, b] = placement.segment(segment).bounds();
        [
            [low[0].min(a[0]), low[1].min(a[1])],
            [high[0].max(b[0]), high[1].max(b[1])],
        ]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::polygon::lines_around as polygon;

    #[test]
    fn vertices_between_lines_in_one_direction_go_and_corners_stay() {
        let mut points: Vec<[f64; 2]> = (0..100).map(|k| [f64::from(k), 0.0]).collect();
        points.extend([[100.0, 0.0], [100.0, 20.0], [0.0, 20.0], [0.0, 10.0]]);
        let (kept, off) = simplified(&polygon(&points), 1e-9);
        assert_eq!(kept.len(), 4, "{kept:?}");
        assert_eq!(off, 0.0);
        let area: f64 = kept.iter().map(Segment::area).sum();
        assert!((area - 2000.0).abs() < 1e-9);
    }

    #[test]
    fn arcs_of_one_circle_become_arcs_of_half_a_circle_at_most() {
        let quarter = libm::tan(PI / 8.0);
        let corners = [[5.0, 0.0], [0.0, 5.0], [-5.0, 0.0], [0.0, -5.0]];
        let arcs: Vec<Segment> = polygon(&corners)
            .into_iter()
            .map(|side| Segment {
                bulge: quarter,
                ..side
            })
            .collect();
        let (kept, off) = simplified(&arcs, 1e-9);
        assert_eq!(kept.len(), 2);
        assert!(off < 1e-12 && kept.iter().all(|arc| (arc.bulge - 1.0).abs() < 1e-12));
    }

    #[test]
    fn what_turns_back_or_leaves_the_line_is_no_line() {
        let back = [[0.0, 0.0], [10.0, 0.0], [5.0, 0.0], [5.0, 5.0]];
        assert_eq!(simplified(&polygon(&back), 0.1).0.len(), 4);
        let bent = [[0.0, 0.0], [5.0, 0.02], [10.0, 0.0], [5.0, 5.0]];
        assert_eq!(simplified(&polygon(&bent), 0.01).0.len(), 4);
        let (kept, off) = simplified(&polygon(&bent), 0.03);
        assert_eq!(kept.len(), 3);
        assert!((off - 0.02).abs() < 1e-15);
    }

    #[test]
    fn a_turned_rectangle_lies_along_the_axes_again() {
        let corners = [[0.0, 0.0], [40.0, 0.0], [40.0, 90.0], [0.0, 90.0]];
        let turned: Vec<Segment> = polygon(&corners)
            .iter()
            .map(|side| Placement::turned(0.4).segment(side))
            .collect();
        let [low, high] = bounds(&turned, &to_smallest_box(&turned));
        assert!(low.iter().all(|c| c.abs() < 1e-12));
        assert!((high[0] - 90.0).abs() < 1e-12 && (high[1] - 40.0).abs() < 1e-12);
    }
}
