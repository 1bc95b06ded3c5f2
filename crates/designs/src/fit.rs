//! A closed polygon as lines and arcs within a proved distance.

use std::f64::consts::PI;
use torse_geometry::pattern::Segment;

/// Returns lines and arcs for a closed polygon that are no farther from it than `within`, and a bound for how far they are;
/// what is a corner, by its index, stays one.
///
/// From each corner on a segment goes as far as one line or one arc of at most half a circle can: the search doubles its
/// steps and then halves them. Every candidate is compared with each side of the polygon, not with samples.
pub fn fitted(polygon: &[[f64; 2]], corners: &[usize], within: f64) -> (Vec<Segment>, f64) {
    let count = polygon.len();
    let first = corners.first().copied().unwrap_or(0);
    let turned = polygon.iter().cycle().skip(first).take(count + 1);
    let turned: Vec<[f64; 2]> = turned.copied().collect();
    let mut ends: Vec<usize> = corners
        .iter()
        .map(|corner| corner - first)
        .filter(|at| *at > 0)
        .collect();
    ends.push(count);
    let (mut segments, mut off) = (Vec::new(), 0.0_f64);
    let mut at = 0;
    for end in ends {
        let (more, distance) = fitted_run(turned.get(at..=end).unwrap_or_default(), within);
        segments.extend(more);
        off = off.max(distance);
        at = end;
    }
    (segments, off)
}

/// As [`fitted`], of a polygon from its first corner to its last, without corners between.
pub fn fitted_run(polygon: &[[f64; 2]], within: f64) -> (Vec<Segment>, f64) {
    let (mut segments, mut off) = (Vec::new(), 0.0_f64);
    let end = polygon.len().saturating_sub(1);
    let mut at = 0;
    while at < end {
        let (to, segment, distance) = longest(polygon, at, end, within);
        segments.push(segment);
        off = off.max(distance);
        at = to;
    }
    (segments, off)
}

/// Returns how far one segment goes from a corner on, the segment, and its distance.
fn longest(points: &[[f64; 2]], from: usize, end: usize, within: f64) -> (usize, Segment, f64) {
    let candidate = |to: usize| joined(points.get(from..=to)?, within);
    let at = |k: usize| points.get(k).copied().unwrap_or_default();
    let mut best = (from + 1, Segment::line(at(from), at(from + 1)), 0.0);
    let (mut step, mut bad) = (2, end + 1);
    while from + step <= end {
        match candidate(from + step) {
            Some((segment, off)) => best = (from + step, segment, off),
            None => {
                bad = from + step;
                break;
            }
        }
        step *= 2;
    }
    while best.0 + 1 < bad {
        let middle = best.0 + (bad - best.0) / 2;
        match candidate(middle) {
            Some((segment, off)) => best = (middle, segment, off),
            None => bad = middle,
        }
    }
    best
}

/// Returns one segment for a run of sides, and a bound of its distance from them.
fn joined(run: &[[f64; 2]], within: f64) -> Option<(Segment, f64)> {
    let (from, to) = (*run.first()?, *run.last()?);
    let line = Segment::line(from, to);
    if let Some(off) = off_line(run, &line).filter(|off| *off <= within) {
        return Some((line, off));
    }
    let middle = *run.get(run.len() / 2)?;
    let [a, b] = [sub(middle, from), sub(to, middle)];
    // Chords of a circle turn by half of what the arcs over them sweep.
    let turn = libm::atan2(cross(a, b), a[0] * b[0] + a[1] * b[1]);
    if turn.abs() > 0.5 * PI {
        return None;
    }
    let bulge = libm::tan(0.5 * turn);
    let arc = Segment { from, to, bulge };
    let off = off_arc(run, &arc).filter(|off| *off <= within)?;
    Some((arc, off))
}

fn sub(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Returns how far sides that go forward along a line are from it.
fn off_line(run: &[[f64; 2]], line: &Segment) -> Option<f64> {
    let way = sub(line.to, line.from);
    let length = libm::hypot(way[0], way[1]);
    let (mut before, mut off) = (0.0, 0.0_f64);
    for point in run.iter().skip(1) {
        let arm = sub(*point, line.from);
        let along = (arm[0] * way[0] + arm[1] * way[1]) / length;
        if along.is_nan() || along <= before {
            return None;
        }
        before = along;
        off = off.max((cross(way, arm) / length).abs());
    }
    Some(off)
}

/// Returns how far sides that go forward around a circle are from it: at their ends, or where they come nearest to its
/// centre. Each ray from the centre meets both once, so this bounds both ways.
fn off_arc(run: &[[f64; 2]], arc: &Segment) -> Option<f64> {
    let (centre, radius) = arc.circle()?;
    let mut off = 0.0_f64;
    for side in run.windows(2) {
        let [a, b] = [sub(side[0], centre), sub(side[1], centre)];
        if cross(a, b) * arc.bulge <= 0.0 {
            return None;
        }
        let way = sub(b, a);
        let foot = -(a[0] * way[0] + a[1] * way[1]) / (way[0] * way[0] + way[1] * way[1]);
        let mut miss = |p: [f64; 2]| off = off.max((libm::hypot(p[0], p[1]) - radius).abs());
        miss(a);
        miss(b);
        if (0.0..=1.0).contains(&foot) {
            miss([a[0] + foot * way[0], a[1] + foot * way[1]]);
        }
    }
    Some(off)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn regular(count: u32, radius: f64) -> Vec<[f64; 2]> {
        (0..count)
            .map(|k| {
                let (s, c) = libm::sincos(2.0 * PI * f64::from(k) / f64::from(count));
                [radius * c, radius * s]
            })
            .collect()
    }

    #[test]
    fn a_fine_circle_becomes_arcs_and_a_square_stays_lines() {
        let sagitta = 20.0 * (1.0 - libm::cos(PI / 360.0));
        let (segments, off) = fitted(&regular(360, 20.0), &[], 1e-3);
        assert!(segments.len() <= 3, "{}", segments.len());
        assert!((off - sagitta).abs() < 1e-9, "{off}");
        let area: f64 = segments.iter().map(Segment::area).sum();
        assert!((area - 400.0 * PI).abs() < 2.0 * PI * 20.0 * sagitta);
        let square = [[0.0, 0.0], [8.0, 0.0], [8.0, 8.0], [0.0, 8.0]];
        let (segments, off) = fitted(&square, &[0, 1, 2, 3], 1e-3);
        assert_eq!((segments.len(), off), (4, 0.0));
    }

    #[test]
    fn what_is_farther_than_the_distance_is_not_joined() {
        // A wave: no arc spans its inflections.
        let wave: Vec<[f64; 2]> = (0..=400)
            .map(|k| [0.25 * f64::from(k), 3.0 * libm::sin(0.05 * f64::from(k))])
            .collect();
        let polygon: Vec<[f64; 2]> = wave
            .iter()
            .copied()
            .chain([[100.0, 40.0], [0.0, 40.0]])
            .collect();
        let (segments, off) = fitted(&polygon, &[0, 400, 401, 402], 0.01);
        assert!(off <= 0.01);
        for point in &polygon {
            let near = segments.iter().map(|s| s.distance(*point));
            assert!(near.fold(f64::INFINITY, f64::min) <= 0.01 + 1e-9);
        }
        assert!(segments.len() < 60);
    }
}
