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
    /// The two sides of a surface, and its opacity.
    Patch([Colour; 2], f64),
}

/// The measured legend.
pub(crate) struct Entries {
    rows: Vec<Vec<(Key, TypeLine)>>,
    /// Room it takes, the gap to the plotting area included.
    pub width: f64,
    pub height: f64,
}

const SAMPLE: f64 = 28.0;
const GAP: f64 = 7.0;
const BETWEEN: f64 = 14.0;
const ROW: f64 = 1.45 * TEXT_SIZE;

impl Entries {
    /// Measure the entries; rows below the plot break at `page` pixels.
    pub(crate) fn new(
        place: Legend,
        entries: &[(Key, &str)],
        page: f64,
    ) -> Result<Entries, FigureError> {
        let mut lines = Vec::with_capacity(entries.len());
        for &(key, label) in entries {
            lines.push((key, typeset(label, TEXT_SIZE)?));
        }
        let columns = match place {
            Legend::Below => columns_that_fit(&lines, page),
            _ => 1,
        };
        let rows: Vec<Vec<(Key, TypeLine)>> = lines.chunks(columns).map(<[_]>::to_vec).collect();
        let width = rows.iter().map(|row| row_width(row)).fold(0.0, f64::max);
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
            let wide = row_width(row);
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

fn row_width(row: &[(Key, TypeLine)]) -> f64 {
    let own: f64 = row.iter().map(|(_, line)| SAMPLE + GAP + line.width).sum();
    own + BETWEEN * row.len().saturating_sub(1) as f64
}

/// Entries per row, at least one, so that no row is wider than `page` and the rows are about equally long.
fn columns_that_fit(lines: &[(Key, TypeLine)], page: f64) -> usize {
    let fits = |&n: &usize| lines.chunks(n).all(|row| row_width(row) <= page);
    let most = (1..=lines.len()).rev().find(fits).unwrap_or(1);
    let rows = lines.len().div_ceil(most).max(1);
    lines.len().div_ceil(rows).max(1)
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
            Key::Patch([front, back], opacity) => {
                let (l, r, t, b) = (x + 6.0, x + SAMPLE - 6.0, y - 5.0, y + 5.0);
                let quad = [[l, t], [r, t], [r, b], [l, b]];
                scene.fill(polygon(&quad), front, opacity);
                if front != back {
                    scene.fill(polygon(&[[r, t], [r, b], [l, b]]), back, opacity);
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
