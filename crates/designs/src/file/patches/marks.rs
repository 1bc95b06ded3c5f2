//! Marks on a patch: lines, holes, circles and lettering.

use crate::design::Mark;
use crate::file::keys;
use crate::file::reader::{NumberKind, Reader, Value};

/// The most marks of a patch, and points of a line.
const MAX_MARKS: usize = 256;

pub(super) fn marks(reader: &mut Reader, value: Value<'_>) -> Option<Vec<Mark>> {
    let items = reader.list(value, "marks", [0, MAX_MARKS])?;
    let marks: Vec<_> = items.into_iter().map(|item| mark(reader, item)).collect();
    marks.into_iter().collect()
}

fn mark(reader: &mut Reader, value: Value<'_>) -> Option<Mark> {
    let mut entries = reader.entries(value, "a mark", keys::MARK)?;
    let span = entries.span.clone();
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
        let help = "`{ line = [[u, v], ..] }`, `{ at = [u, v], radius = r }` for a hole, or \
                    `{ at = [u, v], text = \"..\", height = h }`";
        reader.complain(&span, "a mark is a line, a hole or a text", help);
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
