//! A closed outline moved outwards, each of its segments by a distance of its own, with mitred corners.

use crate::chords::{chords_of, self_crossing};
use crate::polygon::distance;
use crate::segment_crossings::carrier_crossings;
use std::f64::consts::PI;
use torse_geometry::pattern::Segment;

/// A mitre reaches no farther than this times the larger distance from its corner: beyond, the corner is cut off.
const MITRE: f64 = 4.0;
/// Lines whose directions differ by an angle of a smaller sine have no corner.
const PARALLEL: f64 = 1e-9;
/// Chords that stand for an arc where it is looked for crossings.
const ARC_POINTS: u32 = 8;
/// The most chords of an outline that is looked at.
const MAX_CHORDS: usize = 20_000;

/// Returns the outline, counterclockwise, moved outwards; `distances` are those of its segments, and neighbours whose
/// ends are apart by no more than `snap` are joined as they are.
///
/// # Errors
/// In words, where an inward curve is narrower than its distance, a segment would vanish, or the result crosses itself.
pub(super) fn moved_outwards(
    outline: &[Segment],
    distances: &[f64],
    snap: f64,
) -> Result<Vec<Segment>, String> {
    let mut moved = Vec::with_capacity(outline.len());
    for (segment, by) in outline.iter().zip(distances) {
        moved.push(shifted(segment, *by)?);
    }
    let count = moved.len();
    let mut bridges: Vec<Option<Segment>> = vec![None; count];
    for (k, bridge) in bridges.iter_mut().enumerate() {
        let next = (k + 1) % count;
        let (Some(corner), Some(a), Some(b)) = (
            outline.get(k).map(|segment| segment.to),
            moved.get(k).copied(),
            moved.get(next).copied(),
        ) else {
            continue;
        };
        if distance(a.to, b.from) <= snap {
            if let Some(b) = moved.get_mut(next) {
                b.from = a.to;
            }
            continue;
        }
        let widest = distances.iter().skip(k).take(1).chain(distances.get(next));
        let reach = MITRE * widest.fold(0.0_f64, |m, d| m.max(d.abs()));
        let met = carrier_crossings(&a, &b, PARALLEL, 0.0)
            .into_iter()
            .min_by(|p, q| distance(*p, corner).total_cmp(&distance(*q, corner)));
        match met.filter(|point| distance(*point, corner) <= reach) {
            Some(point) => {
                let a = ending_at(&a, point).ok_or_else(|| vanishes(corner))?;
                let b = starting_at(&b, point).ok_or_else(|| vanishes(corner))?;
                if let Some(place) = moved.get_mut(k) {
                    *place = a;
                }
                if let Some(place) = moved.get_mut(next) {
                    *place = b;
                }
            }
            None => *bridge = Some(Segment::line(a.to, b.from)),
        }
    }
    let closed: Vec<Segment> = moved
        .into_iter()
        .zip(bridges)
        .flat_map(|(segment, bridge)| [Some(segment), bridge])
        .flatten()
        .filter(|segment| segment.from != segment.to)
        .collect();
    match crossing(&closed) {
        None => Ok(closed),
        Some([x, y]) => Err(format!(
            "the outline would cross itself near ({x:.2}, {y:.2})"
        )),
    }
}

fn vanishes([x, y]: [f64; 2]) -> String {
    format!("a stretch of the outline near ({x:.2}, {y:.2}) is too short")
}

/// Returns a segment moved to its right.
fn shifted(segment: &Segment, by: f64) -> Result<Segment, String> {
    let Some((centre, radius)) = segment.circle() else {
        let way = [0, 1].map(|i| segment.to[i] - segment.from[i]);
        let length = libm::hypot(way[0], way[1]);
        if length == 0.0 {
            return Ok(*segment);
        }
        let right = [way[1] / length * by, -way[0] / length * by];
        let point = |p: [f64; 2]| [p[0] + right[0], p[1] + right[1]];
        return Ok(Segment::line(point(segment.from), point(segment.to)));
    };
    // Counterclockwise the circle is on the left.
    let growth = by * segment.bulge.signum();
    if radius + growth <= 0.0 {
        return Err(format!(
            "an inward curve of radius {radius:.3} mm is narrower than {by} mm"
        ));
    }
    let point = |p: [f64; 2]| [0, 1].map(|i| p[i] + growth * (p[i] - centre[i]) / radius);
    Ok(Segment {
        from: point(segment.from),
        to: point(segment.to),
        bulge: segment.bulge,
    })
}

/// Returns the segment up to a point of its line or circle; `None` if it would turn round.
fn ending_at(segment: &Segment, point: [f64; 2]) -> Option<Segment> {
    let Some((centre, _)) = segment.circle() else {
        let way = [0, 1].map(|i| segment.to[i] - segment.from[i]);
        let new = [0, 1].map(|i| point[i] - segment.from[i]);
        return (way[0] * new[0] + way[1] * new[1] > 0.0)
            .then(|| Segment::line(segment.from, point));
    };
    // How far it is from its end to the point, the way it turns.
    let way = |p: [f64; 2]| libm::atan2(p[1] - centre[1], p[0] - centre[0]);
    let more = (way(point) - way(segment.to) + PI).rem_euclid(2.0 * PI) - PI;
    let angle = segment.angle() + more;
    (angle * segment.bulge > 0.0 && angle.abs() < 1.9 * PI).then(|| Segment {
        to: point,
        bulge: libm::tan(0.25 * angle),
        ..*segment
    })
}

/// Returns the segment from a point of its line or circle on.
fn starting_at(segment: &Segment, point: [f64; 2]) -> Option<Segment> {
    ending_at(&segment.reversed(), point).map(|back| back.reversed())
}

/// Returns a place at which a closed outline crosses itself, as chords of its arcs show.
fn crossing(outline: &[Segment]) -> Option<[f64; 2]> {
    let steps = if outline.len() * 8 > MAX_CHORDS {
        1
    } else {
        ARC_POINTS
    };
    self_crossing(&chords_of(outline, steps))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn polygon(points: &[[f64; 2]]) -> Vec<Segment> {
        let next = points.iter().cycle().skip(1);
        let sides = points.iter().zip(next);
        sides.map(|(a, b)| Segment::line(*a, *b)).collect()
    }

    fn area(outline: &[Segment]) -> f64 {
        outline.iter().map(Segment::area).sum()
    }

    #[test]
    fn each_side_of_a_rectangle_moves_by_its_own_distance() {
        let outline = polygon(&[[0.0, 0.0], [100.0, 0.0], [100.0, 40.0], [0.0, 40.0]]);
        let moved = moved_outwards(&outline, &[1.0, 2.0, 3.0, 4.0], 1e-9).unwrap();
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
        let moved = moved_outwards(&[half(10.0), half(-10.0)], &[2.0, 2.0], 1e-9).unwrap();
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
        let moved = moved_outwards(&polygon(&l), &[2.0; 6], 1e-9).unwrap();
        assert!((area(&moved) - (44.0 * 44.0 - 20.0 * 20.0)).abs() < 1e-9);
        // A needle of 5 degrees: its mitre would reach 23 times the distance.
        let tip = 100.0 * libm::tan(5.0_f64.to_radians());
        let needle = polygon(&[[0.0, 0.0], [100.0, 0.0], [100.0, tip]]);
        let moved = moved_outwards(&needle, &[1.0; 3], 1e-9).unwrap();
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
        assert!(moved_outwards(&polygon(&slot), &[1.0; 8], 1e-9).is_ok());
        assert!(moved_outwards(&polygon(&slot), &[2.0; 8], 1e-9).is_err());
        let inward = Segment {
            from: [0.0, 0.0],
            to: [2.0, 0.0],
            bulge: -1.0,
        };
        assert!(
            shifted(&inward, 1.5)
                .unwrap_err()
                .contains("radius 1.000 mm")
        );
    }
}
