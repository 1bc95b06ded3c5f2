//! A smooth flat rail as lines and circular arcs within a tolerance.
//!
//! On an interval the rail is replaced by a line, by one arc, or by two arcs with a common tangent (a *biarc*,
//! Bolton 1975) that keep its ends and its tangents there, whichever comes first within the
//! tolerance; otherwise the interval is halved. The distance is not sampled: in the frame of the chord the
//! rail is a pair of polynomials `u, v`, a circle through both ends is
//! `F(u, v) = (kappa (u^2 + v^2 - l u) - 2 cos(phi) v)/2 = 0` with a gradient of length one on it, and the
//! sum of the absolute Chebyshev coefficients of `F(u, v)` bounds it on the whole interval. A rail that proceeds
//! along the chord cannot leave the arc at its ends, so this is the distance of both from each other, up to the
//! factor `1/cos(phi)` there, with `phi` half the swept angle.

use super::development::Development;
use super::error::{PatternError, PatternResult};
use super::segment::Segment;
use crate::chebyshev::{Interpolant, NODES, Row};

/// Halvings of the parameter interval.
const MAX_DEPTH: u32 = 40;
/// The most segments of one rail.
const MAX_SEGMENTS: usize = 1 << 16;
/// Where candidates are looked at first, as shares of the interval.
const LOOKS: [f64; 4] = [0.15, 0.4, 0.65, 0.85];
/// The widest arc sweeps twice this angle, in radians.
const WIDEST: f64 = 0.8;

/// Lines and arcs in a chain, with the largest distance from the rail (not counting errors of the rail itself).
pub(super) struct Fitted {
    pub segments: Vec<Segment>,
    pub distance: f64,
}

impl Fitted {
    /// A rail that is a point: it has no segments.
    pub(super) fn point() -> Self {
        Self {
            segments: Vec::new(),
            distance: 0.0,
        }
    }
}

/// Fits one rail within `tolerance`.
pub(super) fn fit(development: &Development, side: usize, tolerance: f64) -> PatternResult<Fitted> {
    let rail = Rail { development, side };
    let mut open = vec![(rail.end(0.0), rail.end(1.0), 0_u32)];
    let mut fitted = Fitted::point();
    while let Some((from, to, depth)) = open.pop() {
        if let Some((segments, distance)) = rail.try_segments(&from, &to, tolerance) {
            let drawn = segments.into_iter().filter(|s| s.from != s.to);
            fitted.segments.extend(drawn);
            fitted.distance = fitted.distance.max(distance);
        } else if depth >= MAX_DEPTH || fitted.segments.len() + open.len() >= MAX_SEGMENTS {
            return Err(PatternError::NotReached {
                reached: tolerance.next_up(),
                demanded: tolerance,
                x: from.x,
            });
        } else {
            let middle = rail.end(0.5 * (from.x + to.x));
            open.push((middle, to, depth + 1));
            open.push((from, middle, depth + 1));
        }
    }
    Ok(fitted)
}

/// A point of the rail with its tangent.
#[derive(Clone, Copy)]
struct End {
    x: f64,
    point: [f64; 2],
    tangent: [f64; 2],
}

struct Rail<'a> {
    development: &'a Development,
    side: usize,
}

impl Rail<'_> {
    fn end(&self, x: f64) -> End {
        let [point, tangent] = self.development.rail(self.side, x);
        End { x, point, tangent }
    }

    fn try_segments(&self, from: &End, to: &End, tolerance: f64) -> Option<(Vec<Segment>, f64)> {
        let line = Segment::line(from.point, to.point);
        let looks = LOOKS.map(|share| self.end(from.x + share * (to.x - from.x)).point);
        let frame = Chord::new(&line);
        // A first look, which spares most of the work of a bound that fails.
        let near = |s: &Segment| {
            let off = |p: &[f64; 2]| frame.off(s, *p).abs();
            looks.iter().all(|p| off(p) <= tolerance)
        };
        let bound = |s: &Segment, from: f64, to: f64| self.bound(s, from, to, tolerance);
        if near(&line)
            && let Some(distance) = bound(&line, from.x, to.x)
        {
            return Some((vec![line], distance));
        }
        let [alpha, beta] = leans(from, to)?;
        // The one arc whose tangents differ from both by the same angle.
        let bulge = libm::tan(0.25 * (beta - alpha));
        let arc = Segment { bulge, ..line };
        if near(&arc)
            && let Some(distance) = bound(&arc, from.x, to.x)
        {
            return Some((vec![arc], distance));
        }
        let pair = biarc(from.point, to.point, [alpha, beta]);
        let halves = pair.each_ref().map(Chord::new);
        let close = |p: &[f64; 2]| {
            let side = usize::from(frame.place(*p)[0] > 0.5 * frame.length);
            halves[side].off(&pair[side], *p).abs() <= tolerance
        };
        if !looks.iter().all(close) {
            return None;
        }
        let joint = self.passing(pair[0].to, from.x, to.x);
        let first = bound(&pair[0], from.x, joint)?;
        let second = bound(&pair[1], joint, to.x)?;
        Some((pair.to_vec(), first.max(second)))
    }

    /// The parameter between `from` and `to` where the rail passes `point`, nearly: secants, then halving where they
    /// leave the interval. Where exactly the rail is cut does not matter, as both parts are bounded.
    fn passing(&self, point: [f64; 2], from: f64, to: f64) -> f64 {
        let (mut low, mut high) = (from, to);
        let mut x = 0.5 * (from + to);
        for _ in 0..6 {
            let end = self.end(x);
            let [u, v] = end.tangent;
            let ahead = (point[0] - end.point[0]) * u + (point[1] - end.point[1]) * v;
            if ahead > 0.0 {
                low = x;
            } else {
                high = x;
            }
            let next = x + ahead / (u * u + v * v);
            x = if next > low && next < high {
                next
            } else {
                0.5 * (low + high)
            };
        }
        x
    }

    /// A bound for the distance of the rail on `[from, to]` and the segment; `None` above the tolerance.
    fn bound(&self, segment: &Segment, from: f64, to: f64, tolerance: f64) -> Option<f64> {
        let chord = segment.chord_length();
        let phi = 2.0 * libm::atan(segment.bulge);
        if phi.abs() > WIDEST || !(chord > 0.0 || segment.is_line()) {
            return None;
        }
        let frame = Chord::new(segment);
        let mut largest = 0.0_f64;
        let mut before = f64::NEG_INFINITY;
        let panels = self.development.panels();
        let start = panels.partition_point(|p| p.range()[1] <= from);
        for panel in panels.iter().skip(start) {
            if panel.range()[0] >= to {
                break;
            }
            let [x, y] = panel.rail_between(self.side, from, to);
            let both = frame.coefficients(&x, &y);
            let [u, v] = both.each_ref().map(|list| trimmed(list));
            if chord > 0.0 {
                // Forward along the chord, up to the tolerance.
                for place in values(u) {
                    if place < before - tolerance {
                        return None;
                    }
                    before = before.max(place);
                }
                largest = largest.max(circle_bound(segment, u, v, chord));
            } else {
                // The segment is a point.
                largest = largest.max(libm::hypot(absolute(u), absolute(v)));
            }
            if largest > tolerance {
                return None;
            }
        }
        let distance = largest / libm::cos(phi);
        (distance <= tolerance).then_some(distance)
    }
}

/// The angles of the tangents at both ends from the chord, in (-pi, pi].
fn leans(from: &End, to: &End) -> Option<[f64; 2]> {
    let chord = [to.point[0] - from.point[0], to.point[1] - from.point[1]];
    let lean = |t: &[f64; 2]| {
        libm::atan2(
            chord[0] * t[1] - chord[1] * t[0],
            chord[0] * t[0] + chord[1] * t[1],
        )
    };
    let found = [lean(&from.tangent), lean(&to.tangent)];
    let steep = found.iter().any(|a| !a.is_finite() || a.abs() > 1.2);
    (!steep).then_some(found)
}

/// Two arcs of equal chords from `a` to `b` that lean by `alpha` and `beta` from the chord at the ends: their
/// common tangent at the joint leans by `-(alpha + beta)/2`, so their chords lean by `+-(alpha - beta)/4`.
fn biarc(a: [f64; 2], b: [f64; 2], [alpha, beta]: [f64; 2]) -> [Segment; 2] {
    let chord = [b[0] - a[0], b[1] - a[1]];
    let gamma = -0.5 * (alpha + beta);
    let above = 0.5 * libm::tan(0.25 * (alpha - beta));
    let joint = [
        a[0] + 0.5 * chord[0] - above * chord[1],
        a[1] + 0.5 * chord[1] + above * chord[0],
    ];
    let arc = |from, to, turn: f64| Segment {
        from,
        to,
        bulge: libm::tan(0.25 * turn),
    };
    [arc(a, joint, gamma - alpha), arc(joint, b, beta - gamma)]
}

/// The frame of the chord of a segment; of a point, the first axis.
struct Chord {
    origin: [f64; 2],
    axis: [f64; 2],
    length: f64,
}

impl Chord {
    fn new(segment: &Segment) -> Self {
        let length = segment.chord_length();
        let axis = if length > 0.0 {
            [0, 1].map(|i| (segment.to[i] - segment.from[i]) / length)
        } else {
            [1.0, 0.0]
        };
        Self {
            origin: segment.from,
            axis,
            length,
        }
    }

    /// A point along and across the chord.
    fn place(&self, point: [f64; 2]) -> [f64; 2] {
        let [x, y] = [point[0] - self.origin[0], point[1] - self.origin[1]];
        let [c, s] = self.axis;
        [c * x + s * y, c * y - s * x]
    }

    /// The distance of a point from the circle of a segment with this chord, to first order.
    fn off(&self, segment: &Segment, point: [f64; 2]) -> f64 {
        let [u, v] = self.place(point);
        if self.length > 0.0 {
            segment.off_circle(u, v, self.length)
        } else {
            libm::hypot(u, v)
        }
    }

    /// The coefficients of a curve along and across the chord.
    fn coefficients(&self, x: &Interpolant, y: &Interpolant) -> [Row; 2] {
        let ([c, s], mut origin) = (self.axis, self.origin);
        let (mut along, mut across) = ([0.0; NODES], [0.0; NODES]);
        let slots = along.iter_mut().zip(&mut across);
        for ((u, v), (x, y)) in slots.zip(x.coefficients().iter().zip(y.coefficients())) {
            let [x, y] = [x - origin[0], y - origin[1]];
            (*u, *v) = (c * x + s * y, c * y - s * x);
            // Only the constants are moved.
            origin = [0.0; 2];
        }
        [along, across]
    }
}

/// Without the last coefficients while they are far below the rounding of the largest.
fn trimmed(list: &[f64]) -> &[f64] {
    let largest = list.iter().fold(0.0_f64, |m, c| m.max(c.abs()));
    let last = list.iter().rposition(|c| c.abs() > 1e-18 * largest);
    list.get(..=last.unwrap_or(0)).unwrap_or(list)
}

fn absolute(list: &[f64]) -> f64 {
    list.iter().map(|c| c.abs()).sum()
}

/// A bound for the distance from the circle (or line), from the coefficients of `F`.
fn circle_bound(segment: &Segment, u: &[f64], v: &[f64], chord: f64) -> f64 {
    let b = segment.bulge;
    let square = 1.0 + b * b;
    let (curved, straight) = (2.0 * b / (chord * square), (1.0 - b * b) / square);
    if b == 0.0 {
        return absolute(v);
    }
    let mut sum = [0.0; 2 * NODES];
    for list in [u, v] {
        for (i, a) in list.iter().enumerate() {
            // T_i T_j = (T_(i+j) + T_|i-j|)/2, both orders at once.
            sum[0] += 0.5 * a * a;
            sum[2 * i] += 0.5 * a * a;
            for (j, c) in list.iter().enumerate().skip(i + 1) {
                sum[i + j] += a * c;
                sum[j - i] += a * c;
            }
        }
    }
    for (slot, c) in sum.iter_mut().zip(u) {
        *slot -= chord * c;
    }
    for slot in &mut sum {
        *slot *= curved;
    }
    for (slot, c) in sum.iter_mut().zip(v) {
        *slot -= straight * c;
    }
    let f = absolute(&sum);
    // |d - r| = |F| 2r/(d + r), where d is not much less than r.
    let radius = segment.radius();
    if f < 0.5 * radius {
        f / (1.0 - f / radius)
    } else {
        f64::INFINITY
    }
}

/// The values at the nodes of a polynomial given by its coefficients.
fn values(coefficients: &[f64]) -> impl Iterator<Item = f64> {
    crate::chebyshev::node_rows()
        .iter()
        .map(move |row| row.iter().zip(coefficients).map(|(t, c)| t * c).sum())
}
