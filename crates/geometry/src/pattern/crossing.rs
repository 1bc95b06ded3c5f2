//! Whether an outline meets itself.
//!
//! A flat pattern maps a disc into the plane without folds (the edge of regression is outside). By the
//! theorem on immersed discs it overlaps itself nowhere if its border is a simple closed curve. Two
//! segments are compared by their bounding boxes and halved while these meet and an arc deviates
//! from its chord; what is left are chords, and whether two chords meet is decided exactly: by the sign of
//! determinants in f64 where the rounding error leaves no doubt (Shewchuk 1997), else in rationals.

use super::segment::Segment;
use crate::scalars::exact;
use std::cmp::Ordering;

/// Halvings of a pair of segments.
const MAX_DEPTH: u32 = 48;

/// The first two segments of a closed outline found to meet away from their common ends, and where. Arcs are
/// followed to within `tolerance`.
pub(super) fn crossing(outline: &[Segment], tolerance: f64) -> Option<([usize; 2], [f64; 2])> {
    let boxes: Vec<Box> = outline.iter().map(Box::around).collect();
    let mut order: Vec<usize> = (0..outline.len()).collect();
    order.sort_by(|a, b| boxes[*a].low[0].total_cmp(&boxes[*b].low[0]));
    let mut found: Option<([usize; 2], [f64; 2])> = None;
    for (rank, &i) in order.iter().enumerate() {
        for &j in order.iter().skip(rank + 1) {
            if boxes[j].low[0] > boxes[i].high[0] {
                break;
            }
            let pair = [i.min(j), i.max(j)];
            // The answer does not depend on the order of the sweep.
            if found.is_some_and(|(known, _)| known <= pair) || !boxes[i].meets(&boxes[j]) {
                continue;
            }
            let [a, b] = pair.map(|k| outline[k]);
            let joined = [a.to == b.from, b.to == a.from];
            let place = if joined.contains(&true) {
                neighbours(&a, &b, joined)
            } else {
                meet(&a, &b, tolerance, 0)
            };
            if let Some(at) = place {
                found = Some((pair, at));
            }
        }
    }
    found
}

/// Consecutive segments: they share an end, and must not run back on each other. Only lines can do so exactly.
fn neighbours(a: &Segment, b: &Segment, joined: [bool; 2]) -> Option<[f64; 2]> {
    if !(a.is_line() && b.is_line()) || joined == [true, true] {
        return None;
    }
    let (a, b) = if joined[0] { (a, b) } else { (b, a) };
    let ahead = (a.to[0] - a.from[0]) * (b.to[0] - b.from[0])
        + (a.to[1] - a.from[1]) * (b.to[1] - b.from[1]);
    let straight = side(a.from, a.to, b.to) == Ordering::Equal;
    (straight && ahead < 0.0).then_some(a.to)
}

fn meet(a: &Segment, b: &Segment, tolerance: f64, depth: u32) -> Option<[f64; 2]> {
    if !Box::around(a).meets(&Box::around(b)) {
        return None;
    }
    let bent = [a, b].map(Segment::sagitta);
    if depth >= MAX_DEPTH || bent.iter().all(|s| *s <= tolerance) {
        return chords_meet(a, b).then_some(a.from);
    }
    let tested = |a: &Segment, b: &Segment| meet(a, b, tolerance, depth + 1);
    if bent[0] >= bent[1] {
        a.halves().iter().find_map(|half| tested(half, b))
    } else {
        b.halves().iter().find_map(|half| tested(a, half))
    }
}

/// Whether two closed line segments have a point in common, exactly.
fn chords_meet(a: &Segment, b: &Segment) -> bool {
    let sides = [
        side(a.from, a.to, b.from),
        side(a.from, a.to, b.to),
        side(b.from, b.to, a.from),
        side(b.from, b.to, a.to),
    ];
    if sides.iter().all(|s| *s == Ordering::Equal) {
        // On one line: they meet where their boxes do.
        return Box::chord(a).meets(&Box::chord(b));
    }
    let apart = |s: Ordering, t: Ordering| s == t && s != Ordering::Equal;
    !apart(sides[0], sides[1]) && !apart(sides[2], sides[3])
}

/// On which side of the line from `a` to `b` the point `c` is: `Greater` to the left, `Equal` on it, exactly.
fn side(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Ordering {
    let (left, right) = ((a[0] - c[0]) * (b[1] - c[1]), (a[1] - c[1]) * (b[0] - c[0]));
    let (value, size) = (left - right, left.abs() + right.abs());
    // Shewchuk's bound for this determinant is (3 + 16 eps) eps with eps = 2^-53.
    if size.is_normal() && value.abs() > 4.0e-16 * size {
        return value.total_cmp(&0.0);
    }
    let minus = |p: f64, q: f64| exact(p) - exact(q);
    let left = minus(a[0], c[0]) * minus(b[1], c[1]);
    let right = minus(a[1], c[1]) * minus(b[0], c[0]);
    left.cmp(&right)
}

struct Box {
    low: [f64; 2],
    high: [f64; 2],
}

impl Box {
    /// Around the chord and the arc: a sagitta to all sides.
    fn around(segment: &Segment) -> Self {
        let wide = if segment.is_line() {
            0.0
        } else {
            segment.sagitta() * (1.0 + 1e-9)
        };
        let Self { low, high } = Self::chord(segment);
        // A bulge above one reaches beyond its chord on all sides; the sagitta is then above half the chord.
        Self {
            low: low.map(|c| c - wide),
            high: high.map(|c| c + wide),
        }
    }

    fn chord(segment: &Segment) -> Self {
        let (a, b) = (segment.from, segment.to);
        Self {
            low: [a[0].min(b[0]), a[1].min(b[1])],
            high: [a[0].max(b[0]), a[1].max(b[1])],
        }
    }

    fn meets(&self, other: &Self) -> bool {
        (0..2).all(|k| self.low[k] <= other.high[k] && other.low[k] <= self.high[k])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn polygon(points: &[[f64; 2]]) -> Vec<Segment> {
        let next = points.iter().cycle().skip(1);
        points
            .iter()
            .zip(next)
            .map(|(a, b)| Segment::line(*a, *b))
            .collect()
    }

    #[test]
    fn a_bow_tie_crosses_and_a_square_does_not() {
        let square = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
        assert_eq!(crossing(&polygon(&square), 1e-9), None);
        let tie = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        assert_eq!(crossing(&polygon(&tie), 1e-9).unwrap().0, [0, 2]);
    }

    #[test]
    fn a_spike_of_width_zero_is_a_crossing_and_one_unit_in_the_last_place_is_not() {
        let spike = |y: f64| {
            [
                [0.0, 0.0],
                [4.0, 0.0],
                [4.0, 1.0],
                [2.0, 1.0],
                [3.0, y],
                [0.0, 1.0],
            ]
        };
        assert!(crossing(&polygon(&spike(1.0)), 1e-9).is_some());
        // On the line from (0, 1) to (2, 1), exactly and not quite.
        let touch = |y: f64| {
            [
                [0.0, 0.0],
                [4.0, 0.0],
                [4.0, 3.0],
                [1.0, y],
                [2.0, 1.0],
                [0.0, 1.0],
            ]
        };
        assert!(crossing(&polygon(&touch(1.0)), 1e-9).is_some());
        assert!(crossing(&polygon(&touch(1.0_f64.next_up())), 1e-9).is_none());
    }

    #[test]
    fn arcs_that_pass_each_other_closely_do_not_cross_and_arcs_that_touch_do() {
        // Two half rings: the inner border of one against the outer of the other.
        let ring = |inner: f64, outer: f64, gap: f64| {
            vec![
                Segment {
                    from: [outer, 0.0],
                    to: [-outer, 0.0],
                    bulge: 1.0,
                },
                Segment::line([-outer, 0.0], [-inner, gap]),
                Segment {
                    from: [-inner, gap],
                    to: [inner, gap],
                    bulge: -1.0,
                },
                Segment::line([inner, gap], [outer, 0.0]),
            ]
        };
        assert!(crossing(&ring(1.0, 1.001, 0.0), 1e-6).is_none());
        assert!(crossing(&ring(1.0, 1.001, 0.0011), 1e-6).is_some());
    }

    proptest! {
        #[test]
        fn the_sign_is_that_of_the_exact_determinant(
            a in prop::array::uniform2(-1.0..1.0_f64), b in prop::array::uniform2(-1.0..1.0_f64),
            t in -2.0..2.0_f64, lift in prop_oneof![Just(0.0), -1e-16..1e-16_f64, -1.0..1.0_f64],
        ) {
            let c = [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]) + lift];
            let det = (exact(b[0]) - exact(a[0])) * (exact(c[1]) - exact(a[1]))
                - (exact(b[1]) - exact(a[1])) * (exact(c[0]) - exact(a[0]));
            let zero = exact(0.0);
            prop_assert_eq!(side(a, b, c), det.cmp(&zero));
        }
    }
}
