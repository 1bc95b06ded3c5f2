//! A part on paper: pages, scales, the drawing with its labels and principal dimensions.

use super::figure::{PaperFigure, PaperStyle, ToPaper};
use super::sides::Side;
use super::words::{degrees, length};
use crate::unroll::{Blank, FlatPiece, Part, PartMark};
use serde::Serialize;
use std::f64::consts::FRAC_1_SQRT_2;
use torse_geometry::pattern::Segment;

/// A sheet of paper, upright.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum PaperSize {
    /// 210 x 297 mm.
    A4,
    /// 297 x 420 mm.
    A3,
    /// 8.5 x 11 in.
    Letter,
}

impl PaperSize {
    /// All with their names on the command line.
    pub const ALL: [(&'static str, Self); 3] =
        [("a4", Self::A4), ("a3", Self::A3), ("letter", Self::Letter)];

    /// Width and height in millimetres.
    #[must_use]
    pub fn millimetres(self) -> [f64; 2] {
        match self {
            Self::A4 => [210.0, 297.0],
            Self::A3 => [297.0, 420.0],
            Self::Letter => [215.9, 279.4],
        }
    }

    /// Returns the name as it is printed.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::A4 => "A4",
            Self::A3 => "A3",
            Self::Letter => "Letter",
        }
    }
}

/// The scale of a drawing.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct PaperScale {
    /// As it is written: `1:5`.
    pub name: String,
    /// Millimetres on paper for one of the part.
    pub factor: f64,
}

/// Steps of scales between powers of ten, as rulers have them.
const STEPS: [f64; 4] = [1.0, 2.0, 2.5, 5.0];
/// Room around the part for its dimensions and labels: left, top, right, bottom.
const ROOM: [f64; 4] = [16.0, 7.0, 8.0, 21.0];
/// The most rulings that are drawn of a part.
const MAX_RULINGS: usize = 14;
/// The largest scale bar on paper, in millimetres.
const MAX_BAR: f64 = 60.0;

/// Returns the largest scale at which something so large fits.
fn scale(size: [f64; 2], room: [f64; 2]) -> PaperScale {
    let fits = |factor: f64| size[0] * factor <= room[0] && size[1] * factor <= room[1];
    // Enlarged up to fifty times, reduced as much as it takes.
    for power in (-1..=12).map(|power| libm::exp10(f64::from(power))) {
        let steps = if power < 1.0 {
            // 50:1, 20:1, 10:1 as one over 0.02, 0.05, 0.1; and 5:1, 2:1 over 0.2 and 0.5.
            vec![0.02, 0.05, 0.1, 0.2, 0.5]
        } else {
            STEPS.iter().map(|step| step * power).collect()
        };
        for step in steps {
            if fits(1.0 / step) {
                let name = if step < 1.0 {
                    format!("{}:1", length(1.0 / step))
                } else {
                    format!("1:{}", length(step))
                };
                return PaperScale {
                    name,
                    factor: 1.0 / step,
                };
            }
        }
    }
    PaperScale {
        name: "not to scale".to_owned(),
        factor: (room[0] / size[0]).min(room[1] / size[1]),
    }
}

/// Where the drawing stands on its sheet.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum BenchLayout {
    /// At the left, with the view and what is said beside it.
    Beside,
    /// Across the whole width, with all else below it.
    Above,
}

impl BenchLayout {
    /// Both with the shares of width and height that the drawing takes.
    const ALL: [(Self, [f64; 2]); 2] = [(Self::Beside, [0.69, 0.68]), (Self::Above, [1.0, 0.58])];
}

/// Returns the layout in which a part is drawn largest on so much paper, and the size of its drawing.
pub(super) fn layout(size: [f64; 2], room: [f64; 2]) -> (BenchLayout, [f64; 2]) {
    let boxes = BenchLayout::ALL.map(|(layout, shares)| {
        let drawn = [0, 1].map(|i| (room[i] * shares[i]).floor());
        let inner = [drawn[0] - ROOM[0] - ROOM[2], drawn[1] - ROOM[1] - ROOM[3]];
        (layout, drawn, scale(size, inner).factor)
    });
    let [beside, above] = boxes;
    let (layout, drawn, _) = if above.2 > beside.2 { above } else { beside };
    (layout, drawn)
}

/// What a drawing of a part is made from.
pub(super) struct Drawn<'a> {
    pub piece: &'a FlatPiece,
    pub part: &'a Part,
    pub blank: &'a Blank,
    pub sides: &'a [Side],
}

/// Returns the drawing of a part in a box on paper, at the largest scale at which it fits.
pub(super) fn drawing(drawn: &Drawn<'_>, [width, height]: [f64; 2]) -> (PaperFigure, PaperScale) {
    let [left, top, right, bottom] = ROOM;
    let room = [width - left - right, height - top - bottom];
    let size = drawn.part.size;
    let scale = scale(size, room);
    let on_paper = size.map(|c| c * scale.factor);
    let corner = [
        left + 0.5 * (room[0] - on_paper[0]),
        top + 0.5 * (room[1] - on_paper[1]) + on_paper[1],
    ];
    let to = ToPaper {
        scale: scale.factor,
        origin: corner,
    };
    let mut figure = PaperFigure {
        width,
        height,
        ..PaperFigure::default()
    };
    part_lines(&mut figure, drawn, to);
    labels(&mut figure, drawn, to);
    overall(&mut figure, size, to);
    bar(&mut figure, &scale, [left, height - 2.0]);
    (figure, scale)
}

/// The lines of a part: what is cut, bent, rolled and marked.
pub(super) fn part_lines(figure: &mut PaperFigure, drawn: &Drawn<'_>, to: ToPaper) {
    let part = drawn.part;
    for line in rulings(drawn) {
        figure.line(PaperStyle::Ruling, line, to);
    }
    figure.chain(PaperStyle::Outline, &part.outline, true, to);
    if let Some(seam_line) = &part.seam_line {
        figure.chain(PaperStyle::Seam, seam_line, true, to);
    }
    for opening in &part.openings {
        figure.chain(PaperStyle::Outline, &opening.shape.contour(), true, to);
        let ([x, y], [low, high]) = (opening.shape.middle(), opening.shape.bounds());
        let [wide, tall] = [0, 1].map(|i| 0.5 * (high[i] - low[i]) + 1.5 / to.scale);
        figure.line(PaperStyle::Mark, [[x - wide, y], [x + wide, y]], to);
        figure.line(PaperStyle::Mark, [[x, y - tall], [x, y + tall]], to);
    }
    let bends = part.bends.iter().map(|bend| (bend.line, bend.angle));
    for (line, angle) in bends.chain(part.sharp.iter().map(|fold| (fold.line, fold.angle))) {
        let style = if angle > 0.0 {
            PaperStyle::BendUp
        } else {
            PaperStyle::BendDown
        };
        figure.line(style, line, to);
    }
    for notch in &part.notches {
        figure.line(PaperStyle::Mark, *notch, to);
    }
    for mark in &part.marks {
        match mark {
            PartMark::Line(points) => {
                for pair in points.windows(2) {
                    figure.line(PaperStyle::Mark, [pair[0], pair[1]], to);
                }
            }
            PartMark::Circle([x, y], radius) => {
                let half = |from: f64, end: f64| Segment {
                    from: [x + from * radius, *y],
                    to: [x + end * radius, *y],
                    bulge: 1.0,
                };
                let circle = [half(1.0, -1.0), half(-1.0, 1.0)];
                figure.chain(PaperStyle::Mark, &circle, true, to);
            }
            PartMark::Text(at, height, angle, content) => {
                // A line on paper is as high as it says, and its middle is where it stands.
                let (x, y) = (libm::cos(*angle), libm::sin(*angle));
                let half = 0.3 * height * content.chars().map(|_| 1.0).sum::<f64>();
                let middle = [
                    at[0] + half * x - 0.5 * height * y,
                    at[1] + half * y + 0.5 * height * x,
                ];
                figure.text(to.point(middle), [x, -y], height * to.scale, content);
            }
        }
    }
}

/// Returns some of the rulings along which a rolled part stays straight.
fn rulings(drawn: &Drawn<'_>) -> Vec<[[f64; 2]; 2]> {
    if drawn.part.rolled.is_empty() {
        return Vec::new();
    }
    let flat = &drawn.piece.flat;
    let bent: Vec<_> = flat
        .rulings()
        .iter()
        .filter(|r| r.radius.is_finite() && !r.is_point())
        .collect();
    let every = bent.len().div_ceil(MAX_RULINGS).max(1);
    let placed = bent
        .iter()
        .skip(every / 2)
        .step_by(every)
        .filter_map(|ruling| {
            let [a, b] = ruling.ends;
            let on = |p| {
                Some(
                    drawn
                        .part
                        .placement
                        .point(drawn.blank.place(ruling.piece, p, 0.0)?),
                )
            };
            Some([on(a)?, on(b)?])
        });
    placed.collect()
}

/// The labels of sides, openings and bends.
pub(super) fn labels(figure: &mut PaperFigure, drawn: &Drawn<'_>, to: ToPaper) {
    const SIZE: f64 = 3.0;
    for side in drawn.sides {
        if let Some((middle, [x, y])) = side.middle() {
            let at = to.point(middle);
            // The part is on the left, the label on the right, of a part with an allowance inside of the seam.
            let off = if drawn.part.seam_line.is_some() {
                -3.0
            } else {
                3.0
            };
            let at = [at[0] + off * y, at[1] + off * x];
            figure.bold(at, [x, y], SIZE + 0.3, &side.mark());
        }
    }
    for (k, opening) in drawn.part.openings.iter().enumerate() {
        let [low, high] = opening.shape.bounds();
        let half = 0.5 * (high[0] - low[0]).max(high[1] - low[1]);
        let away = (half * to.scale * FRAC_1_SQRT_2).max(1.0) + 1.8;
        let [x, y] = to.point(opening.shape.middle());
        figure.text(
            [x + away + 1.0, y - away],
            [1.0, 0.0],
            SIZE,
            &format!("H{}", k + 1),
        );
    }
    let part = drawn.part;
    let bends = part.bends.iter().enumerate().map(|(k, bend)| {
        let radius = length(bend.inside_radius);
        let name = format!("B{}  {}  R{radius}", k + 1, turned(bend.angle));
        (bend.line, name)
    });
    let sharp = part.sharp.iter().enumerate().map(|(k, fold)| {
        let name = format!("S{}  {}", k + 1, turned(fold.angle));
        (fold.line, name)
    });
    for ([from, end], name) in bends.chain(sharp) {
        let way = [end[0] - from[0], end[1] - from[1]];
        let size = libm::hypot(way[0], way[1]);
        let [x, y] = way.map(|c| c / size);
        let (x, y) = if x < -1e-9 || (x.abs() <= 1e-9 && y < 0.0) {
            (-x, -y)
        } else {
            (x, y)
        };
        // A third of the way, above the line as it is read.
        let at = to.point([0, 1].map(|i| from[i] + way[i] / 3.0));
        figure.text([at[0] - 2.0 * y, at[1] - 2.0 * x], [x, y], SIZE, &name);
    }
}

/// Returns an angle with the way that it is bent.
fn turned(angle: f64) -> String {
    let way = if angle > 0.0 { "up" } else { "down" };
    format!("{} {way}", degrees(angle.abs().to_degrees()))
}

/// Width and height of the box, and its lower left corner, from which all is measured.
fn overall(figure: &mut PaperFigure, [width, height]: [f64; 2], to: ToPaper) {
    const BELOW: f64 = 9.0;
    let [low, high] = [to.point([0.0, 0.0]), to.point([width, height])];
    let y = low[1] + BELOW;
    let x = low[0] - BELOW;
    for end in [low[0], high[0]] {
        figure.polygon(
            PaperStyle::Dimension,
            &[[end, low[1] + 1.0], [end, y + 1.0]],
            false,
        );
    }
    for end in [low[1], high[1]] {
        figure.polygon(
            PaperStyle::Dimension,
            &[[low[0] - 1.0, end], [x - 1.0, end]],
            false,
        );
    }
    figure.dimension([low[0], y], [high[0], y], &length(width));
    figure.dimension([x, low[1]], [x, high[1]], &length(height));
    // Where coordinates start.
    const CORNER: f64 = 3.0;
    figure.polygon(
        PaperStyle::Dimension,
        &[[low[0], low[1] - CORNER], low, [low[0] + CORNER, low[1]]],
        false,
    );
    figure.text([low[0] - 3.2, low[1] + 3.0], [1.0, 0.0], 2.6, "0, 0");
}

/// A bar with the lengths of the part, in the lower left corner.
fn bar(figure: &mut PaperFigure, scale: &PaperScale, [x, y]: [f64; 2]) {
    let most = MAX_BAR / scale.factor;
    let power = libm::exp10(libm::floor(libm::log10(most)));
    let step = [5.0, 2.0, 1.0].map(|step| step * power);
    let Some(whole) = step.into_iter().find(|step| *step <= most) else {
        return;
    };
    let end = x + whole * scale.factor;
    figure.polygon(PaperStyle::Dimension, &[[x, y], [end, y]], false);
    for k in 0..=10 {
        let at = x + (end - x) * f64::from(k) / 10.0;
        let high = if k % 5 == 0 { 2.5 } else { 1.3 };
        figure.polygon(PaperStyle::Dimension, &[[at, y], [at, y - high]], false);
    }
    for share in [0.0, 0.5, 1.0] {
        let at = [x + share * (end - x), y - 4.4];
        figure.text(at, [1.0, 0.0], 2.6, &length(share * whole));
    }
    let at = [end + 14.0, y - 1.4];
    let paper = length(whole * scale.factor);
    figure.text(at, [1.0, 0.0], 2.6, &format!("mm at {}", scale.name));
    figure.text(
        [at[0] + 28.0, at[1]],
        [1.0, 0.0],
        2.6,
        &format!("(bar: {paper} mm on paper)"),
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_is_drawn_at_the_largest_scale_of_a_ruler_at_which_it_fits() {
        for (size, name) in [
            (100.0, "1:1"),
            (101.0, "1:2"),
            (201.0, "1:2.5"),
            (499.0, "1:5"),
            (2400.0, "1:25"),
            (45.0, "2:1"),
            (4.0, "20:1"),
        ] {
            let scale = scale([size, 0.5 * size], [100.0, 60.0]);
            assert_eq!(scale.name, name);
            assert!(size * scale.factor <= 100.0);
        }
    }
}
