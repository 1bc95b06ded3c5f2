//! Evaluation of many points at once into the caller's buffers, on f64.
//!
//! Basis rows are computed once for each parameter; a grid row then combines the control net in `u` and
//! is a dot product in `v` for each point. Nothing is allocated for a point, the inner loops have
//! constant bounds for the usual degrees and vectorise, and the cost reaches that of storing the
//! points. Functions named `par_` share the rows of large grids among threads; results do not depend
//! on the number of threads, for every point is computed by the same operations.

use crate::basis::{Basis, Bernstein};
use crate::curve::Curve;
use crate::error::{GeometryError, Result};
use crate::planes::{PlaneFamily, Ruling, ruling_of};
use crate::surface::{Rails, TensorSurface};
use crate::vector::combine;
use rayon::prelude::*;

/// The basis functions of one degree at many parameters, row by row.
///
/// ```
/// use torse_geometry::{Gbt, batch::BasisTable};
/// let table = BasisTable::new(&Gbt::new(0.5, 0.5)?, 3, &[0.0, 0.5, 1.0])?;
/// assert_eq!((table.width(), table.len()), (4, 3));
/// assert_eq!(table.row(0), Some(&[1.0, 0.0, 0.0, 0.0][..]));
/// # Ok::<(), torse_geometry::GeometryError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct BasisTable {
    width: usize,
    values: Vec<f64>,
}

impl BasisTable {
    /// The table of `basis` of this degree at the parameters `xs`.
    ///
    /// # Errors
    /// [`GeometryError::OutOfRange`] for degree zero; the errors of the basis.
    pub fn new<B: Basis<f64>>(basis: &B, degree: usize, xs: &[f64]) -> Result<Self> {
        let width = degree + 1;
        let mut values = vec![0.0; width * xs.len()];
        for (x, row) in xs.iter().zip(values.chunks_exact_mut(width)) {
            basis.row_into(x, row)?;
        }
        Ok(Self { width, values })
    }

    /// The number of basis functions, the degree plus one.
    #[must_use]
    pub fn width(&self) -> usize {
        self.width
    }

    /// The number of parameters.
    #[must_use]
    pub fn len(&self) -> usize {
        self.values.len() / self.width.max(1)
    }

    /// Whether there are no parameters.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// The basis functions at parameter `index`.
    #[must_use]
    pub fn row(&self, index: usize) -> Option<&[f64]> {
        self.values.chunks_exact(self.width.max(1)).nth(index)
    }

    /// `out[j] = sum_i row_j[i] points[i]` for all rows.
    fn combine_into<const D: usize>(&self, points: &[[f64; D]], out: &mut [[f64; D]]) {
        match points.len() {
            2 => combine_rows::<2, D>(&self.values, points, out),
            3 => combine_rows::<3, D>(&self.values, points, out),
            4 => combine_rows::<4, D>(&self.values, points, out),
            5 => combine_rows::<5, D>(&self.values, points, out),
            6 => combine_rows::<6, D>(&self.values, points, out),
            7 => combine_rows::<7, D>(&self.values, points, out),
            8 => combine_rows::<8, D>(&self.values, points, out),
            _ => {
                for (row, slot) in self.values.chunks_exact(self.width.max(1)).zip(out) {
                    *slot = combine(row, points).unwrap_or([0.0; D]);
                }
            }
        }
    }
}

/// The inner loop with `N` control points known at compile time.
fn combine_rows<const N: usize, const D: usize>(
    rows: &[f64],
    points: &[[f64; D]],
    out: &mut [[f64; D]],
) {
    let Some((points, _)) = points.split_first_chunk::<N>() else {
        return;
    };
    let (rows, _) = rows.as_chunks::<N>();
    for (slot, row) in out.iter_mut().zip(rows) {
        let mut sum = [0.0; D];
        for (weight, point) in row.iter().zip(points) {
            for (s, p) in sum.iter_mut().zip(point) {
                *s += weight * p;
            }
        }
        *slot = sum;
    }
}

fn check_length(what: &'static str, expected: usize, given: usize) -> Result<()> {
    if expected == given {
        return Ok(());
    }
    Err(GeometryError::LengthMismatch {
        what,
        index: 0,
        expected,
        given,
    })
}

/// Parameters evaluated at a time on a curve: one column of values is half a kilobyte.
const BLOCK: usize = 64;

/// The basis functions at a block of parameters, one column for each function: the degree-raising
/// recursion then runs along the columns, over all parameters at once.
struct Columns {
    columns: Vec<[f64; BLOCK]>,
}

impl Columns {
    fn fill<B: Basis<f64>>(&mut self, basis: &B, xs: &[f64; BLOCK]) -> Result<()> {
        let [first, second, rest @ ..] = self.columns.as_mut_slice() else {
            return Ok(());
        };
        let Some((third, _)) = rest.split_first_mut() else {
            for (p, x) in xs.iter().enumerate() {
                (first[p], second[p]) = (1.0 - x, *x);
            }
            return Ok(());
        };
        for (p, x) in xs.iter().enumerate() {
            [first[p], second[p], third[p]] = basis.seeds(x)?;
        }
        for degree in 3..self.columns.len() {
            let Some(active) = self.columns.get_mut(..=degree) else {
                break;
            };
            if let [.., below, last] = active {
                for p in 0..BLOCK {
                    last[p] = xs[p] * below[p];
                }
            }
            for i in (1..degree).rev() {
                let Some([lower, entry]) = active.get_mut(i - 1..=i) else {
                    break;
                };
                for p in 0..BLOCK {
                    entry[p] = (1.0 - xs[p]) * entry[p] + xs[p] * lower[p];
                }
            }
            if let Some(entry) = active.first_mut() {
                for p in 0..BLOCK {
                    entry[p] *= 1.0 - xs[p];
                }
            }
        }
        Ok(())
    }

    fn combine_into<const D: usize>(&self, points: &[[f64; D]], out: &mut [[f64; D]]) {
        let mut sums = [[0.0; BLOCK]; D];
        for (column, point) in self.columns.iter().zip(points) {
            for (sum, coordinate) in sums.iter_mut().zip(point) {
                for (s, weight) in sum.iter_mut().zip(column) {
                    *s += weight * coordinate;
                }
            }
        }
        for (p, slot) in out.iter_mut().enumerate().take(BLOCK) {
            *slot = std::array::from_fn(|axis| sums[axis][p]);
        }
    }
}

impl<B: Basis<f64>, const D: usize> Curve<B, f64, D> {
    /// The points at all parameters `xs`, into `out` of the same length.
    ///
    /// # Errors
    /// [`GeometryError::LengthMismatch`] when the lengths differ.
    ///
    /// ```
    /// use torse_geometry::{Curve, Gbt};
    /// let curve = Curve::new(Gbt::new(0.3, 0.9)?, vec![[0.0, 1.0], [2.0, 3.0], [5.0, 1.0], [6.0, 0.0]])?;
    /// let xs: Vec<f64> = (0..1000).map(|i| f64::from(i) / 999.0).collect();
    /// let mut out = vec![[0.0; 2]; xs.len()];
    /// curve.points_into(&xs, &mut out)?;
    /// assert_eq!(out[321], curve.point(&xs[321])?);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn points_into(&self, xs: &[f64], out: &mut [[f64; D]]) -> Result<()> {
        check_length("output buffer", xs.len(), out.len())?;
        let mut basis = Columns {
            columns: vec![[0.0; BLOCK]; self.degree() + 1],
        };
        for (xs, out) in xs.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
            let mut block = [0.0; BLOCK];
            for (slot, x) in block.iter_mut().zip(xs) {
                *slot = *x;
            }
            basis.fill(self.basis(), &block)?;
            basis.combine_into(self.points(), out);
        }
        Ok(())
    }
}

impl<B: Basis<f64>> PlaneFamily<B, f64> {
    /// The rulings at all parameters `xs`, into `out` of the same length.
    ///
    /// # Errors
    /// [`GeometryError::LengthMismatch`]; [`GeometryError::NoRuling`] where there is none.
    ///
    /// ```
    /// use torse_geometry::{Gbt, PlaneFamily};
    /// let planes = vec![[1., 0., 0.2, 3.], [0.5, 1., 0.1, 2.], [0., 1., 0.5, 4.], [-1., 0.3, 0.1, 5.]];
    /// let family = PlaneFamily::new(Gbt::new(0.5, 0.5)?, planes)?;
    /// let xs = [0.1, 0.2, 0.7];
    /// let mut out = vec![family.ruling(&0.0)?; 3];
    /// family.rulings_into(&xs, &mut out)?;
    /// for (x, ruling) in xs.iter().zip(&out) {
    ///     let one = family.ruling(x)?;
    ///     assert!((0..3).all(|i| (one.foot[i] - ruling.foot[i]).abs() < 1e-12 * one.foot[i].abs()));
    /// }
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn rulings_into(&self, xs: &[f64], out: &mut [Ruling<f64>]) -> Result<()> {
        check_length("output buffer", xs.len(), out.len())?;
        let points = self.curve().points();
        let (mut row, mut slope) = (vec![0.0; points.len()], vec![0.0; points.len()]);
        for (x, slot) in xs.iter().zip(out) {
            self.curve()
                .basis()
                .row_and_slope_into(x, &mut row, &mut slope)?;
            let (mut plane, mut change) = ([0.0; 4], [0.0; 4]);
            for ((w, d), q) in row.iter().zip(&slope).zip(points) {
                for axis in 0..4 {
                    plane[axis] += w * q[axis];
                    change[axis] += d * q[axis];
                }
            }
            *slot = ruling_of(&plane, &change).map_err(|_| GeometryError::NoRuling {
                parameter: x.to_string(),
            })?;
        }
        Ok(())
    }
}

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
    /// [`GeometryError::LengthMismatch`] when `out` has another length.
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
/// [`GeometryError::LengthMismatch`]; what the patch refuses.
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
