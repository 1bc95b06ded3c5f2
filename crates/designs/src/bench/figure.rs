//! Drawings on paper: lines and lettering in millimetres from the upper left corner, y downwards.

use serde::Serialize;
use std::f64::consts::FRAC_PI_4;
use torse_geometry::pattern::Segment;

/// How a line is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum PaperStyle {
    /// What is cut.
    Outline,
    /// Where it is sewn, welded or glued, inside of what is cut.
    Seam,
    /// A bend line, up.
    BendUp,
    /// A bend line, down.
    BendDown,
    /// A line that stays straight when the sheet is rolled.
    Ruling,
    /// What is marked: notches, centres of openings.
    Mark,
    /// Dimension lines, scale bars.
    Dimension,
    /// The arrow of a dimension, filled.
    Arrow,
    /// The frame of what a neighbouring page shows too.
    Frame,
}

/// A line on paper.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PaperLine {
    /// How it is drawn.
    pub style: PaperStyle,
    /// The start (two numbers), then the end of a line (two) or of a cubic curve after its two control points (six).
    pub path: Vec<Vec<f64>>,
    /// Whether the end is joined to the start.
    pub closed: bool,
}

/// Lettering on paper, its middle at a point.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PaperText {
    /// The middle.
    pub at: [f64; 2],
    /// The height of a line in millimetres.
    pub size: f64,
    /// Degrees against the clock.
    pub angle: f64,
    /// What it says.
    pub text: String,
    /// Whether it stands out.
    pub bold: bool,
}

/// A drawing on paper.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
#[non_exhaustive]
pub struct PaperFigure {
    /// Its width in millimetres.
    pub width: f64,
    /// Its height in millimetres.
    pub height: f64,
    /// Its lines.
    pub lines: Vec<PaperLine>,
    /// Its lettering.
    pub texts: Vec<PaperText>,
}

/// From a part, y upwards, to paper.
#[derive(Debug, Clone, Copy)]
pub(super) struct ToPaper {
    /// Millimetres on paper for one of the part.
    pub scale: f64,
    /// Where the origin of the part is.
    pub origin: [f64; 2],
}

impl ToPaper {
    pub(super) fn point(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        // A hundred-thousandth of a millimetre is nothing on paper, and short to write.
        let short = |c: f64| (c * 1e5).round() / 1e5 + 0.0;
        [
            short(self.origin[0] + self.scale * x),
            short(self.origin[1] - self.scale * y),
        ]
    }
}

impl PaperFigure {
    /// Adds a chain of lines and arcs of the part.
    pub(super) fn chain(
        &mut self,
        style: PaperStyle,
        segments: &[Segment],
        closed: bool,
        to: ToPaper,
    ) {
        let Some(first) = segments.first() else {
            return;
        };
        let mut path = vec![to.point(first.from).to_vec()];
        for segment in segments {
            if segment.is_line() {
                path.push(to.point(segment.to).to_vec());
                continue;
            }
            let parts = (segment.angle().abs() / FRAC_PI_4).ceil().clamp(1.0, 64.0);
            let mut k = 0.0;
            while k < parts {
                let part = segment.part(k / parts, (k + 1.0) / parts);
                path.push(cubic(&part).into_iter().flat_map(|p| to.point(p)).collect());
                k += 1.0;
            }
        }
        self.lines.push(PaperLine {
            style,
            path,
            closed,
        });
    }

    /// Adds a straight line of the part.
    pub(super) fn line(&mut self, style: PaperStyle, [from, to]: [[f64; 2]; 2], map: ToPaper) {
        self.chain(style, &[Segment::line(from, to)], false, map);
    }

    /// Adds a polygon in coordinates of the paper.
    pub(super) fn polygon(&mut self, style: PaperStyle, points: &[[f64; 2]], closed: bool) {
        let path = points.iter().map(|point| point.to_vec()).collect();
        self.lines.push(PaperLine {
            style,
            path,
            closed,
        });
    }

    /// Adds a line of letters about a point of the paper; `way` is its direction on the part, turned so that it is not
    /// upside down.
    pub(super) fn text(&mut self, at: [f64; 2], way: [f64; 2], size: f64, text: &str) {
        self.texts.push(PaperText {
            at,
            size,
            angle: upright(way),
            text: text.to_owned(),
            bold: false,
        });
    }

    /// The same, standing out.
    pub(super) fn bold(&mut self, at: [f64; 2], way: [f64; 2], size: f64, text: &str) {
        self.text(at, way, size, text);
        if let Some(last) = self.texts.last_mut() {
            last.bold = true;
        }
    }

    /// Adds a dimension between two points of the paper, with arrows and its number beside the middle.
    pub(super) fn dimension(&mut self, from: [f64; 2], to: [f64; 2], text: &str) {
        const ARROW: [f64; 2] = [2.4, 0.45];
        let way = [to[0] - from[0], to[1] - from[1]];
        let size = libm::hypot(way[0], way[1]);
        if size <= 0.0 {
            return;
        }
        let unit = way.map(|c| c / size);
        self.polygon(PaperStyle::Dimension, &[from, to], false);
        for (tip, sign) in [(from, 1.0), (to, -1.0)] {
            let back = |side: f64| {
                [
                    tip[0] + sign * ARROW[0] * unit[0] - side * ARROW[1] * unit[1],
                    tip[1] + sign * ARROW[0] * unit[1] + side * ARROW[1] * unit[0],
                ]
            };
            self.polygon(PaperStyle::Arrow, &[tip, back(1.0), back(-1.0)], true);
        }
        let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
        // Above the line, as it is read.
        let reading = upright([unit[0], -unit[1]]).to_radians();
        let (sine, cosine) = libm::sincos(reading);
        let at = [middle[0] - 2.0 * sine, middle[1] - 2.0 * cosine];
        self.text(at, [unit[0], -unit[1]], 3.0, text);
    }
}

/// Returns the direction of letters in degrees against the clock, more than -90 and at most 90.
fn upright([x, y]: [f64; 2]) -> f64 {
    let angle = libm::atan2(y, x).to_degrees();
    if angle > 90.0 + 1e-9 {
        angle - 180.0
    } else if angle <= -90.0 + 1e-9 {
        angle + 180.0
    } else {
        angle
    }
}

/// Returns the control points and the end of the cubic curve that has the ends, tangents and middle of an arc; it is
/// nearer to an arc of 45 degrees than a millionth of its radius.
fn cubic(arc: &Segment) -> [[f64; 2]; 3] {
    let angle = arc.angle();
    let way = [arc.to[0] - arc.from[0], arc.to[1] - arc.from[1]];
    // The length of a handle over the chord: 4/3 tan(a/4) r, with the chord 2 r sin(a/2).
    let handle = 2.0 / 3.0 * libm::tan(0.25 * angle) / libm::sin(0.5 * angle);
    let turned = |by: f64| {
        let (sine, cosine) = libm::sincos(by);
        [
            handle * (way[0] * cosine - way[1] * sine),
            handle * (way[0] * sine + way[1] * cosine),
        ]
    };
    let (out, back) = (turned(-0.5 * angle), turned(0.5 * angle));
    [
        [arc.from[0] + out[0], arc.from[1] + out[1]],
        [arc.to[0] - back[0], arc.to[1] - back[1]],
        arc.to,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arcs_are_drawn_as_cubics_that_stay_on_their_circle() {
        let eighth = Segment {
            from: [1.0, 0.0],
            to: [libm::sqrt(0.5), libm::sqrt(0.5)],
            bulge: libm::tan(std::f64::consts::PI / 16.0),
        };
        let [a, b, c] = cubic(&eighth);
        for k in 0..=16 {
            let t = f64::from(k) / 16.0;
            let s = 1.0 - t;
            let [x, y] = [0, 1].map(|i| {
                s * s * s * eighth.from[i]
                    + 3.0 * s * s * t * a[i]
                    + 3.0 * s * t * t * b[i]
                    + t * t * t * c[i]
            });
            assert!((libm::hypot(x, y) - 1.0).abs() < 5e-6, "{t}");
        }
    }

    #[test]
    fn letters_are_never_upside_down() {
        for (way, angle) in [
            ([1.0, 0.0], 0.0),
            ([-1.0, 0.0], 0.0),
            ([0.0, -1.0], 90.0),
            ([0.0, 1.0], 90.0),
            ([-1.0, 1.0], -45.0),
        ] {
            assert!((upright(way) - angle).abs() < 1e-9, "{way:?}");
        }
    }
}
