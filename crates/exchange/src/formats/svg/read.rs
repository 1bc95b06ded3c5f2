//! Our own SVG files read back, also after a drawing program has saved them: the layers are groups by their name,
//! paths of straight sides and circular arcs, texts, and the description as notes. Elements on other layers and of
//! other kinds are passed over; a file that moves a layer or a path is refused.

use super::commands::vertices;
use super::xml::{Event, Reader, Tag};
use crate::drawing::{Drawing, Layer, Text, Vertex};
use crate::error::{Result, unreadable};

impl Drawing {
    /// The drawing in an SVG file: paths and texts on the layers of [`Layer`], with the bend angles and in the order
    /// that [`svg`](crate::svg) writes, and the description as notes. Arcs come back with bulges up to rounding.
    ///
    /// # Errors
    /// [`ExchangeError::Unreadable`](crate::ExchangeError::Unreadable) with the line for text that is not XML, for numbers that are none, for curves that
    /// are neither lines nor circular arcs and for elements that are moved by a `transform`, and what
    /// [`Drawing::path`] and [`Drawing::text`] refuse.
    ///
    /// ```
    /// use torse_exchange::{Drawing, Layer, svg};
    /// let mut drawing = Drawing::default();
    /// drawing.polygon(Layer::Outline, &[[0.0, 0.0], [40.0, 0.0], [40.0, 20.0], [0.0, 20.0]])?;
    /// drawing.bend([15.0, 0.0], [15.0, 20.0], 0.5)?;
    /// drawing.bend([25.0, 0.0], [25.0, 20.0], -0.25)?;
    /// assert_eq!(Drawing::from_svg(&svg(&drawing)?)?, drawing);
    /// # Ok::<(), torse_exchange::ExchangeError>(())
    /// ```
    pub fn from_svg(text: &str) -> Result<Self> {
        let mut found = Found::default();
        let mut reader = Reader::new(text);
        // The open elements, each with the layer that it is in.
        let mut open: Vec<(String, Option<Layer>)> = Vec::new();
        let mut svg = false;
        while let Some(event) = reader.next()? {
            let within = open.last().and_then(|(_, layer)| *layer);
            match event {
                Event::Start(tag) => {
                    svg |= tag.name == "svg";
                    let layer = found.start(&tag, within)?;
                    if !tag.empty {
                        open.push((tag.name, layer));
                    }
                }
                Event::End(name, line) => match open.pop() {
                    Some((last, _)) if last == name => found.end(&name),
                    _ => return Err(unreadable(line, "an end without its start")),
                },
                Event::Text(content) => found.content(&content),
            }
        }
        if !svg || !open.is_empty() {
            return Err(unreadable(1, "no whole SVG"));
        }
        found.drawing()
    }
}

/// A path before all of them are in order.
struct Drawn {
    order: Option<usize>,
    layer: Layer,
    vertices: Vec<Vertex>,
    closed: bool,
    bend: Option<f64>,
}

/// What was read so far.
#[derive(Default)]
struct Found {
    paths: Vec<Drawn>,
    texts: Vec<Text>,
    notes: String,
    /// What the characters that come belong to.
    writing: Writing,
}

#[derive(Default, Clone, Copy, PartialEq)]
enum Writing {
    #[default]
    Nothing,
    Notes,
    Letters,
}

impl Found {
    /// Takes an element; gives the layer of what is inside.
    fn start(&mut self, tag: &Tag, within: Option<Layer>) -> Result<Option<Layer>> {
        let moved = |layer| match tag.get("transform") {
            Some(_) => Err(unreadable(tag.line, "a layer or path that is moved")),
            None => Ok(layer),
        };
        match tag.name.as_str() {
            "g" => {
                let name = tag
                    .get("inkscape:label")
                    .or(tag.get("id"))
                    .unwrap_or_default();
                let layer = Layer::named(name).or(within);
                return if layer.is_some() {
                    moved(layer)
                } else {
                    Ok(None)
                };
            }
            "desc" if within.is_none() => self.writing = Writing::Notes,
            "path" => {
                if let Some(layer) = moved(within)? {
                    let (vertices, closed) = vertices(tag.get("d").unwrap_or_default(), tag.line)?;
                    self.paths.push(Drawn {
                        order: tag.get("data-order").and_then(|n| n.parse().ok()),
                        layer,
                        vertices,
                        closed,
                        bend: tag.number("data-bend")?,
                    });
                }
            }
            "text" => {
                if let Some(layer) = within {
                    let wanted = |name| tag.number(name);
                    let angle = tag
                        .get("transform")
                        .map_or(Ok(0.0), |turn| rotation(turn, tag.line))?;
                    self.texts.push(Text {
                        layer,
                        at: [
                            wanted("x")?.unwrap_or(0.0),
                            0.0 - wanted("y")?.unwrap_or(0.0),
                        ],
                        height: wanted("font-size")?.unwrap_or(1.0),
                        angle,
                        content: String::new(),
                    });
                    self.writing = Writing::Letters;
                }
            }
            _ => {}
        }
        Ok(within)
    }

    fn end(&mut self, name: &str) {
        if name == "desc" || name == "text" {
            self.writing = Writing::Nothing;
        }
    }

    fn content(&mut self, content: &str) {
        match (self.writing, self.texts.last_mut()) {
            (Writing::Notes, _) => self.notes.push_str(content),
            (Writing::Letters, Some(text)) => text.content.push_str(content),
            _ => {}
        }
    }

    /// The drawing, its paths in their order where the file says it.
    fn drawing(mut self) -> Result<Drawing> {
        let mut drawing = Drawing::default();
        for note in self.notes.lines().filter(|line| !line.is_empty()) {
            drawing.note(note)?;
        }
        self.paths
            .sort_by_key(|path| path.order.unwrap_or(usize::MAX));
        for path in self.paths {
            drawing.push(path.layer, &path.vertices, path.closed, path.bend)?;
        }
        for text in self.texts {
            drawing.text(text)?;
        }
        Ok(drawing)
    }
}

/// The angle of `rotate(a x y)`, counter-clockwise with y up, in radians.
fn rotation(transform: &str, line: usize) -> Result<f64> {
    let inside = transform.trim().strip_prefix("rotate(");
    let first = inside.and_then(|rest| rest.split([' ', ',', ')']).next());
    let degrees = first.and_then(|a| a.parse::<f64>().ok());
    let degrees = degrees.ok_or(unreadable(line, "a text that is moved"))?;
    Ok(-degrees.to_radians() + 0.0)
}
