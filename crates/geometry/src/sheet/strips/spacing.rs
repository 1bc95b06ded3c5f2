//! Where the edges of strips are placed: so that all have about the same distance from the surface.
//!
//! With `L, M, N` the second fundamental form, the direction `(-M/L, 1)` is conjugate to a curve of constant `v`. The
//! normal curvature along it, times the square of the width over eight, is the distance of a narrow strip.

use super::strip::{StripError, SurfaceStrip, Tensor};
use crate::error::{Result, count};
use crate::surface::Surface;
use crate::vector::norm;

/// Intervals of the table, across the strips.
const ACROSS: usize = 64;
/// Places along each curve.
const ALONG: usize = 32;
/// The least entry of the table, as a share of the largest.
const LEAST: f64 = 0.05;
/// The largest entry of the table as it is measured, as a multiple of the middle one: beside a place at which a curve is
/// asymptotic the measured ones have no bound, and the distance of strips has.
const MOST: f64 = 16.0;
/// What counts as zero of the normal curvature of a curve, as a share of the largest.
const FLAT: f64 = 1e-9;
/// Halvings that find the place at which a curve is asymptotic.
const HALVINGS: usize = 48;

/// How densely edges are wanted: as a table of the root of the distance of strips over their width.
pub(super) struct StripSpacing {
    /// On intervals of equal width; positive.
    roots: Vec<f64>,
}

/// What is measured at a place.
struct CurvatureSample {
    /// The normal component of the second derivative along the curve.
    along: f64,
    /// The same of that along a step `(0, 1)`.
    across: f64,
    /// The same of that in the conjugate direction with a step of one across; `None` where the curve is asymptotic.
    conjugate: Option<f64>,
    /// The largest of all three coefficients.
    size: f64,
}

fn share(k: usize, n: usize) -> f64 {
    count(k) / count(n)
}

/// `None` where the surface has no normal.
fn sampled_curvature(surface: &Tensor, u: f64, v: f64) -> Result<Option<CurvatureSample>> {
    let forms = surface.forms(&u, &v)?;
    let length = norm(&forms.normal);
    if length == 0.0 || !length.is_finite() {
        return Ok(None);
    }
    let [l, m, n] = forms.second.map(|c| c / length);
    let conjugate = (n - m * m / l).abs();
    Ok(Some(CurvatureSample {
        along: l,
        across: n.abs(),
        conjugate: conjugate.is_finite().then_some(conjugate),
        size: l.abs().max(m.abs()).max(n.abs()),
    }))
}

impl StripSpacing {
    /// Measures a surface on a grid.
    pub fn new(surface: &Tensor) -> Result<Self, StripError> {
        let mut grid = Vec::with_capacity((ACROSS + 1) * (ALONG + 1));
        for j in 0..=ACROSS {
            for i in 0..=ALONG {
                let at = [share(i, ALONG), share(j, ACROSS)];
                if let Some(found) = sampled_curvature(surface, at[0], at[1])? {
                    grid.push((at, found));
                }
            }
        }
        let size = grid.iter().fold(0.0_f64, |m, (_, b)| m.max(b.size));
        // A plane has rulings in all directions.
        let reach = surface.rows().flatten().flatten();
        let reach = reach.fold(0.0_f64, |m, c| m.max(c.abs()));
        let plane = size <= FLAT * FLAT.sqrt() * reach;
        if !plane && let Some(at) = asymptotic(surface, &grid, size)? {
            let point = surface.point(&at[0], &at[1])?;
            return Err(StripError::Asymptotic { at, point });
        }
        let mut roots = vec![0.0_f64; ACROSS];
        for (at, found) in &grid {
            // At both ends of the curves the first and the last ruling are those to equal parameters.
            let end = at[0] == 0.0 || at[0] == 1.0;
            let conjugate = found.conjugate.unwrap_or(0.0);
            let value = if end {
                conjugate.max(found.across)
            } else {
                conjugate
            };
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
            let place = (at[1] * share(ACROSS, 1)).round() as usize;
            for slot in [place.checked_sub(1), Some(place)].into_iter().flatten() {
                if let Some(root) = roots.get_mut(slot) {
                    *root = root.max((value / 8.0).sqrt());
                }
            }
        }
        let mut sorted = roots.clone();
        sorted.sort_by(f64::total_cmp);
        let most = MOST * sorted.get(ACROSS / 2).copied().unwrap_or(0.0);
        if most > 0.0 {
            for root in &mut roots {
                *root = root.min(most);
            }
        }
        Ok(Self {
            roots: bounded_below(roots),
        })
    }

    /// Returns how many strips would come within a distance, if all were narrow.
    pub fn count(&self, within: f64) -> usize {
        let whole: f64 = self.roots.iter().sum::<f64>() / share(ACROSS, 1);
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        let count = (whole / within.sqrt()).min(1e6).ceil() as usize;
        count
    }

    /// Returns the places of the edges of so many strips, from 0 to 1.
    pub fn places(&self, count: usize) -> Vec<f64> {
        let whole: f64 = self.roots.iter().sum();
        let mut places = vec![0.0];
        let (mut below, mut slot) = (0.0, 0);
        for k in 1..count {
            let wanted = share(k, count) * whole;
            while slot + 1 < self.roots.len() && below + self.roots[slot] < wanted {
                below += self.roots[slot];
                slot += 1;
            }
            let inside = ((wanted - below) / self.roots[slot]).clamp(0.0, 1.0);
            places.push((share(slot, 1) + inside) / share(ACROSS, 1));
        }
        places.push(1.0);
        places
    }

    /// Corrects the table by the bounds of strips that were made.
    pub fn correct(&mut self, strips: &[SurfaceStrip]) {
        let overlap = |k: usize, strip: &SurfaceStrip| {
            let [from, to] = strip.range;
            (to.min(share(k + 1, ACROSS)) - from.max(share(k, ACROSS))).max(0.0)
        };
        let mut corrected = vec![0.0_f64; self.roots.len()];
        for strip in strips {
            let parts = || {
                self.roots
                    .iter()
                    .enumerate()
                    .map(|(k, root)| (k, *root, overlap(k, strip)))
            };
            let expected: f64 = parts().map(|(_, root, width)| root * width).sum();
            let factor = strip.distance.sqrt() / expected;
            for (k, root, width) in parts() {
                corrected[k] += factor * root * width * share(ACROSS, 1);
            }
        }
        self.roots = bounded_below(corrected);
    }
}

/// Returns the roots, none far below the largest: where nothing is bent, strips are wide but not endless.
fn bounded_below(roots: Vec<f64>) -> Vec<f64> {
    let largest = roots.iter().fold(0.0_f64, |m, r| m.max(*r));
    let least = if largest > 0.0 { LEAST * largest } else { 1.0 };
    roots.into_iter().map(|root| root.max(least)).collect()
}

/// Returns a place at which a curve of constant `v` is asymptotic, as far as samples show.
fn asymptotic(
    surface: &Tensor,
    grid: &[([f64; 2], CurvatureSample)],
    size: f64,
) -> Result<Option<[f64; 2]>> {
    let largest = grid.iter().fold(0.0_f64, |m, (_, b)| m.max(b.along.abs()));
    if largest <= FLAT * size {
        // All of them are.
        return Ok(Some([0.5, 0.5]));
    }
    let bound = FLAT * largest;
    let up = grid.iter().find(|(_, b)| b.along > bound);
    let down = grid.iter().find(|(_, b)| b.along < -bound);
    let (Some((up, _)), Some((down, _))) = (up, down) else {
        return Ok(None);
    };
    let (mut up, mut down) = (*up, *down);
    for _ in 0..HALVINGS {
        let middle = [0, 1].map(|k| 0.5 * (up[k] + down[k]));
        match sampled_curvature(surface, middle[0], middle[1])? {
            Some(found) if found.along > 0.0 => up = middle,
            Some(_) => down = middle,
            None => break,
        }
    }
    Ok(Some(up))
}
