//! Meshes of surfaces: on equal parameter steps, or along the rulings where they are needed.

use super::{Mesh, check_count, number};
use crate::error::{ExchangeError, Result};
use torse_geometry::vector::{cross, dot, lerp, norm, sub, unit};
use torse_geometry::{Rails, Surface};

/// The most rulings of a mesh.
const MAX_RULINGS: usize = 1 << 16;
/// Where bisection of the parameter ends.
const LEAST_CELL: f64 = 1e-9;

impl Mesh {
    /// The mesh of `(u_cells + 1) x (v_cells + 1)` vertices at equal parameter steps. The edges run along
    /// the parameter lines, so of a ruled surface along its rulings.
    ///
    /// # Errors
    /// [`ExchangeError::OutOfRange`] for no cells, [`ExchangeError::TooMany`], [`ExchangeError::NotFinite`],
    /// and what the surface refuses.
    ///
    /// ```
    /// use torse_exchange::Mesh;
    /// use torse_geometry::{Curve, Gbt, TensorSurface};
    /// let directrix = Curve::new(Gbt::new(0.0, 0.0)?, vec![[1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]])?;
    /// let cylinder = TensorSurface::cylinder(&directrix, &[0.0, 0.0, 1.0], &2.0)?;
    /// let mesh = Mesh::sample(&cylinder, 8, 2)?;
    /// assert_eq!((mesh.vertices().len(), mesh.triangles().len()), (27, 32));
    /// // On the unit cylinder the normal is the direction of the point itself.
    /// let (p, n) = (mesh.vertices()[10], mesh.normals()[10]);
    /// assert!((p[0] - n[0]).abs() < 1e-14 && (p[1] - n[1]).abs() < 1e-14);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn sample(surface: &impl Surface<f64>, u_cells: usize, v_cells: usize) -> Result<Self> {
        #[allow(clippy::cast_precision_loss)]
        for (name, cells) in [("cells along u", u_cells), ("cells along v", v_cells)] {
            if cells == 0 {
                let (value, range) = (cells as f64, "{1, 2, ..}");
                return Err(ExchangeError::OutOfRange { name, value, range });
            }
        }
        let count = u_cells
            .saturating_add(1)
            .saturating_mul(v_cells.saturating_add(1));
        check_count(count)?;
        let (mut vertices, mut normals) = (Vec::with_capacity(count), Vec::with_capacity(count));
        #[allow(clippy::cast_precision_loss)]
        let at = |i: usize, cells: usize| i as f64 / cells as f64;
        for i in 0..=u_cells {
            for j in 0..=v_cells {
                let partials = surface.partials(&at(i, u_cells), &at(j, v_cells), 1)?;
                vertices.push(*partials.point());
                normals.push(unit(&partials.normal()).unwrap_or_default());
            }
        }
        Self::with_normals(vertices, normals, grid_triangles(u_cells, v_cells))
    }

    /// The mesh of a ruled patch with an edge on every ruling it uses and no vertex between the rails: the
    /// rulings are as dense as the surface needs to stay within `tolerance` of the triangles, measured at the
    /// middle and the quarters of each cell (an estimate).
    ///
    /// # Errors
    /// [`ExchangeError::OutOfRange`] unless the tolerance is positive, [`ExchangeError::TooMany`] when more
    /// than 65536 rulings are needed, and what the patch refuses.
    ///
    /// ```
    /// use torse_exchange::Mesh;
    /// use torse_geometry::{RuledSurface, curve::ellipse_arc};
    /// let ring = |z: f64| ellipse_arc(&[0.0, 0.0, z], &[2.0, 0.0, z], &[0.0, 2.0, z]);
    /// let mesh = Mesh::ruled(&RuledSurface::new(ring(0.0)?, ring(3.0)?), 1e-3)?;
    /// // A chord of angle t lies r (1 - cos(t/2)) from the circle of radius r.
    /// let turns = (mesh.triangles().len() / 2) as f64;
    /// let sagitta = 2.0 * (1.0 - (std::f64::consts::FRAC_PI_4 / turns).cos());
    /// assert!(sagitta <= 1e-3 && sagitta > 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn ruled(patch: &impl Rails<f64>, tolerance: f64) -> Result<Self> {
        let rulings = ruling_parameters(patch, tolerance)?;
        let count = rulings.len();
        let (mut vertices, mut normals) =
            (Vec::with_capacity(2 * count), Vec::with_capacity(2 * count));
        for x in rulings {
            let [p, q] = patch.rail_jets(&x, 1)?;
            let value = |jets: &[torse_algebra::Jet<f64>; 3]| jets.each_ref().map(|j| *j.value());
            let slope = |jets: &[torse_algebra::Jet<f64>; 3]| {
                jets.each_ref()
                    .map(|j| j.coefficients().get(1).copied().unwrap_or(f64::NAN))
            };
            let ends = [value(&p), value(&q)];
            let ruling = sub(&ends[1], &ends[0]);
            for (end, jets) in ends.into_iter().zip([&p, &q]) {
                vertices.push(end);
                normals.push(unit(&cross(&slope(jets), &ruling)).unwrap_or_default());
            }
        }
        Self::with_normals(
            vertices,
            normals,
            grid_triangles(count.saturating_sub(1), 1),
        )
    }
}

fn grid_triangles(u_cells: usize, v_cells: usize) -> Vec<[u32; 3]> {
    let index = |i: usize, j: usize| number(i * (v_cells + 1) + j);
    let mut triangles = Vec::with_capacity(2 * u_cells * v_cells);
    for i in 0..u_cells {
        for j in 0..v_cells {
            let (a, b, c, d) = (
                index(i, j),
                index(i + 1, j),
                index(i + 1, j + 1),
                index(i, j + 1),
            );
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    triangles
}

/// Parameters of rulings between which two triangles follow the patch within the tolerance.
pub(super) fn ruling_parameters(patch: &impl Rails<f64>, tolerance: f64) -> Result<Vec<f64>> {
    if !(tolerance.is_finite() && tolerance > 0.0) {
        return Err(ExchangeError::OutOfRange {
            name: "tolerance",
            value: tolerance,
            range: "(0, inf)",
        });
    }
    let mut done = vec![0.0];
    let mut open = vec![(0.5, 1.0), (0.0, 0.5)];
    while let Some((from, to)) = open.pop() {
        let middle = 0.5 * (from + to);
        if to - from > LEAST_CELL && !is_flat(patch, from, to, tolerance)? {
            open.extend([(middle, to), (from, middle)]);
        } else {
            done.push(to);
        }
        if done.len() + open.len() > MAX_RULINGS {
            return Err(ExchangeError::TooMany {
                what: "rulings",
                given: done.len() + open.len(),
                most: MAX_RULINGS,
            });
        }
    }
    Ok(done)
}

fn is_flat(patch: &impl Rails<f64>, from: f64, to: f64, tolerance: f64) -> Result<bool> {
    let ([p0, q0], [p1, q1]) = (patch.ruling_ends(&from)?, patch.ruling_ends(&to)?);
    let normal = unit(&cross(&sub(&q1, &p0), &sub(&q0, &p1)));
    for part in [0.25, 0.5, 0.75] {
        let [p, q] = patch.ruling_ends(&(from + part * (to - from)))?;
        let apart = from_chord(&p, &p0, &p1).max(from_chord(&q, &q0, &q1));
        // The middle of the cell against the plane of the diagonals: a twisted cell is not flat either.
        let middle = sub(&lerp(&p, &q, &0.5), &p0);
        let above = normal.map_or(0.0, |n| dot(&n, &middle).abs());
        // A comparison that NaN fails: what is not finite is met at the door of the mesh.
        if !(apart <= tolerance && above <= tolerance) {
            return Ok(!(apart.is_finite() && above.is_finite()));
        }
    }
    Ok(true)
}

/// The distance of a point from a segment.
fn from_chord(point: &[f64; 3], from: &[f64; 3], to: &[f64; 3]) -> f64 {
    let (chord, way) = (sub(to, from), sub(point, from));
    let square = dot(&chord, &chord);
    let part = if square > 0.0 {
        (dot(&way, &chord) / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    norm(&sub(point, &lerp(from, to, &part)))
}
