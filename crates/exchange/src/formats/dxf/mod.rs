//! DXF: drawings as AutoCAD 2000 (AC1015) text, and back.

mod read;
mod tables;

use crate::drawing::{Drawing, Layer, Path, Text};
use crate::error::{ExchangeError, Result};
use std::fmt::Write;
use tables::Handles;

/// The application name that marks our data in a file.
const APPLICATION: &str = "TORSE";

/// The drawing as DXF of AutoCAD 2000 in millimetres (`$INSUNITS` 4): each path a light-weight polyline with
/// bulges, so that arcs stay arcs, on the layer of its name; texts; notes as comments. The angle of a bend line
/// is extended data of the application `TORSE`: the string `bend` and the angle in radians, then `inside radius` and
/// millimetres where a tool makes it. Numbers are in the
/// shortest form that reads back to the same f64.
///
/// # Errors
/// [`ExchangeError::Empty`] for a drawing without paths.
pub fn dxf(drawing: &Drawing) -> Result<String> {
    let Some(bounds) = drawing.bounds().filter(|_| !drawing.paths().is_empty()) else {
        return Err(ExchangeError::Empty { what: "paths" });
    };
    let mut handles = Handles::default();
    let mut body = Tags::default();
    let space = tables::write(&mut body, &mut handles);
    body.section("ENTITIES");
    for path in drawing.paths() {
        polyline(&mut body, path, &handles.next(), &space);
    }
    for text in drawing.texts() {
        lettering(&mut body, text, &handles.next(), &space);
    }
    body.end_section();
    tables::write_objects(&mut body, &mut handles);

    let mut file = Tags::default();
    for note in drawing.notes() {
        file.tag(999, escaped(note));
    }
    file.section("HEADER");
    file.tag(9, "$ACADVER").tag(1, "AC1015");
    file.tag(9, "$INSUNITS").tag(70, 4);
    file.tag(9, "$MEASUREMENT").tag(70, 1);
    for (name, [x, y]) in [("$EXTMIN", bounds[0]), ("$EXTMAX", bounds[1])] {
        file.tag(9, name)
            .number(10, x)
            .number(20, y)
            .number(30, 0.0);
    }
    file.tag(9, "$HANDSEED").tag(5, handles.next());
    file.end_section();
    Ok(file.text + &body.text + "0\nEOF\n")
}

fn polyline(tags: &mut Tags, path: &Path, handle: &str, space: &str) {
    tags.entity("LWPOLYLINE", handle, space, path.layer());
    tags.tag(100, "AcDbPolyline");
    tags.tag(90, path.vertices().len());
    tags.tag(70, u8::from(path.is_closed()));
    for vertex in path.vertices() {
        let [x, y] = vertex.point;
        tags.number(10, x).number(20, y);
        if vertex.bulge != 0.0 {
            tags.number(42, vertex.bulge);
        }
    }
    if let Some(angle) = path.bend() {
        tags.tag(1001, APPLICATION).tag(1000, "bend");
        tags.number(1040, angle);
        if let Some(radius) = path.inside_radius() {
            tags.tag(1000, "inside radius").number(1040, radius);
        }
    }
}

fn lettering(tags: &mut Tags, text: &Text, handle: &str, space: &str) {
    let [x, y] = text.at;
    tags.entity("TEXT", handle, space, text.layer);
    tags.tag(100, "AcDbText");
    tags.number(10, x).number(20, y).number(30, 0.0);
    tags.number(40, text.height);
    tags.tag(1, escaped(&text.content));
    // The format has degrees only; the exact angle is ours.
    tags.number(50, text.angle.to_degrees());
    tags.tag(100, "AcDbText");
    tags.tag(1001, APPLICATION).tag(1000, "angle");
    tags.number(1040, text.angle);
}

/// Text in ASCII: other characters as `\U+XXXX`, in UTF-16 as the format wants them. What
/// begins a code of the format is written likewise.
fn escaped(text: &str) -> String {
    let mut ascii = String::with_capacity(text.len());
    for c in text.chars() {
        if c.is_ascii() && !"\\^%".contains(c) {
            ascii.push(c);
        } else {
            for unit in c.encode_utf16(&mut [0; 2]) {
                let _ = write!(ascii, "\\U+{unit:04X}");
            }
        }
    }
    ascii
}

/// Group codes and values, one a line.
#[derive(Default)]
struct Tags {
    text: String,
}

impl Tags {
    fn tag(&mut self, code: u16, value: impl std::fmt::Display) -> &mut Self {
        // Writing to a String cannot fail.
        let _ = writeln!(self.text, "{code}\n{value}");
        self
    }

    /// A number, without a negative zero.
    fn number(&mut self, code: u16, value: f64) -> &mut Self {
        self.tag(code, value + 0.0)
    }

    fn section(&mut self, name: &str) {
        self.tag(0, "SECTION").tag(2, name);
    }

    fn end_section(&mut self) {
        self.tag(0, "ENDSEC");
    }

    fn entity(&mut self, kind: &str, handle: &str, space: &str, layer: Layer) {
        self.tag(0, kind).tag(5, handle).tag(330, space);
        self.tag(100, "AcDbEntity").tag(8, layer.name());
    }
}
