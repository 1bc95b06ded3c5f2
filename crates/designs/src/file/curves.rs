//! Space curves.

use super::imports::Imports;
use super::joints::joint;
use super::points::{exact_list, list, point, vector, vectors};
use super::reader::{Entries, Named, NumberKind, Reader, Value, accepted};
use super::shapes::shape;
use super::{MAX_CONTROLS, keys, named, placement, splines};
use std::ops::Range;
use torse_geometry::Coordinate;
use torse_geometry::basis::BasisShape;
use torse_geometry::curve::EllipticHelix;
use torse_geometry::prelude::{PiecewiseRail, Point, Rail};
use torse_geometry::vector::{norm, sub};
use torse_numbers::rational::Rational;

/// The ways to make a curve.
const KINDS: [&str; 11] = [
    "bezier",
    "gbt",
    "hermite",
    "arc",
    "continues",
    "spline",
    "through",
    "polyline",
    "row",
    "import",
    "copy",
];

pub fn curves(
    reader: &mut Reader,
    section: Option<Value<'_>>,
    points: &Named<Point>,
    planes: &Named<[f64; 4]>,
    imports: &mut Imports<'_>,
) -> Named<PiecewiseRail> {
    named(reader, section, "[curves]", |reader, name, value, known| {
        let what = format!("[curves.{name}]");
        let mut entries = reader.entries(value, &what, keys::CURVE)?;
        let span = entries.span.clone();
        let made = curve(reader, &mut entries, points, known, imports);
        let placed = placement::placed(reader, &mut entries, points, planes, made);
        for key in keys::CURVE {
            if let Some(value) = entries.take(key) {
                let message = format!("`{key}` means nothing for this curve");
                reader.complain(&value.span(), message, "");
            }
        }
        let placed = placed?;
        // What left the range of f64 is refused here, once.
        accepted(reader, &span, placed.point(0.5))?;
        Some(placed)
    })
}

fn curve(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    points: &Named<Point>,
    known: &Named<PiecewiseRail>,
    imports: &mut Imports<'_>,
) -> Option<PiecewiseRail> {
    let (what, span) = (entries.what.clone(), entries.span.clone());
    let shape = shape(reader, entries)?;
    let weights = match entries.take("weights") {
        Some(value) => Some(weights(reader, value)?),
        None => None,
    };
    let mut given = KINDS.iter().filter(|kind| entries.has(kind));
    let (Some(kind), None) = (given.next().copied(), given.next()) else {
        let help = format!("one of `{}`", KINDS.join("`, `"));
        reader.complain(
            &span,
            format!("{what} is made in one of eleven ways"),
            &help,
        );
        return None;
    };
    let value = entries.take(kind)?;
    if weights.is_some() && !["bezier", "gbt"].contains(&kind) {
        reader.complain(&span, format!("`{kind}` has no weights"), "");
        return None;
    }
    if shape.is_some() && !["bezier", "gbt", "continues"].contains(&kind) {
        reader.complain(&span, format!("`{kind}` has no `shape`"), "");
        return None;
    }
    let place = value.span();
    let made = match kind {
        "bezier" | "gbt" => {
            let control = exact_list(reader, value, points, [2, MAX_CONTROLS])?;
            let shape = match (kind, shape) {
                ("bezier", None) => BasisShape::Bernstein,
                ("gbt", Some(shape)) => shape,
                ("gbt", None) => {
                    let help = "`shape = [mu, nu]`, both in [-1, 1]";
                    reader.complain(&span, format!("{what} lacks `shape`"), help);
                    return None;
                }
                _ => {
                    let help = "with shape parameters it is `gbt = [...]`";
                    reader.complain(&span, "a Bezier curve has no `shape`", help);
                    return None;
                }
            };
            Rail::exact(shape, &control, weights.as_deref())
        }
        "hermite" => Rail::hermite(&vectors(reader, value, points, [4, 6])?),
        "arc" => arc(reader, value, points)?,
        "continues" => {
            let first = single(reader, value, known)?;
            let joint = joint(reader, entries);
            let free = match entries.take("free") {
                Some(value) => list(reader, value, points, [0, MAX_CONTROLS]),
                None => Some(Vec::new()),
            };
            let shape = shape.unwrap_or(match first.curve() {
                torse_geometry::sheet::RailCurve::Plain(curve) => *curve.basis(),
                torse_geometry::sheet::RailCurve::Weighted(curve) => *curve.basis(),
                torse_geometry::sheet::RailCurve::Elliptic(_) => BasisShape::Bernstein,
            });
            first.next(shape, &joint?, &free?)
        }
        "spline" => return splines::spline(reader, value, points),
        "through" => return splines::through(reader, entries, value, points),
        "polyline" => return splines::polyline(reader, value, points),
        "row" => return row(reader, value, known),
        "import" => return imports.curve(reader, entries, value, points),
        _ => return reader.named(value, "curve", known).cloned(),
    };
    accepted(reader, &place, made).map(PiecewiseRail::from)
}

/// Returns a quarter of an ellipse, a part of one, or an arc about an axis that may climb.
fn arc(
    reader: &mut Reader,
    value: Value<'_>,
    points: &Named<Point>,
) -> Option<Result<Rail, torse_geometry::GeometryError>> {
    let mut arc = reader.entries(value, "an arc", keys::ARC)?;
    let span = arc.span.clone();
    let mut one =
        |reader: &mut Reader, key: &str| arc.take(key).map(|value| point(reader, value, points));
    let (centre, from, to, axis) = (
        one(reader, "centre"),
        one(reader, "from"),
        one(reader, "to"),
        arc.take("axis").map(|value| vector(reader, value, points)),
    );
    let mut number = |reader: &mut Reader, key: &str, dimension| {
        arc.take(key).map(|value| reader.number(value, dimension))
    };
    let (angle, climb) = (
        number(reader, "angle", NumberKind::None),
        number(reader, "climb", NumberKind::Length),
    );
    let (Some(centre), Some(from), true) = (centre, from, to.is_some() != axis.is_some()) else {
        let help = "`arc = { centre = .., from = .., to = .. }`, the quarter of an ellipse, a part of it with `angle`; or \
                    `{ centre, from, axis, angle }`, an arc of a circle";
        reader.complain(
            &span,
            "an arc has a centre and two ends, or a centre, a start and an axis",
            help,
        );
        return None;
    };
    let (centre, from) = (centre?, from?);
    let angle = match angle {
        Some(angle) => Some(angle?),
        None => None,
    };
    let climb = match climb {
        Some(climb) => climb?,
        None => 0.0,
    };
    match (to, axis) {
        (Some(to), _) => {
            let to = to?;
            if climb != 0.0 {
                reader.complain(&span, "`climb` goes with `axis`", "");
                return None;
            }
            Some(match angle {
                None => Rail::ellipse_arc(centre, from, to),
                Some(degrees) => {
                    let [cosine, sine] = [sub(&from, &centre), sub(&to, &centre)];
                    EllipticHelix::new(centre, cosine, sine, [0.0; 3], [0.0, degrees / 90.0])
                        .map(Rail::from)
                }
            })
        }
        (None, axis) => {
            let Some(degrees) = angle else {
                reader.complain(
                    &span,
                    "an arc about an axis lacks its `angle`",
                    "degrees, positive counter-clockwise",
                );
                return None;
            };
            Some(EllipticHelix::about(centre, axis??, from, degrees, climb).map(Rail::from))
        }
    }
}

/// Curves one after the other, which must meet.
fn row(
    reader: &mut Reader,
    value: Value<'_>,
    known: &Named<PiecewiseRail>,
) -> Option<PiecewiseRail> {
    let place = value.span();
    let items = reader.list(value, "curves", [1, super::MAX_THINGS])?;
    let parts: Vec<_> = items
        .into_iter()
        .map(|item| reader.named(item, "curve", known).cloned())
        .collect();
    let parts: Vec<PiecewiseRail> = parts.into_iter().collect::<Option<_>>()?;
    for (index, pair) in parts.windows(2).enumerate() {
        let (end, start) = (
            accepted(reader, &place, pair[0].point(1.0))?,
            accepted(reader, &place, pair[1].point(0.0))?,
        );
        let gap = norm(&sub(&end, &start));
        let size = end
            .iter()
            .chain(&start)
            .fold(1.0_f64, |m, c| m.max(c.abs()));
        if gap > 1e-9 * size {
            let message = format!(
                "curves {} and {} of this row do not meet: {gap:.6} mm apart",
                index + 1,
                index + 2
            );
            reader.complain(
                &place,
                message,
                "with `copy` and `reversed = true` a curve runs the other way",
            );
            return None;
        }
    }
    accepted(reader, &place, PiecewiseRail::joined(&parts))
}

/// Returns a curve of one piece.
pub fn single(reader: &mut Reader, value: Value<'_>, known: &Named<PiecewiseRail>) -> Option<Rail> {
    let place = value.span();
    let curve = reader.named(value, "curve", known)?;
    one_piece(reader, &place, curve)
}

/// Returns the only piece of a curve; a mistake where there are several.
pub fn one_piece(reader: &mut Reader, place: &Range<usize>, curve: &PiecewiseRail) -> Option<Rail> {
    let rail = accepted(reader, place, curve.single())?;
    if rail.is_none() {
        let message = format!(
            "this curve has {} pieces, and one of a single piece is wanted here",
            curve.count()
        );
        reader.complain(place, message, "");
    }
    rail
}

fn weights(reader: &mut Reader, value: Value<'_>) -> Option<Vec<Rational>> {
    let items = reader.list(value, "weights", [2, MAX_CONTROLS])?;
    let all: Vec<_> = items
        .into_iter()
        .map(|item| {
            let span = item.span();
            let weight = reader.rational(item, NumberKind::None)?;
            let near = weight.approximate();
            if near > 0.0 {
                return Some(weight);
            }
            reader.complain(&span, format!("{near} is outside (0, infinity)"), "");
            None
        })
        .collect();
    all.into_iter().collect()
}
