//! Curves, plane families and rulings at many parameters.

use super::check_length;
use super::wide::widest;
use crate::basis::Basis;
use crate::coordinate::{Coordinate, check_finite};
use crate::curve::Curve;
use crate::error::{GeometryError, Result};
use crate::planes::{PlaneFamily, Ruling, ruling_of};
use rayon::prelude::*;
use std::ops::Range;

/// Parameters evaluated at a time on a curve: one column of values is half a kilobyte.
const BLOCK: usize = 64;

/// Parameters that one thread takes at a time; below this starting threads costs more than it gains.
const SHARE: usize = 128 * BLOCK;

/// The basis functions (or their slopes) at a block of parameters, one column for each function: the
/// degree-raising recursion then runs along the columns, over all parameters at once.
struct Columns {
    columns: Vec<[f64; BLOCK]>,
}

impl Columns {
    fn new(degree: usize) -> Self {
        Self {
            columns: vec![[0.0; BLOCK]; degree + 1],
        }
    }

    /// The basis functions at `xs`.
    fn fill<B: Basis<f64>>(&mut self, basis: &B, xs: &[f64; BLOCK]) -> Result<()> {
        if let [first, second] = self.columns.as_mut_slice() {
            for (p, x) in xs.iter().enumerate() {
                (first[p], second[p]) = (1.0 - x, *x);
            }
            return Ok(());
        }
        self.start(basis, xs)?;
        self.raise(3..self.columns.len(), xs);
        Ok(())
    }

    /// The basis functions at `xs`, and their slopes into `slopes`; for the formula see
    /// [`Basis::row_and_slope_into`].
    fn fill_with_slopes<B: Basis<f64>>(
        &mut self,
        slopes: &mut Self,
        basis: &B,
        xs: &[f64; BLOCK],
    ) -> Result<()> {
        let degree = self.columns.len() - 1;
        if let [first, second, third, ..] = slopes.columns.as_mut_slice() {
            for (p, x) in xs.iter().enumerate() {
                [first[p], second[p], third[p]] = basis.seed_slopes(x)?;
            }
        }
        slopes.raise(3..degree + 1, xs);
        self.start(basis, xs)?;
        self.raise(3..degree, xs);
        if degree > 2 {
            let factor = 0.0.natural(degree - 2);
            let mut below = [0.0; BLOCK];
            for (i, (slope, entry)) in slopes.columns.iter_mut().zip(&self.columns).enumerate() {
                let entry = if i < degree { *entry } else { [0.0; BLOCK] };
                for p in 0..BLOCK {
                    slope[p] += factor * (below[p] - entry[p]);
                }
                below = entry;
            }
            self.raise(degree..degree + 1, xs);
        }
        Ok(())
    }

    /// The three seeds into the first columns.
    fn start<B: Basis<f64>>(&mut self, basis: &B, xs: &[f64; BLOCK]) -> Result<()> {
        if let [first, second, third, ..] = self.columns.as_mut_slice() {
            widest(
                #[inline(always)]
                || basis.seed_columns(xs, [first, second, third]),
            )?;
        }
        Ok(())
    }

    /// From the basis of degree `degrees.start - 1` to that of the last of `degrees`.
    fn raise(&mut self, degrees: Range<usize>, xs: &[f64; BLOCK]) {
        widest(
            #[inline(always)]
            || {
                for degree in degrees {
                    let Some(active) = self.columns.get_mut(..=degree) else {
                        break;
                    };
                    raise_once(active, xs);
                }
            },
        );
    }

    /// The sums of `points` weighted by the columns, one column for each coordinate.
    fn combined<const D: usize>(&self, points: &[[f64; D]]) -> [[f64; BLOCK]; D] {
        let mut sums = [[0.0; BLOCK]; D];
        widest(
            #[inline(always)]
            || {
                for (column, point) in self.columns.iter().zip(points) {
                    for (sum, coordinate) in sums.iter_mut().zip(point) {
                        for (s, weight) in sum.iter_mut().zip(column) {
                            *s += weight * coordinate;
                        }
                    }
                }
            },
        );
        sums
    }
}

/// From the basis of one degree less, in all but the last column, to the basis of all columns.
#[inline(always)]
fn raise_once(columns: &mut [[f64; BLOCK]], xs: &[f64; BLOCK]) {
    if let [.., below, last] = columns {
        for p in 0..BLOCK {
            last[p] = xs[p] * below[p];
        }
    }
    for i in (1..columns.len().saturating_sub(1)).rev() {
        let Some([lower, entry]) = columns.get_mut(i - 1..=i) else {
            break;
        };
        for p in 0..BLOCK {
            entry[p] = (1.0 - xs[p]) * entry[p] + xs[p] * lower[p];
        }
    }
    if let Some(entry) = columns.first_mut() {
        for p in 0..BLOCK {
            entry[p] *= 1.0 - xs[p];
        }
    }
}

fn check_buffer<T>(xs: &[f64], out: &[T]) -> Result<()> {
    check_finite("curve parameter", xs)?;
    check_length("output buffer", xs.len(), out.len())
}

/// A whole block of parameters, the last one filled up with zeros.
fn block(xs: &[f64]) -> [f64; BLOCK] {
    let mut block = [0.0; BLOCK];
    for (slot, x) in block.iter_mut().zip(xs) {
        *slot = *x;
    }
    block
}

impl<B: Basis<f64>, const D: usize> Curve<B, f64, D> {
    /// The points at all parameters `xs`, into `out` of the same length.
    ///
    /// # Errors
    /// [`GeometryError::LengthMismatch`] when the lengths differ, [`GeometryError::NotFinite`] for a parameter
    /// that is NaN or infinite.
    ///
    /// ```
    /// use torse_geometry::{Curve, Gbt};
    /// let curve = Curve::new(Gbt::new(0.3, 0.9)?, vec![[0.0, 1.0], [2.0, 3.0], [5.0, 1.0], [6.0, 0.0]])?;
    /// let xs: Vec<f64> = (0..1000).map(|i| f64::from(i) / 999.0).collect();
    /// let mut out = vec![[0.0; 2]; xs.len()];
    /// curve.points_into(&xs, &mut out)?;
    /// assert_eq!(out[321], curve.point(&xs[321])?);
    /// let error = curve.points_into(&xs[..7], &mut out).unwrap_err();
    /// assert_eq!(error.to_string(), "output buffer: entry 0 has 1000 elements, expected 7");
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn points_into(&self, xs: &[f64], out: &mut [[f64; D]]) -> Result<()> {
        check_buffer(xs, out)?;
        let mut basis = Columns::new(self.degree());
        for (xs, out) in xs.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
            basis.fill(self.basis(), &block(xs))?;
            let sums = basis.combined(self.points());
            for (p, slot) in out.iter_mut().enumerate() {
                *slot = std::array::from_fn(|axis| sums[axis][p]);
            }
        }
        Ok(())
    }

    /// [`Curve::points_into`] with the parameters shared among threads; the same values.
    ///
    /// # Errors
    /// As [`Curve::points_into`].
    ///
    /// ```
    /// use torse_geometry::{Curve, Gbt};
    /// let curve = Curve::new(Gbt::new(0.3, 0.9)?, vec![[0.0, 1.0], [2.0, 3.0], [5.0, 1.0], [6.0, 0.0]])?;
    /// let xs: Vec<f64> = (0..20_000).map(|i| f64::from(i) / 19_999.0).collect();
    /// let (mut one, mut many) = (vec![[0.0; 2]; xs.len()], vec![[1.0; 2]; xs.len()]);
    /// curve.points_into(&xs, &mut one)?;
    /// curve.par_points_into(&xs, &mut many)?;
    /// assert_eq!(one, many);
    /// # Ok::<(), torse_geometry::GeometryError>(())
    /// ```
    pub fn par_points_into(&self, xs: &[f64], out: &mut [[f64; D]]) -> Result<()>
    where
        B: Sync,
    {
        shared(xs, out, |xs, out| self.points_into(xs, out))
    }
}

impl<B: Basis<f64>> PlaneFamily<B, f64> {
    /// The rulings at all parameters `xs`, into `out` of the same length.
    ///
    /// # Errors
    /// As [`Curve::points_into`]; [`GeometryError::NoRuling`] where there is none.
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
        check_buffer(xs, out)?;
        let curve = self.curve();
        let (mut basis, mut slopes) = (Columns::new(self.degree()), Columns::new(self.degree()));
        for (xs, out) in xs.chunks(BLOCK).zip(out.chunks_mut(BLOCK)) {
            basis.fill_with_slopes(&mut slopes, curve.basis(), &block(xs))?;
            let planes = basis.combined(curve.points());
            let changes = slopes.combined(curve.points());
            for (p, (x, slot)) in xs.iter().zip(out).enumerate() {
                let at = |columns: &[[f64; BLOCK]; 4]| [0, 1, 2, 3].map(|axis| columns[axis][p]);
                *slot = ruling_of(&at(&planes), &at(&changes)).map_err(|_| {
                    GeometryError::NoRuling {
                        parameter: x.approximate(),
                    }
                })?;
            }
        }
        Ok(())
    }

    /// [`PlaneFamily::rulings_into`] with the parameters shared among threads; the same values.
    ///
    /// # Errors
    /// As [`PlaneFamily::rulings_into`], and the same error on every run.
    pub fn par_rulings_into(&self, xs: &[f64], out: &mut [Ruling<f64>]) -> Result<()>
    where
        B: Sync,
    {
        shared(xs, out, |xs, out| self.rulings_into(xs, out))
    }
}

/// Runs `fill` on shares of the parameters, on all threads.
fn shared<T: Send>(
    xs: &[f64],
    out: &mut [T],
    fill: impl Fn(&[f64], &mut [T]) -> Result<()> + Sync,
) -> Result<()> {
    check_length("output buffer", xs.len(), out.len())?;
    let shares = xs.par_chunks(SHARE).zip(out.par_chunks_mut(SHARE));
    match shares.try_for_each(|(xs, out)| fill(xs, out)) {
        Ok(()) => Ok(()),
        // Whichever thread failed first: the serial run names the first place.
        Err(_) => fill(xs, out),
    }
}
