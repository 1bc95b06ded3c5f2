//! Space curves.

use super::joints::joint;
use super::points::{list, point};
use super::reader::{Dimension, Entries, Named, Reader, Value, accepted};
use super::{MOST_CONTROLS, keys, named};
use toml::de::DeValue;
use torse_geometry::basis::Shape;
use torse_geometry::prelude::{Point, Rail};

pub fn curves(
    reader: &mut Reader,
    section: Option<Value<'_>>,
    points: &Named<Point>,
) -> Named<Rail> {
    named(reader, section, "[curves]", |reader, name, value, known| {
        let what = format!("[curves.{name}]");
        let mut entries = reader.entries(value, &what, keys::CURVE)?;
        curve(reader, &mut entries, points, known)
    })
}

fn curve(
    reader: &mut Reader,
    entries: &mut Entries<'_>,
    points: &Named<Point>,
    known: &Named<Rail>,
) -> Option<Rail> {
    let (what, span) = (entries.what.clone(), entries.span.clone());
    let shape = shape(reader, entries)?;
    let weights = match entries.take("weights") {
        Some(value) => Some(weights(reader, value)?),
        None => None,
    };
    let kinds = ["bezier", "gbt", "hermite", "arc", "continues"];
    let mut given = kinds.iter().filter(|kind| entries.has(kind));
    let (Some(kind), None) = (given.next().copied(), given.next()) else {
        let help = format!("one of `{}`", kinds.join("`, `"));
        reader.complain(&span, format!("{what} is made in one of five ways"), &help);
        return None;
    };
    let value = entries.take(kind)?;
    let unweighted = ["hermite", "arc", "continues"].contains(&kind);
    if weights.is_some() && unweighted {
        reader.complain(&span, format!("`{kind}` has no weights"), "");
        return None;
    }
    let made = match kind {
        "bezier" | "gbt" => {
            let control = list(reader, value, points, [2, MOST_CONTROLS])?;
            let shape = match (kind, shape) {
                ("bezier", None) => Shape::Bernstein,
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
            match weights {
                None => Rail::new(shape, &control),
                Some(weights) => Rail::weighted(shape, &control, &weights),
            }
        }
        "hermite" => Rail::hermite(&list(reader, value, points, [4, 6])?),
        "arc" => {
            let mut arc = reader.entries(value, "an arc", keys::ARC)?;
            let mut ends = ["centre", "from", "to"]
                .map(|key| arc.take(key))
                .into_iter();
            let mut next = || match ends.next().flatten() {
                Some(value) => point(reader, value, points),
                None => {
                    let help =
                        "`arc = { centre = .., from = .., to = .. }`, the quarter of an ellipse";
                    reader.complain(&arc.span, "an arc has a centre and two ends", help);
                    None
                }
            };
            let (centre, from, to) = (next()?, next()?, next()?);
            Rail::ellipse_arc(centre, from, to)
        }
        _ => {
            let first = reader.named(value, "curve", known)?;
            let joint = joint(reader, entries);
            let free = match entries.take("free") {
                Some(value) => list(reader, value, points, [0, MOST_CONTROLS]),
                None => Some(Vec::new()),
            };
            let shape = shape.unwrap_or(match first.curve() {
                torse_geometry::sheet::RailCurve::Plain(curve) => *curve.basis(),
                torse_geometry::sheet::RailCurve::Weighted(curve) => *curve.basis(),
                torse_geometry::sheet::RailCurve::Elliptic(_) => Shape::Bernstein,
            });
            first.next(shape, &joint?, &free?)
        }
    };
    accepted(reader, &span, made)
}

/// The shape parameters, if any; `None` when they are wrong.
#[allow(clippy::option_option, reason = "wrong is not missing")]
pub fn shape(reader: &mut Reader, entries: &mut Entries<'_>) -> Option<Option<Shape<f64>>> {
    match entries.take("shape") {
        Some(value) => shape_of(reader, value).map(Some),
        None => Some(None),
    }
}

/// Shape parameters, or the word for none.
pub fn shape_of(reader: &mut Reader, value: Value<'_>) -> Option<Shape<f64>> {
    if let DeValue::String(word) = value.get_ref()
        && word == "bernstein"
    {
        return Some(Shape::Bernstein);
    }
    let span = value.span();
    let [mu, nu] = reader.numbers(value, [Dimension::None; 2])?;
    accepted(reader, &span, Shape::gbt(mu, nu))
}

fn weights(reader: &mut Reader, value: Value<'_>) -> Option<Vec<f64>> {
    let items = reader.list(value, "weights", [2, MOST_CONTROLS])?;
    let all: Vec<_> = items
        .into_iter()
        .map(|item| reader.number_in(item, Dimension::None, "(0, infinity)", |w| w > 0.0))
        .collect();
    all.into_iter().collect()
}
