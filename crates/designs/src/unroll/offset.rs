//! A closed outline moved to its right, each of its segments by a distance of its own, with mitred corners.

use crate::polygon::distance;
use crate::segment_crossings::carrier_crossings;
use crate::simple_contour::{direction, self_contact};
use std::f64::consts::PI;
use torse_geometry::pattern::Segment;

/// A mitre of an outer corner reaches no farther than this times the larger distance from it: beyond, the corner is cut off.
const MITRE: f64 = 4.0;
/// Lines whose directions differ by an angle of a smaller sine have no corner.
const PARALLEL: f64 = 1e-9;
/// Ends that are no farther apart, as a share of the size of the outline, are one point.
const ROUNDING: f64 = 1e-9;
/// Carriers whose half chord is no longer, as a share of the size, touch.
const TOUCHING: f64 = 1e-6;
/// What a moved segment may fall short of its distance, as a share of the size.
const SHORT: f64 = 1e-7;

/// Returns the outline moved to its right, outwards if it runs counterclockwise; `distances`, not negative, are those of its
/// segments. Corners are mitred; an outer one that is sharp is cut off; a side or an arc that the corners beside it take
/// whole is left out.
///
/// The result is compared with the outline: it is simple, runs the same way around, and none of its parts is nearer to a
/// segment than the smaller of both distances.
///
/// # Errors
/// In words, where that does not hold.
pub(super) fn moved_outwards(
    outline: &[Segment],
    distances: &[f64],
) -> Result<Vec<Segment>, String> {
    let size = outline.iter().map(Segment::length).sum::<f64>();
    let mut live: Vec<Moved> = Vec::with_capacity(outline.len());
    let mut narrow = None;
    for (index, (segment, by)) in outline.iter().zip(distances).enumerate() {
        match shifted(segment, *by) {
            Some(moved) => live.push(Moved {
                index,
                own: *segment,
                by: *by,
                moved,
            }),
            None => narrow = narrow.or(Some((segment.radius(), *by))),
        }
    }
    let narrow = narrow.map(|(radius, by)| {
        format!("an inward curve of radius {radius:.3} mm is narrower than {by} mm")
    });
    let joined = loop {
        let joints = joints(&live, outline.len(), size);
        let joints = joints.map_err(|reason| narrow.clone().unwrap_or(reason))?;
        let parts = live.iter().enumerate().map(|(k, part)| {
            let before = joints.get((k + joints.len() - 1) % joints.len().max(1));
            let [from, to] = [before?.after, joints.get(k)?.before];
            between(&part.moved, from, to)
        });
        let parts: Vec<Option<Segment>> = parts.collect();
        // The shortest of those that run backwards goes first: what is beside it may then have room.
        let backward = live
            .iter()
            .enumerate()
            .filter(|(k, _)| matches!(parts.get(*k), Some(None)));
        let shortest = backward.min_by(|(_, a), (_, b)| a.own.length().total_cmp(&b.own.length()));
        let Some((gone, _)) = shortest else {
            let bridges = joints
                .iter()
                .map(|joint| Segment::line(joint.before, joint.after));
            break parts.into_iter().flatten().zip(bridges).collect::<Vec<_>>();
        };
        live.remove(gone);
    };
    check(outline, distances, &live, &joined, size)?;
    let closed = joined
        .into_iter()
        .flat_map(|(segment, bridge)| [segment, bridge]);
    Ok(closed
        .filter(|segment| segment.from != segment.to)
        .collect())
}

/// A segment of an outline and where it is moved to.
struct Moved {
    /// Its place in the outline.
    index: usize,
    own: Segment,
    by: f64,
    moved: Segment,
}

/// Where a moved segment ends and the next one starts: one point, or two with a line between them.
struct Joint {
    before: [f64; 2],
    after: [f64; 2],
}

/// Returns the joint behind each moved segment of an outline of so many.
fn joints(live: &[Moved], count: usize, size: f64) -> Result<Vec<Joint>, String> {
    let next = live.iter().cycle().skip(1);
    live.iter()
        .zip(next)
        .map(|(a, b)| joint(a, b, count, size))
        .collect()
}

fn joint(a: &Moved, b: &Moved, count: usize, size: f64) -> Result<Joint, String> {
    let ends = [a.moved.to, b.moved.from];
    let apart = distance(ends[0], ends[1]);
    let one = |point| Joint {
        before: point,
        after: point,
    };
    if apart <= ROUNDING * size {
        return Ok(one(middle(ends)));
    }
    let bridge = Joint {
        before: ends[0],
        after: ends[1],
    };
    // Positive at a corner that turns left: an outer one.
    let turn = libm::sin(direction(&b.own, false) - direction(&a.own, true));
    let ahead = libm::cos(direction(&b.own, false) - direction(&a.own, true)) > 0.0;
    let is_next = (a.index + 1) % count == b.index;
    if turn.abs() <= PARALLEL && ahead && (is_next || in_line(&a.moved, &b.moved, size)) {
        return Ok(bridge);
    }
    let corner = middle([a.own.to, b.own.from]);
    let slack = (TOUCHING * size) * (TOUCHING * size);
    let met = carrier_crossings(&a.moved, &b.moved, PARALLEL, slack)
        .into_iter()
        .min_by(|p, q| distance(*p, corner).total_cmp(&distance(*q, corner)));
    // What is left out was narrower than the distances: there, and at inner corners, sides are cut where they meet.
    let is_step = is_next && (turn > 0.0 || a.by != b.by);
    let reach = if is_step {
        MITRE * a.by.max(b.by)
    } else {
        f64::INFINITY
    };
    // Two outer corners with a narrow hollow between them have no corner in common.
    let is_hollow = !is_next && turn > PARALLEL;
    match met.filter(|point| !is_hollow && distance(*point, corner) <= reach) {
        Some(point) => Ok(one(point)),
        None if is_step => Ok(bridge),
        None => Err(format!(
            "what is beside the corner near ({:.2}, {:.2}) is too narrow",
            corner[0], corner[1]
        )),
    }
}

fn middle([a, b]: [[f64; 2]; 2]) -> [f64; 2] {
    [0, 1].map(|i| 0.5 * (a[i] + b[i]))
}

/// Returns whether two lines lie on one.
fn in_line(a: &Segment, b: &Segment, size: f64) -> bool {
    let way = [0, 1].map(|i| a.to[i] - a.from[i]);
    let off = |p: [f64; 2]| {
        ((p[0] - a.from[0]) * way[1] - (p[1] - a.from[1]) * way[0]).abs() / a.chord_length()
    };
    a.is_line() && b.is_line() && off(b.from).max(off(b.to)) <= ROUNDING * size
}

/// Refuses a moved outline that is not simple, runs the other way around, or is nearer to the outline than it should be.
fn check(
    outline: &[Segment],
    distances: &[f64],
    live: &[Moved],
    joined: &[(Segment, Segment)],
    size: f64,
) -> Result<(), String> {
    let near = |[x, y]: [f64; 2], what: &str| Err(format!("{what} near ({x:.2}, {y:.2})"));
    let start = outline.first().map_or([0.0; 2], |segment| segment.from);
    let all: Vec<Segment> = joined
        .iter()
        .flat_map(|(segment, bridge)| [*segment, *bridge])
        .filter(|segment| segment.from != segment.to)
        .collect();
    let area = |contour: &[Segment]| contour.iter().map(Segment::area).sum::<f64>();
    if area(&all) * area(outline) <= 0.0 {
        return near(start, "nothing is left of the outline");
    }
    if let Some(at) = self_contact(&all, 0.0) {
        return near(at, "the outline would cross itself or touch itself");
    }
    for ((moved, _), part) in joined.iter().zip(live) {
        let [low, high] = moved.bounds();
        for (index, (segment, by)) in outline.iter().zip(distances).enumerate() {
            let wanted = part.by.min(*by) - SHORT * size;
            let [from, to] = segment.bounds();
            let is_beside = (0..2).any(|i| from[i] > high[i] + wanted || to[i] < low[i] - wanted);
            if index == part.index || is_beside {
                continue;
            }
            let points = [moved.from, moved.point(0.5), moved.to];
            if let Some(at) = points.into_iter().find(|p| segment.distance(*p) < wanted) {
                return near(at, "the outline would come too near to another part of it");
            }
            let corner = [segment.from, segment.to]
                .into_iter()
                .find(|p| moved.distance(*p) < wanted);
            if let Some(at) = corner {
                return near(at, "the outline would come too near to another part of it");
            }
        }
    }
    Ok(())
}

/// Returns a segment moved to its right; `None` for an arc that is narrower than that.
fn shifted(segment: &Segment, by: f64) -> Option<Segment> {
    let Some((centre, radius)) = segment.circle() else {
        let way = [0, 1].map(|i| segment.to[i] - segment.from[i]);
        let length = libm::hypot(way[0], way[1]);
        if length == 0.0 {
            return None;
        }
        let right = [way[1] / length * by, -way[0] / length * by];
        let point = |p: [f64; 2]| [p[0] + right[0], p[1] + right[1]];
        return Some(Segment::line(point(segment.from), point(segment.to)));
    };
    // Counterclockwise the circle is on the left.
    let growth = by * segment.bulge.signum();
    let point = |p: [f64; 2]| [0, 1].map(|i| p[i] + growth * (p[i] - centre[i]) / radius);
    (radius + growth > 0.0).then(|| Segment {
        from: point(segment.from),
        to: point(segment.to),
        bulge: segment.bulge,
    })
}

/// Returns the segment between two points of its line or circle; `None` if it would turn round.
fn between(segment: &Segment, from: [f64; 2], to: [f64; 2]) -> Option<Segment> {
    let Some((centre, _)) = segment.circle() else {
        let way = [0, 1].map(|i| segment.to[i] - segment.from[i]);
        let new = [0, 1].map(|i| to[i] - from[i]);
        return (way[0] * new[0] + way[1] * new[1] > 0.0).then(|| Segment::line(from, to));
    };
    // How far it is from its ends to the points, the way it turns.
    let way = |p: [f64; 2]| libm::atan2(p[1] - centre[1], p[0] - centre[0]);
    let turn = |a: [f64; 2], b: [f64; 2]| (way(b) - way(a) + PI).rem_euclid(2.0 * PI) - PI;
    let angle = segment.angle() + turn(segment.to, to) - turn(segment.from, from);
    (angle * segment.bulge > 0.0 && angle.abs() < 1.9 * PI).then(|| Segment {
        from,
        to,
        bulge: libm::tan(0.25 * angle),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::polygon::lines_around as polygon;

    fn area(outline: &[Segment]) -> f64 {
        outline.iter().map(Segment::area).sum()
    }

    #[test]
    fn each_side_of_a_rectangle_moves_by_its_own_distance() {
        let outline = polygon(&[[0.0, 0.0], [100.0, 0.0], [100.0, 40.0], [0.0, 40.0]]);
        let moved = moved_outwards(&outline, &[1.0, 2.0, 3.0, 4.0]).unwrap();
        assert_eq!(moved.len(), 4);
        assert!((area(&moved) - 106.0 * 44.0).abs() < 1e-9);
        let [x, y] = moved[0].from;
        assert!((x + 4.0).abs() < 1e-12 && (y + 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_circle_grows_by_its_distance() {
        let half = |x: f64| Segment {
            from: [x, 0.0],
            to: [-x, 0.0],
            bulge: 1.0,
        };
        let moved = moved_outwards(&[half(10.0), half(-10.0)], &[2.0, 2.0]).unwrap();
        assert!((area(&moved) - PI * 144.0).abs() < 1e-9);
    }

    #[test]
    fn inward_corners_are_trimmed_and_sharp_ones_cut_off() {
        // An L: its inner corner moves into the notch.
        let l = [
            [0.0, 0.0],
            [40.0, 0.0],
            [40.0, 20.0],
            [20.0, 20.0],
            [20.0, 40.0],
            [0.0, 40.0],
        ];
        let moved = moved_outwards(&polygon(&l), &[2.0; 6]).unwrap();
        assert!((area(&moved) - (44.0 * 44.0 - 20.0 * 20.0)).abs() < 1e-9);
        // A needle of 5 degrees: its mitre would reach 23 times the distance.
        let tip = 100.0 * libm::tan(5.0_f64.to_radians());
        let needle = polygon(&[[0.0, 0.0], [100.0, 0.0], [100.0, tip]]);
        let moved = moved_outwards(&needle, &[1.0; 3]).unwrap();
        assert_eq!(moved.len(), 4);
        let far = moved.iter().map(|s| distance(s.from, [0.0, 0.0]));
        assert!(moved.iter().all(|s| s.from[0] > -4.0) && far.count() == 4);
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        // A slot of 3 mm, whose sides would meet.
        let slot = [
            [0.0, 0.0],
            [40.0, 0.0],
            [40.0, 20.0],
            [21.5, 20.0],
            [21.5, 5.0],
            [18.5, 5.0],
            [18.5, 20.0],
            [0.0, 20.0],
        ];
        assert!(moved_outwards(&polygon(&slot), &[1.0; 8]).is_ok());
        assert!(moved_outwards(&polygon(&slot), &[2.0; 8]).is_err());
        // A V of 10 by 80: no side of it is as far from the other as twice 6.
        let v = |wide: f64| {
            let top = [[60.0 + wide, 100.0], [60.0, 20.0], [60.0 - wide, 100.0]];
            let points = [
                [0.0, 0.0],
                [120.0, 0.0],
                [120.0, 100.0],
                top[0],
                top[1],
                top[2],
                [0.0, 100.0],
            ];
            polygon(&points)
        };
        // Where it is filled, the outline is that of the whole rectangle.
        let filled = moved_outwards(&v(5.0), &[6.0; 7]).unwrap();
        assert!((area(&filled) - 132.0 * 112.0).abs() < 1e-9, "{filled:?}");
        let open = moved_outwards(&v(15.0), &[4.0; 7]).unwrap();
        // Its sides meet 4 / sin(a) above the bottom, with tan(a) = 15/80.
        let bottom = 20.0 + 4.0 * libm::hypot(15.0, 80.0) / 15.0;
        assert!(
            open.iter().any(|s| distance(s.from, [60.0, bottom]) < 1e-9),
            "{open:?}"
        );
    }

    /// A contour that runs clockwise: moved to the right, it shrinks.
    fn opening(points: &[[f64; 2]]) -> Vec<Segment> {
        let turned: Vec<[f64; 2]> = points.iter().rev().copied().collect();
        polygon(&turned)
    }

    #[test]
    fn openings_shrink_to_what_is_left_of_them_or_are_refused() {
        let half = |k: f64| vec![k; 4];
        // Corners of 18 degrees.
        let triangle = opening(&[[0.0, 0.0], [30.0, 0.0], [0.0, 10.0]]);
        let shrunk = moved_outwards(&triangle, &half(0.5)[..3]).unwrap();
        // Similar, by what is left of the radius of the inscribed circle.
        let radius = 0.5 * (40.0 - libm::hypot(30.0, 10.0));
        let share = (radius - 0.5) / radius;
        assert!((area(&shrunk) + 150.0 * share * share).abs() < 1e-9);
        assert!(moved_outwards(&triangle, &[radius; 3]).is_err());
        // A tip that is cut off by 0.1 mm: the short side goes.
        let tip = opening(&[[0.0, 0.0], [20.0, 0.0], [20.0, 0.1], [0.0, 10.0]]);
        let shrunk = moved_outwards(&tip, &half(0.2)).unwrap();
        assert_eq!(shrunk.len(), 3, "{shrunk:?}");
        // A rounded corner of a smaller radius than the distance becomes a sharp one.
        let quarter = libm::tan(PI / 8.0);
        let mut rounded = opening(&[
            [0.0, 0.0],
            [10.0, 0.0],
            [10.0, 9.7],
            [9.7, 10.0],
            [0.0, 10.0],
        ]);
        rounded[1].bulge = -quarter;
        let shrunk = moved_outwards(&rounded, &[0.5; 5]).unwrap();
        assert!((area(&shrunk) + 81.0).abs() < 1e-9, "{shrunk:?}");
        // Narrower than twice the distance: a lens of arcs, a D, a rectangle, two squares with a narrow neck.
        let bulge = -0.02;
        let arc = |from: f64, to: f64, bulge: f64| Segment {
            from: [from, 0.0],
            to: [to, 0.0],
            bulge,
        };
        let lens = [arc(0.0, 20.0, bulge), arc(20.0, 0.0, bulge)];
        let d = [arc(0.0, 20.0, bulge), arc(20.0, 0.0, 0.0)];
        let strip = opening(&[[0.0, 0.0], [20.0, 0.0], [20.0, 0.3], [0.0, 0.3]]);
        for narrow in [&lens[..], &d, &strip] {
            assert!(moved_outwards(narrow, &half(0.5)[..narrow.len()]).is_err());
            assert!(
                moved_outwards(narrow, &half(0.01)[..narrow.len()]).is_ok(),
                "{narrow:?}"
            );
        }
        let bell = opening(&[
            [0.0, 0.0],
            [10.0, 0.0],
            [10.0, 4.9],
            [20.0, 4.9],
            [20.0, 0.0],
            [30.0, 0.0],
            [30.0, 10.0],
            [20.0, 10.0],
            [20.0, 5.1],
            [10.0, 5.1],
            [10.0, 10.0],
            [0.0, 10.0],
        ]);
        for (by, fits) in [(0.05, true), (0.1, false), (0.2, false), (0.6, false)] {
            assert_eq!(moved_outwards(&bell, &[by; 12]).is_ok(), fits, "{by}");
        }
    }
}
