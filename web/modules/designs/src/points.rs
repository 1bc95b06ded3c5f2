//! The points of a design that a page lets its user drag: where they are, and where their numbers stand in the text.

use serde::Serialize;
use std::collections::BTreeMap;
use torse::Design;

/// A point with coordinates of its own.
#[derive(Serialize)]
pub struct DraggablePoint {
    /// Its name, or that of what it belongs to with its number there.
    name: String,
    /// In millimetres.
    at: [f64; 3],
    /// From where to where each coordinate stands in the text, in 16-bit units, as scripts count.
    places: [[usize; 2]; 3],
    /// Whether each is a number: only these are dragged.
    plain: [bool; 3],
}

/// More points are listed by nobody.
const MAX_POINTS: usize = 400;

/// The points in the order of the text.
pub fn draggable(design: &Design, text: &str) -> Vec<DraggablePoint> {
    let mut points: Vec<_> = design.parts().points.iter().take(MAX_POINTS).collect();
    points.sort_by_key(|point| point.places[0].start);
    let mut units = Units::new(text);
    let mut names = BTreeMap::new();
    let listed = points.into_iter().map(|point| DraggablePoint {
        name: {
            let name = match point.number {
                0 => point.name.clone(),
                number => format!("{} {number}", point.name),
            };
            // A curve and a patch may have one name.
            let count: &mut usize = names.entry(name.clone()).or_default();
            *count += 1;
            match *count {
                1 => name,
                count => format!("{name} ({count})"),
            }
        },
        at: point.at,
        places: point
            .places
            .each_ref()
            .map(|place| [units.before(place.start), units.before(place.end)]),
        plain: point.plain,
    });
    listed.collect()
}

/// Counts 16-bit units up to bytes that come in order.
struct Units<'t> {
    rest: &'t str,
    byte: usize,
    units: usize,
}

impl<'t> Units<'t> {
    fn new(text: &'t str) -> Self {
        Self {
            rest: text,
            byte: 0,
            units: 0,
        }
    }

    fn before(&mut self, byte: usize) -> usize {
        let step = byte.saturating_sub(self.byte);
        if let Some((passed, rest)) = self.rest.split_at_checked(step) {
            self.units += passed.encode_utf16().count();
            self.byte += step;
            self.rest = rest;
        }
        self.units
    }
}
