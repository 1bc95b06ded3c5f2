//! The borders that surfaces of IGES have without being trimmed: of a surface of revolution the circles and the curves at
//! both angles, of a bounded plane its curve.

use super::records::Entity;
use super::{LoopCurves, Reader};
use crate::read::error::{ReadResult, at, refused};
use crate::read::{CurveShape, FaceBorder, SurfaceShape};
use torse_geometry::curve::EllipticHelix;
use torse_geometry::vector::{add, cross, dot, norm, scale, sub, unit};
use torse_geometry::{AffineMap, Coordinate, exact};

/// Points within this share of the size of a curve are one; angles within it are a whole turn.
const SAME: f64 = 1e-9;

/// The loops that bound a surface, and what they are to it.
type OwnBorders = (Vec<Option<LoopCurves>>, FaceBorder);

/// An axis: a point, and a direction of length one.
struct Axis {
    origin: [f64; 3],
    direction: [f64; 3],
}

impl Axis {
    /// The turn by an angle.
    fn turn(&self, angle: f64) -> AffineMap<f64> {
        let (sine, cosine) = libm::sincos(angle);
        let image = |v: &[f64; 3]| -> [f64; 3] {
            let along = scale(&dot(v, &self.direction), &self.direction);
            let across = sub(v, &along);
            let side = cross(&self.direction, v);
            add(&along, &add(&scale(&cosine, &across), &scale(&sine, &side)))
        };
        let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|v| image(&v));
        AffineMap {
            linear: std::array::from_fn(|i| std::array::from_fn(|j| columns[j][i])),
            shift: sub(&self.origin, &image(&self.origin)),
        }
    }

    /// The way of a point between two angles, if it is not on the axis.
    fn way(&self, point: &[f64; 3], angles: [f64; 2], size: f64) -> Option<EllipticHelix> {
        let arm = sub(point, &self.origin);
        let centre = add(
            &self.origin,
            &scale(&dot(&arm, &self.direction), &self.direction),
        );
        let arm = sub(point, &centre);
        let side = cross(&self.direction, &arm);
        let range = angles.map(|angle| angle * std::f64::consts::FRAC_2_PI);
        if norm(&arm) <= SAME * size {
            return None;
        }
        EllipticHelix::new(centre, arm, side, [0.0; 3], range).ok()
    }
}

impl<'t> Reader<'t, '_> {
    /// The loops that bound a surface by itself; nothing of one whose border is known otherwise, or not.
    pub(super) fn own_borders(
        &self,
        entity: &Entity<'t>,
        surface: &SurfaceShape,
    ) -> ReadResult<Option<OwnBorders>> {
        let found = match (entity.kind, surface) {
            (108, _) if entity.form == 1 && entity.whole(4)? != 0 => {
                let curves = self.border(self.file.pointed(entity, 4)?, 0)?;
                let border = match curves {
                    Some(_) => FaceBorder::Loop(0),
                    None => FaceBorder::NotRead,
                };
                Some((vec![curves], border))
            }
            (120, SurfaceShape::Plane(_) | SurfaceShape::Cylinder(..) | SurfaceShape::Cone(..)) => {
                self.turned_borders(entity, surface)?
            }
            _ => None,
        };
        let map = self.matrix(entity, 0)?;
        Ok(found.map(|(loops, border)| {
            let moved = |(id, place, shape): (usize, _, CurveShape)| {
                let shape = map
                    .as_ref()
                    .map_or_else(|| shape.clone(), |map| shape.mapped(map));
                (id, place, shape)
            };
            let moved = |curves: LoopCurves| curves.into_iter().map(moved).collect::<LoopCurves>();
            let loops = loops.into_iter().map(|curves| curves.map(moved));
            (loops.collect(), border)
        }))
    }

    /// The borders of a straight line that turns between two angles.
    fn turned_borders(
        &self,
        entity: &Entity<'t>,
        surface: &SurfaceShape,
    ) -> ReadResult<Option<OwnBorders>> {
        let place = entity.place();
        let axis = self.file.pointed(entity, 0)?;
        let [origin, end] = [axis.point(0)?, axis.point(3)?]
            .map(|point| point.each_ref().map(Coordinate::approximate));
        let direction =
            unit(&sub(&end, &origin)).ok_or_else(|| at(&place, "an axis without direction"))?;
        let axis = Axis { origin, direction };
        let Some(curve) = self.whole(entity, 1, 0)? else {
            return Ok(None);
        };
        let angles = [entity.number(2)?, entity.number(3)?];
        let wide = angles[1] - angles[0];
        if wide.is_nan() || wide <= SAME || wide > std::f64::consts::TAU + SAME {
            return Ok(None);
        }
        let rail = curve.rail().map_err(refused(&place))?;
        let ends = [
            rail.point(0.0).map_err(refused(&place))?,
            rail.point(1.0).map_err(refused(&place))?,
        ];
        let size = norm(&sub(&ends[0], &origin)).max(norm(&sub(&ends[1], &origin)));
        let ways = ends.map(|end| axis.way(&end, angles, size).map(CurveShape::Arc));
        let [first, last] = ways;
        let edge = |shape: CurveShape| (entity.id, entity.place(), shape);
        let whole = wide >= std::f64::consts::TAU - SAME;
        if whole && matches!(surface, SurfaceShape::Plane(_)) {
            let rings = first.into_iter().chain(last);
            let rings = rings.map(|ring| Some(vec![edge(ring)]));
            return Ok(Some((rings.collect(), FaceBorder::Unstated)));
        }
        let sides = angles.map(|angle| {
            let turn = axis.turn(angle);
            curve.mapped(&AffineMap {
                linear: turn.linear.map(|row| row.map(exact)),
                shift: turn.shift.map(exact),
            })
        });
        let [before, behind] = sides;
        let around = [
            first,
            Some(behind),
            last.map(|ring| ring.reversed()),
            Some(before.reversed()),
        ];
        let edges = around.into_iter().flatten().map(edge).collect();
        Ok(Some((vec![Some(edges)], FaceBorder::Loop(0))))
    }
}
