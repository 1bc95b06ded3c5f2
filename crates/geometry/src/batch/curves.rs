//! Curves, plane families and rulings at many parameters.

use super::check_length;
use crate::basis::Basis;
use crate::curve::Curve;
use crate::error::{GeometryError, Result};
use crate::planes::{PlaneFamily, Ruling, ruling_of};

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
