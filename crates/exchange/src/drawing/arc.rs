//! The circular arc of a side with a bulge.
//!
//! With the chord `c` from start to end and the bulge `b = tan(theta/4)` the radius is
//! `|c| (1 + b^2)/(4 |b|)`, and the centre is the middle of the chord plus `(1 - b^2)/(4 b)` times the chord
//! turned left by a right angle.

use super::Vertex;

/// An arc: centre, radius, and the sides of the chord.
pub(crate) struct Arc {
    pub(crate) centre: [f64; 2],
    pub(crate) radius: f64,
    start: [f64; 2],
    chord: [f64; 2],
    bulge: f64,
}

impl Arc {
    /// The arc of a side; `None` of a straight one, and where the bulge is so small that the radius
    /// overflows.
    pub(crate) fn from_bulge(from: Vertex, to: [f64; 2]) -> Option<Self> {
        let ([x, y], b) = (from.point, from.bulge);
        let chord = [to[0] - x, to[1] - y];
        let radius = libm::hypot(chord[0], chord[1]) * (1.0 + b * b) / (4.0 * b.abs());
        let rise = (1.0 - b * b) / (4.0 * b);
        let centre = [
            x + 0.5 * chord[0] - rise * chord[1],
            y + 0.5 * chord[1] + rise * chord[0],
        ];
        let finite = radius.is_finite() && centre.iter().all(|x| x.is_finite());
        (b != 0.0 && finite).then_some(Self {
            centre,
            radius,
            start: [x, y],
            chord,
            bulge: b,
        })
    }

    /// The points of the arc farthest to the right, up, left and down, as far as they are inside it.
    pub(crate) fn extremes(&self) -> Vec<[f64; 2]> {
        let ways = [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]];
        let inside = |p: &[f64; 2]| {
            // The arc lies to the right of its chord when it turns left.
            let way = [p[0] - self.start[0], p[1] - self.start[1]];
            (self.chord[0] * way[1] - self.chord[1] * way[0]) * self.bulge < 0.0
        };
        let at = |way: [f64; 2]| {
            [
                self.centre[0] + self.radius * way[0],
                self.centre[1] + self.radius * way[1],
            ]
        };
        ways.map(at).into_iter().filter(inside).collect()
    }
}

/// Points along a side after its start, its end included; see [`Path::polygon`](super::Path::polygon).
pub(crate) fn parts(from: Vertex, to: [f64; 2], share: f64) -> Vec<[f64; 2]> {
    let Some(arc) = Arc::from_bulge(from, to) else {
        return vec![to];
    };
    let turn = 4.0 * libm::atan(from.bulge);
    // A part of an angle t has a sagitta below r t^2/8, and the whole arc the length r |turn|.
    let wanted = (turn.abs() / (8.0 * share.max(1e-9))).sqrt().ceil();
    let count = wanted.clamp(1.0, 256.0);
    let (x, y) = (from.point[0] - arc.centre[0], from.point[1] - arc.centre[1]);
    let mut points = Vec::new();
    let mut k = 1.0;
    while k < count {
        let (sine, cosine) = libm::sincos(turn * k / count);
        points.push([
            arc.centre[0] + cosine * x - sine * y,
            arc.centre[1] + sine * x + cosine * y,
        ]);
        k += 1.0;
    }
    points.push(to);
    points
}
