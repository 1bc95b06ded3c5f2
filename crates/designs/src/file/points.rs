//! Points: three lengths, or the name of a point.

use super::named;
use super::reader::{Named, NumberKind, Reader, Value};
use std::ops::Range;
use toml::Spanned;
use toml::de::DeValue;
use torse_geometry::Coordinate;
use torse_geometry::prelude::Point;
use torse_numbers::rational::Rational;

pub fn points(reader: &mut Reader, section: Option<Value<'_>>) -> Named<Point> {
    let known = named(reader, section, "[points]", |reader, _, value, known| {
        point(reader, value, known)
    });
    // Each has a name of its own.
    for point in &mut reader.placed {
        point.number = 0;
    }
    known
}

/// A point; the place of one that stands here with its coordinates is kept.
pub fn point(reader: &mut Reader, value: Value<'_>, known: &Named<Point>) -> Option<Point> {
    let places = places(&value);
    let at = vector(reader, value, known)?;
    if let Some((places, plain)) = places {
        reader.place_point(at, places, plain);
    }
    Some(at)
}

/// A vector, three lengths; or the name of a point.
pub fn vector(reader: &mut Reader, value: Value<'_>, known: &Named<Point>) -> Option<Point> {
    if let DeValue::String(_) = value.get_ref() {
        return reader.named(value, "point", known).copied();
    }
    reader.numbers(value, [NumberKind::Length; 3])
}

/// Where the coordinates of a point stand in the text, and which of them are numbers; nothing for a name.
pub fn places(value: &Value<'_>) -> Option<([Range<usize>; 3], [bool; 3])> {
    let DeValue::Array(items) = value.get_ref() else {
        return None;
    };
    let places: Vec<Range<usize>> = items.iter().map(Spanned::span).collect();
    let is_number =
        |item: &Value<'_>| matches!(item.get_ref(), DeValue::Integer(_) | DeValue::Float(_));
    let plain: Vec<bool> = items.iter().map(is_number).collect();
    Some((places.try_into().ok()?, plain.try_into().ok()?))
}

/// A list of vectors, or of points among them.
pub fn vectors(
    reader: &mut Reader,
    value: Value<'_>,
    known: &Named<Point>,
    [least, most]: [usize; 2],
) -> Option<Vec<Point>> {
    let items = reader.list(value, "points", [least, most])?;
    let all: Vec<Option<Point>> = items
        .into_iter()
        .map(|item| vector(reader, item, known))
        .collect();
    all.into_iter().collect()
}

/// A list of points.
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

/// A list of points with exact coordinates, in millimetres.
pub fn exact_list(
    reader: &mut Reader,
    value: Value<'_>,
    known: &Named<Point>,
    [least, most]: [usize; 2],
) -> Option<Vec<[Rational; 3]>> {
    let items = reader.list(value, "points", [least, most])?;
    let points: Vec<Option<[Rational; 3]>> = items
        .into_iter()
        .map(|item| match item.get_ref() {
            DeValue::String(_) => point(reader, item, known).map(|p| p.map(torse_geometry::exact)),
            _ => {
                let places = places(&item);
                let coordinates = reader.list(item, "numbers", [3, 3])?;
                let all: Vec<_> = coordinates
                    .into_iter()
                    .map(|c| reader.rational(c, NumberKind::Length))
                    .collect();
                let all: Vec<Rational> = all.into_iter().collect::<Option<_>>()?;
                let exact: [Rational; 3] = all.try_into().ok()?;
                let at = exact.each_ref().map(Coordinate::approximate);
                if let Some((places, plain)) = places {
                    reader.place_point(at, places, plain);
                }
                Some(exact)
            }
        })
        .collect();
    points.into_iter().collect()
}
