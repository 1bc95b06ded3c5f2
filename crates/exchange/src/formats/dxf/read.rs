//! Our own DXF files read back: notes, and polylines, lines and texts on our layers. What is on other layers
//! or of other kinds is passed over.

use super::APPLICATION;
use crate::drawing::{BendLine, Drawing, Layer, Text, Vertex};
use crate::error::{ExchangeError, Result};
use crate::read::dxf::unit_of;
use torse_geometry::Coordinate;
use torse_geometry::vector::unit;

impl Drawing {
    /// The drawing in a DXF file, in the unit of its `$INSUNITS`, in millimetres where it states none: light-weight
    /// polylines, lines and texts on the layers of [`Layer`] with the bend angles that [`dxf`](crate::dxf) writes, and
    /// the comments as notes. Polylines and texts that are drawn across `(0, 0, -1)`, as mirroring leaves them, are seen
    /// from the other side. Entities on other layers and of other kinds are passed over.
    ///
    /// # Errors
    /// [`ExchangeError::Unreadable`] with the line for text that is not pairs of group code and value, a
    /// number that is none, or an entity that is not drawn in the plane of x and y, and what [`Drawing::path`] and
    /// [`Drawing::text`] refuse.
    pub fn from_dxf(text: &str) -> Result<Self> {
        let mut drawing = Self::default();
        let mut entity: Option<Entity> = None;
        let mut inside = false;
        let mut pending = false;
        let mut header = "";
        let mut factor = 1.0;
        let mut lines = text.lines().zip(1..);
        while let Some((code, line)) = lines.next() {
            let bad = |what| ExchangeError::Unreadable { line, what };
            let code: u16 = code.trim().parse().map_err(|_| bad("no group code"))?;
            let (value, line) = lines.next().ok_or_else(|| bad("no value"))?;
            match (code, value.trim()) {
                (999, _) => drawing.note(&unescaped(value))?,
                (9, name) => header = name,
                (70, number) if header == "$INSUNITS" => {
                    header = "";
                    let number = number.parse().map_err(|_| bad("no whole number"))?;
                    let unit = unit_of(number).map_err(|_| bad("no unit of length"))?;
                    factor = unit.map_or(1.0, |unit| unit.millimetres().approximate());
                }
                (0, kind) => {
                    if let Some(done) = entity.take() {
                        done.add_to(&mut drawing, factor)?;
                    }
                    pending = kind == "SECTION";
                    inside = inside && kind != "ENDSEC";
                    if inside {
                        entity = Entity::new(kind, line);
                    }
                }
                (2, name) if pending => inside = name == "ENTITIES",
                (code, trimmed) => {
                    if let Some(entity) = &mut entity {
                        entity.take(code, value, trimmed, line)?;
                    }
                }
            }
        }
        if let Some(done) = entity.take() {
            done.add_to(&mut drawing, factor)?;
        }
        Ok(drawing)
    }
}

/// A direction that is beside the z-axis by no more, as a share of its length, is along it.
const UPRIGHT: f64 = 1e-9;

#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Polyline,
    Line,
    Text,
}

/// An entity while its groups come in.
struct Entity {
    kind: Kind,
    line: usize,
    layer: Option<Layer>,
    vertices: Vec<Vertex>,
    closed: bool,
    height: f64,
    degrees: f64,
    /// The direction that it is drawn across.
    extrusion: [f64; 3],
    content: String,
    /// The application whose extended data is being read, the name of the next number there, and ours.
    application: String,
    name: String,
    bend: Option<f64>,
    radius: Option<f64>,
    angle: Option<f64>,
}

impl Entity {
    fn new(kind: &str, line: usize) -> Option<Self> {
        let kind = match kind {
            "LWPOLYLINE" => Kind::Polyline,
            "LINE" => Kind::Line,
            "TEXT" => Kind::Text,
            _ => return None,
        };
        Some(Self {
            kind,
            line,
            layer: None,
            vertices: Vec::new(),
            closed: false,
            height: 0.0,
            degrees: 0.0,
            extrusion: [0.0, 0.0, 1.0],
            content: String::new(),
            application: String::new(),
            name: String::new(),
            bend: None,
            radius: None,
            angle: None,
        })
    }

    fn take(&mut self, code: u16, value: &str, trimmed: &str, line: usize) -> Result<()> {
        let number = || -> Result<f64> {
            let what = "no number";
            let bad = |_| ExchangeError::Unreadable { line, what };
            trimmed.parse().map_err(bad)
        };
        match code {
            8 => self.layer = Layer::named(trimmed),
            70 if self.kind == Kind::Polyline => {
                // The first bit says closed.
                self.closed = number()?.rem_euclid(2.0) >= 1.0;
            }
            10 | 11 => self.vertices.push(Vertex {
                point: [number()?, 0.0],
                bulge: 0.0,
            }),
            20 | 21 | 42 => {
                let value = number()?;
                if let Some(last) = self.vertices.last_mut() {
                    if code == 42 {
                        last.bulge = value;
                    } else {
                        last.point[1] = value;
                    }
                }
            }
            40 => self.height = number()?,
            50 => self.degrees = number()?,
            210 => self.extrusion[0] = number()?,
            220 => self.extrusion[1] = number()?,
            230 => self.extrusion[2] = number()?,
            1 => self.content = unescaped(value),
            1001 => trimmed.clone_into(&mut self.application),
            1000 => trimmed.clone_into(&mut self.name),
            1040 if self.application == APPLICATION => match self.name.as_str() {
                "bend" => self.bend = Some(number()?),
                "inside radius" => self.radius = Some(number()?),
                "angle" => self.angle = Some(number()?),
                _ => {}
            },
            _ => {}
        }
        Ok(())
    }

    /// Returns whether it is drawn across `(0, 0, -1)`.
    fn is_mirrored(&self) -> Result<bool> {
        let across = unit(&self.extrusion).filter(|[x, y, _]| libm::hypot(*x, *y) <= UPRIGHT);
        let [_, _, up] = across.ok_or(ExchangeError::Unreadable {
            line: self.line,
            what: "an entity that is not drawn in the plane of x and y",
        })?;
        Ok(up < 0.0)
    }

    fn add_to(mut self, drawing: &mut Drawing, factor: f64) -> Result<()> {
        let Some(layer) = self.layer else {
            return Ok(());
        };
        // The ends of a line are in the coordinates of the drawing, whatever its direction.
        let mirrored = self.kind != Kind::Line && self.is_mirrored()?;
        for vertex in &mut self.vertices {
            vertex.point = vertex.point.map(|c| c * factor);
            if mirrored {
                // By the rule for axes of Autodesk's reference x is turned round and y is not.
                vertex.point[0] = -vertex.point[0];
                vertex.bulge = -vertex.bulge;
            }
        }
        if self.kind != Kind::Text {
            let bend = self.bend.map(|angle| BendLine {
                angle,
                inside_radius: self.radius.map(|radius| radius * factor),
            });
            return drawing.push(layer, &self.vertices, self.closed, bend);
        }
        let unplaced = ExchangeError::Unreadable {
            line: self.line,
            what: "a text without a place",
        };
        let at = self.vertices.first().ok_or(unplaced)?.point;
        let angle = self.angle.unwrap_or(self.degrees.to_radians());
        drawing.text(Text {
            layer,
            at,
            height: self.height * factor,
            angle: if mirrored {
                std::f64::consts::PI - angle
            } else {
                angle
            },
            content: self.content,
        })
    }
}

/// Text with `\U+XXXX` made characters again.
fn unescaped(text: &str) -> String {
    let mut units = Vec::with_capacity(text.len());
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let code = rest.strip_prefix("\\U+").and_then(|tail| tail.get(..4));
        let unit = code.and_then(|digits| u16::from_str_radix(digits, 16).ok());
        let used = match unit {
            Some(unit) => {
                units.push(unit);
                7
            }
            None => {
                units.extend_from_slice(first.encode_utf16(&mut [0; 2]));
                first.len_utf8()
            }
        };
        rest = rest.get(used..).unwrap_or_default();
    }
    String::from_utf16_lossy(&units)
}
