//! Surfaces on grids of parameters.

use super::{BasisTable, check_length};
use crate::basis::{Basis, Bernstein};
use crate::error::Result;
use crate::parallel::prelude::*;
use crate::surface::{Rails, TensorSurface};

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
        let mut curves = self.four_curves();
        let groups = self.u.values.chunks(4 * self.u.width);
        for (rows, out) in groups.zip(out.chunks_mut(4 * self.v.len().max(1))) {
            self.fill_rows(rows, &mut curves, out);
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
        let groups = self.u.values.par_chunks(4 * self.u.width);
        groups
            .zip(out.par_chunks_mut(4 * self.v.len().max(1)))
            .for_each_init(
                || self.four_curves(),
                |curves, (rows, out)| self.fill_rows(rows, curves, out),
            );
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
        let mut curves = self.four_curves();
        let mut points = vec![[0.0; 3]; 4 * self.v.len()];
        for (group, rows) in self.u.values.chunks(4 * self.u.width).enumerate() {
            let count = rows.len() / self.u.width;
            self.fill_rows(rows, &mut curves, &mut points);
            let rows = points.chunks(self.v.len().max(1)).take(count);
            for (i, row) in rows.enumerate() {
                consume(4 * group + i, row);
            }
        }
    }

    /// Room for the control points of four curves `T(u, .)`.
    fn four_curves(&self) -> [Vec<[f64; 3]>; 4] {
        [(); 4].map(|()| vec![[0.0; 3]; self.v.width])
    }

    /// Up to four rows of the grid.
    fn fill_rows(&self, rows: &[f64], curves: &mut [Vec<[f64; 3]>; 4], out: &mut [[f64; 3]]) {
        let mut count = 0;
        for (row, curve) in rows.chunks_exact(self.u.width).zip(curves.iter_mut()) {
            count += 1;
            curve.fill([0.0; 3]);
            for (weight, points) in row.iter().zip(self.net.chunks_exact(self.v.width)) {
                for (sum, point) in curve.iter_mut().zip(points) {
                    for axis in 0..3 {
                        sum[axis] += weight * point[axis];
                    }
                }
            }
        }
        combine_rows(&self.v, curves, count, out);
    }
}

/// The rows of points of the first `count` lists of control points.
fn combine_rows<L: AsRef<[[f64; 3]]>>(
    table: &BasisTable,
    lists: &[L; 4],
    count: usize,
    out: &mut [[f64; 3]],
) {
    if count == lists.len() {
        table.combine_four_into(lists.each_ref().map(AsRef::as_ref), out);
        return;
    }
    let rows = out.chunks_mut(table.len().max(1));
    for (points, row) in lists.iter().take(count).zip(rows) {
        table.combine_into(points.as_ref(), row);
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
    let across = across(us, vs, out)?;
    for (us, rows) in us.chunks(4).zip(out.chunks_mut(4 * vs.len().max(1))) {
        fill_rulings(patch, us, &across, rows)?;
    }
    Ok(())
}

/// [`ruled_grid_into`] with the rulings of large grids shared among threads; the same values.
///
/// # Errors
/// As [`ruled_grid_into`], and the same error on every run.
///
/// ```
/// use torse_geometry::{Bernstein, Curve, RuledSurface, batch};
/// let rail = |z: f64| Curve::new(Bernstein, vec![[0.0, z, 0.0], [1.0, 0.0, z], [2.0, z, z]]);
/// let patch = RuledSurface::new(rail(0.5)?, rail(2.0)?);
/// let xs: Vec<f64> = (0..201).map(|i| f64::from(i) / 200.0).collect();
/// let (mut one, mut many) = (vec![[0.0; 3]; 201 * 201], vec![[1.0; 3]; 201 * 201]);
/// batch::ruled_grid_into(&patch, &xs, &xs, &mut one)?;
/// batch::par_ruled_grid_into(&patch, &xs, &xs, &mut many)?;
/// assert_eq!(one, many);
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
pub fn par_ruled_grid_into(
    patch: &impl Rails<f64>,
    us: &[f64],
    vs: &[f64],
    out: &mut [[f64; 3]],
) -> Result<()> {
    if out.len() < PARALLEL_FROM {
        return ruled_grid_into(patch, us, vs, out);
    }
    let across = across(us, vs, out)?;
    let groups = us
        .par_chunks(4)
        .zip(out.par_chunks_mut(4 * vs.len().max(1)));
    match groups.try_for_each(|(us, rows)| fill_rulings(patch, us, &across, rows)) {
        Ok(()) => Ok(()),
        // Whichever thread failed first: the serial run names the first place.
        Err(_) => ruled_grid_into(patch, us, vs, out),
    }
}

/// The weights across the rulings, after a look at the buffer.
fn across(us: &[f64], vs: &[f64], out: &[[f64; 3]]) -> Result<BasisTable> {
    check_length("output buffer", us.len() * vs.len(), out.len())?;
    BasisTable::new(&Bernstein, 1, vs)
}

/// The points of up to four rulings.
fn fill_rulings(
    patch: &impl Rails<f64>,
    us: &[f64],
    across: &BasisTable,
    out: &mut [[f64; 3]],
) -> Result<()> {
    let mut ends = [[[0.0; 3]; 2]; 4];
    for (u, slot) in us.iter().zip(&mut ends) {
        *slot = patch.ruling_ends(u)?;
    }
    combine_rows(across, &ends, us.len(), out);
    Ok(())
}
