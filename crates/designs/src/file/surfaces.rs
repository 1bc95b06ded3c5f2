//! Surfaces that are no developables: tensor products, given by their nets or made from curves.

use super::curves::single;
use super::points::list;
use super::reader::{Entries, Named, NumberKind, Reader, Value, accepted};
use super::shapes::shape_of;
use super::{MAX_CONTROLS, Parts, keys, named};
use crate::design::{FreeSurface, Tensor};
use torse_geometry::basis::BasisShape;
use torse_geometry::prelude::{GeometryError, PiecewiseRail, Place, Point, Rail};
use torse_geometry::sheet::RailCurve;
use torse_geometry::{Curve, TensorSurface};

/// The ways to make a surface.
const KINDS: [&str; 5] = ["net", "bilinear", "swung", "swept", "rotation"];

type SpaceCurve = Curve<BasisShape<f64>, f64, 3>;
type PlaneCurve = Curve<BasisShape<f64>, f64, 2>;

pub fn surfaces(
    reader: &mut Reader,
    section: Option<Value<'_>>,
    parts: &Parts,
) -> Named<FreeSurface> {
    named(reader, section, "[surfaces]", |reader, name, value, _| {
        let what = format!("[surfaces.{name}]");
        let mut entries = reader.entries(value, &what, keys::SURFACE)?;
        surface(reader, name, &mut entries, parts)
    })
}

fn surface(
    reader: &mut Reader,
    name: &str,
    entries: &mut Entries<'_>,
    parts: &Parts,
) -> Option<FreeSurface> {
    let (what, span) = (entries.what.clone(), entries.span.clone());
    let mut given = KINDS.iter().filter(|kind| entries.has(kind));
    let (Some(kind), None) = (given.next().copied(), given.next()) else {
        let help = format!("one of `{}`", KINDS.join("`, `"));
        reader.complain(&span, format!("{what} is made in one of five ways"), &help);
        return None;
    };
    let value = entries.take(kind)?;
    let place = value.span();
    let made = match kind {
        "net" => {
            let [u, v] = ["shape-u", "shape-v"].map(|key| match entries.take(key) {
                Some(value) => shape_of(reader, value),
                None => Some(BasisShape::Bernstein),
            });
            let rows = reader.list(value, "rows of points", [2, MAX_CONTROLS])?;
            let rows: Vec<_> = rows
                .into_iter()
                .map(|row| list(reader, row, &parts.points, [2, MAX_CONTROLS]))
                .collect();
            let net = rows.into_iter().collect::<Option<Vec<_>>>()?;
            TensorSurface::new(u?, v?, net).map(|surface| vec![surface])
        }
        "bilinear" => {
            let corners = list(reader, value, &parts.points, [4, 4]);
            let [u, v] = ["shape-u", "shape-v"].map(|key| match entries.take(key) {
                Some(value) => shape_of(reader, value),
                None => Some(BasisShape::Bernstein),
            });
            let degrees = match entries.take("degrees") {
                Some(value) => degrees(reader, value),
                None => Some((3, 3)),
            };
            let interior = match entries.take("interior") {
                Some(value) => list(reader, value, &parts.points, [0, MAX_CONTROLS]),
                None => Some(Vec::new()),
            };
            let [a, b, c, d]: [Point; 4] = corners?.try_into().ok()?;
            let corners = [[a, b], [c, d]];
            TensorSurface::bilinear(u?, v?, degrees?, &corners, &interior?)
                .map(|surface| vec![surface])
        }
        "rotation" => {
            let profile = single(reader, value, &parts.curves)?;
            turned(&profile)
        }
        _ => {
            let [first, second] = curves(reader, value, &parts.curves)?;
            let factor = match entries.take("factor") {
                Some(value) if kind == "swung" => {
                    let positive = |factor| factor > 0.0;
                    reader.number_in(value, NumberKind::None, "(0, infinity)", positive)?
                }
                Some(value) => {
                    reader.complain(&value.span(), "only what is swung has a `factor`", "");
                    return None;
                }
                None => 1.0,
            };
            let matrices = match entries.take("matrices") {
                Some(value) if kind == "swept" => Some(matrices(reader, value)?),
                Some(value) => {
                    reader.complain(&value.span(), "only what is swept has `matrices`", "");
                    return None;
                }
                None => None,
            };
            let made = match (kind, matrices) {
                ("swung", _) => swung(&first, &second, factor),
                (_, None) => swept(&first, &second),
                (_, Some(matrices)) => swept_by(&first, &second, &matrices),
            };
            made.map(|surface| vec![surface])
        }
    };
    for key in keys::SURFACE {
        if let Some(value) = entries.take(key) {
            let message = format!("`{key}` means nothing for a surface made by `{kind}`");
            reader.complain(&value.span(), message, "");
        }
    }
    Some(FreeSurface {
        name: name.to_owned(),
        kind,
        parts: accepted(reader, &place, made)?,
    })
}

/// Returns the degrees of a net in both directions.
fn degrees(reader: &mut Reader, value: Value<'_>) -> Option<(usize, usize)> {
    let place = value.span();
    let both = reader.numbers(value, [NumberKind::None; 2])?;
    let whole = |d: &f64| *d >= 1.0 && d.fract() == 0.0 && *d <= 24.0;
    if !both.iter().all(whole) {
        let message = format!("{both:?} are no degrees");
        reader.complain(&place, message, "two whole numbers from 1 to 24");
        return None;
    }
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
    let [m, n] = both.map(|d| d as usize);
    Some((m, n))
}

type Matrix = [[f64; 3]; 3];

/// Matrices by their rows.
fn matrices(reader: &mut Reader, value: Value<'_>) -> Option<Vec<Matrix>> {
    let items = reader.list(value, "matrices", [1, MAX_CONTROLS])?;
    let matrix = |reader: &mut Reader, item: Value<'_>| -> Option<Matrix> {
        let rows = reader.list(item, "rows of a matrix", [3, 3])?;
        let rows: Vec<_> = rows
            .into_iter()
            .map(|row| reader.numbers(row, [NumberKind::None; 3]))
            .collect();
        let rows = rows.into_iter().collect::<Option<Vec<_>>>()?;
        rows.try_into().ok()
    };
    let all: Vec<_> = items.into_iter().map(|item| matrix(reader, item)).collect();
    all.into_iter().collect()
}

fn curves(
    reader: &mut Reader,
    value: Value<'_>,
    known: &Named<PiecewiseRail>,
) -> Option<[Rail; 2]> {
    let items = reader.list(value, "curves", [2, 2])?;
    let mut both = items.into_iter().map(|item| single(reader, item, known));
    match (both.next()?, both.next()?) {
        (Some(first), Some(second)) => Some([first, second]),
        _ => None,
    }
}

/// Returns a curve without weights: tensor products have none.
fn plain(rail: &Rail) -> Result<&SpaceCurve, GeometryError> {
    match rail.curve() {
        RailCurve::Plain(curve) => Ok(curve),
        RailCurve::Weighted(_) => Err(GeometryError::Degenerate {
            what: "tensor product of a weighted curve",
            at: Place::Whole,
        }),
        RailCurve::Elliptic(_) => Err(GeometryError::Degenerate {
            what: "tensor product of an arc of any angle: it has no control points",
            at: Place::Whole,
        }),
    }
}

/// Returns two coordinates of a curve.
fn flat(rail: &Rail, [i, j]: [usize; 2]) -> Result<PlaneCurve, GeometryError> {
    Ok(plain(rail)?.mapped(|p| [p[i], p[j]]))
}

/// Returns a profile `[x, z]` that swings along a trajectory `[x, y]`.
fn swung(profile: &Rail, trajectory: &Rail, factor: f64) -> Result<Tensor, GeometryError> {
    TensorSurface::swung(&flat(profile, [0, 2])?, &flat(trajectory, [0, 1])?, &factor)
}

fn swept(section: &Rail, trajectory: &Rail) -> Result<Tensor, GeometryError> {
    TensorSurface::swept(plain(section)?, plain(trajectory)?)
}

fn swept_by(
    section: &Rail,
    trajectory: &Rail,
    matrices: &[Matrix],
) -> Result<Tensor, GeometryError> {
    TensorSurface::swept_by(plain(section)?, plain(trajectory)?, matrices)
}

/// Returns a profile `[x, z]` turned about the z axis: a tensor product for each quarter.
fn turned(profile: &Rail) -> Result<Vec<Tensor>, GeometryError> {
    let quarters = TensorSurface::quarter_turns(&flat(profile, [0, 2])?)?;
    let plain = quarters.iter().map(|quarter| {
        let (u, v) = quarter.bases();
        let net = quarter.rows().map(<[_]>::to_vec).collect();
        TensorSurface::new(*u, BasisShape::from(*v), net)
    });
    plain.collect()
}
