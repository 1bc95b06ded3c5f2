//! What is measured of a surface in general: on a grid, nothing proved.

use crate::design::{FreeSurface, Tensor};
use serde::Serialize;
use torse_geometry::Surface;
use torse_geometry::prelude::GeometryError;
use torse_geometry::vector::norm;

/// Samples for curvatures, each way.
const SAMPLES: u32 = 32;
/// Intervals of the quadrature of the area, each way.
const INTERVALS: u32 = 16;

/// What was measured of a surface.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[non_exhaustive]
pub struct SurfaceReport {
    /// Its name.
    pub name: String,
    /// How it is made.
    pub kind: &'static str,
    /// The degrees of the tensor product.
    pub degrees: [usize; 2],
    /// The least and the greatest Gaussian curvature, for one over square millimetres; `null` where it is unbounded.
    pub gaussian: Option<[f64; 2]>,
    /// The smallest radius of curvature; `null` for a flat surface and where there is none.
    pub radius: Option<f64>,
    /// The area.
    pub area: f64,
}

pub(super) fn surface(surface: &FreeSurface) -> Result<SurfaceReport, GeometryError> {
    let mut gaussian = Some([f64::INFINITY, f64::NEG_INFINITY]);
    let (mut curvature, mut area) = (0.0_f64, 0.0);
    let mut degrees = [0; 2];
    for part in &surface.parts {
        degrees = part.degrees().into();
        area += area_of(part)?;
        for (i, j) in (0..=SAMPLES).flat_map(|i| (0..=SAMPLES).map(move |j| (i, j))) {
            let [u, v] = [i, j].map(|k| f64::from(k) / f64::from(SAMPLES));
            let forms = part.forms(&u, &v)?;
            match (forms.gaussian(), forms.principal(), &mut gaussian) {
                (Ok(k), Ok(both), Some([low, high])) => {
                    (*low, *high) = (low.min(k), high.max(k));
                    let largest = both.map(|p| p.curvature.abs());
                    curvature = curvature.max(largest[0]).max(largest[1]);
                }
                _ => gaussian = None,
            }
        }
    }
    Ok(SurfaceReport {
        name: surface.name.clone(),
        kind: surface.kind,
        degrees,
        gaussian,
        radius: (gaussian.is_some() && curvature > 0.0).then(|| 1.0 / curvature),
        area,
    })
}

/// By Gauss and Legendre with three places on each interval, each way.
fn area_of(part: &Tensor) -> Result<f64, GeometryError> {
    let outer = 0.6_f64.sqrt();
    let rule = [(-outer, 5.0 / 9.0), (0.0, 8.0 / 9.0), (outer, 5.0 / 9.0)];
    let half = 0.5 / f64::from(INTERVALS);
    let places: Vec<(f64, f64)> = (0..INTERVALS)
        .flat_map(|k| {
            let middle = half * f64::from(2 * k + 1);
            rule.map(|(place, weight)| (middle + half * place, half * weight))
        })
        .collect();
    let mut area = 0.0;
    for (u, wide) in &places {
        for (v, high) in &places {
            area += wide * high * norm(&part.partials(u, v, 1)?.normal());
        }
    }
    Ok(area)
}
