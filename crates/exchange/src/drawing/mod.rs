//! Flat drawings in layers: what a cutter or a press brake needs of a flat pattern.

mod arc;
mod flat;
mod layer;

pub(crate) use arc::Arc;
pub use layer::Layer;

use crate::error::{ExchangeError, Result};

/// A corner of a path and the side that starts there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vertex {
    /// The place, in millimetres.
    pub point: [f64; 2],
    /// The tangent of a quarter of the angle that the side to the next vertex turns: 0 for a straight side,
    /// 1 for half a circle, positive to the left (counter-clockwise).
    pub bulge: f64,
}

/// What happens at a bend line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BendLine {
    /// The angle in radians by which the sheet is bent, positive upwards (towards the viewer).
    pub angle: f64,
    /// The inside radius of the bend in millimetres, where a tool makes it.
    pub inside_radius: Option<f64>,
}

/// A path of straight sides and circular arcs on a layer.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    layer: Layer,
    vertices: Vec<Vertex>,
    closed: bool,
    bend: Option<BendLine>,
}

impl Path {
    /// The layer.
    #[must_use]
    pub fn layer(&self) -> Layer {
        self.layer
    }

    /// The vertices: two at least, neighbours differ.
    #[must_use]
    pub fn vertices(&self) -> &[Vertex] {
        &self.vertices
    }

    /// Whether the last vertex is joined to the first.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.closed
    }

    /// The angle in radians by which the sheet is bent at this line, positive upwards (towards the viewer).
    #[must_use]
    pub fn bend(&self) -> Option<f64> {
        self.bend.map(|bend| bend.angle)
    }

    /// The inside radius of the bend at this line in millimetres, where a tool makes it.
    #[must_use]
    pub fn inside_radius(&self) -> Option<f64> {
        self.bend.and_then(|bend| bend.inside_radius)
    }

    /// The path as points, with arcs divided so that no chord is farther from its arc than this share of the length
    /// of the whole arc (at most 256 parts); a closed path ends where it starts.
    #[must_use]
    pub fn polygon(&self, share: f64) -> Vec<[f64; 2]> {
        let mut points: Vec<[f64; 2]> =
            self.vertices.first().map(|v| v.point).into_iter().collect();
        for (from, to) in self.sides() {
            points.extend(arc::parts(from, to, share));
        }
        points
    }

    /// The sides: each vertex with the place of the next.
    pub(crate) fn sides(&self) -> impl Iterator<Item = (Vertex, [f64; 2])> {
        let ends = self.vertices.iter().cycle().skip(1);
        let count = self.vertices.len() - usize::from(!self.closed);
        let pairs = self.vertices.iter().zip(ends).take(count);
        pairs.map(|(vertex, end)| (*vertex, end.point))
    }
}

/// A line of text on a layer.
#[derive(Debug, Clone, PartialEq)]
pub struct Text {
    /// The layer.
    pub layer: Layer,
    /// The start of the base line.
    pub at: [f64; 2],
    /// The height of the letters in millimetres.
    pub height: f64,
    /// The direction of the base line in radians, counter-clockwise from the x axis.
    pub angle: f64,
    /// The text, without control characters.
    pub content: String,
}

/// A drawing: paths and texts on layers, notes for whoever opens the file. Lengths are in millimetres, y is
/// up.
///
/// ```
/// use torse_exchange::{Drawing, Layer, dxf, svg};
/// let mut drawing = Drawing::default();
/// drawing.polygon(Layer::Outline, &[[0.0, 0.0], [40.0, 0.0], [40.0, 20.0], [0.0, 20.0]])?;
/// drawing.circle(Layer::Outline, [30.0, 10.0], 4.0)?;
/// drawing.bend([15.0, 0.0], [15.0, 20.0], 0.5)?;
/// drawing.note("bend to 90 degrees first")?;
/// assert_eq!(drawing.paths()[2].layer(), Layer::BendUp);
/// assert_eq!(Drawing::from_dxf(&dxf(&drawing)?)?, drawing);
/// assert!(svg(&drawing)?.contains("<g id=\"BEND_UP\""));
/// # Ok::<(), torse_exchange::ExchangeError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Drawing {
    paths: Vec<Path>,
    texts: Vec<Text>,
    notes: Vec<String>,
    stroke: Option<f64>,
}

/// Vertices nearer to each other than this part of the path's size are one: an apex unrolls to many.
const SAME: f64 = 1e-13;

impl Drawing {
    /// The paths in the order they were added.
    #[must_use]
    pub fn paths(&self) -> &[Path] {
        &self.paths
    }

    /// The texts in the order they were added.
    #[must_use]
    pub fn texts(&self) -> &[Text] {
        &self.texts
    }

    /// The width of all strokes in millimetres; where none was chosen, lines are drawn to be seen.
    #[must_use]
    pub fn stroke_width(&self) -> Option<f64> {
        self.stroke
    }

    /// Chooses the width of all strokes, in millimetres: a cutter takes a hairline for a cut, and wider lines for areas to
    /// engrave. DXF files have no width.
    ///
    /// # Errors
    /// [`ExchangeError::OutOfRange`] unless the width is positive.
    pub fn set_stroke_width(&mut self, width: f64) -> Result<()> {
        check_positive("width of strokes", width)?;
        self.stroke = Some(width);
        Ok(())
    }

    /// The notes in the order they were added.
    #[must_use]
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Adds a path of straight sides and arcs. Neighbouring vertices at one place become one.
    ///
    /// # Errors
    /// [`ExchangeError::NotFinite`], [`ExchangeError::Empty`] when fewer than two places differ.
    pub fn path(&mut self, layer: Layer, vertices: &[Vertex], closed: bool) -> Result<()> {
        self.push(layer, vertices, closed, None)
    }

    /// Adds an open path of straight sides.
    ///
    /// # Errors
    /// As [`Drawing::path`].
    pub fn polyline(&mut self, layer: Layer, points: &[[f64; 2]]) -> Result<()> {
        self.push(layer, &straight(points), false, None)
    }

    /// Adds a closed path of straight sides.
    ///
    /// # Errors
    /// As [`Drawing::path`].
    pub fn polygon(&mut self, layer: Layer, points: &[[f64; 2]]) -> Result<()> {
        self.push(layer, &straight(points), true, None)
    }

    /// Adds a line.
    ///
    /// # Errors
    /// As [`Drawing::path`].
    pub fn line(&mut self, layer: Layer, from: [f64; 2], to: [f64; 2]) -> Result<()> {
        self.push(layer, &straight(&[from, to]), false, None)
    }

    /// Adds a circle, counter-clockwise from the right.
    ///
    /// # Errors
    /// As [`Drawing::path`], and [`ExchangeError::OutOfRange`] unless the radius is positive.
    pub fn circle(&mut self, layer: Layer, [x, y]: [f64; 2], radius: f64) -> Result<()> {
        check_positive("radius", radius)?;
        let half = |x: f64| Vertex {
            point: [x, y],
            bulge: 1.0,
        };
        self.push(layer, &[half(x + radius), half(x - radius)], true, None)
    }

    /// Adds a line at which the sheet is bent by an angle in radians: on [`Layer::BendUp`] when it is
    /// positive, on [`Layer::BendDown`] when negative, on [`Layer::Rulings`] when zero. The angle stays with
    /// the line in the file.
    ///
    /// # Errors
    /// As [`Drawing::path`].
    pub fn bend(&mut self, from: [f64; 2], to: [f64; 2], angle: f64) -> Result<()> {
        let bend = BendLine {
            angle,
            inside_radius: None,
        };
        self.bend_line(from, to, bend)
    }

    /// As [`Drawing::bend`], of a bend that a tool makes over a radius; both stay with the line in the file.
    ///
    /// # Errors
    /// As [`Drawing::path`].
    pub fn bend_line(&mut self, from: [f64; 2], to: [f64; 2], bend: BendLine) -> Result<()> {
        let layer = if bend.angle > 0.0 {
            Layer::BendUp
        } else if bend.angle < 0.0 {
            Layer::BendDown
        } else {
            Layer::Rulings
        };
        self.push(layer, &straight(&[from, to]), false, Some(bend))
    }

    /// Adds a line of text.
    ///
    /// # Errors
    /// [`ExchangeError::NotFinite`], [`ExchangeError::OutOfRange`] unless the height is positive,
    /// [`ExchangeError::BadText`].
    pub fn text(&mut self, text: Text) -> Result<()> {
        let index = self.texts.len();
        let [x, y] = text.at;
        for value in [x, y, text.height, text.angle] {
            check_finite("text", index, value)?;
        }
        check_positive("height of a text", text.height)?;
        check_text(&text.content)?;
        self.texts.push(text);
        Ok(())
    }

    /// Adds a note: a comment in the file, which no reader draws.
    ///
    /// # Errors
    /// [`ExchangeError::BadText`].
    pub fn note(&mut self, note: &str) -> Result<()> {
        check_text(note)?;
        self.notes.push(note.to_owned());
        Ok(())
    }

    /// The corners `[[x, y] least, [x, y] greatest]` of the smallest box around all paths and the starts of
    /// the texts; `None` of an empty drawing.
    #[must_use]
    pub fn bounds(&self) -> Option<[[f64; 2]; 2]> {
        let sides = self.paths.iter().flat_map(Path::sides);
        let reach = sides.flat_map(|(from, to)| {
            let extremes = Arc::from_bulge(from, to).map(|arc| arc.extremes());
            let ends = [from.point, to];
            extremes.into_iter().flatten().chain(ends)
        });
        let all = reach.chain(self.texts.iter().map(|text| text.at));
        all.fold(None, |bounds, p| {
            let [low, high] = bounds.unwrap_or([p, p]);
            let pick = |a: [f64; 2], f: fn(f64, f64) -> f64| [f(a[0], p[0]), f(a[1], p[1])];
            Some([pick(low, f64::min), pick(high, f64::max)])
        })
    }

    /// Adds a path, without the sides of it that have no length.
    pub(crate) fn push(
        &mut self,
        layer: Layer,
        vertices: &[Vertex],
        closed: bool,
        bend: Option<BendLine>,
    ) -> Result<()> {
        let index = self.paths.len();
        for vertex in vertices {
            let [x, y] = vertex.point;
            for value in [x, y, vertex.bulge] {
                check_finite("path", index, value)?;
            }
        }
        if let Some(bend) = bend {
            check_finite("path", index, bend.angle)?;
            check_finite("path", index, bend.inside_radius.unwrap_or(0.0))?;
        }
        let size = vertices.iter().flat_map(|v| v.point);
        let size = size.fold(0.0_f64, |m, x| m.max(x.abs()));
        let same = |a: [f64; 2], b: [f64; 2]| {
            (a[0] - b[0]).abs() <= SAME * size && (a[1] - b[1]).abs() <= SAME * size
        };
        let mut kept: Vec<Vertex> = Vec::with_capacity(vertices.len());
        for vertex in vertices {
            match kept.last_mut() {
                // The side between the two has no length; the next side starts at the later one.
                Some(last) if same(last.point, vertex.point) => last.bulge = vertex.bulge,
                _ => kept.push(*vertex),
            }
        }
        while let [first, _, .., last] = kept.as_slice()
            && closed
            && same(first.point, last.point)
        {
            kept.pop();
        }
        let distinct = match kept.as_slice() {
            [] | [_] => false,
            [a, b] => !same(a.point, b.point),
            _ => true,
        };
        if !distinct {
            let what = "path with two different places";
            return Err(ExchangeError::Empty { what });
        }
        self.paths.push(Path {
            layer,
            vertices: kept,
            closed,
            bend,
        });
        Ok(())
    }
}

fn straight(points: &[[f64; 2]]) -> Vec<Vertex> {
    let straight = |&point: &[f64; 2]| Vertex { point, bulge: 0.0 };
    points.iter().map(straight).collect()
}

fn check_finite(what: &'static str, index: usize, value: f64) -> Result<()> {
    if value.is_finite() {
        return Ok(());
    }
    Err(ExchangeError::NotFinite { what, index, value })
}

fn check_positive(name: &'static str, value: f64) -> Result<()> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    let range = "(0, inf)";
    Err(ExchangeError::OutOfRange { name, value, range })
}

/// Refuses line breaks and other control characters, on which the formats are built.
pub(crate) fn check_text(text: &str) -> Result<()> {
    if text.chars().any(char::is_control) {
        let text = text.to_owned();
        return Err(ExchangeError::BadText { text });
    }
    Ok(())
}
