//! Crossings of the lines and circles on which segments lie.

use crate::polygon::distance;
use torse_geometry::pattern::Segment;

type Circle = ([f64; 2], f64);

/// Returns the points, two at most, in which the whole lines or circles of two segments meet.
///
/// Lines have no crossing if the sine of the angle between them is at most `parallel`. Where a line or a circle passes a
/// circle, the square of half of the chord is negative: down to `-slack` this counts as touching, and the point of touch
/// is returned twice.
pub fn carrier_crossings(a: &Segment, b: &Segment, parallel: f64, slack: f64) -> Vec<[f64; 2]> {
    match (a.circle(), b.circle()) {
        (None, None) => line_line(a, b, parallel).into_iter().collect(),
        (None, Some(circle)) => line_circle(a, circle, slack),
        (Some(circle), None) => line_circle(b, circle, slack),
        (Some(one), Some(other)) => circle_circle(one, other, slack),
    }
}

fn line_line(a: &Segment, b: &Segment, parallel: f64) -> Option<[f64; 2]> {
    let [u, v] = [a, b].map(|s| [s.to[0] - s.from[0], s.to[1] - s.from[1]]);
    let turn = u[0] * v[1] - u[1] * v[0];
    if turn.abs() <= parallel * a.chord_length() * b.chord_length() {
        return None;
    }
    let arm = [b.from[0] - a.from[0], b.from[1] - a.from[1]];
    let share = (arm[0] * v[1] - arm[1] * v[0]) / turn;
    Some([0, 1].map(|i| a.from[i] + share * u[i]))
}

fn line_circle(line: &Segment, (centre, radius): Circle, slack: f64) -> Vec<[f64; 2]> {
    let length = line.chord_length();
    let unit = [0, 1].map(|i| (line.to[i] - line.from[i]) / length);
    let arm = [0, 1].map(|i| centre[i] - line.from[i]);
    let along = arm[0] * unit[0] + arm[1] * unit[1];
    let off = arm[1] * unit[0] - arm[0] * unit[1];
    let half = half_chord((radius - off) * (radius + off), slack);
    let places = half.map(|half| [along - half, along + half]);
    let point = |t: f64| [0, 1].map(|i| line.from[i] + t * unit[i]);
    places.map_or_else(Vec::new, |places| places.map(point).to_vec())
}

fn circle_circle((one, r): Circle, (other, s): Circle, slack: f64) -> Vec<[f64; 2]> {
    let apart = distance(one, other);
    if apart == 0.0 {
        return Vec::new();
    }
    let along = 0.5 * (apart + (r - s) * (r + s) / apart);
    let half = half_chord((r - along) * (r + along), slack);
    let unit = [0, 1].map(|i| (other[i] - one[i]) / apart);
    let point = |h: f64| {
        [
            one[0] + along * unit[0] - h * unit[1],
            one[1] + along * unit[1] + h * unit[0],
        ]
    };
    half.map_or_else(Vec::new, |half| [half, -half].map(point).to_vec())
}

/// Returns the root of the square, 0 if it is negative and at least `-slack`, and `None` below that.
fn half_chord(square: f64, slack: f64) -> Option<f64> {
    (square >= -slack).then(|| square.max(0.0).sqrt())
}
