//! Hermite cones.

use super::raw::UntrimmedSurface;
use crate::file::Parts;
use crate::file::planes::plane;
use crate::file::points::{point, vector, vectors};
use crate::file::reader::{Entries, NumberKind, Reader, Value, accepted};
use torse_geometry::developable::{
    HermiteCone, QuarticData, QuinticData, oblique_image_as_printed,
};
use torse_geometry::prelude::{Point, Rail, Sheet, SweptEdge};

/// Returns a Hermite cone between parallel planes, or cut by an oblique one.
pub(super) fn hermite(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    data: &mut Entries<'_>,
    parts: &Parts,
) -> Option<UntrimmedSurface> {
    let span = data.span.clone();
    let degree = data.take("degree").map_or(Some(3.0), |value| {
        reader.number_in(value, NumberKind::None, "{3, 4, 5}", |d| {
            [3.0, 4.0, 5.0].contains(&d)
        })
    })?;
    let tension = data.take("tension");
    let printed = data
        .take("as-printed")
        .map_or(Some(false), |value| reader.truth(value))?;
    let mut missing = |reader: &mut Reader, key: &str| {
        let value = data.take(key);
        if value.is_none() {
            let message = format!("a Hermite cone of degree {degree} lacks `{key}`");
            reader.complain(&span, message, "");
        }
        value
    };
    let ratio = missing(reader, "ratio").and_then(|value| reader.number(value, NumberKind::None));
    let one = |reader: &mut Reader, value: Option<Value<'_>>| vector(reader, value?, &parts.points);
    let two = |reader: &mut Reader, value: Option<Value<'_>>| -> Option<[Point; 2]> {
        let points = vectors(reader, value?, &parts.points, [2, 2])?;
        points.try_into().ok()
    };
    let tension = match tension {
        Some(value) => reader.numbers(value, [NumberKind::None; 2])?,
        None => [1.0; 2],
    };
    let tensed = |tangents: [Point; 2]| {
        let [k1, k2] = tension;
        let [first, last] = tangents;
        [first.map(|c| k1 * c), last.map(|c| k2 * c)]
    };
    let cone = if degree == 3.0 {
        let summit = missing(reader, "summit").and_then(|v| point(reader, v, &parts.points));
        let q = missing(reader, "q").and_then(|v| vectors(reader, v, &parts.points, [4, 4]));
        let [from, to, first, last]: [Point; 4] = q?.try_into().ok()?;
        let [first, last] = tensed([first, last]);
        HermiteCone::cubic(summit?, ratio?, [from, to, first, last])
    } else {
        let value = missing(reader, "p-start");
        let p_start = one(reader, value);
        let value = missing(reader, "p-middle");
        let p_middle = one(reader, value);
        let value = missing(reader, "q-ends");
        let q_ends = two(reader, value);
        let value = missing(reader, "q-tangents");
        let q_tangents = two(reader, value);
        let tangent = if degree == 5.0 {
            let value = missing(reader, "p-middle-tangent");
            Some(one(reader, value)?)
        } else {
            None
        };
        let quartic = QuarticData {
            p_start: p_start?,
            p_middle: p_middle?,
            q_ends: q_ends?,
            q_tangents: tensed(q_tangents?),
        };
        match tangent {
            None => HermiteCone::quartic(ratio?, quartic),
            Some(p_middle_tangent) => HermiteCone::quintic(
                ratio?,
                QuinticData {
                    quartic,
                    p_middle_tangent,
                },
            ),
        }
    };
    let cone = accepted(reader, &span, cone)?;
    let q = accepted(reader, &span, Rail::hermite(&cone.q))?;
    if printed {
        let Some(value) = entries.take("between") else {
            reader.complain(&span, "`as-printed` needs a plane `between`", "");
            return None;
        };
        let cut = plane(reader, value, &parts.planes)?;
        let data = accepted(reader, &span, oblique_image_as_printed(&cone, &cut))?;
        let edge = accepted(reader, &span, Rail::hermite(&data))?;
        return Some(UntrimmedSurface::between(edge, q));
    }
    // From the curve p, the image of q in the ratio of the cone, or from the image of q in an oblique plane.
    let other = match entries.take("between") {
        Some(value) => SweptEdge::Cut(plane(reader, value, &parts.planes)?),
        None => SweptEdge::Share(1.0 / cone.ratio),
    };
    let sheet = Sheet::cone(&q, cone.summit, [other, SweptEdge::Share(1.0)]);
    accepted(reader, &span, sheet.and_then(UntrimmedSurface::swept))
}
