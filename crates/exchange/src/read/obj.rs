//! Wavefront OBJ: triangles and polygons, which are fanned; polylines as curves. The format has no unit.

use super::decimal::{decimal, double};
use super::error::{ReadError, ReadResult, at, refused};
use super::imported::{Imported, PassedOver};
use super::{CurveShape, Drafts, FileKind, FilePlace, LengthUnit, check_unit};
use crate::mesh::{MAX_VERTICES, Mesh};
use torse_algebra::Rational;
use torse_geometry::Coordinate;
use torse_geometry::curve::Spline;

pub(super) fn read(name: &str, text: &str, given: Option<&LengthUnit>) -> ReadResult<Imported> {
    let unit = check_unit(None, given)?;
    let millimetres = unit.unit().millimetres().clone();
    let factor = millimetres.approximate();
    let mut drafts = Drafts::new(&unit);
    let mut passed = PassedOver::default();
    let mut vertices: Vec<[f64; 3]> = Vec::new();
    // The text of the vertices, for polylines, whose corners are exact.
    let mut lines: Vec<&str> = Vec::new();
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for (line, content) in (1..).zip(text.lines()) {
        let mut words = content.split_whitespace();
        let word = words.next().unwrap_or("#");
        let place = FilePlace::entity(
            line,
            format!("`{}`", word.chars().take(20).collect::<String>()),
        );
        match word {
            "v" => {
                let mut vertex = [0.0; 3];
                for slot in &mut vertex {
                    let value = words.next().and_then(double);
                    *slot = value.ok_or_else(|| at(&place, "a vertex has three finite numbers"))?
                        * factor;
                }
                if vertices.len() >= MAX_VERTICES {
                    return Err(ReadError::TooMuch {
                        place,
                        what: "vertices",
                        most: MAX_VERTICES,
                    });
                }
                vertices.push(vertex);
                lines.push(content);
            }
            "f" => {
                let mut corners = Vec::new();
                for word in words {
                    corners.push(
                        index(word, vertices.len())
                            .ok_or_else(|| at(&place, no_vertex(word, vertices.len())))?,
                    );
                }
                if corners.len() < 3 {
                    return Err(at(&place, "a face has three vertices at least"));
                }
                for pair in corners.windows(2).skip(1) {
                    triangles.push([corners[0], pair[0], pair[1]]);
                }
            }
            "l" => {
                let mut points: Vec<[Rational; 3]> = Vec::new();
                for word in words {
                    let index = index(word, vertices.len())
                        .ok_or_else(|| at(&place, no_vertex(word, vertices.len())))?;
                    let source = usize::try_from(index).ok().and_then(|k| lines.get(k));
                    let numbers = source.map_or("", |line| *line).split_whitespace().skip(1);
                    let numbers: Vec<Rational> = numbers
                        .take(3)
                        .filter_map(decimal)
                        .map(|n| n * millimetres.clone())
                        .collect();
                    let point = <[Rational; 3]>::try_from(numbers);
                    points.push(
                        point.map_err(|_| at(&place, "a vertex with a number that is too long"))?,
                    );
                }
                points.dedup();
                if points.len() < 2 {
                    return Err(at(&place, "a line has two places at least"));
                }
                let shape = Spline::polyline(points).map_err(refused(&place))?;
                drafts.curve("line", place, CurveShape::Spline(shape))?;
            }
            "#" | "vn" | "vt" | "o" | "g" | "s" | "mtllib" | "usemtl" => {}
            word if word.starts_with('#') => {}
            word => passed.add(word),
        }
    }
    if !triangles.is_empty() {
        let place = FilePlace::default();
        let mesh = Mesh::new(vertices, triangles).map_err(|error| at(&place, error.to_string()))?;
        if !mesh.triangles().is_empty() {
            drafts.mesh(name, place, mesh);
        }
    }
    drafts.finish(FileKind::Obj, None, passed)
}

/// The vertex that `7`, `7/1/2` or, counted from the last, `-1` names.
fn index(word: &str, count: usize) -> Option<u32> {
    let number: i64 = word.split('/').next()?.parse().ok()?;
    let count = i64::try_from(count).ok()?;
    let index = if number < 0 {
        count + number
    } else {
        number - 1
    };
    if !(0..count).contains(&index) {
        return None;
    }
    u32::try_from(index).ok()
}

fn no_vertex(word: &str, count: usize) -> String {
    let word: String = word.chars().take(20).collect();
    format!("there is no vertex `{word}` among the {count} above")
}
