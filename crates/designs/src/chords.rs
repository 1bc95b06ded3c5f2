//! Contours as chords: where they cross one another, and how far they are apart.

use crate::polygon::distance;
use torse_geometry::pattern::Segment;

/// A line from one point to another.
pub type Chord = [[f64; 2]; 2];

/// The most chords of an arc.
const MAX_PARTS: f64 = 256.0;

/// Returns the chords of a contour, so many for an arc that they are no farther than `within` from it.
pub fn chords_within(contour: &[Segment], within: f64) -> Vec<Chord> {
    let mut all = Vec::with_capacity(contour.len());
    for segment in contour {
        let count = match segment.is_line() {
            true => 1.0,
            // The sagitta falls with the square of the number of parts, of an arc of at most half a circle.
            false => (segment.sagitta() / within)
                .sqrt()
                .ceil()
                .clamp(1.0, MAX_PARTS),
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

/// Returns a point at which a chord of one contour crosses a chord of the other, inside of both: that of the chords which
/// begin leftmost.
pub fn mutual_crossing(one: &[Chord], other: &[Chord]) -> Option<[f64; 2]> {
    // Only chords that lie above one another are compared.
    let low = |chord: &Chord| chord[0][0].min(chord[1][0]);
    let high = |chord: &Chord| chord[0][0].max(chord[1][0]);
    let contours = [one, other].into_iter().enumerate();
    let mut chords: Vec<(usize, &Chord)> = contours
        .flat_map(|(contour, chords)| chords.iter().map(move |chord| (contour, chord)))
        .collect();
    chords.sort_by(|(_, a), (_, b)| low(a).total_cmp(&low(b)));
    chords.iter().enumerate().find_map(|(k, (contour, chord))| {
        let behind = chords.iter().skip(k + 1);
        let mut near = behind.take_while(|(_, second)| low(second) <= high(chord));
        near.find_map(|(second_contour, second)| {
            (contour != second_contour).then(|| crossing(chord, second))?
        })
    })
}

/// Returns the point at which two chords cross inside of both.
fn crossing(one: &Chord, other: &Chord) -> Option<[f64; 2]> {
    let side = |line: &Chord, p: [f64; 2]| {
        (line[1][0] - line[0][0]) * (p[1] - line[0][1])
            - (line[1][1] - line[0][1]) * (p[0] - line[0][0])
    };
    let length = |line: &Chord| distance(line[0], line[1]);
    // What touches within rounding does not cross.
    let small = 1e-9 * length(one) * length(other).max(length(one));
    let sides = |line: &Chord, segment: &Chord| {
        let (p, q) = (side(line, segment[0]), side(line, segment[1]));
        let parted = p.abs() > small && q.abs() > small && (p > 0.0) != (q > 0.0);
        parted.then_some([p, q])
    };
    sides(other, one)?;
    let [p, q] = sides(one, other)?;
    Some(along(other, p / (p - q)))
}

/// Returns the point of a chord at this part of its length.
fn along(chord: &Chord, part: f64) -> [f64; 2] {
    let [from, to] = chord;
    std::array::from_fn(|axis| from[axis] + (to[axis] - from[axis]) * part)
}

/// Returns the point of a chord that is nearest to this one.
pub fn nearest_on(chord: &Chord, point: [f64; 2]) -> [f64; 2] {
    let [from, to] = chord;
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let square = dx * dx + dy * dy;
    if square == 0.0 {
        return *from;
    }
    let part = ((point[0] - from[0]) * dx + (point[1] - from[1]) * dy) / square;
    along(chord, part.clamp(0.0, 1.0))
}

/// Returns the least distance of two contours, and the point of the first where it is; for contours that cross, zero and a
/// crossing.
pub fn clearance(one: &[Chord], other: &[Chord]) -> (f64, [f64; 2]) {
    let mut best = (f64::INFINITY, [f64::NAN; 2]);
    for a in one {
        for b in other {
            if let Some(point) = crossing(a, b) {
                return (0.0, point);
            }
            let ends = a.map(|point| (point, nearest_on(b, point)));
            let feet = b.map(|point| (nearest_on(a, point), point));
            for (point, near) in ends.into_iter().chain(feet) {
                let off = distance(point, near);
                if off < best.0 {
                    best = (off, point);
                }
            }
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: [Chord; 4] = [
        [[0.0, 0.0], [10.0, 0.0]],
        [[10.0, 0.0], [10.0, 10.0]],
        [[10.0, 10.0], [0.0, 10.0]],
        [[0.0, 10.0], [0.0, 0.0]],
    ];

    #[test]
    fn contours_are_nearest_in_the_middle_of_a_side_where_a_corner_of_the_other_points_at_it() {
        let arrow = [[[12.0, 7.0], [15.0, 9.0]], [[15.0, 9.0], [12.0, 7.0]]];
        assert_eq!(clearance(&SQUARE, &arrow), (2.0, [10.0, 7.0]));
        assert_eq!(clearance(&arrow, &SQUARE), (2.0, [12.0, 7.0]));
    }

    #[test]
    fn a_long_line_through_a_contour_crosses_it_though_all_corners_are_far_away() {
        let line = [[[-100.0, 4.0], [100.0, 4.0]]];
        let is_crossing = |at: [f64; 2]| {
            let mut crossings = [[0.0, 4.0], [10.0, 4.0]].into_iter();
            crossings.any(|crossing| distance(crossing, at) < 1e-12)
        };
        let (room, at) = clearance(&SQUARE, &line);
        assert!(room == 0.0 && is_crossing(at), "{at:?}");
        let at = mutual_crossing(&line, &SQUARE).unwrap();
        assert!(is_crossing(at), "{at:?}");
        assert_eq!(
            mutual_crossing(&[[[11.0, -5.0], [11.0, 15.0]]], &SQUARE),
            None
        );
    }
}
