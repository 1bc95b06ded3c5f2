//! IGES 5: curves, surfaces, and surfaces that are trimmed.
//!
//! Read are arcs (100), composite curves (102), linear paths (106), planes (108), lines (110), ruled surfaces (118),
//! surfaces of revolution (120), tabulated cylinders (122), B-spline curves and surfaces (126, 128), trimmed and bounded
//! surfaces (141 to 144), with their matrices (124). Entities that are only part of others are read where these use them.
//! A seam, which a loop of the format has as two curves, is one edge that is passed twice, as STEP has it.

mod own_borders;
mod records;
mod seams;

use super::error::{ReadError, ReadResult, at, refused};
use super::imported::{Imported, PassedOver};
use super::trim::{Base, Trim, between};
use super::turned::turned;
use super::{
    CurveShape, Drafts, FaceBorder, FileKind, ImportedFace, LengthUnit, SplineSurface,
    SurfaceFrame, SurfaceShape, check_unit,
};
use records::{Entity, File, parse};
use seams::seams;
use std::cell::Cell;
use torse_algebra::Rational;
use torse_algebra::rational::ratio;
use torse_geometry::curve::{EllipticHelix, MAX_SPLINE_POINTS, Spline};
use torse_geometry::vector::{sub, unit};
use torse_geometry::{AffineMap, Coordinate};

/// How deep entities point to entities.
const MAX_DEPTH: usize = 24;

pub(super) fn read(text: &str, given: Option<&LengthUnit>) -> ReadResult<Imported> {
    let file = parse(text)?;
    let unit = check_unit(stated(&file)?, given)?;
    let millimetres = unit.unit().millimetres().clone();
    let scale = file
        .global
        .get(12)
        .and_then(|text| super::decimal::decimal(text));
    // Lengths of the file are lengths of the model times its scale.
    let scale = scale
        .filter(|scale| *scale > Rational::default())
        .unwrap_or(Rational::from(1));
    let factor = millimetres / scale;
    let uncertainty = file
        .global
        .get(18)
        .and_then(|text| super::decimal::decimal(text));
    let uncertainty = uncertainty
        .map(|own| own.approximate() * factor.approximate())
        .filter(|own| *own > 0.0);
    let reader = Reader {
        file: &file,
        map: AffineMap::stretch(&factor),
        factor: factor.approximate(),
        work: Cell::new(0),
    };
    let mut drafts = Drafts::new(&unit);
    let mut passed = PassedOver::default();
    let has = |kind: i64| {
        file.entities
            .iter()
            .any(|entity| entity.kind == kind && !entity.hidden)
    };
    // Programs say of faces and shells of B-reps that they belong to others also where there is none.
    let (lone_faces, lone_shells) = (!has(514), !has(186));
    for entity in &file.entities {
        if entity.hidden {
            continue;
        }
        if entity.dependent {
            if (entity.kind == 510 && lone_faces) || (entity.kind == 514 && lone_shells) {
                passed.add_at(&kind_words(entity.kind), &entity.place());
            }
            continue;
        }
        let name = match entity.label {
            "" => entity.id.to_string(),
            label => label.to_owned(),
        };
        if let Some(shape) = reader.curve(entity, 0)? {
            drafts.curve(&name, entity.place(), shape.mapped(&reader.map))?;
        } else if let Some((surface, loops, border)) = reader.face(entity)? {
            let face = ImportedFace {
                name: String::new(),
                place: entity.place(),
                surface: surface.moved(&reader.map, reader.factor),
                loops: reader.edges(entity, loops, uncertainty.unwrap_or(0.0), &mut drafts)?,
                border,
                forward: true,
            };
            drafts.face(&name, face);
        } else if !matches!(entity.kind, 124 | 314 | 406 | 402 | 0) {
            passed.add_at(&kind_words(entity.kind), &entity.place());
        }
    }
    drafts.finish(FileKind::Iges, uncertainty, passed)
}

/// An entity that is not read, by its name where it is a common one.
fn kind_words(kind: i64) -> String {
    let name = match kind {
        116 => "point",
        140 => "offset surface",
        150..=168 | 180 | 182 | 184 => "solid of constructive geometry",
        186 => "solid with faces (manifold B-rep)",
        190 | 192 | 194 | 196 | 198 => "analytic surface of a B-rep",
        202..=230 => "annotation",
        308 | 408 => "subfigure",
        502 | 504 | 508 => "part of a B-rep",
        510 => "face of a B-rep",
        514 => "shell of faces of a B-rep",
        _ => return format!("entity of type {kind}"),
    };
    format!("{name} (type {kind})")
}

/// The unit that the global section states, by its flag.
fn stated(file: &File<'_>) -> ReadResult<Option<LengthUnit>> {
    let flag = file.global.get(13).map_or("", |text| text.trim());
    let name = file.global.get(14).map_or("", |text| text.trim());
    let wrong = |flag: &str| {
        super::error::at_line(
            1,
            format!("units flag {flag} `{name}`: no unit of length that is read"),
        )
    };
    let known = |name: &str| LengthUnit::named(name);
    let found = match flag {
        "" => return Ok(None),
        "1" => known("in"),
        "2" => known("mm"),
        "3" => match name {
            "" => return Ok(None),
            name => known(name),
        },
        "4" => known("ft"),
        "5" => known("mi"),
        "6" => known("m"),
        "7" => known("km"),
        "8" => known("mil"),
        "9" => known("um"),
        "10" => known("cm"),
        "11" => ratio(127, 5_000_000).and_then(|mm| LengthUnit::new("microinch", mm)),
        _ => None,
    };
    let found = found.ok_or_else(|| wrong(flag))?;
    // The name says the same where it says something.
    match known(name) {
        Some(named) if named.millimetres() != found.millimetres() => Err(super::error::at_line(
            1,
            format!(
                "units flag {flag} is {}, and the name beside it is `{name}`: one of the two is wrong",
                found.name()
            ),
        )),
        _ => Ok(Some(found)),
    }
}

/// The curves of a loop, with their entities.
type LoopCurves = Vec<(usize, super::FilePlace, CurveShape)>;

struct Reader<'t, 'f> {
    file: &'f File<'t>,
    /// To millimetres.
    map: AffineMap<Rational>,
    factor: f64,
    work: Cell<usize>,
}

impl<'t> Reader<'t, '_> {
    fn guard(&self, entity: &Entity<'t>, depth: usize) -> ReadResult<()> {
        self.work.set(self.work.get() + 1);
        let most = 50 * self.file.entities.len() + 1_000_000;
        if depth > MAX_DEPTH || self.work.get() > most {
            return Err(ReadError::TooMuch {
                place: entity.place(),
                what: "entities that point to each other: a circle of pointers?",
                most: if depth > MAX_DEPTH { MAX_DEPTH } else { most },
            });
        }
        Ok(())
    }

    /// The map of an entity's matrix, and of the matrix of that.
    fn matrix(&self, entity: &Entity<'t>, depth: usize) -> ReadResult<Option<AffineMap<Rational>>> {
        if entity.matrix == 0 {
            return Ok(None);
        }
        self.guard(entity, depth)?;
        let missing = || {
            at(
                &entity.place(),
                format!("there is no matrix {}", entity.matrix),
            )
        };
        let own = self
            .file
            .get(entity.matrix)
            .filter(|own| own.kind == 124)
            .ok_or_else(missing)?;
        let row = |k: usize| own.exacts(4 * k, 4);
        let rows = [row(0)?, row(1)?, row(2)?];
        let map = AffineMap {
            linear: std::array::from_fn(|i| std::array::from_fn(|j| rows[i][j].clone())),
            shift: std::array::from_fn(|i| rows[i][3].clone()),
        };
        Ok(Some(match self.matrix(own, depth + 1)? {
            Some(outer) => outer.after(&map),
            None => map,
        }))
    }

    /// The curve that an entity is; nothing for another kind.
    fn curve(&self, entity: &Entity<'t>, depth: usize) -> ReadResult<Option<CurveShape>> {
        self.guard(entity, depth)?;
        let place = entity.place();
        let made = match entity.kind {
            100 => {
                let height = entity.number(0)?;
                let flat = |k: usize| -> ReadResult<[f64; 3]> {
                    Ok([entity.number(k)?, entity.number(k + 1)?, height])
                };
                let (centre, start, end) = (flat(1)?, flat(3)?, flat(5)?);
                let ([x, y, _], [u, v, _]) = (sub(&start, &centre), sub(&end, &centre));
                let radius = libm::hypot(x, y);
                if radius == 0.0 {
                    return Err(at(&place, "an arc of radius zero"));
                }
                let turn = libm::atan2(x * v - y * u, x * u + y * v) * std::f64::consts::FRAC_2_PI;
                let turn = if start == end || turn.abs() < 1e-9 {
                    4.0
                } else {
                    turn.rem_euclid(4.0)
                };
                let arc =
                    EllipticHelix::new(centre, [x, y, 0.0], [-y, x, 0.0], [0.0; 3], [0.0, turn]);
                arc.map(CurveShape::Arc)
            }
            102 => {
                let count = entity.count(0)?;
                let mut row = Vec::with_capacity(count);
                for k in 1..=count {
                    let part = self.file.pointed(entity, k)?;
                    // Points may stand among the curves.
                    if part.kind == 116 {
                        continue;
                    }
                    let Some(shape) = self.curve(part, depth + 1)? else {
                        return Ok(None);
                    };
                    row.push(shape);
                }
                match row.len() {
                    0 => return Err(at(&place, "a composite curve without curves")),
                    1 => Ok(row.swap_remove(0)),
                    _ => Ok(CurveShape::Row(row)),
                }
            }
            106 if matches!(entity.form, 11 | 12 | 63) => {
                let count = entity.count(1)?;
                let mut points = Vec::with_capacity(count);
                for k in 0..count {
                    points.push(match entity.whole(0)? {
                        1 => {
                            let [x, y] = [entity.exact(3 + 2 * k)?, entity.exact(4 + 2 * k)?];
                            [x, y, entity.exact(2)?]
                        }
                        2 => entity.point(2 + 3 * k)?,
                        _ => return Ok(None),
                    });
                }
                points.dedup();
                Spline::polyline(points).map(CurveShape::Spline)
            }
            110 => CurveShape::line(entity.point(0)?, entity.point(3)?),
            126 => {
                let (upper, degree) = (entity.count(0)?, entity.count(1)?);
                let (points, knots) = (upper + 1, upper + degree + 2);
                if points > MAX_SPLINE_POINTS {
                    return Err(at(&place, format!("{points} control points")));
                }
                let polynomial = entity.whole(4)? == 1;
                let weights = entity.exacts(6 + knots, points)?;
                let at = 6 + knots + points;
                let control: ReadResult<Vec<_>> =
                    (0..points).map(|k| entity.point(at + 3 * k)).collect();
                let equal = weights.windows(2).all(|pair| pair[0] == pair[1]);
                let weights = (!polynomial && !equal).then_some(weights);
                let spline = Spline::new(degree, entity.exacts(6, knots)?, control?, weights)
                    .map_err(refused(&place))?;
                let range = [at + 3 * points, at + 3 * points + 1];
                let ends = [entity.exact(range[0])?, entity.exact(range[1])?].map(Trim::Parameter);
                between(Base::Curve(CurveShape::Spline(spline)), ends, true)
            }
            _ => return Ok(None),
        };
        let shape = made.map_err(refused(&place))?;
        Ok(Some(match self.matrix(entity, depth)? {
            Some(map) => shape.mapped(&map),
            None => shape,
        }))
    }

    fn whole(
        &self,
        from: &Entity<'t>,
        index: usize,
        depth: usize,
    ) -> ReadResult<Option<CurveShape>> {
        self.curve(self.file.pointed(from, index)?, depth + 1)
    }

    /// The edges of the loops of a face, in millimetres; a seam is one edge that is passed twice.
    fn edges(
        &self,
        face: &Entity<'t>,
        loops: Vec<LoopCurves>,
        uncertainty: f64,
        drafts: &mut Drafts,
    ) -> ReadResult<Vec<Vec<(usize, bool)>>> {
        let in_millimetres = |edges: LoopCurves| -> LoopCurves {
            let moved = edges.into_iter();
            moved
                .map(|(id, place, shape)| (id, place, shape.mapped(&self.map)))
                .collect()
        };
        let loops: Vec<LoopCurves> = loops.into_iter().map(in_millimetres).collect();
        let shapes: Vec<&CurveShape> = loops.iter().flatten().map(|(_, _, shape)| shape).collect();
        let partners = seams(&shapes, uncertainty).map_err(refused(&face.place()))?;
        let mut known = Vec::with_capacity(partners.len());
        let mut partners = partners.into_iter();
        let mut drafted = Vec::with_capacity(loops.len());
        for edges in loops {
            let mut loop_edges = Vec::with_capacity(edges.len());
            for (id, place, shape) in edges {
                let seam = partners.next().flatten();
                let seam = seam.and_then(|earlier| known.get(earlier).copied());
                let edge = match seam {
                    Some(index) => (index, false),
                    None => (drafts.curve(&id.to_string(), place, shape)?, true),
                };
                drafts.mark_edge(edge.0);
                known.push(edge.0);
                loop_edges.push(edge);
            }
            drafted.push(loop_edges);
        }
        Ok(drafted)
    }

    /// The surface that an entity is, with its borders where it has some; nothing for another kind.
    fn face(
        &self,
        entity: &Entity<'t>,
    ) -> ReadResult<Option<(SurfaceShape, Vec<LoopCurves>, FaceBorder)>> {
        let surface = match entity.kind {
            144 | 143 => self.file.pointed(entity, usize::from(entity.kind == 143))?,
            _ => {
                let Some(shape) = self.surface(entity)? else {
                    return Ok(None);
                };
                let own = self.own_borders(entity, &shape)?;
                let (loops, border) = own.unwrap_or((Vec::new(), FaceBorder::OwnOfSurface));
                return Ok(Some((shape, loops.into_iter().flatten().collect(), border)));
            }
        };
        let Some(shape) = self.surface(surface)? else {
            return Ok(None);
        };
        let mut loops: Vec<Option<LoopCurves>> = Vec::new();
        let mut border = FaceBorder::Unstated;
        if entity.kind == 144 {
            // The outer border, unless it is that of the surface itself, then the inner ones.
            let outer = usize::from(entity.whole(1)? != 0);
            (loops, border) = match outer {
                0 => {
                    let own = self.own_borders(surface, &shape)?;
                    own.unwrap_or((Vec::new(), FaceBorder::OwnOfSurface))
                }
                _ => (Vec::new(), FaceBorder::Loop(0)),
            };
            let inner = entity.count(2)?;
            let first = if outer == 1 { 3 } else { 4 };
            for k in first..first + outer + inner {
                let on = self.file.pointed(entity, k)?;
                loops.push(self.border(self.file.pointed(on, 3)?, 0)?);
            }
        } else {
            for k in 0..entity.count(2)? {
                let boundary = self.file.pointed(entity, 3 + k)?;
                let mut curves = Some(LoopCurves::new());
                let mut index = 4;
                for _ in 0..boundary.count(3)? {
                    extend(
                        &mut curves,
                        self.border(self.file.pointed(boundary, index)?, 0)?,
                    );
                    index += 3 + boundary.count(index + 2)?;
                }
                loops.push(curves);
            }
        }
        if loops.iter().any(Option::is_none) {
            border = FaceBorder::NotRead;
        }
        Ok(Some((shape, loops.into_iter().flatten().collect(), border)))
    }

    /// The curves of a loop, those of a composite curve one by one; nothing if one of them is of a kind that is not read.
    fn border(&self, entity: &Entity<'t>, depth: usize) -> ReadResult<Option<LoopCurves>> {
        self.guard(entity, depth)?;
        if entity.kind == 102 && entity.matrix == 0 {
            let mut all = Some(LoopCurves::new());
            for k in 1..=entity.count(0)? {
                let part = self.file.pointed(entity, k)?;
                // Points may stand among the curves.
                if part.kind != 116 {
                    extend(&mut all, self.border(part, depth + 1)?);
                }
            }
            return Ok(all);
        }
        Ok(self
            .curve(entity, depth)?
            .map(|shape| vec![(entity.id, entity.place(), shape)]))
    }

    fn surface(&self, entity: &Entity<'t>) -> ReadResult<Option<SurfaceShape>> {
        let place = entity.place();
        let shape = match entity.kind {
            108 => {
                let normal = [entity.number(0)?, entity.number(1)?, entity.number(2)?];
                let size = torse_geometry::vector::dot(&normal, &normal);
                let axis = unit(&normal).ok_or_else(|| at(&place, "a plane without normal"))?;
                let share = entity.number(3)? / size;
                SurfaceShape::Plane(SurfaceFrame {
                    origin: normal.map(|c| c * share),
                    axis,
                    across: across(&axis),
                })
            }
            118 => {
                let (first, second) = (self.whole(entity, 0, 0)?, self.whole(entity, 1, 0)?);
                let (Some(first), Some(second)) = (first, second) else {
                    return Ok(None);
                };
                let second = if entity.whole(2)? == 1 {
                    second.reversed()
                } else {
                    second
                };
                SurfaceShape::Ruled(Box::new([first, second]))
            }
            120 => {
                let axis = self.file.pointed(entity, 0)?;
                let Some(curve) = self.whole(entity, 1, 0)? else {
                    return Ok(None);
                };
                let (from, to) = (axis.point(0)?, axis.point(3)?);
                let way = sub(&to, &from);
                let direction = unit(&way.each_ref().map(Coordinate::approximate))
                    .ok_or_else(|| at(&place, "an axis without direction"))?;
                let frame = SurfaceFrame {
                    origin: from.each_ref().map(Coordinate::approximate),
                    axis: direction,
                    across: across(&direction),
                };
                turned(curve, &from, &way, frame)
            }
            122 => {
                let Some(curve) = self.whole(entity, 0, 0)? else {
                    return Ok(None);
                };
                let end = entity.point(1)?.each_ref().map(Coordinate::approximate);
                let rail = curve
                    .rail()
                    .and_then(|rail| rail.point(0.0))
                    .map_err(refused(&place))?;
                SurfaceShape::Extruded(Box::new(curve), sub(&end, &rail))
            }
            128 => self.spline_surface(entity)?,
            _ => return Ok(None),
        };
        Ok(Some(match self.matrix(entity, 0)? {
            Some(map) => shape.moved(&map, 1.0),
            None => shape,
        }))
    }

    fn spline_surface(&self, entity: &Entity<'t>) -> ReadResult<SurfaceShape> {
        let place = entity.place();
        let uppers = [entity.count(0)?, entity.count(1)?];
        let degrees = [entity.count(2)?, entity.count(3)?];
        let sizes = uppers.map(|upper| upper + 1);
        let points = sizes[0].saturating_mul(sizes[1]);
        if points > MAX_SPLINE_POINTS {
            return Err(at(&place, format!("{points} control points")));
        }
        let counts = [0, 1].map(|k| sizes[k] + degrees[k] + 1);
        let knots = [
            entity.exacts(9, counts[0])?,
            entity.exacts(9 + counts[0], counts[1])?,
        ];
        let start = 9 + counts[0] + counts[1];
        let all = entity.exacts(start, points)?;
        // The first direction runs fastest.
        let grid = |list: &dyn Fn(usize) -> ReadResult<[Rational; 3]>| -> ReadResult<Vec<Vec<[Rational; 3]>>> {
            (0..sizes[0]).map(|i| (0..sizes[1]).map(|j| list(i + j * sizes[0])).collect()).collect()
        };
        let net = grid(&|k| entity.point(start + points + 3 * k))?;
        let equal = all.windows(2).all(|pair| pair[0] == pair[1]);
        let weights = (!equal).then(|| {
            (0..sizes[0])
                .map(|i| {
                    (0..sizes[1])
                        .map(|j| all[i + j * sizes[0]].clone())
                        .collect()
                })
                .collect()
        });
        SplineSurface::new(degrees, knots, net, weights)
            .map(SurfaceShape::Spline)
            .map_err(refused(&place))
    }
}

/// Adds curves to a loop; one in which a curve is not read is none.
fn extend(curves: &mut Option<LoopCurves>, more: Option<LoopCurves>) {
    match (curves.as_mut(), more) {
        (Some(all), Some(more)) => all.extend(more),
        _ => *curves = None,
    }
}

/// A direction across another one.
fn across(axis: &[f64; 3]) -> [f64; 3] {
    let other = if axis[0].abs() < 0.5 {
        [1.0, 0.0, 0.0]
    } else {
        [0.0, 1.0, 0.0]
    };
    unit(&torse_geometry::vector::cross(axis, &other)).unwrap_or(other)
}
