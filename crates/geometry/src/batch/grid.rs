//! Surfaces on grids of parameters.

use super::{BasisTable, check_length};
use crate::basis::{Basis, Bernstein};
use crate::error::Result;
use crate::surface::{Rails, TensorSurface};
use rayon::prelude::*;

/// Points from which a grid is shared among threads: below, starting them costs more than it gains.
const PARALLEL_FROM: usize = 1 << 15;

/// A tensor-product surface with its basis tables for one grid of parameters.
///
/// ```
/// use torse_geometry::{Gbt, Surface, TensorSurface, batch::GridEvaluator};
/// let net = (0..4).map(|i| (0..4).map(|j| [f64::from(i), f64::from(j), f64::from(i * j)]).collect()).collect();
/// let surface = TensorSurface::new(Gbt::new(0.5, 0.1)?, Gbt::new(1.0, -0.4)?, net)?;
/// let (us, vs) = ([0.0, 0.25, 1.0], [0.0, 0.5, 0.75, 1.0]);
/// let grid = GridEvaluator::new(&surface, &us, &vs)?;
/// let mut out = vec![[0.0; 3]; grid.len()];
/// grid.fill(&mut out)?;
/// // The first parameter varies slowest.
/// let one = surface.point(&us[1], &vs[2])?;
/// assert!((0..3).all(|k| (one[k] - out[1 * 4 + 2][k]).abs() < 1e-14));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone)]
pub struct GridEvaluator {
    u: BasisTable,
    v: BasisTable,
    /// The control net, `v` running fastest.
    net: Vec<[f64; 3]>,
}

impl GridEvaluator {
    /// The tables of `surface` for the parameters `us` and `vs`.
    ///
    /// # Errors
    /// The errors of the bases.
    pub fn new<U: Basis<f64>, V: Basis<f64>>(
        surface: &TensorSurface<U, V, f64>,
        us: &[f64],
        vs: &[f64],
    ) -> Result<Self> {
        let ((m, n), (u, v)) = (surface.degrees(), surface.bases());
        Ok(Self {
            u: BasisTable::new(u, m, us)?,
            v: BasisTable::new(v, n, vs)?,
            net: surface.rows().flatten().copied().collect(),
        })
    }

    /// The number of points of the grid.
    #[must_use]
    pub fn len(&self) -> usize {
        self.u.len() * self.v.len()
    }

    /// Whether the grid has no points.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// All points on this thread; `out[i * vs.len() + j]` is the point at `(us[i], vs[j])`.
    ///
    /// # Errors
    /// [`GeometryError::LengthMismatch`](crate::GeometryError::LengthMismatch) when `out` has another length.
    pub fn fill(&self, out: &mut [[f64; 3]]) -> Result<()> {
        check_length("output buffer", self.len(), out.len())?;
        let mut curve = vec![[0.0; 3]; self.v.width];
        let rows = self.u.values.chunks_exact(self.u.width);
        for (row, out) in rows.zip(out.chunks_mut(self.v.len().max(1))) {
            self.fill_row(row, &mut curve, out);
        }
        Ok(())
    }

    /// All points, the rows of large grids shared among threads; the same values as [`Self::fill`].
    ///
    /// # Errors
    /// As [`Self::fill`].
    pub fn par_fill(&self, out: &mut [[f64; 3]]) -> Result<()> {
        if out.len() < PARALLEL_FROM {
            return self.fill(out);
        }
        check_length("output buffer", self.len(), out.len())?;
        let rows = self.u.values.par_chunks_exact(self.u.width);
        let buffer = || vec![[0.0; 3]; self.v.width];
        rows.zip(out.par_chunks_mut(self.v.len().max(1)))
            .for_each_init(buffer, |curve, (row, out)| self.fill_row(row, curve, out));
        Ok(())
    }

    /// Hands each row of points to `consume` while it is in the cache.
    ///
    /// ```
    /// # use torse_geometry::{Bernstein, TensorSurface, batch::GridEvaluator};
    /// # let net = vec![vec![[0.0, 0.0, 1.0], [0.0, 1.0, 5.0]], vec![[1.0, 0.0, 2.0], [1.0, 1.0, 3.0]]];
    /// # let surface = TensorSurface::new(Bernstein, Bernstein, net)?;
    /// let xs = [0.0, 0.5, 1.0];
    /// let mut highest = f64::NEG_INFINITY;
    /// GridEvaluator::new(&surface, &xs, &xs)?.rows(|_, row| {
    ///     highest = row.iter().fold(highest, |h, p| h.max(p[2]));
    /// });
    /// assert_eq!(highest, 5.0);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn rows(&self, mut consume: impl FnMut(usize, &[[f64; 3]])) {
        let mut curve = vec![[0.0; 3]; self.v.width];
        let mut points = vec![[0.0; 3]; self.v.len()];
        for (i, row) in self.u.values.chunks_exact(self.u.width).enumerate() {
            self.fill_row(row, &mut curve, &mut points);
            consume(i, &points);
        }
    }

    fn fill_row(&self, row: &[f64], curve: &mut [[f64; 3]], out: &mut [[f64; 3]]) {
        curve.fill([0.0; 3]);
        for (weight, points) in row.iter().zip(self.net.chunks_exact(self.v.width)) {
            for (sum, point) in curve.iter_mut().zip(points) {
                for axis in 0..3 {
                    sum[axis] += weight * point[axis];
                }
            }
        }
        self.v.combine_into(curve, out);
    }
}

/// The points of a ruled patch on the grid `us` x `vs`, into `out` (the first parameter varies slowest):
/// the ends of each ruling once, then linear interpolation.
///
/// # Errors
/// [`GeometryError::LengthMismatch`](crate::GeometryError::LengthMismatch); what the patch refuses.
///
/// ```
/// use torse_geometry::{Bernstein, Curve, RuledSurface, Surface, batch};
/// let rail = |z: f64| Curve::new(Bernstein, vec![[0.0, z, 0.0], [1.0, 0.0, z], [2.0, z, z]]);
/// let patch = RuledSurface::new(rail(0.5)?, rail(2.0)?);
/// let (us, vs) = ([0.0, 0.3], [0.0, 0.5, 1.0]);
/// let mut out = [[0.0; 3]; 6];
/// batch::ruled_grid_into(&patch, &us, &vs, &mut out)?;
/// assert_eq!(out[4], patch.point(&0.3, &0.5)?);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn ruled_grid_into(
    patch: &impl Rails<f64>,
    us: &[f64],
    vs: &[f64],
    out: &mut [[f64; 3]],
) -> Result<()> {
    check_length("output buffer", us.len() * vs.len(), out.len())?;
    let across = BasisTable::new(&Bernstein, 1, vs)?;
    for (u, row) in us.iter().zip(out.chunks_mut(vs.len().max(1))) {
        across.combine_into(&patch.ruling_ends(u)?, row);
    }
    Ok(())
}
