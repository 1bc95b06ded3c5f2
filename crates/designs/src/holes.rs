//! Holes in space: what is round on the sheet, cut into the patches it meets.

use crate::design::{Design, Mark};
use crate::error::DesignError;
use crate::unroll::{Demand, drawing, position, unroll};
use std::f64::consts::PI;
use torse_geometry::pattern::{FlatPattern, PatternPlace};
use torse_geometry::prelude::{Point, Sheet};
use torse_geometry::vector::{norm, sub};

/// The part of a hole that lies on a patch.
#[derive(Debug, Clone)]
pub struct SpaceHole {
    /// The index of the patch.
    pub patch: usize,
    /// The rulings that meet it.
    pub range: [f64; 2],
    /// Whether it ends there because the patch does.
    clipped: [bool; 2],
    flat: FlatPattern,
    piece: usize,
    centre: [f64; 2],
    radius: f64,
}

/// Steps in which the end of a hole is looked for.
const STEPS: u32 = 1024;
/// Points of the curve around a hole.
const AROUND: u32 = 64;

/// Returns the holes of all patches: those that are marked on them, and what of the holes of a neighbour reaches onto
/// them.
///
/// # Errors
/// As [`unroll`] and [`drawing`]: holes that leave the sheet, or overlap, are refused.
pub fn holes(design: &Design) -> Result<Vec<SpaceHole>, DesignError> {
    let is_hole = |mark: &Mark| matches!(mark, Mark::Hole(..));
    let mut all = Vec::new();
    for piece in design.pieces() {
        let patches = || {
            let indices = piece.patches.iter();
            indices.filter_map(|index| Some((*index, design.patches.get(*index)?)))
        };
        if !patches().any(|(_, patch)| patch.marks.iter().any(is_hole)) {
            continue;
        }
        let demand = Demand {
            only: Some(piece.name.clone()),
            allow_strain: 0.5,
            ..Demand::default()
        };
        let pieces = unroll(design, &demand)?;
        // What cannot be cut is refused here as there.
        drawing(design, &pieces)?;
        let Some(flat) = pieces.first().map(|piece| &piece.flat) else {
            continue;
        };
        for (marked, patch) in patches() {
            for mark in &patch.marks {
                let Mark::Hole([u, v], radius) = mark else {
                    continue;
                };
                let Some(at) = position(flat, patch) else {
                    continue;
                };
                let place = PatternPlace {
                    piece: at,
                    x: *u,
                    v: *v,
                };
                let Some(centre) = flat.flatten(place) else {
                    continue;
                };
                for (index, other) in patches() {
                    let Some(piece) = position(flat, other) else {
                        continue;
                    };
                    let starts = if index == marked {
                        vec![*u]
                    } else {
                        vec![0.0, 1.0]
                    };
                    let hole = SpaceHole {
                        patch: index,
                        range: [0.0; 2],
                        clipped: [false; 2],
                        flat: flat.clone(),
                        piece,
                        centre,
                        radius: *radius,
                    };
                    let met = starts.into_iter().find(|x| hole.beyond(*x) < 0.0);
                    all.extend(met.map(|x| hole.reaching(x)));
                }
            }
        }
    }
    Ok(all)
}

impl SpaceHole {
    /// Returns the flat ruling: its start, its direction and its length.
    fn ruling(&self, x: f64) -> ([f64; 2], [f64; 2], f64) {
        let end = |v: f64| {
            let piece = self.piece;
            self.flat
                .flatten(PatternPlace { piece, x, v })
                .unwrap_or([f64::NAN; 2])
        };
        let (from, to) = (end(0.0), end(1.0));
        let way = sub(&to, &from);
        let length = norm(&way);
        (from, way.map(|c| c / length), length)
    }

    /// By how much the ruling misses the circle; negative where it meets it.
    fn beyond(&self, x: f64) -> f64 {
        let (from, along, _) = self.ruling(x);
        let arm = sub(&self.centre, &from);
        (along[0] * arm[1] - along[1] * arm[0]).abs() - self.radius
    }

    /// Returns the same hole with the rulings that meet it, of which one is known.
    fn reaching(mut self, start: f64) -> Self {
        for (end, border) in [0.0, 1.0].into_iter().enumerate() {
            let step = (border - start) / f64::from(STEPS);
            let mut inside = start;
            let outside = (1..=STEPS).map(|k| start + f64::from(k) * step).find(|x| {
                let out = self.beyond(*x) >= 0.0;
                if !out {
                    inside = *x;
                }
                out
            });
            match outside {
                None => (self.range[end], self.clipped[end]) = (border, true),
                Some(mut outside) => {
                    for _ in 0..60 {
                        let middle = 0.5 * (inside + outside);
                        if self.beyond(middle) < 0.0 {
                            inside = middle;
                        } else {
                            outside = middle;
                        }
                    }
                    self.range[end] = inside;
                }
            }
        }
        self
    }

    /// Returns whether it goes on beyond the patch.
    pub fn is_clipped(&self) -> bool {
        self.clipped != [false; 2]
    }

    /// Returns the shares of a ruling between which it is open.
    pub fn across(&self, x: f64) -> [f64; 2] {
        let (from, along, length) = self.ruling(x);
        let arm = sub(&self.centre, &from);
        let middle = along[0] * arm[0] + along[1] * arm[1];
        let off = along[0] * arm[1] - along[1] * arm[0];
        let touched = (0..2).any(|end| !self.clipped[end] && (x - self.range[end]).abs() <= 1e-12);
        let half = if touched {
            0.0
        } else {
            (self.radius * self.radius - off * off).max(0.0).sqrt()
        };
        [middle - half, middle + half].map(|at| at / length)
    }

    /// Rulings between which the hole is followed by chords within a distance.
    pub fn rulings(&self, within: f64) -> Vec<f64> {
        let cosine = (1.0 - within / self.radius).max(0.0);
        let steps = (PI / libm::acos(cosine)).ceil().clamp(8.0, 512.0);
        let [from, to] = self.range;
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let count = steps as u32;
        (1..count)
            .map(|k| {
                let share = 0.5 - 0.5 * libm::cos(PI * f64::from(k) / steps);
                from + share * (to - from)
            })
            .collect()
    }

    /// Returns points in space at equal steps around it, so that the patch is on the left as seen from the side to
    /// which the parameters turn against the clock.
    ///
    /// # Errors
    /// [`DesignError::Mark`] where a point of the circle is not found on the patch.
    pub fn around(&self, sheet: &Sheet) -> Result<Vec<Point>, DesignError> {
        let lost = || DesignError::Mark {
            patch: self.patch.to_string(),
            reason: "its circle is not found in space".to_owned(),
        };
        let mut places = Vec::new();
        for k in 0..AROUND {
            let (sine, cosine) = libm::sincos(2.0 * PI * f64::from(k) / f64::from(AROUND));
            let point = [
                self.centre[0] + self.radius * cosine,
                self.centre[1] + self.radius * sine,
            ];
            let place = self.flat.locate(point).ok_or_else(lost)?;
            places.push([place.x, place.v]);
        }
        let next = places.iter().cycle().skip(1);
        let turned: f64 = places
            .iter()
            .zip(next)
            .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
            .sum();
        if turned > 0.0 {
            places.reverse();
        }
        places
            .into_iter()
            .map(|[x, v]| sheet.point(x, v).map_err(|_| lost()))
            .collect()
    }
}
