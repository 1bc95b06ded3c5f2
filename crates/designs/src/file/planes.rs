//! Planes and families of planes.

use super::joints::joint;
use super::points::{list as point_list, point};
use super::reader::{Entries, Named, NumberKind, Reader, Value, accepted};
use super::shapes::shape;
use super::{MAX_CONTROLS, keys, named};
use toml::de::DeValue;
use torse_geometry::basis::BasisShape;
use torse_geometry::prelude::{Planes, Point};
use torse_geometry::vector::{cross, dot, sub};

/// A plane `p X + q Y + r Z = s`; `s` is a length where `p, q, r` are plain.
const PLANE: [NumberKind; 4] = [
    NumberKind::None,
    NumberKind::None,
    NumberKind::None,
    NumberKind::Length,
];

pub fn planes(
    reader: &mut Reader,
    section: Option<Value<'_>>,
    points: &Named<Point>,
) -> Named<[f64; 4]> {
    named(
        reader,
        section,
        "[planes]",
        |reader, _, value, known| match value.get_ref() {
            DeValue::Table(_) => constructed(reader, value, points),
            _ => plane(reader, value, known),
        },
    )
}

/// Returns a plane: four numbers or a name.
pub fn plane(reader: &mut Reader, value: Value<'_>, known: &Named<[f64; 4]>) -> Option<[f64; 4]> {
    if let DeValue::String(_) = value.get_ref() {
        return reader.named(value, "plane", known).copied();
    }
    reader.numbers(value, PLANE)
}

/// Returns a plane through three points, or through one with a normal.
fn constructed(reader: &mut Reader, value: Value<'_>, points: &Named<Point>) -> Option<[f64; 4]> {
    let mut entries = reader.entries(value, "a plane", keys::PLANE)?;
    let span = entries.span.clone();
    let (normal, at) = if let Some(value) = entries.take("through") {
        let three = point_list(reader, value, points, [3, 3])?;
        let [a, b, c] = three.as_slice() else {
            return None;
        };
        (cross(&sub(b, a), &sub(c, a)), *a)
    } else {
        let (Some(at), Some(normal)) = (entries.take("point"), entries.take("normal")) else {
            let help = "`{ through = [A, B, C] }` or `{ point = A, normal = [p, q, r] }`";
            reader.complain(
                &span,
                "a plane goes through three points, or has a point and a normal",
                help,
            );
            return None;
        };
        let at = point(reader, at, points);
        let normal = reader.numbers(normal, [NumberKind::None; 3]);
        (normal?, at?)
    };
    if normal.iter().all(|c| *c == 0.0) {
        let message = "this plane has no normal: the points are on a line, or the vector is zero";
        reader.complain(&span, message, "");
        return None;
    }
    let [p, q, r] = normal;
    Some([p, q, r, dot(&normal, &at)])
}

/// Returns two planes that cut rulings.
pub fn pair(
    reader: &mut Reader,
    value: Value<'_>,
    known: &Named<[f64; 4]>,
) -> Option<[[f64; 4]; 2]> {
    let items = reader.list(value, "planes", [2, 2])?;
    let both: Vec<_> = items
        .into_iter()
        .map(|item| plane(reader, item, known))
        .collect();
    match both.as_slice() {
        [Some(first), Some(second)] => Some([*first, *second]),
        _ => None,
    }
}

/// Returns a list of control planes.
pub fn list(
    reader: &mut Reader,
    value: Value<'_>,
    known: &Named<[f64; 4]>,
    least: usize,
) -> Option<Vec<[f64; 4]>> {
    let items = reader.list(value, "planes", [least, MAX_CONTROLS])?;
    let all: Vec<_> = items
        .into_iter()
        .map(|item| plane(reader, item, known))
        .collect();
    all.into_iter().collect()
}

pub fn families(
    reader: &mut Reader,
    section: Option<Value<'_>>,
    planes: &Named<[f64; 4]>,
) -> Named<Planes> {
    named(
        reader,
        section,
        "[families]",
        |reader, name, value, known| {
            let what = format!("[families.{name}]");
            let mut entries = reader.entries(value, &what, keys::FAMILY)?;
            family(reader, &mut entries, planes, known)
        },
    )
}

fn family(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    planes: &Named<[f64; 4]>,
    known: &Named<Planes>,
) -> Option<Planes> {
    let (what, span) = (entries.what.clone(), entries.span.clone());
    let shape = shape(reader, entries);
    let made = match (
        entries.take("bernstein"),
        entries.take("gbt"),
        entries.take("continues"),
    ) {
        (Some(value), None, None) => {
            let control = list(reader, value, planes, 3)?;
            Planes::new(BasisShape::Bernstein, &control)
        }
        (None, Some(value), None) => {
            let control = list(reader, value, planes, 3);
            let (control, Some(shape)) = (control?, shape?) else {
                reader.complain(
                    &span,
                    format!("{what} lacks `shape`"),
                    "`shape = [mu, nu]`, both in [-1, 1]",
                );
                return None;
            };
            Planes::new(shape, &control)
        }
        (None, None, Some(value)) => {
            let first = reader.named(value, "family", known)?;
            return continued(reader, entries, first, shape?, planes);
        }
        _ => {
            let help = "control planes: `bernstein = [...]`, or `gbt = [...]` with `shape = [mu, nu]`; or `continues`";
            reader.complain(&span, format!("{what} is made in one of three ways"), help);
            return None;
        }
    };
    accepted(reader, &span, made)
}

/// Returns the family that continues another as the entries `join`, `beta`, `scale` and `free` say.
pub fn continued(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    first: &Planes,
    shape: Option<BasisShape<f64>>,
    planes: &Named<[f64; 4]>,
) -> Option<Planes> {
    let span = entries.span.clone();
    let joint = joint(reader, entries);
    let free = match entries.take("free") {
        Some(value) => list(reader, value, planes, 0),
        None => Some(Vec::new()),
    };
    let shape = shape.unwrap_or(*first.family().curve().basis());
    let next = first.next(shape, &joint?, &free?);
    accepted(reader, &span, next)
}
