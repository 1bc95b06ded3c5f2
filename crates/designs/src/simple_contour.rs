//! Whether a closed contour is simple: that it nowhere comes back to where it has been, and goes around once.

use crate::polygon::distance;
use crate::segment_crossings::carrier_crossings;
use std::f64::consts::PI;
use torse_geometry::pattern::Segment;

/// Parts of a contour are neighbours, and near to each other for that reason, up to this times the distance that is asked for.
const NEIGHBOURS: f64 = 64.0;
/// Rounding, as a share of the size of a contour.
const ROUNDING: f64 = 1e-9;
/// Neighbours in any case, as a share of the size: where two arcs touch, their crossing is known no better.
const TOUCHING: f64 = 1e-6;
/// Corners that turn by half a turn, but for this, have no side to which they turn.
const REVERSAL: f64 = 1e-6;

/// Returns a point at which a closed contour comes within a distance of itself, beyond rounding: where it crosses itself,
/// touches itself, or lies on itself. Near a corner both sides are near to each other; that counts where they still are
/// 64 times the distance away from it.
pub fn self_contact(contour: &[Segment], within: f64) -> Option<[f64; 2]> {
    let size = size(contour);
    let within = within + ROUNDING * size;
    let apart = (NEIGHBOURS * within).max(TOUCHING * size);
    let mut whole = 0.0;
    let mut starts = Vec::with_capacity(contour.len());
    for segment in contour {
        starts.push(whole);
        whole += segment.length();
    }
    let boxes: Vec<[[f64; 2]; 2]> = contour.iter().map(Segment::bounds).collect();
    let mut order: Vec<usize> = (0..contour.len()).collect();
    let low = |k: usize, axis: usize| boxes.get(k).map_or(f64::NAN, |b| b[0][axis]);
    let high = |k: usize, axis: usize| boxes.get(k).map_or(f64::NAN, |b| b[1][axis]);
    order.sort_by(|a, b| low(*a, 0).total_cmp(&low(*b, 0)));
    for (k, i) in order.iter().enumerate() {
        let behind = order.iter().skip(k + 1);
        for j in behind.take_while(|j| low(**j, 0) <= high(*i, 0) + within) {
            if low(*j, 1) > high(*i, 1) + within || low(*i, 1) > high(*j, 1) + within {
                continue;
            }
            let (first, second) = (*i.min(j), *i.max(j));
            let (Some(a), Some(b)) = (contour.get(first), contour.get(second)) else {
                continue;
            };
            let (Some(start), Some(next)) = (starts.get(first), starts.get(second)) else {
                continue;
            };
            let between = (next - start - a.length()).max(0.0);
            let around = (whole - (next - start) - b.length()).max(0.0);
            let is_far = |p: [f64; 2], q: [f64; 2]| {
                let forward = distance(p, a.to) + between + distance(b.from, q);
                let back = distance(q, b.to) + around + distance(a.from, p);
                forward.min(back) > apart
            };
            let near = near_points(a, b, within).into_iter();
            if let Some((at, _)) = near.into_iter().find(|(p, q)| is_far(*p, *q)) {
                return Some(at);
            }
        }
    }
    None
}

/// Returns whether a closed contour goes around once: its direction turns by one full turn. One that turns back somewhere
/// is not judged, and does.
pub fn goes_around_once(contour: &[Segment]) -> bool {
    let small = ROUNDING * size(contour);
    let long: Vec<&Segment> = contour
        .iter()
        .filter(|s| s.chord_length() > small)
        .collect();
    let next = long.iter().cycle().skip(1);
    let mut turned = 0.0;
    for (a, b) in long.iter().zip(next) {
        let corner = libm::remainder(direction(b, false) - direction(a, true), 2.0 * PI);
        if corner.abs() > PI - REVERSAL {
            return true;
        }
        turned += a.angle() + corner;
    }
    (turned.abs() - 2.0 * PI).abs() < PI
}

/// Returns the direction of a segment at its start, or at its end, in radians.
pub fn direction(segment: &Segment, at_end: bool) -> f64 {
    let way = [0, 1].map(|i| segment.to[i] - segment.from[i]);
    let half = 0.5 * segment.angle();
    libm::atan2(way[1], way[0]) + if at_end { half } else { -half }
}

fn size(contour: &[Segment]) -> f64 {
    let bounds = contour.iter().map(Segment::bounds);
    let whole = bounds.reduce(|[a, b], [c, d]| {
        [
            [a[0].min(c[0]), a[1].min(c[1])],
            [b[0].max(d[0]), b[1].max(d[1])],
        ]
    });
    whole.map_or(0.0, |[low, high]| distance(low, high))
}

/// Returns pairs of points of two segments, where the segments come nearest to each other and at their ends and middles, that
/// are no farther apart than this.
fn near_points(a: &Segment, b: &Segment, within: f64) -> Vec<([f64; 2], [f64; 2])> {
    let crossings = carrier_crossings(a, b, 0.0, 0.0).into_iter();
    let on_both = |p: &[f64; 2]| a.distance(*p) <= within && b.distance(*p) <= within;
    let mut found: Vec<_> = crossings.filter(on_both).map(|p| (p, p)).collect();
    for point in extreme_points(a, b) {
        found.extend(
            foot(b, point)
                .filter(|q| distance(point, *q) <= within)
                .map(|q| (point, q)),
        );
    }
    for point in extreme_points(b, a) {
        found.extend(
            foot(a, point)
                .filter(|p| distance(point, *p) <= within)
                .map(|p| (p, point)),
        );
    }
    found
}

/// Returns the points of a segment at which its distance from another can be least, if they do not cross; and its middle.
fn extreme_points(own: &Segment, other: &Segment) -> Vec<[f64; 2]> {
    let mut points = vec![own.from, own.point(0.5), own.to];
    let seen_from = match (own.circle(), other.circle()) {
        (_, Some((centre, _))) => Some(centre),
        // The point of a circle in the direction of a line.
        (Some((centre, _)), None) => foot(&Segment::line(other.from, other.to), centre),
        (None, None) => None,
    };
    points.extend(seen_from.and_then(|from| foot(own, from)));
    points
}

/// Returns the point of a segment that is nearest to a point.
fn foot(segment: &Segment, point: [f64; 2]) -> Option<[f64; 2]> {
    let ends = [segment.from, segment.to];
    let near = match segment.circle() {
        None => {
            let way = [0, 1].map(|i| segment.to[i] - segment.from[i]);
            let arm = [0, 1].map(|i| point[i] - segment.from[i]);
            let square = way[0] * way[0] + way[1] * way[1];
            let share = (arm[0] * way[0] + arm[1] * way[1]) / square;
            (0.0..=1.0)
                .contains(&share)
                .then(|| [0, 1].map(|i| segment.from[i] + share * way[i]))
        }
        Some((centre, radius)) => {
            let arm = [0, 1].map(|i| point[i] - centre[i]);
            let away = libm::hypot(arm[0], arm[1]);
            let way = |p: [f64; 2]| libm::atan2(p[1] - centre[1], p[0] - centre[0]);
            let turned = (way(point) - way(segment.from)) * segment.bulge.signum();
            (away > 0.0 && turned.rem_euclid(2.0 * PI) <= segment.angle().abs())
                .then(|| [0, 1].map(|i| centre[i] + radius / away * arm[i]))
        }
    };
    let all = ends.into_iter().chain(near);
    all.min_by(|p, q| distance(*p, point).total_cmp(&distance(*q, point)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::polygon::lines_around as polygon;

    fn circle(times: u32, radius: f64) -> Vec<Segment> {
        let half = |x: f64| Segment {
            from: [x, 0.0],
            to: [-x, 0.0],
            bulge: 1.0,
        };
        (0..times)
            .flat_map(|_| [half(radius), half(-radius)])
            .collect()
    }

    const SQUARE: [[f64; 2]; 4] = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];

    #[test]
    fn what_is_passed_twice_touches_or_turns_back_is_found() {
        let twice = [SQUARE, SQUARE].concat();
        let spike = [
            [0., 0.],
            [10., 0.],
            [10., 10.],
            [5., 10.],
            [5., 15.],
            [5., 10.],
            [0., 10.],
        ];
        let touching = [
            [0., 0.],
            [10., 10.],
            [20., 0.],
            [20., 20.],
            [10., 10.],
            [0., 20.],
        ];
        let slit = [
            [0., 0.],
            [10., 0.],
            [10., 10.],
            [0., 10.],
            [0., 0.],
            [2., 2.],
            [2., 8.],
            [8., 8.],
            [8., 2.],
            [2., 2.],
        ];
        for points in [&twice[..], &spike, &touching, &slit] {
            assert!(self_contact(&polygon(points), 0.0).is_some(), "{points:?}");
        }
        assert!(self_contact(&circle(2, 10.0), 0.0).is_some());
        // Too small to be seen beside the distance, and yet passed twice.
        assert!(!goes_around_once(&circle(2, 0.01)) && !goes_around_once(&polygon(&twice)));
    }

    #[test]
    fn simple_contours_are_simple_sharp_corners_and_cusps_too() {
        let needle = [[0.0, 0.0], [100.0, 0.0], [100.0, 0.5]];
        for contour in [polygon(&SQUARE), polygon(&needle), circle(1, 10.0)] {
            assert_eq!(self_contact(&contour, 1e-3), None, "{contour:?}");
            assert!(goes_around_once(&contour));
        }
        // Three arcs that meet in cusps.
        let corners = [[0.0, 0.0], [10.0, 0.0], [5.0, 5.0 * 3.0_f64.sqrt()]];
        let deltoid: Vec<Segment> = polygon(&corners)
            .into_iter()
            .map(|side| Segment {
                bulge: -libm::tan(PI / 12.0),
                ..side
            })
            .collect();
        assert_eq!(self_contact(&deltoid, 1e-6), None);
        // Within a distance: a slot of that width.
        let slot = [[0.0, 0.0], [10.0, 0.0], [10.0, 0.01], [0.0, 0.01]];
        assert_eq!(self_contact(&polygon(&slot), 1e-3), None);
        assert!(self_contact(&polygon(&slot), 0.02).is_some());
    }
}
