//! Entities of DXF as curves, and the maps of blocks.

use super::groups::Entity;
use crate::read::CurveShape;
use crate::read::error::{ReadResult, at, refused};
use crate::read::svg::document::turned;
use torse_algebra::Rational;
use torse_algebra::rational::integer;
use torse_geometry::curve::{EllipticHelix, EndCondition, Spacing, Spline, interpolate};
use torse_geometry::vector::{add, cross, norm, scale, sub, unit};
use torse_geometry::{AffineMap, Coordinate, GeometryError, exact};

/// The curve that an entity is; nothing for one of another kind. Vertices are those of a polyline.
pub(super) fn curve(
    entity: &Entity<'_, '_>,
    vertices: &[Entity<'_, '_>],
) -> ReadResult<Option<CurveShape>> {
    let place = entity.place();
    let made = match entity.kind {
        "LINE" => CurveShape::line(entity.point(10)?, entity.point(11)?),
        "ARC" | "CIRCLE" => {
            let radius = positive(entity, 40, "a radius")?;
            let range = if entity.kind == "ARC" {
                let [from, to] = [entity.number(50, 0.0)?, entity.number(51, 360.0)?];
                // Counter-clockwise from the first angle to the second.
                let turn = (to - from).rem_euclid(360.0);
                let turn = if turn == 0.0 { 360.0 } else { turn };
                [from / 90.0, (from + turn) / 90.0]
            } else {
                [0.0, 4.0]
            };
            let centre = entity.point(10)?.each_ref().map(Coordinate::approximate);
            let arc = EllipticHelix::new(
                centre,
                [radius, 0.0, 0.0],
                [0.0, radius, 0.0],
                [0.0; 3],
                range,
            );
            let axes = entity_axes(entity)?;
            arc.map(|arc| CurveShape::Arc(arc).mapped(&axes))
        }
        "ELLIPSE" => {
            let number = |p: [Rational; 3]| p.each_ref().map(Coordinate::approximate);
            let (centre, major) = (number(entity.point(10)?), number(entity.point(11)?));
            let normal = extrusion(entity)?;
            let ratio = positive(entity, 40, "a ratio of the axes")?;
            let minor = scale(&ratio, &cross(&normal, &major));
            let turn = std::f64::consts::TAU;
            let [from, to] = [entity.number(41, 0.0)?, entity.number(42, turn)?];
            let width = (to - from).rem_euclid(turn);
            // A whole turn is written as two angles that differ by it, up to the digits of the file.
            let whole = width < 1e-9 || turn - width < 1e-9;
            let quarter = |angle: f64| angle * std::f64::consts::FRAC_2_PI;
            let range = if whole {
                [quarter(from), quarter(from) + 4.0]
            } else {
                [quarter(from), quarter(from + width)]
            };
            EllipticHelix::new(centre, major, minor, [0.0; 3], range).map(CurveShape::Arc)
        }
        "LWPOLYLINE" => {
            let elevation = entity.exacts(38)?.into_iter().next().unwrap_or_default();
            let mut corners: Vec<([Rational; 3], f64)> = Vec::new();
            for group in entity.groups {
                match group.code {
                    10 => corners.push(([exact(0.0), exact(0.0), elevation.clone()], 0.0)),
                    42 => {
                        let bulge = crate::read::decimal::double(group.value);
                        let bulge =
                            bulge.ok_or_else(|| at(&place, "a bulge that is no finite number"))?;
                        if let Some(last) = corners.last_mut() {
                            last.1 = bulge;
                        }
                    }
                    _ => {}
                }
            }
            for (corner, point) in corners.iter_mut().zip(entity.points(10)?) {
                let [x, y, _] = point;
                (corner.0[0], corner.0[1]) = (x, y);
            }
            let axes = entity_axes(entity)?;
            polyline(&corners, entity.whole(70, 0)? & 1 == 1).map(|shape| shape.mapped(&axes))
        }
        "POLYLINE" => {
            let flags = entity.whole(70, 0)?;
            if flags & (16 | 64) != 0 {
                return Ok(None);
            }
            let mut corners = Vec::new();
            for vertex in vertices {
                // Points of the frame of a smoothed polyline are not on it.
                if vertex.whole(70, 0)? & 16 == 0 {
                    corners.push((vertex.point(10)?, vertex.number(42, 0.0)?));
                }
            }
            let in_space = flags & 8 != 0;
            if !in_space {
                let height = elevation(entity, &corners)?;
                for (corner, _) in &mut corners {
                    corner[2] = height.clone();
                }
            }
            let shape = polyline(&corners, flags & 1 == 1);
            if in_space {
                shape
            } else {
                let axes = entity_axes(entity)?;
                shape.map(|shape| shape.mapped(&axes))
            }
        }
        "SPLINE" => spline(entity)?,
        _ => return Ok(None),
    };
    match made {
        // Programs write lines without length: nothing is lost with them.
        Err(GeometryError::Degenerate { .. }) => Ok(None),
        other => other.map(Some).map_err(refused(&place)),
    }
}

/// The height of a polyline that lies in a plane: its own (group 30), which its vertices repeat or leave zero; theirs, where it
/// has none.
fn elevation(entity: &Entity<'_, '_>, corners: &[([Rational; 3], f64)]) -> ReadResult<Rational> {
    let zero = Rational::default();
    let own = entity.exacts(30)?.into_iter().next().unwrap_or_default();
    let mut heights = corners.iter().map(|(corner, _)| &corner[2]);
    let height = if own == zero {
        heights.clone().next().cloned().unwrap_or_default()
    } else {
        own.clone()
    };
    let is_other = |z: &&Rational| **z != height && (own == zero || **z != zero);
    match heights.find(is_other) {
        None => Ok(height),
        Some(other) => Err(at(
            &entity.place(),
            format!(
                "a polyline in a plane has one height, not {} and {} (group 30); one in space has 8 in group 70",
                height.approximate(),
                other.approximate()
            ),
        )),
    }
}

/// A spline by its control points, or through its points where it has none.
fn spline(entity: &Entity<'_, '_>) -> ReadResult<Result<CurveShape, GeometryError>> {
    let place = entity.place();
    let control = entity.points(10)?;
    if control.is_empty() {
        let through = entity.points(11)?;
        if through.len() < 2 {
            return Err(at(
                &place,
                "a SPLINE without control points, and without two points that it goes through",
            ));
        }
        let tangent = |code: i32| -> ReadResult<EndCondition> {
            let found = entity.points(code)?.into_iter().next();
            let found = found.map(|p| p.each_ref().map(Coordinate::approximate));
            Ok(match found {
                Some(direction) if norm(&direction) > 0.0 => EndCondition::Tangent(direction),
                _ => EndCondition::Natural,
            })
        };
        let ends = [tangent(12)?, tangent(13)?];
        if ends == [EndCondition::Natural; 2] {
            return Ok(Ok(CurveShape::Through(through)));
        }
        let points: Vec<[f64; 3]> = through
            .iter()
            .map(|p| p.each_ref().map(Coordinate::approximate))
            .collect();
        return Ok(interpolate(&points, Spacing::Chord, ends)
            .map(|found| CurveShape::Spline(found.spline)));
    }
    let degree =
        usize::try_from(entity.whole(71, 3)?).map_err(|_| at(&place, "a degree below zero"))?;
    let weights = entity.exacts(41)?;
    let one = integer(1);
    let weights = weights.iter().any(|w| *w != one).then_some(weights);
    Ok(Spline::new(degree, entity.exacts(40)?, control, weights).map(CurveShape::Spline))
}

/// A polyline whose sides are straight, or arcs with `bulge` the tangent of a quarter of their angle.
fn polyline(corners: &[([Rational; 3], f64)], closed: bool) -> Result<CurveShape, GeometryError> {
    let mut row = Vec::new();
    let mut straight: Vec<[Rational; 3]> = Vec::new();
    let back = if closed { corners.first() } else { None };
    let ends = corners.iter().skip(1).chain(back);
    for ((from, bulge), (to, _)) in corners.iter().zip(ends) {
        if from == to {
            continue;
        }
        if *bulge == 0.0 {
            if straight.is_empty() {
                straight.push(from.clone());
            }
            straight.push(to.clone());
            continue;
        }
        if !straight.is_empty() {
            row.push(CurveShape::Spline(Spline::polyline(std::mem::take(
                &mut straight,
            ))?));
        }
        let number = |p: &[Rational; 3]| p.each_ref().map(Coordinate::approximate);
        row.push(CurveShape::Arc(flat_arc(number(from), number(to), *bulge)?));
    }
    if !straight.is_empty() {
        row.push(CurveShape::Spline(Spline::polyline(straight)?));
    }
    match row.len() {
        0 => Err(GeometryError::Degenerate {
            what: "a polyline without length",
            at: torse_geometry::Place::Whole,
        }),
        1 => Ok(row.swap_remove(0)),
        _ => Ok(CurveShape::Row(row)),
    }
}

/// The arc between two points at one height, with `bulge = tan(angle / 4)`, positive to the left.
fn flat_arc(from: [f64; 3], to: [f64; 3], bulge: f64) -> Result<EllipticHelix, GeometryError> {
    let chord = sub(&to, &from);
    let rise = (1.0 - bulge * bulge) / (4.0 * bulge);
    let left = [-chord[1], chord[0], 0.0];
    let middle = scale(&0.5, &add(&from, &to));
    let centre = add(&middle, &scale(&rise, &left));
    let [x, y, z] = sub(&from, &centre);
    let quarters = 4.0 * libm::atan(bulge) * std::f64::consts::FRAC_2_PI;
    EllipticHelix::new(centre, [x, y, z], [-y, x, 0.0], [0.0; 3], [0.0, quarters])
}

fn positive(entity: &Entity<'_, '_>, code: i32, what: &str) -> ReadResult<f64> {
    let value = entity.number(code, 0.0)?;
    if value > 0.0 {
        return Ok(value);
    }
    Err(at(&entity.place(), format!("{what} of {value}")))
}

/// The direction that a flat entity is drawn across.
fn extrusion(entity: &Entity<'_, '_>) -> ReadResult<[f64; 3]> {
    let normal = [
        entity.number(210, 0.0)?,
        entity.number(220, 0.0)?,
        entity.number(230, 1.0)?,
    ];
    unit(&normal).ok_or_else(|| at(&entity.place(), "an extrusion without direction"))
}

/// From the coordinates of a flat entity to those of the drawing, by the reference's rule for axes.
pub(super) fn entity_axes(entity: &Entity<'_, '_>) -> ReadResult<AffineMap<Rational>> {
    let normal = extrusion(entity)?;
    let identity = AffineMap::stretch(&integer(1));
    if normal == [0.0, 0.0, 1.0] {
        return Ok(identity);
    }
    let near = normal[0].abs() < 1.0 / 64.0 && normal[1].abs() < 1.0 / 64.0;
    let other = if near {
        [0.0, 1.0, 0.0]
    } else {
        [0.0, 0.0, 1.0]
    };
    let x = unit(&cross(&other, &normal)).unwrap_or([1.0, 0.0, 0.0]);
    let y = cross(&normal, &x);
    let columns = [x, y, normal].map(|column| column.map(exact));
    Ok(AffineMap {
        linear: std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i].clone())),
        shift: identity.shift,
    })
}

/// The map of an inserted block, for one of its copies.
pub(super) fn insert_map(
    entity: &Entity<'_, '_>,
    base: &[Rational; 3],
    [column, row]: [i64; 2],
) -> ReadResult<AffineMap<Rational>> {
    let factor = |code: i32| -> ReadResult<Rational> {
        let value = entity
            .exacts(code)?
            .into_iter()
            .next()
            .unwrap_or(integer(1));
        if value == Rational::default() {
            return Err(at(&entity.place(), "a scale of zero"));
        }
        Ok(value)
    };
    let factors = [factor(41)?, factor(42)?, factor(43)?];
    let (sine, cosine) = turned(entity.number(50, 0.0)?);
    let (sine, cosine) = (exact(sine), exact(cosine));
    let zero = Rational::default;
    let turn = AffineMap {
        linear: [
            [cosine.clone(), -sine.clone(), zero()],
            [sine, cosine, zero()],
            [zero(), zero(), integer(1)],
        ],
        shift: std::array::from_fn(|_| zero()),
    };
    let step = |code: i32, count: i64| -> ReadResult<Rational> {
        Ok(entity.exacts(code)?.into_iter().next().unwrap_or_default() * integer(count))
    };
    let place = [step(44, column)?, step(45, row)?, zero()];
    let stretched = AffineMap {
        linear: std::array::from_fn(|i| {
            std::array::from_fn(|j| if i == j { factors[i].clone() } else { zero() })
        }),
        // The base point goes to the copy's place.
        shift: std::array::from_fn(|i| place[i].clone() - factors[i].clone() * base[i].clone()),
    };
    let mut local = turn.after(&stretched);
    let at = entity.point(10)?;
    for (shift, at) in local.shift.iter_mut().zip(at) {
        *shift = shift.clone() + at;
    }
    Ok(entity_axes(entity)?.after(&local))
}
