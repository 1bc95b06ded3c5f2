//! Legends: always beside the plotting area, never on it.

use crate::colour::{Colour, Line};
use crate::error::FigureError;
use crate::ink::chart::TEXT_SIZE;
use crate::ink::scene::{Align, Rect, Scene, Turn, circle, polygon, polyline};
use crate::ink::typeset::{TypeLine, typeset};

/// Where the legend stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Legend {
    /// A column to the right.
    #[default]
    Right,
    /// Rows below.
    Below,
    /// Nowhere.
    Hidden,
}

/// The shape of a marked point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Marker {
    /// A filled disc.
    #[default]
    Disc,
    /// A ring filled with paper.
    Ring,
    /// A filled square.
    Square,
    /// A filled square on its corner.
    Diamond,
}

/// The sample in front of a legend entry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Key {
    Line(Line),
    Marker(Marker, Colour),
    /// A control polygon: a line through a marker.
    Chain(Line, Marker),
    /// A two-sided surface.
    Patch(Colour, Colour),
}

/// The measured legend.
pub(crate) struct Entries {
    rows: Vec<Vec<(Key, TypeLine)>>,
    /// Room it takes, the gap to the plotting area included.
    pub width: f64,
    pub height: f64,
}

const SAMPLE: f64 = 26.0;
const GAP: f64 = 7.0;
const BETWEEN: f64 = 18.0;
const ROW: f64 = 1.45 * TEXT_SIZE;

impl Entries {
    /// Measure the entries; rows below the plot break at `page` pixels.
    pub(crate) fn new(
        place: Legend,
        entries: &[(Key, &str)],
        page: f64,
    ) -> Result<Entries, FigureError> {
        let mut rows: Vec<Vec<(Key, TypeLine)>> = Vec::new();
        let mut width = 0.0f64;
        let mut pen = 0.0f64;
        for &(key, label) in entries {
            let line = typeset(label, TEXT_SIZE)?;
            let own = SAMPLE + GAP + line.width;
            let joins = place == Legend::Below && pen + BETWEEN + own <= page;
            match rows.last_mut() {
                Some(row) if joins => {
                    row.push((key, line));
                    pen += BETWEEN + own;
                }
                _ => {
                    rows.push(vec![(key, line)]);
                    pen = own;
                }
            }
            width = width.max(pen);
        }
        let height = rows.len() as f64 * ROW;
        Ok(match place {
            _ if rows.is_empty() => Entries {
                rows,
                width: 0.0,
                height: 0.0,
            },
            Legend::Hidden => Entries {
                rows: Vec::new(),
                width: 0.0,
                height: 0.0,
            },
            Legend::Right => Entries {
                rows,
                width: width + BETWEEN,
                height,
            },
            Legend::Below => Entries {
                rows,
                width,
                height: height + GAP,
            },
        })
    }

    /// Draw into `room`, which is at least as large as measured.
    pub(crate) fn draw(&self, scene: &mut Scene, place: Legend, room: Rect) {
        let mut y = match place {
            Legend::Below => room.y + GAP,
            _ => room.y + ((room.h - self.height) / 2.0).max(0.0),
        } + ROW / 2.0;
        for row in &self.rows {
            let wide: f64 = row.iter().map(|(_, l)| SAMPLE + GAP + l.width).sum();
            let wide = wide + BETWEEN * row.len().saturating_sub(1) as f64;
            let mut x = match place {
                Legend::Below => room.x + (room.w - wide) / 2.0,
                _ => room.x + BETWEEN,
            };
            for (key, line) in row {
                key.draw(scene, [x, y]);
                scene.set(line, [x + SAMPLE + GAP, y], Align::Left, Turn::Across, 0.0);
                x += SAMPLE + GAP + line.width + BETWEEN;
            }
            y += ROW;
        }
    }
}

impl Key {
    fn draw(self, scene: &mut Scene, [x, y]: [f64; 2]) {
        let middle = [x + SAMPLE / 2.0, y];
        match self {
            Key::Line(line) => scene.stroke(polyline(&[[x, y], [x + SAMPLE, y]]), line),
            Key::Marker(marker, colour) => draw_marker(scene, middle, marker, colour),
            Key::Chain(line, marker) => {
                scene.stroke(polyline(&[[x, y], [x + SAMPLE, y]]), line);
                draw_marker(scene, middle, marker, line.colour);
            }
            Key::Patch(front, back) => {
                let (l, r, t, b) = (x + 3.0, x + SAMPLE - 3.0, y - 5.0, y + 5.0);
                let quad = [[l, t], [r, t], [r, b], [l, b]];
                scene.fill(polygon(&quad), front, 1.0);
                if front != back {
                    scene.fill(polygon(&[[r, t], [r, b], [l, b]]), back, 1.0);
                }
                scene.stroke(polygon(&quad), Line::solid(Colour::GREY, 0.6));
            }
        }
    }
}

/// Draw a marker of the usual size.
pub(crate) fn draw_marker(scene: &mut Scene, at: [f64; 2], marker: Marker, colour: Colour) {
    let around =
        |r: f64, turn: [[f64; 2]; 4]| turn.map(|[dx, dy]| [at[0] + r * dx, at[1] + r * dy]);
    const SQUARE: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    const DIAMOND: [[f64; 2]; 4] = [[0.0, -1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.0]];
    match marker {
        Marker::Disc => scene.fill(circle(at, 3.1), colour, 1.0),
        Marker::Ring => {
            scene.fill(circle(at, 2.9), Colour::PAPER, 1.0);
            scene.stroke(circle(at, 2.9), Line::solid(colour, 1.2));
        }
        Marker::Square => scene.fill(polygon(&around(2.8, SQUARE)), colour, 1.0),
        Marker::Diamond => scene.fill(polygon(&around(4.0, DIAMOND)), colour, 1.0),
    }
}
