//! Cylinders and cones within edges of any kind: sectors between rulings, in which either edge has one piece.
//!
//! The rulings of a cylinder and of a cone are known, so that edges need no equal parameters: what is at one angle about the
//! axis is on one ruling. Two runs of edges are cut at the angles at which a piece of either begins. Between two such angles
//! the patch is the cylinder or the cone over the one piece, and ends in the plane of the other one, or in the apex; where
//! neither piece is plane, lines run between parts so short that they are rulings as far as points of the file are known.

use super::edge_rails::{ending, plane_of, quadratic};
use super::loops::opening;
use super::round::RoundFace;
use super::runs::{AroundAxis, Piece, Runs, SAME_ANGLE, near_first};
use super::{FaceSheets, words};
use std::f64::consts::{FRAC_PI_2, TAU};
use torse_geometry::prelude::{
    Construction, PiecewiseRail, Point, Rail, RailCurve, Sheet, SweptEdge,
};
use torse_geometry::vector::{cross, norm, sub};

/// An edge and a ruling between which the sine of the angle is smaller touch each other.
const TOUCHING: f64 = 1e-3;
/// The angle about the axis between the ends of a line that is a ruling, at most: the tangent plane turns by as much along
/// it, and stretches by an eighth of its square.
const TURN: f64 = 5e-4;
/// How often a sector is halved at most until lines in it are rulings.
const MAX_HALVINGS: usize = 10;
/// The most sectors of a face.
const MAX_SECTORS: usize = 4096;
/// Rulings at which a sheet is compared with the edges.
const RULINGS: u32 = 9;

/// Returns the sheets of a face between two runs of edges, or between one and the apex of its cone; or why it has none.
pub(super) fn in_sectors(face: RoundFace) -> Result<FaceSheets, String> {
    let RoundFace {
        surface,
        tolerance,
        borders,
        mut holes,
        seam,
    } = face;
    let about = AroundAxis { surface, tolerance };
    let closed = !borders.is_empty();
    let runs = if closed {
        about.runs_around(&borders, &holes, seam)?
    } else {
        let outer = longest(&holes)?;
        about.runs_beside(&holes.remove(outer))?
    };
    let (sheets, off) = about.sheets(runs)?;
    let openings = holes.into_iter().enumerate();
    Ok(FaceSheets {
        sheets,
        closed,
        note: Some(format!(
            "made over its edges, which leave its surface by {off:.1e} mm, measured"
        )),
        border: None,
        openings: openings
            .map(|(index, curve)| opening(index, curve))
            .collect(),
    })
}

/// Returns the index of the longest of closed curves.
fn longest(curves: &[PiecewiseRail]) -> Result<usize, String> {
    let mut best: Option<(f64, usize)> = None;
    for (index, curve) in curves.iter().enumerate() {
        let length = curve.length(1e-3).map_err(words)?;
        if best.is_none_or(|(known, _)| length > known) {
            best = Some((length, index));
        }
    }
    best.map(|(_, index)| index)
        .ok_or_else(|| "it has no edges".to_owned())
}

impl AroundAxis {
    /// Returns the sheets between two runs, and how far they are from the surface and from the edges, as samples show.
    fn sheets(&self, [first, second]: Runs) -> Result<(Vec<Sheet>, f64), String> {
        let first = first.ok_or("it has no edges")?;
        let (mut sheets, mut farthest) = (Vec::new(), 0.0_f64);
        let Some(second) = second else {
            for piece in &first {
                let sheet = self.to_apex(piece)?;
                farthest = farthest.max(self.off(&sheet, piece, None)?);
                sheets.push(sheet);
            }
            return Ok((sheets, farthest));
        };
        let second = near_first(&first, second);
        let mut angles: Vec<f64> = first
            .iter()
            .chain(&second)
            .flat_map(|piece| [piece.from, piece.to])
            .collect();
        angles.sort_by(f64::total_cmp);
        angles.dedup_by(|a, b| *a - *b <= SAME_ANGLE);
        // A cone cut by a plane is written over arcs of less than half a turn.
        let quarters = angles.windows(2).flat_map(|pair| {
            let wide = pair[1] - pair[0];
            let count = (wide / FRAC_PI_2 - SAME_ANGLE).ceil().max(1.0);
            #[allow(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "at most 4"
            )]
            let count = count.min(64.0) as u32;
            (1..count)
                .map(move |k| pair[0] + wide * f64::from(k) / f64::from(count))
                .collect::<Vec<_>>()
        });
        let quarters: Vec<f64> = quarters.collect();
        if self.surface.angle.is_some() {
            angles.extend(quarters);
            angles.sort_by(f64::total_cmp);
        }
        let (first, second) = (self.cut(first, &angles)?, self.cut(second, &angles)?);
        if first.len() != second.len() || first.len() > MAX_SECTORS {
            return Err("its edges do not go as far about its axis".to_owned());
        }
        for pair in first.into_iter().zip(second) {
            let ends = [pair.0.from - pair.1.from, pair.0.to - pair.1.to];
            if ends.iter().any(|off| off.abs() > 4.0 * SAME_ANGLE) {
                return Err("its edges do not go as far about its axis".to_owned());
            }
            let off = self.sector(pair, MAX_HALVINGS, &mut sheets)?;
            farthest = farthest.max(off);
        }
        Ok((sheets, farthest))
    }

    /// Adds the sheets between two pieces over the same angles; returns how far they are off.
    fn sector(
        &self,
        (p, q): (Piece, Piece),
        halvings: usize,
        sheets: &mut Vec<Sheet>,
    ) -> Result<f64, String> {
        let tips = [self.tip(&p, &q, 0.0)?, self.tip(&p, &q, 1.0)?];
        let tip = tips[0].or(tips[1]);
        let wide = p.to - p.from > FRAC_PI_2 + SAME_ANGLE;
        let is_narrow = tips == [None; 2] || (tip.is_some() && !wide && tips.contains(&None));
        let mut reason =
            "its edges meet where its rulings end, at both ends of a sector".to_owned();
        if is_narrow {
            let planes = [self.plane(&p.rail, tip)?, self.plane(&q.rail, tip)?];
            let is_cut = planes != [None; 2];
            let sheet = match planes {
                [_, Some(plane)] => self.over(&p.rail, [None, Some(plane)], tips)?,
                [Some(plane), None] => self.over(&q.rail, [Some(plane), None], tips)?,
                [None, None] => Sheet::ruled(ending(&p.rail, tips)?, ending(&q.rail, tips)?),
            };
            let off = self.off(&sheet, &p, Some(&q))?;
            let is_straight = is_cut || self.turn(&sheet)? <= TURN;
            if off <= 4.0 * self.tolerance && is_straight {
                sheets.push(sheet);
                return Ok(off);
            }
            reason = format!(
                "what is made over its edges is {off:.2e} mm from its surface and its edges"
            );
            if is_cut {
                return Err(reason);
            }
        }
        if halvings == 0 || sheets.len() >= MAX_SECTORS {
            return Err(reason);
        }
        let middle = 0.5 * (p.from + p.to);
        let [first, second] = [p, q].map(|piece| self.cut(vec![piece], &[middle]));
        let mut farthest = 0.0_f64;
        let (first, second) = (first?, second?);
        if first.len() != 2 || second.len() != 2 {
            return Err(reason);
        }
        for pair in first.into_iter().zip(second) {
            farthest = farthest.max(self.sector(pair, halvings - 1, sheets)?);
        }
        Ok(farthest)
    }

    /// Returns the largest angle about the axis between the ends of rulings of a sheet, as samples show.
    fn turn(&self, sheet: &Sheet) -> Result<f64, String> {
        let mut largest = 0.0_f64;
        for k in 0..=RULINGS {
            let ends = sheet
                .ruling(f64::from(k) / f64::from(RULINGS))
                .map_err(words)?;
            let [a, b] = ends.map(|end| self.surface.angle_of(&end));
            largest = largest.max(libm::remainder(a - b, TAU).abs());
        }
        Ok(largest)
    }

    /// Returns the point in which two pieces begin or end, if it is one.
    fn tip(&self, p: &Piece, q: &Piece, x: f64) -> Result<Option<Point>, String> {
        let ends = [&p.rail, &q.rail].map(|rail| rail.point(x).map_err(words));
        let [a, b] = ends;
        let (a, b) = (a?, b?);
        if norm(&sub(&a, &b)) > 4.0 * self.tolerance {
            return Ok(None);
        }
        let ruling = match self.surface.angle {
            Some(angle) => sub(&a, &self.surface.apex(angle)),
            None => self.surface.frame.axis,
        };
        for piece in [p, q] {
            let way = piece.rail.derivative(x).map_err(words)?;
            let lean = norm(&cross(&way, &ruling));
            if lean <= TOUCHING * norm(&way) * norm(&ruling) {
                return Err("its border touches a ruling where it turns back".to_owned());
            }
        }
        Ok(Some(a))
    }

    /// Returns the cone from a piece to the apex.
    fn to_apex(&self, piece: &Piece) -> Result<Sheet, String> {
        let angle = self.surface.angle.ok_or("a cylinder has no apex")?;
        let edges = [SweptEdge::Share(1.0), SweptEdge::Share(0.0)];
        Sheet::cone(&piece.rail, self.surface.apex(angle), edges).map_err(words)
    }

    /// Returns the cylinder or cone over a piece, cut by a plane at the other edge; the piece is the edge without a plane.
    fn over(
        &self,
        rail: &Rail,
        planes: [Option<[f64; 4]>; 2],
        tips: [Option<Point>; 2],
    ) -> Result<Sheet, String> {
        let Some(angle) = self.surface.angle else {
            let edges = planes.map(|plane| plane.map_or(SweptEdge::Share(0.0), SweptEdge::Cut));
            // The ends of an arc are computed, and meet nothing exactly.
            let rail = match rail.curve() {
                RailCurve::Elliptic(arc) if tips != [None; 2] => quadratic(arc)?,
                _ => rail.clone(),
            };
            return Sheet::cylinder(&rail, self.surface.frame.axis, edges).map_err(words);
        };
        let edges = planes.map(|plane| plane.map_or(SweptEdge::Share(1.0), SweptEdge::Cut));
        let rail = match rail.curve() {
            RailCurve::Elliptic(arc) => quadratic(arc)?,
            RailCurve::Plain(_) | RailCurve::Weighted(_) => rail.clone(),
        };
        let cone = Sheet::cone(&rail, self.surface.apex(angle), edges).map_err(words)?;
        match cone.construction() {
            // Both edges of a cone end in one point but for rounding: as curves they do exactly.
            Construction::Cone(patch) if tips != [None; 2] => {
                let [first, second] = patch.rails().map_err(words)?;
                Ok(Sheet::ruled(ending(&first, tips)?, ending(&second, tips)?))
            }
            _ => Ok(cone),
        }
    }

    /// Returns the plane `n . X = e` of a piece, if it lies in one; moved through the point in which it meets the other edge.
    fn plane(&self, rail: &Rail, tip: Option<Point>) -> Result<Option<[f64; 4]>, String> {
        let plane = plane_of(rail);
        Ok(plane.map(|(origin, normal)| self.surface.cut(normal, &tip.unwrap_or(origin))))
    }

    /// Returns how far a sheet is from the surface, and its second edge from the piece that is meant, at some rulings.
    fn off(&self, sheet: &Sheet, p: &Piece, q: Option<&Piece>) -> Result<f64, String> {
        let mut farthest = 0.0_f64;
        for k in 0..=RULINGS {
            let u = f64::from(k) / f64::from(RULINGS);
            for v in [0.0, 0.25, 0.5, 0.75, 1.0] {
                let point = sheet.point(u, v).map_err(words)?;
                let off = self.surface.distance(&point);
                // Not a number is as far as can be.
                farthest = farthest.max(if off.is_nan() { f64::INFINITY } else { off });
            }
            let ends = sheet.ruling(u).map_err(words)?;
            for (end, piece) in ends.iter().zip([Some(p), q]) {
                let Some(piece) = piece else {
                    continue;
                };
                let own = self.surface.angle_of(end);
                let angle = piece.from + libm::remainder(own - piece.from, TAU);
                let angle = if angle < piece.from - SAME_ANGLE {
                    angle + TAU
                } else {
                    angle
                };
                let x = self.place(piece, angle.clamp(piece.from, piece.to))?;
                let meant = piece.rail.point(x).map_err(words)?;
                farthest = farthest.max(norm(&sub(end, &meant)));
            }
        }
        Ok(farthest)
    }
}
