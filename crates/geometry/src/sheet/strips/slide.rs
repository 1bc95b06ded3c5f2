//! How points are moved along the surface before strips are compared with it.
//!
//! A ruling that joins `(s, v0)` and `(t, v1)` is compared with the surface over `u = (1 - w) s + w t + e w (1 - w)`,
//! `v = (1 - w) v0 + w v1`. Here `e` is chosen: so that, with what moves points along the ruling, the
//! second derivative of the difference in the middle is as short as it can be, which leaves its normal part.
//!
//! Whatever `e` is, what follows from it is a bound of the distance both ways as long as
//! - it is continuous along the panel, and zero on the first and last ruling: then the paths cover all places between
//!   the edges;
//! - `-(s + t) <= e <= 2 - s - t`: then no path leaves them, since `(1 - w) s + w t >= (s + t) w (1 - w)`, and likewise
//!   from 1.
//!
//! So it is piecewise linear, with values at equal steps; `s + t` is linear on each piece, and the second holds between
//! the steps as it holds at them.

use super::rulings::parameters;
use super::strip::Tensor;
use crate::error::count;
use crate::sheet::{Panel, PanelPiece, Point};
use crate::surface::Surface;
use crate::vector::{dot, sub};

/// The steps on each piece.
pub(super) const STEPS: usize = 8;

/// Returns the values of `e` on each piece of a panel, at equal steps.
pub(super) fn slides(surface: &Tensor, range: [f64; 2], panel: &Panel) -> Vec<[f64; STEPS + 1]> {
    let mut all = Vec::with_capacity(panel.pieces.len());
    let mut start = 0.0;
    for (index, piece) in panel.pieces.iter().enumerate() {
        let mut values: [f64; STEPS + 1] = std::array::from_fn(|k| {
            let x = count(k) / count(STEPS);
            wanted(surface, range, piece, x).unwrap_or(0.0)
        });
        // Continuous from piece to piece.
        values[0] = start;
        if index + 1 == panel.pieces.len() {
            values[STEPS] = 0.0;
        }
        start = values[STEPS];
        all.push(values);
    }
    all
}

/// Returns the best value for a ruling within its limits.
fn wanted(surface: &Tensor, range: [f64; 2], piece: &PanelPiece, x: f64) -> Option<f64> {
    let [s, t] = parameters(piece, x)?;
    let [low, high] = range;
    let point = |u: f64, v: f64| surface.point(&u, &v).ok();
    let ruling = sub(&point(t, high)?, &point(s, low)?);
    let middle = surface
        .partials(&(0.5 * (s + t)), &(0.5 * (low + high)), 2)
        .ok()?;
    let [du, dv] = [t - s, high - low];
    let [uu, uv, vv] = [(2, 0), (1, 1), (0, 2)].map(|(i, j)| middle.get(i, j).copied());
    let (uu, uv, vv, along): (Point, Point, Point, Point) = (uu?, uv?, vv?, *middle.get(1, 0)?);
    let bent: Point =
        std::array::from_fn(|k| uu[k] * du * du + 2.0 * uv[k] * du * dv + vv[k] * dv * dv);
    // The shortest of bent + c ruling - 2 e along, by its normal equations.
    let [rr, ra, aa] = [
        dot(&ruling, &ruling),
        dot(&ruling, &along),
        dot(&along, &along),
    ];
    let [rb, ab] = [dot(&ruling, &bent), dot(&along, &bent)];
    let determinant = rr * aa - ra * ra;
    if determinant <= 1e-9 * rr * aa {
        return None;
    }
    let e = 0.5 * (ab * rr - rb * ra) / determinant;
    let sum = s + t;
    // Rounding must not lead beyond the limits.
    let room = 1.0 - 1e-6;
    e.is_finite()
        .then(|| e.clamp(-room * sum.max(0.0), room * (2.0 - sum).max(0.0)))
}
