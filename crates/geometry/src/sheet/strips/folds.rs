//! The angle between neighbouring strips along the edge that they share, by samples.

use super::strip::SurfaceStrip;
use crate::error::Result;
use crate::sheet::{Construction, PanelKind, PanelPiece, Point, Sheet};
use crate::surface::Rails;
use crate::vector::{cross, dot, norm, sub, unit};

/// Rulings of each piece.
const RULINGS: u32 = 64;
/// Places along the edge.
const PLACES: u32 = 128;

/// The least and the greatest angle between the tangent planes of two strips, in radians.
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

/// The unit normals along an edge, 0 or 1, of a strip, by its parameter.
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
            if let (Some(at), Some(normal)) = (parameter(&piece.sheet, piece, x, edge), normal) {
                list.push((at, normal));
            }
        }
    }
    Ok(list)
}

/// The parameter on an edge of a ruling.
fn parameter(sheet: &Sheet, piece: &PanelPiece, x: f64, edge: usize) -> Option<f64> {
    match (piece.kind, sheet.construction()) {
        (PanelKind::Fan(_), _) => {
            let [from, to] = piece.ranges[edge];
            Some(from + (to - from) * x)
        }
        (PanelKind::Arc, Construction::Connecting(patch)) => {
            patch.parameters_at(x).map(|both| both[edge])
        }
        (PanelKind::Arc, Construction::Part(part)) => {
            let [from, to] = part.range();
            parameter(part.whole(), piece, from + (to - from) * x, edge)
        }
        _ => None,
    }
}

/// Between two neighbours in a list.
fn normal_at(list: &[(f64, Point)], at: f64) -> Option<Point> {
    let pair = list.windows(2).find(|pair| pair[0].0 <= at && at <= pair[1].0)?;
    let [(from, one), (to, other)] = [pair[0], pair[1]];
    let share = if to > from { (at - from) / (to - from) } else { 0.5 };
    unit(&std::array::from_fn(|k| one[k] + share * (other[k] - one[k])))
}
