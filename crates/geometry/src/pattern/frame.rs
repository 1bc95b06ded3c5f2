//! One ruling of a patch on f64: why a patch cannot be developed there.
//!
//! Let `r` be the unit ruling from the first to the second rail, `n` the unit normal along it and
//! `t = n x r` the unit vector across the ruling in which the patch proceeds. A developable has one `n` on
//! each ruling, the plane of `r` and `t` touches it there, and
//!
//! ```text
//! turn    R' . t / |R|       how fast the ruling turns in the sheet
//! along   P' . r, Q' . r     the speeds of the rails along the ruling
//! across  P' . t, Q' . t     and across it: positive on a regular patch
//! ```
//!
//! A patch that is not quite developable has different normals at the two ends; `n` is the one between,
//! normal to `P' + Q'`, and the tangent plane at an end leans out of the plane of `r` and `t` by the angle `psi`
//! with `tan psi = (P' . n)/(P' . t)`. Flattening shortens every line across the rulings by `1 - cos psi`: the
//! largest relative loss of length, and of area, since lengths along the ruling stay. Inside, the angle is
//! smaller than at the worse end, as `tan psi` is a monotone fraction of `v`.

use super::error::{PatternError, PatternResult};
use crate::surface::Rails;
use crate::vector::{cross, dot, sub};

type Vector = [f64; 3];

/// One ruling, see the module.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    pub x: f64,
    pub length: f64,
    pub normal: Vector,
    pub turn: f64,
    pub across: [f64; 2],
    /// `1 - cos psi` at the worse end.
    pub strain: f64,
    /// How far the tangents of the rails lean out of the plane, `tan psi` at the ends times the speeds across.
    out: [f64; 2],
    /// Bounds for the rounding of `turn` and of the speeds.
    pub rounding: [f64; 2],
}

/// Roundings of the evaluation of a ruling and its derivative that are allowed for, as a multiple of the unit.
const ROUNDINGS: f64 = 8.0;

impl Frame {
    pub(super) fn at(patch: &(impl Rails<f64> + ?Sized), x: f64) -> PatternResult<Self> {
        let ends = patch.ends_and_slopes(&x)?;
        if !ends
            .as_flattened()
            .as_flattened()
            .iter()
            .all(|c| c.is_finite())
        {
            return Err(PatternError::NotFinite { x });
        }
        let [[p, dp], [q, dq]] = ends;
        let ruling = sub(&q, &p);
        let (Some((length, r)), Some((speed, middle))) =
            (polar(&ruling), polar(&mean(&dp, &dq)).or(polar(&dp)))
        else {
            let still = polar(&ruling).is_some();
            return Err(if still {
                PatternError::NoTangentPlane { x }
            } else {
                PatternError::NoRuling { x }
            });
        };
        // Where the rails run against each other, the edge of regression is in the middle and either
        // rail gives the plane.
        let sides = [polar(&dp), polar(&dq)];
        let speeds: f64 = sides.iter().flatten().map(|(speed, _)| speed).sum();
        let best = sides
            .iter()
            .flatten()
            .map(|(speed, unit)| speed * size(&cross(&r, unit)));
        let mut chosen = cross(&r, &middle);
        let least = 1e-8 * best.fold(speed * size(&chosen), f64::max);
        if speed * size(&chosen) <= least {
            let other = sides.iter().flatten().find_map(|(speed, unit)| {
                let normal = cross(&r, unit);
                (speed * size(&normal) > least).then_some(normal)
            });
            chosen = other.ok_or(PatternError::NoTangentPlane { x })?;
        }
        let Some((sine, n)) = polar(&chosen) else {
            return Err(PatternError::NoTangentPlane { x });
        };
        let t = cross(&n, &r);
        let across = [dot(&dp, &t), dot(&dq, &t)];
        let far = size(&p).max(size(&q));
        let relative = ROUNDINGS * f64::EPSILON * (1.0 + far / length) / sine;
        let lean = |v: &Vector, across: f64| {
            let out = dot(v, &n);
            // A rail that stands still, at an apex, or runs along the ruling, at an edge of regression.
            let noise = libm::hypot(across, out) <= 1e-12 * speeds.max(f64::MIN_POSITIVE);
            if noise { 0.0 } else { out }
        };
        let out = [lean(&dp, across[0]), lean(&dq, across[1])];
        // 1 - cos psi without cancellation.
        let lost = |i: usize| {
            let (a, b) = (across[i].abs(), out[i]);
            let way = libm::hypot(a, b);
            if b == 0.0 {
                0.0
            } else {
                (b / way) * (b / (way + a))
            }
        };
        let frame = Self {
            x,
            length,
            normal: n,
            turn: dot(&sub(&dq, &dp), &t) / length,
            across,
            strain: lost(0).max(lost(1)),
            out,
            rounding: [relative * speeds / length, relative * speeds],
        };
        let numbers = [frame.turn, speeds, relative, frame.strain, length];
        if numbers.iter().all(|v| v.is_finite()) {
            Ok(frame)
        } else {
            Err(PatternError::NotFinite { x })
        }
    }

    /// The angle between the tangent planes at the ends, in radians.
    pub(super) fn twist(&self) -> f64 {
        let lean = |i: usize| libm::atan2(self.out[i], self.across[i].abs());
        (lean(0) - lean(1)).abs()
    }

    /// Refuses a ruling that the edge of regression crosses, by more than rounding explains.
    pub(super) fn check_regular(&self) -> PatternResult<()> {
        let [a, b] = self.across;
        check_across(self.x, [a, b], self.length, self.rounding[1])
    }
}

/// Refuses speeds across the ruling of different signs: their zero is on the edge of regression.
pub(super) fn check_across(
    x: f64,
    [a, b]: [f64; 2],
    length: f64,
    rounding: f64,
) -> PatternResult<()> {
    if a.min(b) >= -rounding {
        return Ok(());
    }
    let v = if (a < 0.0) == (b < 0.0) {
        0.5
    } else {
        a / (a - b)
    };
    let cut_off = if a < b { v } else { 1.0 - v };
    Err(PatternError::Regression {
        x,
        v,
        depth: cut_off * length,
    })
}

fn mean(a: &Vector, b: &Vector) -> Vector {
    std::array::from_fn(|i| 0.5 * a[i] + 0.5 * b[i])
}

fn size(v: &Vector) -> f64 {
    v.iter().fold(0.0, |m, c| m.max(c.abs()))
}

/// The length without overflow or underflow of the squares.
pub(super) fn norm(v: &Vector) -> f64 {
    polar(v).map_or(0.0, |(length, _)| length)
}

/// Length and direction; `None` of the zero vector and where the length is no number.
pub(super) fn polar(v: &Vector) -> Option<(f64, Vector)> {
    let largest = size(v);
    if !(largest > 0.0 && largest.is_finite()) {
        return None;
    }
    let scaled = v.map(|c| c / largest);
    let length = dot(&scaled, &scaled).sqrt();
    Some((length * largest, scaled.map(|c| c / length)))
}
