//! Cylinders and cones within curves that planes cut from them: oblique ends, and openings over the seam.
//!
//! A closed face is cut open along a ruling that no opening meets: where the file has its seam does not matter.

use super::loops::opening;
use super::{FaceSheets, SAME, words};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use torse_exchange::{Imported, ImportedFace, SurfaceFrame, SurfaceShape};
use torse_geometry::basis::BasisShape;
use torse_geometry::curve::EllipticHelix;
use torse_geometry::prelude::{PiecewiseRail, Point, Rail, RailCurve, Sheet, SweptEdge};
use torse_geometry::vector::{add, cross, dot, norm, scale, sub, unit};

/// Points of each piece of a curve at which it is looked at.
const SAMPLES: u32 = 64;
/// Directions of planes are one within this.
const PARALLEL: f64 = 1e-9;
/// The room about an opening that the ruling along which a face is cut open keeps, as an angle.
const ROOM: f64 = 1e-3;

/// A cylinder or a cone.
struct Swept {
    frame: SurfaceFrame,
    radius: f64,
    /// Half of the angle of a cone; none of a cylinder.
    angle: Option<f64>,
}

/// Returns the sheets of a face between two curves that lie in planes, or why it has none.
pub(super) fn between_planes(
    face: &ImportedFace,
    imported: &Imported,
) -> Result<FaceSheets, String> {
    let ClosedFace {
        surface,
        tolerance,
        borders: [first, second],
        holes,
    } = ClosedFace::new(face, imported)?;
    let planes = [
        surface.plane(&first, tolerance)?,
        surface.plane(&second, tolerance)?,
    ];
    let start = surface.free_angle(&first, &holes)?;
    let sheets = surface.sheets(start, planes)?;
    let off = surface.check(&sheets, [&first, &second], tolerance)?;
    let openings = holes.into_iter().enumerate();
    Ok(FaceSheets {
        sheets,
        closed: true,
        note: Some(format!(
            "cut by the planes of its edges, which leave its surface by {off:.1e} mm, measured"
        )),
        border: None,
        openings: openings
            .map(|(index, curve)| opening(index, curve))
            .collect(),
    })
}

/// Returns whether an opening of a face that is closed around lies over the ruling at which its first edge begins: there a
/// file cuts it open.
pub(super) fn has_opening_over_seam(face: &ImportedFace, imported: &Imported) -> bool {
    let moved = || -> Result<bool, String> {
        let closed = ClosedFace::new(face, imported)?;
        let [first, _] = &closed.borders;
        let start = closed.surface.angle_of(&first.point(0.0).map_err(words)?);
        Ok(closed.surface.free_angle(first, &closed.holes)? != start)
    };
    moved().unwrap_or(false)
}

/// A cylinder or a cone with two edges around its axis, and its openings.
struct ClosedFace {
    surface: Swept,
    /// The distance within which points are one.
    tolerance: f64,
    borders: [PiecewiseRail; 2],
    holes: Vec<PiecewiseRail>,
}

impl ClosedFace {
    fn new(face: &ImportedFace, imported: &Imported) -> Result<Self, String> {
        let surface = Swept::of_face(face).ok_or("it is neither a cylinder nor a cone")?;
        let tolerance = (SAME * surface.radius).max(imported.uncertainty.unwrap_or(0.0));
        let (mut borders, mut holes) = (Vec::new(), Vec::new());
        for chain in chains(face, imported, tolerance)? {
            match surface.winding(&chain)? {
                0 => holes.push(chain),
                1 | -1 => borders.push(chain),
                _ => return Err("an edge runs around it more than once".to_owned()),
            }
        }
        let borders = <[PiecewiseRail; 2]>::try_from(borders)
            .map_err(|all| format!("{} of its edges run around it, and not two", all.len()))?;
        Ok(Self {
            surface,
            tolerance,
            borders,
            holes,
        })
    }
}

/// Returns the closed curves of the edges that are passed once: those that are passed twice are seams.
fn chains(
    face: &ImportedFace,
    imported: &Imported,
    tolerance: f64,
) -> Result<Vec<PiecewiseRail>, String> {
    let all: Vec<(usize, bool)> = face.loops.iter().flatten().copied().collect();
    let times = |edge: usize| all.iter().filter(|(other, _)| *other == edge).count();
    let mut open: Vec<PiecewiseRail> = Vec::new();
    for (edge, forward) in all.iter().filter(|(edge, _)| times(*edge) == 1) {
        let curve = imported.curves.get(*edge).ok_or("an edge is missing")?;
        let shape = if *forward {
            curve.shape.clone()
        } else {
            curve.shape.reversed()
        };
        open.push(shape.rail().map_err(words)?);
    }
    let apart = |a: &PiecewiseRail, b: &PiecewiseRail| -> Result<f64, String> {
        let (end, start) = (a.point(1.0).map_err(words)?, b.point(0.0).map_err(words)?);
        Ok(norm(&sub(&end, &start)))
    };
    let mut closed = Vec::new();
    while !open.is_empty() {
        let mut run = vec![open.remove(0)];
        while let (Some(first), Some(last)) = (run.first(), run.last())
            && apart(last, first)? > tolerance
        {
            let mut next = None;
            for (index, other) in open.iter().enumerate() {
                if apart(last, other)? <= tolerance {
                    next = Some(index);
                    break;
                }
            }
            match next {
                Some(index) => run.push(open.remove(index)),
                None => return Err("its edges are not closed around it".to_owned()),
            }
        }
        closed.push(PiecewiseRail::joined(&run).map_err(words)?);
    }
    Ok(closed)
}

impl Swept {
    fn of_face(face: &ImportedFace) -> Option<Self> {
        match &face.surface {
            SurfaceShape::Cylinder(frame, radius) => Some(Self {
                frame: *frame,
                radius: *radius,
                angle: None,
            }),
            SurfaceShape::Cone(frame, radius, angle) => Some(Self {
                frame: *frame,
                radius: *radius,
                angle: Some(*angle),
            }),
            _ => None,
        }
    }

    /// Returns the angle of a point about the axis.
    fn angle_of(&self, point: &Point) -> f64 {
        let arm = sub(point, &self.frame.origin);
        let side = cross(&self.frame.axis, &self.frame.across);
        libm::atan2(dot(&arm, &side), dot(&arm, &self.frame.across))
    }

    /// Returns the distance of a point from the surface.
    fn distance(&self, point: &Point) -> f64 {
        let arm = sub(point, &self.frame.origin);
        let along = dot(&arm, &self.frame.axis);
        let out = norm(&cross(&arm, &self.frame.axis));
        match self.angle {
            None => (out - self.radius).abs(),
            Some(angle) => {
                (out - (self.radius + along * libm::tan(angle))).abs() * libm::cos(angle)
            }
        }
    }

    /// Returns points along a curve, and its angles about the axis, each less than half a turn from the one before.
    fn angles(&self, curve: &PiecewiseRail) -> Result<Vec<f64>, String> {
        let mut angles: Vec<f64> = Vec::new();
        for rail in curve.rails().map_err(words)? {
            for k in 0..=SAMPLES {
                let point = rail.point(f64::from(k) / f64::from(SAMPLES));
                let angle = self.angle_of(&point.map_err(words)?);
                let near = angles
                    .last()
                    .map_or(angle, |last| last + libm::remainder(angle - last, TAU));
                angles.push(near);
            }
        }
        Ok(angles)
    }

    /// Returns how often a closed curve runs around the axis, as points on it show.
    fn winding(&self, curve: &PiecewiseRail) -> Result<i32, String> {
        let angles = self.angles(curve)?;
        let turn = angles.last().unwrap_or(&0.0) - angles.first().unwrap_or(&0.0);
        #[allow(clippy::cast_possible_truncation, reason = "a few turns")]
        Ok((turn / TAU).round().clamp(-9.0, 9.0) as i32)
    }

    /// Returns the plane `n . X = e` of a curve of arcs of ellipses.
    fn plane(&self, curve: &PiecewiseRail, tolerance: f64) -> Result<[f64; 4], String> {
        let mut found: Option<(Point, Point)> = None;
        for rail in curve.rails().map_err(words)? {
            let RailCurve::Elliptic(arc) = rail.curve() else {
                return Err("an edge around it is no circle and no ellipse".to_owned());
            };
            let [cosine, sine] = arc.axes();
            let normal = unit(&cross(cosine, sine)).ok_or("an edge has no plane")?;
            let (known, centre) = *found.get_or_insert((normal, *arc.centre()));
            let off = dot(&sub(arc.centre(), &centre), &known).abs();
            if norm(&cross(&known, &normal)) > PARALLEL || off > tolerance {
                return Err("an edge around it lies in no plane".to_owned());
            }
        }
        let (mut normal, centre) = found.ok_or("an edge is missing")?;
        // Rounding of a plane across the axis.
        if norm(&cross(&normal, &self.frame.axis)) <= PARALLEL {
            normal = self.frame.axis;
        }
        let [p, q, r] = normal;
        Ok([p, q, r, dot(&normal, &centre)])
    }

    /// Returns the angle of a ruling that no opening meets: that of the start of the border if it is one, else the middle of
    /// the widest gap.
    fn free_angle(&self, border: &PiecewiseRail, holes: &[PiecewiseRail]) -> Result<f64, String> {
        let start = self.angle_of(&border.point(0.0).map_err(words)?);
        let mut taken: Vec<[f64; 2]> = Vec::new();
        for hole in holes {
            let angles = self.angles(hole)?;
            let low = angles.iter().copied().fold(f64::INFINITY, f64::min) - ROOM;
            let high = angles.iter().copied().fold(f64::NEG_INFINITY, f64::max) + ROOM;
            // Angles after the start.
            let from = (low - start).rem_euclid(TAU);
            taken.push([from, from + high - low]);
        }
        if taken.iter().all(|[_, to]| *to <= TAU) {
            return Ok(start);
        }
        taken.sort_by(|a, b| a[0].total_cmp(&b[0]));
        // What goes over the start takes the first angles too.
        let over = taken.iter().map(|[_, to]| to - TAU).fold(0.0, f64::max);
        let (mut reached, mut best) = (over, (0.0, 0.0));
        for [from, to] in taken.into_iter().chain([[TAU, TAU]]) {
            if from - reached > best.0 {
                best = (from - reached, 0.5 * (from + reached));
            }
            reached = reached.max(to);
        }
        if best.0 <= 0.0 {
            return Err("its openings leave no ruling along which it could be cut open".to_owned());
        }
        Ok(start + best.1)
    }

    /// Returns the sheets once around from a ruling, between two planes: a cylinder over a circle, or four cones over quarters
    /// of one.
    fn sheets(&self, start: f64, planes: [[f64; 4]; 2]) -> Result<Vec<Sheet>, String> {
        let SurfaceFrame {
            origin,
            axis,
            across,
        } = self.frame;
        let side = cross(&axis, &across);
        let edges = planes.map(SweptEdge::Cut);
        let Some(angle) = self.angle else {
            let [cosine, sine] = [across, side].map(|v| scale(&self.radius, &v));
            let from = start / FRAC_PI_2;
            let circle = EllipticHelix::new(origin, cosine, sine, [0.0; 3], [from, from + 4.0]);
            let circle = Rail::from(circle.map_err(words)?);
            return Ok(vec![Sheet::cylinder(&circle, axis, edges).map_err(words)?]);
        };
        // Where the cone is as wide as its own radius, or one, if that is its apex.
        let (radius, centre) = if self.radius > 0.0 {
            (self.radius, origin)
        } else {
            (libm::tan(angle), add(&origin, &axis))
        };
        let apex = add(&centre, &scale(&(-radius / libm::tan(angle)), &axis));
        let out = |turn: f64| {
            let (sine, cosine) = libm::sincos(turn);
            add(&scale(&cosine, &across), &scale(&sine, &side))
        };
        let mut cones = Vec::with_capacity(4);
        for quarter in 0..4 {
            let from = start + FRAC_PI_2 * f64::from(quarter);
            let to = if quarter == 3 {
                start
            } else {
                start + FRAC_PI_2 * f64::from(quarter + 1)
            };
            let [a, b] = [out(from), out(to)].map(|v| scale(&radius, &v));
            let points = [
                add(&centre, &a),
                add(&centre, &add(&a, &b)),
                add(&centre, &b),
            ];
            let weights = [1.0, std::f64::consts::FRAC_1_SQRT_2, 1.0];
            let arc = Rail::weighted(BasisShape::Bernstein, &points, &weights).map_err(words)?;
            cones.push(Sheet::cone(&arc, apex, edges).map_err(words)?);
        }
        Ok(cones)
    }

    /// Refuses edges that leave the surface or turn back, and planes that cut it otherwise, as samples show; returns by how
    /// much they leave it.
    fn check(
        &self,
        sheets: &[Sheet],
        borders: [&PiecewiseRail; 2],
        tolerance: f64,
    ) -> Result<f64, String> {
        let mut farthest = 0.0_f64;
        for border in borders {
            for rail in border.rails().map_err(words)? {
                for k in 0..=SAMPLES {
                    let point = rail
                        .point(f64::from(k) / f64::from(SAMPLES))
                        .map_err(words)?;
                    let off = self.distance(&point);
                    if off.is_nan() || off > 4.0 * tolerance {
                        return Err(format!("an edge leaves its surface by {off:.2e} mm"));
                    }
                    farthest = farthest.max(off);
                }
            }
            let angles = self.angles(border)?;
            let turn = angles.last().unwrap_or(&0.0) - angles.first().unwrap_or(&0.0);
            let back = angles
                .windows(2)
                .any(|pair| (pair[1] - pair[0]) * turn < -1e-9);
            if back || (turn.abs() - TAU).abs() > PI {
                return Err("an edge around it meets a ruling more than once".to_owned());
            }
        }
        for sheet in sheets {
            for k in 0..=SAMPLES {
                let ends = sheet
                    .ruling(f64::from(k) / f64::from(SAMPLES))
                    .map_err(words)?;
                let off = ends.map(|end| self.distance(&end));
                let off = off[0].max(off[1]);
                if off.is_nan() || off > 4.0 * tolerance {
                    return Err(format!(
                        "the planes of its edges cut it elsewhere, {off:.2e} mm off"
                    ));
                }
                farthest = farthest.max(off);
            }
        }
        Ok(farthest)
    }
}
