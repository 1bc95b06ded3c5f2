//! Cylinders and cones over a curve.

use crate::file::Parts;
use crate::file::planes::pair;
use crate::file::points::{point, vector};
use crate::file::reader::{Entries, NumberKind, Reader};
use torse_geometry::prelude::{GeometryError, Point, Rail, Sheet, SweptEdge};

/// A surface of straight lines from a curve to its image: along a direction, or through an apex.
pub(super) struct Sweep {
    /// What gives the lines: key, what is said without it, and what would be right.
    pub by: [&'static str; 3],
    /// Where the surface begins and ends unless the file says so.
    pub whole: [f64; 2],
    /// The sheet between two edges.
    pub sheet: fn(&Rail, Point, [SweptEdge; 2]) -> Result<Sheet, GeometryError>,
}

pub(super) const CYLINDER: Sweep = Sweep {
    by: [
        "direction",
        "a cylinder lacks its `direction`",
        "a vector: `direction = [0, 0, 100]`",
    ],
    whole: [0.0, 1.0],
    sheet: Sheet::cylinder,
};

pub(super) const CONE: Sweep = Sweep {
    by: [
        "apex",
        "a cone lacks its `apex`",
        "a point: `apex = [0, 0, 100]`",
    ],
    whole: [1.0, 0.0],
    sheet: Sheet::cone,
};

/// The lines of a cone or a cylinder, and where they end.
pub(super) struct Swept {
    pub lines: Point,
    pub edges: [SweptEdge; 2],
}

pub(super) fn swept(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    parts: &Parts,
    sweep: &Sweep,
) -> Option<Swept> {
    let span = entries.span.clone();
    let [key, lacking, help] = sweep.by;
    let Some(lines) = entries.take(key) else {
        reader.complain(&span, lacking, help);
        return None;
    };
    let lines = match key {
        "apex" => point(reader, lines, &parts.points),
        _ => vector(reader, lines, &parts.points),
    };
    let edges = stretch(reader, entries, parts, sweep.whole);
    Some(Swept {
        lines: lines?,
        edges: edges?,
    })
}

fn stretch(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    parts: &Parts,
    usual: [f64; 2],
) -> Option<[SweptEdge; 2]> {
    match (entries.take("range"), entries.take("between")) {
        (None, None) => Some(usual.map(SweptEdge::Share)),
        (Some(value), None) => {
            let place = value.span();
            let [from, to] = reader.numbers(value, [NumberKind::None; 2])?;
            if from == to {
                reader.complain(
                    &place,
                    format!("[{from}, {to}] is no range"),
                    "its ends differ",
                );
                return None;
            }
            Some([from, to].map(SweptEdge::Share))
        }
        (None, Some(value)) => {
            pair(reader, value, &parts.planes).map(|planes| planes.map(SweptEdge::Cut))
        }
        (Some(value), Some(_)) => {
            reader.complain(
                &value.span(),
                "`range` and `between` exclude each other",
                "",
            );
            None
        }
    }
}
