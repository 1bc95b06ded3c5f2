//! Points: three lengths, or the name of a point.

use super::named;
use super::reader::{Named, NumberKind, Reader, Value};
use toml::de::DeValue;
use torse_geometry::prelude::Point;

pub fn points(reader: &mut Reader, section: Option<Value<'_>>) -> Named<Point> {
    named(reader, section, "[points]", |reader, _, value, known| {
        point(reader, value, known)
    })
}

/// A point.
pub fn point(reader: &mut Reader, value: Value<'_>, known: &Named<Point>) -> Option<Point> {
    if let DeValue::String(_) = value.get_ref() {
        return reader.named(value, "point", known).copied();
    }
    reader.numbers(value, [NumberKind::Length; 3])
}

/// A list of points, or of vectors that are as long.
pub fn list(
    reader: &mut Reader,
    value: Value<'_>,
    known: &Named<Point>,
    [least, most]: [usize; 2],
) -> Option<Vec<Point>> {
    let items = reader.list(value, "points", [least, most])?;
    let points: Vec<Option<Point>> = items
        .into_iter()
        .map(|item| point(reader, item, known))
        .collect();
    points.into_iter().collect()
}
