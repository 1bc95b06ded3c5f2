//! Our own SVG files read back, also after a drawing program has saved them: the layers are groups by their name,
//! paths of straight sides and circular arcs, texts, and the description as notes. Elements on other layers and of
//! other kinds are passed over. Groups and paths may be moved, turned, mirrored and scaled; lengths are in the unit that
//! the file states.

use crate::drawing::{BendLine, Drawing, Layer, Text, Vertex};
use crate::error::{ExchangeError, Result};
use crate::read::svg::document::{self, Element, Matrix};
use crate::read::svg::parts;
use crate::read::svg::path::{Segment, Subpath};
use crate::read::{FilePlace, ReadError};
use torse_algebra::Rational;

impl Drawing {
    /// The drawing in an SVG file: paths and texts on the layers of [`Layer`], with the bend angles and in the order
    /// that [`svg`](crate::svg) writes, and the description as notes. Arcs come back with bulges up to
    /// rounding, the direction of a text without whole turns. A file
    /// that states no unit is in millimetres.
    ///
    /// # Errors
    /// [`ExchangeError::Read`] with line and element for text that is not XML, for numbers that are none, for curves that
    /// are neither lines nor circular arcs, and what [`Drawing::path`] and [`Drawing::text`] refuse.
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
        let document = document::parse(text)?;
        let found = document::drawn(&document, &Rational::from(1))?;
        let mut drawing = Self::default();
        for note in found.notes.lines().filter(|line| !line.is_empty()) {
            drawing.note(note)?;
        }
        let mut paths = Vec::new();
        let mut texts = Vec::new();
        for element in &found.elements {
            let Some(layer) = element
                .layers
                .iter()
                .rev()
                .find_map(|name| Layer::named(name))
            else {
                continue;
            };
            match element.tag {
                "text" => texts.push(text_of(element, layer)?),
                _ => paths.extend(paths_of(element, layer)?),
            }
        }
        // In their order where the file says it.
        paths.sort_by_key(|path| path.order.unwrap_or(usize::MAX));
        for path in paths {
            drawing.push(path.layer, &path.vertices, path.closed, path.bend)?;
        }
        for text in texts {
            drawing.text(text)?;
        }
        Ok(drawing)
    }
}

/// A path before all of them are in order.
struct Drawn {
    order: Option<usize>,
    layer: Layer,
    vertices: Vec<Vertex>,
    closed: bool,
    bend: Option<BendLine>,
}

fn wrong(place: &FilePlace, reason: impl Into<String>) -> ExchangeError {
    ExchangeError::Read(ReadError::Wrong {
        place: place.clone(),
        reason: reason.into(),
    })
}

fn paths_of(element: &Element<'_>, layer: Layer) -> Result<Vec<Drawn>> {
    let attribute = |name: &str| element.node.attribute(name);
    let number = |name: &str| {
        let Some(text) = attribute(name) else {
            return Ok(None);
        };
        let number = text.trim().parse::<f64>().ok();
        let number = number.filter(|number| number.is_finite());
        number
            .map(Some)
            .ok_or_else(|| wrong(&element.place, format!("`{name}` is no number")))
    };
    let inside_radius = number("data-inside-radius")?;
    let bend = number("data-bend")?.map(|angle| BendLine {
        angle,
        inside_radius,
    });
    let mut parts = parts(element)?;
    // A move alone draws nothing.
    parts.retain(|part| !part.segments.is_empty());
    if bend.is_some() && parts.len() > 1 {
        return Err(wrong(&element.place, "a bend line of several parts"));
    }
    parts
        .iter()
        .map(|part| {
            Ok(Drawn {
                order: attribute("data-order").and_then(|n| n.parse().ok()),
                layer,
                vertices: vertices(part, element)?,
                closed: part.closed,
                bend,
            })
        })
        .collect()
}

/// By how much a map stretches, and whether it mirrors (which the step from y down to y up does); nothing for one that
/// makes ellipses of circles.
fn similarity(matrix: Matrix) -> Option<(f64, bool)> {
    let ([a, b], [c, d]) = (matrix.vector([1.0, 0.0]), matrix.vector([0.0, 1.0]));
    let (first, second) = (libm::hypot(a, b), libm::hypot(c, d));
    let even =
        (first - second).abs() <= 1e-9 * first && (a * c + b * d).abs() <= 1e-9 * first * second;
    (even && first > 0.0).then_some((first, a * d - b * c < 0.0))
}

/// The vertices of a part, in millimetres, y up.
fn vertices(part: &Subpath, element: &Element<'_>) -> Result<Vec<Vertex>> {
    // Plus zero: no negative zero.
    let vertex = |p: [f64; 2]| Vertex {
        point: element.matrix.point(p).map(|c| c + 0.0),
        bulge: 0.0,
    };
    let mut vertices = vec![vertex(part.start)];
    let mut at = part.start;
    for segment in &part.segments {
        let mut bulge = 0.0;
        match *segment {
            Segment::Line(_) => {}
            Segment::Arc {
                radii: [rx, ry],
                large,
                sweep,
                to,
                ..
            } => {
                let round = (rx - ry).abs() <= 1e-9 * rx;
                let Some((_, mirrored)) = similarity(element.matrix).filter(|_| round) else {
                    return Err(wrong(&element.place, "an arc of an ellipse"));
                };
                bulge = bulge_of(at, to, rx, large, sweep);
                if mirrored {
                    bulge = -bulge;
                }
            }
            Segment::Quadratic(_) | Segment::Cubic(_) => {
                return Err(wrong(
                    &element.place,
                    "a curve that is neither a line nor an arc of a circle",
                ));
            }
        }
        if let Some(last) = vertices.last_mut() {
            last.bulge = bulge;
        }
        at = segment.end();
        vertices.push(vertex(at));
    }
    Ok(vertices)
}

/// `tan(theta/4)` of an arc over a chord, positive for SVG's positive way; half a circle where the radius is too small
/// for the chord, as SVG demands.
fn bulge_of(from: [f64; 2], to: [f64; 2], radius: f64, large: bool, sweep: bool) -> f64 {
    let half = 0.5 * libm::hypot(to[0] - from[0], to[1] - from[1]);
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
    if sweep { size } else { -size }
}

/// A text: its place, its height and the direction of its base line.
fn text_of(element: &Element<'_>, layer: Layer) -> Result<Text> {
    let number = |name: &str| element.length(name).map_err(ExchangeError::from);
    let (x, y) = (number("x")?.unwrap_or(0.0), number("y")?.unwrap_or(0.0));
    let Some((stretch, _)) = similarity(element.matrix) else {
        return Err(wrong(&element.place, "a text that is stretched"));
    };
    let [a, b] = element.matrix.vector([1.0, 0.0]);
    let content = element
        .node
        .descendants()
        .filter_map(|node| if node.is_text() { node.text() } else { None });
    Ok(Text {
        layer,
        at: element.matrix.point([x, y]).map(|c| c + 0.0),
        height: number("font-size")?.unwrap_or(1.0) * stretch,
        angle: libm::atan2(b, a) + 0.0,
        content: content.collect(),
    })
}
