//! Necks: where a contour comes close to itself with material between.
//!
//! Next to every corner both of its sides are close to each other, and that is no neck. A neck is where the distance cannot be
//! made smaller by going a little way along the contour, at either of the two points.

use super::pairs::{Chord, for_pairs};
use crate::chords::nearest_on;
use std::collections::BTreeMap;

/// Directions are orthogonal where their cosine is no larger.
const ORTHOGONAL: f64 = 1e-6;
/// Distances that differ by no more than this share are equal.
const EQUAL: f64 = 1e-9;

/// The narrowest neck of a contour.
#[derive(Debug, Clone, Copy)]
pub(super) struct Neck {
    /// How wide it is, no less than in truth.
    pub width: f64,
    /// The middle of it.
    pub at: [f64; 2],
}

/// Returns for each contour its narrowest neck below `least` and above `within`, at which ends are joined; nothing where there is
/// too much to look at.
pub(super) fn necks(chords: &[Chord], least: f64, within: f64) -> Option<BTreeMap<usize, Neck>> {
    let mut rings: BTreeMap<usize, Vec<&Chord>> = BTreeMap::new();
    for chord in chords {
        rings.entry(chord.contour).or_default().push(chord);
    }
    let mut found: BTreeMap<usize, Neck> = BTreeMap::new();
    let all = for_pairs(chords, least, |a, b| {
        let Some(ring) = rings.get(&a.contour).filter(|_| a.contour == b.contour) else {
            return;
        };
        let (gap, [p, q]) = closest(a, b);
        let width = gap + a.off + b.off;
        let known = found.get(&a.contour).map_or(least, |neck| neck.width);
        if gap <= within || width >= known || !stays(ring, a, p, q) || !stays(ring, b, q, p) {
            return;
        }
        let at = [0, 1].map(|i| 0.5 * (p[i] + q[i]));
        if is_material(chords, at) {
            found.insert(a.contour, Neck { width, at });
        }
    });
    all.then_some(found)
}

/// Returns the distance of two chords, and the points of both where it is: the middle of these where there are several.
fn closest(a: &Chord, b: &Chord) -> (f64, [[f64; 2]; 2]) {
    let [first, second] = [a, b].map(|chord| [chord.from, chord.to]);
    let candidates = [
        [a.from, nearest_on(&second, a.from)],
        [a.to, nearest_on(&second, a.to)],
        [nearest_on(&first, b.from), b.from],
        [nearest_on(&first, b.to), b.to],
    ];
    let gap = |[p, q]: &[[f64; 2]; 2]| libm::hypot(q[0] - p[0], q[1] - p[1]);
    let least = candidates.iter().map(gap).fold(f64::INFINITY, f64::min);
    // The distance of points of two lines is convex: between two places at which it is least it is so too.
    let equal = candidates
        .iter()
        .filter(|pair| gap(pair) <= least * (1.0 + EQUAL));
    let (mut sum, mut count) = ([[0.0; 2]; 2], 0.0);
    for pair in equal {
        count += 1.0;
        for (total, point) in sum.iter_mut().flatten().zip(pair.iter().flatten()) {
            *total += point;
        }
    }
    (least, sum.map(|point| point.map(|c| c / count)))
}

/// Returns whether a point of a chord comes no nearer to another point where it goes on to the next chord of its contour.
fn stays(ring: &[&Chord], chord: &Chord, at: [f64; 2], other: [f64; 2]) -> bool {
    let count = ring.len();
    // The first chord with a length from here on, forwards or backwards.
    let next = |step: usize| {
        (1..count)
            .filter_map(|k| ring.get((chord.number + k * step) % count))
            .find(|next| next.from != next.to)
    };
    let nears = |end: Option<[f64; 2]>| {
        end.is_some_and(|end| {
            let (way, towards) = (
                [end[0] - at[0], end[1] - at[1]],
                [other[0] - at[0], other[1] - at[1]],
            );
            let inner = way[0] * towards[0] + way[1] * towards[1];
            let size = libm::hypot(way[0], way[1]) * libm::hypot(towards[0], towards[1]);
            inner > ORTHOGONAL * size
        })
    };
    let onwards = at == chord.to && nears(next(1).map(|next| next.to));
    let backwards = at == chord.from && nears(next(count.saturating_sub(1)).map(|next| next.from));
    !onwards && !backwards
}

/// Returns whether a point lies in an odd number of contours.
fn is_material(chords: &[Chord], [x, y]: [f64; 2]) -> bool {
    let crossed = chords.iter().filter(|chord| {
        let (a, b) = (chord.from, chord.to);
        (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    });
    crossed.count() % 2 == 1
}
