//! Contours as chords: where they cross one another, and how far they are apart.

use crate::polygon::distance;
use torse_geometry::pattern::Segment;

/// A line from one point to another.
pub type Chord = [[f64; 2]; 2];

/// The most chords of an arc.
const MAX_PARTS: f64 = 256.0;

/// Returns the chords of a contour, so many for an arc that they are no farther than `within` from it.
pub fn chords_within(contour: &[Segment], within: f64) -> Vec<Chord> {
    let parts = |segment: &Segment| {
        // The sagitta falls with the square of the number of parts, of an arc of at most half a circle.
        let parts = (segment.sagitta() / within).sqrt().ceil();
        parts.clamp(1.0, MAX_PARTS)
    };
    chords(contour, parts)
}

fn chords(contour: &[Segment], parts: impl Fn(&Segment) -> f64) -> Vec<Chord> {
    let mut all = Vec::with_capacity(contour.len());
    for segment in contour {
        let count = if segment.is_line() {
            1.0
        } else {
            parts(segment)
        };
        let (mut k, mut from) = (1.0, segment.from);
        while k <= count {
            let to = segment.point(k / count);
            all.push([from, to]);
            (from, k) = (to, k + 1.0);
        }
    }
    all
}

/// Returns a place at which chords of one contour cross those of another.
pub fn mutual_crossing(one: &[Chord], other: &[Chord]) -> Option<[f64; 2]> {
    let all = one.iter().map(|chord| (*chord, false));
    let all = all.chain(other.iter().map(|chord| (*chord, true)));
    first_crossing(all.collect(), |a, b| a != b)
}

/// Returns the start of the first chord, from left to right, that crosses another of a pair that counts.
fn first_crossing<T: Copy>(
    mut chords: Vec<(Chord, T)>,
    counts: impl Fn(T, T) -> bool,
) -> Option<[f64; 2]> {
    // Only chords that lie above one another are compared.
    let low = |chord: &Chord| chord[0][0].min(chord[1][0]);
    let high = |chord: &Chord| chord[0][0].max(chord[1][0]);
    chords.sort_by(|(a, _), (b, _)| low(a).total_cmp(&low(b)));
    for (k, (one, first)) in chords.iter().enumerate() {
        let behind = chords.iter().skip(k + 1);
        let mut near = behind.take_while(|(other, _)| low(other) <= high(one));
        if near.any(|(other, second)| counts(*first, *second) && crosses(one, other)) {
            return Some(one[0]);
        }
    }
    None
}

/// Returns whether two chords cross inside of both.
fn crosses(one: &Chord, other: &Chord) -> bool {
    let side = |line: &Chord, p: [f64; 2]| {
        (line[1][0] - line[0][0]) * (p[1] - line[0][1])
            - (line[1][1] - line[0][1]) * (p[0] - line[0][0])
    };
    let length = |line: &Chord| distance(line[0], line[1]);
    // What touches within rounding does not cross.
    let small = 1e-9 * length(one) * length(other).max(length(one));
    let parted = |line: &Chord, of: &Chord| {
        let (p, q) = (side(line, of[0]), side(line, of[1]));
        p.abs() > small && q.abs() > small && (p > 0.0) != (q > 0.0)
    };
    parted(one, other) && parted(other, one)
}

/// Returns the least distance of two contours that do not cross, and the point of the first where it is.
pub fn nearest_points(one: &[Chord], other: &[Chord]) -> (f64, [f64; 2]) {
    let mut best = (f64::INFINITY, [f64::NAN; 2]);
    for a in one {
        for b in other {
            for point in a {
                let off = Segment::line(b[0], b[1]).distance(*point);
                if off < best.0 {
                    best = (off, *point);
                }
            }
            for point in b {
                let off = Segment::line(a[0], a[1]).distance(*point);
                if off < best.0 {
                    best = (off, a[0]);
                }
            }
        }
    }
    best
}
