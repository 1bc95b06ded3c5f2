//! Edges about the axis of a cylinder or cone: how far they go, and their pieces between rulings.

use super::round::{SAMPLES, Swept};
use super::words;
use std::f64::consts::TAU;
use torse_geometry::prelude::{PiecewiseRail, Point, Rail};
use torse_geometry::vector::{norm, sub};

/// Angles that differ by less are one, in radians.
pub(super) const SAME_ANGLE: f64 = 1e-7;

/// A piece of an edge that meets each ruling once, with rising angles at its ends.
#[derive(Clone)]
pub(super) struct Piece {
    pub rail: Rail,
    pub from: f64,
    pub to: f64,
}

/// What bounds the rulings of a face: pieces from its first angle to its last; none in an apex.
pub(super) type Runs = [Option<Vec<Piece>>; 2];

/// How a piece of an edge goes about the axis.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Rising,
    Falling,
    /// Along a ruling.
    Along,
}

/// A cylinder or cone, and the distance within which points are one.
pub(super) struct AroundAxis {
    pub surface: Swept,
    pub tolerance: f64,
}

impl AroundAxis {
    /// Returns the angles of a piece at equal steps, each near the one before, the first one near a given angle; points in
    /// the axis have that of their neighbours.
    fn angles(&self, rail: &Rail, near: f64) -> Result<Vec<f64>, String> {
        let mut points = Vec::new();
        for k in 0..=SAMPLES {
            let point = rail.point(f64::from(k) / f64::from(SAMPLES));
            points.push(point.map_err(words)?);
        }
        let on_axis = |point: &Point| self.surface.out(point) <= self.tolerance;
        let first = points.iter().find(|point| !on_axis(point));
        let start = first.map_or(near, |point| self.surface.angle_of(point));
        let mut last = near + libm::remainder(start - near, TAU);
        let mut angles = Vec::with_capacity(points.len());
        for point in &points {
            if !on_axis(point) {
                last += libm::remainder(self.surface.angle_of(point) - last, TAU);
            }
            angles.push(last);
        }
        Ok(angles)
    }

    /// Returns how a piece goes about the axis, and its angles at both ends.
    fn way(&self, rail: &Rail, near: f64) -> Result<(Way, [f64; 2]), String> {
        let angles = self.angles(rail, near)?;
        let (Some(first), Some(last)) = (angles.first(), angles.last()) else {
            return Err("an edge is missing".to_owned());
        };
        let ends = [*first, *last];
        if angles
            .iter()
            .all(|angle| (angle - first).abs() <= SAME_ANGLE)
        {
            return Ok((Way::Along, ends));
        }
        let sign = (last - first).signum();
        let back = angles
            .windows(2)
            .any(|pair| (pair[1] - pair[0]) * sign < -1e-9);
        if back || (last - first).abs() <= SAME_ANGLE {
            return Err("an edge of it meets a ruling more than once".to_owned());
        }
        Ok((
            if sign > 0.0 {
                Way::Rising
            } else {
                Way::Falling
            },
            ends,
        ))
    }

    /// Returns the pieces of rising curves in a row; those along a ruling are left out.
    fn rising(&self, rails: &[Rail]) -> Result<Vec<Piece>, String> {
        let (mut pieces, mut near) = (Vec::new(), 0.0);
        for rail in rails {
            let (way, [from, to]) = self.way(rail, near)?;
            near = to;
            match way {
                Way::Rising => pieces.push(Piece {
                    rail: rail.clone(),
                    from,
                    to,
                }),
                Way::Along => {
                    return Err("an edge around it has a step along a ruling".to_owned());
                }
                Way::Falling => {
                    return Err("an edge around it meets a ruling more than once".to_owned());
                }
            }
        }
        Ok(pieces)
    }

    /// Returns the runs of a face that is closed around, from a ruling that no opening meets: that of the seam, if it is one.
    pub(super) fn runs_around(
        &self,
        borders: &[PiecewiseRail],
        holes: &[PiecewiseRail],
        seam: Option<f64>,
    ) -> Result<Runs, String> {
        let first = borders.first().ok_or("it has no edges")?;
        let start = match seam {
            Some(angle) => angle,
            None => self.surface.angle_of(&first.point(0.0).map_err(words)?),
        };
        let start = self.surface.free_angle(start, holes)?;
        let run = |border: &PiecewiseRail| -> Result<Vec<Piece>, String> {
            let turned = self.surface.winding(border)? < 0;
            let border = if turned {
                border.reversed().map_err(words)?
            } else {
                border.clone()
            };
            let pieces = self.rising(&border.rails().map_err(words)?)?;
            self.once_around(pieces, start)
        };
        match borders {
            [only] if self.surface.angle.is_some() => Ok([Some(run(only)?), None]),
            [first, second] => Ok([Some(run(first)?), Some(run(second)?)]),
            _ => Err(format!(
                "{} of its edges run around it, and not two",
                borders.len()
            )),
        }
    }

    /// Returns pieces once around from an angle.
    fn once_around(&self, pieces: Vec<Piece>, start: f64) -> Result<Vec<Piece>, String> {
        let first = pieces.first().map_or(0.0, |piece| piece.from);
        let turns = ((start - first + SAME_ANGLE) / TAU).floor();
        let start = start - turns * TAU;
        let mut cut = self.cut(pieces, &[start])?;
        let before = cut
            .iter()
            .take_while(|piece| piece.from < start - SAME_ANGLE)
            .count();
        let shift = |pieces: &mut [Piece], by: f64| {
            for piece in pieces {
                piece.from += by;
                piece.to += by;
            }
        };
        shift(&mut cut, turns * TAU);
        let behind = cut.get_mut(..before).unwrap_or_default();
        shift(behind, TAU);
        cut.rotate_left(before);
        Ok(cut)
    }

    /// Returns the runs of a face beside the axis: the edges of its border that rise and those that fall, between two
    /// rulings; one of these may be a point, and instead of one run there may be the apex.
    pub(super) fn runs_beside(&self, border: &PiecewiseRail) -> Result<Runs, String> {
        let mut rails = border.rails().map_err(words)?;
        let mut ways = self.ways(&rails)?;
        if !ways.contains(&Way::Rising) {
            rails = rails.iter().rev().map(Rail::reversed).collect();
            ways = self.ways(&rails)?;
        }
        let count = ways.len();
        let start = (0..count).find(|k| {
            let before = ways.get((k + count - 1) % count);
            ways.get(*k) == Some(&Way::Rising) && before != Some(&Way::Rising)
        });
        let start = start.ok_or("its edges do not go forth and back about its axis")?;
        rails.rotate_left(start);
        ways.rotate_left(start);
        let up = ways.iter().take_while(|way| **way == Way::Rising).count();
        let side = ways.iter().skip(up);
        let side = up + side.take_while(|way| **way == Way::Along).count();
        let down = ways.iter().skip(side);
        let down = side + down.take_while(|way| **way == Way::Falling).count();
        if ways.iter().skip(down).any(|way| *way != Way::Along) {
            return Err("its edges go forth and back about its axis more than once".to_owned());
        }
        let rising = self.rising(rails.get(..up).unwrap_or_default())?;
        if down > side {
            let falling = rails.get(side..down).unwrap_or_default();
            let back: Vec<Rail> = falling.iter().rev().map(Rail::reversed).collect();
            return Ok([Some(rising), Some(self.rising(&back)?)]);
        }
        let Some(angle) = self.surface.angle else {
            return Err("its edges do not go forth and back about its axis".to_owned());
        };
        let apex = self.surface.apex(angle);
        for rail in rails.get(up..).unwrap_or_default() {
            let end = rail.point(1.0).map_err(words)?;
            if norm(&sub(&end, &apex)) <= 4.0 * self.tolerance {
                return Ok([Some(rising), None]);
            }
        }
        Err("its edges go forth about its axis, and not back".to_owned())
    }

    fn ways(&self, rails: &[Rail]) -> Result<Vec<Way>, String> {
        let ways = rails.iter().map(|rail| Ok(self.way(rail, 0.0)?.0));
        ways.collect()
    }

    /// Returns the pieces, each cut at the angles inside of it.
    pub(super) fn cut(&self, pieces: Vec<Piece>, angles: &[f64]) -> Result<Vec<Piece>, String> {
        let mut all = Vec::with_capacity(pieces.len() + angles.len());
        for piece in pieces {
            let mut rest = piece;
            for angle in angles {
                if *angle <= rest.from + SAME_ANGLE || *angle >= rest.to - SAME_ANGLE {
                    continue;
                }
                let x = self.place(&rest, *angle)?;
                let [before, after] = rest.rail.split(x).map_err(words)?;
                all.push(Piece {
                    rail: before,
                    from: rest.from,
                    to: *angle,
                });
                rest = Piece {
                    rail: after,
                    from: *angle,
                    to: rest.to,
                };
            }
            all.push(rest);
        }
        Ok(all)
    }

    /// Returns the parameter of a piece at an angle between those of its ends, by halving.
    pub(super) fn place(&self, piece: &Piece, angle: f64) -> Result<f64, String> {
        let angles = self.angles(&piece.rail, piece.from)?;
        let below = angles.iter().take_while(|own| **own < angle).count();
        let below = u32::try_from(below).unwrap_or(SAMPLES).clamp(1, SAMPLES);
        let step = |k: u32| f64::from(k) / f64::from(SAMPLES);
        let (mut low, mut high) = (step(below - 1), step(below));
        while high - low > f64::EPSILON * high {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            let own = self
                .surface
                .angle_of(&piece.rail.point(middle).map_err(words)?);
            if libm::remainder(own - angle, TAU) < 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        Ok(0.5 * (low + high))
    }
}

/// Returns pieces with angles by whole turns nearer to those of the first ones.
pub(super) fn near_first(first: &[Piece], mut second: Vec<Piece>) -> Vec<Piece> {
    let start = |pieces: &[Piece]| pieces.first().map_or(0.0, |piece| piece.from);
    let turns = ((start(first) - start(&second)) / TAU).round();
    for piece in &mut second {
        piece.from += turns * TAU;
        piece.to += turns * TAU;
    }
    second
}
