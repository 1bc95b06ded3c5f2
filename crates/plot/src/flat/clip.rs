//! Clips plane figures to the plotting area, so that no mark leaves it and coordinates stay moderate.

use crate::ink::scene::Rect;

/// The parts of a polyline inside `r` (Liang and Barsky 1984, segment by segment).
pub(crate) fn clip_polyline(points: &[[f64; 2]], r: Rect) -> Vec<Vec<[f64; 2]>> {
    let mut parts: Vec<Vec<[f64; 2]>> = Vec::new();
    let mut joined = false;
    for pair in points.windows(2) {
        let &[a, b] = pair else { continue };
        let Some((t0, t1)) = inside(a, b, r) else {
            joined = false;
            continue;
        };
        let at = |t: f64| match t {
            0.0 => a,
            1.0 => b,
            _ => onto(between(a, b, t), r),
        };
        match parts.last_mut() {
            Some(part) if joined && t0 == 0.0 => part.push(at(t1)),
            _ => parts.push(vec![at(t0), at(t1)]),
        }
        joined = t1 == 1.0;
    }
    parts
}

/// Parameters of the part of `a b` inside `r`, if any.
fn inside(a: [f64; 2], b: [f64; 2], r: Rect) -> Option<(f64, f64)> {
    let (mut t0, mut t1) = (0.0f64, 1.0f64);
    let bounds = [(r.x, r.right()), (r.y, r.bottom())];
    for ((a, b), (low, high)) in [(a[0], b[0]), (a[1], b[1])].into_iter().zip(bounds) {
        let d = b - a;
        for (toward, room) in [(-d, a - low), (d, high - a)] {
            if toward == 0.0 {
                if room < 0.0 {
                    return None;
                }
                continue;
            }
            let t = room / toward;
            if toward < 0.0 {
                t0 = t0.max(t);
            } else {
                t1 = t1.min(t);
            }
        }
    }
    (t0 <= t1).then_some((t0, t1))
}

fn between(a: [f64; 2], b: [f64; 2], t: f64) -> [f64; 2] {
    [0, 1].map(|k| a[k] + t * (b[k] - a[k]))
}

/// The nearest point of `r`: the cut of a line with an end very far away is off by the rounding of that end.
fn onto([x, y]: [f64; 2], r: Rect) -> [f64; 2] {
    [x.clamp(r.x, r.right()), y.clamp(r.y, r.bottom())]
}

/// A polygon cut to `r` (Sutherland and Hodgman 1974).
pub(crate) fn clip_polygon(points: &[[f64; 2]], r: Rect) -> Vec<[f64; 2]> {
    let sides = [
        (0, r.x, 1.0),
        (0, r.right(), -1.0),
        (1, r.y, 1.0),
        (1, r.bottom(), -1.0),
    ];
    sides
        .into_iter()
        .fold(points.to_vec(), |polygon, (axis, bound, sign)| {
            let room = |p: &[f64; 2]| (p[axis] - bound) * sign;
            let mut kept = Vec::with_capacity(polygon.len() + 1);
            for (a, b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
                let (ra, rb) = (room(a), room(b));
                if ra >= 0.0 {
                    kept.push(*a);
                }
                if (ra < 0.0) != (rb < 0.0) {
                    let t = ra / (ra - rb);
                    kept.push(between(*a, *b, t));
                }
            }
            kept
        })
        .into_iter()
        .map(|p| onto(p, r))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const UNIT: Rect = Rect {
        x: 0.0,
        y: 0.0,
        w: 1.0,
        h: 1.0,
    };

    #[test]
    fn a_line_that_leaves_and_returns_becomes_two() {
        let parts = clip_polyline(&[[0.5, 0.5], [1.5, 0.5], [1.5, 0.25], [0.5, 0.25]], UNIT);
        assert_eq!(
            parts,
            [vec![[0.5, 0.5], [1.0, 0.5]], vec![[1.0, 0.25], [0.5, 0.25]]]
        );
    }

    #[test]
    fn a_line_inside_is_kept_whole() {
        let line = [[0.1, 0.1], [0.9, 0.2], [0.3, 0.8]];
        assert_eq!(clip_polyline(&line, UNIT), [line.to_vec()]);
    }

    #[test]
    fn a_triangle_around_the_area_becomes_the_area() {
        let cut = clip_polygon(&[[-3.0, -1.0], [3.0, -1.0], [0.5, 9.0]], UNIT);
        let area: f64 = cut
            .iter()
            .zip(cut.iter().cycle().skip(1))
            .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
            .sum::<f64>()
            / 2.0;
        assert!((area - 1.0).abs() < 1e-12);
    }

    proptest! {
        #[test]
        fn whatever_goes_in_comes_out_inside(points in prop::collection::vec([-1e200..1e200f64, -3.0..3.0f64], 2..12)) {
            for p in clip_polyline(&points, UNIT).iter().flatten().chain(&clip_polygon(&points, UNIT)) {
                prop_assert!(p.iter().all(|c| (-1e-6..=1.0 + 1e-6).contains(c)), "{p:?}");
            }
        }
    }
}
