//! Wavefront OBJ: triangles and polygons; polylines as curves. Free-form curves and surfaces are passed over. The format has no
//! unit.

use super::decimal::{decimal, double};
use super::error::{ReadError, ReadResult, at, refused};
use super::imported::{Imported, PassedOver};
use super::obj_lines::{FREE_FORM, whole_lines};
use super::polygon::{MAX_CONCAVE_CORNERS, triangulated};
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
    let mut lines: Vec<String> = Vec::new();
    let mut triangles: Vec<[u32; 3]> = Vec::new();
    for (line, content) in whole_lines(text) {
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
                lines.push(content.into_owned());
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
                let places: Vec<[f64; 3]> = corners
                    .iter()
                    .filter_map(|k| vertices.get(usize::try_from(*k).ok()?).copied())
                    .collect();
                let polygon = triangulated(&places).ok_or_else(|| ReadError::TooMuch {
                    place: place.clone(),
                    what: "corners of a polygon that is not convex",
                    most: MAX_CONCAVE_CORNERS,
                })?;
                if polygon.crossed {
                    passed.add_at(
                        "order of the corners of a polygon that crosses itself",
                        &place,
                    );
                }
                let triangle = |three: [usize; 3]| three.map(|k| corners[k]);
                triangles.extend(polygon.triangles.into_iter().map(triangle));
            }
            "l" => {
                let mut points: Vec<[Rational; 3]> = Vec::new();
                for word in words {
                    let index = index(word, vertices.len())
                        .ok_or_else(|| at(&place, no_vertex(word, vertices.len())))?;
                    let source = usize::try_from(index).ok().and_then(|k| lines.get(k));
                    let numbers = source.map_or("", String::as_str).split_whitespace().skip(1);
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
            word if FREE_FORM.contains(&word) => passed.add_at("free-form statement", &place),
            word => passed.add_at(word, &place),
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
