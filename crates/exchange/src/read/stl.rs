//! STL, text or binary. The format has no unit; corners at one place are one vertex.

use super::decimal::double;
use super::error::{ReadError, ReadResult, at, at_line};
use super::imported::{Imported, PassedOver};
use super::{Drafts, FileKind, FilePlace, LengthUnit, check_unit};
use crate::mesh::{MAX_VERTICES, Mesh};
use std::collections::HashMap;
use torse_geometry::Coordinate;

pub(super) fn read(name: &str, bytes: &[u8], given: Option<&LengthUnit>) -> ReadResult<Imported> {
    let unit = check_unit(None, given)?;
    let factor = unit.unit().millimetres().approximate();
    let mut corners = Corners::default();
    let whole = bytes.get(80..84).and_then(|b| <[u8; 4]>::try_from(b).ok());
    let count = whole.map_or(0, |b| u64::from(u32::from_le_bytes(b)));
    if u64::try_from(bytes.len()) == Ok(84 + 50 * count) {
        binary(bytes.get(84..).unwrap_or_default(), &mut corners)?;
    } else if bytes.contains(&0) || !begins_as_text(bytes) {
        let reason = format!(
            "a binary STL of {count} facets has {} bytes, and this file {}: it ends in the middle, or is none",
            84 + 50 * count,
            bytes.len()
        );
        return Err(at(&FilePlace::default(), reason));
    } else {
        ascii(&String::from_utf8_lossy(bytes), &mut corners)?;
    }
    let vertices: Vec<[f64; 3]> = corners
        .vertices
        .iter()
        .map(|v| v.map(|c| c * factor))
        .collect();
    let place = FilePlace::default();
    let mesh =
        Mesh::new(vertices, corners.triangles).map_err(|error| at(&place, error.to_string()))?;
    let mut drafts = Drafts::new(&unit);
    if !mesh.triangles().is_empty() {
        drafts.mesh(name, place, mesh);
    }
    drafts.finish(FileKind::Stl, None, PassedOver::default())
}

/// Returns whether it begins with the word of an STL in text, in letters of either size.
fn begins_as_text(bytes: &[u8]) -> bool {
    let word = b"solid";
    let first = bytes.trim_ascii_start().get(..word.len());
    first.is_some_and(|first| first.eq_ignore_ascii_case(word))
}

/// Vertices, each once, and triangles.
#[derive(Default)]
struct Corners {
    vertices: Vec<[f64; 3]>,
    triangles: Vec<[u32; 3]>,
    known: HashMap<[u64; 3], u32>,
    open: Vec<u32>,
}

impl Corners {
    fn add(&mut self, place: &FilePlace, corner: [f64; 3]) -> ReadResult<()> {
        if corner.iter().any(|c| !c.is_finite()) {
            return Err(at(place, "a corner has three finite numbers"));
        }
        // Plus zero: no negative zero.
        let key = corner.map(|c| (c + 0.0).to_bits());
        let fresh = u32::try_from(self.vertices.len()).unwrap_or(u32::MAX);
        let index = *self.known.entry(key).or_insert(fresh);
        if index == fresh {
            if self.vertices.len() >= MAX_VERTICES {
                return Err(ReadError::TooMuch {
                    place: place.clone(),
                    what: "vertices",
                    most: MAX_VERTICES,
                });
            }
            self.vertices.push(corner);
        }
        self.open.push(index);
        if let [a, b, c] = self.open[..] {
            self.triangles.push([a, b, c]);
            self.open.clear();
        }
        Ok(())
    }
}

fn binary(bytes: &[u8], corners: &mut Corners) -> ReadResult<()> {
    for (facet, chunk) in bytes.chunks_exact(50).enumerate() {
        let place = FilePlace {
            line: None,
            entity: Some(format!("facet {}", facet + 1)),
        };
        for corner in chunk.get(12..48).unwrap_or_default().chunks_exact(12) {
            let number = |k: usize| {
                let word = corner
                    .get(4 * k..4 * k + 4)
                    .and_then(|b| <[u8; 4]>::try_from(b).ok());
                f64::from(word.map_or(f32::NAN, f32::from_le_bytes))
            };
            corners.add(&place, [number(0), number(1), number(2)])?;
        }
    }
    Ok(())
}

fn ascii(text: &str, corners: &mut Corners) -> ReadResult<()> {
    let mut ended = false;
    for (line, content) in (1..).zip(text.lines()) {
        let mut words = content.split_whitespace();
        // Some programs write the words in capitals.
        let word = words.next().unwrap_or_default().to_ascii_lowercase();
        match word.as_str() {
            "vertex" => {
                let mut corner = [0.0; 3];
                for slot in &mut corner {
                    let value = words.next().and_then(double);
                    *slot =
                        value.ok_or_else(|| at_line(line, "a corner has three finite numbers"))?;
                }
                corners.add(&FilePlace::line(line), corner)?;
            }
            "endloop" if !corners.open.is_empty() => {
                return Err(at_line(line, "a facet has three corners"));
            }
            "endsolid" => ended = true,
            "" | "solid" | "facet" | "outer" | "endloop" | "endfacet" => {}
            _ => return Err(at_line(line, "a word that STL does not have")),
        }
    }
    if !ended || !corners.open.is_empty() {
        return Err(at_line(
            text.lines().count().max(1),
            "the file ends in the middle",
        ));
    }
    Ok(())
}
