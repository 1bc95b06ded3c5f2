//! Cylinders and cones within curves that planes cut from them: oblique ends, and openings over the seam.
//!
//! A closed face is cut open along a ruling that no opening meets: where the file has its seam does not matter.

use super::loops::opening;
use super::round::{PARALLEL, RoundFace, SAMPLES, Swept};
use super::{FaceSheets, words};
use std::f64::consts::{FRAC_PI_2, PI, TAU};
use torse_exchange::SurfaceFrame;
use torse_geometry::basis::BasisShape;
use torse_geometry::curve::EllipticHelix;
use torse_geometry::prelude::{PiecewiseRail, Point, Rail, RailCurve, Sheet, SweptEdge};
use torse_geometry::vector::{add, cross, dot, norm, scale, sub, unit};

/// Returns the sheets of a face between two curves that lie in planes, or why it has none.
pub(super) fn between_planes(face: &RoundFace) -> Result<FaceSheets, String> {
    let RoundFace {
        surface,
        tolerance,
        borders,
        holes,
        ..
    } = face;
    let [first, second] = borders.as_slice() else {
        let count = borders.len();
        return Err(format!("{count} of its edges run around it, and not two"));
    };
    let planes = [
        surface.plane(first, *tolerance)?,
        surface.plane(second, *tolerance)?,
    ];
    let start = surface.angle_of(&first.point(0.0).map_err(words)?);
    let start = surface.free_angle(start, holes)?;
    let sheets = surface.sheets(start, planes)?;
    let off = surface.check(&sheets, [first, second], *tolerance)?;
    let openings = holes.iter().cloned().enumerate();
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
pub(super) fn has_opening_over_seam(round: &RoundFace) -> bool {
    let moved = || -> Result<bool, String> {
        let [first, _] = round.borders.as_slice() else {
            return Ok(false);
        };
        let start = round.surface.angle_of(&first.point(0.0).map_err(words)?);
        Ok(round.surface.free_angle(start, &round.holes)? != start)
    };
    moved().unwrap_or(false)
}

impl Swept {
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
        let (normal, centre) = found.ok_or("an edge is missing")?;
        Ok(self.cut(normal, &centre))
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
        let ((centre, radius), apex) = (self.wide(angle), self.apex(angle));
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
