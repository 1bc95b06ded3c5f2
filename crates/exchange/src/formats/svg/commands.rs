//! The commands of an SVG path: straight sides and circular arcs, as text and back.

use crate::drawing::{Arc, Path, Vertex};
use crate::error::{ExchangeError, Result, unreadable};
use std::fmt::Write;
use std::iter::Peekable;
use std::str::Chars;

/// The commands of a path, absolute and in the shortest form that reads back to the same numbers; y points down.
pub(super) fn commands(path: &Path) -> String {
    let point = |[x, y]: [f64; 2]| format!("{} {}", x + 0.0, 0.0 - y);
    let start = path.vertices().first().map(|v| v.point).unwrap_or_default();
    let mut text = format!("M{}", point(start));
    let straight_back = |to: [f64; 2], bulge: f64| path.is_closed() && to == start && bulge == 0.0;
    for (from, to) in path.sides() {
        match Arc::of(from, to) {
            Some(arc) => {
                // Left in the drawing is against the clock, which SVG, with y down, calls negative.
                let (large, sweep) = (u8::from(from.bulge.abs() > 1.0), u8::from(from.bulge < 0.0));
                let r = arc.radius;
                let _ = write!(text, "A{r} {r} 0 {large} {sweep} {}", point(to));
            }
            None if straight_back(to, from.bulge) => {}
            None => text.push_str(&format!("L{}", point(to))),
        }
    }
    if path.is_closed() {
        text.push('Z');
    }
    text
}

/// The vertices of a path with y up, and whether it is closed. All commands for lines and arcs, absolute and relative.
pub(super) fn vertices(commands: &str, line: usize) -> Result<(Vec<Vertex>, bool)> {
    let mut tokens = Tokens {
        rest: commands.chars().peekable(),
        line,
    };
    let mut vertices: Vec<Vertex> = Vec::new();
    let (mut closed, mut command) = (false, None);
    loop {
        command = match tokens.command() {
            Some(letter) => Some(letter),
            None if tokens.is_empty() => break,
            // Numbers go on with the last command; after a move come lines.
            None => command.map(|c| match c {
                'M' => 'L',
                'm' => 'l',
                other => other,
            }),
        };
        let letter = command.ok_or_else(|| tokens.wrong("a path that starts with no command"))?;
        if closed {
            return Err(tokens.wrong("a path of several parts"));
        }
        let [x, y] = vertices.last().map_or([0.0; 2], |v| v.point);
        let from = if letter.is_ascii_lowercase() {
            [x, y]
        } else {
            [0.0; 2]
        };
        let mut bulge = 0.0;
        let point = match letter.to_ascii_uppercase() {
            'M' if !vertices.is_empty() => return Err(tokens.wrong("a path of several parts")),
            'M' | 'L' => tokens.point(from)?,
            'H' => [from[0] + tokens.number()?, y],
            'V' => [x, from[1] - tokens.number()?],
            'A' => {
                let radii = [tokens.number()?, tokens.number()?];
                let _turn = tokens.number()?;
                let (large, sweep) = (tokens.flag()?, tokens.flag()?);
                let to = tokens.point(from)?;
                if (radii[0] - radii[1]).abs() > 1e-9 * radii[0].abs() {
                    return Err(tokens.wrong("an arc of an ellipse"));
                }
                bulge = bulge_of([x, y], to, radii[0].abs(), large, sweep);
                to
            }
            'Z' => {
                closed = true;
                continue;
            }
            _ => return Err(tokens.wrong("a curve that is neither a line nor an arc of a circle")),
        };
        if let Some(last) = vertices.last_mut() {
            last.bulge = bulge;
        }
        vertices.push(Vertex { point, bulge: 0.0 });
    }
    Ok((vertices, closed))
}

/// `tan(theta/4)` of an arc over a chord; half a circle where the radius is too small for the chord, as SVG demands.
fn bulge_of(from: [f64; 2], to: [f64; 2], radius: f64, large: bool, sweep: bool) -> f64 {
    let half = 0.5 * (to[0] - from[0]).hypot(to[1] - from[1]);
    if radius == 0.0 || half == 0.0 {
        return 0.0;
    }
    let height = ((radius - half) * (radius + half)).max(0.0).sqrt();
    let size = if large {
        (radius + height) / half
    } else {
        half / (radius + height)
    };
    let size = if radius <= half { 1.0 } else { size };
    if sweep { -size } else { size }
}

/// Letters and numbers of a path.
struct Tokens<'t> {
    rest: Peekable<Chars<'t>>,
    line: usize,
}

impl Tokens<'_> {
    fn wrong(&self, what: &'static str) -> ExchangeError {
        unreadable(self.line, what)
    }

    fn skip(&mut self) {
        while self
            .rest
            .next_if(|c| c.is_whitespace() || *c == ',')
            .is_some()
        {}
    }

    fn is_empty(&mut self) -> bool {
        self.skip();
        self.rest.peek().is_none()
    }

    fn command(&mut self) -> Option<char> {
        self.skip();
        self.rest.next_if(char::is_ascii_alphabetic)
    }

    /// A number ends where another sign, point or letter begins.
    fn number(&mut self) -> Result<f64> {
        self.skip();
        let mut text = String::new();
        while let Some(&c) = self.rest.peek() {
            let signed = text.is_empty() || text.ends_with(['e', 'E']);
            let fits = match c {
                '0'..='9' => true,
                '+' | '-' => signed,
                '.' => !text.contains(['.', 'e', 'E']),
                'e' | 'E' => !text.contains(['e', 'E']),
                _ => false,
            };
            if !fits {
                break;
            }
            text.push(c);
            self.rest.next();
        }
        text.parse().map_err(|_| self.wrong("no number"))
    }

    fn flag(&mut self) -> Result<bool> {
        self.skip();
        match self.rest.next() {
            Some('0') => Ok(false),
            Some('1') => Ok(true),
            _ => Err(self.wrong("no flag of an arc")),
        }
    }

    /// A point with y up, relative to another.
    fn point(&mut self, from: [f64; 2]) -> Result<[f64; 2]> {
        let x = self.number()?;
        let y = self.number()?;
        Ok([from[0] + x, from[1] - y])
    }
}
