//! Marks on a patch: lines, holes, circles, lettering and openings.

use crate::design::{Mark, MarkedOpening, NamedCurve, ParameterSide};
use crate::file::points::vector;
use crate::file::reader::{Entries, NumberKind, Reader, Value, accepted};
use crate::file::{Parts, keys};
use toml::de::DeValue;
use torse_geometry::vector::{norm, sub};

/// The most marks of a patch, and points of a line.
const MAX_MARKS: usize = 256;

/// Ends of a curve that are farther apart than this share of it do not close it.
const CLOSED: f64 = 1e-6;

pub(super) fn marks(reader: &mut Reader, value: Value<'_>, parts: &Parts) -> Option<Vec<Mark>> {
    let items = reader.list(value, "marks", [0, MAX_MARKS])?;
    let marks: Vec<_> = items
        .into_iter()
        .map(|item| mark(reader, item, parts))
        .collect();
    marks.into_iter().collect()
}

fn mark(reader: &mut Reader, value: Value<'_>, parts: &Parts) -> Option<Mark> {
    let mut entries = reader.entries(value, "a mark", keys::MARK)?;
    let span = entries.span.clone();
    if entries.has("opening") || entries.has("passes") {
        return opening(reader, &mut entries, parts).map(Mark::Opening);
    }
    if let Some(value) = entries.take("line") {
        let items = reader.list(value, "places", [2, MAX_MARKS])?;
        let places: Vec<_> = items.into_iter().map(|item| place(reader, item)).collect();
        return places.into_iter().collect::<Option<_>>().map(Mark::Line);
    }
    let length = |reader: &mut Reader, value| {
        reader.number_in(value, NumberKind::Length, "(0, infinity)", |r| r > 0.0)
    };
    let at = entries.take("at").map(|value| place(reader, value));
    let (Some(at), true) = (at, entries.has("radius") != entries.has("text")) else {
        let help = "`{ line = [[u, v], ..] }`, `{ at = [u, v], radius = r }` for a hole, \
                    `{ at = [u, v], text = \"..\", height = h }`, `{ opening = \"CURVE\", at = [u, v] }` or \
                    `{ passes = \"PATCH\" }`";
        reader.complain(
            &span,
            "a mark is a line, a hole, a text or an opening",
            help,
        );
        return None;
    };
    if let Some(value) = entries.take("radius") {
        let radius = length(reader, value);
        let cut = entries
            .take("hole")
            .map_or(Some(true), |value| reader.truth(value));
        return Some(match cut? {
            true => Mark::Hole(at?, radius?),
            false => Mark::Circle(at?, radius?),
        });
    }
    let (text, place) = reader.text(entries.take("text")?, "a text")?;
    if text.chars().any(char::is_control) || text.is_empty() || text.len() > 200 {
        reader.complain(&place, "a mark is one line of 1 to 200 bytes", "");
        return None;
    }
    let height = entries
        .take("height")
        .map_or(Some(5.0), |value| length(reader, value));
    let angle = entries
        .take("angle")
        .map_or(Some(0.0), |value| reader.number(value, NumberKind::None));
    Some(Mark::Text(at?, text, height?, angle?.to_radians()))
}

/// Returns an opening of any shape.
fn opening(reader: &mut Reader, entries: &mut Entries<'_>, parts: &Parts) -> Option<MarkedOpening> {
    let span = entries.span.clone();
    let (shape, passes) = (entries.take("opening"), entries.take("passes"));
    let at = entries.take("at");
    let turned = entries.take("angle");
    let along = entries.take("along");
    let mut wrong = |message: &str, help: &str| {
        reader.complain(&span, message, help);
        None
    };
    if let Some(key) = keys::MARK.iter().find(|key| entries.has(key)) {
        return wrong(&format!("`{key}` means nothing for an opening"), "");
    }
    let shape = match (shape, passes) {
        (Some(shape), None) => shape,
        (None, Some(name)) => {
            if at.is_some() || turned.is_some() || along.is_some() {
                return wrong("what passes through has no place of its own", "");
            }
            let (name, place) = reader.text(name, "the name of a patch or a chain")?;
            let patches = Vec::new();
            return Some(MarkedOpening::Passed {
                name,
                place,
                patches,
            });
        }
        _ => return wrong("`opening` and `passes` exclude each other", ""),
    };
    let is_polygon = matches!(shape.get_ref(), DeValue::Array(_));
    if turned.is_some() && at.is_none() {
        return wrong("`angle` wants `at`", "");
    }
    if at.is_some() && along.is_some() || is_polygon && (at.is_some() || along.is_some()) {
        let help = "a curve has `at` (on the sheet), `along` (thrown on it) or neither (it lies on it), a polygon \
                    `[[u, v], ..]` none of them";
        return wrong("an opening is placed in one way", help);
    }
    if is_polygon {
        let items = reader.list(shape, "places", [3, MAX_MARKS])?;
        let places: Vec<_> = items.into_iter().map(|item| place(reader, item)).collect();
        let places: Vec<[f64; 2]> = places.into_iter().collect::<Option<_>>()?;
        let next = places.iter().cycle().skip(1);
        let sides = places.iter().zip(next).map(|(from, to)| ParameterSide {
            after: 0,
            ends: [*from, *to],
        });
        return Some(MarkedOpening::OnParameters(sides.collect()));
    }
    let (name, place_of_name) = reader.text(shape, "the name of a curve")?;
    let curve = reader
        .find(&name, &place_of_name, "curve", &parts.curves)?
        .clone();
    let gap = curve.point(0.0).and_then(|start| {
        let end = curve.point(1.0)?;
        let length = curve.length(1e-3)?;
        Ok((norm(&sub(&end, &start)).max(curve.gap()?), length))
    });
    let (gap, length) = accepted(reader, &place_of_name, gap)?;
    if gap > CLOSED * length {
        let message = format!("`{name}` does not close: its ends are {gap:.4} mm apart");
        reader.complain(&place_of_name, message, "an opening is a closed curve");
        return None;
    }
    let curve = NamedCurve { name, curve };
    let Some(at) = at else {
        let along = match along {
            None => None,
            Some(value) => {
                let place = value.span();
                let along = vector(reader, value, &parts.points)?;
                if norm(&along) == 0.0 {
                    reader.complain(&place, "a direction has a length", "");
                    return None;
                }
                Some(along)
            }
        };
        return Some(MarkedOpening::InSpace { curve, along });
    };
    let rails = accepted(reader, &place_of_name, curve.curve.rails())?;
    for rail in &rails {
        let [low, high] = accepted(reader, &place_of_name, rail.bounding_box(1e-6 * length))?;
        if high[2].max(-low[2]) > CLOSED * length {
            let message = format!("`{}` does not lie in the plane z = 0", curve.name);
            let help = "on the sheet x and y are lengths from the place `at`, x along the ruling";
            reader.complain(&place_of_name, message, help);
            return None;
        }
    }
    let angle = turned.map_or(Some(0.0), |value| reader.number(value, NumberKind::None));
    Some(MarkedOpening::OnSheet {
        curve,
        at: place(reader, at)?,
        angle: angle?.to_radians(),
    })
}

/// Returns a place `[u, v]` on a patch.
fn place(reader: &mut Reader, value: Value<'_>) -> Option<[f64; 2]> {
    let span = value.span();
    let [u, v] = reader.numbers(value, [NumberKind::None; 2])?;
    if [u, v].iter().all(|c| (0.0..=1.0).contains(c)) {
        return Some([u, v]);
    }
    let help = "u goes from ruling to ruling, v along them, both from 0 to 1";
    reader.complain(&span, format!("[{u}, {v}] is outside the patch"), help);
    None
}
