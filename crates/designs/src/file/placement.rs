//! Curves that are cut, turned round and moved: the entries `section`, `reversed`, `scale`, `mirror`, `rotate`, `move`,
//! in this order.

use super::keys;
use super::planes::plane;
use super::points::{point, vector};
use super::reader::{Entries, Named, NumberKind, Reader, Value, accepted};
use toml::de::DeValue;
use torse_geometry::AffineMap;
use torse_geometry::prelude::{PiecewiseRail, Point};
use torse_geometry::vector::{cross, dot, scale, sub, unit};

const IDENTITY: [Point; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Returns the curve as these entries place it.
pub fn placed(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    points: &Named<Point>,
    planes: &Named<[f64; 4]>,
    curve: Option<PiecewiseRail>,
) -> Option<PiecewiseRail> {
    let span = entries.span.clone();
    let section = entries.take("section").map(|value| {
        let items = reader.list(value, "numbers", [2, 2])?;
        let both: Vec<_> = items
            .into_iter()
            .map(|item| reader.rational(item, NumberKind::None))
            .collect();
        both.into_iter().collect::<Option<Vec<_>>>()
    });
    let reversed = entries
        .take("reversed")
        .map_or(Some(false), |value| reader.truth(value));
    let mut maps = Vec::new();
    for (key, read) in MAPS {
        if let Some(value) = entries.take(key) {
            maps.push(read(reader, value, points, planes));
        }
    }
    let mut curve = curve?;
    if let Some(section) = section {
        let section = section?;
        if let [from, to] = section.as_slice() {
            curve = accepted(reader, &span, curve.part(from, to))?;
        }
    }
    if reversed? {
        curve = accepted(reader, &span, curve.reversed())?;
    }
    for map in maps {
        curve = accepted(reader, &span, curve.mapped(&map?))?;
    }
    Some(curve)
}

type Read = fn(&mut Reader, Value<'_>, &Named<Point>, &Named<[f64; 4]>) -> Option<AffineMap<f64>>;

/// The maps, in the order in which they act.
const MAPS: [(&str, Read); 4] = [
    ("scale", stretch),
    ("mirror", mirror),
    ("rotate", rotation),
    ("move", shift),
];

/// Returns the map with this linear part that leaves a point where it is.
fn about(fixed: &Point, linear: [Point; 3]) -> AffineMap<f64> {
    let image = linear.map(|row| dot(&row, fixed));
    AffineMap {
        linear,
        shift: sub(fixed, &image),
    }
}

fn stretch(
    reader: &mut Reader,
    value: Value<'_>,
    points: &Named<Point>,
    _: &Named<[f64; 4]>,
) -> Option<AffineMap<f64>> {
    let (factor, fixed) = if let DeValue::Table(_) = value.get_ref() {
        let mut entries = reader.entries(value, "`scale`", keys::SCALE)?;
        let span = entries.span.clone();
        let Some(by) = entries.take("by") else {
            reader.complain(
                &span,
                "`scale` lacks `by`",
                "`scale = 2` or `scale = { about = A, by = 2 }`",
            );
            return None;
        };
        let fixed = entries
            .take("about")
            .map_or(Some([0.0; 3]), |value| point(reader, value, points));
        (factor(reader, by), fixed)
    } else {
        (factor(reader, value), Some([0.0; 3]))
    };
    let factor = factor?;
    Some(about(&fixed?, IDENTITY.map(|row| scale(&factor, &row))))
}

fn factor(reader: &mut Reader, value: Value<'_>) -> Option<f64> {
    reader.number_in(
        value,
        NumberKind::None,
        "(0, infinity); a mirror is `mirror`",
        |f| f > 0.0,
    )
}

/// Returns the mirror image in a plane.
fn mirror(
    reader: &mut Reader,
    value: Value<'_>,
    _: &Named<Point>,
    planes: &Named<[f64; 4]>,
) -> Option<AffineMap<f64>> {
    let span = value.span();
    let [p, q, r, s] = plane(reader, value, planes)?;
    let normal = [p, q, r];
    let square = dot(&normal, &normal);
    if !(square > 0.0 && square.is_finite()) {
        reader.complain(&span, "this plane has no normal", "");
        return None;
    }
    let row = |i: usize| sub(&IDENTITY[i], &scale(&(2.0 * normal[i] / square), &normal));
    Some(AffineMap {
        linear: [row(0), row(1), row(2)],
        shift: scale(&(2.0 * s / square), &normal),
    })
}

/// Returns the turn about an axis by an angle in degrees; quarter turns about the axes of the space are exact.
fn rotation(
    reader: &mut Reader,
    value: Value<'_>,
    points: &Named<Point>,
    _: &Named<[f64; 4]>,
) -> Option<AffineMap<f64>> {
    let mut entries = reader.entries(value, "`rotate`", keys::ROTATE)?;
    let span = entries.span.clone();
    let fixed = entries
        .take("about")
        .map_or(Some([0.0; 3]), |value| point(reader, value, points));
    let axis = entries.take("axis").map_or(Some([0.0, 0.0, 1.0]), |value| {
        reader.numbers(value, [NumberKind::None; 3])
    });
    let Some(angle) = entries.take("angle") else {
        reader.complain(
            &span,
            "`rotate` lacks its `angle`",
            "degrees, positive counter-clockwise",
        );
        return None;
    };
    let degrees = reader.number(angle, NumberKind::None);
    let Some(axis) = unit(&axis?) else {
        reader.complain(&span, "an axis without direction", "");
        return None;
    };
    let degrees = degrees?;
    let (sine, cosine) = match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        angle => (libm::sin(angle.to_radians()), libm::cos(angle.to_radians())),
    };
    // The formula of Rodrigues.
    let column = |e: &Point| -> Point {
        let (along, across) = (dot(&axis, e), cross(&axis, e));
        std::array::from_fn(|k| cosine * e[k] + sine * across[k] + (1.0 - cosine) * along * axis[k])
    };
    let columns = IDENTITY.each_ref().map(column);
    let linear = std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i]));
    Some(about(&fixed?, linear))
}

fn shift(
    reader: &mut Reader,
    value: Value<'_>,
    points: &Named<Point>,
    _: &Named<[f64; 4]>,
) -> Option<AffineMap<f64>> {
    let shift = vector(reader, value, points)?;
    Some(AffineMap {
        linear: IDENTITY,
        shift,
    })
}
