//! Cylinders and cones with edges around their axes: closed curves of edges, their turns, and a ruling that no opening meets.

use super::{SAME, words};
use std::f64::consts::TAU;
use torse_exchange::{Imported, ImportedFace, SurfaceFrame, SurfaceShape};
use torse_geometry::prelude::{PiecewiseRail, Point};
use torse_geometry::vector::{add, cross, dot, norm, scale, sub};

/// Points of each piece of a curve at which it is looked at.
pub(super) const SAMPLES: u32 = 64;
/// Directions of planes are one within this.
pub(super) const PARALLEL: f64 = 1e-9;
/// The room about an opening that the ruling along which a face is cut open keeps, as an angle.
const ROOM: f64 = 1e-3;

/// A cylinder or a cone.
pub(super) struct Swept {
    pub frame: SurfaceFrame,
    pub radius: f64,
    /// Half of the angle of a cone; none of a cylinder.
    pub angle: Option<f64>,
}

/// A cylinder or a cone with closed curves of edges.
pub(super) struct RoundFace {
    pub surface: Swept,
    /// The distance within which points are one.
    pub tolerance: f64,
    /// Curves once around the axis.
    pub borders: Vec<PiecewiseRail>,
    /// Curves beside the axis.
    pub holes: Vec<PiecewiseRail>,
    /// Where an edge is that is passed twice, as an angle: there the file cuts the face open.
    pub seam: Option<f64>,
}

impl RoundFace {
    pub(super) fn new(face: &ImportedFace, imported: &Imported) -> Result<Self, String> {
        let surface = Swept::of_face(face).ok_or("it is neither a cylinder nor a cone")?;
        let edges = Edges::new(face, imported)?;
        // A cone may be stated at its apex.
        let mut size = surface.radius;
        for edge in &edges.once {
            for x in [0.0, 0.5, 1.0] {
                size = size.max(surface.out(&edge.point(x).map_err(words)?));
            }
        }
        let tolerance = (SAME * size).max(imported.uncertainty.unwrap_or(0.0));
        let (mut borders, mut holes) = (Vec::new(), Vec::new());
        for chain in closed_curves(edges.once, tolerance)? {
            match surface.winding(&chain)? {
                0 => holes.push(chain),
                1 | -1 => borders.push(chain),
                _ => return Err("an edge runs around it more than once".to_owned()),
            }
        }
        let seam = match &edges.seam {
            Some(seam) => Some(surface.angle_of(&seam.point(0.5).map_err(words)?)),
            None => None,
        };
        Ok(Self {
            surface,
            tolerance,
            borders,
            holes,
            seam,
        })
    }
}

/// The edges of a face as curves, passed as its loops pass them.
struct Edges {
    /// Those that are passed once.
    once: Vec<PiecewiseRail>,
    /// The first that is passed twice.
    seam: Option<PiecewiseRail>,
}

impl Edges {
    fn new(face: &ImportedFace, imported: &Imported) -> Result<Self, String> {
        let all: Vec<(usize, bool)> = face.loops.iter().flatten().copied().collect();
        let times = |edge: usize| all.iter().filter(|(other, _)| *other == edge).count();
        let (mut once, mut seam) = (Vec::new(), None);
        for (edge, forward) in &all {
            let is_seam = times(*edge) > 1;
            if is_seam && seam.is_some() {
                continue;
            }
            let curve = imported.curves.get(*edge).ok_or("an edge is missing")?;
            let shape = if *forward {
                curve.shape.clone()
            } else {
                curve.shape.reversed()
            };
            let rail = shape.rail().map_err(words)?;
            if is_seam {
                seam = Some(rail);
            } else {
                once.push(rail);
            }
        }
        Ok(Self { once, seam })
    }
}

/// Returns the closed curves that curves are one after the other.
fn closed_curves(
    mut open: Vec<PiecewiseRail>,
    tolerance: f64,
) -> Result<Vec<PiecewiseRail>, String> {
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
    pub(super) fn of_face(face: &ImportedFace) -> Option<Self> {
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
    pub(super) fn angle_of(&self, point: &Point) -> f64 {
        let arm = sub(point, &self.frame.origin);
        let side = cross(&self.frame.axis, &self.frame.across);
        libm::atan2(dot(&arm, &side), dot(&arm, &self.frame.across))
    }

    /// Returns the distance of a point from the axis.
    pub(super) fn out(&self, point: &Point) -> f64 {
        norm(&cross(&sub(point, &self.frame.origin), &self.frame.axis))
    }

    /// Returns the distance of a point from the surface.
    pub(super) fn distance(&self, point: &Point) -> f64 {
        let arm = sub(point, &self.frame.origin);
        let along = dot(&arm, &self.frame.axis);
        let out = self.out(point);
        match self.angle {
            None => (out - self.radius).abs(),
            Some(angle) => {
                (out - (self.radius + along * libm::tan(angle))).abs() * libm::cos(angle)
            }
        }
    }

    /// Returns points along a curve, and its angles about the axis, each less than half a turn from the one before.
    pub(super) fn angles(&self, curve: &PiecewiseRail) -> Result<Vec<f64>, String> {
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
    pub(super) fn winding(&self, curve: &PiecewiseRail) -> Result<i32, String> {
        let angles = self.angles(curve)?;
        let turn = angles.last().unwrap_or(&0.0) - angles.first().unwrap_or(&0.0);
        #[allow(clippy::cast_possible_truncation, reason = "a few turns")]
        Ok((turn / TAU).round().clamp(-9.0, 9.0) as i32)
    }

    /// Returns the angle of a ruling that no opening meets: the given one if it is one, else the middle of the widest gap.
    pub(super) fn free_angle(&self, start: f64, holes: &[PiecewiseRail]) -> Result<f64, String> {
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

    /// Returns the plane `n . X = e` through a point; the normal of one that is across the axis but for rounding is the axis.
    pub(super) fn cut(&self, normal: Point, point: &Point) -> [f64; 4] {
        let across = norm(&cross(&normal, &self.frame.axis)) <= PARALLEL;
        let normal = if across { self.frame.axis } else { normal };
        let [p, q, r] = normal;
        [p, q, r, dot(&normal, point)]
    }

    /// Returns where a cone is as wide as its own radius, or one, if that is its apex: the centre and the radius there.
    pub(super) fn wide(&self, angle: f64) -> (Point, f64) {
        if self.radius > 0.0 {
            (self.frame.origin, self.radius)
        } else {
            let axis = &self.frame.axis;
            (add(&self.frame.origin, axis), libm::tan(angle))
        }
    }

    /// Returns the apex of a cone with half of its angle.
    pub(super) fn apex(&self, angle: f64) -> Point {
        let (centre, radius) = self.wide(angle);
        add(
            &centre,
            &scale(&(-radius / libm::tan(angle)), &self.frame.axis),
        )
    }
}
