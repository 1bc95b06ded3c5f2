//! The recorded picture: a list of marks in painter's order, in fractional pixels, y downwards.

use tiny_skia::{Path, PathBuilder};

use crate::colour::{Colour, Line};
use crate::error::FigureError;
use crate::ink::font::Style;
use crate::ink::typeset::{TypeLine, typeset};

/// An axis-parallel rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rect {
    pub x: f64,
    pub y: f64,
    pub w: f64,
    pub h: f64,
}

impl Rect {
    pub(crate) fn right(&self) -> f64 {
        self.x + self.w
    }

    pub(crate) fn bottom(&self) -> f64 {
        self.y + self.h
    }

    /// The rectangle with `left, top, right, bottom` taken off, never smaller than one pixel.
    pub(crate) fn inset(&self, [left, top, right, bottom]: [f64; 4]) -> Rect {
        Rect {
            x: self.x + left,
            y: self.y + top,
            w: (self.w - left - right).max(1.0),
            h: (self.h - top - bottom).max(1.0),
        }
    }
}

/// Where a line of type stands relative to its anchor, horizontally.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Align {
    Left,
    Centre,
    Right,
}

/// Where a note stands relative to its point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// Centred above.
    Above,
    /// Centred below.
    Below,
    /// Level, ending at the point.
    Left,
    /// Level, starting at the point.
    Right,
    /// Above, ending at the point.
    AboveLeft,
    /// Above, starting at the point.
    AboveRight,
    /// Below, ending at the point.
    BelowLeft,
    /// Below, starting at the point.
    BelowRight,
}

impl Place {
    /// Unit steps on the page, y downwards.
    fn direction(self) -> [i8; 2] {
        match self {
            Place::Above => [0, -1],
            Place::Below => [0, 1],
            Place::Left => [-1, 0],
            Place::Right => [1, 0],
            Place::AboveLeft => [-1, -1],
            Place::AboveRight => [1, -1],
            Place::BelowLeft => [-1, 1],
            Place::BelowRight => [1, 1],
        }
    }
}

/// Direction of a line of type.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Turn {
    Across,
    /// Read from below to above.
    Upwards,
    /// Along a unit vector of the page.
    Along([f64; 2]),
}

/// A glyph on the page.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Glyph {
    pub style: Style,
    pub id: u16,
    pub x: f64,
    pub y: f64,
    pub size: f64,
    pub turn: Turn,
}

/// Straight (not premultiplied) RGBA samples.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Pixels {
    pub width: u32,
    pub height: u32,
    pub rgba: Vec<u8>,
}

/// One mark.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Item {
    Fill {
        path: Path,
        colour: Colour,
        alpha: f64,
    },
    Stroke {
        path: Path,
        line: Line,
        alpha: f64,
    },
    /// Type, with a rim of paper around it where it stands on other marks.
    Type {
        glyphs: Vec<Glyph>,
        colour: Colour,
        rim: f64,
    },
    /// An image at twice the resolution of the page, and the same as a PNG file.
    Image {
        x: u32,
        y: u32,
        pixels: Pixels,
        png: Vec<u8>,
    },
}

/// The page and its marks.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Scene {
    pub width: u32,
    pub height: u32,
    pub items: Vec<Item>,
}

impl Scene {
    pub(crate) fn new(width: u32, height: u32) -> Scene {
        Scene {
            width,
            height,
            items: Vec::new(),
        }
    }

    pub(crate) fn fill(&mut self, path: Option<Path>, colour: Colour, alpha: f64) {
        self.items.extend(path.map(|path| Item::Fill {
            path,
            colour,
            alpha,
        }));
    }

    pub(crate) fn stroke(&mut self, path: Option<Path>, line: Line) {
        self.items.extend(path.map(|path| Item::Stroke {
            path,
            line,
            alpha: 1.0,
        }));
    }

    pub(crate) fn fill_rect(&mut self, r: Rect, colour: Colour) {
        let corners = [
            [r.x, r.y],
            [r.right(), r.y],
            [r.right(), r.bottom()],
            [r.x, r.bottom()],
        ];
        self.fill(polygon(&corners), colour, 1.0);
    }

    /// Set `text` with the middle of its capitals at height `y`; returns its width.
    pub(crate) fn text(
        &mut self,
        text: &str,
        size: f64,
        [x, y]: [f64; 2],
        align: Align,
        turn: Turn,
    ) -> Result<f64, FigureError> {
        let line = typeset(text, size)?;
        self.set(&line, [x, y], align, turn, 0.0);
        Ok(line.width)
    }

    /// Set a note beside a point, on a rim of paper.
    pub(crate) fn note(
        &mut self,
        text: &str,
        size: f64,
        at: [f64; 2],
        place: Place,
    ) -> Result<(), FigureError> {
        let line = typeset(text, size)?;
        let [dx, dy] = place.direction();
        let gap = 0.55 * size;
        let align = match dx {
            1 => Align::Left,
            -1 => Align::Right,
            _ => Align::Centre,
        };
        // Diagonal notes stand a little closer, level ones clear the marker.
        let reach = if dx != 0 && dy != 0 { 0.75 } else { 1.0 };
        let x = at[0] + f64::from(dx) * gap * reach;
        let y = at[1] + f64::from(dy) * (gap * reach + line.cap_height() / 2.0);
        self.set(&line, [x, y], align, Turn::Across, 2.4);
        Ok(())
    }

    /// Set lettering whose base line starts at `at` and whose capitals are so high.
    pub(crate) fn letter(
        &mut self,
        text: &str,
        height: f64,
        at: [f64; 2],
        angle: f64,
        colour: Colour,
    ) -> Result<(), FigureError> {
        let line = typeset(text, TypeLine::size_of_capitals(height))?;
        // The page has y downwards; from the base line to the middle of the capitals.
        let way = [libm::cos(angle), -libm::sin(angle)];
        let rise = 0.5 * line.cap_height();
        let middle = [at[0] + rise * way[1], at[1] - rise * way[0]];
        self.type_line(&line, middle, Align::Left, Turn::Along(way), 0.0, colour);
        Ok(())
    }

    /// Place a line of type with the middle of its capitals at `at`.
    pub(crate) fn set(
        &mut self,
        line: &TypeLine,
        at: [f64; 2],
        align: Align,
        turn: Turn,
        rim: f64,
    ) {
        self.type_line(line, at, align, turn, rim, Colour::INK);
    }

    fn type_line(
        &mut self,
        line: &TypeLine,
        at: [f64; 2],
        align: Align,
        turn: Turn,
        rim: f64,
        colour: Colour,
    ) {
        let start = match align {
            Align::Left => 0.0,
            Align::Centre => -line.width / 2.0,
            Align::Right => -line.width,
        };
        let drop = line.cap_height() / 2.0;
        let glyphs = line
            .glyphs
            .iter()
            .map(|g| {
                let (along, across) = (start + g.x, drop + g.y);
                let (dx, dy) = match turn {
                    Turn::Across => (along, across),
                    Turn::Upwards => (across, -along),
                    Turn::Along([x, y]) => (along * x - across * y, along * y + across * x),
                };
                Glyph {
                    style: g.style,
                    id: g.id,
                    x: at[0] + dx,
                    y: at[1] + dy,
                    size: g.size,
                    turn,
                }
            })
            .collect();
        self.items.push(Item::Type {
            glyphs,
            colour,
            rim,
        });
    }
}

/// An open path through `points`; `None` for fewer than two.
pub(crate) fn polyline(points: &[[f64; 2]]) -> Option<Path> {
    trace(points).and_then(PathBuilder::finish)
}

/// A closed path through `points`.
pub(crate) fn polygon(points: &[[f64; 2]]) -> Option<Path> {
    let mut path = trace(points)?;
    path.close();
    path.finish()
}

fn trace(points: &[[f64; 2]]) -> Option<PathBuilder> {
    let (first, rest) = points.split_first()?;
    if rest.is_empty() {
        return None;
    }
    let mut path = PathBuilder::new();
    path.move_to(first[0] as f32, first[1] as f32);
    for p in rest {
        path.line_to(p[0] as f32, p[1] as f32);
    }
    Some(path)
}

/// A circle.
pub(crate) fn circle([x, y]: [f64; 2], radius: f64) -> Option<Path> {
    PathBuilder::from_circle(x as f32, y as f32, radius as f32)
}
