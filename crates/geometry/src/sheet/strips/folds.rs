//! The angle between neighbouring strips along the edge that they share, by samples.

use super::rulings::parameters;
use super::strip::SurfaceStrip;
use crate::error::Result;
use crate::sheet::{PanelKind, Point};
use crate::surface::Rails;
use crate::vector::{cross, dot, norm, sub, unit};

/// Rulings of each piece.
const RULINGS: u32 = 64;
/// Places along the edge.
const PLACES: u32 = 128;

/// Returns the least and the greatest angle between the tangent planes of two strips, in radians.
pub(super) fn between(first: &SurfaceStrip, second: &SurfaceStrip) -> Result<[f64; 2]> {
    let (before, after) = (normals(first, 1)?, normals(second, 0)?);
    let mut angles = [f64::INFINITY, 0.0_f64];
    for k in 0..=PLACES {
        let at = f64::from(k) / f64::from(PLACES);
        // In the apex of a fan there is no one plane.
        let (Some(one), Some(other)) = (normal_at(&before, at), normal_at(&after, at)) else {
            continue;
        };
        let angle = libm::atan2(norm(&cross(&one, &other)), dot(&one, &other));
        angles = [angles[0].min(angle), angles[1].max(angle)];
    }
    if angles[0] > angles[1] {
        angles[0] = angles[1];
    }
    Ok(angles)
}

/// Returns the unit normals along an edge, 0 or 1, of a strip, by its parameter.
fn normals(strip: &SurfaceStrip, edge: usize) -> Result<Vec<(f64, Point)>> {
    let mut list = Vec::new();
    for piece in &strip.panel.pieces {
        if piece.kind == PanelKind::Fan(edge + 1) {
            continue;
        }
        for k in 0..=RULINGS {
            let x = f64::from(k) / f64::from(RULINGS);
            let rails: [[Point; 2]; 2] = piece.sheet.ends_and_slopes(&x)?;
            let [[p, _], [q, _]] = rails;
            let normal = unit(&cross(&rails[edge][1], &sub(&q, &p)));
            if let (Some(both), Some(normal)) = (parameters(piece, x), normal) {
                list.push((both[edge], normal));
            }
        }
    }
    Ok(list)
}

/// Between two neighbours in a list.
fn normal_at(list: &[(f64, Point)], at: f64) -> Option<Point> {
    let pair = list
        .windows(2)
        .find(|pair| pair[0].0 <= at && at <= pair[1].0)?;
    let [(from, one), (to, other)] = [pair[0], pair[1]];
    let share = if to > from {
        (at - from) / (to - from)
    } else {
        0.5
    };
    unit(&std::array::from_fn(|k| {
        one[k] + share * (other[k] - one[k])
    }))
}
